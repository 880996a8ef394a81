/*
 * The batten of least energy within bounds, by a primal-dual interior-point method.
 *
 * Unknown are the moves s_i of each duck along the free rows of its frame, and the slopes of
 * the batten at the ducks: with these the energy is that of a chain of beams, and its matrix a
 * narrow positive definite band, which the multipliers of the bounds only make heavier on the
 * diagonal. With f the energy, g_i = (within_i^2 - |s_i|^2) / 2 >= 0 and multipliers l_i >= 0
 * we follow
 *
 *     grad f_i + l_i s_i = 0,   l_i g_i = mu,   mu -> 0.
 *
 * Each step solves one banded system, and their number hardly depends on the count of ducks.
 * Source: [NW06] ch. 16 and 19; [HL93] for the beam form of the cubic spline.
 */
#include "base/work.h"
#include "fair/elastic_batten.h"
#include "numeric/banded.h"

#include <float.h>
#include <string.h>

typedef struct {
    const bat_batten *batten;
    const bat_ducks *ducks;
    int width, block, lower; /* unknowns of a duck: `width` moves, `width` slopes */
    double *z, *moments, *forces;
    double *s, *gradient; /* [count][width], along the frames */
    double *multiplier;   /* [count] */
    double *matrix;       /* [count * block][lower + 1] */
    double *step;         /* [count][block] */
    double objective;
} interior;

static const double *frame_row(const interior *p, int i, int row)
{
    return p->ducks->frames + ((size_t)i * (size_t)p->width + (size_t)row) * (size_t)p->width;
}

/* The part of the moves of duck i that is free. */
static double move_dot(const interior *p, int i, const double *a, const double *b)
{
    return bat_dot(p->ducks->freedom[i], a + i * p->width, b + i * p->width);
}

/* g_i; a place away from the rim is the least that the numbers can tell from 0. */
static double gap(const interior *p, int i)
{
    const double square = p->ducks->within[i] * p->ducks->within[i];
    return bat_max(square - move_dot(p, i, p->s, p->s), DBL_EPSILON * square) / 2;
}

/* ---- where the ducks are ---- */

static void place_ducks(interior *p)
{
    const int width = p->width;
    for (int i = 0; i < p->batten->count; i++)
        for (int k = 0; k < width; k++) {
            double move = 0;
            for (int row = 0; row < p->ducks->freedom[i]; row++)
                move += p->s[i * width + row] * frame_row(p, i, row)[k];
            p->z[i * width + k] = p->ducks->centre[i * width + k] + move;
        }
}

/* The objective there, its gradient along the frames. */
static void differentiate(interior *p)
{
    const int width = p->width;
    const bat_ducks *ducks = p->ducks;
    p->objective = bat_batten_bend(p->batten, width, p->z, p->moments, p->forces) / 2;
    for (int i = 0; i < p->batten->count; i++) {
        double total[3] = {0};
        for (int k = 0; k < width; k++) {
            const double away =
                ducks->pull ? p->z[i * width + k] - ducks->anchor[i * width + k] : 0;
            const double pull = ducks->pull ? ducks->pull[i] * away : 0;
            total[k] = p->forces[i * width + k] + pull;
            p->objective += pull * away / 2;
        }
        for (int row = 0; row < ducks->freedom[i]; row++)
            p->gradient[i * width + row] = bat_dot(width, frame_row(p, i, row), total);
    }
}

/* ---- the system ---- */

static void add_entry(interior *p, int row, int column, double value)
{
    const int high = bat_max_int(row, column), low = bat_min_int(row, column);
    p->matrix[(size_t)high * (size_t)(p->lower + 1) + (size_t)(low - high + p->lower)] += value;
}

/* A beam of length h between the ducks i and i + 1. */
static void add_beam(interior *p, int i)
{
    const double h = p->batten->t[i + 1] - p->batten->t[i];
    const int width = p->width;
    for (int k = 0; k < width; k++) {
        const int slope = i * p->block + width + k, next = slope + p->block;
        add_entry(p, slope, slope, 4 / h);
        add_entry(p, next, next, 4 / h);
        add_entry(p, next, slope, 2 / h);
    }
    for (int end = 0; end < 2; end++)
        for (int row = 0; row < p->ducks->freedom[i + end]; row++) {
            const double *axis = frame_row(p, i + end, row), sign = end == 0 ? 1 : -1;
            const int move = (i + end) * p->block + row;
            add_entry(p, move, move, 12 / (h * h * h));
            for (int k = 0; k < width; k++) {
                add_entry(p, i * p->block + width + k, move, sign * 6 / (h * h) * axis[k]);
                add_entry(p, (i + 1) * p->block + width + k, move,
                          sign * 6 / (h * h) * axis[k]);
            }
            for (int other = 0; end == 1 && other < p->ducks->freedom[i]; other++)
                add_entry(p, move, i * p->block + other,
                          -12 / (h * h * h) * bat_dot(width, axis, frame_row(p, i, other)));
        }
}

/* Springs and bounds on duck i; moves that it may not make are pinned. */
static void add_duck(interior *p, int i, double mu)
{
    const int free = p->ducks->freedom[i], first = i * p->block;
    const double *s = p->s + i * p->width;
    double *right = p->step + first;
    memset(right, 0, (size_t)p->block * sizeof *right);
    for (int row = free; row < p->width; row++)
        add_entry(p, first + row, first + row, 1);
    if (free == 0)
        return;
    const double g = gap(p, i), l = p->multiplier[i];
    const double pull = p->ducks->pull ? p->ducks->pull[i] : 0;
    for (int row = 0; row < free; row++) {
        add_entry(p, first + row, first + row, pull + l);
        for (int other = 0; other <= row; other++)
            add_entry(p, first + row, first + other, l / g * s[row] * s[other]);
        right[row] = -(p->gradient[i * p->width + row] + mu / g * s[row]);
    }
}

static batten_status solve_step(interior *p, double mu)
{
    const int n = p->batten->count, unknowns = n * p->block;
    memset(p->matrix, 0, (size_t)unknowns * (size_t)(p->lower + 1) * sizeof *p->matrix);
    for (int i = 0; i + 1 < n; i++)
        add_beam(p, i);
    for (int i = 0; i < n; i++)
        add_duck(p, i, mu);
    batten_status status = bat_symmetric_factor(unknowns, p->lower, p->matrix);
    if (status == BATTEN_OK)
        bat_symmetric_solve(unknowns, p->lower, p->matrix, 1, p->step);
    return status;
}

/* ---- the path ---- */

/* What a full step does to the multiplier of duck i. */
static double multiplier_step(const interior *p, int i, double mu)
{
    const double *step = p->step + i * p->block, *s = p->s + i * p->width;
    const double g = gap(p, i), l = p->multiplier[i];
    return (mu - l * g + l * bat_dot(p->ducks->freedom[i], s, step)) / g;
}

/* The part of the step that ends on the rim of the ball of duck i: |s + a d| = within. */
static double to_rim(const interior *p, int i)
{
    const double *d = p->step + i * p->block, *s = p->s + i * p->width;
    const int free = p->ducks->freedom[i];
    const double dd = bat_dot(free, d, d), sd = bat_dot(free, s, d), g2 = 2 * gap(p, i);
    if (dd == 0)
        return HUGE_VAL;
    const double root = sqrt(sd * sd + dd * g2);
    return sd > 0 ? g2 / (sd + root) : (root - sd) / dd;
}

static double longest_step(const interior *p, double mu)
{
    double longest = HUGE_VAL;
    for (int i = 0; i < p->batten->count; i++) {
        if (p->ducks->freedom[i] == 0)
            continue;
        const double change = multiplier_step(p, i, mu);
        longest = bat_min(longest, to_rim(p, i));
        if (change < 0)
            longest = bat_min(longest, -p->multiplier[i] / change);
    }
    return bat_min(1,
                   0.99 * longest); /* stay inside: the usual part of the way to the boundary */
}

static void advance_step(interior *p, double mu, double part)
{
    for (int i = 0; i < p->batten->count; i++) {
        const int free = p->ducks->freedom[i];
        if (free > 0)
            p->multiplier[i] += part * multiplier_step(p, i, mu);
        for (int row = 0; row < free; row++)
            p->s[i * p->width + row] += part * p->step[i * p->block + row];
    }
}

/* The sum of l g, which bounds how much of the objective is left; `*count` free ducks. */
static double complementarity(const interior *p, int *count)
{
    double sum = 0;
    *count = 0;
    for (int i = 0; i < p->batten->count; i++)
        if (p->ducks->freedom[i] > 0) {
            sum += p->multiplier[i] * gap(p, i);
            ++*count;
        }
    return sum;
}

/* How far the least calm duck would still go, as a part of its bound; the rounding of the
 * forces (a dozen operations on ordinates, over K_ii, which is as many of the same terms) left
 * out. */
static double unrest(interior *p)
{
    double most = 0, size = 0, to[3];
    for (int i = 0; i < p->batten->count * p->width; i++)
        size = bat_max(size, fabs(p->z[i]));
    for (int i = 0; i < p->batten->count; i++) {
        if (p->ducks->freedom[i] == 0)
            continue;
        double *z = p->z + i * p->width;
        bat_clip(p->width, p->ducks->centre + i * p->width, p->ducks->within[i], z);
        bat_duck_release(p->batten, p->ducks, i, z, p->forces + i * p->width, 1, to);
        const double way = bat_distance(p->width, z, to) - 64 * DBL_EPSILON * size;
        most = bat_max(most, way / p->ducks->within[i]);
    }
    return most;
}

/* All in the middle of their bounds, under multipliers as large as the forces there need. */
static void start_in_middle(interior *p)
{
    double mu = 0;
    place_ducks(p);
    differentiate(p);
    for (int i = 0; i < p->batten->count; i++)
        mu = bat_max(mu, sqrt(move_dot(p, i, p->gradient, p->gradient)) * p->ducks->within[i]);
    for (int i = 0; i < p->batten->count; i++)
        if (p->ducks->freedom[i] > 0)
            p->multiplier[i] = mu / gap(p, i);
}

#define MAX_STEPS 100

static batten_status follow_path(interior *p, const batten_job *job)
{
    bat_work work = {job, 0};
    int count;
    double left = complementarity(p, &count), part = 1;
    /* Either hardly anything is left of what could be won, or there was nothing to win. */
    const double first = p->objective, none = 1e-22 * left;
    for (int k = 0; k < MAX_STEPS; k++) {
        if (left <= 1e-12 * (first - p->objective) + none && unrest(p) <= 1e-8)
            break;
        batten_status status =
            bat_work_step(&work, (uint64_t)p->batten->count, k / (double)MAX_STEPS, "fairing");
        if (status != BATTEN_OK)
            return status;
        /* After a short step first back to the middle of the path. */
        const double mu = left / count * (part > 0.9 ? 0.05 : 0.4);
        if (solve_step(p, mu) != BATTEN_OK)
            return BATTEN_OK; /* no digits are left: the residual tells how good it is */
        part = longest_step(p, mu);
        advance_step(p, mu, part);
        place_ducks(p);
        differentiate(p);
        left = complementarity(p, &count);
    }
    return BATTEN_OK;
}

static batten_status begin_interior(const bat_batten *batten, const bat_ducks *ducks,
                                    interior *p)
{
    const size_t n = (size_t)batten->count, w = (size_t)ducks->width;
    *p = (interior){.batten = batten, .ducks = ducks, .width = ducks->width};
    p->block = 2 * ducks->width;
    p->lower = 4 * ducks->width - 1;
    p->z = bat_array3(n, w, sizeof(double));
    p->moments = bat_array3(n, w, sizeof(double));
    p->forces = bat_array3(n, w, sizeof(double));
    p->s = bat_array3(n, w, sizeof(double));
    p->gradient = bat_array3(n, w, sizeof(double));
    p->multiplier = bat_array(n, sizeof(double));
    p->step = bat_array3(n, 2 * w, sizeof(double));
    p->matrix = bat_array3(n, 8 * w * w, sizeof(double));
    const bool all = p->z && p->moments && p->forces && p->s && p->gradient && p->multiplier &&
                     p->step && p->matrix;
    return all ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void end_interior(interior *p)
{
    bat_release(p->z);
    bat_release(p->moments);
    bat_release(p->forces);
    bat_release(p->s);
    bat_release(p->gradient);
    bat_release(p->multiplier);
    bat_release(p->step);
    bat_release(p->matrix);
}

batten_status bat_batten_least(const bat_batten *batten, const bat_ducks *ducks,
                               const batten_job *job, double *z, double *residual)
{
    interior p;
    batten_status status = begin_interior(batten, ducks, &p);
    if (status == BATTEN_OK) {
        start_in_middle(&p);
        status = follow_path(&p, job);
    }
    if (status == BATTEN_OK) {
        const double rest = unrest(&p);
        if (rest <= BAT_DUCK_AT_REST) {
            memcpy(z, p.z, (size_t)batten->count * (size_t)ducks->width * sizeof *z);
            *residual = rest;
        } else {
            status =
                bat_fail(BATTEN_TOLERANCE_NOT_MET,
                         "a released point would still move by %g of its bound, more than %g",
                         rest, BAT_DUCK_AT_REST);
        }
    }
    end_interior(&p);
    return status;
}
