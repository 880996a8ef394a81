/* Double points of one span in a census, and how what is special is noted. */
#include "inspect/affine/census_double.h"
#include "base/list.h"
#include "inspect/affine/double_points.h"
#include "numeric/vector.h"

#include <batten/invariants.h>
#include <batten/nearest.h>

static batten_vec3 point_at(const bat_census_finding *f, double t, double s)
{
    double real[3] = {0};
    for (int k = 0; k < f->dimension; k++) {
        double a[BATTEN_MAX_DEGREE + 1], b[BATTEN_MAX_DEGREE + 1] = {0};
        for (int i = 0; i <= f->degree; i++)
            a[i] = f->points[i * f->dimension + k];
        for (int r = f->degree; r > 0; r--)
            for (int i = 0; i < r; i++) {
                const double da = a[i + 1] - a[i], db = b[i + 1] - b[i];
                a[i] += t * da - s * db;
                b[i] += t * db + s * da;
            }
        real[k] = a[0];
    }
    return bat_vec3_of(3, real);
}

batten_status bat_census_add(bat_census_finding *f, batten_special special)
{
    batten_census *c = &f->census;
    if (BAT_LIST_GROW(c->specials, c->count, f->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    special.point =
        point_at(f, special.t, special.kind == BATTEN_SPECIAL_ISOLATED ? special.s : 0);
    int at = c->count++;
    for (; at > 0 &&
           (c->specials[at - 1].kind > special.kind ||
            (c->specials[at - 1].kind == special.kind && c->specials[at - 1].t > special.t));
         at--)
        c->specials[at] = c->specials[at - 1];
    c->specials[at] = special;
    c->whole[special.kind]++;
    c->segment[special.kind] += special.inside;
    /* The least change makes two of it, or none. */
    if (special.inside && (special.multiplicity > 1 || special.kind == BATTEN_SPECIAL_CUSP ||
                           special.kind == BATTEN_SPECIAL_PAUSE))
        c->margin = 0;
    return BATTEN_OK;
}

/* ---- double points ---- */

/* Both parameters of a real pair, the lower first, without cancellation. */
static void pair_of(double sum, double discriminant, double *t, double *s)
{
    const double far = (sum + copysign(sqrt(discriminant), sum)) / 2;
    const double near = far != 0 ? (sum * sum - discriminant) / 4 / far : 0;
    *t = bat_min(far, near);
    *s = bat_max(far, near);
}

static batten_status add_double_point(const bat_double_point *point, bat_census_finding *f)
{
    batten_special special = {.inside = point->inside, .multiplicity = point->multiplicity};
    if (point->sign < 0) {
        special.kind = BATTEN_SPECIAL_ISOLATED;
        special.t = point->sum / 2;
        special.s = sqrt(fabs(point->discriminant)) / 2;
    } else {
        special.kind = BATTEN_SPECIAL_CROSSING;
        pair_of(point->sum, fabs(point->discriminant), &special.t, &special.s);
        const double out = bat_max(-special.t, special.s - 1);
        f->census.margin = bat_min(f->census.margin, fabs(out));
    }
    return bat_census_add(f, special);
}

/* The coordinates with the degree of the second below that of the first. */
static void reduce(bat_wholes *pool, bat_whole_poly *x, bat_whole_poly *y)
{
    if (x->degree < y->degree) {
        const bat_whole_poly swapped = *x;
        *x = *y;
        *y = swapped;
    }
    if (x->degree == y->degree && x->degree > 0) {
        bat_whole_poly sum = bat_poly_make(pool, x->degree - 1);
        for (int k = 1; k <= sum.degree; k++)
            sum.c[k] =
                bat_whole_subtract(pool, bat_whole_multiply(pool, y->c[k], x->c[x->degree]),
                                   bat_whole_multiply(pool, x->c[k], y->c[x->degree]));
        *y = bat_poly_trim(sum);
    }
    if (pool->effort->status != BATTEN_OK)
        return;
    x->c[0] = y->c[0] = (bat_whole){0, 0, NULL};
    *x = bat_poly_primitive(pool, *x);
    *y = bat_poly_primitive(pool, *y);
}

/* A search finds the crossings inside where elimination was too much. */
static batten_status search_crossings(bat_census_finding *f, const double *plane)
{
    double breaks[2] = {0, 1};
    batten_curve *curve = NULL;
    batten_parameters found = {0, NULL};
    batten_status status =
        batten_curve_from_bezier(2, (batten_pieces){f->degree, 1, breaks}, plane, NULL, &curve);
    if (status == BATTEN_OK)
        status = batten_curve_self_crossings(curve, &found);
    for (int i = 0; i + 1 < found.count && status == BATTEN_OK; i += 2)
        status = bat_census_add(f, (batten_special){.kind = BATTEN_SPECIAL_CROSSING,
                                                    .inside = true,
                                                    .multiplicity = 1,
                                                    .t = found.at[i],
                                                    .s = found.at[i + 1]});
    batten_release(found.at);
    batten_curve_unref(curve);
    return status;
}

batten_status bat_census_find_double(bat_whole_poly x, bat_whole_poly y, int stops,
                                     const double *plane, bat_census_finding *f)
{
    batten_census *c = &f->census;
    bat_effort effort = {BATTEN_OK, BAT_CENSUS_EFFORT};
    bat_wholes pool = {&effort, NULL, NULL, 0};
    x = bat_poly_copy(&pool, x);
    y = bat_poly_copy(&pool, y);
    reduce(&pool, &x, &y);
    bat_double_points found = {.known = BAT_DOUBLE_POINTS_UNKNOWN};
    if (effort.status == BATTEN_OK)
        found = bat_double_points_find(&pool, x, y);
    int equal = 0, real = 0;
    for (int i = 0; i < found.count; i++) {
        equal += found.at[i].sign == 0;
        real += found.at[i].multiplicity;
    }
    batten_status status = effort.status == BATTEN_OUT_OF_MEMORY ? effort.status : BATTEN_OK;
    c->is_repeated = effort.status == BATTEN_OK && found.known == BAT_DOUBLE_POINTS_REPEATED;
    c->is_complete =
        effort.status == BATTEN_OK && found.known == BAT_DOUBLE_POINTS_ALL && equal == stops;
    if (c->is_complete) {
        c->complex_count = found.finite - real;
        c->infinite_count = (c->degree - 1) * (c->degree - 2) / 2 - found.finite;
        for (int i = 0; i < found.count && status == BATTEN_OK; i++)
            if (found.at[i].sign != 0)
                status = add_double_point(&found.at[i], f);
    } else if (status == BATTEN_OK && !c->is_repeated) {
        status = search_crossings(f, plane);
    }
    bat_wholes_release(&pool);
    return status;
}
