/*
 * Whether a deformation folds: the determinant of its Jacobian on one span of the lattice is a polynomial of degree 3 p - 1,
 * which lies between its least and its greatest Bezier coefficient. Where these do not have one sign it is halved.
 */
#include "numeric/bernstein.h"
#include "numeric/vector.h"
#include "shape/deform/lattice.h"

#include <float.h>
#include <string.h>

enum {
    WIDTH = BAT_LATTICE_MOST_DEGREE + 1,
    DEPTH = 60 /* halvings of one span, twenty in each direction: a millionth of it */
};

/* A polynomial in three variables: Bezier coefficients, the last direction fastest. */
typedef struct {
    int degree[3];
    double *c;
} polynomial3;

static size_t coefficient_count(const polynomial3 *f)
{
    return (size_t)(f->degree[0] + 1) * (size_t)(f->degree[1] + 1) * (size_t)(f->degree[2] + 1);
}

static double *coefficient(const polynomial3 *f, int i, int j, int k)
{
    return f->c +
           ((size_t)i * (size_t)(f->degree[1] + 1) + (size_t)j) * (size_t)(f->degree[2] + 1) +
           k;
}

/* A part of a span. */
typedef struct {
    double low[3], high[3];
    int depth;
} part;

/* What is needed for one span after the other. */
typedef struct {
    batten_deformation *d;
    double *moves; /* [3][points of a span] in Bezier form, one coordinate after the other */
    polynomial3 by[3][3];    /* by[c][k]: coordinate c by the parameter of direction k */
    polynomial3 minor;       /* of degree 2 p, less in two directions: the room for each */
    polynomial3 determinant; /* [DEPTH + 2] halves, one behind the other */
    size_t room;             /* of one determinant */
    part *waiting;           /* [DEPTH + 2] which parts these are */
    double (*binomials)[3 * WIDTH];
    int parts, most; /* looked at, and allowed */
} search;

static batten_status begin_search(batten_deformation *d, int most, search *s)
{
    const int *p = d->lattice.degrees;
    memset(s, 0, sizeof *s);
    s->d = d;
    s->most = most;
    s->binomials = bat_array(3 * WIDTH, sizeof *s->binomials);
    if (!s->binomials)
        return BATTEN_OUT_OF_MEMORY;
    for (int n = 0; n < 3 * WIDTH; n++)
        for (int k = 0; k <= n; k++)
            s->binomials[n][k] =
                k == 0 || k == n ? 1 : s->binomials[n - 1][k - 1] + s->binomials[n - 1][k];
    const size_t points = (size_t)(p[0] + 1) * (size_t)(p[1] + 1) * (size_t)(p[2] + 1);
    s->room = (size_t)(27 * p[0] * p[1] * p[2]);
    batten_status status = BATTEN_OK;
    s->moves = bat_array(points, 3 * sizeof *s->moves);
    s->waiting = bat_array(DEPTH + 2, sizeof *s->waiting);
    s->minor.c = bat_array(s->room, sizeof *s->minor.c);
    s->determinant.c = bat_array(s->room, (DEPTH + 2) * sizeof *s->determinant.c);
    if (!s->moves || !s->waiting || !s->minor.c || !s->determinant.c)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < 9 && status == BATTEN_OK; i++) {
        polynomial3 *f = &s->by[i / 3][i % 3];
        memcpy(f->degree, p, sizeof f->degree);
        f->degree[i % 3]--;
        f->c = bat_array(points, sizeof *f->c);
        status = f->c ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    return status;
}

static void end_search(search *s)
{
    bat_release(s->binomials);
    bat_release(s->waiting);
    bat_release(s->moves);
    bat_release(s->minor.c);
    bat_release(s->determinant.c);
    for (int i = 0; i < 9; i++)
        bat_release(s->by[i / 3][i % 3].c);
}

/* ---- one span in Bezier form ---- */

/* What the B-splines of a span contribute to its Bezier coefficients: the blossom at j ends and p - j starts of the span. */
static void find_extraction(const bat_axis *axis, int span, double out[WIDTH][WIDTH])
{
    const int p = axis->degree, first = axis->first[span];
    const double *U = axis->knots, a = axis->breaks[span], b = axis->breaks[span + 1];
    for (int j = 0; j <= p; j++)
        for (int i = 0; i <= p; i++) {
            double row[WIDTH] = {0};
            row[i] = 1;
            for (int level = 1; level <= p; level++) {
                const double u = level <= j ? b : a;
                for (int r = p; r >= level; r--) {
                    const double low = U[first - p + r], high = U[first + r - level + 1];
                    const double share = (u - low) / (high - low);
                    row[r] = (1 - share) * row[r - 1] + share * row[r];
                }
            }
            out[j][i] = row[p];
        }
}

/* Replace the coefficients along one direction by their combinations. */
static void combine_along(const int counts[3], int axis, double matrix[WIDTH][WIDTH],
                          double *values)
{
    const int n = counts[axis];
    const int stride = axis == 2 ? 1 : axis == 1 ? counts[2] : counts[1] * counts[2];
    const int total = counts[0] * counts[1] * counts[2];
    for (int at = 0; at < total; at++) {
        if (at / stride % n)
            continue;
        double line[WIDTH];
        for (int j = 0; j < n; j++) {
            line[j] = 0;
            for (int i = 0; i < n; i++)
                line[j] += matrix[j][i] * values[at + i * stride];
        }
        for (int j = 0; j < n; j++)
            values[at + j * stride] = line[j];
    }
}

/* The moves of one span in Bezier form; false when there are none. */
static bool extract_moves(search *s, const int span[3])
{
    const batten_deformation *d = s->d;
    const int *p = d->lattice.degrees;
    const int counts[3] = {p[0] + 1, p[1] + 1, p[2] + 1},
              total = counts[0] * counts[1] * counts[2];
    bool any = false;
    int first[3];
    for (int k = 0; k < 3; k++)
        first[k] = bat_axis_first_point(&d->axes[k], span[k]);
    for (int at = 0; at < total; at++) {
        const size_t from =
            bat_lattice_index(&d->lattice, first[0] + at / (counts[1] * counts[2]),
                              first[1] + at / counts[2] % counts[1], first[2] + at % counts[2]);
        for (int c = 0; c < 3; c++) {
            s->moves[c * total + at] = d->moves[3 * from + (size_t)c];
            any |= s->moves[c * total + at] != 0;
        }
    }
    for (int k = 0; k < 3 && any; k++) {
        double matrix[WIDTH][WIDTH];
        find_extraction(&d->axes[k], span[k], matrix);
        for (int c = 0; c < 3; c++)
            combine_along(counts, k, matrix, s->moves + c * total);
    }
    return any;
}

/* The derivatives of the map by x, y and z of the model, each along its own degrees. */
static void differentiate_moves(search *s, const int span[3])
{
    const batten_deformation *d = s->d;
    const int *p = d->lattice.degrees;
    const int total = (p[0] + 1) * (p[1] + 1) * (p[2] + 1);
    const int strides[3] = {(p[1] + 1) * (p[2] + 1), p[2] + 1, 1};
    for (int k = 0; k < 3; k++) {
        const double *breaks = d->axes[k].breaks + span[k];
        const double rate = p[k] / ((breaks[1] - breaks[0]) * d->extent[k]);
        for (int c = 0; c < 3; c++) {
            const polynomial3 *f = &s->by[c][k];
            const double *from = s->moves + c * total;
            for (int x = 0; x <= f->degree[0]; x++)
                for (int y = 0; y <= f->degree[1]; y++)
                    for (int z = 0; z <= f->degree[2]; z++) {
                        const int at = x * strides[0] + y * strides[1] + z;
                        *coefficient(f, x, y, z) =
                            (c == k) + rate * (from[at + strides[k]] - from[at]);
                    }
        }
    }
}

/* ---- the determinant ---- */

/* out += sign f g */
static void add_product(const search *s, double sign, const polynomial3 *f,
                        const polynomial3 *g, polynomial3 *out)
{
    double(*const B)[3 * WIDTH] = s->binomials;
    const int *p = f->degree, *q = g->degree, *n = out->degree;
    for (int i = 0; i <= p[0]; i++)
        for (int j = 0; j <= p[1]; j++)
            for (int k = 0; k <= p[2]; k++) {
                const double value =
                    sign * *coefficient(f, i, j, k) * B[p[0]][i] * B[p[1]][j] * B[p[2]][k];
                for (int x = 0; x <= q[0]; x++)
                    for (int y = 0; y <= q[1]; y++) {
                        const double along =
                            value * B[q[0]][x] / B[n[0]][i + x] * B[q[1]][y] / B[n[1]][j + y];
                        const double *from = coefficient(g, x, y, 0);
                        double *to = coefficient(out, i + x, j + y, k);
                        for (int z = 0; z <= q[2]; z++)
                            to[z] += along * from[z] * B[q[2]][z] / B[n[2]][k + z];
                    }
            }
}

static void add_degrees(const polynomial3 *f, const polynomial3 *g, polynomial3 *out)
{
    for (int k = 0; k < 3; k++)
        out->degree[k] = f->degree[k] + g->degree[k];
    memset(out->c, 0, coefficient_count(out) * sizeof *out->c);
}

/* Expanded by its first column. */
static void make_determinant(search *s)
{
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        add_degrees(&s->by[a][1], &s->by[b][2], &s->minor);
        add_product(s, 1, &s->by[a][1], &s->by[b][2], &s->minor);
        add_product(s, -1, &s->by[b][1], &s->by[a][2], &s->minor);
        if (c == 0)
            add_degrees(&s->by[0][0], &s->minor, &s->determinant);
        add_product(s, 1, &s->by[c][0], &s->minor, &s->determinant);
    }
}

/*
 * What rounding leaves of a determinant: every coefficient is a mean of products of three derivatives with six signs. A
 * product takes three multiplications, six binomials and their quotients with as many, and sums over at most
 * 9 x 9 x 9 terms, twice, whose roundings grow with their number at worst.
 */
static double rounding_of(const search *s)
{
    const int *p = s->d->lattice.degrees;
    const double terms = 24 + 2.0 * (p[0] + 1) * (p[1] + 1) * (p[2] + 1);
    double product = 6;
    for (int k = 0; k < 3; k++) {
        double most = 0;
        for (int c = 0; c < 3; c++)
            for (size_t i = 0; i < coefficient_count(&s->by[c][k]); i++)
                most = bat_max(most, fabs(s->by[c][k].c[i]));
        product *= most;
    }
    return terms * DBL_EPSILON * product;
}

/* ---- its sign ---- */

/* The determinant at a corner is its coefficient there: the least met anywhere is kept, with its place. */
static void look_at_corners(search *s, const polynomial3 *f, const part *at)
{
    batten_deformation_report *r = &s->d->report;
    for (int corner = 0; corner < 8; corner++) {
        const int end[3] = {corner >> 2, corner >> 1 & 1, corner & 1};
        const double value = *coefficient(f, end[0] * f->degree[0], end[1] * f->degree[1],
                                          end[2] * f->degree[2]);
        if (!(value < r->least))
            continue;
        r->least = value;
        for (int k = 0; k < 3; k++)
            r->at[k] = s->d->low[k] + s->d->extent[k] * (end[k] ? at->high[k] : at->low[k]);
    }
}

/* Halve along the direction: the lower half stays, the upper goes behind it. */
static void halve_part(search *s, polynomial3 *f, int axis, part *lower, part *upper)
{
    polynomial3 other = *f;
    other.c = f->c + s->room;
    const int n = f->degree[axis];
    const int counts[3] = {f->degree[0] + 1, f->degree[1] + 1, f->degree[2] + 1};
    const int stride = axis == 2 ? 1 : axis == 1 ? counts[2] : counts[1] * counts[2];
    const int total = counts[0] * counts[1] * counts[2];
    for (int at = 0; at < total; at++) {
        double line[3 * WIDTH], right[3 * WIDTH];
        if (at / stride % (n + 1))
            continue;
        for (int i = 0; i <= n; i++)
            line[i] = f->c[at + i * stride];
        bat_bernstein_split(n, line, 0.5, line, right);
        for (int i = 0; i <= n; i++) {
            f->c[at + i * stride] = line[i];
            other.c[at + i * stride] = right[i];
        }
    }
    *upper = *lower;
    lower->depth = ++upper->depth;
    lower->high[axis] = upper->low[axis] = (lower->low[axis] + lower->high[axis]) / 2;
}

/* One span: until every part of it is above 0, or one is met that is not. */
static void judge_span(search *s, part whole)
{
    batten_deformation_report *r = &s->d->report;
    const double margin = rounding_of(s);
    int waiting = 1;
    s->waiting[0] = whole;
    while (waiting > 0) {
        polynomial3 f = s->determinant;
        part *at = &s->waiting[waiting - 1];
        f.c += (size_t)(waiting - 1) * s->room;
        double least = HUGE_VAL;
        for (size_t i = 0; i < coefficient_count(&f); i++)
            least = bat_min(least, f.c[i]);
        look_at_corners(s, &f, at);
        if (r->least <= margin) {
            r->folding = BATTEN_FOLDS;
            return;
        }
        if (least > margin || at->depth == DEPTH || s->parts >= s->most) {
            r->bound = bat_min(r->bound, least - margin);
            waiting--;
            if (!(least > margin))
                r->folding = BATTEN_FOLDS_UNKNOWN;
            continue;
        }
        s->parts++;
        halve_part(s, &f, at->depth % 3, at, at + 1);
        waiting++;
    }
}

batten_status bat_deformation_find_folds(batten_deformation *d, int most_parts)
{
    search s;
    batten_deformation_report *r = &d->report;
    r->folding = BATTEN_FOLDS_NOWHERE;
    r->bound = r->least = HUGE_VAL;
    for (int k = 0; k < 3; k++)
        r->at[k] = d->low[k];
    batten_status status = begin_search(d, most_parts, &s);
    int span[3];
    for (span[0] = 0; status == BATTEN_OK && span[0] < d->axes[0].span_count; span[0]++)
        for (span[1] = 0; span[1] < d->axes[1].span_count; span[1]++)
            for (span[2] = 0; span[2] < d->axes[2].span_count; span[2]++) {
                part whole = {.depth = 0};
                if (r->folding == BATTEN_FOLDS)
                    continue;
                if (!extract_moves(&s, span)) {
                    r->bound = bat_min(r->bound, 1);
                    r->least = bat_min(r->least, 1);
                    continue;
                }
                for (int k = 0; k < 3; k++) {
                    whole.low[k] = d->axes[k].breaks[span[k]];
                    whole.high[k] = d->axes[k].breaks[span[k] + 1];
                }
                differentiate_moves(&s, span);
                make_determinant(&s);
                judge_span(&s, whole);
            }
    if (r->folding == BATTEN_FOLDS)
        r->bound = bat_min(r->bound, r->least);
    end_search(&s);
    return status;
}
