/*
 * The motion of a section between two rails: pairs of points on both, the frame across the chord,
 * and its scale.
 */
#include "shape/sweep/motion_rails.h"
#include "base/sort.h"
#include "numeric/jet3.h"
#include "numeric/rounding.h"
#include "shape/sweep/rail_heights.h"
#include <batten/nearest.h>

#include <string.h>

enum { SAMPLES = 64 };

/* ---- the pose ---- */

/* The direction from rail to rail and how far it is, with derivatives; d [5][3]. Where the
 * rails meet, both come from D = (v - end) E. */
static void find_chord(const bat_between *m, double v, const double *d, bat_jet3 *chord,
                       bat_jet *length)
{
    const double distance = bat_norm(3, d);
    const bool meet = (v == 0 || v == 1) && distance <= m->tolerance;
    double e[12];
    for (int k = 0; k < 4; k++)
        for (int c = 0; c < 3; c++)
            e[3 * k + c] = meet ? d[3 * (k + 1) + c] / (k + 1) : d[3 * k + c];
    const double unit = bat_norm(3, e); /* squares must not overflow */
    for (int i = 0; i < 12; i++)
        e[i] /= unit;
    const double sign = meet && v == 1 ? -1 : 1;
    const bat_jet3 along = bat_jet3_of_v(3, e);
    const bat_jet norm = bat_jet3_norm(along);
    *chord = bat_jet3_multiply(bat_jet_divide(bat_jet_constant(sign), norm), along);
    *length = bat_jet_scale(unit, norm);
    if (meet)
        *length = bat_jet_multiply(bat_jet_scale(sign, bat_jet_v(0)), *length);
}

/* Square to the chord: Z x chord, with Z the mean of the tangents. */
static batten_status find_rise(const double (*rails)[15], const bat_jet3 *chord, double v,
                               bat_jet3 *rise)
{
    bat_jet3 mean[2];
    for (int k = 0; k < 2; k++) {
        const double speed = bat_norm(3, rails[k] + 3);
        double slope[12];
        if (!(speed > 0))
            return bat_fail(BATTEN_SINGULAR_HERE, "rail %d has no tangent at %g of its length",
                            k + 1, v);
        for (int i = 0; i < 12; i++)
            slope[i] = rails[k][3 + i] / speed;
        mean[k] = bat_jet3_unit(bat_jet3_of_v(3, slope));
    }
    const bat_jet3 sum = bat_jet3_add(mean[0], mean[1]);
    const bat_jet3 square = bat_jet3_cross(sum, *chord);
    if (!(bat_vec3_norm(bat_jet3_in_v(&square, 0)) > BAT_LEAST_SINE))
        return bat_fail(
            BATTEN_SINGULAR_HERE,
            "at %g of their length the rails have no mean tangent across their chord", v);
    *rise = bat_jet3_unit(square);
    return BATTEN_OK;
}

static void put_column(const bat_jet3 *a, int column, bat_pose *out)
{
    for (int k = 0; k <= BAT_POSE_ORDER; k++) {
        const batten_vec3 at = bat_jet3_in_v(a, k);
        memcpy(out->d[k][column], (double[3]){at.x, at.y, at.z}, sizeof out->d[k][column]);
    }
}

static batten_status between_pose(const bat_motion *motion, double v, batten_side side,
                                  bat_pose *out)
{
    const bat_between *m = (const bat_between *)(const void *)motion;
    double rails[2][15], d[15];
    batten_status status = bat_rail_look(m, 0, v, side, rails[0]);
    if (status == BATTEN_OK)
        status = bat_rail_look(m, 1, v, side, rails[1]);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < 15; i++)
        d[i] = rails[1][i] - rails[0][i];
    if (!(bat_norm(3, d) + bat_norm(3, d + 3) > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the rails meet at %g of their length", v);
    bat_jet3 chord, rise;
    bat_jet length;
    find_chord(m, v, d, &chord, &length);
    status = find_rise((const double(*)[15])rails, &chord, v, &rise);
    if (status != BATTEN_OK)
        return status;
    const bat_jet height = m->height > 0 ? bat_jet_constant(m->height) : length;
    const bat_jet3 along = bat_jet3_cross(chord, rise);
    *out = (bat_pose){.share = {v, 1}};
    const bat_jet3 x = bat_jet3_of_v(3, d), y = bat_jet3_multiply(height, rise),
                   z = bat_jet3_multiply(height, along), o = bat_jet3_of_v(3, rails[0]);
    put_column(&x, BAT_POSE_X, out);
    put_column(&y, BAT_POSE_Y, out);
    put_column(&z, BAT_POSE_Z, out);
    put_column(&o, BAT_POSE_ORIGIN, out);
    return BATTEN_OK;
}

static void between_free(bat_motion *motion)
{
    bat_between *m = (bat_between *)(void *)motion;
    batten_curve_unref(m->rails[0]);
    batten_curve_unref(m->rails[1]);
    bat_release(m);
}

/* ---- building ---- */

/* Both rails rise all along, over the same heights. */
static batten_status check_heights(bat_between *m)
{
    double ends[2][2];
    for (int k = 0; k < 2; k++) {
        const batten_interval domain = batten_curve_domain(m->rails[k]);
        batten_parameters turns = {0, NULL};
        batten_status status = bat_rail_height(m, k, domain.a, &ends[k][0]);
        if (status == BATTEN_OK)
            status = bat_rail_height(m, k, domain.b, &ends[k][1]);
        if (status == BATTEN_OK)
            status = batten_curve_turns(m->rails[k], m->across, &turns);
        if (status != BATTEN_OK)
            return status;
        const int count = turns.count;
        const double at = count ? turns.at[0] : 0;
        batten_release(turns.at);
        if (count > 0)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "rail %d turns back across the planes, at %g of its parameters",
                            k + 1, at);
        if (!(ends[k][1] - ends[k][0] > m->tolerance))
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "rail %d goes from height %g to %g: it must rise across the planes",
                            k + 1, ends[k][0], ends[k][1]);
    }
    for (int i = 0; i < 2; i++)
        if (fabs(ends[0][i] - ends[1][i]) > m->tolerance)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "the rails %s at heights %g and %g: there is no plane with both",
                            i ? "end" : "begin", ends[0][i], ends[1][i]);
    m->heights[0] = ends[0][0];
    m->heights[1] = ends[0][1];
    return BATTEN_OK;
}

static batten_status check_length(const bat_between *m, int rail)
{
    const double *points = batten_curve_points(m->rails[rail]);
    const int count = batten_curve_point_count(m->rails[rail]);
    double longest = 0;
    for (int i = 1; i < count; i++)
        longest = bat_max(longest, bat_distance(3, points, points + 3 * i));
    if (!(longest > m->tolerance))
        return bat_fail(BATTEN_COINCIDENT,
                        "rail %d reaches %g, no more than the tolerance of %g", rail + 1,
                        longest, m->tolerance);
    return BATTEN_OK;
}

/* From rail to rail at v. */
static batten_status gap_at(const bat_between *m, double v, batten_vec3 *gap)
{
    double rails[2][15];
    batten_status status = bat_rail_look(m, 0, v, BATTEN_FROM_RIGHT, rails[0]);
    if (status == BATTEN_OK)
        status = bat_rail_look(m, 1, v, BATTEN_FROM_RIGHT, rails[1]);
    *gap = bat_vec3_subtract(bat_vec3_of(3, rails[1]), bat_vec3_of(3, rails[0]));
    return status;
}

/* The least distance of the rails between a and b, by golden sections. */
static batten_status least_gap(const bat_between *m, double a, double b, double *at,
                               double *least)
{
    const double golden = (sqrt(5) - 1) / 2;
    batten_vec3 gap;
    batten_status status = BATTEN_OK;
    double u = b - golden * (b - a), v = a + golden * (b - a), fu = 0, fv = 0;
    status = gap_at(m, u, &gap);
    fu = bat_vec3_norm(gap);
    if (status == BATTEN_OK)
        status = gap_at(m, v, &gap);
    fv = bat_vec3_norm(gap);
    for (int i = 0; status == BATTEN_OK && i < 60; i++) {
        if (fu <= fv) {
            b = v;
            v = u;
            fv = fu;
            u = b - golden * (b - a);
            status = gap_at(m, u, &gap);
            fu = bat_vec3_norm(gap);
        } else {
            a = u;
            u = v;
            fu = fv;
            v = a + golden * (b - a);
            status = gap_at(m, v, &gap);
            fv = bat_vec3_norm(gap);
        }
    }
    *at = fu <= fv ? u : v;
    *least = bat_min(fu, fv);
    return status;
}

/* Are the rails apart anywhere? */
static batten_status check_apart(const bat_between *m)
{
    const bat_motion *base = &m->base;
    double widest = 0;
    for (int i = 0; i <= (base->break_count - 1) * SAMPLES; i++) {
        const int k = bat_min_int(i / SAMPLES, base->break_count - 2);
        const double t = (double)(i - k * SAMPLES) / SAMPLES;
        batten_vec3 gap;
        const batten_status status =
            gap_at(m, (1 - t) * base->breaks[k] + t * base->breaks[k + 1], &gap);
        widest = bat_max(widest, bat_vec3_norm(gap));
        if (status != BATTEN_OK || widest > m->tolerance)
            return status;
    }
    return bat_fail(BATTEN_COINCIDENT,
                    "the rails coincide: they are nowhere farther apart than %g", widest);
}

/* Rails may meet at their ends alone. */
static batten_status check_meeting(const bat_between *m)
{
    const bat_motion *base = &m->base;
    const int count = (base->break_count - 1) * SAMPLES;
    double size[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, places[3] = {0, 0, 0};
    for (int i = 0; i <= count; i++) {
        const int k = bat_min_int(i / SAMPLES, base->break_count - 2);
        const double t = (double)(i - k * SAMPLES) / SAMPLES;
        const double v = (1 - t) * base->breaks[k] + t * base->breaks[k + 1];
        batten_vec3 gap;
        batten_status status = gap_at(m, v, &gap);
        if (status != BATTEN_OK)
            return status;
        memmove(size, size + 1, 2 * sizeof *size);
        memmove(places, places + 1, 2 * sizeof *places);
        size[2] = bat_vec3_norm(gap);
        places[2] = v;
        if (i < 2 || !(size[1] <= size[0] && size[1] <= size[2]))
            continue;
        double at, least;
        status = least_gap(m, places[0], places[2], &at, &least);
        if (status == BATTEN_OK && least <= m->tolerance)
            status = bat_fail(
                BATTEN_NOT_COMPATIBLE,
                "the rails cross or meet at %g of their length, where they are %g apart", at,
                least);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* The knots of both rails, as shares of the way. */
static batten_status lay_breaks(bat_between *m)
{
    const size_t total = (size_t)batten_curve_spans(m->rails[0], NULL) +
                         (size_t)batten_curve_spans(m->rails[1], NULL);
    double *breaks = m->base.breaks = bat_array(total, sizeof *breaks);
    m->base.smoothness = bat_array(total, sizeof *m->base.smoothness);
    if (!breaks || !m->base.smoothness)
        return BATTEN_OUT_OF_MEMORY;
    size_t count = 0;
    for (int k = 0; k < 2; k++) {
        const batten_interval domain = batten_curve_domain(m->rails[k]);
        const int own = batten_curve_spans(m->rails[k], breaks + count);
        for (int i = 0; i < own; i++, count++) {
            double height = 0;
            const batten_status status = bat_rail_height(m, k, breaks[count], &height);
            if (status != BATTEN_OK)
                return status;
            breaks[count] = m->by_planes
                                ? (height - m->heights[0]) / (m->heights[1] - m->heights[0])
                                : (breaks[count] - domain.a) / (domain.b - domain.a);
        }
    }
    bat_sort_doubles(count, breaks);
    int kept = 0;
    for (size_t i = 0; i < count; i++)
        if (i == 0 || breaks[i] - breaks[kept - 1] > BAT_MEANT_SAME)
            breaks[kept++] = breaks[i];
    breaks[0] = 0;
    breaks[kept - 1] = 1;
    m->base.break_count = kept;
    return BATTEN_OK;
}

static batten_status build_motion(bat_between *m, const bat_rails *rails)
{
    for (int k = 0; k < 2; k++) {
        m->rails[k] = batten_curve_ref(rails->rails[k]);
        m->base.size =
            bat_max(m->base.size, bat_largest(3 * batten_curve_point_count(m->rails[k]),
                                              batten_curve_points(m->rails[k])));
    }
    m->across = rails->across;
    m->by_planes = bat_vec3_norm(rails->across) > 0;
    m->height = rails->height;
    m->tolerance = bat_max(rails->tolerance, BAT_ROUNDING * m->base.size);
    batten_status status = check_length(m, 0);
    if (status == BATTEN_OK)
        status = check_length(m, 1);
    if (status == BATTEN_OK && m->by_planes)
        status = check_heights(m);
    if (status == BATTEN_OK)
        status = lay_breaks(m);
    if (status == BATTEN_OK)
        status = check_apart(m);
    if (status == BATTEN_OK)
        status = check_meeting(m);
    if (status == BATTEN_OK)
        status = bat_motion_find_smoothness(&m->base);
    return status;
}

batten_status bat_motion_between(const bat_rails *rails, bat_motion **out)
{
    bat_between *m = bat_array(1, sizeof *m);
    if (!m)
        return BATTEN_OUT_OF_MEMORY;
    m->base.pose = between_pose;
    m->base.free = between_free;
    const batten_status status = build_motion(m, rails);
    if (status == BATTEN_OK)
        *out = &m->base;
    else
        bat_motion_free(&m->base);
    return status;
}
