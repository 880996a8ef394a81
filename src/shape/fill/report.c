/* What a fill reached: gaps, angles, differences of curvature along all edges. */
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include <batten/measure.h>

#include <string.h>

enum { PLACES = 16 };

batten_status bat_fill_lack(const bat_fill_loop *loop, int side, int half,
                            const batten_surface *patch, double t, double out[3])
{
    bat_fill_view s, r;
    memset(out, 0, 3 * sizeof *out);
    batten_status status =
        bat_fill_see_surface(patch, half == 0 ? t : 0, half == 0 ? 0 : t, &s);
    if (status == BATTEN_OK)
        status = bat_fill_see_ribbon(&loop->sides[side], half == 0 ? t : 2 - t,
                                     half == 0 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &r);
    if (status != BATTEN_OK || !s.regular || !r.regular || !r.bent)
        return status;
    const double *along = half == 0 ? s.u : s.v, *D = half == 0 ? s.v : s.u;
    batten_vec3 across = bat_vec3_cross(bat_vec3_of(3, s.normal), bat_vec3_of(3, along));
    across = bat_vec3_scale(across, 1 / bat_vec3_norm(across));
    const double direction[3] = {across.x, across.y, across.z};
    /* Both have the side and its planes in common, so they differ in S_vv alone. */
    const double reach = bat_dot(3, D, direction);
    const double lack = reach * reach *
                        (bat_fill_curvature(&r, direction, s.normal) -
                         bat_fill_curvature(&s, direction, s.normal));
    for (int c = 0; c < 3; c++)
        out[c] = lack * s.normal[c];
    return BATTEN_OK;
}

/* The parameters in [0, 1] where an edge is looked at: PLACES + 1 in each span. */
static batten_status places_of(const batten_surface *surface, batten_direction direction,
                               double **out, int *count)
{
    const int spans = batten_surface_spans(surface, direction, NULL) - 1;
    double *knots = bat_array((size_t)spans + 1, sizeof *knots);
    *out = bat_array((size_t)spans * PLACES + 1, sizeof **out);
    *count = 0;
    if (knots && *out) {
        batten_surface_spans(surface, direction, knots);
        for (int k = 0; k < spans; k++)
            for (int j = 0; j < PLACES; j++)
                (*out)[(*count)++] = knots[k] + j * (knots[k + 1] - knots[k]) / PLACES;
        (*out)[(*count)++] = knots[spans];
    }
    const bool good = knots && *out;
    bat_release(knots);
    return good ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* Half of side i: that of quad i, or of the next one where the side is its u = 0. */
static batten_status measure_half(const bat_fill_loop *loop, int i, int half,
                                  const batten_surface *patch, batten_fill_edge *edge)
{
    double *places = NULL;
    int count = 0;
    batten_status status = places_of(patch, half == 0 ? BATTEN_U : BATTEN_V, &places, &count);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        bat_fill_view s, r;
        const double t = places[k];
        status = bat_fill_see_surface(patch, half == 0 ? t : 0, half == 0 ? 0 : t, &s);
        if (status == BATTEN_OK)
            status = bat_fill_see_ribbon(&loop->sides[i], half == 0 ? t : 2 - t,
                                         half == 0 ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &r);
        if (status == BATTEN_OK)
            bat_fill_compare(&s, &r, half == 0 ? s.u : s.v, edge);
    }
    bat_release(places);
    return status;
}

/* Spoke i: u = 1 of quad i and v = 1 of the next, seen at the places of both. */
static batten_status measure_spoke(const batten_surface *patch, const batten_surface *next,
                                   batten_fill_edge *edge)
{
    batten_status status = BATTEN_OK;
    for (int which = 0; status == BATTEN_OK && which < 2; which++) {
        double *places = NULL;
        int count = 0;
        status = places_of(which == 0 ? patch : next, which == 0 ? BATTEN_V : BATTEN_U, &places,
                           &count);
        for (int k = 0; status == BATTEN_OK && k < count; k++) {
            bat_fill_view s, r;
            status = bat_fill_see_surface(patch, 1, places[k], &s);
            if (status == BATTEN_OK)
                status = bat_fill_see_surface(next, places[k], 1, &r);
            if (status == BATTEN_OK)
                bat_fill_compare(&s, &r, s.v, edge);
        }
        bat_release(places);
    }
    return status;
}

/* The largest curvature of the ribbons that give one, in the coordinates of the loop. */
static batten_status measure_rim(const bat_fill_loop *loop, double *out)
{
    batten_status status = BATTEN_OK;
    *out = 0;
    for (int i = 0; i < loop->count; i++)
        for (int k = 0; status == BATTEN_OK && loop->sides[i].bend && k <= 4 * PLACES; k++) {
            bat_fill_view r;
            status =
                bat_fill_see_ribbon(&loop->sides[i], k / (2.0 * PLACES),
                                    k < 4 * PLACES ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &r);
            if (status == BATTEN_OK && r.regular && r.bent)
                *out = bat_max(*out, bat_fill_largest_curvature(&r));
        }
    return status;
}

static batten_status look_for_folds(const batten_surface *patch, bool *folded, double at[3])
{
    batten_surface_fold fold;
    const batten_status status = batten_surface_find_fold(patch, &fold);
    if (status != BATTEN_OK || *folded || !fold.found)
        return status;
    *folded = true;
    at[0] = fold.point.x;
    at[1] = fold.point.y;
    at[2] = fold.point.z;
    return BATTEN_OK;
}

static void place_given(const bat_fill_loop *loop, double at[3])
{
    for (int c = 0; c < 3; c++)
        at[c] = loop->centre[c] + loop->size * at[c];
}

/* From the loop's coordinates to those of the caller. */
static void to_given(const bat_fill_loop *loop, batten_fill_edge *edge)
{
    double *at[3] = {edge->gap_at, edge->angle_at, edge->curvature_at};
    edge->gap *= loop->size;
    edge->curvature /= loop->size;
    for (int k = 0; k < 3; k++)
        place_given(loop, at[k]);
}

batten_status bat_fill_measure(const bat_fill_loop *loop, batten_surface *const *patches,
                               batten_surface_fill_report *report)
{
    batten_status status = BATTEN_OK;
    const int n = loop->count;
    report->count = n;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        const int next = (i + 1) % n;
        batten_fill_edge *outer = &report->outer[i], *inner = &report->inner[i];
        *outer = (batten_fill_edge){.curve = loop->sides[i].given, .first = i, .second = next};
        *inner = (batten_fill_edge){.curve = -1, .first = i, .second = next};
        for (int half = 0; status == BATTEN_OK && half < 2; half++)
            status = measure_half(loop, i, half, patches[half == 0 ? i : next], outer);
        if (status == BATTEN_OK)
            status = measure_spoke(patches[i], patches[next], inner);
        if (status == BATTEN_OK)
            status = look_for_folds(patches[i], &report->folded, report->fold_at);
        /* What leaves a side against its ribbon turns back, too. */
        if (status == BATTEN_OK && !report->folded && outer->angle > BAT_PI / 2) {
            report->folded = true;
            memcpy(report->fold_at, outer->angle_at, sizeof report->fold_at);
        }
        to_given(loop, outer);
        to_given(loop, inner);
    }
    if (status == BATTEN_OK && !report->folded)
        status = bat_fill_find_overlap(loop, patches, &report->folded, report->fold_at);
    place_given(loop, report->fold_at);
    if (status == BATTEN_OK)
        status = measure_rim(loop, &report->rim_curvature);
    report->rim_curvature /= loop->size;
    report->most_curvature = bat_max(report->rim_curvature, 1 / loop->size);
    return status;
}
