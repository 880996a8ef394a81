/* Where things stand and how they end: frames and end conditions from arguments. */
#ifndef BAT_DESIGN_PLACE_H
#define BAT_DESIGN_PLACE_H
#include "design/feature.h"

/* The parameters "at", "axis" and "from", which every shape with a place of its own has. */
#define BAT_PLACE                                                                        \
    {"at", BATTEN_VALUE_POINT, false, false, "origin", NULL, "where it stands"},         \
        {"axis",                                                                         \
         BATTEN_VALUE_POINT,                                                             \
         false,                                                                          \
         false,                                                                          \
         "z",                                                                            \
         NULL,                                                                           \
         "its axis, or the normal of its plane"},                                        \
    {                                                                                    \
        "from", BATTEN_VALUE_POINT, false, false, NULL, NULL, "the direction of angle 0" \
    }

/* The frame of these parameters. BAD_ARGUMENT when the axis is 0, or `from` parallel to it. */
batten_status bat_frame(const bat_run *run, batten_frame *out);
/* Put a curve of the xy-plane into the frame of the feature, in space; the curve's reference is
 * given back, and a bad status so far handed on. */
batten_status bat_place_curve(bat_run *run, batten_status status, batten_curve *plane);
/* Fails, naming the parameter, when a vector is 0. */
batten_status bat_check_direction(const char *parameter, batten_vec3 v);

/* The words of batten_end_kind, in its order. */
#define BAT_END_WORDS \
    "not-a-knot natural clamped direction second parabolic bessel circle curvature fair"

/* The parameters "ends", "start", "end" and their vectors of splines that solve for slopes or
 * bends alone, and so know no further ends than these. */
#define BAT_PLAIN_ENDS                                                                          \
    {"ends",                                                                                    \
     BATTEN_VALUE_WORD,                                                                         \
     false,                                                                                     \
     false,                                                                                     \
     "natural",                                                                                 \
     BAT_END_WORDS,                                                                             \
     "what holds at both ends; not not-a-knot, curvature or fair"},                             \
        {"start",       BATTEN_VALUE_WORD,        false, false, NULL,                           \
         BAT_END_WORDS, "what holds at the start"},                                             \
        {"start-vector",                                                                        \
         BATTEN_VALUE_POINT,                                                                    \
         false,                                                                                 \
         false,                                                                                 \
         "origin",                                                                              \
         NULL,                                                                                  \
         "the derivative or direction at the start; of a function its first number"},           \
        {"end", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS, "what holds at the end"}, \
    {                                                                                           \
        "end-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,                         \
            "the derivative or direction at the end; of a function its first number"            \
    }

/* What holds at an end: the word of its own parameter, else that of "ends", with the vector. */
batten_end bat_end(const bat_run *run, const char *own, const char *vector);

#endif
