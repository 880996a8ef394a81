/*
 * A line of a hull made fair. What is sought is the difference from the quadratic nearest to the
 * values: the program for it has small numbers, and what is quadratic stays so.
 */
#include "loft/lines/line.h"
#include "fair/sign_pattern.h"
#include "numeric/banded.h"

#include <batten/text.h>
#include <batten/fair.h>

enum {
    P = BAT_LOFT_DEGREE,
    K = BAT_LOFT_SUPPORT,
    SAMPLES_OF_SPAN = 4,
    ROUNDS = 3,
    JUDGED = 241
};

/* In the mean a line moves by so much of the bound: less would repeat the rounding of the table,
 * more would rest on the bounds. As of a patch. */
static const double wanted_move = 0.25;

/* Between these the weight of f''', of unit size, is sought: below the first a line passes its
 * points, above the last it is a quadratic. */
static const double least_smooth = 1e-12, most_smooth = 1e3;

/* ---- the quadratic ---- */

/* a + b t + c t^2 with the least squares of the distances. */
static batten_status fit_quadratic(const bat_loft_line *line, double abc[3])
{
    double normal[9] = {0};
    memset(abc, 0, 3 * sizeof *abc);
    for (int k = 0; k < line->datum_count; k++) {
        const double power[3] = {1, line->t[k], line->t[k] * line->t[k]};
        for (int i = 0; i < 3; i++) {
            abc[i] += power[i] * (line->values[k] - line->values[0]);
            for (int j = 0; j <= i; j++)
                normal[3 * i + 2 - i + j] += power[i] * power[j];
        }
    }
    const batten_status status = bat_symmetric_factor(3, 2, normal);
    if (status == BATTEN_OK)
        bat_symmetric_solve(3, 2, normal, 1, abc);
    abc[0] += line->values[0];
    return status;
}

static batten_status set_quadratic(bat_line_program *f)
{
    const bat_loft_line *line = f->of;
    double abc[3];
    const batten_status status = fit_quadratic(line, abc);
    if (status != BATTEN_OK)
        return status;
    /* A coefficient is the blossom of the quadratic at its three knots. */
    for (int i = 0; i < line->count; i++) {
        const double *t = line->knots + i + 1;
        f->quadratic[i] = abc[0] + abc[1] * (t[0] + t[1] + t[2]) / 3 +
                          abc[2] * (t[0] * t[1] + t[1] * t[2] + t[0] * t[2]) / 3;
    }
    bat_loft_line_straighten(line, f->quadratic);
    for (int k = 0; k < line->datum_count; k++)
        f->missing[k] =
            (line->values[k] - bat_loft_line_at(line, f->quadratic, line->t[k], 0)) /
            line->within;
    return BATTEN_OK;
}

/* ---- rounds ---- */

static batten_status choose_signs(bat_line_program *f, const double *line)
{
    for (int k = 0; k < f->sample_count; k++)
        f->curvature[k] = bat_loft_line_at(f->of, line, f->sample[k], 2);
    return bat_sign_pattern(f->sample_count, f->curvature, f->of->changes, f->signs);
}

/* The line of the differences as they are. */
static void add_up(const bat_line_program *f, double *line)
{
    const bat_loft_line *of = f->of;
    for (int i = 0; i < of->count; i++)
        line[i] = f->quadratic[i] + of->within * f->x[i];
    if (of->pinned[0])
        line[0] = of->values[0];
    if (of->pinned[1])
        line[of->count - 1] = of->values[of->datum_count - 1];
    for (int i = 0; i < of->count && of->one_side; i++)
        line[i] = bat_max(line[i], 0); /* but for rounding it is */
    bat_loft_line_straighten(of, line);
}

static int count_inflections(const bat_loft_line *of, const double *line)
{
    double plane[2 * JUDGED];
    for (int k = 0; k < JUDGED; k++) {
        const double t = (double)k / (JUDGED - 1);
        plane[2 * k] = of->length * t;
        plane[2 * k + 1] = bat_loft_line_at(of, line, t, 0);
    }
    return batten_polyline_inflections(JUDGED, plane, of->height);
}

static double mean_move(const bat_line_program *f)
{
    double sum = 0;
    for (int k = 0; k < f->of->datum_count; k++) {
        const double room = f->of->rooms ? f->of->rooms[k] : 1;
        const double off =
            (bat_loft_line_at(f->of, f->x, f->of->t[k], 0) - f->missing[k]) / room;
        sum += off * off / f->of->datum_count;
    }
    return sqrt(sum);
}

static batten_status choose_smoothness(bat_line_program *f, double *factor)
{
    enum { TRIALS = 30 };
    double low = least_smooth, high = most_smooth;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < TRIALS && status == BATTEN_OK; k++) {
        bool holds;
        f->smooth = sqrt(low * high);
        bat_line_build(f, false);
        status = bat_line_solve_freely(f, factor, &holds);
        if (status == BATTEN_OK && mean_move(f) <= wanted_move)
            low = f->smooth;
        else
            high = f->smooth;
    }
    f->smooth = low;
    return status;
}

/* Rounds with rows on the signs, as long as there are too many changes: a pattern that is chosen
 * anew on the better line may be another. The best is kept. */
static batten_status fair_rounds(bat_line_program *f, double *line, int *found)
{
    double *tried = bat_arena_array(&f->arena, (size_t)f->of->count, sizeof *tried);
    double *factor = bat_arena_array(&f->arena, (size_t)f->of->count, K * sizeof *factor);
    if (!tried || !factor)
        return BATTEN_OUT_OF_MEMORY;
    bool holds;
    batten_status status = choose_smoothness(f, factor);
    bat_line_build(f, false);
    if (status == BATTEN_OK)
        status = bat_line_solve_freely(f, factor, &holds);
    if (status == BATTEN_OK && !holds)
        status = bat_line_solve(f);
    if (status != BATTEN_OK)
        return status;
    add_up(f, line);
    *found = count_inflections(f->of, line);
    memcpy(tried, line, (size_t)f->of->count * sizeof *tried);
    for (int k = 0; k < ROUNDS && status == BATTEN_OK && *found > f->of->changes; k++) {
        status = choose_signs(f, tried);
        bat_line_build(f, true);
        if (status == BATTEN_OK)
            status = bat_line_solve(f);
        if (status == BATTEN_NOT_COMPATIBLE) /* what was reached before stays */
            return BATTEN_OK;
        if (status != BATTEN_OK)
            break;
        add_up(f, tried);
        const int count = count_inflections(f->of, tried);
        if (count < *found) {
            *found = count;
            memcpy(line, tried, (size_t)f->of->count * sizeof *line);
        }
    }
    return status;
}

static void place_samples(bat_line_program *f)
{
    const double *knots = f->of->knots;
    for (int span = P; span < f->of->count; span++)
        for (int k = 0; k < SAMPLES_OF_SPAN; k++)
            f->sample[f->sample_count++] =
                knots[span] + (knots[span + 1] - knots[span]) * k / SAMPLES_OF_SPAN;
    f->sample[f->sample_count++] = 1;
}

static batten_status take_memory(bat_line_program *f)
{
    const size_t n = (size_t)f->of->count, d = sizeof(double),
                 data = (size_t)f->of->datum_count;
    const size_t samples = SAMPLES_OF_SPAN * n + 1, rows = 2 * data + samples + n;
    f->quadratic = bat_arena_array(&f->arena, n, d);
    f->missing = bat_arena_array(&f->arena, data, d);
    f->hessian = bat_arena_array(&f->arena, n, K * d);
    f->linear = bat_arena_array(&f->arena, n, d);
    f->x = bat_arena_array(&f->arena, n, d);
    f->start = bat_arena_array(&f->arena, rows + 1, sizeof *f->start);
    f->column = bat_arena_array(&f->arena, rows, K * sizeof *f->column);
    f->value = bat_arena_array(&f->arena, rows, K * d);
    f->bounds = bat_arena_array(&f->arena, rows, d);
    f->prices = bat_arena_array(&f->arena, rows, d);
    f->sample = bat_arena_array(&f->arena, samples, d);
    f->curvature = bat_arena_array(&f->arena, samples, d);
    f->signs = bat_arena_array(&f->arena, samples, sizeof *f->signs);
    return bat_arena_status(&f->arena);
}

static void pin_ends(bat_line_program *f)
{
    const bat_loft_line *of = f->of;
    const int last = of->count - 1;
    if (of->pinned[0])
        f->x[0] = (of->values[0] - f->quadratic[0]) / of->within;
    if (of->pinned[1])
        f->x[last] = (of->values[of->datum_count - 1] - f->quadratic[last]) / of->within;
    f->first = of->pinned[0];
    f->unknowns = of->count - of->pinned[0] - of->pinned[1];
    for (int k = 0; k < of->run_count; k++)
        f->unknowns -= of->runs[k].last - of->runs[k].first - 1;
}

/* The extent of the values. */
static double extent(const bat_loft_line *line)
{
    double least = line->values[0], most = line->values[0];
    for (int k = 1; k < line->datum_count; k++) {
        least = bat_min(least, line->values[k]);
        most = bat_max(most, line->values[k]);
    }
    return most - least;
}

batten_status bat_loft_line_fair(const bat_loft_line *line, double *f, int *found)
{
    bat_line_program made = {.of = line, .size = extent(line)};
    *found = 0;
    if (made.size == 0) {
        for (int i = 0; i < line->count; i++)
            f[i] = line->values[0];
        return BATTEN_OK;
    }
    batten_status status = take_memory(&made);
    if (status == BATTEN_OK)
        status = set_quadratic(&made);
    if (status == BATTEN_OK) {
        pin_ends(&made);
        place_samples(&made);
        status = fair_rounds(&made, f, found);
    }
    bat_arena_free(&made.arena);
    return status;
}

void bat_loft_say_bound(double bound, size_t room, char *text)
{
    batten_text_print(text, room, "%.4g", 1.0005 * bound);
}
