/* The part of a curve between two parameters, over the seam of a closed one too, and the parts of a
 * curve on one side of a plane. */
#include "inspect/singular.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/extend.h>
#include <batten/nearest.h>

#include <float.h>

/* ---- over the seam ---- */

/* From a to the end and on from the start to b; one of the two may be nothing. */
static batten_status part_around_seam(const batten_curve *curve, double a, double b,
                                      double tolerance, batten_curve **out)
{
    const batten_interval domain = batten_curve_domain(curve);
    batten_curve *first = NULL, *second = NULL;
    if (a == domain.b)
        return batten_curve_subrange(curve, domain.a, b > domain.a ? b : domain.b, out);
    if (b == domain.a)
        return batten_curve_subrange(curve, a, domain.b, out);
    batten_status status = batten_curve_subrange(curve, a, domain.b, &first);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(curve, domain.a, b, &second);
    if (status == BATTEN_OK)
        status = batten_curve_join(first, second, tolerance, out);
    batten_curve_unref(second);
    batten_curve_unref(first);
    return status;
}

batten_status batten_curve_trim(const batten_curve *curve, double a, double b, double tolerance,
                                batten_curve **out)
{
    const batten_interval domain = batten_curve_domain(curve);
    batten_status status = bat_tolerance_check(tolerance);
    if (status == BATTEN_OK)
        status = bat_knots_clip(domain.a, domain.b, &a);
    if (status == BATTEN_OK)
        status = bat_knots_clip(domain.a, domain.b, &b);
    if (status != BATTEN_OK)
        return status;
    if (a < b)
        return batten_curve_subrange(curve, a, b, out);
    if (curve->periodic)
        return batten_curve_subrange(curve, a, b + (domain.b - domain.a), out);
    const double size = bat_curve_size(curve);
    if (!batten_curve_is_closed(curve, bat_max(tolerance, 16 * DBL_EPSILON * size)))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the part from %.17g to %.17g goes over the ends of an open curve", a,
                        b);
    return part_around_seam(curve, a, b, bat_max(tolerance, 16 * DBL_EPSILON * size), out);
}

/* ---- one side of a plane ---- */

typedef struct {
    const batten_curve *curve;
    batten_vec3 normal; /* of length one */
    double offset;
    int count;  /* of parts between neighbours of `at` */
    double *at; /* [count + 1] */
    bool *kept; /* [count] */
} cutting;

/* Is the part from a to b in front of the plane? What is in it counts as in front. */
static batten_status judge_part(const cutting *c, double a, double b, bool *kept)
{
    enum { SAMPLES = 5 };
    double farthest = 0;
    for (int i = 0; i < SAMPLES; i++) {
        double p[3];
        const batten_status status =
            batten_curve_evaluate(c->curve, a + (b - a) * ((i + 0.5) / SAMPLES), 0, p);
        if (status != BATTEN_OK)
            return status;
        const double away =
            bat_vec3_dot(c->normal, bat_vec3_of(c->curve->dimension, p)) - c->offset;
        if (fabs(away) > fabs(farthest))
            farthest = away;
    }
    *kept = farthest >= -64 * DBL_EPSILON * (bat_curve_size(c->curve) + fabs(c->offset));
    return BATTEN_OK;
}

/* The ends of the domain and the crossings that are apart from each other and from these. */
static void list_cuts(cutting *c, const batten_parameters *crossings)
{
    const batten_interval domain = batten_curve_domain(c->curve);
    const double apart = BAT_EXACT * (domain.b - domain.a);
    c->at[0] = domain.a;
    for (int i = 0; i < crossings->count; i++)
        if (crossings->at[i] > c->at[c->count] + apart && crossings->at[i] < domain.b - apart)
            c->at[++c->count] = crossings->at[i];
    c->at[++c->count] = domain.b;
}

/* Crossings and ends, rising; those that rounding alone keeps apart are one. */
static batten_status cut_at_crossings(cutting *c, const batten_parameters *crossings)
{
    c->at = bat_array((size_t)crossings->count + 2, sizeof *c->at);
    c->kept = bat_array((size_t)crossings->count + 1, sizeof *c->kept);
    if (!c->at || !c->kept)
        return BATTEN_OUT_OF_MEMORY;
    list_cuts(c, crossings);
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < c->count; i++)
        status = judge_part(c, c->at[i], c->at[i + 1], &c->kept[i]);
    return status;
}

/* Neighbours that are both kept, or both not, are one part. */
static void merge_parts(cutting *c)
{
    int n = 0;
    for (int i = 0; i < c->count; i++) {
        if (n > 0 && c->kept[i] == c->kept[n - 1]) {
            c->at[n] = c->at[i + 1];
            continue;
        }
        c->kept[n] = c->kept[i];
        c->at[++n] = c->at[i + 1];
    }
    c->count = n;
}

static batten_status take_parts(const cutting *c, bool closed, double tolerance,
                                batten_curves *out)
{
    batten_curves made = {0, bat_array((size_t)c->count, sizeof *made.at)};
    batten_status status = made.at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    const bool over = closed && c->count > 2 && c->kept[0] && c->kept[c->count - 1];
    for (int i = over; status == BATTEN_OK && i < c->count; i++) {
        const bool last = over && i == c->count - 1;
        if (!c->kept[i])
            continue;
        status = batten_curve_trim(c->curve, c->at[i], last ? c->at[1] : c->at[i + 1],
                                   tolerance, &made.at[made.count]);
        made.count += status == BATTEN_OK;
    }
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_curves_release(&made);
    return status;
}

batten_status batten_curve_trim_plane(const batten_curve *curve, batten_vec3 normal,
                                      double offset, double tolerance, batten_curves *out)
{
    batten_parameters crossings = {0, NULL};
    batten_status status = bat_tolerance_check(tolerance);
    if (status == BATTEN_OK)
        status = batten_curve_plane_crossings(curve, normal, offset, &crossings);
    if (status != BATTEN_OK)
        return status;
    const double length =
        bat_vec3_norm(curve->dimension < 3 ? (batten_vec3){normal.x, normal.y, 0} : normal);
    const double size = bat_curve_size(curve);
    cutting c = {.curve = curve,
                 .normal = bat_vec3_scale(normal, 1 / length),
                 .offset = offset / length};
    status = cut_at_crossings(&c, &crossings);
    if (status == BATTEN_OK) {
        merge_parts(&c);
        status = take_parts(
            &c, batten_curve_is_closed(curve, bat_max(tolerance, 16 * DBL_EPSILON * size)),
            tolerance, out);
    }
    bat_release(c.kept);
    bat_release(c.at);
    bat_release(crossings.at);
    return status;
}
