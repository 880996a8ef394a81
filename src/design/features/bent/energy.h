/* What the features 'minimum-energy' and 'minimum-variation' share. */
#ifndef BAT_FEATURES_ENERGY_H
#define BAT_FEATURES_ENERGY_H
#include "design/shared/through.h"

#include <batten/bent.h>

#define BAT_ENERGY_PARAMETERS                                                        \
    BAT_EACH, BAT_CLOSED,                                                            \
        {"tension",                                                                  \
         BATTEN_VALUE_NUMBER,                                                        \
         false,                                                                      \
         false,                                                                      \
         "0",                                                                        \
         NULL,                                                                       \
         "energy added for each unit of length: the strip is pulled"},               \
        {"scale-invariant",                                                          \
         BATTEN_VALUE_YES_NO,                                                        \
         false,                                                                      \
         false,                                                                      \
         "no",                                                                       \
         NULL,                                                                       \
         "the energy times the length or its cube: longer curves do not cost less"}, \
    {                                                                                \
        "pieces", BATTEN_VALUE_COUNT, false, false, "0", NULL,                       \
            "quintics between neighbouring points, 1 to 16; 0: as many as save energy"                          \
    }

/* Curves of least energy through all rows of the principal input. */
batten_status bat_least_energy(bat_run *run);

#endif
