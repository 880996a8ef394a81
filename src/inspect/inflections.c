/* Inflections of curves, and curvature that is zero along a stretch. */
#include "inspect/inflections.h"
#include "inspect/forms.h"
#include "inspect/singular.h"
#include "numeric/vector.h"

#include <batten/nearest.h>
#include <float.h>
#include <string.h>

/*
 * With the homogeneous curve A = (X, Y, Z), w and derivatives along the span: the velocity is
 * N / w^2 with N = A' w - A w', and N x N' / w^4 = C' x C''. So with B = N x N'
 *
 *     curvature^2 = |B|^2 w^4 / |N|^6,
 *
 * signed like B in the plane. Its derivative has the sign of
 *
 *     (B' w + 2 B w') |N|^2 - 3 B w (N . N'),    in space multiplied by B as a vector.
 *
 * Of a function (dimension 1) the second derivative stands for curvature: with M = N' w - 2 N
 * w', s'' = M / w^3 and s''' has the sign of M' w - 3 M w'.
 */
typedef struct {
    int dimension;
    bat_form n[3], w, dw; /* N, w, w' */
} velocity;

static velocity velocity_of(bat_forms *forms, const bat_span_forms *span, int dimension)
{
    velocity v = {
        .dimension = dimension, .w = span->w, .dw = bat_form_derivative(forms, span->w)};
    for (int k = 0; k < dimension; k++) {
        v.n[k] = bat_form_derivative(forms, span->x[k]);
        if (v.w.degree > 0)
            v.n[k] = bat_form_sum(forms, bat_form_product(forms, v.n[k], v.w), -1,
                                  bat_form_product(forms, span->x[k], v.dw));
    }
    return v;
}

static bat_form dot(bat_forms *forms, int count, const bat_form *a, const bat_form *b)
{
    bat_form sum = bat_form_product(forms, a[0], b[0]);
    for (int k = 1; k < count; k++)
        sum = bat_form_sum(forms, sum, 1, bat_form_product(forms, a[k], b[k]));
    return sum;
}

/* x' w + factor x w' */
static bat_form weighted(bat_forms *forms, const velocity *v, bat_form derivative,
                         double factor, bat_form x)
{
    if (v->w.degree == 0)
        return derivative;
    return bat_form_sum(forms, bat_form_product(forms, derivative, v->w), factor,
                        bat_form_product(forms, x, v->dw));
}

static bat_form wedge(bat_forms *forms, bat_form ax, bat_form ay, bat_form bx, bat_form by)
{
    return bat_form_sum(forms, bat_form_product(forms, ax, by), -1,
                        bat_form_product(forms, ay, bx));
}

/* What has the sign of curvature: B in the plane, M of a function. */
static bat_form bending(bat_forms *forms, const velocity *v, const double *direction)
{
    (void)direction;
    const bat_form dx = bat_form_derivative(forms, v->n[0]);
    if (v->dimension == 1)
        return weighted(forms, v, dx, -2, v->n[0]);
    return wedge(forms, v->n[0], v->n[1], dx, bat_form_derivative(forms, v->n[1]));
}

/* What has the sign of the derivative of curvature. */
static bat_form bending_rate(bat_forms *forms, const velocity *v, const double *direction)
{
    bat_form dn[3], b[3], db[3];
    if (v->dimension == 1) {
        const bat_form m = bending(forms, v, direction);
        return weighted(forms, v, bat_form_derivative(forms, m), -3, m);
    }
    for (int k = 0; k < v->dimension; k++)
        dn[k] = bat_form_derivative(forms, v->n[k]);
    const int parts = v->dimension == 2 ? 1 : 3;
    for (int k = 0; k < parts; k++) {
        const int i = parts == 1 ? 0 : (k + 1) % 3, j = parts == 1 ? 1 : (k + 2) % 3;
        b[k] = wedge(forms, v->n[i], v->n[j], dn[i], dn[j]);
        db[k] = bat_form_derivative(forms, b[k]);
    }
    const bat_form size = parts == 1 ? b[0] : dot(forms, 3, b, b);
    const bat_form rate = parts == 1 ? db[0] : dot(forms, 3, b, db);
    const bat_form first = bat_form_product(forms, weighted(forms, v, rate, 2, size),
                                            dot(forms, v->dimension, v->n, v->n));
    bat_form second = bat_form_product(forms, size, dot(forms, v->dimension, v->n, dn));
    if (v->w.degree > 0)
        second = bat_form_product(forms, second, v->w);
    return bat_form_sum(forms, first, -3, second);
}

/* What vanishes where curvature does: B in the plane, |B|^2 in space. */
static bat_form bending_size(bat_forms *forms, const velocity *v, const double *direction)
{
    bat_form dn[3], b[3];
    if (v->dimension < 3)
        return bending(forms, v, direction);
    for (int k = 0; k < 3; k++)
        dn[k] = bat_form_derivative(forms, v->n[k]);
    for (int k = 0; k < 3; k++)
        b[k] = wedge(forms, v->n[(k + 1) % 3], v->n[(k + 2) % 3], dn[(k + 1) % 3],
                     dn[(k + 2) % 3]);
    return dot(forms, 3, b, b);
}

/* How fast the curve goes along the direction. */
static bat_form advance(bat_forms *forms, const velocity *v, const double *direction)
{
    const bat_form one = {0, &(double){direction[0]}, 0};
    bat_form sum = bat_form_product(forms, v->n[0], one);
    for (int k = 1; k < v->dimension; k++)
        sum = bat_form_sum(forms, sum, direction[k], v->n[k]);
    return sum;
}

static bat_form speed_squared(bat_forms *forms, const velocity *v, const double *direction)
{
    (void)direction;
    return dot(forms, v->dimension, v->n, v->n);
}

/* The highest degree of any form above is that of the rate of a rational curve in space,
 * 2 (4 p - 2) + p + 4 p - 2 or less; fewer than 80 forms are made on a span. */
enum { FORMS = 96 };

static int highest_degree(const batten_curve *curve)
{
    return 13 * curve->degree;
}

/* What is walked for a question: a form whose changes of sign answer it, or (`touching`) one
 * whose zeros do. */
typedef struct {
    bat_form (*form)(bat_forms *forms, const velocity *v, const double *direction);
    bool touching;
    double direction[3], uncertainty;
} question;

/* ---- zeros, also those without a change of sign ---- */

static bool is_zero(bat_form form, double t)
{
    double value = 0, power = 1;
    const bool late = t > 0.5; /* so that the powers of the smaller one are those that vanish */
    const double x = late ? (1 - t) / t : t / (1 - t);
    for (int k = 0; k <= form.degree; k++, power *= x)
        value += form.c[late ? form.degree - k : k] * power;
    return fabs(value) * bat_pow(late ? t : 1 - t, form.degree) <= 4 * form.error;
}

/* After the turns of a form on a span have been noted, from number `first` on: those at which
 * it vanishes stay, and so do the ends of the span. */
static batten_status keep_zeros(bat_walk *walk, int first, bat_form form, double a, double b)
{
    const int found = walk->count - first;
    if (walk->room < walk->count + 2) {
        double *grown = bat_resize(walk->at, 2 * ((size_t)walk->count + 2), sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        walk->at = grown;
        walk->room = 2 * (walk->count + 2);
    }
    double *at = walk->at + first;
    const bool begins = is_zero(form, 0) && (first == 0 || at[-1] != a);
    int kept = 0;
    for (int i = 0; i < found; i++)
        if (at[i] > a && at[i] < b && is_zero(form, (at[i] - a) / (b - a)))
            at[kept++] = at[i];
    if (begins) {
        memmove(at + 1, at, (size_t)kept++ * sizeof *at);
        at[0] = a;
    }
    if (is_zero(form, 1))
        at[kept++] = b;
    walk->count = first + kept;
    return BATTEN_OK;
}

static batten_status walk_zeros(bat_walk *walk, bat_forms *forms, bat_form form,
                                const bat_span_forms *span)
{
    const int first = walk->count;
    walk->sign = 0; /* ends of spans are looked at by themselves */
    const batten_status status =
        bat_walk_piece(walk, bat_form_derivative(forms, form), span->a, span->b);
    return status == BATTEN_OK ? keep_zeros(walk, first, form, span->a, span->b) : status;
}

/* ---- along the curve ---- */

static batten_status walk_span(bat_walk *walk, bat_forms *forms, int dimension,
                               const question *ask, const bat_span_forms *span)
{
    const velocity v = velocity_of(forms, span, dimension);
    const bat_form form = ask->form(forms, &v, ask->direction);
    return ask->touching ? walk_zeros(walk, forms, form, span)
                         : bat_walk_piece(walk, form, span->a, span->b);
}

static batten_status walk_curve(const batten_curve *curve, const question *ask,
                                batten_parameters *out)
{
    const int p = curve->degree;
    bat_walk walk = {0};
    bat_forms forms = {0};
    bat_span_forms span;
    /* Control points come of sums and rotations at the size of the whole curve, and are right
     * to a few of its roundings, also where a coordinate is nearly 0: what those can make is
     * none.
     */
    const double uncertainty = ask->uncertainty + 4 * DBL_EPSILON * bat_curve_size(curve);
    double *rows = bat_array3((size_t)p + 1, bat_curve_width(curve), sizeof *rows);
    batten_status status =
        rows ? bat_forms_begin(FORMS, highest_degree(curve), &forms) : BATTEN_OUT_OF_MEMORY;
    for (int k = p;
         status == BATTEN_OK && bat_span_forms_next(curve, &k, rows, NULL, &forms, &span);) {
        for (int j = 0; j < curve->dimension; j++)
            span.x[j].error += uncertainty;
        status = walk_span(&walk, &forms, curve->dimension, ask, &span);
    }
    if (status == BATTEN_OK && curve->periodic && !ask->touching)
        status = bat_walk_close(&walk, batten_curve_domain(curve).a);
    if (status == BATTEN_OK) {
        *out = (batten_parameters){walk.count, walk.at};
        walk.at = NULL;
    }
    bat_walk_end(&walk);
    bat_forms_end(&forms);
    bat_release(rows);
    return status;
}

batten_status bat_parameters_merge(const batten_parameters *a, const batten_parameters *b,
                                   batten_interval domain, batten_parameters *out)
{
    /* Places closer than this are one but for rounding. */
    const double apart = 64 * DBL_EPSILON * (domain.b - domain.a);
    double *at = bat_array((size_t)a->count + (size_t)b->count, sizeof *at);
    int count = 0;
    if (!at)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0, j = 0; i < a->count || j < b->count;) {
        const bool first = j == b->count || (i < a->count && a->at[i] <= b->at[j]);
        const double next = first ? a->at[i++] : b->at[j++];
        if (count == 0 || next - at[count - 1] > apart)
            at[count++] = next;
        else if (next == domain.b) /* what all but meets the end is the end */
            at[count - 1] = next;
    }
    *out = (batten_parameters){count, at};
    return BATTEN_OK;
}

batten_status bat_curve_inflections(const batten_curve *curve, double uncertainty,
                                    batten_parameters *out)
{
    if (curve->dimension == 3)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a curve in space has no inflections");
    const question ask = {.form = bending, .uncertainty = uncertainty};
    return walk_curve(curve, &ask, out);
}

batten_status bat_curve_curvature_extrema(const batten_curve *curve, double uncertainty,
                                          batten_parameters *out)
{
    const question ask = {.form = bending_rate, .uncertainty = uncertainty};
    return walk_curve(curve, &ask, out);
}

batten_status batten_curve_inflections(const batten_curve *curve, batten_parameters *out)
{
    return bat_curve_inflections(curve, 0, out);
}

batten_status batten_curve_curvature_extrema(const batten_curve *curve, batten_parameters *out)
{
    return bat_curve_curvature_extrema(curve, 0, out);
}

batten_status batten_curve_turns(const batten_curve *curve, batten_vec3 direction,
                                 batten_parameters *out)
{
    const double along[3] = {direction.x, direction.y, direction.z};
    question ask = {.form = advance};
    const double size = bat_largest(curve->dimension, along);
    if (!isfinite(size) || size == 0 || bat_first_not_finite(along, 3) < 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the direction is (%g, %g, %g)", direction.x,
                        direction.y, direction.z);
    for (int k = 0; k < 3; k++)
        ask.direction[k] = along[k] / size;
    return walk_curve(curve, &ask, out);
}

batten_status batten_curve_flat_points(const batten_curve *curve, batten_parameters *out)
{
    const question ask = {.form = bending_size, .touching = true};
    batten_parameters zeros = {0, NULL}, changes = {0, NULL};
    batten_status status = walk_curve(curve, &ask, &zeros);
    if (status == BATTEN_OK && curve->dimension < 3)
        status = batten_curve_inflections(curve, &changes);
    if (status == BATTEN_OK)
        status = bat_parameters_merge(&changes, &zeros, batten_curve_domain(curve), out);
    bat_release(changes.at);
    bat_release(zeros.at);
    return status;
}

batten_status batten_curve_standstills(const batten_curve *curve, batten_parameters *out)
{
    const question ask = {.form = speed_squared, .touching = true};
    return walk_curve(curve, &ask, out);
}
