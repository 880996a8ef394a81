/* Where a coordinate of a curve takes a value, and where the curve crosses a plane. */
#include "base/plural.h"
#include "inspect/forms.h"
#include "numeric/vector.h"

#include <batten/nearest.h>
#include <float.h>
#include <string.h>

/*
 * A coordinate equals the value where g = x - value w changes sign, and where g touches 0:
 * there its derivative changes sign while g is no more than roundoff. Both are walks along the
 * curve.
 */
typedef struct {
    bat_walk crossings, turns;
    double *flat; /* ends of the spans on which g vanishes, and of the domain where it vanishes
                     there */
    int flat_count;
} search;

static bool vanishes(bat_form g)
{
    for (int k = 0; k <= g.degree; k++)
        if (fabs(g.c[k]) > 4 * g.error * bat_binomials[g.degree][k])
            return false;
    return true;
}

static batten_status search_span(search *s, bat_forms *forms, const bat_span_forms *span,
                                 int axis, double value)
{
    const bat_form offset = {0, &(double){value}, 2 * DBL_EPSILON * fabs(value)};
    const bat_form g =
        bat_form_sum(forms, span->x[axis], -1, bat_form_product(forms, offset, span->w));
    if (vanishes(g)) {
        s->flat[s->flat_count++] = span->a;
        s->flat[s->flat_count++] = span->b;
        return BATTEN_OK;
    }
    const bat_form slope = bat_form_derivative(forms, g);
    const bat_form turn =
        bat_form_sum(forms, bat_form_product(forms, slope, span->w), -1,
                     bat_form_product(forms, g, bat_form_derivative(forms, span->w)));
    batten_status status = bat_walk_piece(&s->crossings, g, span->a, span->b);
    return status == BATTEN_OK ? bat_walk_piece(&s->turns, turn, span->a, span->b) : status;
}

static batten_status search_spans(search *s, const batten_curve *curve, int axis, double value)
{
    const int p = curve->degree;
    const double origin[3] = {0};
    bat_forms forms = {0};
    bat_span_forms span;
    double *rows = bat_array3((size_t)p + 1, bat_curve_width(curve), sizeof *rows);
    batten_status status = rows ? bat_forms_begin(32, 3 * p, &forms) : BATTEN_OUT_OF_MEMORY;
    for (int k = p;
         status == BATTEN_OK && bat_span_forms_next(curve, &k, rows, origin, &forms, &span);)
        status = search_span(s, &forms, &span, axis, value);
    bat_forms_end(&forms);
    bat_release(rows);
    return status;
}

/* Is g no more than the rounding of coordinates at u? */
static batten_status is_on(const batten_curve *curve, int axis, double value, double u,
                           bool *on)
{
    const double size =
        bat_largest(curve->count * curve->dimension, curve->points) + fabs(value);
    double point[3];
    batten_status status = batten_curve_evaluate(curve, u, 0, point);
    if (status == BATTEN_OK)
        *on = fabs(point[axis] - value) <= 4 * (curve->degree + 1) * DBL_EPSILON * size;
    return status;
}

/* Keep the turns that touch. */
static batten_status filter_turns(search *s, const batten_curve *curve, int axis, double value)
{
    int kept = 0;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < s->turns.count; k++) {
        bool on = false;
        status = is_on(curve, axis, value, s->turns.at[k], &on);
        if (on)
            s->turns.at[kept++] = s->turns.at[k];
    }
    s->turns.count = kept;
    return status;
}

/* A curve may begin or end on the value; both stand at their place among the flat spans. */
static batten_status add_ends(search *s, const batten_curve *curve, int axis, double value)
{
    const batten_interval domain = batten_curve_domain(curve);
    bool first = false, last = false;
    batten_status status = is_on(curve, axis, value, domain.a, &first);
    if (status == BATTEN_OK)
        status = is_on(curve, axis, value, domain.b, &last);
    if (status == BATTEN_OK && first) {
        memmove(s->flat + 1, s->flat, (size_t)s->flat_count++ * sizeof *s->flat);
        s->flat[0] = domain.a;
    }
    if (status == BATTEN_OK && last)
        s->flat[s->flat_count++] = domain.b;
    return status;
}

/* Merge the three increasing lists; what two of them found is found once. */
static int merge(const search *s, double apart, double *at)
{
    int i = 0, j = 0, k = 0, count = 0;
    for (;;) {
        const double a = i < s->crossings.count ? s->crossings.at[i] : HUGE_VAL;
        const double b = j < s->turns.count ? s->turns.at[j] : HUGE_VAL;
        const double c = k < s->flat_count ? s->flat[k] : HUGE_VAL;
        const double next = bat_min(a, bat_min(b, c));
        if (next == HUGE_VAL)
            return count;
        i += next == a;
        j += next == b;
        k += next == c;
        if (count == 0 || next - at[count - 1] > apart)
            at[count++] = next;
    }
}

batten_status batten_curve_crossings(const batten_curve *curve, int axis, double value,
                                     batten_parameters *out)
{
    if (axis < 0 || axis >= curve->dimension)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no coordinate %d in %d dimension%s",
                        axis + 1, curve->dimension, bat_plural(curve->dimension));
    if (!isfinite(value))
        return bat_fail(BATTEN_NOT_FINITE, "the value to cross is %g", value);
    const batten_interval domain = batten_curve_domain(curve);
    search s = {0};
    s.flat = bat_array(2 * (size_t)batten_curve_spans(curve, NULL) + 2, sizeof *s.flat);
    batten_status status = s.flat ? search_spans(&s, curve, axis, value) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = filter_turns(&s, curve, axis, value);
    if (status == BATTEN_OK)
        status = add_ends(&s, curve, axis, value);
    double *at = NULL;
    const int room = s.crossings.count + s.turns.count + s.flat_count;
    if (status == BATTEN_OK && !(at = bat_array((size_t)room, sizeof *at)))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) /* parameters closer than this are one but for rounding */
        *out = (batten_parameters){merge(&s, 64 * DBL_EPSILON * (domain.b - domain.a), at), at};
    bat_walk_end(&s.crossings);
    bat_walk_end(&s.turns);
    bat_release(s.flat);
    return status;
}

/* The plane is made the one of all points with the first coordinate offset / |normal|. */
batten_status batten_curve_plane_crossings(const batten_curve *curve, batten_vec3 normal,
                                           double offset, batten_parameters *out)
{
    const double length =
        bat_vec3_norm(curve->dimension < 3 ? (batten_vec3){normal.x, normal.y, 0} : normal);
    if (curve->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "a function meets no plane; make its graph first");
    if (!(length > 0 && isfinite(length) && isfinite(normal.z) && isfinite(offset)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a plane with the normal (%g, %g, %g) at %g",
                        normal.x, normal.y, normal.z, offset);
    batten_affine map = batten_affine_identity();
    batten_curve *turned = NULL;
    map.m[0][0] = normal.x / length;
    map.m[0][1] = normal.y / length;
    map.m[0][2] = normal.z / length;
    batten_status status = batten_curve_transform(curve, &map, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_crossings(turned, 0, offset / length, out);
    batten_curve_unref(turned);
    return status;
}
