/* What is true of a skin: that it passes its sections, and what its report says. */
#include "shape/skin_parts.h"

#include <float.h>
#include <stdlib.h>

/* How far the curve runs at u while its parameter is rounded: its knots are moved into [0, 1]
 * by up to 4 eps (max(|a|, |b|) + (b - a)), those of its partners too, and u is computed there
 * and back. */
static batten_status parameter_rounding(const batten_curve *section, double u, double *moved)
{
    const batten_interval domain = batten_curve_domain(section);
    const double end = bat_max(fabs(domain.a), fabs(domain.b));
    const double step = 12 * DBL_EPSILON * (end + (domain.b - domain.a));
    double low[3], high[3];
    batten_status status = batten_curve_evaluate(section, bat_max(domain.a, u - step), 0, low);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(section, bat_min(domain.b, u + step), 0, high);
    if (status == BATTEN_OK)
        *moved = bat_distance(batten_curve_dimension(section), low, high);
    return status;
}

/* The largest distance of a section from its line on the surface, beyond the rounding of its
 * parameters, at the knots and midway between them. */
static batten_status section_distance(const bat_skin *t, const batten_surface *surface, int k,
                                      const double *knots, int knot_count, double *worst)
{
    const batten_curve *section = t->placed[k];
    const batten_interval domain = batten_curve_domain(section);
    for (int i = 0; i < 2 * knot_count - 1; i++) {
        const double s = i % 2 == 0 ? knots[i / 2] : (knots[i / 2] + knots[i / 2 + 1]) / 2;
        const double u =
            bat_min(domain.b, bat_max(domain.a, (1 - s) * domain.a + s * domain.b));
        double given[3], found[3], rounding = 0;
        batten_status status = batten_curve_evaluate(section, u, 0, given);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate(surface, s, t->v[k], 0, found);
        if (status == BATTEN_OK)
            status = parameter_rounding(section, u, &rounding);
        if (status != BATTEN_OK)
            return status;
        *worst = bat_max(*worst, bat_distance(t->dimension, given, found) - rounding);
    }
    return BATTEN_OK;
}

static batten_status check_sections(const bat_skin *t, const batten_surface *surface,
                                    const double *knots, int knot_count)
{
    for (int k = 0; k < t->count; k++) {
        const int n = batten_curve_point_count(t->placed[k]) * t->dimension;
        double worst = 0, size = 0;
        for (int i = 0; i < n; i++)
            size = bat_max(size, fabs(batten_curve_points(t->placed[k])[i]));
        const batten_status status = section_distance(t, surface, k, knots, knot_count, &worst);
        if (status != BATTEN_OK)
            return status;
        const double allowed = t->deviation[k] + 1e-13 * size;
        if (!(worst <= allowed))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "section %d is missed by %g, more than %g", k, worst, allowed);
    }
    return BATTEN_OK;
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* @param knots  spoilt: it becomes the sorted spans */
static double span_ratio(double *knots, int knot_count)
{
    const int spans = knot_count - 1;
    for (int i = 0; i < spans; i++)
        knots[i] = knots[i + 1] - knots[i];
    qsort(knots, (size_t)spans, sizeof *knots, by_value);
    return knots[0] / knots[spans / 2];
}

/* The angle between the normals on both sides of the knot line u at v; 0 where one of them
 * vanishes. */
static batten_status normal_jump(const batten_surface *surface, double u, double v,
                                 double *worst)
{
    batten_vec3 normal[2];
    for (int side = 0; side < 2; side++) {
        double out[9];
        const batten_status status = batten_surface_evaluate_side(
            surface, u, v, side == 0 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT,
            1, out);
        if (status != BATTEN_OK)
            return status;
        normal[side] = bat_vec3_cross(bat_vec3_of(3, out + 3), bat_vec3_of(3, out + 6));
    }
    const double sine = bat_vec3_norm(bat_vec3_cross(normal[0], normal[1]));
    *worst = bat_max(*worst, atan2(sine, bat_vec3_dot(normal[0], normal[1])));
    return BATTEN_OK;
}

/* Only knots that stand p times or more can have a jump of the normal; it is looked for at 33
 * places of each. */
static batten_status find_normal_jump(const bat_skin *t, const batten_surface *surface,
                                      const double *knots, int knot_count, double *worst)
{
    const batten_curve *first = t->unified[0];
    const int p = batten_curve_degree(first), n = batten_curve_point_count(first);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    batten_status status = BATTEN_OK;
    for (int i = 1; i + 1 < knot_count && t->dimension == 3; i++) {
        if (bat_knots_multiplicity(p, n, batten_curve_knots(first), knots[i]) < p)
            continue;
        for (int j = 0; status == BATTEN_OK && j <= 32; j++)
            status = normal_jump(surface, knots[i], v.a + (v.b - v.a) * (j / 32.0), worst);
    }
    return status;
}

/* Distinct inner knots of all sections, those within rounding taken as one. */
static batten_status count_exact(const bat_skin *t, int *count)
{
    size_t total = 0, used = 0;
    for (int k = 0; k < t->count; k++)
        total += (size_t)batten_curve_spans(t->placed[k], NULL);
    double *knots = bat_array(total, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < t->count; k++) {
        const int own = batten_curve_spans(t->placed[k], knots + used);
        const batten_interval domain = batten_curve_domain(t->placed[k]);
        for (int i = 1; i + 1 < own; i++) /* the ends are not counted */
            knots[used + (size_t)i - 1] =
                (knots[used + (size_t)i] - domain.a) / (domain.b - domain.a);
        used += (size_t)(own - 2);
    }
    qsort(knots, used, sizeof *knots, by_value);
    *count = used > 0;
    for (size_t i = 1; i < used; i++)
        *count += knots[i] - knots[i - 1] > 16 * DBL_EPSILON;
    bat_release(knots);
    return BATTEN_OK;
}

batten_status bat_skin_inspect(const bat_skin *t, const batten_surface *surface,
                               batten_skin_report *report)
{
    const int knot_count = batten_surface_spans(surface, BATTEN_U, NULL);
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, BATTEN_U, knots);
    batten_skin_report found = {.knot_count = knot_count - 2};
    for (int k = 0; k < t->count; k++)
        if (t->deviation[k] > found.deviation) {
            found.deviation = t->deviation[k];
            found.worst_section = k;
        }
    batten_status status = check_sections(t, surface, knots, knot_count);
    if (status == BATTEN_OK && report)
        status = find_normal_jump(t, surface, knots, knot_count, &found.normal_jump);
    if (status == BATTEN_OK && report)
        status = count_exact(t, &found.exact_knot_count);
    if (status == BATTEN_OK && report) {
        found.span_ratio = span_ratio(knots, knot_count);
        *report = found;
    }
    bat_release(knots);
    return status;
}
