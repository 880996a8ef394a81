/* What the features that fit lines, circles, ellipses and clothoids share. */
#ifndef BAT_FEATURES_PRIMITIVE_H
#define BAT_FEATURES_PRIMITIVE_H
#include "design/shared/through.h"
#include <batten/approximate.h>

/* How much of a closed shape is drawn. */
#define BAT_WHOLE                                                                        \
    {                                                                                    \
        "whole", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,                         \
            "all of it, or the part beside the points alone, from the first to the last" \
    }

/* The shape and its report were made; hands the status on. */
static inline batten_status bat_made_primitive(const batten_primitive_report *report,
                                               batten_status status, bat_made *made)
{
    if (status != BATTEN_OK)
        return status;
    made->has_error = true;
    made->error_max = report->error;
    made->error_rms = report->rms;
    return BATTEN_OK;
}

#endif
