#include "numeric/vector.h"
#include "shape/developable_parts.h"
#include <batten/interpolate.h>
#include <batten/skin.h>

enum { FIRST_SAMPLES = 17, MAX_SAMPLES = 1025, CONE_RULINGS = 8, PROJECTIONS = 6 };

/* The surface between the cones, through so many of its rulings. */
typedef struct {
    int count;
    bat_pair *pairs;   /* [count] */
    double *tau;       /* [count] of the interpolation: the sum of both chords */
    double *points[2]; /* [count][3] on each edge */
    double *u[2];      /* [count] their parameters */
    batten_curve *edge[2];
    batten_surface *surface;
    double error;
} middle;

static void release_middle(middle *m)
{
    for (int e = 0; e < 2; e++) {
        bat_release(m->points[e]);
        bat_release(m->u[e]);
        batten_curve_unref(m->edge[e]);
    }
    bat_release(m->pairs);
    bat_release(m->tau);
    batten_surface_unref(m->surface);
    *m = (middle){0};
}

/* ---- rulings along the path ---- */

static double path_step(const bat_plate *plate, bat_pair a, bat_pair b)
{
    return hypot((b.x - a.x) * plate->edge[0].length, (b.y - a.y) * plate->edge[1].length);
}

/* Where the warp is 0 beside the point of the path that is the share f of its step k. */
static batten_status polish(const bat_plate *plate, int k, double f, bat_pair *out)
{
    const bat_pair *a = &plate->pairs[k], *b = a + 1;
    const double reach = 2.0 / BAT_EDGE_STEPS, length = hypot(b->x - a->x, b->y - a->y);
    const bat_pair across = {-(b->y - a->y) / length, (b->x - a->x) / length};
    bool found;
    *out = (bat_pair){a->x + f * (b->x - a->x), a->y + f * (b->y - a->y)};
    return bat_plate_root(plate, *out, across, reach, reach, &found, out);
}

static bool follows(bat_pair a, bat_pair b)
{
    return b.x >= a.x && b.y >= a.y && (b.x > a.x || b.y > a.y);
}

/* At `wanted` equal steps of the path; those that would run back are left out. */
static batten_status sample_path(const bat_plate *plate, int wanted, middle *m)
{
    const bat_pair last = plate->pairs[plate->count - 1];
    double whole = 0, passed = 0;
    for (int k = 0; k + 1 < plate->count; k++)
        whole += path_step(plate, plate->pairs[k], plate->pairs[k + 1]);
    m->pairs[0] = plate->pairs[0];
    m->count = 1;
    int k = 0;
    for (int i = 1; i + 1 < wanted; i++) {
        const double target = whole * i / (wanted - 1);
        double step = path_step(plate, plate->pairs[k], plate->pairs[k + 1]);
        while (k + 2 < plate->count && passed + step < target) {
            passed += step;
            k++;
            step = path_step(plate, plate->pairs[k], plate->pairs[k + 1]);
        }
        bat_pair found;
        const double f = step > 0 ? bat_min(1, (target - passed) / step) : 0;
        const batten_status status = polish(plate, k, f, &found);
        if (status != BATTEN_OK)
            return status;
        if (follows(m->pairs[m->count - 1], found) && follows(found, last))
            m->pairs[m->count++] = found;
    }
    m->pairs[m->count++] = last;
    return BATTEN_OK;
}

static batten_status check_touch(const bat_plate *plate, const bat_edge_place at[2],
                                 bat_pair pair)
{
    const bool is_end = (pair.x == 0 && pair.y == 0) || (pair.x == 1 && pair.y == 1);
    const double distance = bat_vec3_norm(bat_vec3_subtract(at[1].P, at[0].P));
    if (is_end || distance > 1e-9 * plate->size)
        return BATTEN_OK;
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "the edges touch at %g of the first and %g of the second", at[0].u,
                    at[1].u);
}

static batten_status place_samples(const bat_plate *plate, middle *m)
{
    for (int i = 0; i < m->count; i++) {
        bat_edge_place at[2];
        const double share[2] = {m->pairs[i].x, m->pairs[i].y};
        batten_status status = BATTEN_OK;
        for (int e = 0; e < 2 && status == BATTEN_OK; e++) {
            status = bat_plate_edge_at(&plate->edge[e], share[e], &at[e]);
            double *p = m->points[e] + 3 * i;
            p[0] = at[e].P.x;
            p[1] = at[e].P.y;
            p[2] = at[e].P.z;
            m->u[e][i] = at[e].u;
        }
        if (status == BATTEN_OK)
            status = check_touch(plate, at, m->pairs[i]);
        if (status != BATTEN_OK)
            return status;
        m->tau[i] = i == 0
                        ? 0
                        : m->tau[i - 1] +
                              bat_distance(3, m->points[0] + 3 * i - 3, m->points[0] + 3 * i) +
                              bat_distance(3, m->points[1] + 3 * i - 3, m->points[1] + 3 * i);
    }
    return BATTEN_OK;
}

/* ---- fitted edges ---- */

/* The distance of q from the curve near u. */
static batten_status distance_near(const batten_curve *curve, double u, const double *q,
                                   double *out)
{
    const batten_interval domain = batten_curve_domain(curve);
    double values[6];
    batten_status status = BATTEN_OK;
    for (int k = 0; k < PROJECTIONS && status == BATTEN_OK; k++) {
        status = batten_curve_evaluate(curve, u, 1, values);
        const double speed = bat_norm(3, values + 3);
        double along = 0;
        for (int c = 0; c < 3; c++)
            along += (q[c] - values[c]) * (values[3 + c] / speed);
        u = bat_min(domain.b, bat_max(domain.a, u + along / speed));
    }
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, u, 0, values);
    *out = bat_distance(3, values, q);
    return status;
}

static batten_status fit_edge(const bat_plate *plate, int e, middle *m)
{
    batten_interpolate_options options = batten_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = m->tau;
    batten_status status =
        batten_curve_interpolate(3, m->count, m->points[e], &options, NULL, &m->edge[e]);
    for (int i = 0; i + 1 < m->count && status == BATTEN_OK; i++) {
        double q[3], off = 0;
        status = batten_curve_evaluate(m->edge[e], (m->tau[i] + m->tau[i + 1]) / 2, 0, q);
        if (status == BATTEN_OK)
            status =
                distance_near(plate->edge[e].curve, (m->u[e][i] + m->u[e][i + 1]) / 2, q, &off);
        m->error = bat_max(m->error, off);
    }
    return status;
}

/* Do the rulings join equal shares of both domains? Then nothing needs to be fitted. */
static bool is_exact(const bat_plate *plate, const middle *m)
{
    const batten_interval a = batten_curve_domain(plate->edge[0].curve);
    const batten_interval b = batten_curve_domain(plate->edge[1].curve);
    for (int i = 0; i < m->count; i++)
        if (fabs((m->u[0][i] - a.a) / (a.b - a.a) - (m->u[1][i] - b.a) / (b.b - b.a)) > 1e-9)
            return false;
    return true;
}

static batten_status reserve(int count, middle *m)
{
    m->pairs = bat_array((size_t)count, sizeof *m->pairs);
    m->tau = bat_array((size_t)count, sizeof *m->tau);
    for (int e = 0; e < 2; e++) {
        m->points[e] = bat_array((size_t)count * 3, sizeof(double));
        m->u[e] = bat_array((size_t)count, sizeof(double));
    }
    const bool all = m->pairs && m->tau && m->points[0] && m->points[1] && m->u[0] && m->u[1];
    return all ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status make_middle(const bat_plate *plate, int samples, middle *m)
{
    release_middle(m);
    batten_status status = reserve(samples, m);
    if (status == BATTEN_OK)
        status = sample_path(plate, samples, m);
    if (status == BATTEN_OK)
        status = place_samples(plate, m);
    if (status != BATTEN_OK)
        return status;
    if (is_exact(plate, m))
        return batten_surface_ruled(plate->edge[0].curve, plate->edge[1].curve, &m->surface);
    for (int e = 0; e < 2 && status == BATTEN_OK; e++)
        status = fit_edge(plate, e, m);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(m->edge[0], m->edge[1], &m->surface);
    return status;
}

/* The warp of the rulings that were found, which the surface between them should not exceed. */
static batten_status found_warp(const bat_plate *plate, const middle *m, double *out)
{
    batten_status status = BATTEN_OK;
    *out = 0;
    for (int i = 0; i < m->count && status == BATTEN_OK; i++) {
        bool has;
        double sine, cosine;
        status = bat_plate_warp(plate, m->pairs[i], &has, &sine, &cosine);
        if (status == BATTEN_OK && has)
            *out = bat_max(*out, atan2(fabs(sine), cosine));
    }
    return status;
}

static batten_status refine_middle(const bat_plate *plate,
                                   const batten_developable_options *options, middle *m)
{
    for (int samples = FIRST_SAMPLES; samples <= MAX_SAMPLES; samples = 2 * samples - 1) {
        batten_developable seen = {0};
        double found = 0;
        batten_status status = make_middle(plate, samples, m);
        if (status == BATTEN_OK)
            status = found_warp(plate, m, &found);
        if (status != BATTEN_OK)
            return status;
        seen.surface = m->surface;
        status = bat_plate_measure(options, &seen);
        const bool is_fair = seen.warp <= found + 0.05 * options->warp;
        if (status != BATTEN_OK ||
            (m->error <= options->tolerance && (is_fair || samples == MAX_SAMPLES)))
            return status;
    }
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "the edges are within %g with %d rulings, not within %g", m->error,
                    m->count, options->tolerance);
}

/* ---- cones ---- */

/* A curve that rests in one point, with the degree, knots and weights of another: then rulings
 * between the two have an even parameter. */
static batten_status resting(const batten_curve *like, batten_vec3 at, batten_curve **out)
{
    const int count = batten_curve_point_count(like);
    double *points = bat_array((size_t)count * 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++) {
        points[3 * i] = at.x;
        points[3 * i + 1] = at.y;
        points[3 * i + 2] = at.z;
    }
    const batten_status status =
        batten_curve_create(3, batten_curve_degree(like), count, points,
                            batten_curve_weights(like), batten_curve_knots(like), out);
    bat_release(points);
    return status;
}

/* From pair a to b along a side of the square: one edge rests. */
static batten_status make_cone(const bat_plate *plate, bat_pair a, bat_pair b,
                               batten_surface **out, double *length)
{
    const int e = a.x == b.x ? 1 : 0; /* the edge that moves */
    const double from[2] = {a.x, a.y}, to[2] = {b.x, b.y};
    bat_edge_place start, end, apex;
    batten_curve *side[2] = {NULL, NULL};
    batten_status status = bat_plate_edge_at(&plate->edge[e], from[e], &start);
    if (status == BATTEN_OK)
        status = bat_plate_edge_at(&plate->edge[e], to[e], &end);
    if (status == BATTEN_OK)
        status = bat_plate_edge_at(&plate->edge[1 - e], from[1 - e], &apex);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(plate->edge[e].curve, start.u, end.u, &side[e]);
    if (status == BATTEN_OK)
        status = resting(side[e], apex.P, &side[1 - e]);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(side[0], side[1], out);
    *length = (to[e] - from[e]) * plate->edge[e].length;
    batten_curve_unref(side[0]);
    batten_curve_unref(side[1]);
    return status;
}

/* Set the domain of a part and join it to what is there; the part is given back. */
static batten_status add_part(batten_status status, double length, double tolerance,
                              batten_surface *part, batten_surface **whole)
{
    batten_surface *placed = NULL, *joined = NULL;
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(part, BATTEN_U, 0, length, &placed);
    if (status == BATTEN_OK && *whole)
        status = batten_surface_join(*whole, placed, BATTEN_U, tolerance, &joined);
    else if (status == BATTEN_OK)
        joined = batten_surface_ref(placed);
    if (status == BATTEN_OK) {
        batten_surface_unref(*whole);
        *whole = joined;
    }
    batten_surface_unref(placed);
    batten_surface_unref(part);
    return status;
}

/* ---- the whole ---- */

static batten_status put_ruling(const bat_plate *plate, bat_pair pair, double u,
                                batten_developable *out)
{
    batten_ruling *ruling = &out->rulings[out->count++];
    bat_edge_place a, b;
    double sine = 0, cosine = 1;
    batten_status status = bat_plate_edge_at(&plate->edge[0], pair.x, &a);
    if (status == BATTEN_OK)
        status = bat_plate_edge_at(&plate->edge[1], pair.y, &b);
    if (status != BATTEN_OK)
        return status;
    *ruling = (batten_ruling){.u = u, .s = a.u, .t = b.u};
    if (bat_warp_of(&a, &b, 1e-9 * plate->size, &sine, &cosine))
        ruling->warp = atan2(fabs(sine), cosine);
    return BATTEN_OK;
}

/* Rulings of a cone by equal shares of length; those at its ends belong to its neighbours or to
 * the outside. */
static batten_status put_cone_rulings(const bat_plate *plate, bat_pair a, bat_pair b, double u0,
                                      double u1, bool at_start, batten_developable *out)
{
    batten_status status = BATTEN_OK;
    for (int k = at_start ? 0 : 1; k < CONE_RULINGS + !at_start && status == BATTEN_OK; k++) {
        const double f = (double)k / CONE_RULINGS;
        const bat_pair pair = {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
        status = put_ruling(plate, pair, u0 + f * (u1 - u0), out);
        if (status == BATTEN_OK)
            out->rulings[out->count - 1].warp = 0;
    }
    return status;
}

static batten_status put_rulings(const bat_plate *plate, const middle *m, double before,
                                 double behind, batten_developable *out)
{
    const bat_pair start = {0, 0}, end = {1, 1};
    const double length = m->count > 1 ? m->tau[m->count - 1] : 0;
    const double whole = before + length + behind;
    out->rulings = bat_array((size_t)m->count + 2 * CONE_RULINGS, sizeof *out->rulings);
    if (!out->rulings)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    if (before > 0)
        status = put_cone_rulings(plate, start, m->pairs[0], 0, before / whole, true, out);
    for (int i = 0; i < m->count && status == BATTEN_OK; i++) {
        const batten_interval domain = batten_curve_domain(plate->edge[0].curve);
        /* Exact edges keep their parameter. */
        const double u = m->edge[0] || m->count == 1
                             ? (before + m->tau[i]) / whole
                             : (m->u[0][i] - domain.a) / (domain.b - domain.a);
        status = put_ruling(plate, m->pairs[i], u, out);
    }
    if (behind > 0 && status == BATTEN_OK)
        status = put_cone_rulings(plate, m->pairs[m->count - 1], end, (before + length) / whole,
                                  1, false, out);
    return status;
}

/* A path that is all cones meets in one ruling. */
static batten_status only_ruling(const bat_plate *plate, middle *m)
{
    batten_status status = reserve(1, m);
    if (status != BATTEN_OK)
        return status;
    m->count = 1;
    m->pairs[0] = plate->pairs[0];
    return place_samples(plate, m);
}

static batten_status join_parts(const bat_plate *plate, middle *m, batten_developable *out)
{
    const bat_pair first = plate->pairs[0], last = plate->pairs[plate->count - 1];
    const double tolerance = 1e-9 * plate->size;
    batten_surface *part = NULL, *whole = NULL;
    double before = 0, behind = 0;
    out->cone[0] = first.x > 0 || first.y > 0;
    out->cone[1] = last.x < 1 || last.y < 1;
    batten_status status = BATTEN_OK;
    if (out->cone[0]) {
        status = make_cone(plate, (bat_pair){0, 0}, first, &part, &before);
        status = add_part(status, before, tolerance, part, &whole);
    }
    if (m->surface && status == BATTEN_OK)
        status = add_part(status, m->tau[m->count - 1], tolerance,
                          batten_surface_ref(m->surface), &whole);
    if (out->cone[1] && status == BATTEN_OK) {
        part = NULL;
        status = make_cone(plate, last, (bat_pair){1, 1}, &part, &behind);
        status = add_part(status, behind, tolerance, part, &whole);
    }
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(whole, BATTEN_U, 0, 1, &out->surface);
    if (status == BATTEN_OK)
        status = put_rulings(plate, m, before, behind, out);
    batten_surface_unref(whole);
    return status;
}

batten_status bat_plate_surface(const bat_plate *plate,
                                const batten_developable_options *options,
                                batten_developable *out)
{
    middle m = {0};
    batten_status status =
        plate->count > 1 ? refine_middle(plate, options, &m) : only_ruling(plate, &m);
    if (status == BATTEN_OK)
        status = join_parts(plate, &m, out);
    out->error = m.error;
    release_middle(&m);
    return status;
}
