/* What the feature 'frames' and the output 'frame-table' share. */
#ifndef BAT_FEATURES_FRAMES_H
#define BAT_FEATURES_FRAMES_H
#include "design/feature.h"

#include <batten/skin.h>

#define BAT_FRAMES_PARAMETERS                                             \
    {"kind",                                                              \
     BATTEN_VALUE_WORD,                                                   \
     false,                                                               \
     false,                                                               \
     "rotation-minimising",                                               \
     "rotation-minimising fixed frenet closing",                          \
     "how the frames turn about the tangent"},                            \
    {                                                                     \
        "count", BATTEN_VALUE_COUNT, false, false, "24", NULL,            \
            "frames, evenly by arc length, one at either end; at least 2" \
    }

/* Frames along one curve, and where on it they stand. */
typedef struct {
    int count;
    double *at, *length; /* parameters, arc lengths from the start */
    batten_frame *frames;
} bat_frames;

batten_status bat_frames_of(const bat_run *run, const batten_object *object, bat_frames *out);
void bat_frames_release(bat_frames *frames);

#endif
