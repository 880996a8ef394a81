/*
 * Polynomials on one span in Bernstein form, with a bound on their roundoff, and where
 * piecewise polynomials change sign.
 *
 * What is asked of a curve (is it inflected, where is curvature extreme, where is it nearest)
 * is where some polynomial in its coordinates changes sign. The polynomial is computed exactly
 * but for rounding, which each step bounds; coefficients below the bound count as zero. So a
 * straight piece, an arc, the calm end of a natural spline do not show sign changes made of
 * roundoff.
 */
#ifndef BAT_FORMS_H
#define BAT_FORMS_H
#include "spline/curve/curve.h"
#include <batten/curvature.h>

/* Coefficient k is that of Bernstein times binomial(degree, k): so a product is a convolution.
 */
typedef struct {
    int degree;
    double *c;    /* [degree + 1] */
    double error; /* of the Bernstein coefficients */
} bat_form;

/* Where forms live. One memory, used up by the forms of a span and reset for the next. */
typedef struct {
    double *memory;
    size_t used, room;
} bat_forms;

batten_status bat_forms_begin(int form_count, int highest_degree, bat_forms *out);
void bat_forms_end(bat_forms *forms);

bat_form bat_form_product(bat_forms *forms, bat_form a, bat_form b);
/* a + factor b, of any degrees */
bat_form bat_form_sum(bat_forms *forms, bat_form a, double factor, bat_form b);
/* With respect to the t of the span, which runs from 0 to 1. */
bat_form bat_form_derivative(bat_forms *forms, bat_form a);

/* A curve on one span: its homogeneous coordinates relative to `origin`, w last; w is the form
 * 1 of degree 0 when the curve is polynomial. */
typedef struct {
    double a, b; /* the span */
    bat_form x[3], w;
} bat_span_forms;
/* The next non-empty span at or after index *k, which moves behind it; false behind the last.
 * `rows` [p + 1][width]; `origin` [d] or NULL for the first point of the span. */
bool bat_span_forms_next(const batten_curve *curve, int *k, double *rows, const double *origin,
                         bat_forms *forms, bat_span_forms *out);

/* A walk along a piecewise polynomial that notes where it changes sign. Begins with {0}. */
typedef struct {
    bool only_rising; /* note changes from below to above 0 only */
    int first, sign;  /* the first and the last one seen, 0 before that */
    int count, room;
    double *at;
    double *halves; /* for subdivision */
    int width;
} bat_walk;

/* The next piece, over [a, b]. The form is spoilt. */
batten_status bat_walk_piece(bat_walk *walk, bat_form form, double a, double b);
/* The way closes: a change of sign from its end to its beginning is noted there, as the first.
 */
batten_status bat_walk_close(bat_walk *walk, double start);
void bat_walk_end(bat_walk *walk);

#endif
