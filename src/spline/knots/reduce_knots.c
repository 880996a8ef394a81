/*
 * Knot reduction [LM87], [LM88]. One by one, removals add up their bounds (remove.c). Here many
 * knots go at once: those that matter least, as evenly spread as can be; the control rows of
 * the coarse spline are the nearest ones, by least squares, to the rows c of the fine one on
 * its own knots; and c - B b, with B the matrix of knot insertion, are the control rows of the
 * difference. The largest of them bounds it everywhere, so the bound is proved anew for each
 * trial and nothing adds up. A group that cannot go is tried by halves.
 */
#include "numeric/givens.h"
#include "numeric/vector.h"
#include "spline/spline.h"

#include <stdlib.h>
#include <string.h>

/* A knot, and what its removal alone would move. */
typedef struct {
    int knot;       /* index, the last of equal ones */
    int class;      /* the power of two of that movement, against the tolerance */
    uint32_t place; /* in its class, so that the first few are spread evenly */
} candidate;

typedef struct {
    const bat_spline *fine;
    size_t group;
    double tolerance;
    bat_spline best;
    double error;
    int *order; /* [count] knots of best in the order in which they shall go */
    int count;
    bool *gone;      /* [knots of best] */
    double *weights; /* [rows of fine] roots of the lengths on which they bear */
    double *row;     /* [width] */
    int left;        /* trials */
} reduction;

/* ---- the nearest rows on given knots ---- */

/* Row i of B: what points mu - p .. mu of the coarse spline give to row i of the fine one, by
 * the recurrence of the Oslo algorithm. */
static void insertion_row(int p, const double *t, int mu, const double *tau, double *out)
{
    out[0] = 1;
    for (int k = 1; k <= p; k++) {
        double saved = 0;
        for (int r = 0; r < k; r++) {
            const double low = t[mu + 1 - k + r], high = t[mu + 1 + r];
            const double part = out[r] / (high - low);
            out[r] = saved + (high - tau[k]) * part;
            saved = (tau[k] - low) * part;
        }
        out[k] = saved;
    }
}

/* The coarse span that holds tau, from one before it on. */
static int next_span(const bat_spline *coarse, double tau, int mu)
{
    while (mu < coarse->count - 1 && coarse->knots[mu + 1] <= tau)
        mu++;
    return mu;
}

/* Both ends stay: what they contribute goes to the right side. */
static void set_aside(const reduction *work, int n, int first, double *values, double *right)
{
    const bat_spline *fine = work->fine;
    const int columns[2] = {0, n - 1}, rows[2] = {0, fine->count - 1};
    for (int e = 0; e < 2; e++) {
        const int k = columns[e] - first;
        if (k < 0 || k > fine->degree)
            continue;
        for (size_t c = 0; c < fine->width; c++)
            right[c] -= values[k] * fine->values[(size_t)rows[e] * fine->width + c];
        values[k] = 0;
    }
}

static void add_rows(reduction *work, const bat_spline *coarse, bat_givens *qr)
{
    const bat_spline *fine = work->fine;
    const size_t width = fine->width;
    const int p = fine->degree, n = coarse->count;
    const double one = 1, *last = fine->values + (size_t)(fine->count - 1) * width;
    double values[BATTEN_MAX_DEGREE + 1];
    bat_givens_clear(qr);
    bat_givens_add(qr, 0, 1, &one, 1, fine->values);
    for (int i = 1, mu = p; i < fine->count - 1; i++) {
        mu = next_span(coarse, fine->knots[i], mu);
        insertion_row(p, coarse->knots, mu, fine->knots + i, values);
        memcpy(work->row, fine->values + (size_t)i * width, width * sizeof *work->row);
        set_aside(work, n, mu - p, values, work->row);
        bat_givens_add(qr, mu - p, p + 1, values, work->weights[i], work->row);
    }
    bat_givens_add(qr, n - 1, 1, &one, 1, last);
}

/* The largest row of c - B b. */
static double difference(const reduction *work, const bat_spline *coarse)
{
    const bat_spline *fine = work->fine;
    const size_t width = fine->width;
    const int p = fine->degree;
    double values[BATTEN_MAX_DEGREE + 1], largest = 0;
    for (int i = 0, mu = p; i < fine->count; i++) {
        mu = next_span(coarse, fine->knots[i], mu);
        insertion_row(p, coarse->knots, mu, fine->knots + i, values);
        memcpy(work->row, fine->values + (size_t)i * width, width * sizeof *work->row);
        for (int k = 0; k <= p; k++)
            for (size_t c = 0; c < width; c++)
                work->row[c] -= values[k] * coarse->values[(size_t)(mu - p + k) * width + c];
        for (size_t c = 0; c < width; c += work->group) {
            const double norm = bat_norm((int)work->group, work->row + c);
            /* What is no number counts as too far. */
            largest = norm <= largest ? largest : isnan(norm) ? HUGE_VAL : norm;
        }
    }
    return largest;
}

/* The rows of the coarse spline, whose knots are set; *error infinite when these knots do not
 * do. */
static batten_status solve(reduction *work, bat_spline *coarse, double *error)
{
    const size_t width = work->fine->width;
    bat_givens qr;
    int unknown;
    batten_status status =
        bat_givens_begin(coarse->count, work->fine->degree + 1, false, width, &qr);
    if (status != BATTEN_OK)
        return status;
    *error = HUGE_VAL;
    add_rows(work, coarse, &qr);
    if (bat_givens_check(&qr, &unknown) == BATTEN_OK) {
        bat_givens_solve(&qr, coarse->values);
        /* The ends come back to the bit. */
        memcpy(coarse->values, work->fine->values, width * sizeof(double));
        memcpy(coarse->values + (size_t)(coarse->count - 1) * width,
               work->fine->values + (size_t)(work->fine->count - 1) * width,
               width * sizeof(double));
        *error = difference(work, coarse);
    }
    bat_givens_end(&qr);
    return BATTEN_OK;
}

/* ---- which knots, and how many ---- */

/* The bits of a number in reverse: counting on, the fractions fill a line evenly. */
static uint32_t reverse_bits(uint32_t x)
{
    uint32_t y = 0;
    for (int i = 0; i < 32; i++)
        y |= (x >> i & 1u) << (31 - i);
    return y;
}

static int by_rank(const void *a, const void *b)
{
    const candidate *x = a, *y = b;
    if (x->class != y->class)
        return x->class < y->class ? -1 : 1;
    if (x->place != y->place)
        return x->place < y->place ? -1 : 1;
    return (x->knot > y->knot) - (x->knot < y->knot);
}

/* Movements far below the tolerance are alike. */
enum { LEAST_CLASS = -8, CLASSES = 64 };

static int find_candidates(const bat_spline *s, const double *errors, double tolerance,
                           candidate *candidates)
{
    uint32_t seen[CLASSES] = {0};
    int count = 0;
    for (int r = s->degree + 1; r < s->count; r++) {
        if (!isfinite(errors[r]))
            continue;
        int class = LEAST_CLASS;
        if (errors[r] > 0)
            frexp(errors[r] / tolerance, &class);
        class = bat_max_int(LEAST_CLASS, bat_min_int(class, LEAST_CLASS + CLASSES - 1));
        candidates[count++] = (candidate){r, class, reverse_bits(seen[class - LEAST_CLASS]++)};
    }
    qsort(candidates, (size_t)count, sizeof *candidates, by_rank);
    return count;
}

batten_status bat_spline_rank_knots(const bat_spline *spline, size_t group, double tolerance,
                                    int *order, int *count)
{
    const size_t knots = (size_t)spline->count + (size_t)spline->degree + 1;
    double *errors = bat_array(knots, sizeof *errors);
    candidate *candidates = bat_array(knots, sizeof *candidates);
    batten_status status = errors && candidates ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_spline_removal_errors(spline, group, errors);
    if (status == BATTEN_OK) {
        *count = find_candidates(spline, errors, tolerance, candidates);
        for (int i = 0; i < *count; i++)
            order[i] = candidates[i].knot;
    }
    bat_release(errors);
    bat_release(candidates);
    return status;
}

/* The knots of the best so far without those that are gone. */
static batten_status without(reduction *work, int gone_count, bat_spline *out)
{
    const bat_spline *s = &work->best;
    const batten_status status =
        bat_spline_make(s->degree, s->count - gone_count, s->width, out);
    for (int j = 0, k = 0; status == BATTEN_OK && j < s->count + s->degree + 1; j++)
        if (!work->gone[j])
            out->knots[k++] = s->knots[j];
    return status;
}

static void mark(reduction *work, int from, int to, bool gone)
{
    for (int i = from; i < to; i++)
        work->gone[work->order[i]] = gone;
}

/* Ranked knots that wait to be tried together. */
typedef struct {
    int from, to;
} block;

/* All ranked knots at once; a block that cannot go is tried by halves, as long as work is left.
 */
static batten_status reduce_once(reduction *work, int *removed)
{
    block waiting[64] = {{0, work->count}};
    bat_spline kept = {0};
    double kept_error = 0;
    batten_status status = BATTEN_OK;
    *removed = 0;
    memset(work->gone, 0,
           (size_t)(work->best.count + work->best.degree + 1) * sizeof *work->gone);
    for (int depth = work->count > 0; status == BATTEN_OK && depth > 0 && work->left > 0;) {
        const block b = waiting[--depth];
        bat_spline trial = {0};
        double error = HUGE_VAL;
        work->left--;
        mark(work, b.from, b.to, true);
        status = without(work, *removed + b.to - b.from, &trial);
        if (status == BATTEN_OK)
            status = solve(work, &trial, &error);
        if (status == BATTEN_OK && error <= work->tolerance) {
            bat_spline_free(&kept);
            kept = trial;
            kept_error = error;
            *removed += b.to - b.from;
            continue;
        }
        bat_spline_free(&trial);
        mark(work, b.from, b.to, false);
        const int middle = b.from + (b.to - b.from) / 2;
        if (middle > b.from) {
            waiting[depth++] = (block){middle, b.to};
            waiting[depth++] = (block){b.from, middle};
        }
    }
    if (status == BATTEN_OK && *removed > 0) {
        bat_spline_free(&work->best);
        work->best = kept;
        work->error = kept_error;
    } else {
        bat_spline_free(&kept);
    }
    return status;
}

static void find_weights(reduction *work)
{
    const bat_spline *fine = work->fine;
    for (int i = 0; i < fine->count; i++)
        work->weights[i] = sqrt((fine->knots[i + fine->degree + 1] - fine->knots[i]) /
                                (fine->knots[fine->count] - fine->knots[fine->degree]));
}

static batten_status reduce(reduction *work)
{
    batten_status status = BATTEN_OK;
    int removed = 1;
    while (status == BATTEN_OK && removed > 0) {
        status = bat_spline_rank_knots(&work->best, work->group, work->tolerance, work->order,
                                       &work->count);
        if (status == BATTEN_OK)
            status = reduce_once(work, &removed);
    }
    return status;
}

static bool is_clamped(const bat_spline *s)
{
    return s->knots[0] == s->knots[s->degree] &&
           s->knots[s->count] == s->knots[s->count + s->degree];
}

batten_status bat_spline_reduce_knots(const bat_spline *fine, size_t group, double tolerance,
                                      bat_spline *coarse, double *error)
{
    if (!(tolerance > 0) || !is_clamped(fine))
        return BATTEN_OK;
    const size_t knots = (size_t)fine->count + (size_t)fine->degree + 1;
    reduction work = {.fine = fine,
                      .group = group,
                      .tolerance = tolerance,
                      .best = *coarse,
                      .error = *error,
                      /* Some dozens of knots one by one, however many there are. */
                      .left = (int)(64 * bat_log2(2.0 + fine->count))};
    work.order = bat_array(knots, sizeof *work.order);
    work.gone = bat_array(knots, sizeof *work.gone);
    work.weights = bat_array((size_t)fine->count, sizeof *work.weights);
    work.row = bat_array(fine->width, sizeof *work.row);
    batten_status status =
        work.order && work.gone && work.weights && work.row ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        find_weights(&work);
        work.error = bat_min(*error, difference(&work, coarse));
        status = reduce(&work);
    }
    *coarse = work.best;
    *error = work.error;
    bat_release(work.order);
    bat_release(work.gone);
    bat_release(work.weights);
    bat_release(work.row);
    return status;
}
