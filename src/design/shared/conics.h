/* What the features of conics share. */
#ifndef BAT_DESIGN_CONICS_H
#define BAT_DESIGN_CONICS_H
#include "design/shared/through.h"
#include <batten/arcs.h>

#define BAT_CONIC_TANGENTS                                                                    \
    {                                                                                         \
        "tangents", BATTEN_VALUE_POINT, true, false, NULL, NULL,                              \
            "a direction for each point; by circles through three points when there are none" \
    }
#define BAT_CONIC_SHARES                                                                     \
    {"start-share",                                                                          \
     BATTEN_VALUE_NUMBER,                                                                    \
     false,                                                                                  \
     false,                                                                                  \
     "0",                                                                                    \
     NULL,                                                                                   \
     "where the first control point lies from the start, 0, to where the tangents meet, 1; " \
     "0: found"},                                                                            \
    {                                                                                        \
        "end-share", BATTEN_VALUE_NUMBER, false, false, "0", NULL, "the same from the end"   \
    }

/* A row of points as conics, with notes of spans that are otherwise. */
batten_status bat_conics_make(bat_run *run, const bat_data *data,
                              const batten_curve_conics_options *options, bat_made *made);

#endif
