/*
 * How far a piece of a curve by its arc length s can be from the quintic with its point, tangent
 * and curvature at both ends.
 *
 * The difference vanishes to the third order at both ends, so that by Rolle's theorem along any
 * fixed direction it is at most h^6 max |x^(6)| max t^3 (1 - t)^3 / 6! = h^6 max |x^(6)| / 46080.
 *
 * With the numerator A and the denominator w of the piece let N = A' w - A w' and G = N . N. Then
 * d/ds = w^2 G^(-1/2) d/du, dx/ds = N G^(-1/2), and by induction
 *
 *     d^n x/ds^n = P[n] w^(n-1) G^(-(3n-2)/2),   P[1] = N,
 *     P[n+1] = P[n]' w G + (n-1) P[n] w' G - (3n-2)/2 P[n] w G'.
 *
 * All of these are polynomials, of which the coefficients of Bernstein bound |P[6]| and w from
 * above and G from below, on eight parts of the piece, so that P[6] and G are taken nearly at one
 * place. Without weights w is 1, of degree 0.
 *
 * A polynomial is kept by its coefficients times the binomial ones: products are convolutions.
 */
#include "shape/near/arc_length_bound.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <string.h>

enum { ORDER = 6, PARTS = 8 };

/* 1 / (6! 64), where t^3 (1 - t)^3 is largest. */
static const double hermite_remainder = 1.0 / 46080;

typedef struct {
    int degree; /* -1: zero */
    double *c;
} polynomial;

typedef struct {
    int dimension;
    double *memory;
    polynomial a[3], w, n[3], g; /* A, w, N, G */
    polynomial wg, turn[2];      /* w G, w' G and w G' */
    polynomial p[3], next, derivative;
} sixth;

static polynomial zero_of(polynomial p, int degree)
{
    p.degree = degree;
    memset(p.c, 0, (size_t)(degree + 1) * sizeof *p.c);
    return p;
}

/* sum += factor a b, where the degree of the sum is that of the product. */
static void add_product(double factor, polynomial a, polynomial b, polynomial *sum)
{
    for (int i = 0; i <= a.degree; i++)
        for (int j = 0; j <= b.degree; j++)
            sum->c[i + j] += factor * a.c[i] * b.c[j];
}

static void differentiate(polynomial p, polynomial *out)
{
    out->degree = p.degree - 1;
    for (int i = 0; i < p.degree; i++)
        out->c[i] = (i + 1) * p.c[i + 1] - (p.degree - i) * p.c[i];
}

/* With c[i] = C(n, i) b[i]: back to b. */
static void take_out_binomials(polynomial *p)
{
    double binomial = 1;
    for (int i = 0; i <= p->degree; i++) {
        p->c[i] /= binomial;
        binomial = binomial * (p->degree - i) / (i + 1);
    }
}

/* Lengths in units of h, from the middle of the end points; weights in units of the largest. */
static void read_piece(sixth *f, const batten_curve *piece, double h)
{
    const int n = piece->degree, d = f->dimension;
    double largest = 0, binomial = 1;
    for (int i = 0; i <= n; i++)
        largest = bat_max(largest, piece->weights ? piece->weights[i] : 1);
    f->w.degree = piece->weights ? n : 0;
    f->w.c[0] = 1;
    for (int i = 0; i <= n; i++) {
        const double weight = piece->weights ? piece->weights[i] / largest : 1;
        if (piece->weights)
            f->w.c[i] = binomial * weight;
        for (int k = 0; k < d; k++) {
            const double middle = piece->points[k] / 2 + piece->points[n * d + k] / 2;
            f->a[k].degree = n;
            f->a[k].c[i] = binomial * weight * ((piece->points[i * d + k] - middle) / h);
        }
        binomial = binomial * (n - i) / (i + 1);
    }
}

/* N: of degree 2p - 2, as the highest terms of A' w and A w' cancel; without weights A'. */
static void find_numerators(sixth *f)
{
    const int n = f->a[0].degree;
    for (int k = 0; k < f->dimension; k++) {
        if (f->w.degree == 0) {
            differentiate(f->a[k], &f->n[k]);
            continue;
        }
        f->n[k] = zero_of(f->n[k], 2 * n - 2);
        for (int i = 0; i <= n; i++)
            for (int j = 0; j <= n; j++)
                if (i != j)
                    f->n[k].c[i + j - 1] += (j - i) * f->a[k].c[j] * f->w.c[i];
    }
    f->g = zero_of(f->g, 2 * f->n[0].degree);
    for (int k = 0; k < f->dimension; k++)
        add_product(1, f->n[k], f->n[k], &f->g);
}

static void find_sixth(sixth *f)
{
    f->wg = zero_of(f->wg, f->w.degree + f->g.degree);
    add_product(1, f->w, f->g, &f->wg);
    differentiate(f->w, &f->derivative);
    f->turn[0] = zero_of(f->turn[0], bat_max_int(0, f->wg.degree - 1));
    add_product(1, f->derivative, f->g, &f->turn[0]);
    differentiate(f->g, &f->derivative);
    f->turn[1] = zero_of(f->turn[1], bat_max_int(0, f->wg.degree - 1));
    add_product(1, f->w, f->derivative, &f->turn[1]);
    for (int k = 0; k < f->dimension; k++) {
        f->p[k].degree = f->n[k].degree;
        memcpy(f->p[k].c, f->n[k].c, (size_t)(f->n[k].degree + 1) * sizeof *f->p[k].c);
        for (int n = 1; n < ORDER; n++) {
            differentiate(f->p[k], &f->derivative);
            f->next = zero_of(f->next, bat_max_int(0, f->p[k].degree + f->wg.degree - 1));
            add_product(1, f->derivative, f->wg, &f->next);
            add_product(n - 1, f->p[k], f->turn[0], &f->next);
            add_product(-(3 * n - 2) / 2.0, f->p[k], f->turn[1], &f->next);
            const polynomial made = f->next;
            f->next = f->p[k];
            f->p[k] = made;
        }
        take_out_binomials(&f->p[k]);
    }
    take_out_binomials(&f->w);
    take_out_binomials(&f->g);
}

/* De Casteljau in place: `part` becomes the part on [0, t], `rest` that on [t, 1]. */
static void split_off(double t, polynomial *rest, polynomial *part)
{
    const int n = rest->degree;
    part->degree = n;
    for (int level = n; level >= 0; level--) {
        part->c[n - level] = rest->c[0];
        for (int i = 0; i < level; i++)
            rest->c[i] = (1 - t) * rest->c[i] + t * rest->c[i + 1];
    }
}

/* max |P[6]| w^5 G^-8 over the next part of the piece, the first of `waiting` equal ones. */
static double largest_on_next_part(sixth *f, int waiting)
{
    const double t = 1.0 / waiting;
    double largest = 0, most_weight = 0, least = INFINITY;
    for (int k = 0; k < f->dimension; k++) /* N is not needed any more */
        split_off(t, &f->p[k], &f->n[k]);
    split_off(t, &f->w, &f->derivative);
    split_off(t, &f->g, &f->next);
    for (int i = 0; i <= f->n[0].degree; i++) {
        double v[3] = {0};
        for (int k = 0; k < f->dimension; k++)
            v[k] = f->n[k].c[i];
        largest = bat_max(largest, bat_norm(f->dimension, v));
    }
    for (int i = 0; i <= f->derivative.degree; i++)
        most_weight = bat_max(most_weight, f->derivative.c[i]);
    for (int i = 0; i <= f->next.degree; i++)
        least = bat_min(least, f->next.c[i]);
    if (!(least > 0))
        return INFINITY;
    const double bound = largest * bat_pow(most_weight, ORDER - 1) / bat_pow(least, 8);
    return isfinite(bound) ? bound : (double)INFINITY;
}

static batten_status make_room(const batten_curve *piece, sixth *f)
{
    polynomial *const all[] = {&f->a[0], &f->a[1],    &f->a[2],    &f->w,
                               &f->n[0], &f->n[1],    &f->n[2],    &f->g,
                               &f->wg,   &f->turn[0], &f->turn[1], &f->p[0],
                               &f->p[1], &f->p[2],    &f->next,    &f->derivative};
    const size_t count = sizeof all / sizeof *all;
    /* P[6] has the highest degree: 27 p - 27, without weights 11 p - 16. */
    const int p = piece->degree, highest = (piece->weights ? 27 : 11) * (p - 1);
    const size_t room = (size_t)bat_max_int(2 * p, highest) + 1;
    f->memory = bat_array3(count, room, sizeof *f->memory);
    for (size_t i = 0; f->memory && i < count; i++)
        all[i]->c = f->memory + i * room;
    return f->memory ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

batten_status bat_arc_length_bound(const batten_curve *piece, double h, double *bound)
{
    sixth f = {.dimension = piece->dimension};
    const batten_status status = make_room(piece, &f);
    if (status != BATTEN_OK)
        return status;
    read_piece(&f, piece, h);
    find_numerators(&f);
    find_sixth(&f);
    double largest = 0;
    for (int waiting = PARTS; waiting > 0; waiting--)
        largest = bat_max(largest, largest_on_next_part(&f, waiting));
    *bound = hermite_remainder * largest * h;
    bat_release(f.memory);
    return BATTEN_OK;
}
