/* Polynomials in Bernstein form with bounds on their rounding, and a walk over their signs. */
#include "inspect/forms.h"

#include <float.h>
#include <string.h>

/* ---- arithmetic ---- */

batten_status bat_forms_begin(int form_count, int highest_degree, bat_forms *out)
{
    const size_t room = (size_t)form_count * ((size_t)highest_degree + 1);
    double *memory = bat_array(room, sizeof *memory);
    if (!memory)
        return BATTEN_OUT_OF_MEMORY;
    *out = (bat_forms){memory, 0, room};
    return BATTEN_OK;
}

void bat_forms_end(bat_forms *forms)
{
    bat_release(forms->memory);
    *forms = (bat_forms){0};
}

static bat_form take_form(bat_forms *forms, int degree)
{
    assert(forms->used + (size_t)degree + 1 <= forms->room);
    bat_form form = {degree, forms->memory + forms->used, 0};
    forms->used += (size_t)degree + 1;
    memset(form.c, 0, ((size_t)degree + 1) * sizeof *form.c);
    return form;
}

/* binomial(n, k + 1) from binomial(n, k) */
static double next_binomial(int n, int k, double binomial)
{
    return binomial * (n - k) / (k + 1);
}

static double largest_coefficient(bat_form a)
{
    double largest = 0, binomial = 1;
    for (int k = 0; k <= a.degree; k++) {
        largest = bat_max(largest, fabs(a.c[k]) / binomial);
        binomial = next_binomial(a.degree, k, binomial);
    }
    return largest;
}

bat_form bat_form_product(bat_forms *forms, bat_form a, bat_form b)
{
    const double large_a = largest_coefficient(a), large_b = largest_coefficient(b);
    bat_form out = take_form(forms, a.degree + b.degree);
    for (int i = 0; i <= a.degree; i++)
        for (int j = 0; j <= b.degree; j++)
            out.c[i + j] += a.c[i] * b.c[j];
    const int terms = bat_min_int(a.degree, b.degree) + 1;
    out.error = large_a * b.error + large_b * a.error + a.error * b.error +
                (terms + 1) * DBL_EPSILON * large_a * large_b;
    return out;
}

/* Times ((1 - t) + t)^by, each power one addition of neighbours. */
static bat_form elevated(bat_forms *forms, bat_form a, int by)
{
    bat_form out = take_form(forms, a.degree + by);
    memcpy(out.c, a.c, ((size_t)a.degree + 1) * sizeof *a.c);
    for (int n = a.degree; n < out.degree; n++)
        for (int k = n + 1; k > 0; k--)
            out.c[k] += out.c[k - 1];
    out.error = a.error + by * DBL_EPSILON * largest_coefficient(a);
    return out;
}

bat_form bat_form_sum(bat_forms *forms, bat_form a, double factor, bat_form b)
{
    const int degree = bat_max_int(a.degree, b.degree);
    const bat_form high_a = elevated(forms, a, degree - a.degree);
    const bat_form high_b = elevated(forms, b, degree - b.degree);
    bat_form out = take_form(forms, degree);
    for (int k = 0; k <= degree; k++)
        out.c[k] = high_a.c[k] + factor * high_b.c[k];
    out.error =
        high_a.error + fabs(factor) * high_b.error +
        2 * DBL_EPSILON * (largest_coefficient(a) + fabs(factor) * largest_coefficient(b));
    return out;
}

bat_form bat_form_derivative(bat_forms *forms, bat_form a)
{
    const int n = a.degree;
    bat_form out = take_form(forms, bat_max_int(n - 1, 0));
    for (int k = 0; k < n; k++)
        out.c[k] = (k + 1) * a.c[k + 1] - (n - k) * a.c[k];
    out.error = 2 * n * (a.error + DBL_EPSILON * largest_coefficient(a));
    return out;
}

/* ---- spans ---- */

bool bat_span_forms_next(const batten_curve *curve, int *k, double *rows, const double *origin,
                         bat_forms *forms, bat_span_forms *out)
{
    const int p = curve->degree, d = curve->dimension;
    const size_t width = bat_curve_width(curve);
    while (*k < curve->count && curve->knots[*k] == curve->knots[*k + 1])
        ++*k;
    if (*k >= curve->count)
        return false;
    const double *points = curve->points + (size_t)(*k - p) * (size_t)d;
    const double *from = origin ? origin : points;
    for (int i = 0; i <= p; i++) {
        const double w = curve->weights ? curve->weights[*k - p + i] * curve->weight_scale : 1;
        for (int j = 0; j < d; j++)
            rows[(size_t)i * width + (size_t)j] = w * (points[i * d + j] - from[j]);
        if (curve->weights)
            rows[(size_t)i * width + (size_t)d] = w;
    }
    bat_piece_from_rows(p, curve->knots, *k, width, rows);
    forms->used = 0;
    *out = (bat_span_forms){.a = curve->knots[*k], .b = curve->knots[*k + 1]};
    for (int j = 0; j <= d; j++) {
        bat_form form = take_form(forms, j < d || curve->weights ? p : 0);
        for (int i = 0; i <= form.degree; i++)
            form.c[i] = (j < (int)width ? rows[(size_t)i * width + (size_t)j] : 1) *
                        bat_binomials[form.degree][i];
        /* Coordinates are known to their last place; each of the p levels that lead to Bezier
         * rows is a convex combination. */
        form.error = j < (int)width ? 4 * p * DBL_EPSILON * largest_coefficient(form) : 0;
        for (int i = 0; j < d && i <= p; i++)
            form.error = bat_max(form.error, DBL_EPSILON * fabs(points[i * d + j]));
        *(j < d ? &out->x[j] : &out->w) = form;
    }
    ++*k;
    return true;
}

/* ---- sign changes ---- */

/* Deeper than this halves are narrower than the rounding of t. */
enum { DEPTH = 48 };

static batten_status note_sign(bat_walk *walk, double at, int sign)
{
    const bool change = walk->sign != 0 && sign != walk->sign;
    const bool wanted = change && (sign > 0 || !walk->only_rising);
    if (wanted && walk->count == walk->room) {
        const int more = bat_max_int(16, 2 * walk->room);
        double *grown = bat_resize(walk->at, (size_t)more, sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        walk->at = grown;
        walk->room = more;
    }
    if (wanted)
        walk->at[walk->count++] = at;
    if (walk->first == 0)
        walk->first = sign;
    walk->sign = sign;
    return BATTEN_OK;
}

/* de Casteljau at t: `left` becomes the coefficients before t, `right` (if any) those behind.
 */
static double split_form(int n, double *left, double *right, double t)
{
    if (right)
        right[n] = left[n];
    for (int r = 1; r <= n; r++) {
        for (int k = n; k >= r; k--)
            left[k] = (1 - t) * left[k - 1] + t * left[k];
        if (right)
            right[n - r] = left[n];
    }
    return left[n];
}

static double value_at(int n, const double *c, double *work, double t)
{
    memcpy(work, c, ((size_t)n + 1) * sizeof *c);
    return split_form(n, work, NULL, t);
}

/* The one root in [0, 1] of a polynomial with the sign `first` after 0 and the other before 1:
 * two steps of secants, then the middle, and again. `zero`: smaller coefficients are roundoff.
 */
static double find_root(int n, const double *c, double zero, double *work, int first)
{
    double low = 0, high = 1;
    double at_low = fabs(c[0]) > zero ? c[0] : first * zero;
    double at_high = fabs(c[n]) > zero ? c[n] : -first * zero;
    for (int k = 0; k < 3 * DEPTH && high - low > DBL_EPSILON * high; k++) {
        const double secant = low - at_low * ((high - low) / (at_high - at_low));
        const bool use = k % 3 != 2 && secant > low && secant < high;
        const double t = use ? secant : low + (high - low) / 2;
        const double value = value_at(n, c, work, t);
        if (value == 0 || t == low || t == high)
            return t;
        if ((value > 0) == (first > 0)) {
            low = t;
            at_low = value;
        } else {
            high = t;
            at_high = value;
        }
    }
    return low + (high - low) / 2;
}

typedef struct {
    int first, last, variations;
} signs;

static signs signs_of(int n, const double *c, double zero)
{
    signs s = {0, 0, 0};
    for (int k = 0; k <= n; k++) {
        if (fabs(c[k]) <= zero)
            continue;
        const int sign = c[k] > 0 ? 1 : -1;
        if (s.first == 0)
            s.first = sign;
        s.variations += s.last != 0 && sign != s.last;
        s.last = sign;
    }
    return s;
}

/* Room for DEPTH waiting halves, and one for values. */
static batten_status make_room(bat_walk *walk, int width)
{
    if (walk->width >= width)
        return BATTEN_OK;
    double *grown = bat_resize(walk->halves, (size_t)width * (DEPTH + 3), sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    walk->halves = grown;
    walk->width = width;
    return BATTEN_OK;
}

/* Coefficients that are roundoff become 0: near an end where several of them are, the value of
 * the polynomial has no sign otherwise, and a root is found there that is none. */
static void clear_roundoff(int n, double *c, double zero)
{
    for (int k = 0; k <= n; k++)
        if (fabs(c[k]) <= zero)
            c[k] = 0;
}

/* Halve until a half has at most one variation of sign, hence (Descartes) at most one root. A
 * half as narrow as rounding counts by the signs at its ends. */
static batten_status walk_halves(bat_walk *walk, int n, double zero, double a, double b)
{
    const size_t width = (size_t)n + 1;
    double *work = walk->halves + width * (DEPTH + 2);
    double low[DEPTH + 2] = {0};
    int depth[DEPTH + 2] = {0}, waiting = 1;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && waiting > 0) {
        double *c = walk->halves + width * (size_t)--waiting;
        const double at = low[waiting], size = ldexp(1, -depth[waiting]);
        const signs s = signs_of(n, c, zero);
        if (s.variations >= 2 && depth[waiting] < DEPTH) {
            double *left = c + width;
            memcpy(left, c, width * sizeof *c);
            split_form(n, left, c, 0.5);
            depth[waiting + 1] = ++depth[waiting];
            low[waiting + 1] = at;
            low[waiting] = at + size / 2;
            waiting += 2;
            continue;
        }
        if (s.first != 0)
            status = note_sign(walk, a + (b - a) * at, s.first);
        if (status == BATTEN_OK && s.first != s.last) {
            clear_roundoff(n, c, zero);
            const double t = s.variations == 1 ? find_root(n, c, zero, work, s.first) : 0.5;
            status = note_sign(walk, a + (b - a) * (at + size * t), s.last);
        }
    }
    return status;
}

batten_status bat_walk_piece(bat_walk *walk, bat_form form, double a, double b)
{
    const int n = form.degree;
    batten_status status = make_room(walk, n + 1);
    if (status != BATTEN_OK)
        return status;
    double binomial = 1;
    for (int k = 0; k <= n; k++) {
        walk->halves[k] = form.c[k] / binomial;
        binomial = next_binomial(n, k, binomial);
    }
    return walk_halves(walk, n, 4 * form.error, a, b);
}

batten_status bat_walk_close(bat_walk *walk, double start)
{
    const int before = walk->count;
    batten_status status = walk->first == 0 ? BATTEN_OK : note_sign(walk, start, walk->first);
    if (status == BATTEN_OK && walk->count > before) {
        memmove(walk->at + 1, walk->at, (size_t)before * sizeof *walk->at);
        walk->at[0] = start;
    }
    return status;
}

void bat_walk_end(bat_walk *walk)
{
    bat_release(walk->at);
    bat_release(walk->halves);
    *walk = (bat_walk){0};
}
