/*
 * Where searches of least energy start: the other curves that go through the same points. What is
 * found has to be better than all of them.
 */
#include "numeric/vector.h"
#include "shape/bent/energy.h"
#include "shape/points/parametrize.h"
#include <batten/interpolate.h>
#include <batten/local.h>

#include <string.h>

/* ---- plane chains, also of points in a plane of space ---- */

/* The plane of the points and of the tangents at the ends, when there is one. */
typedef struct {
    batten_vec3 x, y, z; /* square axes through the first point, which is the origin */
    double *points;      /* [count][2] */
    double angles[2];    /* of the tangents given */
} plane_points;

static batten_vec3 point_at(const bat_energy_spline *t, int i)
{
    return bat_vec3_of(t->d, t->points + (size_t)i * (size_t)t->d);
}

/* The axes, from the points farthest from the first and from the line to that. */
static void find_axes(const bat_energy_spline *t, plane_points *out)
{
    batten_vec3 far = {0, 0, 0}, aside = {0, 0, 0};
    for (int i = 1; i < t->count; i++)
        far = bat_vec3_norm(point_at(t, i)) > bat_vec3_norm(far) ? point_at(t, i) : far;
    out->x = bat_vec3_scale(far, 1 / bat_vec3_norm(far));
    for (int i = 1; i < t->count; i++) {
        const batten_vec3 p = point_at(t, i);
        const batten_vec3 off = bat_vec3_along(p, -bat_vec3_dot(p, out->x), out->x);
        aside = bat_vec3_norm(off) > bat_vec3_norm(aside) ? off : aside;
    }
    const double width = bat_vec3_norm(aside);
    out->y = width > 0 ? bat_vec3_scale(aside, 1 / width) : aside;
    out->z = bat_vec3_cross(out->x, out->y);
}

/* In the plane x and y stay as they are. */
static bool find_plane(const bat_energy_spline *t, plane_points *out)
{
    /* What is farther out is seen in the curve. */
    static const double flat = 1e-12;
    const double *const tangents[2] = {t->options->start_tangent, t->options->end_tangent};
    if (t->d == 2)
        *out = (plane_points){
            .x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}, .points = out->points};
    else
        find_axes(t, out);
    double size = 0, off = 0;
    for (int i = 0; i < t->count; i++) {
        const batten_vec3 p = point_at(t, i);
        out->points[2 * i] = bat_vec3_dot(p, out->x);
        out->points[2 * i + 1] = bat_vec3_dot(p, out->y);
        size = bat_max(size, bat_vec3_norm(p));
        off = bat_max(off, fabs(bat_vec3_dot(p, out->z)));
    }
    bool is_flat = off <= flat * size && bat_vec3_norm(out->z) > 0;
    for (int e = 0; e < 2 && is_flat; e++) {
        const batten_vec3 way = tangents[e] ? bat_vec3_of(t->d, tangents[e]) : out->x;
        out->angles[e] = bat_atan2(bat_vec3_dot(way, out->y), bat_vec3_dot(way, out->x));
        is_flat = fabs(bat_vec3_dot(way, out->z)) <= flat * bat_vec3_norm(way);
    }
    return is_flat;
}

static batten_status put_into_space(const bat_energy_spline *t, const plane_points *plane,
                                    batten_chain **chain)
{
    const batten_frame frame = {{0, 0, 0}, plane->x, plane->z};
    batten_chain *placed = NULL;
    const batten_status status =
        t->d == 3 ? batten_chain_place(*chain, &frame, &placed) : BATTEN_OK;
    if (placed) {
        batten_chain_unref(*chain);
        *chain = placed;
    }
    return status;
}

/* A chain of a family, or Spiro's: with free ends those of the least energy of its kind. */
static batten_status make_chain(const bat_energy_spline *t, const plane_points *plane,
                                bool spiro, batten_span_family family, bat_energy_start *out)
{
    const batten_curve_minimum_energy_options *o = t->options;
    const batten_points points = {2, t->count, plane->points};
    const batten_nonlinear_end free_end = o->energy == BATTEN_ENERGY_BENDING
                                              ? BATTEN_NONLINEAR_NATURAL
                                              : BATTEN_NONLINEAR_CIRCULAR;
    batten_chain_nonlinear_options nonlinear = batten_chain_nonlinear_defaults();
    batten_chain_spiro_options by_spiro = batten_chain_spiro_defaults();
    nonlinear.family = family;
    nonlinear.closed = by_spiro.closed = o->closed;
    nonlinear.start = o->start_tangent ? BATTEN_NONLINEAR_TANGENT : free_end;
    nonlinear.end = o->end_tangent ? BATTEN_NONLINEAR_TANGENT : free_end;
    nonlinear.start_value = by_spiro.start.tangent = o->start_tangent ? plane->angles[0] : 0;
    nonlinear.end_value = by_spiro.end.tangent = o->end_tangent ? plane->angles[1] : 0;
    by_spiro.start.has_tangent = o->start_tangent;
    by_spiro.end.has_tangent = o->end_tangent;
    batten_status status =
        spiro ? batten_chain_spiro(points, &by_spiro, out->parameters, NULL, &out->chain)
              : batten_chain_nonlinear(points, &nonlinear, NULL, out->parameters, NULL,
                                       &out->chain);
    if (status == BATTEN_OK)
        out->parameters[t->count - !o->closed] = batten_chain_domain(out->chain).b;
    return status == BATTEN_OK ? put_into_space(t, plane, &out->chain) : status;
}

/* ---- cubics ---- */

/* A cubic spline whose second derivative is continuous. */
static batten_status make_cubic(const bat_energy_spline *t, batten_parametrization parameters,
                                bat_energy_start *out)
{
    const batten_curve_minimum_energy_options *o = t->options;
    const bool natural = o->energy == BATTEN_ENERGY_BENDING;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    const batten_status status = bat_parametrize((batten_points){t->d, t->count, t->points},
                                                 parameters, o->closed, out->parameters);
    if (status != BATTEN_OK)
        return status;
    options.parameters = BATTEN_GIVEN;
    options.given = out->parameters;
    options.knots_at_data = true;
    options.closed = o->closed;
    options.start.kind = options.end.kind =
        natural ? BATTEN_END_NATURAL : BATTEN_END_NOT_A_KNOT;
    return batten_curve_interpolate((batten_points){t->d, t->count, t->points}, &options, NULL,
                                    &out->curve);
}

/* A cubic with the tangents of circles through three neighbours: its curvature steps, but where
 * points lie wildly it has none of the sharp bends of the others. */
static batten_status make_round(const bat_energy_spline *t, bat_energy_start *out)
{
    const batten_points points = {t->d, t->count, t->points};
    batten_tangents_options options = batten_tangents_defaults();
    options.length = BATTEN_LENGTH_MIDDLE;
    options.closed = t->options->closed;
    double *tangents = bat_array3((size_t)t->count, (size_t)t->d, sizeof *tangents);
    if (!tangents)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status =
        batten_tangents(points, &options, out->parameters, NULL, tangents, NULL);
    if (status == BATTEN_OK)
        status = batten_curve_from_tangents(points, out->parameters, tangents, NULL,
                                            t->options->closed, &out->curve);
    bat_release(tangents);
    return status;
}

typedef enum { ELASTICA, SPIRO, EULER, CHORD, CENTRIPETAL, UNIFORM, ROUND } start_kind;

/* In the order in which one is taken before another of the same energy: the plane ones, which are the curve
 * sought or near it, and the others. */
static const start_kind kinds_of_bending[] = {ELASTICA,    EULER,   SPIRO, CHORD,
                                              CENTRIPETAL, UNIFORM, ROUND};
static const start_kind kinds_of_variation[] = {SPIRO,       EULER,   ELASTICA, CHORD,
                                                CENTRIPETAL, UNIFORM, ROUND};
enum { PLANE_KINDS = 3 };

static batten_status make_start(const bat_energy_spline *t, const plane_points *plane,
                                start_kind kind, bat_energy_start *out)
{
    switch (kind) {
    case ELASTICA:
        return make_chain(t, plane, false, BATTEN_FAMILY_ELASTICA, out);
    case SPIRO:
        return make_chain(t, plane, true, BATTEN_FAMILY_ELASTICA, out);
    case EULER:
        return make_chain(t, plane, false, BATTEN_FAMILY_EULER_SPIRAL, out);
    case CHORD:
        return make_cubic(t, BATTEN_CHORD, out);
    case CENTRIPETAL:
        return make_cubic(t, BATTEN_CENTRIPETAL, out);
    case UNIFORM:
        return make_cubic(t, BATTEN_UNIFORM, out);
    default:
        return make_round(t, out);
    }
}

static void release_start(bat_energy_start *start)
{
    batten_chain_unref(start->chain);
    batten_curve_unref(start->curve);
    bat_release(start->parameters);
    *start = (bat_energy_start){0};
}

/* Behind all that have no more energy, but for what does not count. */
static void insert_start(const bat_energy_spline *t, bat_energy_start start,
                         bat_energy_starts *starts)
{
    const double same = start.energy * (1 + BAT_ENERGY_WORTH) + BAT_ENERGY_NOTHING * t->count;
    int i = starts->count++;
    for (; i > 0 && starts->at[i - 1].energy > same; i--)
        starts->at[i] = starts->at[i - 1];
    starts->at[i] = start;
}

/* Does this failure end the whole? That there is no such curve does not. */
static bool ends_all(batten_status status)
{
    return status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED;
}

/* Chains take the tangents given, cubics nothing. */
static bool meets_ends(const bat_energy_spline *t, const bat_energy_start *start)
{
    const batten_curve_minimum_energy_options *o = t->options;
    const bool has_tangents = o->start_tangent || o->end_tangent;
    const bool has_curvatures = o->start_curvature || o->end_curvature;
    return o->closed || (!has_curvatures && (start->chain || !has_tangents));
}

static batten_status add_start(const bat_energy_spline *t, const plane_points *plane,
                               start_kind kind, bat_energy_starts *out)
{
    bat_energy_start start = {.energy = HUGE_VAL};
    start.parameters = bat_array((size_t)t->count + 1, sizeof *start.parameters);
    batten_status status =
        start.parameters ? make_start(t, plane, kind, &start) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_energy_measure(t, start.chain, start.curve, 1, &start.energy);
    /* Where curvature steps its variation is infinite. */
    if (status == BATTEN_OK && kind == ROUND && t->options->energy == BATTEN_ENERGY_VARIATION)
        start.energy = HUGE_VAL;
    if (status == BATTEN_OK) {
        start.is_rival = meets_ends(t, &start);
        insert_start(t, start, out);
        return BATTEN_OK;
    }
    release_start(&start);
    return ends_all(status) ? status : BATTEN_OK;
}

batten_status bat_energy_starts_make(const bat_energy_spline *t, bat_energy_starts *out)
{
    const start_kind *kinds =
        t->options->energy == BATTEN_ENERGY_BENDING ? kinds_of_bending : kinds_of_variation;
    plane_points plane = {.points = bat_array((size_t)t->count, 2 * sizeof *plane.points)};
    batten_status status = plane.points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const bool is_plane = t->count > 2 && find_plane(t, &plane);
        for (int i = is_plane ? 0 : PLANE_KINDS;
             i < BAT_ENERGY_MOST_STARTS && status == BATTEN_OK; i++)
            status = add_start(t, &plane, kinds[i], out);
    }
    bat_release(plane.points);
    return status;
}

void bat_energy_starts_release(bat_energy_starts *starts)
{
    for (int i = 0; i < starts->count; i++)
        release_start(&starts->at[i]);
    starts->count = 0;
}
