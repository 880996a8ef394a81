/* Scalar fields on surfaces, as designs name them. */
#ifndef BAT_DESIGN_FIELD_H
#define BAT_DESIGN_FIELD_H
#include "design/feature.h"

#include <batten/contours.h>

/* In the order of batten_field_kind. */
#define BAT_FIELD_WORDS \
    "height gaussian mean kappa1 kappa2 isophote draft highlight reflection silhouette absolute zebra"

#define BAT_FIELD_PARAMETERS                                                                                \
    {"spacing",                                                                                             \
     BATTEN_VALUE_LENGTH,                                                                                   \
     false,                                                                                                 \
     false,                                                                                                 \
     "0",                                                                                                   \
     NULL,                                                                                                  \
     "of contours: a length for heights and light lines, else a number; 0: chosen"},                        \
        {"direction",                                                                                       \
         BATTEN_VALUE_POINT,                                                                                \
         false,                                                                                             \
         false,                                                                                             \
         NULL,                                                                                              \
         NULL,                                                                                              \
         "of heights, light, the pull of a mould, a line of light or the tubes of a zebra; up by default"}, \
    {                                                                                                       \
        "through", BATTEN_VALUE_POINT, false, false, "origin", NULL,                                        \
            "a point of the light line of highlight and reflection lines; the eye of a silhouette"          \
    }

/* The field of this kind; `eye` is the direction to the one who looks. */
batten_surface_field bat_field_of(const bat_run *run, batten_field_kind kind, batten_vec3 eye);

#endif
