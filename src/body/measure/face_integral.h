/*
 * Integrals over a trimmed face as integrals along its loops, by Green's theorem:
 * the integral of g du dv over the face is that of G dv along its loops, with G the integral of
 * g along u from any fixed place; or, u and v exchanged, minus that of H du.
 */
#ifndef BAT_FACE_INTEGRAL_H
#define BAT_FACE_INTEGRAL_H
#include "base/base.h"
#include <batten/body.h>

/* N is Su x Sv; x, y, z are measured from `centre` and divided by `size`. */
typedef enum {
    BAT_AREA,              /* |N| */
    BAT_AREA_MOMENT,       /* three: x |N|, y |N|, z |N| */
    BAT_VOLUME = 4,        /* three: x Nx, y Ny, z Nz */
    BAT_VOLUME_MOMENT = 7, /* three: x^2 / 2 Nx, ... */
    BAT_FACE_INTEGRALS = 10
} bat_face_integral;

typedef struct {
    batten_vec3 centre;
    double size;
    /* Of the area of each face, and of its area times `size`: how far off they may be. */
    double area_precision, volume_precision;
    size_t most; /* evaluations of the surface for one face */
} bat_face_rules;

typedef struct {
    double values[BAT_FACE_INTEGRALS]; /* seen from outside the face */
    double area_error, volume_error;   /* by which the rules differ */
    double slack; /* the area between the edges and the face's own curves of them */
    bool is_met;  /* both errors are as small as was asked for */
} bat_face_sums;

/* Where the coordinates of a body are measured from, and by what; the rest is 0. */
bat_face_rules bat_face_rules_of(const batten_body *body);
/* Add what a face has to the sums of several. */
void bat_face_add(bat_face_sums *sums, const bat_face_sums *face);
/* The mean of the three forms of the volume. They agree when the faces close: their spread is
 * part of its error. Both in size^3. */
double bat_face_volume(const bat_face_sums *sums);
double bat_face_volume_error(const bat_face_sums *sums);

/* Face `face` of a body that is traced, with loops. */
batten_status bat_face_integrate(const batten_body_parts *parts, int face,
                                 const bat_face_rules *rules, bat_face_sums *out);

#endif
