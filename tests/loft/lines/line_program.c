#include "loft/lines/line_program.h"

#include "support/test.h"

enum {
    INNER = 2,
    N = INNER + BAT_LOFT_SUPPORT,
    DATA = 5,
    SAMPLES = 3,
    ROWS = 2 * DATA + N + SAMPLES
};

/* A line with uneven knots and all the memory of its program. */
typedef struct {
    double knots[N + BAT_LOFT_SUPPORT], t[DATA], values[DATA], quadratic[N], missing[DATA];
    double hessian[BAT_LOFT_SUPPORT * N], linear[N], x[N], factor[BAT_LOFT_SUPPORT * N];
    int start[ROWS + 1], column[BAT_LOFT_SUPPORT * ROWS], signs[SAMPLES];
    double value[BAT_LOFT_SUPPORT * ROWS], bounds[ROWS], prices[ROWS], sample[SAMPLES];
    bat_loft_line line;
    bat_line_program program;
} bench;

static void begin_bench(bool pin_first, bool pin_last, bench *b)
{
    static const double inner[INNER] = {0.3, 0.55}, t[DATA] = {0, 0.2, 0.45, 0.8, 1},
                        missing[DATA] = {0.5, -0.3, 0.8, -0.6, 0.2},
                        quadratic[N] = {0.1, 0.3, -0.2, 0.4, 0.6, 0.5};
    *b = (bench){.signs = {1, -1, 1}, .sample = {0, 0.4, 1}};
    memcpy(b->t, t, sizeof t);
    memcpy(b->missing, missing, sizeof missing);
    memcpy(b->quadratic, quadratic, sizeof quadratic);
    bat_loft_knots(INNER, inner, b->knots);
    b->line = (bat_loft_line){.count = N,
                              .knots = b->knots,
                              .datum_count = DATA,
                              .t = b->t,
                              .values = b->values,
                              .within = 0.25,
                              .pinned = {pin_first, pin_last}};
    b->x[0] = pin_first ? 0.7 : 0;
    b->x[N - 1] = pin_last ? -0.4 : 0;
    b->program = (bat_line_program){.of = &b->line,
                                    .size = 2,
                                    .smooth = 1e-3,
                                    .quadratic = b->quadratic,
                                    .missing = b->missing,
                                    .first = pin_first,
                                    .unknowns = N - pin_first - pin_last,
                                    .hessian = b->hessian,
                                    .linear = b->linear,
                                    .x = b->x,
                                    .start = b->start,
                                    .column = b->column,
                                    .value = b->value,
                                    .bounds = b->bounds,
                                    .prices = b->prices,
                                    .sample_count = SAMPLES,
                                    .sample = b->sample,
                                    .signs = b->signs};
}

/* The squares of the moves, in bounds, and of f''' of unit size, which is constant on each span. */
static double sum_of_squares(const bench *b, const double *x)
{
    double sum = 0;
    for (int k = 0; k < DATA; k++) {
        const double off = bat_loft_line_at(&b->line, x, b->t[k], 0) - b->missing[k];
        sum += off * off;
    }
    for (int span = 3; span < N; span++) {
        const double h = b->knots[span + 1] - b->knots[span];
        const double third = bat_loft_line_at(&b->line, x, b->knots[span] + h / 3, 3) *
                             b->line.within / b->program.size;
        sum += b->program.smooth * h * third * third;
    }
    return sum;
}

TEST(a_line_of_greville_abscissas_is_its_parameter)
{
    bench b;
    double x[N], square[N];
    begin_bench(false, false, &b);
    for (int i = 0; i < N; i++) {
        const double *t = b.knots + i + 1;
        x[i] = (t[0] + t[1] + t[2]) / 3;
        square[i] = (t[0] * t[1] + t[1] * t[2] + t[2] * t[0]) / 3;
    }
    for (int k = 0; k <= 20; k++) {
        const double t = k / 20.;
        CHECK_NEAR(bat_loft_line_at(&b.line, x, t, 0), t, 1e-15);
        CHECK_NEAR(bat_loft_line_at(&b.line, x, t, 1), 1, 1e-14);
        CHECK_NEAR(bat_loft_line_at(&b.line, square, t, 0), t * t, 1e-15);
        CHECK_NEAR(bat_loft_line_at(&b.line, square, t, 1), 2 * t, 1e-14);
        CHECK_NEAR(bat_loft_line_at(&b.line, square, t, 2), 2, 1e-13);
        CHECK_NEAR(bat_loft_line_at(&b.line, square, t, 3), 0, 1e-11);
    }
}

/* The sum is quadratic: its differences are its derivatives. */
TEST(squares_have_the_derivatives_of_their_sum_with_either_end_pinned)
{
    for (int pin = 0; pin < 4; pin++) {
        bench b;
        begin_bench(pin & 1, pin & 2, &b);
        bat_line_build(&b.program, false);
        const int first = b.program.first;
        for (int i = 0; i < b.program.unknowns; i++) {
            double x[N], sum[4];
            memcpy(x, b.x, sizeof x);
            x[first + i] = 1;
            sum[1] = sum_of_squares(&b, x);
            x[first + i] = -1;
            sum[0] = sum_of_squares(&b, x);
            CHECK_NEAR(b.linear[i], (sum[1] - sum[0]) / 2, 1e-12);
            for (int j = bat_max_int(0, i - 3); j <= i; j++) {
                for (int k = 0; k < 4; k++) {
                    memcpy(x, b.x, sizeof x);
                    x[first + i] += k & 1 ? 1 : -1;
                    x[first + j] += k & 2 ? 1 : -1;
                    sum[k] = sum_of_squares(&b, x);
                }
                CHECK_NEAR(b.hessian[4 * i + 3 - (i - j)],
                           (sum[0] - sum[1] - sum[2] + sum[3]) / 4, 1e-11);
            }
        }
    }
}

/* What a row holds x to, of all coefficients, pinned ones included: sign f <= bound. */
static void check_row(const bench *b, int row, double t, int order, double sign, double bound)
{
    double square = 0, at_pinned = 0;
    const bat_line_program *f = &b->program;
    const int first = f->first;
    double entry[N] = {0};
    for (int k = f->start[row]; k < f->start[row + 1]; k++)
        entry[f->column[k]] += f->value[k];
    for (int i = 0; i < N; i++) {
        double unit[N] = {0};
        unit[i] = 1;
        const double value = sign * bat_loft_line_at(f->of, unit, t, order);
        if (i >= first && i < first + f->unknowns)
            square += value * value;
        else
            at_pinned += value * b->x[i];
    }
    for (int i = first; i < first + f->unknowns; i++) {
        double unit[N] = {0};
        unit[i] = 1;
        CHECK_NEAR(entry[i - first],
                   sign * bat_loft_line_at(f->of, unit, t, order) / sqrt(square), 1e-14);
    }
    CHECK_NEAR(f->bounds[row], (bound - at_pinned) / sqrt(square), 1e-13);
}

TEST(rows_hold_the_data_within_their_bounds_and_then_the_signs)
{
    for (int pin = 0; pin < 4; pin++) {
        bench b;
        int row = 0;
        begin_bench(pin & 1, pin & 2, &b);
        bat_line_build(&b.program, true);
        for (int k = 0; k < DATA; k++) {
            if ((k == 0 && (pin & 1)) || (k == DATA - 1 && (pin & 2)))
                continue; /* nothing is free there */
            check_row(&b, row, b.t[k], 0, 1, b.missing[k] + 0.995);
            check_row(&b, row + 1, b.t[k], 0, -1, 0.995 - b.missing[k]);
            CHECK(b.prices[row] == HUGE_VAL && b.prices[row + 1] == HUGE_VAL);
            row += 2;
        }
        for (int k = 0; k < SAMPLES; k++, row++) {
            const double bend = bat_loft_line_at(&b.line, b.quadratic, b.sample[k], 2) / 0.25;
            check_row(&b, row, b.sample[k], 2, -b.signs[k], b.signs[k] * bend);
            CHECK(b.prices[row] == 30);
        }
        CHECK_INT(b.program.row_count, row);
    }
}

TEST(one_side_is_a_row_for_each_coefficient_that_is_free)
{
    for (int pin = 0; pin < 4; pin++) {
        bench b;
        begin_bench(pin & 1, pin & 2, &b);
        bat_line_build(&b.program, false);
        const int before = b.program.row_count, last = b.program.unknowns;
        b.line.one_side = true;
        bat_line_build(&b.program, false);
        CHECK_INT(b.program.row_count, before + last);
        for (int i = 0; i < last; i++) {
            const int row = before + i;
            double sum = 0;
            CHECK_NEAR(b.bounds[row], b.quadratic[b.program.first + i] / 0.25, 1e-15);
            for (int k = b.start[row]; k < b.start[row + 1]; k++) {
                CHECK(b.value[k] == (b.column[k] == i ? -1 : 0));
                sum += b.value[k];
            }
            CHECK(sum == -1 && b.prices[row] == HUGE_VAL);
        }
    }
}

TEST(without_rows_that_bind_both_ways_of_solving_find_the_least_sum)
{
    for (int pin = 0; pin < 4; pin++) {
        bench b;
        double x[N];
        bool holds = false;
        begin_bench(pin & 1, pin & 2, &b);
        bat_line_build(&b.program, false);
        CHECK_OK(bat_line_solve_freely(&b.program, b.factor, &holds));
        CHECK(holds);
        memcpy(x, b.x, sizeof x);
        const double least = sum_of_squares(&b, x);
        for (int i = 0; i < b.program.unknowns; i++)
            for (int side = -1; side <= 1; side += 2) {
                memcpy(x, b.x, sizeof x);
                x[b.program.first + i] += 1e-3 * side;
                CHECK(sum_of_squares(&b, x) > least);
            }
        memcpy(x, b.x, sizeof x);
        bat_line_build(&b.program, false);
        CHECK_OK(bat_line_solve(&b.program));
        for (int i = 0; i < N; i++)
            CHECK_NEAR(b.x[i], x[i], 1e-6);
    }
}

TEST(a_row_that_the_least_sum_breaks_is_told_and_kept_by_the_program)
{
    bench b;
    bool holds = true;
    begin_bench(false, false, &b);
    b.program.smooth =
        1e4; /* the data are 0.8 and less off a quadratic, and once more than 0.995 */
    b.missing[2] = 1.9;
    bat_line_build(&b.program, false);
    CHECK_OK(bat_line_solve_freely(&b.program, b.factor, &holds));
    CHECK(!holds);
    CHECK_OK(bat_line_solve(&b.program));
    for (int k = 0; k < DATA; k++)
        CHECK(fabs(bat_loft_line_at(&b.line, b.x, b.t[k], 0) - b.missing[k]) < 0.9951);
}

/* Of the whole line, its quadratic too: squares of moves and of f''' of unit size. */
static double sum_of_whole(const bench *b, const double *x)
{
    double line[N], sum = 0;
    for (int i = 0; i < N; i++)
        line[i] = b->quadratic[i] + b->line.within * x[i];
    for (int k = 0; k < DATA; k++) {
        const double off = bat_loft_line_at(&b->line, x, b->t[k], 0) - b->missing[k];
        sum += off * off;
    }
    for (int span = 3; span < N; span++) {
        const double h = b->knots[span + 1] - b->knots[span];
        const double third =
            bat_loft_line_at(&b->line, line, b->knots[span] + h / 3, 3) / b->program.size;
        sum += b->program.smooth * h * third * third;
    }
    return sum;
}

/* Every coefficient that is free is moved either way, and the run with it. */
static void check_least(const bench *b, bat_straight_run run, int first, int last)
{
    const double least = sum_of_whole(b, b->x);
    for (int i = first; i <= last; i++)
        for (int side = -1; side <= 1 && (i <= run.first || i >= run.last); side += 2) {
            double x[N];
            memcpy(x, b->x, sizeof x);
            x[i] += 1e-3 * side;
            bat_loft_line_straighten(&b->line, x);
            CHECK(sum_of_whole(b, x) > least);
        }
}

TEST(straight_runs_leave_the_least_sum_of_lines_that_are_straight_there)
{
    static const bat_straight_run runs[] = {{0, 3}, {1, 4}, {2, 5}, {0, 4}, {1, 5}, {0, 5}};
    for (int k = 0; k < COUNT(runs); k++)
        for (int pin = 0; pin < (runs[k].last - runs[k].first < 5 ? 4 : 3); pin++) {
            bench b;
            bool holds;
            begin_bench(pin & 1, pin & 2, &b);
            b.line.run_count = 1;
            b.line.runs = runs + k;
            b.program.smooth = 1e-2;
            b.program.unknowns -= runs[k].last - runs[k].first - 1;
            bat_loft_line_straighten(&b.line, b.quadratic);
            bat_line_build(&b.program, false);
            CHECK_OK(bat_line_solve_freely(&b.program, b.factor, &holds));
            CHECK(!(pin & 1) || b.x[0] == 0.7);
            CHECK(!(pin & 2) || b.x[N - 1] == -0.4);
            check_least(&b, runs[k], pin & 1, N - 1 - (pin >> 1));
        }
}
