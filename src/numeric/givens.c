/*
 * Least squares with banded rows by Givens rotations, one row at a time, also where the
 * unknowns form a ring; and the band of the inverse of R^T R, after [HdH85].
 */
#include "numeric/givens.h"

#include <float.h>
#include <string.h>

static size_t stride_of(const bat_givens *qr)
{
    return (size_t)qr->width + (size_t)qr->border + qr->rights;
}

batten_status bat_givens_begin(int count, int width, bool ring, size_t rights, bat_givens *out)
{
    /* A row that wraps reaches both ends; with a border of width - 1 its part in the band
     * begins at 0. A ring that is too short for this is all border. */
    const int border = !ring ? 0 : count < 2 * width ? count : width - 1;
    bat_givens qr = {count, count - border, width, border, rights,
                     NULL,  NULL,           NULL,  NULL,   NULL};
    const size_t stride = stride_of(&qr);
    qr.band = bat_array3((size_t)qr.inner, stride, sizeof *qr.band);
    qr.corner = bat_array3((size_t)border, (size_t)border + rights, sizeof *qr.corner);
    qr.sizes = bat_array((size_t)count, sizeof *qr.sizes);
    qr.filled = bat_array((size_t)qr.inner, sizeof *qr.filled);
    qr.row = bat_array(stride + (size_t)width, sizeof *qr.row);
    if (qr.band && qr.corner && qr.sizes && qr.filled && qr.row) {
        *out = qr;
        return BATTEN_OK;
    }
    bat_givens_end(&qr);
    return BATTEN_OUT_OF_MEMORY;
}

void bat_givens_clear(bat_givens *qr)
{
    const size_t border = (size_t)qr->border;
    memset(qr->band, 0, (size_t)qr->inner * stride_of(qr) * sizeof *qr->band);
    memset(qr->corner, 0, border * (border + qr->rights) * sizeof *qr->corner);
    memset(qr->sizes, 0, (size_t)qr->count * sizeof *qr->sizes);
    memset(qr->filled, 0, (size_t)qr->inner * sizeof *qr->filled);
}

void bat_givens_end(bat_givens *qr)
{
    bat_release(qr->band);
    bat_release(qr->corner);
    bat_release(qr->sizes);
    bat_release(qr->filled);
    bat_release(qr->row);
    *qr = (bat_givens){0};
}

int bat_givens_place(const bat_givens *qr, int first)
{
    /* Rows that begin in the border come first: their band, if any, begins at 0. */
    return first >= qr->inner ? first - qr->inner : first + qr->border;
}

/* ---- adding rows ---- */

typedef struct {
    double c, s;
} rotation;

/* Makes row[0] vanish against above[0], which grows. */
static rotation begin_rotation(double *above, double *row)
{
    const double r = bat_max(fabs(above[0]), fabs(row[0])) < 0x1p500
                         ? sqrt(above[0] * above[0] + row[0] * row[0])
                         : bat_hypot(above[0], row[0]);
    /* Squares that vanish together are left to hypot. */
    const double size = r > 0x1p-500 ? r : bat_hypot(above[0], row[0]);
    const rotation by = {above[0] / size, row[0] / size};
    above[0] = size;
    row[0] = 0;
    return by;
}

static void rotate(rotation by, size_t count, double *above, double *row)
{
    for (size_t k = 0; k < count; k++) {
        const double a = above[k], b = row[k];
        above[k] = by.c * a + by.s * b;
        row[k] = by.c * b - by.s * a;
    }
}

static void add_to_corner(bat_givens *qr)
{
    const size_t n = (size_t)qr->border, stride = n + qr->rights;
    double *row = qr->row + 2 * qr->width;
    for (size_t b = 0; b < n; b++)
        if (row[b] != 0) {
            double *above = qr->corner + b * stride + b;
            const rotation by = begin_rotation(above, row + b);
            rotate(by, stride - b - 1, above + 1, row + b + 1);
        }
}

static bool all_zero(size_t count, const double *numbers)
{
    for (size_t k = 0; k < count; k++)
        if (numbers[k] != 0)
            return false;
    return true;
}

/* The part of the row in the band begins at column `at`. What is left of it slides through the
 * first 2 width numbers, and goes back to their beginning when it has reached their end. */
static void add_row(bat_givens *qr, int at)
{
    const size_t w = (size_t)qr->width, stride = stride_of(qr);
    double *row = qr->row, *rest = qr->row + 2 * w;
    for (int i = at; i < qr->inner && !all_zero(w, row); i++, row++) {
        double *above = qr->band + (size_t)i * stride;
        if (row == qr->row + w) {
            memcpy(qr->row, row, w * sizeof *row);
            memset(qr->row + w, 0, w * sizeof *row);
            row = qr->row;
        }
        if (row[0] == 0)
            continue;
        if (!qr->filled[i]) {
            memcpy(above, row, w * sizeof *row);
            memcpy(above + w, rest, (stride - w) * sizeof *row);
            qr->filled[i] = true;
            return;
        }
        const rotation by = begin_rotation(above, row);
        rotate(by, w - 1, above + 1, row + 1);
        rotate(by, stride - w, above + w, rest);
    }
    add_to_corner(qr);
}

void bat_givens_add(bat_givens *qr, int first, int length, const double *values, double factor,
                    const double *right)
{
    double *row = qr->row, *border = row + 2 * qr->width, *rights = border + qr->border;
    memset(row, 0, (stride_of(qr) + (size_t)qr->width) * sizeof *row);
    int at = qr->inner;
    for (int i = 0, j = first; i < length; i++, j++) {
        if (j >= qr->count)
            j -= qr->count;
        if (values[i] == 0)
            continue;
        const double value = factor * values[i];
        qr->sizes[j] += value * value;
        if (j >= qr->inner) {
            border[j - qr->inner] += value;
            continue;
        }
        at = bat_min_int(at, j);
        row[j - at] = value;
    }
    for (size_t k = 0; k < qr->rights; k++)
        rights[k] = factor * right[k];
    add_row(qr, at);
}

/* ---- solving ---- */

static double diagonal(const bat_givens *qr, int i)
{
    const size_t n = (size_t)qr->border, b = (size_t)(i - qr->inner);
    return i < qr->inner ? qr->band[(size_t)i * stride_of(qr)]
                         : qr->corner[b * (n + qr->rights) + b];
}

batten_status bat_givens_check(const bat_givens *qr, int *unknown)
{
    for (int i = 0; i < qr->count; i++) {
        const double pivot = fabs(diagonal(qr, i)), size = sqrt(qr->sizes[i]);
        *unknown = i;
        if (!isfinite(pivot) || !isfinite(size))
            return bat_fail(BATTEN_OVERFLOW, "the equations of unknown %d leave the numbers",
                            i + 1);
        /* A column is turned about as often as the band is wide, and rounded each time. */
        if (!(pivot > 4 * (qr->width + qr->border) * DBL_EPSILON * size))
            return bat_fail(BATTEN_SINGULAR_SYSTEM,
                            "unknown %d of %d is not determined: %g of its %g is left", i + 1,
                            qr->count, pivot, size);
    }
    return BATTEN_OK;
}

static void subtract(size_t width, double factor, const double *from, double *row)
{
    for (size_t k = 0; k < width; k++)
        row[k] -= factor * from[k];
}

void bat_givens_solve_upper(const bat_givens *qr, size_t width, double *b)
{
    const int n = qr->inner;
    const size_t stride = stride_of(qr), corner = (size_t)qr->border + qr->rights;
    for (int i = qr->count - 1; i >= 0; i--) {
        const double *row =
            i < n ? qr->band + (size_t)i * stride : qr->corner + (size_t)(i - n) * corner - n;
        double *x = b + (size_t)i * width;
        if (i < n) {
            for (int k = 1; k < qr->width && i + k < n; k++)
                subtract(width, row[k], b + (size_t)(i + k) * width, x);
            for (int k = 0; k < qr->border; k++)
                subtract(width, row[qr->width + k], b + (size_t)(n + k) * width, x);
        } else {
            for (int k = i + 1; k < qr->count; k++)
                subtract(width, row[k], b + (size_t)k * width, x);
        }
        for (size_t k = 0; k < width; k++)
            x[k] /= i < n ? row[0] : row[i];
    }
}

void bat_givens_solve_lower(const bat_givens *qr, size_t width, double *b)
{
    const int n = qr->inner;
    const size_t stride = stride_of(qr), corner = (size_t)qr->border + qr->rights;
    for (int i = 0; i < qr->count; i++) {
        const double *row =
            i < n ? qr->band + (size_t)i * stride : qr->corner + (size_t)(i - n) * corner - n;
        double *x = b + (size_t)i * width;
        for (size_t k = 0; k < width; k++)
            x[k] /= i < n ? row[0] : row[i];
        if (i < n) {
            for (int k = 1; k < qr->width && i + k < n; k++)
                subtract(width, row[k], x, b + (size_t)(i + k) * width);
            for (int k = 0; k < qr->border; k++)
                subtract(width, row[qr->width + k], x, b + (size_t)(n + k) * width);
        } else {
            for (int k = i + 1; k < qr->count; k++)
                subtract(width, row[k], x, b + (size_t)k * width);
        }
    }
}

void bat_givens_solve(const bat_givens *qr, double *x)
{
    const size_t r = qr->rights, stride = stride_of(qr), border = (size_t)qr->border;
    for (int i = 0; i < qr->inner; i++)
        memcpy(x + (size_t)i * r, qr->band + (size_t)i * stride + (size_t)qr->width + border,
               r * sizeof *x);
    for (size_t i = 0; i < border; i++)
        memcpy(x + ((size_t)qr->inner + i) * r, qr->corner + i * (border + r) + border,
               r * sizeof *x);
    bat_givens_solve_upper(qr, r, x);
}

/* ---- the band of the inverse ---- */

/* Column c of R^-T. */
static void invert_transposed(const bat_givens *qr, int c, double *out)
{
    const int n = qr->border;
    const size_t stride = (size_t)n + qr->rights;
    for (int i = c; i < n; i++) {
        double sum = i == c;
        for (int k = c; k < i; k++)
            sum -= qr->corner[(size_t)k * stride + (size_t)i] * out[k * n + c];
        out[i * n + c] = sum / qr->corner[(size_t)i * stride + (size_t)i];
    }
}

/* Column c by R^-1, in place. */
static void solve_corner(const bat_givens *qr, int c, double *out)
{
    const int n = qr->border;
    for (int i = n - 1; i >= 0; i--) {
        const double *r = qr->corner + (size_t)i * ((size_t)n + qr->rights);
        double sum = i < c ? 0 : out[i * n + c];
        for (int k = i + 1; k < n; k++)
            sum -= r[k] * out[k * n + c];
        out[i * n + c] = sum / r[i];
    }
}

/* The inverse of the corner's R^T R by solving for the unit vectors. */
static void invert_corner(const bat_givens *qr, double *out)
{
    for (int c = 0; c < qr->border; c++) {
        invert_transposed(qr, c, out);
        solve_corner(qr, c, out);
    }
}

/* Element (i, j) of the inverse; both in the band no farther apart than its width, and those of
 * the rows after the one that is being made. */
static double element(const bat_inverse_band *v, int i, int j)
{
    const int low = bat_min_int(i, j), high = bat_max_int(i, j), n = v->inner;
    if (low >= n)
        return v->corner[(low - n) * v->border + high - n];
    const double *row = v->band + (size_t)low * (size_t)(v->width + v->border);
    return high < n ? row[high - low] : row[v->width + high - n];
}

/* Row i of R times column j of the inverse is 1 / R_ii on the diagonal and 0 to its right. */
static void inverse_row(const bat_givens *qr, const bat_inverse_band *v, int i)
{
    const int n = qr->inner, w = qr->width, last = bat_min_int(n - 1, i + w - 1);
    const double *r = qr->band + (size_t)i * stride_of(qr);
    double *out = v->band + (size_t)i * (size_t)(w + v->border);
    for (int j = qr->count - 1; j >= i; j--) {
        j = j < n ? bat_min_int(j, last) : j;
        double sum = j == i ? 1 / r[0] : 0;
        for (int k = i + 1; k <= last; k++)
            sum -= r[k - i] * element(v, k, j);
        for (int k = 0; k < v->border; k++)
            sum -= r[w + k] * element(v, n + k, j);
        out[j < n ? j - i : w + j - n] = sum / r[0];
    }
}

batten_status bat_inverse_band_make(const bat_givens *qr, bat_inverse_band *out)
{
    bat_inverse_band v = {qr->count, qr->inner, qr->width, qr->border, NULL, NULL};
    v.band = bat_array3((size_t)v.inner, (size_t)(v.width + v.border), sizeof *v.band);
    v.corner = bat_array3((size_t)v.border, (size_t)v.border, sizeof *v.corner);
    if (!v.band || !v.corner) {
        bat_inverse_band_free(&v);
        return BATTEN_OUT_OF_MEMORY;
    }
    invert_corner(qr, v.corner);
    for (int i = v.inner - 1; i >= 0; i--)
        inverse_row(qr, &v, i);
    *out = v;
    return BATTEN_OK;
}

void bat_inverse_band_free(bat_inverse_band *inverse)
{
    bat_release(inverse->band);
    bat_release(inverse->corner);
    *inverse = (bat_inverse_band){0};
}

double bat_inverse_band_form(const bat_inverse_band *v, int first, int length,
                             const double *values)
{
    double sum = 0;
    for (int a = 0; a < length; a++)
        for (int b = 0; b <= a; b++) {
            const double term = values[a] * values[b] *
                                element(v, (first + a) % v->count, (first + b) % v->count);
            sum += a == b ? term : 2 * term;
        }
    return sum;
}
