/* The implicit equation of a plane curve as the determinant of Bezout, and its inversion. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/contours.h>

#include <float.h>
#include <string.h>

enum { MOST = BATTEN_IMPLICIT_DEGREE };

/* The matrix is c + x a + y b, row by row, in coordinates relative to `origin` and `size`. */
struct batten_implicit {
    int degree;
    batten_interval domain;
    double origin[2], size;
    double rows[MOST + 1][3]; /* w x, w y, w of the Bezier points in these coordinates */
    double c[MOST * MOST], a[MOST * MOST], b[MOST * MOST];
    double factor; /* so that the largest gradient is 1 */
};

/* ---- the matrix ---- */

/* p_i q_j - p_j q_i for p = X - x W and q = Y - y W: the parts without x and y, with x, with y.
 * The product x y drops out. */
static void bracket(const batten_implicit *f, int i, int j, double out[3])
{
    const double *p = f->rows[i], *q = f->rows[j];
    out[0] = p[0] * q[1] - q[0] * p[1];
    out[1] = q[2] * p[1] - p[2] * q[1];
    out[2] = q[0] * p[2] - p[0] * q[2];
}

/* Entry i, j, counted from 1 as the source does, is `left` times the bracket i, j and `right`
 * times the entry i + 1, j - 1. */
static void set_entry(batten_implicit *f, int i, int j, double left, double right)
{
    const int n = f->degree, at = (i - 1) * n + j - 1;
    double l[3];
    bracket(f, i, j - 1, l);
    const int before = i * n + j - 2;
    f->c[at] = left * l[0] + (right != 0 ? right * f->c[before] : 0);
    f->a[at] = left * l[1] + (right != 0 ? right * f->a[before] : 0);
    f->b[at] = left * l[2] + (right != 0 ? right * f->b[before] : 0);
}

/* Bezout's matrix of p and q in the Bernstein basis of degree n - 1. */
static void fill_bezout(batten_implicit *f)
{
    const int n = f->degree;
    for (int i = 1; i <= n; i++)
        set_entry(f, i, 1, (double)n / i, 0);
    for (int j = 1; j < n; j++) {
        for (int i = 1; i < n; i++)
            set_entry(f, i, j + 1, (double)(n * n) / (i * (n - j)),
                      (double)(j * (n - i)) / (i * (n - j)));
        set_entry(f, n, j + 1, (double)n / (n - j), 0);
    }
}

static void matrix_at(const batten_implicit *f, double x, double y, double *m)
{
    for (int k = 0; k < f->degree * f->degree; k++)
        m[k] = f->c[k] + x * f->a[k] + y * f->b[k];
}

static void swap(double *a, double *b)
{
    const double kept = *a;
    *a = *b;
    *b = kept;
}

/* By elimination with the largest pivot of each column; 0 is a good answer. */
static double determinant(int n, double *m)
{
    double product = 1;
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(m[i * n + k]) > fabs(m[best * n + k]))
                best = i;
        if (m[best * n + k] == 0)
            return 0;
        for (int j = k; j < n && best != k; j++)
            swap(&m[best * n + j], &m[k * n + j]);
        product *= best == k ? m[k * n + k] : -m[k * n + k];
        for (int i = k + 1; i < n; i++) {
            const double share = m[i * n + k] / m[k * n + k];
            for (int j = k + 1; j < n; j++)
                m[i * n + j] -= share * m[k * n + j];
        }
    }
    return product;
}

/* The derivative of a determinant: the sum of those in which one row is derived. */
static double slope(const batten_implicit *f, const double *m, const double *derived)
{
    const int n = f->degree;
    double sum = 0, work[MOST * MOST];
    for (int i = 0; i < n; i++) {
        memcpy(work, m, (size_t)(n * n) * sizeof *m);
        memcpy(work + i * n, derived + i * n, (size_t)n * sizeof *m);
        sum += determinant(n, work);
    }
    return sum;
}

double batten_implicit_value(const batten_implicit *f, double x, double y, double *gradient)
{
    double m[MOST * MOST], work[MOST * MOST];
    matrix_at(f, (x - f->origin[0]) / f->size, (y - f->origin[1]) / f->size, m);
    if (gradient) {
        gradient[0] = f->factor * slope(f, m, f->a);
        gradient[1] = f->factor * slope(f, m, f->b);
    }
    memcpy(work, m, sizeof m);
    return f->factor * f->size * determinant(f->degree, work);
}

/* ---- making one ---- */

/* In as low a degree as the curve has to rounding. */
static batten_status lowest(const batten_curve *curve, batten_curve **out)
{
    const double size = bat_largest(curve->count * 2, curve->points);
    batten_curve *low = NULL;
    batten_status status = batten_curve_clamp(curve, &low);
    while (status == BATTEN_OK && low->degree > 1) {
        batten_curve *lower = NULL;
        const batten_status reduced =
            batten_curve_reduce(low, low->degree - 1, 64 * DBL_EPSILON * size, NULL, &lower);
        if (reduced == BATTEN_OUT_OF_MEMORY)
            status = reduced;
        if (reduced != BATTEN_OK)
            break;
        batten_curve_unref(low);
        low = lower;
    }
    if (status == BATTEN_OK)
        *out = low;
    else
        batten_curve_unref(low);
    return status;
}

static void take_points(const batten_curve *curve, batten_implicit *f)
{
    const batten_box box = batten_curve_box(curve);
    f->domain = batten_curve_domain(curve);
    f->origin[0] = box.low.x + (box.high.x - box.low.x) / 2;
    f->origin[1] = box.low.y + (box.high.y - box.low.y) / 2;
    f->size = bat_max(box.high.x - box.low.x, box.high.y - box.low.y) / 2;
    for (int i = 0; i <= f->degree; i++) {
        const double w = curve->weights ? curve->weights[i] * curve->weight_scale : 1;
        for (int k = 0; k < 2; k++)
            f->rows[i][k] = w * ((curve->points[2 * i + k] - f->origin[k]) / f->size);
        f->rows[i][2] = w;
    }
}

/* Values at places of the curve: f is scaled by the largest gradient. */
static batten_status substitute(const batten_curve *curve, batten_implicit *f,
                                batten_implicit_from_curve_report *report)
{
    const int places = 8 * f->degree;
    double most = 0, least = HUGE_VAL, residual = 0;
    f->factor = 1;
    for (int i = 0; i <= places; i++) {
        const double t = (double)i / places;
        double point[2], gradient[2];
        const batten_status status =
            batten_curve_evaluate(curve, (1 - t) * f->domain.a + t * f->domain.b, 0, point);
        if (status != BATTEN_OK)
            return status;
        residual =
            bat_max(residual, fabs(batten_implicit_value(f, point[0], point[1], gradient)));
        most = bat_max(most, bat_norm(2, gradient));
        least = bat_min(least, bat_norm(2, gradient));
    }
    double entries = 0;
    for (int k = 0; k < f->degree * f->degree; k++)
        entries = bat_max(entries, fabs(f->c[k]) + fabs(f->a[k]) + fabs(f->b[k]));
    /* A determinant of entries that large is 0 when it is below their rounding. */
    if (!(most > 1e-12 * bat_pow(entries, f->degree)))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the equation of the curve vanishes everywhere: the curve is run over "
                        "more than once or its degree %d is too high for it",
                        f->degree);
    f->factor = 1 / most;
    *report = (batten_implicit_from_curve_report){f->degree, residual / most, least / most};
    /* Half of the digits: an equation that keeps fewer does not tell points on from points
     * off. */
    if (report->error > 1e-6 * f->size)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the equation misses its curve by %g",
                        report->error);
    return BATTEN_OK;
}

static batten_status check_curve(const batten_curve *curve)
{
    const int spans = batten_curve_spans(curve, NULL) - 1;
    if (curve->dimension != 2)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "a curve of %d dimensions has no equation in the plane",
                        curve->dimension);
    if (spans != 1)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the curve has %d spans, each with an equation of its own", spans);
    return BATTEN_OK;
}

batten_status batten_implicit_from_curve(const batten_curve *curve,
                                         batten_implicit_from_curve_report *report,
                                         batten_implicit **out)
{
    batten_curve *low = NULL;
    batten_implicit_from_curve_report made;
    batten_status status = check_curve(curve);
    if (status == BATTEN_OK)
        status = lowest(curve, &low);
    if (status != BATTEN_OK)
        return status;
    batten_implicit *f = bat_array(1, sizeof *f);
    if (!f)
        status = BATTEN_OUT_OF_MEMORY;
    else if (low->degree > MOST)
        status = bat_fail(BATTEN_UNSUPPORTED,
                          "curves up to degree %d are made implicit, this one has %d", MOST,
                          low->degree);
    if (status == BATTEN_OK) {
        f->degree = low->degree;
        take_points(low, f);
        if (!(f->size > 0))
            status = bat_fail(BATTEN_COINCIDENT, "the curve is a point");
    }
    if (status == BATTEN_OK) {
        fill_bezout(f);
        status = substitute(low, f, &made);
    }
    batten_curve_unref(low);
    if (status != BATTEN_OK) {
        batten_implicit_free(f);
        return status;
    }
    if (report)
        *report = made;
    *out = f;
    return BATTEN_OK;
}

void batten_implicit_free(batten_implicit *implicit)
{
    bat_release(implicit);
}

/* ---- inversion ---- */

/* One of the vectors v with m v = 0: elimination with the largest pivot of all, the last one
 * taken for 0. v stays 0 when the one before it is lost in rounding too. */
static void null_vector(int n, double *m, double *v)
{
    int order[MOST];
    double first = 0;
    for (int j = 0; j < n; j++)
        order[j] = j;
    for (int k = 0; k + 1 < n; k++) {
        int row = k, column = k;
        for (int i = k; i < n; i++)
            for (int j = k; j < n; j++)
                if (fabs(m[i * n + j]) > fabs(m[row * n + column])) {
                    row = i;
                    column = j;
                }
        for (int j = 0; j < n; j++)
            swap(&m[row * n + j], &m[k * n + j]);
        for (int i = 0; i < n; i++)
            swap(&m[i * n + column], &m[i * n + k]);
        const int kept = order[k];
        order[k] = order[column];
        order[column] = kept;
        first = bat_max(first, fabs(m[k * n + k]));
        /* The null space has more than one vector when a pivot before the last vanishes: six
         * digits are left for rounding. */
        if (!(fabs(m[k * n + k]) > 1e-9 * first))
            return;
        for (int i = k + 1; i < n; i++)
            for (int j = n - 1; j >= k; j--)
                m[i * n + j] -= m[i * n + k] / m[k * n + k] * m[k * n + j];
    }
    double x[MOST] = {0};
    x[n - 1] = 1;
    for (int i = n - 2; i >= 0; i--) {
        double sum = 0;
        for (int j = i + 1; j < n; j++)
            sum += m[i * n + j] * x[j];
        x[i] = -sum / m[i * n + i];
    }
    for (int j = 0; j < n; j++)
        v[order[j]] = x[j];
}

/* p and q at t by de Casteljau, also outside [0, 1]; how far the curve is from the point. */
static double miss_at(const batten_implicit *f, double t, double x, double y)
{
    double rows[MOST + 1][3];
    memcpy(rows, f->rows, sizeof rows);
    for (int r = 1; r <= f->degree; r++)
        for (int i = 0; i <= f->degree - r; i++)
            for (int k = 0; k < 3; k++)
                rows[i][k] = (1 - t) * rows[i][k] + t * rows[i + 1][k];
    const double *at = rows[0];
    return bat_hypot(at[0] / at[2] - x, at[1] / at[2] - y);
}

/* A line: p and q are linear in t. */
static double invert_line(const batten_implicit *f, double x, double y)
{
    const double *a = f->rows[0], *b = f->rows[1];
    const double p[2] = {a[0] - x * a[2], b[0] - x * b[2]};
    const double q[2] = {a[1] - y * a[2], b[1] - y * b[2]};
    const double *use = fabs(p[0] - p[1]) > fabs(q[0] - q[1]) ? p : q;
    return use[0] / (use[0] - use[1]);
}

batten_status batten_implicit_invert(const batten_implicit *f, double x, double y, double *u)
{
    const int n = f->degree;
    const double xi = (x - f->origin[0]) / f->size, eta = (y - f->origin[1]) / f->size;
    double m[MOST * MOST], v[MOST] = {0}, sum = 0, first = 0, t;
    matrix_at(f, xi, eta, m);
    if (n == 1) {
        t = invert_line(f, xi, eta);
    } else {
        null_vector(n, m, v);
        for (int j = 0; j < n; j++) { /* in the basis of degree n - 1 t is sum j v / (n - 1) */
            sum += v[j];
            first += j * v[j] / (n - 1);
        }
        t = first / sum;
    }
    /* Half of the digits, as for the equation; NaN of a t that is none misses too. */
    if (!(miss_at(f, t, xi, eta) <= 1e-6))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "(%g, %g) has no one parameter: it is not on the curve, or the curve "
                        "crosses itself there",
                        x, y);
    *u = f->domain.a + t * (f->domain.b - f->domain.a);
    return BATTEN_OK;
}
