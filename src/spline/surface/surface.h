/*
 * What a surface is inside: a count of references and a table of what its kind can do. Public
 * functions for every kind go through the table; those for NURBS surfaces take the surface for
 * what it is.
 */
#ifndef BAT_SURFACE_H
#define BAT_SURFACE_H
#include "spline/surface/axis.h"
#include <batten/scattered.h>
#include <batten/surface.h>

typedef struct bat_surface_kind bat_surface_kind;

struct batten_surface {
    bat_references references;
    const bat_surface_kind *kind;
    int dimension;
};

/* Parameters, and the sides from which they are approached where a knot lies. */
typedef struct {
    double u, v;
    batten_sides sides;
} bat_surface_place;

static inline bat_surface_place bat_surface_place_at(double u, double v)
{
    return (bat_surface_place){u, v, {BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT}};
}

/* What decides how much of a derivative is roundoff: the spans that hold the point, and the
 * size of numbers. */
typedef struct {
    int degree[2];
    double span[2]; /* lengths */
    double largest; /* |coordinate| of the control points */
} bat_surface_local;

/* One function for each public one of the same name. */
struct bat_surface_kind {
    const char *name;
    int highest_order; /* of the derivatives it has */
    void (*free)(batten_surface *surface);
    batten_interval (*domain)(const batten_surface *surface, batten_direction direction);
    bool (*is_periodic)(const batten_surface *surface, batten_direction direction);
    int (*spans)(const batten_surface *surface, batten_direction direction, double *knots);
    bool (*is_closed)(const batten_surface *surface, batten_direction direction,
                      double tolerance);
    batten_box (*box)(const batten_surface *surface);
    batten_status (*evaluate)(const batten_surface *surface, const bat_surface_place *at,
                              int order, double *out);
    batten_status (*evaluate_many)(const batten_surface *surface, batten_batch uv, int order,
                                   const batten_job *job, double *out);
    batten_status (*evaluate_grid)(const batten_surface *surface, batten_uv_grid places,
                                   int order, const batten_job *job, double *out);
    batten_status (*normal_grid)(const batten_surface *surface, batten_uv_grid places,
                                 const batten_job *job, double *points, double *normals);
    void (*local)(const batten_surface *surface, const bat_surface_place *at,
                  bat_surface_local *out);
    batten_status (*isocurve)(const batten_surface *surface, batten_direction direction,
                              double at, batten_curve **out);
    batten_status (*to_nurbs)(const batten_surface *surface, double tolerance,
                              batten_surface **out, double *error);
    batten_status (*transform)(const batten_surface *surface, const batten_affine *map,
                               batten_surface **out);
    /* u runs the other way, over the same domain if that can be. */
    batten_status (*turn_over)(const batten_surface *surface, batten_surface **out);
};

/* ---- the NURBS kind ---- */

typedef struct {
    batten_surface base;
    bat_axis axes[2]; /* BATTEN_U, BATTEN_V */
    size_t width;     /* of a row of the net: dimension, + 1 when rational */
    double *points;   /* [count_u][count_v][dimension], Cartesian */
    double *weights;  /* [count_u][count_v] or NULL */
    double *net;      /* [count_u][count_v][width]: the points, or (w x .., w) with w scaled */
    double weight_scale; /* the power of two that brings the largest weight into [1, 2) */
    double largest;      /* the largest |coordinate| of a control point */
} bat_nurbs;

/* What a constructor asks for; counts with the wrapped points of a periodic direction. */
typedef struct {
    int dimension, degree[2], count[2];
    bool periodic[2], rational;
} bat_nurbs_shape;

/* A surface whose knots, points and weights wait to be filled in, by nobody else seen yet.
 * bat_nurbs_finish looks at points and weights (not at knots), derives the rest and hands it
 * over, or gives it back. */
batten_status bat_nurbs_make(const bat_nurbs_shape *shape, bat_nurbs **out);
batten_status bat_nurbs_finish(bat_nurbs *nurbs, batten_surface **out);
void bat_nurbs_free(bat_nurbs *nurbs);
/* The shape of an existing one, from which to make others. */
bat_nurbs_shape bat_nurbs_shape_of(const bat_nurbs *nurbs);

const bat_nurbs *bat_surface_nurbs(const batten_surface *surface); /* asserts the kind */
/* The same inside the functions of the kind, which are called through it. */
static inline const bat_nurbs *bat_nurbs_of(const batten_surface *surface)
{
    return (const bat_nurbs *)surface;
}

extern const bat_surface_kind bat_nurbs_kind;

/* Its evaluation (evaluate.c, grid.c), isocurves (isocurve.c), and maps (nurbs.c). */
batten_status bat_nurbs_evaluate(const batten_surface *surface, const bat_surface_place *at,
                                 int order, double *out);
batten_status bat_nurbs_evaluate_many(const batten_surface *surface, batten_batch uv, int order,
                                      const batten_job *job, double *out);
batten_status bat_nurbs_evaluate_grid(const batten_surface *surface, batten_uv_grid places,
                                      int order, const batten_job *job, double *out);
batten_status bat_nurbs_normal_grid(const batten_surface *surface, batten_uv_grid places,
                                    const batten_job *job, double *points, double *normals);
batten_status bat_nurbs_isocurve(const batten_surface *surface, batten_direction direction,
                                 double at, batten_curve **out);
batten_status bat_nurbs_turn_over(const batten_surface *surface, batten_surface **out);
/* The row of the net at `at` in `direction`, or of its derivative of this order <= 2 across:
 * [count of the other direction][width], homogeneous as the net. `at` is inside the domain. */
void bat_nurbs_row(const bat_nurbs *nurbs, batten_direction direction, double at,
                   batten_side side, int order, double *row);

/* From homogeneous derivatives `a` [BATTEN_SURFACE_DERIVATIVES(order)][dimension + 1] to those
 * of the surface, after the rule of Leibniz for w S = A. */
void bat_surface_divide(int dimension, int order, const double *a, double *out);
/* Is every number finite? Faster than asking for the index of one that is not. */
bool bat_all_finite(const double *values, size_t count);

/* When a change succeeded, put its result in the place of what it was made from. The result is
 * pointed to, for the change may be made in the same call, and arguments have no order. */
static inline batten_status bat_surface_replace(batten_status status, batten_surface **surface,
                                                batten_surface *const *made)
{
    if (status == BATTEN_OK) {
        batten_surface_unref(*surface);
        *surface = *made;
    }
    return status;
}

/* Clamp a NURBS surface in both directions, in its place; what is clamped keeps its bits. */
batten_status bat_surface_clamp_both(batten_surface **surface);

static inline batten_direction bat_other(batten_direction direction)
{
    return direction == BATTEN_U ? BATTEN_V : BATTEN_U;
}

#endif
