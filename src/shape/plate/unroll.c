/* Developable surfaces laid flat: options, refinement until the tolerance is met, and the report. */
#include "numeric/vector.h"
#include "shape/plate/unroll_parts.h"

#include <string.h>

enum { FIRST_STEPS = 2, MAX_RULINGS = 1 << 17, LOOKS = 4 };

batten_surface_unroll_options batten_surface_unroll_defaults(void)
{
    return (batten_surface_unroll_options){.size = sizeof(batten_surface_unroll_options),
                                           .straight = BATTEN_STRAIGHT_FIND,
                                           .tolerance =
                                               1e-4}; /* with metres, a tenth of a millimetre */
}

/* ---- which lines are straight ---- */

/* Places between and at the knots, LOOKS in each span. */
static batten_status places_along(const batten_surface *surface, batten_direction direction,
                                  int *count, double **out)
{
    const int knots = batten_surface_spans(surface, direction, NULL);
    double *at = bat_array((size_t)knots * LOOKS, sizeof *at);
    double *breaks = bat_array((size_t)knots, sizeof *breaks);
    if (at && breaks) {
        batten_surface_spans(surface, direction, breaks);
        *count = (knots - 1) * LOOKS + 1;
        for (int i = 0; i < *count; i++) {
            const int k = bat_min_int(i / LOOKS, knots - 2);
            at[i] = breaks[k] + (breaks[k + 1] - breaks[k]) * (i - k * LOOKS) / LOOKS;
        }
        *out = at;
        at = NULL;
    }
    const batten_status status = *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    bat_release(at);
    bat_release(breaks);
    return status;
}

/* How far the lines along v are from their chords; at this u. */
static batten_status bow_of(const batten_surface *surface, double *bow, double *where)
{
    int count[2];
    double *at[2] = {NULL, NULL}, *points = NULL;
    batten_status status = places_along(surface, BATTEN_U, &count[0], &at[0]);
    if (status == BATTEN_OK)
        status = places_along(surface, BATTEN_V, &count[1], &at[1]);
    if (status == BATTEN_OK) {
        points = bat_array3((size_t)count[0], (size_t)count[1] * 3, sizeof *points);
        status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_grid(
            surface, (batten_uv_grid){(size_t)count[0], (size_t)count[1], at[0], at[1]}, 0,
            NULL, points);
    *bow = 0;
    for (int i = 0; i < count[0] && status == BATTEN_OK; i++) {
        const double *line = points + (size_t)3 * (size_t)count[1] * (size_t)i;
        for (int j = 0; j < count[1]; j++) {
            const double off =
                bat_segment_distance(3, line, line + 3 * (count[1] - 1), line + 3 * j);
            if (off > *bow) {
                *bow = off;
                *where = at[0][i];
            }
        }
    }
    bat_release(at[0]);
    bat_release(at[1]);
    bat_release(points);
    return status;
}

/* The surface with its rulings along v. */
static batten_status turn_rulings(const batten_surface *surface,
                                  const batten_surface_unroll_options *options, double *bow,
                                  batten_surface **out)
{
    double bows[2] = {0, 0}, where[2] = {0, 0};
    batten_surface *swapped = NULL;
    batten_status status = batten_surface_swap(surface, &swapped);
    if (status == BATTEN_OK)
        status = bow_of(surface, &bows[0], &where[0]);
    if (status == BATTEN_OK)
        status = bow_of(swapped, &bows[1], &where[1]);
    const bool along_u = options->straight == BATTEN_STRAIGHT_U ||
                         (options->straight == BATTEN_STRAIGHT_FIND && bows[1] < bows[0]);
    *bow = bows[along_u];
    if (status == BATTEN_OK && *bow > options->tolerance)
        status = bat_fail(BATTEN_NOT_COMPATIBLE,
                          "the surface has no straight lines within %g: that of %s = %g is %g "
                          "from its chord",
                          options->tolerance, along_u ? "v" : "u", where[along_u], *bow);
    if (status == BATTEN_OK)
        *out = along_u ? batten_surface_ref(swapped) : batten_surface_ref(surface);
    batten_surface_unref(swapped);
    return status;
}

/* NURBS in space, clamped, with its rulings along v. */
static batten_status prepare_surface(const batten_surface *surface,
                                     const batten_surface_unroll_options *options, double *bow,
                                     batten_surface **out)
{
    batten_surface *nurbs = NULL, *clamped = NULL, *both = NULL;
    batten_status status =
        batten_surface_to_nurbs(surface, options->tolerance / 2, NULL, &nurbs);
    if (status == BATTEN_OK && batten_surface_dimension(nurbs) != 3)
        status = bat_fail(BATTEN_UNSUPPORTED, "surfaces of dimension %d are not laid flat",
                          batten_surface_dimension(nurbs));
    if (status == BATTEN_OK)
        status = batten_surface_clamp(nurbs, BATTEN_U, &clamped);
    if (status == BATTEN_OK)
        status = batten_surface_clamp(clamped, BATTEN_V, &both);
    if (status == BATTEN_OK)
        status = turn_rulings(both, options, bow, out);
    batten_surface_unref(both);
    batten_surface_unref(clamped);
    batten_surface_unref(nurbs);
    return status;
}

/* ---- refinement ---- */

/* How far the cubic pieces of one laying are from a finer one with a ruling midway in each. */
static double distance_from(const bat_flat_strip *coarse, const bat_flat_strip *fine)
{
    double largest = 0;
    for (int i = 0; i + 1 < coarse->count; i++)
        for (int e = 0; e < 2; e++) {
            const double *p = coarse->points + 4 * i + 2 * e, *q = p + 4;
            const double *a = coarse->rates + 8 * i + 4 * e, *b = a + 2;
            const double *known = fine->points + 8 * i + 2 * e;
            const double h = coarse->u[i + 1] - coarse->u[i];
            const double middle[2] = {(p[0] + q[0]) / 2 + h / 8 * (a[0] - b[0]),
                                      (p[1] + q[1]) / 2 + h / 8 * (a[1] - b[1])};
            largest = bat_max(largest, bat_distance(2, middle, known + 4));
            largest = bat_max(largest, bat_distance(2, q, known + 8));
        }
    return largest;
}

static batten_status refine_strip(const bat_strip *strip, batten_parameters knots,
                                  double tolerance, bat_flat_strip *out, double *error)
{
    bat_flat_strip coarse = {0}, fine = {0};
    int steps = FIRST_STEPS;
    batten_status status = bat_strip_flatten(strip, knots.count, knots.at, steps, &coarse);
    *error = HUGE_VAL;
    while (status == BATTEN_OK && *error > tolerance) {
        steps *= 2;
        if ((double)(knots.count - 1) * steps > MAX_RULINGS) {
            status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                              "the flat edges are within %g with %d rulings, not within %g",
                              *error, coarse.count, tolerance);
            break;
        }
        bat_flat_strip_release(&fine);
        status = bat_strip_flatten(strip, knots.count, knots.at, steps, &fine);
        if (status != BATTEN_OK)
            break;
        *error = distance_from(&coarse, &fine);
        if (*error > tolerance) {
            bat_flat_strip_release(&coarse);
            coarse = fine;
            fine = (bat_flat_strip){0};
        }
    }
    bat_flat_strip_release(&fine);
    if (status == BATTEN_OK)
        *out = coarse;
    else
        bat_flat_strip_release(&coarse);
    return status;
}

/* ---- the result ---- */

static batten_status edge_curve(const bat_flat_strip *flat, int e, batten_curve **out)
{
    const int pieces = flat->count - 1;
    double *points = bat_array((size_t)(3 * pieces + 1) * 2, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < pieces; i++) {
        const double *p = flat->points + 4 * i + 2 * e, *q = p + 4;
        const double *a = flat->rates + 8 * i + 4 * e, *b = a + 2;
        const double third = (flat->u[i + 1] - flat->u[i]) / 3;
        double *to = points + 6 * i;
        for (int c = 0; c < 2; c++) {
            to[c] = p[c];
            to[2 + c] = p[c] + third * a[c];
            to[4 + c] = q[c] - third * b[c];
            to[6 + c] = q[c];
        }
    }
    const batten_status status =
        batten_curve_from_bezier(2, (batten_pieces){3, pieces, flat->u}, points, NULL, out);
    bat_release(points);
    return status;
}

/* In space and flat. */
static void hand_over_measures(const bat_flat_strip *flat, batten_unrolled *out)
{
    for (int k = 0; k < 2; k++) {
        out->length_first[k] = flat->length[0][k];
        out->length_second[k] = flat->length[1][k];
        out->area[k] = flat->area[k];
        out->diagonal[k] = flat->diagonal[k];
    }
}

static void hand_over_strip(bat_flat_strip *flat, batten_interval v, batten_unrolled *out)
{
    out->count = flat->count;
    out->u = flat->u;
    out->points = flat->points;
    flat->u = flat->points = NULL;
    out->turn = flat->turn;
    hand_over_measures(flat, out);
    out->strain = flat->strain;
    out->strain_rms = sqrt(flat->strain_sum / flat->area[0]);
    out->strain_at[0] = flat->strain_at[0];
    out->strain_at[1] = v.a + flat->strain_at[1] * (v.b - v.a);
}

static batten_status unroll_strip(const bat_strip *strip, double tolerance,
                                  batten_unrolled *out)
{
    const int knot_count = batten_surface_spans(out->surface, BATTEN_U, NULL);
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(out->surface, BATTEN_U, knots);
    bat_flat_strip flat = {0};
    batten_status status = refine_strip(strip, (batten_parameters){knot_count, knots},
                                        tolerance, &flat, &out->error);
    if (status == BATTEN_OK)
        status = edge_curve(&flat, 0, &out->first);
    if (status == BATTEN_OK)
        status = edge_curve(&flat, 1, &out->second);
    if (status == BATTEN_OK)
        hand_over_strip(&flat, batten_surface_domain(out->surface, BATTEN_V), out);
    bat_flat_strip_release(&flat);
    bat_release(knots);
    return status;
}

static batten_status check_options(const batten_surface_unroll_options *options)
{
    if (!(options->tolerance > 0 && isfinite(options->tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0",
                        options->tolerance);
    return BATTEN_OK;
}

batten_status batten_surface_unroll(const batten_surface *surface,
                                    const batten_surface_unroll_options *options,
                                    batten_unrolled *out)
{
    assert(surface && out);
    batten_surface_unroll_options chosen = batten_surface_unroll_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_unroll_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_surface_unroll_options *o = &chosen;
    batten_curve *edge[2] = {NULL, NULL};
    batten_unrolled made = {0};
    status = check_options(o);
    if (status == BATTEN_OK)
        status = prepare_surface(surface, o, &made.bow, &made.surface);
    for (int e = 0; e < 2 && status == BATTEN_OK; e++) {
        const batten_interval v = batten_surface_domain(made.surface, BATTEN_V);
        status = batten_surface_isocurve(made.surface, BATTEN_V, e ? v.b : v.a, &edge[e]);
    }
    if (status == BATTEN_OK) {
        const batten_box box = batten_surface_box(made.surface);
        const bat_strip strip = {.edge = {edge[0], edge[1]},
                                 .domain = batten_surface_domain(made.surface, BATTEN_U),
                                 .size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low))};
        status = unroll_strip(&strip, o->tolerance, &made);
    }
    batten_curve_unref(edge[0]);
    batten_curve_unref(edge[1]);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_unrolled_release(&made);
    return status;
}

void batten_unrolled_release(batten_unrolled *unrolled)
{
    batten_surface_unref(unrolled->surface);
    batten_curve_unref(unrolled->first);
    batten_curve_unref(unrolled->second);
    bat_release(unrolled->u);
    bat_release(unrolled->points);
    *unrolled = (batten_unrolled){0};
}

batten_status batten_unrolled_at(const batten_unrolled *unrolled, double u, double v,
                                 batten_vec2 *out)
{
    const batten_interval domain = batten_surface_domain(unrolled->surface, BATTEN_V);
    const double at[3] = {domain.a, v, domain.b};
    double space[3][3], first[2], second[2];
    for (int k = 0; k < 3; k++) {
        const batten_status status =
            batten_surface_evaluate(unrolled->surface, u, at[k], 0, space[k]);
        if (status != BATTEN_OK)
            return status;
    }
    batten_status status = batten_curve_evaluate(unrolled->first, u, 0, first);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(unrolled->second, u, 0, second);
    if (status != BATTEN_OK)
        return status;
    const double whole = bat_distance(3, space[0], space[2]);
    const double share = whole > 0 ? bat_distance(3, space[0], space[1]) / whole : 0;
    double place[2];
    for (int c = 0; c < 2; c++)
        place[c] = first[c] + share * (second[c] - first[c]);
    *out = (batten_vec2){place[0], place[1]};
    return BATTEN_OK;
}
