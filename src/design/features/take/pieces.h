/* What the features 'split' and 'divide' share. */
#ifndef BAT_FEATURES_PIECES_H
#define BAT_FEATURES_PIECES_H
#include "design/feature.h"

#include <batten/measure.h>

#define BAT_PIECES_PARAMETERS                                                               \
    {"pieces",                                                                              \
     BATTEN_VALUE_WORD,                                                                     \
     false,                                                                                 \
     false,                                                                                 \
     NULL,                                                                                  \
     "monotone spiral convex spans",                                                        \
     "instead: pieces of this kind"},                                                       \
    {                                                                                       \
        "along", BATTEN_VALUE_POINT, false, false, NULL, NULL,                              \
            "of monotone pieces: the one direction in which they run one way, as [1, 2, 0]" \
    }

/* Where a curve falls into pieces of the kind that 'pieces' names. */
batten_status bat_pieces_divide(const bat_run *run, const batten_object *object,
                                batten_parameters *out);

#endif
