/*
 * Newton's method for the energy of a chain of quintics, held back by Levenberg's and
 * Marquardt's diagonal where the energy is not convex. The matrix has a band whose width does
 * not depend on the number of nodes.
 */
#include "numeric/banded.h"
#include "numeric/vector.h"
#include "shape/bent/energy.h"
#include "shape/bent/energy_sum.h"

#include <float.h>
#include <string.h>

static void search_end(bat_energy_search *s)
{
    double *const arrays[] = {
        s->gradient, s->length_gradient, s->matrix, s->factor, s->right, s->step, s->kept};
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; i++)
        bat_release(arrays[i]);
    bat_release(s->span);
}

static batten_status search_begin(const bat_energy_task *task, bat_energy_curve *curve,
                                  bat_energy_search *s)
{
    const size_t n = (size_t)curve->unknown_count, w = (size_t)curve->band + 1;
    s->task = task;
    s->curve = curve;
    bat_energy_fill_basis(&s->basis);
    s->gradient = bat_array(n, sizeof *s->gradient);
    s->length_gradient = bat_array(n, sizeof *s->length_gradient);
    s->matrix = bat_array3(n, w, sizeof *s->matrix);
    s->factor = bat_array3(n, w, sizeof *s->factor);
    s->right = bat_array3(n, 3, sizeof *s->right);
    s->step = bat_array(n, sizeof *s->step);
    s->span = bat_array(1, sizeof *s->span);
    s->kept = bat_array3((size_t)curve->count, 3 * (size_t)curve->d, sizeof *s->kept);
    return s->gradient && s->length_gradient && s->matrix && s->factor && s->right && s->step &&
                   s->kept && s->span
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

/* ---- steps ---- */

static batten_status factor(bat_energy_search *s, double damping)
{
    const size_t n = (size_t)s->curve->unknown_count, w = (size_t)s->curve->band + 1;
    memcpy(s->factor, s->matrix, n * w * sizeof *s->factor);
    double largest = 0;
    for (size_t i = 0; i < n; i++)
        largest = bat_max(largest, fabs(s->matrix[i * w + w - 1]));
    /* Unknowns whose own row is next to nothing are held too. */
    for (size_t i = 0; i < n; i++)
        s->factor[i * w + w - 1] +=
            damping * bat_max(fabs(s->matrix[i * w + w - 1]), 1e-12 * largest);
    return bat_symmetric_factor((int)n, (int)w - 1, s->factor);
}

/*
 * The product E L^p adds to the matrix what length and energy do together: with a = E' and b =
 * L' it is M11 = 0, M12 = p L^(p-1), M22 = -p (p + 1) E L^(p-2) in terms of the gradient g =
 * L^p a + p E L^(p-1) b and b. Woodbury puts it into the solution. False when the result does
 * not point downhill.
 */
static bool correct(bat_energy_search *s)
{
    const int n = s->curve->unknown_count;
    const double p = bat_energy_power(s), L = s->length, m12 = p / L;
    const double m22 = -p * (p + 1) * s->energy * bat_energy_length_factor(s, L) / L / L;
    double gg = 0, gb = 0, bb = 0;
    for (int i = 0; i < n; i++) {
        gg += s->gradient[i] * s->right[2 * i];
        gb += s->gradient[i] * s->right[2 * i + 1];
        bb += s->length_gradient[i] * s->right[2 * i + 1];
    }
    /* The inverse of M plus the products, for the right side of the products with g. */
    const double a11 = -m22 / (m12 * m12) + gg, a12 = 1 / m12 + gb, a22 = bb;
    const double det = a11 * a22 - a12 * a12;
    const double u = (gg * a22 - gb * a12) / det, v = (a11 * gb - a12 * gg) / det;
    double downhill = 0;
    for (int i = 0; i < n; i++) {
        s->step[i] = -(s->right[2 * i] * (1 - u) - v * s->right[2 * i + 1]);
        downhill -= s->step[i] * s->gradient[i];
    }
    return isfinite(det) && downhill > 0 && downhill < 1e3 * gg;
}

static void solve(bat_energy_search *s)
{
    const int n = s->curve->unknown_count, band = s->curve->band;
    if (s->task->scale_invariant) {
        for (int i = 0; i < n; i++) {
            s->right[2 * i] = s->gradient[i];
            s->right[2 * i + 1] = s->length_gradient[i];
        }
        bat_symmetric_solve(n, band, s->factor, 2, s->right);
        if (correct(s))
            return;
    }
    for (int i = 0; i < n; i++)
        s->step[i] = -s->gradient[i];
    bat_symmetric_solve(n, band, s->factor, 1, s->step);
}

static void minimize_energy(bat_energy_search *s)
{
    const bat_energy_curve *curve = s->curve;
    const int d = curve->d;
    for (int row = 0; row < curve->count * 3; row++) {
        const double *frame = bat_energy_frame_of(curve, row / 3);
        double change[3] = {0};
        for (int k = 0; k < d; k++) {
            const int u = curve->unknown[row * d + k];
            const double by = u >= 0 ? s->step[u] : 0;
            for (int c = 0; c < d; c++)
                change[c] += frame[c * d + k] * by;
        }
        for (int c = 0; c < d; c++)
            curve->x[row * d + c] += change[c];
    }
}

/* The energy at x + step if it is less: then x moves there. */
static bool try_step(bat_energy_search *s)
{
    const size_t count = (size_t)s->curve->count * 3 * (size_t)s->curve->d;
    double energy, length, size;
    memcpy(s->kept, s->curve->x, count * sizeof *s->kept);
    minimize_energy(s);
    bat_energy_sum(s, &energy, &length, &size);
    if (bat_energy_objective(s, energy, length) <
        bat_energy_objective(s, s->energy, s->length)) {
        s->energy = energy;
        s->length = length;
        s->size = size;
        return true;
    }
    memcpy(s->curve->x, s->kept, count * sizeof *s->kept);
    return false;
}

/* How much the energy falls in the step, by its first derivative. */
static double promise(const bat_energy_search *s)
{
    return -bat_dot(s->curve->unknown_count, s->gradient, s->step) / 2;
}

/* Rounding alone bends a line by 1e-15 or so for each unit of length, which is the mean chord.
 */
#define STRAIGHT 1e-28

/* What rounding leaves of the energy: the densities are sums that cancel. */
static double rounding(const bat_energy_search *s)
{
    return 64 * DBL_EPSILON * bat_energy_objective(s, s->size, s->length);
}

/* One step down from x. LEAST when it promises no more than 1e-12 of the first energy. */
static batten_status descend(bat_energy_search *s, double *damping, double *remaining,
                             bat_energy_end *end)
{
    bat_energy_differentiate(s);
    for (int tries = 0; tries < 60; tries++) {
        const batten_status status = factor(s, *damping);
        if (status == BATTEN_OUT_OF_MEMORY)
            return status;
        if (status == BATTEN_OK) {
            solve(s);
            *remaining = promise(s);
            const double small = 1e-12 * s->first + rounding(s) + STRAIGHT * s->curve->spans;
            const bool done = *remaining <= small && *damping < 1e-2;
            *end = done ? BAT_ENERGY_LEAST : BAT_ENERGY_UNDERWAY;
            if (try_step(s)) {
                *damping = *damping < 1e-9 ? 0 : *damping / 10;
                return BATTEN_OK;
            }
            if (done || *remaining <= rounding(s)) {
                *end = BAT_ENERGY_LEAST;
                return BATTEN_OK;
            }
        }
        *damping = bat_max(1e-8, 10 * *damping);
    }
    *end = BAT_ENERGY_STUCK;
    return BATTEN_OK;
}

static batten_status minimise(bat_energy_search *s, batten_curve_minimum_energy_report *report,
                              bat_energy_end *end)
{
    bat_energy_sum(s, &s->energy, &s->length, &s->size);
    double damping = 1e-4;
    *end = s->curve->unknown_count == 0 ? BAT_ENERGY_LEAST : BAT_ENERGY_UNDERWAY;
    s->first = bat_energy_objective(s, s->energy, s->length);
    report->before = bat_max(0, s->first); /* sums that cancel may fall below */
    for (report->steps = 0; report->steps < s->task->max_steps && *end == BAT_ENERGY_UNDERWAY;
         report->steps++) {
        const batten_status status = descend(s, &damping, &report->remaining, end);
        if (status != BATTEN_OK)
            return status;
        if (s->length > s->task->longest)
            *end = BAT_ENERGY_GROWING;
    }
    report->after = bat_max(0, bat_energy_objective(s, s->energy, s->length));
    report->length = s->length;
    return BATTEN_OK;
}

batten_status bat_energy_minimise(const bat_energy_task *task, bat_energy_curve *curve,
                                  batten_curve_minimum_energy_report *report,
                                  bat_energy_end *end)
{
    bat_energy_search s = {.task = NULL};
    batten_status status = search_begin(task, curve, &s);
    if (status == BATTEN_OK)
        status = minimise(&s, report, end);
    search_end(&s);
    return status;
}
