/* The canonical form of a polynomial span under affine maps and changes of its parameter. */
#include "inspect/affine/exact_span.h"
#include "numeric/dense.h"
#include "numeric/vector.h"
#include <batten/invariants.h>

#include <string.h>

enum { POWERS = BATTEN_MAX_DEGREE + 1, EFFORT = 100000000 };

/* Rows of powers of u; constants are of no interest. */
typedef struct {
    int n, rows;
    double a[3][POWERS];
} shape_table;

/* ---- dimension ---- */

static double row_norm(const shape_table *t, int row)
{
    return bat_norm(t->n, t->a[row] + 1);
}

/* Make the rows square to each other and of length one; those that are lost in the tolerance
 * go. Then what is said about columns does not depend on the affine frame. *margin: the
 * shortest row kept, by what it was; *neglected: the longest that went. */
static void make_square(shape_table *t, double tolerance, double *margin, double *neglected)
{
    double scale[3], largest = 0;
    int kept = 0;
    for (int k = 0; k < t->rows; k++)
        largest = bat_max(largest, scale[k] = row_norm(t, k));
    *margin = 1;
    *neglected = 0;
    for (int k = 0; k < t->rows; k++)
        for (int j = 0; j < POWERS && scale[k] > 0; j++)
            t->a[k][j] /= scale[k];
    while (kept < t->rows) {
        int best = kept;
        for (int k = kept; k < t->rows; k++)
            best = row_norm(t, k) > row_norm(t, best) ? k : best;
        const double length = row_norm(t, best), part = bat_min(length, scale[best] / largest);
        if (!(largest > 0) || part <= tolerance) {
            *neglected = largest > 0 ? part : 0;
            break;
        }
        double swapped[POWERS];
        memcpy(swapped, t->a[best], sizeof swapped);
        memcpy(t->a[best], t->a[kept], sizeof swapped);
        memcpy(t->a[kept], swapped, sizeof swapped);
        scale[best] = scale[kept];
        *margin = bat_min(*margin, length);
        for (int j = 0; j < POWERS; j++)
            t->a[kept][j] /= length;
        for (int k = kept + 1; k < t->rows; k++)
            for (int pass = 0; pass < 2; pass++) { /* twice is enough: [GVL13] 5.2.9 */
                const double along = bat_dot(t->n, t->a[k] + 1, t->a[kept] + 1);
                for (int j = 0; j < POWERS; j++)
                    t->a[k][j] -= along * t->a[kept][j];
            }
        kept++;
    }
    t->rows = kept;
}

/* ---- pivots ---- */

/* From the right, each column that does not depend on those found before. */
static void find_pivots(const shape_table *t, double tolerance, batten_canonical *out)
{
    double basis[3][3];
    int found = 0;
    for (int j = t->n; j > 0 && found < t->rows; j--) {
        double v[3] = {0};
        for (int k = 0; k < t->rows; k++)
            v[k] = t->a[k][j];
        for (int pass = 0; pass < 2; pass++)
            for (int i = 0; i < found; i++) {
                const double along = bat_dot(t->rows, v, basis[i]);
                for (int k = 0; k < t->rows; k++)
                    v[k] -= along * basis[i][k];
            }
        const double size = bat_norm(t->rows, v);
        if (size <= tolerance) {
            out->neglected = bat_max(out->neglected, size);
            continue;
        }
        out->margin = bat_min(out->margin, size);
        for (int k = 0; k < t->rows; k++)
            basis[found][k] = v[k] / size;
        out->pivots[t->rows - 1 - found++] = j;
    }
}

/* Row k becomes u^(j_k) and lower powers, without those of the other pivots. */
static batten_status reduce(shape_table *t, const int *pivots)
{
    const int r = t->rows;
    double p[9];
    int order[3];
    for (int k = 0; k < r; k++)
        for (int l = 0; l < r; l++)
            p[k * r + l] = t->a[k][pivots[l]];
    const batten_status status = bat_dense_factor(r, p, order);
    if (status != BATTEN_OK)
        return status;
    bat_dense_solve(r, p, order, POWERS, t->a[0]);
    for (int k = 0; k < r; k++) {
        for (int j = pivots[k] + 1; j < POWERS; j++)
            t->a[k][j] = 0;
        for (int l = 0; l < r; l++)
            t->a[k][pivots[l]] = k == l;
    }
    return BATTEN_OK;
}

/* ---- shift ---- */

static bool is_pivot(const batten_canonical *c, int j)
{
    return (c->dimension > 0 && j == c->pivots[0]) || (c->dimension > 1 && j == c->pivots[1]) ||
           (c->dimension > 2 && j == c->pivots[2]);
}

/* The first row whose second power the shift can make 0; -1: none. */
static int row_of_shift(const batten_canonical *c)
{
    for (int k = 0; k < c->dimension; k++)
        if (c->pivots[k] >= 2 && !is_pivot(c, c->pivots[k] - 1))
            return k;
    return -1;
}

static void shift_rows(shape_table *t, const int *pivots, double by)
{
    for (int k = 0; k < t->rows; k++) {
        for (int r = 0; r < t->n; r++)
            for (int j = t->n - 1; j >= r; j--)
                t->a[k][j] += by * t->a[k][j + 1];
        for (int l = k - 1; l >= 0; l--) {
            const double part = t->a[k][pivots[l]];
            for (int j = 1; j <= pivots[l]; j++)
                t->a[k][j] -= part * t->a[l][j];
        }
        for (int l = 0; l < t->rows; l++)
            t->a[k][pivots[l]] = k == l;
    }
}

/* ---- invariants ---- */

static double power(double x, int e)
{
    double product = 1;
    for (; e > 0; e--)
        product *= x;
    return product;
}

static int common_divisor(int a, int b)
{
    while (b) {
        const int rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* `by`: the shift of u. A power that moves no point of the span by more than the tolerance
 * counts as 0; what went through pivots near to dependence, or a far shift, is as much rougher.
 */
static void list_invariants(const shape_table *t, int shifted, double by, double tolerance,
                            batten_canonical *c)
{
    for (int k = 0; k < c->dimension; k++) {
        double factor = 1; /* j! / j_k! 2^-(j_k - j): from powers of u to t^j / j! */
        double zero = tolerance / c->margin;
        for (int j = c->pivots[k] - 1; j > 0; j--) {
            factor /= 2 * (j + 1.0);
            zero *= 1 + fabs(by);
            if (is_pivot(c, j) || (k == shifted && j == c->pivots[k] - 1))
                continue;
            const double entry = fabs(t->a[k][j]) > zero ? t->a[k][j] : 0;
            c->at[c->count++] = (batten_invariant){.row = k,
                                                   .power = j,
                                                   .weight = c->pivots[k] - j,
                                                   .value = factor * entry,
                                                   .absolute = NAN};
        }
    }
}

static void scale_invariants(double tolerance, batten_canonical *c)
{
    for (int i = 0; i < c->count; i++)
        c->radius = bat_max(c->radius, bat_pow(fabs(c->at[i].value), 1.0 / c->at[i].weight));
    c->base = -1;
    for (int i = 0; i < c->count && c->radius > 0; i++) {
        c->at[i].scaled = c->at[i].value / power(c->radius, c->at[i].weight);
        if (fabs(c->at[i].scaled) > tolerance / c->margin &&
            (c->base < 0 || c->at[i].weight < c->at[c->base].weight))
            c->base = i;
    }
    for (int i = 0; i < c->count && c->base >= 0; i++) {
        const batten_invariant *base = &c->at[c->base];
        const int g = common_divisor(base->weight, c->at[i].weight);
        c->at[i].absolute =
            power(c->at[i].scaled, base->weight / g) / power(base->scaled, c->at[i].weight / g);
    }
}

/* ---- the whole ---- */

static batten_status bring_to_form(shape_table *t, double tolerance, batten_canonical *out)
{
    batten_canonical c = {.base = -1, .margin = 1};
    make_square(t, tolerance, &c.margin, &c.neglected);
    c.dimension = t->rows;
    find_pivots(t, tolerance, &c);
    batten_status status = reduce(t, c.pivots);
    if (status != BATTEN_OK)
        return status;
    const int row = row_of_shift(&c);
    c.has_shift = row >= 0;
    const double by = row >= 0 ? -t->a[row][c.pivots[row] - 1] / c.pivots[row] : 0;
    if (c.has_shift)
        shift_rows(t, c.pivots, by);
    c.shift = 0.5 + by / 2;
    list_invariants(t, row, by, tolerance, &c);
    scale_invariants(tolerance, &c);
    *out = c;
    return BATTEN_OK;
}

static batten_status read_table(int dimension, int degree, const double *points, shape_table *t)
{
    bat_effort effort = {BATTEN_OK, EFFORT};
    bat_wholes pool = {&effort, NULL, NULL, 0};
    bat_exact_span span;
    *t = (shape_table){.rows = dimension};
    batten_status status = bat_exact_span_read(&pool, dimension, degree, points, &span);
    if (status == BATTEN_OK) {
        bat_exact_span_centred(&pool, &span, POWERS, t->a[0]);
        t->n = span.degree;
        status = effort.status;
    }
    bat_wholes_release(&pool);
    return status;
}

batten_status batten_canonical_form(int dimension, int degree, const double *points,
                                    double tolerance, batten_canonical *out)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there are curves in 1 to 3 dimensions, not in %d",
                        dimension);
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "degree %d is not in 1 .. %d", degree,
                        BATTEN_MAX_DEGREE);
    if (!(tolerance > 0 && tolerance < 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance %g is not in (0, 1)", tolerance);
    const size_t all = ((size_t)degree + 1) * (size_t)dimension;
    const size_t bad = bat_first_not_finite(points, all);
    if (bad < all)
        return bat_fail(BATTEN_NOT_FINITE, "point %d is not finite", (int)bad / dimension + 1);
    shape_table t;
    const batten_status status = read_table(dimension, degree, points, &t);
    return status == BATTEN_OK ? bring_to_form(&t, tolerance, out) : status;
}

void batten_canonicals_release(batten_canonicals *forms)
{
    bat_release(forms->at);
    *forms = (batten_canonicals){0, NULL};
}

batten_status batten_curve_canonical_forms(const batten_curve *curve, double tolerance,
                                           batten_canonicals *out)
{
    const int d = batten_curve_dimension(curve), p = batten_curve_degree(curve);
    const int spans = batten_curve_spans(curve, NULL) - 1;
    batten_curve *bezier = NULL;
    if (batten_curve_is_rational(curve))
        return bat_fail(BATTEN_UNSUPPORTED,
                        "polynomial curves have a canonical form, rational ones have not");
    batten_canonical *forms = bat_array((size_t)spans, sizeof *forms);
    batten_status status = forms ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(curve, &bezier);
    for (int i = 0; i < spans && status == BATTEN_OK; i++)
        status = batten_canonical_form(d, p, batten_curve_points(bezier) + (size_t)(p * i * d),
                                       tolerance, &forms[i]);
    batten_curve_unref(bezier);
    if (status != BATTEN_OK) {
        bat_release(forms);
        return status;
    }
    *out = (batten_canonicals){spans, forms};
    return BATTEN_OK;
}

/* ---- the class of quintics ---- */

const char *batten_quintic_name(batten_quintic_case which)
{
#define WORD(name, word, text) word,
    static const char *const words[] = {BATTEN_QUINTIC_TABLE(WORD)};
#undef WORD
    return (unsigned)which < BATTEN_QUINTIC_COUNT ? words[which] : "unknown";
}

const char *batten_quintic_text(batten_quintic_case which)
{
#define TEXT(name, word, text) text,
    static const char *const texts[] = {BATTEN_QUINTIC_TABLE(TEXT)};
#undef TEXT
    return (unsigned)which < BATTEN_QUINTIC_COUNT ? texts[which] : "unknown";
}

static int sign_of(double x, double zero)
{
    return fabs(x) <= zero ? 0 : x < 0 ? -1 : 1;
}

/* By the signs of g, b, and of b^2 - 4 g where g > 0. */
static batten_quintic_case quintic_case(int g, int b, int discriminant)
{
    if (g < 0)
        return BATTEN_QUINTIC_NODE_AND_ISOLATED;
    if (g == 0)
        return b > 0   ? BATTEN_QUINTIC_CUSP_AND_ISOLATED
               : b < 0 ? BATTEN_QUINTIC_CUSP_AND_NODE
                       : BATTEN_QUINTIC_HIGHER_CUSP;
    if (discriminant < 0)
        return BATTEN_QUINTIC_NO_REAL;
    if (discriminant == 0)
        return b < 0 ? BATTEN_QUINTIC_TACNODE : BATTEN_QUINTIC_DOUBLE_ISOLATED;
    return b < 0 ? BATTEN_QUINTIC_TWO_NODES : BATTEN_QUINTIC_TWO_ISOLATED;
}

batten_status batten_quintic_classify(const batten_canonical *canonical, double tolerance,
                                      batten_quintic *out)
{
    double value[6] = {0}, scaled[6] = {0};
    if (canonical->dimension != 2 || canonical->pivots[0] != 2 || canonical->pivots[1] != 5)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the curve is not an affine image of (t^2, t^5 + a t^4 + b t^3 + g t)");
    double factor[6] = {120, 120, 60, 20, 5, 1}; /* 5! / j!: from t^j / j! to powers */
    for (int i = 0; i < canonical->count; i++) {
        const batten_invariant *e = &canonical->at[i];
        value[e->power] = factor[e->power] * e->value;
        scaled[e->power] = factor[e->power] * e->scaled;
    }
    const double b = scaled[3], g = scaled[1], discriminant = b * b - 4 * g;
    const double size = b * b + 4 * fabs(g), zero = tolerance * bat_max(size, 1);
    const int signs[3] = {sign_of(g, zero), sign_of(b, zero), sign_of(discriminant, zero)};
    batten_quintic q = {.which = quintic_case(signs[0], signs[1], signs[2]),
                        .a = value[4],
                        .b = value[3],
                        .g = value[1],
                        .shift = canonical->shift,
                        .margin = signs[0] ? bat_min(fabs(g), 1) : 0};
    if (signs[0] > 0)
        q.margin = signs[2] ? bat_min(q.margin, fabs(discriminant) / size) : 0;
    *out = q;
    return BATTEN_OK;
}
