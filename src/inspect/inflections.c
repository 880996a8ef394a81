#include "inspect/inflections.h"
#include "inspect/forms.h"

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
static bat_form bending(bat_forms *forms, const velocity *v)
{
    const bat_form dx = bat_form_derivative(forms, v->n[0]);
    if (v->dimension == 1)
        return weighted(forms, v, dx, -2, v->n[0]);
    return wedge(forms, v->n[0], v->n[1], dx, bat_form_derivative(forms, v->n[1]));
}

/* What has the sign of the derivative of curvature. */
static bat_form bending_rate(bat_forms *forms, const velocity *v)
{
    bat_form dn[3], b[3], db[3];
    if (v->dimension == 1) {
        const bat_form m = bending(forms, v);
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

/* The highest degree of any form above is that of the rate of a rational curve in space,
 * 2 (4 p - 2) + p + 4 p - 2 or less; fewer than 80 forms are made on a span. */
enum { FORMS = 96 };

static int highest_degree(const batten_curve *curve)
{
    return 13 * curve->degree;
}

typedef bat_form (*question)(bat_forms *forms, const velocity *v);

static batten_status walk_curve(const batten_curve *curve, question ask, double uncertainty,
                                batten_parameters *out)
{
    const int p = curve->degree;
    bat_walk walk = {0};
    bat_forms forms = {0};
    bat_span_forms span;
    double *rows = bat_array3((size_t)p + 1, bat_curve_width(curve), sizeof *rows);
    batten_status status =
        rows ? bat_forms_begin(FORMS, highest_degree(curve), &forms) : BATTEN_OUT_OF_MEMORY;
    for (int k = p;
         status == BATTEN_OK && bat_span_forms_next(curve, &k, rows, NULL, &forms, &span);) {
        for (int j = 0; j < curve->dimension; j++)
            span.x[j].error += uncertainty;
        const velocity v = velocity_of(&forms, &span, curve->dimension);
        status = bat_walk_piece(&walk, ask(&forms, &v), span.a, span.b);
    }
    if (status == BATTEN_OK && curve->periodic)
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

batten_status bat_curve_inflections(const batten_curve *curve, double uncertainty,
                                    batten_parameters *out)
{
    if (curve->dimension == 3)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a curve in space has no inflections");
    return walk_curve(curve, bending, uncertainty, out);
}

batten_status bat_curve_curvature_extrema(const batten_curve *curve, double uncertainty,
                                          batten_parameters *out)
{
    return walk_curve(curve, bending_rate, uncertainty, out);
}

batten_status batten_curve_inflections(const batten_curve *curve, batten_parameters *out)
{
    return bat_curve_inflections(curve, 0, out);
}

batten_status batten_curve_curvature_extrema(const batten_curve *curve, batten_parameters *out)
{
    return bat_curve_curvature_extrema(curve, 0, out);
}
