/* The rulings of a developable surface in order: places on both edges, added where they are needed. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/developable_parts.h"
#include <batten/interpolate.h>
#include <batten/skin.h>

enum {
    FIRST_SAMPLES = 17,
    MAX_SAMPLES = 1025,
    CONE_RULINGS = 8,
    PROJECTIONS = 6,
    ROUGH_PASSES = 100
};

void bat_middle_release(bat_middle *m)
{
    for (int e = 0; e < 2; e++) {
        bat_release(m->points[e]);
        bat_release(m->u[e]);
        batten_curve_unref(m->edge[e]);
    }
    bat_release(m->pairs);
    bat_release(m->tau);
    batten_surface_unref(m->surface);
    *m = (bat_middle){0};
}

/* ---- rulings along the path ---- */

static double path_step(const bat_plate *plate, bat_pair a, bat_pair b)
{
    return bat_hypot((b.x - a.x) * plate->edge[0].length, (b.y - a.y) * plate->edge[1].length);
}

/* Where the warp is 0 beside the point of the path that is the share f of its step k. */
static batten_status polish_pair(const bat_plate *plate, int k, double f, bat_pair *out)
{
    const bat_pair *a = &plate->pairs[k], *b = a + 1;
    const double reach = 2.0 / BAT_EDGE_STEPS, length = bat_hypot(b->x - a->x, b->y - a->y);
    const bat_pair across = {-(b->y - a->y) / length, (b->x - a->x) / length};
    bool found;
    *out = (bat_pair){a->x + f * (b->x - a->x), a->y + f * (b->y - a->y)};
    if (plate->rough || !(length > 0))
        return BATTEN_OK;
    return bat_plate_root(plate, &(bat_pair_line){*out, across},
                          (batten_interval){-reach, reach}, &found, out);
}

static bool follows(bat_pair a, bat_pair b)
{
    return b.x >= a.x && b.y >= a.y && (b.x > a.x || b.y > a.y);
}

/* At `wanted` equal steps of the path; those that would run back are left out. */
static batten_status sample_path(const bat_plate *plate, int wanted, bat_middle *m)
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
        const batten_status status = polish_pair(plate, k, f, &found);
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
    if (is_end || distance > BAT_MEANT_SAME * plate->size)
        return BATTEN_OK;
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "the edges touch at %g of the first and %g of the second", at[0].u,
                    at[1].u);
}

batten_status bat_middle_place(const bat_plate *plate, bat_middle *m)
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

/* How fast the share of edge e grows at pair i: the harmonic mean of what it does on both
 * sides, so that the edge never runs back, also where it rests on one. */
static double share_rate(const bat_middle *m, int e, int i)
{
    double slope[2];
    for (int side = 0; side < 2; side++) {
        const int k = bat_max_int(0, bat_min_int(i - 1 + side, m->count - 2));
        const bat_pair a = m->pairs[k], b = m->pairs[k + 1];
        slope[side] = (e ? b.y - a.y : b.x - a.x) / (m->tau[k + 1] - m->tau[k]);
    }
    return slope[0] > 0 && slope[1] > 0 ? 2 * slope[0] * slope[1] / (slope[0] + slope[1]) : 0;
}

/* The point of edge e in pair i, and its derivative by tau. */
static batten_status edge_row(const bat_plate *plate, const bat_middle *m, int e, int i,
                              double row[6])
{
    bat_edge_place at;
    const batten_status status =
        bat_plate_edge_at(&plate->edge[e], e ? m->pairs[i].y : m->pairs[i].x, &at);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 D = bat_vec3_scale(at.T, plate->edge[e].length * share_rate(m, e, i));
    memcpy(row, (const double[]){at.P.x, at.P.y, at.P.z, D.x, D.y, D.z}, 6 * sizeof *row);
    return BATTEN_OK;
}

/* The edge with the tangents of the given one: C1, for paths that turn sharply. */
static batten_status fit_tangents(const bat_plate *plate, int e, bat_middle *m)
{
    double *values = bat_array((size_t)m->count * 6, sizeof *values);
    batten_status status = values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < m->count && status == BATTEN_OK; i++) {
        status = edge_row(plate, m, e, i, values + 6 * i);
    }
    if (status == BATTEN_OK)
        status = batten_curve_from_hermite(3, m->count, 2, m->tau, values, &m->edge[e]);
    bat_release(values);
    return status;
}

static batten_status fit_points(int e, bat_middle *m)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = m->tau;
    return batten_curve_interpolate((batten_points){3, m->count, m->points[e]}, &options, NULL,
                                    &m->edge[e]);
}

static batten_status fit_edge(const bat_plate *plate, int e, bat_middle *m)
{
    batten_status status = plate->rough ? fit_tangents(plate, e, m) : fit_points(e, m);
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
static bool is_exact(const bat_plate *plate, const bat_middle *m)
{
    const batten_interval a = batten_curve_domain(plate->edge[0].curve);
    const batten_interval b = batten_curve_domain(plate->edge[1].curve);
    for (int i = 0; i < m->count; i++)
        if (fabs((m->u[0][i] - a.a) / (a.b - a.a) - (m->u[1][i] - b.a) / (b.b - b.a)) >
            BAT_MEANT_SAME)
            return false;
    return true;
}

batten_status bat_middle_reserve(int count, bat_middle *m)
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

static batten_status make_middle(const bat_plate *plate, int samples, bat_middle *m)
{
    bat_middle_release(m);
    batten_status status = bat_middle_reserve(samples, m);
    if (status == BATTEN_OK)
        status = sample_path(plate, samples, m);
    if (status == BATTEN_OK)
        status = bat_middle_place(plate, m);
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
static batten_status found_warp(const bat_plate *plate, const bat_middle *m, double *out)
{
    batten_status status = BATTEN_OK;
    *out = 0;
    for (int i = 0; i < m->count && status == BATTEN_OK; i++) {
        bool has;
        double sine, cosine;
        status = bat_plate_warp(plate, m->pairs[i], &has, &sine, &cosine);
        if (status == BATTEN_OK && has)
            *out = bat_max(*out, bat_atan2(fabs(sine), cosine));
    }
    return status;
}

batten_status bat_middle_make(const bat_plate *plate,
                              const batten_surface_developable_options *options, bat_middle *m)
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
        const bool is_fair = seen.warp <= found + 0.05 * options->warp && !seen.has_regression;
        if (status != BATTEN_OK ||
            (m->error <= options->tolerance && (is_fair || plate->rough)))
            return status;
    }
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "the edges are within %g with %d rulings, not within %g, or warped more "
                    "between them than at them",
                    m->error, m->count, options->tolerance);
}
