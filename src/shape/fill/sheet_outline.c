/* The plane of a hole, and its sides in it. */
#include "inspect/nearest/self_crossings.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/fill/sheet.h"
#include "spline/curve/curve.h"
#include <string.h>

/* Points of the outline for each span of a side. */
enum { RING_PLACES = 24 };

batten_affine bat_sheet_to_frame(const bat_sheet_outline *outline)
{
    batten_affine map = batten_affine_identity();
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++)
            map.m[r][c] = outline->axes[r][c] / outline->size;
        map.t[r] = -bat_dot(3, outline->axes[r], outline->centre) / outline->size;
    }
    return map;
}

batten_affine bat_sheet_from_frame(const bat_sheet_outline *outline)
{
    batten_affine map = batten_affine_identity();
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++)
            map.m[r][c] = outline->axes[c][r] * outline->size;
        map.t[r] = outline->centre[r];
    }
    return map;
}

void bat_sheet_outline_free(bat_sheet_outline *outline)
{
    for (int i = 0; i < BATTEN_SHEET_SIDES; i++) {
        batten_curve_unref(outline->sides[i].curve);
        batten_curve_unref(outline->sides[i].slope);
        batten_curve_unref(outline->sides[i].bend);
        batten_curve_unref(outline->plane[i]);
    }
    bat_release(outline->ring);
    *outline = (bat_sheet_outline){0};
}

bool bat_sheet_is_inside(const bat_sheet_outline *outline, const double at[2])
{
    bool inside = false;
    const double *a = outline->ring + 2 * ((size_t)outline->ring_count - 1);
    for (int i = 0; i < outline->ring_count; i++) {
        const double *b = outline->ring + 2 * (size_t)i;
        if ((a[1] > at[1]) != (b[1] > at[1]) &&
            at[0] < a[0] + (b[0] - a[0]) * ((at[1] - a[1]) / (b[1] - a[1])))
            inside = !inside;
        a = b;
    }
    return inside;
}

/* ---- samples round the loop ---- */

/* RING_PLACES points of each span, round the loop, without the last: out [*count][dimension]. */
static batten_status sample_loop(int count, const batten_curve *const *curves,
                                 const bool *reversed, double **out, int *point_count)
{
    int spans = 0, most = 0;
    const size_t d = (size_t)batten_curve_dimension(curves[0]);
    for (int i = 0; i < count; i++) {
        const int own = batten_curve_spans(curves[i], NULL) - 1;
        spans += own;
        most = bat_max_int(most, own);
    }
    double *knots = bat_array((size_t)most + 1, sizeof *knots);
    *out = bat_array3((size_t)spans, RING_PLACES, d * sizeof **out);
    *point_count = 0;
    batten_status status = knots && *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const int own = batten_curve_spans(curves[i], knots) - 1;
        for (int k = 0; status == BATTEN_OK && k < own * RING_PLACES; k++) {
            const int s = k / RING_PLACES, from = reversed[i] ? own - s : s;
            const int to = reversed[i] ? from - 1 : from + 1;
            const double part = (double)(k % RING_PLACES) / RING_PLACES;
            status =
                batten_curve_evaluate(curves[i], (1 - part) * knots[from] + part * knots[to], 0,
                                      *out + d * (size_t)(*point_count)++);
        }
    }
    bat_release(knots);
    return status;
}

/* ---- the frame ---- */

static void centre_of(int count, const double *points, bat_sheet_outline *out)
{
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++) {
            low[c] = bat_min(low[c], points[3 * i + c]);
            high[c] = bat_max(high[c], points[3 * i + c]);
        }
    for (int c = 0; c < 3; c++) {
        out->centre[c] = low[c] / 2 + high[c] / 2;
        out->size = bat_max(out->size, high[c] / 2 - low[c] / 2);
    }
}

/* Twice the area that the loop goes around, over the square of its size. */
static batten_vec3 area_vector(int count, const double *points, const bat_sheet_outline *frame)
{
    batten_vec3 sum = {0, 0, 0};
    const batten_vec3 o = bat_vec3_of(3, frame->centre);
    for (int i = 0; i < count; i++) {
        const double *b = points + 3 * (size_t)((i + 1) % count);
        const batten_vec3 p = bat_vec3_of(3, points + 3 * (size_t)i), q = bat_vec3_of(3, b);
        const batten_vec3 a = bat_vec3_scale(bat_vec3_subtract(p, o), 1 / frame->size);
        sum = bat_vec3_add(
            sum, bat_vec3_cross(a, bat_vec3_scale(bat_vec3_subtract(q, o), 1 / frame->size)));
    }
    return sum;
}

static void set_axis(double axis[3], batten_vec3 v)
{
    const double size = bat_vec3_norm(v);
    axis[0] = v.x / size;
    axis[1] = v.y / size;
    axis[2] = v.z / size;
}

/* The chord of the side that is the longest over the plane. */
static batten_vec3 longest_chord(int count, const batten_curve *const *curves,
                                 const double normal[3])
{
    const batten_vec3 n = bat_vec3_of(3, normal);
    batten_vec3 longest = {0, 0, 0};
    for (int i = 0; i < count; i++) {
        const batten_interval domain = batten_curve_domain(curves[i]);
        double a[3], b[3];
        if (batten_curve_evaluate(curves[i], domain.a, 0, a) != BATTEN_OK ||
            batten_curve_evaluate(curves[i], domain.b, 0, b) != BATTEN_OK)
            continue;
        const batten_vec3 chord = bat_vec3_subtract(bat_vec3_of(3, b), bat_vec3_of(3, a));
        const batten_vec3 flat =
            bat_vec3_subtract(chord, bat_vec3_scale(n, bat_vec3_dot(chord, n)));
        if (bat_vec3_norm(flat) > bat_vec3_norm(longest))
            longest = flat;
    }
    return longest;
}

/* A loop that goes around less than this part of the square of its size lies in no plane. */
static const double least_area = 1e-3;

static batten_status find_plane(int count, const batten_curve *const *curves,
                                bat_sheet_outline *out)
{
    double *points = NULL;
    int n = 0;
    batten_status status = sample_loop(count, curves, out->reversed, &points, &n);
    if (status == BATTEN_OK) {
        centre_of(n, points, out);
        if (!(out->size > 0))
            status = bat_fail(BATTEN_COINCIDENT, "all sides of the hole are one point");
    }
    if (status == BATTEN_OK) {
        const batten_vec3 area = area_vector(n, points, out);
        if (!(bat_vec3_norm(area) > least_area))
            status = bat_fail(BATTEN_NOT_COMPATIBLE,
                              "the sides go around no area: a sheet needs a hole that can be "
                              "seen from one side");
        else
            set_axis(out->axes[2], area);
    }
    if (status == BATTEN_OK) {
        set_axis(out->axes[0], longest_chord(count, curves, out->axes[2]));
        set_axis(out->axes[1],
                 bat_vec3_cross(bat_vec3_of(3, out->axes[2]), bat_vec3_of(3, out->axes[0])));
    }
    bat_release(points);
    return status;
}

/* ---- the sides in the frame ---- */

/* x and y of a curve. */
static batten_status flatten(const batten_curve *curve, batten_curve **out)
{
    const int n = batten_curve_point_count(curve);
    const double *points = batten_curve_points(curve);
    double *flat = bat_array((size_t)n, 2 * sizeof *flat);
    if (!flat)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++)
        memcpy(flat + 2 * (size_t)i, points + 3 * (size_t)i, 2 * sizeof *flat);
    const batten_status status =
        batten_curve_create((batten_points){2, n, flat}, batten_curve_degree(curve),
                            batten_curve_weights(curve), batten_curve_knots(curve), out);
    bat_release(flat);
    return status;
}

static batten_status take_side(const batten_ribbon *given, const bat_sheet_outline *outline,
                               bat_fill_side *out)
{
    const batten_affine map = bat_sheet_to_frame(outline);
    batten_affine linear = map;
    batten_curve *made = NULL;
    memset(linear.t, 0, sizeof linear.t);
    batten_status status = batten_curve_transform(given->curve, &map, &out->curve);
    if (status == BATTEN_OK)
        status = bat_curve_replace(batten_curve_clamp(out->curve, &made), &out->curve, &made);
    if (status == BATTEN_OK && given->slope)
        status = batten_curve_transform(given->slope, &linear, &out->slope);
    if (status == BATTEN_OK && given->slope && given->curvature)
        status = batten_curve_transform(given->curvature, &linear, &out->bend);
    return status;
}

/* Ends meet halfway. */
static batten_status close_corner(bat_sheet_outline *outline, int before)
{
    const int sides[2] = {before, (before + 1) % outline->count};
    double mean[3] = {0, 0, 0};
    int at[2];
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2; k++) {
        const batten_curve *curve = outline->sides[sides[k]].curve;
        at[k] =
            (k == 0) != outline->reversed[sides[k]] ? batten_curve_point_count(curve) - 1 : 0;
        for (int c = 0; c < 3; c++)
            mean[c] += batten_curve_points(curve)[3 * at[k] + c] / 2;
    }
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        batten_curve *made = NULL, **curve = &outline->sides[sides[k]].curve;
        status = bat_curve_replace(batten_curve_with_point(*curve, at[k], mean, &made), curve,
                                   &made);
    }
    return status;
}

static void find_box(bat_sheet_outline *outline)
{
    for (int c = 0; c < 2; c++) {
        outline->low[c] = HUGE_VAL;
        outline->high[c] = -HUGE_VAL;
    }
    for (int i = 0; i < outline->count; i++)
        for (int k = 0; k < 2 * batten_curve_point_count(outline->plane[i]); k++) {
            const double value = batten_curve_points(outline->plane[i])[k];
            outline->low[k % 2] = bat_min(outline->low[k % 2], value);
            outline->high[k % 2] = bat_max(outline->high[k % 2], value);
        }
}

/* ---- is it an outline? ---- */

static batten_status check_crossings(const bat_sheet_outline *outline)
{
    const int n = outline->count;
    batten_curve *round[BATTEN_SHEET_SIDES] = {NULL};
    bat_crossings crossings = {0, 0, NULL};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        if (outline->reversed[i])
            status = batten_curve_reverse(outline->plane[i], &round[i]);
        else
            round[i] = batten_curve_ref(outline->plane[i]);
    }
    if (status == BATTEN_OK)
        status = bat_crossings_find(n, (const batten_curve *const *)round, true, &crossings);
    if (status == BATTEN_OK && crossings.count > 0) {
        const bat_crossing *c = &crossings.at[0];
        status = bat_fail(BATTEN_NOT_COMPATIBLE,
                          "seen along the mean normal of the hole, (%g, %g, %g), curves %d and "
                          "%d cross: a sheet over this plane would fold; divide the hole",
                          outline->axes[2][0], outline->axes[2][1], outline->axes[2][2],
                          outline->sides[c->curve[0]].given + 1,
                          outline->sides[c->curve[1]].given + 1);
    }
    bat_release(crossings.at);
    for (int i = 0; i < n; i++)
        batten_curve_unref(round[i]);
    return status;
}

batten_status bat_sheet_outline_make(int count, const batten_ribbon *sides, double tolerance,
                                     double *loop_gap, bat_sheet_outline *out)
{
    const batten_curve *curves[BATTEN_SHEET_SIDES] = {NULL},
                       *ordered[BATTEN_SHEET_SIDES] = {NULL};
    batten_loop_place places[BATTEN_SHEET_SIDES];
    for (int i = 0; i < count; i++)
        curves[i] = sides[i].curve;
    batten_status status = batten_curves_loop(count, curves, tolerance, places);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        ordered[i] = curves[places[i].curve];
        out->reversed[i] = places[i].reversed;
        out->sides[i].given = places[i].curve;
        *loop_gap = bat_max(*loop_gap, places[i].gap);
    }
    if (status == BATTEN_OK)
        status = find_plane(count, ordered, out);
    out->count = count;
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = take_side(&sides[places[i].curve], out, &out->sides[i]);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = close_corner(out, i);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = flatten(out->sides[i].curve, &out->plane[i]);
    if (status != BATTEN_OK)
        return status;
    find_box(out);
    status = check_crossings(out);
    if (status == BATTEN_OK)
        status = sample_loop(count, (const batten_curve *const *)out->plane, out->reversed,
                             &out->ring, &out->ring_count);
    return status;
}
