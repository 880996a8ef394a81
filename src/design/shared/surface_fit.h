/* What features that make surfaces near points share: how smooth, and the report. */
#ifndef BAT_DESIGN_SURFACE_FIT_H
#define BAT_DESIGN_SURFACE_FIT_H
#include "design/feature.h"
#include <batten/grid.h>

#define BAT_SMOOTHNESS                                                   \
    {"rms",                                                              \
     BATTEN_VALUE_LENGTH,                                                \
     false,                                                              \
     false,                                                              \
     NULL,                                                               \
     NULL,                                                               \
     "the root of the mean squared distance that may be left"},          \
    {                                                                    \
        "lambda", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,         \
            "how much bending weighs against distance, instead of 'rms'" \
    }

/* 'rms', 'lambda' or neither. */
batten_status bat_smoothness_of(const bat_run *run, batten_smooth_by *by, double *amount);
/* The error of the feature, and a remark that says how large it is, where, and how most are. */
void bat_report_surface_fit(bat_run *run, const batten_surface_fit_report *report);

#endif
