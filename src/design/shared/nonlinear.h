/* What the features of nonlinear splines share: conditions at the ends, and what is reported.
 */
#ifndef BAT_DESIGN_NONLINEAR_H
#define BAT_DESIGN_NONLINEAR_H
#include "design/shared/through.h"
#include <batten/bent.h>

#define BAT_NONLINEAR_WORDS "natural circular tangent curvature"

/* The last paragraph of their manual. */
#define BAT_NONLINEAR_ENDS_TEXT                                                               \
    "'ends', or 'start' and 'end', set the conditions at the ends: 'natural' is curvature\n"  \
    "0; 'circular' is constant curvature over the last span; 'tangent' takes its direction\n" \
    "from 'start-angle' and 'end-angle', 'curvature' its value from 'start-curvature' and\n"  \
    "'end-curvature'."

/* Their parameters besides the input: give them all, and BAT_EACH and BAT_CLOSED. */
#define BAT_NONLINEAR_ENDS                                                                   \
    {"ends",                                                                                 \
     BATTEN_VALUE_WORD,                                                                      \
     false,                                                                                  \
     false,                                                                                  \
     "natural",                                                                              \
     BAT_NONLINEAR_WORDS,                                                                    \
     "what holds at both ends: curvature 0, curvature constant on the last span, or given"}, \
        {"start",                                                                            \
         BATTEN_VALUE_WORD,                                                                  \
         false,                                                                              \
         false,                                                                              \
         NULL,                                                                               \
         BAT_NONLINEAR_WORDS,                                                                \
         "what holds at the start"},                                                         \
        {"start-angle",                                                                      \
         BATTEN_VALUE_ANGLE,                                                                 \
         false,                                                                              \
         false,                                                                              \
         "0",                                                                                \
         NULL,                                                                               \
         "direction of a given tangent at the start, from the first axis of the plane"},     \
        {"start-curvature",                                                                  \
         BATTEN_VALUE_NUMBER,                                                                \
         false,                                                                              \
         false,                                                                              \
         "0",                                                                                \
         NULL,                                                                               \
         "given curvature at the start, 1 by the unit; above 0 to the left"},                \
        {"end",                                                                              \
         BATTEN_VALUE_WORD,                                                                  \
         false,                                                                              \
         false,                                                                              \
         NULL,                                                                               \
         BAT_NONLINEAR_WORDS,                                                                \
         "what holds at the end"},                                                           \
        {"end-angle",                                                                        \
         BATTEN_VALUE_ANGLE,                                                                 \
         false,                                                                              \
         false,                                                                              \
         "0",                                                                                \
         NULL,                                                                               \
         "direction of a given tangent at the end"},                                         \
    {                                                                                        \
        "end-curvature", BATTEN_VALUE_NUMBER, false, false, "0", NULL,                       \
            "given curvature at the end"                                                     \
    }

/* What holds at the start, or at the end, and its value. */
batten_nonlinear_end bat_nonlinear_end_of(const bat_run *run, bool start, double *value);

/* A row of points through one family; `tensions`: one for each span of a local spline in
 * tension, or NULL. */
batten_status bat_nonlinear_make(bat_run *run, const bat_data *data, batten_span_family family,
                                 const double *tensions, bat_made *made);

#endif
