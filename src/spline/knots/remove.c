/*
 * Knot removal [Tiller92]. A knot u = U[r] of multiplicity s can go when the p - s points Q
 * between two fixed ones satisfy the p - s + 1 equations of insertion,
 *
 *     P_i = a_i Q_i + (1 - a_i) Q_(i-1),  a_i = (u - U_i) / (U_(i+p+1) - U_i),  i = r - p .. r
 * - s.
 *
 * All but one are solved, from both ends towards it; it is the one whose residual is least. By
 * how much the largest residual of all of them is, by so much at most has the curve moved: the
 * residuals are control points of the difference. The equations are checked after solving, so
 * rounding is in the bound.
 */
#include "numeric/vector.h"
#include "spline/spline.h"

#include <stdlib.h>
#include <string.h>

/* A spline from which knots are taken. */
typedef struct {
    bat_spline *spline;
    size_t group; /* numbers in one point, of which a row has one or many */
    double *rows; /* [2 p + 3][width] scratch: solutions from the left, then from the right */
} removal;

static double alpha(const bat_spline *spline, int i, double u)
{
    const double *U = spline->knots;
    return (u - U[i]) / (U[i + spline->degree + 1] - U[i]);
}

static double *row_of(const bat_spline *spline, int i)
{
    return spline->values + (size_t)i * spline->width;
}

/* The largest norm of a point of P - (a Q + (1 - a) Q'). */
static double residual(const removal *work, const double *P, double a, const double *Q,
                       const double *before)
{
    const size_t width = work->spline->width;
    double largest = 0, difference[4];
    for (size_t c = 0; c < width; c += work->group) {
        for (size_t k = 0; k < work->group; k++)
            difference[k] = P[c + k] - (a * Q[c + k] + (1 - a) * before[c + k]);
        const double norm = bat_norm((int)work->group, difference);
        /* What is no number counts as too far. */
        largest = norm <= largest ? largest : isnan(norm) ? HUGE_VAL : norm;
    }
    return largest;
}

/* left[k], k = 0 .. p - s + 1: Q_(first-1+k) from the left; right[k] the same from the right.
 */
static void solve_both(const removal *work, int r, int s, double *left, double *right)
{
    const bat_spline *spline = work->spline;
    const int p = spline->degree, first = r - p, count = p - s;
    const size_t width = spline->width;
    const double u = spline->knots[r];
    memcpy(left, row_of(spline, first - 1), width * sizeof *left);
    for (int k = 1; k <= count; k++) {
        const double a = alpha(spline, first + k - 1, u), *P = row_of(spline, first + k - 1);
        for (size_t c = 0; c < width; c++)
            left[(size_t)k * width + c] =
                (P[c] - (1 - a) * left[(size_t)(k - 1) * width + c]) / a;
    }
    memcpy(right + (size_t)(count + 1) * width, row_of(spline, first + count + 1),
           width * sizeof *right);
    for (int k = count; k >= 1; k--) {
        const double a = alpha(spline, first + k, u), *P = row_of(spline, first + k);
        for (size_t c = 0; c < width; c++)
            right[(size_t)k * width + c] =
                (P[c] - a * right[(size_t)(k + 1) * width + c]) / (1 - a);
    }
}

/* Of row i, when knot r goes and its neighbours are these. */
static double residual_at(const removal *work, int r, int i, const double *next,
                          const double *before)
{
    const bat_spline *spline = work->spline;
    return residual(work, row_of(spline, i), alpha(spline, i, spline->knots[r]), next, before);
}

/* Take the left solution up to the equation that is left open, the right one beyond it; into
 * `left`. */
static void meet(const removal *work, int r, int s, double *left, const double *right)
{
    const bat_spline *spline = work->spline;
    const int count = spline->degree - s, first = r - spline->degree;
    const size_t width = spline->width;
    int open = 0;
    double least = HUGE_VAL;
    for (int k = 0; k <= count; k++) {
        const double here = residual_at(work, r, first + k, right + (size_t)(k + 1) * width,
                                        left + (size_t)k * width);
        if (here < least) {
            least = here;
            open = k;
        }
    }
    memcpy(left + (size_t)(open + 1) * width, right + (size_t)(open + 1) * width,
           (size_t)(count + 1 - open) * width * sizeof *left);
}

/* What removing knot r once would move; the new points stay in work->rows. */
static double removal_error(const removal *work, int r, int s)
{
    const bat_spline *spline = work->spline;
    const int count = spline->degree - s, first = r - spline->degree;
    const size_t width = spline->width;
    double *left = work->rows, *right = left + (size_t)(count + 2) * width;
    solve_both(work, r, s, left, right);
    meet(work, r, s, left, right);
    double largest = 0;
    for (int k = 0; k <= count; k++)
        largest =
            bat_max(largest, residual_at(work, r, first + k, left + (size_t)(k + 1) * width,
                                         left + (size_t)k * width));
    return largest;
}

static batten_status removal_begin(removal *work, bat_spline *spline, size_t group)
{
    *work = (removal){spline, group, NULL};
    work->rows =
        bat_array3(2 * ((size_t)spline->degree + 2), spline->width, sizeof *work->rows);
    return work->rows ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* Put the points of the last removal_error in place; row r - s then is not needed. */
static void take_points(const removal *work, int r, int s)
{
    const bat_spline *spline = work->spline;
    memcpy(row_of(spline, r - spline->degree), work->rows + spline->width,
           (size_t)(spline->degree - s) * spline->width * sizeof *work->rows);
}

static void close_gap(bat_spline *spline, int r, int s)
{
    const int n = spline->count, p = spline->degree;
    memmove(row_of(spline, r - s), row_of(spline, r - s + 1),
            (size_t)(n - 1 - (r - s)) * spline->width * sizeof *spline->values);
    memmove(spline->knots + r, spline->knots + r + 1,
            (size_t)(n + p - r) * sizeof *spline->knots);
    spline->count--;
}

batten_status bat_spline_remove(const bat_spline *spline, double u, int times, size_t group,
                                double tolerance, int *removed, double *error, bat_spline *out)
{
    bat_spline made;
    removal work;
    batten_status status = bat_spline_insert(spline, 0, NULL, &made);
    if (status != BATTEN_OK)
        return status;
    status = removal_begin(&work, &made, group);
    if (status != BATTEN_OK) {
        bat_spline_free(&made);
        return status;
    }
    *removed = 0;
    *error = 0;
    while (*removed < times) {
        const int r = bat_knots_span(made.degree, made.count, made.knots, u, BATTEN_FROM_RIGHT);
        const int s = bat_knots_multiplicity(made.degree, made.count, made.knots, u);
        const double moved = s > 0 ? removal_error(&work, r, s) : HUGE_VAL;
        if (!(*error + moved <= tolerance))
            break;
        take_points(&work, r, s);
        close_gap(&made, r, s);
        *error += moved;
        ++*removed;
    }
    bat_release(work.rows);
    *out = made;
    return BATTEN_OK;
}

/* ---- all knots ---- */

/* A knot that could go. */
typedef struct {
    int r, s;
    double error;
} candidate;

typedef struct {
    removal removal;
    double tolerance;
    double *moved;         /* [knots] how far the curve has moved between knot j and the next */
    candidate *candidates; /* [count] */
    bool *gone, *row_gone; /* [knots], [rows] removed in this round */
    int count;
} thinning;

static int by_error(const void *a, const void *b)
{
    const candidate *x = a, *y = b;
    if (x->error != y->error)
        return x->error < y->error ? -1 : 1;
    return (x->r > y->r) - (x->r < y->r);
}

/* The curve moves between U[r - p] and U[r - s + p + 1]. */
static double moved_before(const thinning *work, int r, int s)
{
    const int p = work->removal.spline->degree;
    double largest = 0;
    for (int j = r - p; j <= r - s + p; j++)
        largest = bat_max(largest, work->moved[j]);
    return largest;
}

static void find_candidates(thinning *work)
{
    const bat_spline *spline = work->removal.spline;
    const int p = spline->degree, n = spline->count;
    const double *U = spline->knots;
    work->count = 0;
    for (int r = p + 1, s = 1; r < n; r++) {
        s = U[r] == U[r - 1] ? s + 1 : 1;
        if (U[r] == U[r + 1] || U[r] == U[p])
            continue;
        const double error = removal_error(&work->removal, r, s);
        if (moved_before(work, r, s) + error <= work->tolerance)
            work->candidates[work->count++] = (candidate){r, s, error};
    }
    qsort(work->candidates, (size_t)work->count, sizeof *work->candidates, by_error);
}

/* Is a knot so near already gone in this round that the equations share points or knots? */
static bool near_gone(const thinning *work, int r)
{
    const int p = work->removal.spline->degree;
    const int last = bat_min_int(r + p + 1, work->removal.spline->count + p);
    for (int j = bat_max_int(0, r - p - 1); j <= last; j++)
        if (work->gone[j])
            return true;
    return false;
}

/* Close the gaps of a round. Of two spans that become one the larger movement counts. */
static void compact_knots(thinning *work, double *knots, int knot_count)
{
    int kept = 0;
    for (int j = 0; j < knot_count; j++)
        if (work->gone[j])
            work->moved[kept - 1] = bat_max(work->moved[kept - 1], work->moved[j]);
        else {
            knots[kept] = knots[j];
            work->moved[kept++] = work->moved[j];
        }
}

static void compact(thinning *work)
{
    bat_spline *spline = work->removal.spline;
    int rows = 0;
    compact_knots(work, spline->knots, spline->count + spline->degree + 1);
    for (int i = 0; i < spline->count; i++)
        if (!work->row_gone[i])
            memmove(row_of(spline, rows++), row_of(spline, i),
                    spline->width * sizeof *spline->values);
    spline->count = rows;
}

/* Of the knots that can go, those whose going moves the curve least, as long as they do not
 * touch each other. */
static int remove_round(thinning *work)
{
    bat_spline *spline = work->removal.spline;
    const int p = spline->degree;
    int removed = 0;
    find_candidates(work);
    memset(work->gone, 0, (size_t)(spline->count + p + 1) * sizeof *work->gone);
    memset(work->row_gone, 0, (size_t)spline->count * sizeof *work->row_gone);
    for (int i = 0; i < work->count; i++) {
        const int r = work->candidates[i].r, s = work->candidates[i].s;
        if (near_gone(work, r) ||
            moved_before(work, r, s) + work->candidates[i].error > work->tolerance)
            continue;
        const double moved = removal_error(&work->removal, r, s);
        take_points(&work->removal, r, s);
        for (int j = r - p; j <= r - s + p; j++)
            work->moved[j] += moved;
        work->gone[r] = work->row_gone[r - s] = true;
        removed++;
    }
    compact(work);
    return removed;
}

batten_status bat_spline_thin(bat_spline *spline, size_t group, double tolerance, int *removed,
                              double *error)
{
    const size_t knot_count = (size_t)spline->count + (size_t)spline->degree + 1;
    thinning work = {.tolerance = tolerance};
    batten_status status = removal_begin(&work.removal, spline, group);
    work.moved = bat_array(knot_count, sizeof *work.moved);
    work.candidates = bat_array(knot_count, sizeof *work.candidates);
    work.gone = bat_array(knot_count, sizeof *work.gone);
    work.row_gone = bat_array(knot_count, sizeof *work.row_gone);
    if (!work.moved || !work.candidates || !work.gone || !work.row_gone)
        status = BATTEN_OUT_OF_MEMORY;
    *removed = 0;
    *error = 0;
    for (int round = 1; status == BATTEN_OK && round > 0; *removed += round)
        round = remove_round(&work);
    for (int j = spline->degree; status == BATTEN_OK && j < spline->count; j++)
        *error = bat_max(*error, work.moved[j]);
    bat_release(work.row_gone);
    bat_release(work.gone);
    bat_release(work.candidates);
    bat_release(work.moved);
    bat_release(work.removal.rows);
    return status;
}

static void list_errors(const removal *work, double *errors)
{
    const int p = work->spline->degree, n = work->spline->count;
    const double *U = work->spline->knots;
    for (int j = 0; j < n + p + 1; j++)
        errors[j] = HUGE_VAL;
    for (int r = p + 1, s = 1; r < n; r++) {
        s = U[r] == U[r - 1] ? s + 1 : 1;
        if (U[r] != U[r + 1] && U[r] != U[p])
            errors[r] = removal_error(work, r, s);
    }
}

batten_status bat_spline_removal_errors(const bat_spline *spline, size_t group, double *errors)
{
    bat_spline borrowed = *spline;
    removal work;
    const batten_status status = removal_begin(&work, &borrowed, group);
    if (status != BATTEN_OK)
        return status;
    list_errors(&work, errors);
    bat_release(work.rows);
    return BATTEN_OK;
}
