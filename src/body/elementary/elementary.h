/*
 * Lines, conics, planes, cylinders, cones, spheres, tori, extrusions and revolutions as IGES
 * and STEP say them, unbounded, and their bounded parts as exact NURBS.
 */
#ifndef BAT_BODY_ELEMENTARY_H
#define BAT_BODY_ELEMENTARY_H
#include "base/base.h"
#include <batten/geometry.h>
#include <batten/surface.h>

typedef enum {
    BAT_LINE,     /* origin + t x */
    BAT_ELLIPSE,  /* origin + a cos(t) x + b sin(t) y; a circle when a = b */
    BAT_PARABOLA, /* origin + a t^2 x + 2 a t y; a is the focal distance */
    BAT_HYPERBOLA /* origin + a cosh(t) x + b sinh(t) y */
} bat_conic_kind;

/* x, y = z cross x, z of the frame are unit vectors; of a line x may have any length: it is the
 * measure of t. */
typedef struct {
    bat_conic_kind kind;
    batten_frame frame;
    double a, b;
} bat_conic;

/* The parameter of the foot of a point, in (-pi, pi] for an ellipse. */
double bat_conic_parameter(const bat_conic *conic, const double point[3]);
void bat_conic_point(const bat_conic *conic, double t, double point[3]);
/* The part from t0 to t1 > t0 as a curve in space; an ellipse at most once around. The domain
 * is [t0, t1]; the parametrisation is that of the NURBS. */
batten_status bat_conic_between(const bat_conic *conic, double t0, double t1,
                                batten_curve **out);
/* The part from near the point p to near q, in the direction of rising t or against it; of an
 * ellipse the whole when they are the same point to `tolerance`. Ends are on the conic. */
batten_status bat_conic_part(const bat_conic *conic, const double p[3], const double q[3],
                             bool forward, double tolerance, batten_curve **out);

/* Of another curve the part from near p to near q, running as the curve does, or against it
 * when not `forward` (of an open curve always from p to q); the whole, begun there, when they
 * are the same point and the curve is closed. A curve whose ends are p and q to `tolerance` is
 * kept bit for bit. *miss: the larger distance of p and q from the curve. */
batten_status bat_curve_part(const batten_curve *curve, const double p[3], const double q[3],
                             bool forward, double tolerance, batten_curve **out, double *miss);

typedef enum {
    BAT_PLANE,      /* u x + v y */
    BAT_CYLINDER,   /* radius a; u the angle, v along z */
    BAT_CONE,       /* radius a at v = 0, growing with tan(b) along z: (a + v sin b, v cos b) */
    BAT_SPHERE,     /* radius a */
    BAT_TORUS,      /* major a, minor b; b > a is allowed when it is bounded off its crossing;
                       the normal of the inner part, the lemon, points to the axis. The torus of
                       -a is that of a with its normal turned */
    BAT_EXTRUSION,  /* curve + v z; z of the frame may have any length */
    BAT_REVOLUTION, /* curve about the z-axis of the frame, u around; where it crosses the axis
                       it is cut, and the part taken to which the points belong */
    BAT_OFFSET_SURFACE /* of `surface`, by the distance a along its normal */
} bat_elementary_kind;

typedef struct {
    bat_elementary_kind kind;
    batten_frame frame;
    double a, b;
    const batten_curve *curve;     /* EXTRUSION, REVOLUTION */
    const batten_surface *surface; /* OFFSET_SURFACE */
    int most;                      /* points of what comes near an OFFSET_SURFACE */
    bool is_inner;                 /* the lemon of a TORUS, where the points do not tell */
    bool goes_on; /* nothing bounds the face on one side of its loops, which go around the
                     surface once in all (see bat_around): a cone then ends at its apex */
} bat_elementary;

/*
 * How often the loops of a face go around a cylinder, a cone or the extrusion of a closed
 * curve, in all: by the angles about the axis, and the area that they hold along the direction.
 * Loops that bound a face on both sides add up to nothing.
 */
typedef struct {
    batten_vec3 origin, x, y;
    bool is_turned; /* angles, not areas */
    bool meets_axis;
    double near;       /* the axis */
    double whole, sum; /* of one that goes around once, 0 where none can; of all so far */
} bat_around;

batten_status bat_around_begin(const bat_elementary *elementary, double tolerance,
                               bat_around *around);
/* Loops in any order, and of each its curves. */
batten_status bat_around_add(bat_around *around, const batten_curve *curve, bool reversed);
/* Once in all, one way or the other; never where a loop meets the axis. */
bool bat_around_is_once(const bat_around *around);

/*
 * A NURBS surface on the elementary one that reaches over all the points (samples of the edges
 * of a face), with its normal where it stands: Su x Sv along z of a plane, away from the axis
 * or centre of the others. What closes goes all around: cylinder, cone, sphere, torus,
 * revolution. Where the face goes on beyond its loops a cone reaches to the apex; cylinders and
 * extrusions end nowhere then: NOT_COMPATIBLE.
 * @param points [count][3]; none: spheres, tori and surfaces that are bounded by themselves
 * only, else NOT_COMPATIBLE
 * @param tolerance for offsets; *error is what they reached, 0 when exact
 */
batten_status bat_elementary_surface(const bat_elementary *elementary, int count,
                                     const double *points, double tolerance,
                                     batten_surface **out, double *error);

#endif
