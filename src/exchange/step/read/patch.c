/* Faces that are the whole of their surface, as Batten writes untrimmed ones. */
#include "exchange/step/read/topology.h"
#include "numeric/vector.h"

#include <float.h>
#include <string.h>

enum { SOUTH, EAST, NORTH, WEST, SIDES };

/* A row of the net along a border. */
typedef struct {
    int degree, count;
    const double *knots, *points, *weights;
    size_t stride; /* from one point to the next */
} border;

static border take_border(const batten_surface *s, int side)
{
    const int count_u = batten_surface_point_count(s, BATTEN_U);
    const int count_v = batten_surface_point_count(s, BATTEN_V);
    const bool along_u = side == SOUTH || side == NORTH;
    const batten_direction direction = along_u ? BATTEN_U : BATTEN_V;
    const size_t start = side == NORTH  ? (size_t)count_v - 1
                         : side == EAST ? ((size_t)count_u - 1) * (size_t)count_v
                                        : 0;
    const double *weights = batten_surface_weights(s);
    return (border){.degree = batten_surface_degree(s, direction),
                    .count = along_u ? count_u : count_v,
                    .knots = batten_surface_knots(s, direction),
                    .points = batten_surface_points(s) + 3 * start,
                    .weights = weights ? weights + start : NULL,
                    .stride = along_u ? (size_t)count_v : 1};
}

static const double *border_point(const border *b, int i)
{
    return &b->points[3 * (size_t)i * b->stride];
}

static bool is_point(const border *b, double tolerance)
{
    for (int i = 1; i < b->count; i++)
        if (bat_distance(3, border_point(b, i), border_point(b, 0)) > tolerance)
            return false;
    return true;
}

/* The same curve, to `tolerance` and a few roundings. Weights that are all the same are none.
 */
static bool is_border(const border *b, const batten_curve *curve, double tolerance)
{
    const double *weights = batten_curve_weights(curve), *points = batten_curve_points(curve);
    if (batten_curve_degree(curve) != b->degree || batten_curve_point_count(curve) != b->count)
        return false;
    if (memcmp(batten_curve_knots(curve), b->knots,
               (size_t)(b->count + b->degree + 1) * sizeof *b->knots))
        return false;
    for (int i = 0; i < b->count; i++) {
        const double given = weights ? weights[i] / weights[0] : 1;
        const double wanted =
            b->weights ? b->weights[(size_t)i * b->stride] / b->weights[0] : 1;
        const double *point = border_point(b, i);
        /* Weights have no unit: equal to 12 digits, which is what is written of them. */
        const double near = tolerance + 8 * DBL_EPSILON * bat_largest(3, point);
        if (bat_distance(3, &points[3 * i], point) > near ||
            fabs(given - wanted) > 1e-12 * wanted)
            return false;
    }
    return true;
}

/* Does the use go along the border, as a loop around the patch does? */
static bool is_along(const batten_body_parts *p, const border *b, int side, int index)
{
    const batten_body_use *use = &p->uses[index];
    const batten_curve *curve = p->edges[use->edge].curve;
    bool is_seam = false; /* of which only one border is kept in full */
    for (int i = 0; i < p->use_count; i++)
        is_seam |= i != index && p->uses[i].edge == use->edge;
    return use->reversed == (side >= NORTH) && curve && !batten_curve_is_periodic(curve) &&
           is_border(b, curve, is_seam ? p->tolerance : 0);
}

/* Do the uses from `first` on, cyclically, go along all borders but those that are points? */
static bool goes_around(const batten_body_parts *p, const border borders[SIDES], int first)
{
    int used = 0;
    for (int side = 0; side < SIDES; side++)
        if (used < p->use_count &&
            is_along(p, &borders[side], side, (first + used) % p->use_count))
            used++;
        else if (!is_point(&borders[side], p->tolerance))
            return false;
    return used == p->use_count;
}

const batten_body_face *bat_step_whole_patch(const batten_body *body)
{
    const batten_body_parts *p = batten_body_view(body);
    border borders[SIDES];
    if (p->face_count != 1 || p->loop_count != 1 || p->use_count > SIDES ||
        p->faces[0].reversed)
        return NULL;
    const batten_surface *s = p->faces[0].surface;
    if (strcmp(batten_surface_kind(s), "nurbs") != 0 ||
        batten_surface_is_periodic(s, BATTEN_U) || batten_surface_is_periodic(s, BATTEN_V))
        return NULL;
    for (int side = 0; side < SIDES; side++)
        borders[side] = take_border(s, side);
    for (int first = 0; first < p->use_count; first++)
        if (goes_around(p, borders, first))
            return &p->faces[0];
    return NULL;
}
