/* What the features 'fold' and 'crease-pattern' share: the same sheet, folded and flat. */
#ifndef BAT_FEATURES_FOLD_H
#define BAT_FEATURES_FOLD_H
#include "design/feature.h"

#include <batten/plate.h>

#define BAT_FOLD_PARAMETERS                                                                 \
    {"angle",                                                                               \
     BATTEN_VALUE_ANGLE,                                                                    \
     true,                                                                                  \
     false,                                                                                 \
     NULL,                                                                                  \
     NULL,                                                                                  \
     "between each sheet and the osculating plane of the crease; one, or several at equal " \
     "steps "                                                                               \
     "along it"},                                                                           \
        {"flat-curvature",                                                                  \
         BATTEN_VALUE_NUMBER,                                                               \
         true,                                                                              \
         false,                                                                             \
         NULL,                                                                              \
         NULL,                                                                              \
         "instead of the angle: the curvature of the crease in the flat sheet, one by the " \
         "unit"},                                                                           \
        {"crease",                                                                          \
         BATTEN_VALUE_WORD,                                                                 \
         false,                                                                             \
         false,                                                                             \
         "space",                                                                           \
         "space flat",                                                                      \
         "where the crease is given: in space, or in the flat sheet"},                      \
        {"torsion",                                                                         \
         BATTEN_VALUE_NUMBER,                                                               \
         true,                                                                              \
         false,                                                                             \
         NULL,                                                                              \
         NULL,                                                                              \
         "of the space curve that a flat crease becomes; 0 by default"},                    \
        {"left",                                                                            \
         BATTEN_VALUE_LENGTH,                                                               \
         false,                                                                             \
         true,                                                                              \
         NULL,                                                                              \
         NULL,                                                                              \
         "width of the sheet on the inner side of the crease"},                             \
        {"right",                                                                           \
         BATTEN_VALUE_LENGTH,                                                               \
         false,                                                                             \
         false,                                                                             \
         NULL,                                                                              \
         NULL,                                                                              \
         "width of the other sheet; that of the left one by default"},                      \
    {                                                                                       \
        "within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,                            \
            "how near the surfaces are; the tolerance of the design by default"             \
    }

/* Fold along the one curve of the principal input. */
batten_status bat_fold(bat_run *run, batten_fold *out);

#endif
