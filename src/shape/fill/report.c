/* What a fill reached: gaps, angles, differences of curvature along all edges. */
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include <batten/measure.h>

#include <string.h>

enum { PLACES = 16 };

/* A surface seen in one point: two derivatives and the three of second order. */
typedef struct {
    double point[3], u[3], v[3], uu[3], uv[3], vv[3];
    double normal[3];
    double sine;        /* between both first derivatives */
    bool regular, bent; /* there is a normal; second derivatives are known */
} view;

/* Below this part of the product of speeds, next to a corner where two sides meet smoothly, a
 * normal is noise of what the sides were approximated by. */
static const double flat = 1e-4;

static void see_normal(view *s)
{
    const batten_vec3 n = bat_vec3_cross(bat_vec3_of(3, s->u), bat_vec3_of(3, s->v));
    const double size = bat_vec3_norm(n);
    s->sine = size / (bat_norm(3, s->u) * bat_norm(3, s->v));
    s->regular = s->sine > flat;
    s->normal[0] = n.x / size;
    s->normal[1] = n.y / size;
    s->normal[2] = n.z / size;
}

static batten_status see_surface(const batten_surface *surface, double u, double v, view *out)
{
    double d[6][3];
    const batten_status status = batten_surface_evaluate(surface, u, v, 2, d[0]);
    if (status != BATTEN_OK)
        return status;
    double *parts[6] = {out->point, out->u, out->v, out->uu, out->uv, out->vv};
    for (int k = 0; k < 6; k++)
        memcpy(parts[k], d[k], sizeof d[k]);
    out->bent = true;
    see_normal(out);
    return BATTEN_OK;
}

/* The ribbon, seen as a surface of which u runs along it. */
static batten_status see_ribbon(const bat_fill_side *side, double t, batten_side from,
                                view *out)
{
    double C[3][3], T[2][3];
    *out = (view){0};
    batten_status status = batten_curve_evaluate_side(side->curve, t, from, 2, C[0]);
    if (status == BATTEN_OK && side->slope)
        status = batten_curve_evaluate_side(side->slope, t, from, 1, T[0]);
    if (status == BATTEN_OK && side->bend)
        status = batten_curve_evaluate_side(side->bend, t, from, 0, out->vv);
    if (status != BATTEN_OK)
        return status;
    memcpy(out->point, C[0], sizeof C[0]);
    if (!side->slope)
        return BATTEN_OK;
    memcpy(out->u, C[1], sizeof C[1]);
    memcpy(out->v, T[0], sizeof T[0]);
    memcpy(out->uu, C[2], sizeof C[2]);
    memcpy(out->uv, T[1], sizeof T[1]);
    out->bent = side->bend != NULL;
    see_normal(out);
    return BATTEN_OK;
}

/* The normal curvature in a direction of the tangent plane. */
static double curvature(const view *s, const double direction[3], const double normal[3])
{
    const double E = bat_dot(3, s->u, s->u), F = bat_dot(3, s->u, s->v);
    const double G = bat_dot(3, s->v, s->v), a = bat_dot(3, direction, s->u);
    const double b = bat_dot(3, direction, s->v), D = E * G - F * F;
    const double x = (G * a - F * b) / D, y = (E * b - F * a) / D;
    return x * x * bat_dot(3, s->uu, normal) + 2 * x * y * bat_dot(3, s->uv, normal) +
           y * y * bat_dot(3, s->vv, normal);
}

static void keep_largest(double value, const double point[3], double *largest, double at[3])
{
    if (value > *largest) {
        *largest = value;
        memcpy(at, point, 3 * sizeof *at);
    }
}

/* Both sides of one point of an edge that runs along `along`. */
static void compare(const view *s, const view *r, const double along[3], batten_fill_edge *edge)
{
    keep_largest(bat_distance(3, s->point, r->point), s->point, &edge->gap, edge->gap_at);
    if (!s->regular || !r->regular)
        return;
    const batten_vec3 n = bat_vec3_of(3, s->normal), m = bat_vec3_of(3, r->normal);
    const double turned = bat_atan2(bat_vec3_norm(bat_vec3_cross(n, m)), bat_vec3_dot(n, m));
    edge->has_slope = true;
    keep_largest(turned, s->point, &edge->angle, edge->angle_at);
    if (!s->bent || !r->bent)
        return;
    batten_vec3 across = bat_vec3_cross(n, bat_vec3_of(3, along));
    across = bat_vec3_scale(across, 1 / bat_vec3_norm(across));
    const double direction[3] = {across.x, across.y, across.z};
    const double difference =
        curvature(s, direction, s->normal) - curvature(r, direction, s->normal);
    edge->has_curvature = true;
    keep_largest(fabs(difference), s->point, &edge->curvature, edge->curvature_at);
}

batten_status bat_fill_lack(const bat_fill_loop *loop, int side, int half,
                            const batten_surface *patch, double t, double out[3])
{
    view s, r;
    memset(out, 0, 3 * sizeof *out);
    batten_status status = see_surface(patch, half == 0 ? t : 0, half == 0 ? 0 : t, &s);
    if (status == BATTEN_OK)
        status = see_ribbon(&loop->sides[side], half == 0 ? t : 2 - t,
                            half == 0 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &r);
    if (status != BATTEN_OK || !s.regular || !r.regular || !r.bent)
        return status;
    const double *along = half == 0 ? s.u : s.v, *D = half == 0 ? s.v : s.u;
    batten_vec3 across = bat_vec3_cross(bat_vec3_of(3, s.normal), bat_vec3_of(3, along));
    across = bat_vec3_scale(across, 1 / bat_vec3_norm(across));
    const double direction[3] = {across.x, across.y, across.z};
    /* Both have the side and its planes in common, so they differ in S_vv alone. */
    const double reach = bat_dot(3, D, direction);
    const double lack =
        reach * reach *
        (curvature(&r, direction, s.normal) - curvature(&s, direction, s.normal));
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
        view s, r;
        const double t = places[k];
        status = see_surface(patch, half == 0 ? t : 0, half == 0 ? 0 : t, &s);
        if (status == BATTEN_OK)
            status = see_ribbon(&loop->sides[i], half == 0 ? t : 2 - t,
                                half == 0 ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &r);
        if (status == BATTEN_OK)
            compare(&s, &r, half == 0 ? s.u : s.v, edge);
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
            view s, r;
            status = see_surface(patch, 1, places[k], &s);
            if (status == BATTEN_OK)
                status = see_surface(next, places[k], 1, &r);
            if (status == BATTEN_OK)
                compare(&s, &r, s.v, edge);
        }
        bat_release(places);
    }
    return status;
}

/* The larger principal curvature. */
static double largest_curvature(const view *s)
{
    const double E = bat_dot(3, s->u, s->u), F = bat_dot(3, s->u, s->v);
    const double G = bat_dot(3, s->v, s->v), D = E * G - F * F;
    const double L = bat_dot(3, s->uu, s->normal), M = bat_dot(3, s->uv, s->normal);
    const double N = bat_dot(3, s->vv, s->normal);
    const double mean = (E * N - 2 * F * M + G * L) / (2 * D), gauss = (L * N - M * M) / D;
    return fabs(mean) + sqrt(bat_max(0, mean * mean - gauss));
}

/* The largest curvature of the ribbons that give one, in the coordinates of the loop. */
static batten_status measure_rim(const bat_fill_loop *loop, double *out)
{
    batten_status status = BATTEN_OK;
    *out = 0;
    for (int i = 0; i < loop->count; i++)
        for (int k = 0; status == BATTEN_OK && loop->sides[i].bend && k <= 4 * PLACES; k++) {
            view r;
            status = see_ribbon(&loop->sides[i], k / (2.0 * PLACES),
                                k < 4 * PLACES ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &r);
            if (status == BATTEN_OK && r.regular && r.bent)
                *out = bat_max(*out, largest_curvature(&r));
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
    place_given(loop, report->fold_at);
    if (status == BATTEN_OK)
        status = measure_rim(loop, &report->rim_curvature);
    report->rim_curvature /= loop->size;
    report->most_curvature = bat_max(report->rim_curvature, 1 / loop->size);
    return status;
}
