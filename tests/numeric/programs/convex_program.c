#include "numeric/programs/convex_program.h"
#include "numeric/programs/quadratic_program.h"

#include "support/test.h"

#include <math.h>

enum { N = 40, BAND = 3, M = 90, WIDE = BAND + 1 };

/* A random program in a band: H diagonally dominant, rows of up to four neighbours. */
typedef struct {
    int n, m, start[M + 1], column[M * WIDE];
    double hessian[N * WIDE], linear[N], value[M * WIDE], bounds[M], prices[M];
    double x[N], multipliers[M], beyond[M];
} sample;

static bat_convex_program program_of(const sample *s)
{
    return (bat_convex_program){
        s->n,      BAND,     s->hessian, s->linear, {s->m, s->start, s->column, s->value},
        s->bounds, s->prices};
}

static bat_convex_solution solution_of(sample *s)
{
    return (bat_convex_solution){s->x, s->multipliers, s->beyond};
}

static void fill_sample(test_random *random, int n, int m, sample *s)
{
    s->n = n;
    s->m = m;
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < BAND; k++)
            s->hessian[i * WIDE + k] = i - BAND + k < 0 ? 0 : test_random_in(random, -1, 1);
        s->hessian[i * WIDE + BAND] = 2 * BAND + test_random_in(random, 0.1, 1);
        s->linear[i] = test_random_in(random, -9, 9);
    }
    for (int i = 0; i < m; i++) {
        const int first = (int)test_random_in(random, 0, n - BAND);
        s->start[i] = WIDE * i;
        for (int k = 0; k < WIDE; k++) {
            s->column[WIDE * i + k] = first + k;
            s->value[WIDE * i + k] = test_random_in(random, -1, 1);
        }
        s->bounds[i] = test_random_in(random, 0.01, 0.3); /* zeros are inside */
        s->prices[i] = HUGE_VAL;
    }
    s->start[m] = WIDE * m;
}

static double entry(const sample *s, int i, int j)
{
    const int row = i > j ? i : j, back = row - (i > j ? j : i);
    return back > BAND ? 0 : s->hessian[row * WIDE + BAND - back];
}

static double row_value(const sample *s, int i, const double *x)
{
    double sum = 0;
    for (int k = s->start[i]; k < s->start[i + 1]; k++)
        sum += s->value[k] * x[s->column[k]];
    return sum;
}

/* The largest entry of H x + c + At z. */
static double gradient_left(const sample *s)
{
    double left[N], largest = 0;
    for (int i = 0; i < s->n; i++) {
        left[i] = s->linear[i];
        for (int j = 0; j < s->n; j++)
            left[i] += entry(s, i, j) * s->x[j];
    }
    for (int i = 0; i < s->m; i++)
        for (int k = s->start[i]; k < s->start[i + 1]; k++)
            left[s->column[k]] += s->multipliers[i] * s->value[k];
    for (int i = 0; i < s->n; i++)
        largest = fmax(largest, fabs(left[i]));
    return largest;
}

TEST(the_minimum_of_a_convex_program_meets_the_conditions_of_kuhn_and_tucker)
{
    test_random random = test_random_begin("convex program");
    for (int c = 0; c < test_cases(60); c++) {
        sample s;
        fill_sample(&random, BAND + 1 + c % (N - BAND), c % (M + 1), &s);
        const bat_convex_program program = program_of(&s);
        bat_convex_solution out = solution_of(&s);
        bat_convex_report report;
        CHECK_OK(bat_convex_program_solve(&program, NULL, &out, &report));
        CHECK(gradient_left(&s) < 1e-5);
        for (int i = 0; i < s.m; i++) {
            const double room = s.bounds[i] - row_value(&s, i, s.x);
            CHECK(room > -1e-9);
            CHECK(s.multipliers[i] >= 0);
            CHECK(fabs(room * s.multipliers[i]) < 1e-5);
        }
    }
}

/* The same program for the solver of dense ones, which asks for rows from below. */
static batten_status solve_densely(const sample *s, double *x)
{
    double h[N * N], g[N], rows[M * N] = {0}, values[M];
    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < s->n; j++)
            h[i * s->n + j] = entry(s, i, j);
    for (int i = 0; i < s->n; i++)
        g[i] = -s->linear[i];
    for (int i = 0; i < s->m; i++) {
        for (int k = s->start[i]; k < s->start[i + 1]; k++)
            rows[i * s->n + s->column[k]] = -s->value[k];
        values[i] = -s->bounds[i];
    }
    const bat_quadratic_program dense = {s->n, h, g, 0, NULL, NULL, s->m, rows, values};
    bat_quadratic_report report;
    return bat_quadratic_program_solve(&dense, x, NULL, &report);
}

TEST(programs_in_a_band_and_dense_ones_have_the_same_minimum)
{
    test_random random = test_random_begin("convex against dense");
    for (int c = 0; c < test_cases(40); c++) {
        sample s;
        double x[N];
        fill_sample(&random, 8 + c % (N - 7), 2 * c % (M + 1), &s);
        const bat_convex_program program = program_of(&s);
        bat_convex_solution out = solution_of(&s);
        bat_convex_report report;
        CHECK_OK(solve_densely(&s, x));
        CHECK_OK(bat_convex_program_solve(&program, NULL, &out, &report));
        for (int i = 0; i < s.n; i++)
            CHECK_NEAR(s.x[i], x[i], 1e-4);
    }
}

TEST(a_row_with_a_price_yields_where_it_costs_less_than_holding)
{
    /* (x - 3)^2 / 2 with x <= 1: held it costs 2; a price of 1/2 lets x go to 3 - 1/2. */
    const int start[] = {0, 1}, column[] = {0};
    const double hessian[] = {1}, linear[] = {-3}, value[] = {1}, bound[] = {1};
    const double prices[] = {0.5, 5};
    for (int k = 0; k < 2; k++) {
        const bat_convex_program program = {
            1, 0, hessian, linear, {1, start, column, value}, bound, prices + k};
        double x, multiplier, beyond;
        bat_convex_solution out = {&x, &multiplier, &beyond};
        bat_convex_report report;
        CHECK_OK(bat_convex_program_solve(&program, NULL, &out, &report));
        CHECK_NEAR(x, k == 0 ? 2.5 : 1, 1e-6);
        CHECK_NEAR(beyond, k == 0 ? 1.5 : 0, 1e-6);
        CHECK_NEAR(multiplier, k == 0 ? 0.5 : 2, 1e-6);
    }
}

TEST(conditions_that_exclude_each_other_are_refused)
{
    const int start[] = {0, 1, 2}, column[] = {0, 0};
    const double hessian[] = {1}, linear[] = {0}, value[] = {1, -1}, bound[] = {1, -2};
    const bat_convex_program program = {1,     0,   hessian, linear, {2, start, column, value},
                                        bound, NULL};
    double x = 7, multipliers[2], beyond[2];
    bat_convex_solution out = {&x, multipliers, beyond};
    bat_convex_report report;
    CHECK_STATUS(bat_convex_program_solve(&program, NULL, &out, &report),
                 BATTEN_NOT_COMPATIBLE);
    CHECK(x == 7);
}

TEST(a_neighbouring_program_starts_from_the_solution_before_it)
{
    test_random random = test_random_begin("warm start");
    int cold = 0, warm = 0;
    for (int c = 0; c < test_cases(20); c++) {
        sample s;
        double x[N];
        fill_sample(&random, N, M, &s);
        const bat_convex_program program = program_of(&s);
        bat_convex_solution out = solution_of(&s);
        bat_convex_report report;
        CHECK_OK(bat_convex_program_solve(&program, NULL, &out, &report));
        s.bounds[c % M] *= 0.9;
        CHECK_OK(bat_convex_program_solve(&program, &out, &out, &report));
        warm += report.iterations;
        memcpy(x, s.x, sizeof x);
        CHECK_OK(bat_convex_program_solve(&program, NULL, &out, &report));
        cold += report.iterations;
        for (int i = 0; i < N; i++)
            CHECK_NEAR(x[i], s.x[i], 1e-5);
    }
    CHECK(warm < cold);
}

/* The prices of every third row stay infinite. */
static void set_prices(test_random *random, sample *s)
{
    for (int i = 0; i < s->m; i++)
        s->prices[i] = i % 3 == 0 ? HUGE_VAL : test_random_in(random, 0.2, 4);
}

/* Kuhn and Tucker's conditions with excess: what yields costs its price, what holds less. */
static void check_priced(const sample *s)
{
    CHECK(gradient_left(s) < 1e-5);
    for (int i = 0; i < s->m; i++) {
        const double room = s->bounds[i] - row_value(s, i, s->x);
        CHECK(s->beyond[i] >= 0 && s->multipliers[i] >= 0);
        CHECK(isinf(s->prices[i]) ? s->beyond[i] == 0
                                  : s->multipliers[i] <= s->prices[i] * (1 + 1e-9));
        CHECK(room + s->beyond[i] > -1e-9);
        CHECK(fabs((room + s->beyond[i]) * s->multipliers[i]) < 1e-5);
        if (isfinite(s->prices[i]))
            CHECK(s->beyond[i] * (s->prices[i] - s->multipliers[i]) < 1e-5);
    }
}

TEST(priced_rows_start_from_the_solution_before_too)
{
    test_random random = test_random_begin("priced");
    int cold = 0, warm = 0, yielding = 0;
    for (int c = 0; c < test_cases(20); c++) {
        sample s;
        double x[N];
        fill_sample(&random, N, M, &s);
        set_prices(&random, &s);
        const bat_convex_program program = program_of(&s);
        bat_convex_solution out = solution_of(&s);
        bat_convex_report report;
        CHECK_OK(bat_convex_program_solve(&program, NULL, &out, &report));
        check_priced(&s);
        for (int i = 0; i < M; i++)
            yielding += s.beyond[i] > 1e-3;
        s.bounds[c % M] *= 0.9;
        CHECK_OK(bat_convex_program_solve(&program, &out, &out, &report));
        check_priced(&s);
        warm += report.iterations;
        memcpy(x, s.x, sizeof x);
        CHECK_OK(bat_convex_program_solve(&program, NULL, &out, &report));
        cold += report.iterations;
        for (int i = 0; i < N; i++)
            CHECK_NEAR(x[i], s.x[i], 1e-5);
    }
    if (test_cases(10) < 10) /* too few to compare, where allocations fail */
        return;
    CHECK(yielding > 0);
    CHECK(2 * warm <
          3 * cold); /* what rows yield is not taken over: it has to be found again */
}

TEST(objectives_without_a_minimum_are_refused)
{
    static const struct {
        double hessian[2];
        batten_status status;
        const char *says;
    } rows[] = {{{0, 0}, BATTEN_SINGULAR_SYSTEM, "is flat"},
                {{HUGE_VAL, 1}, BATTEN_SINGULAR_SYSTEM, "is flat"},
                {{-3, 1}, BATTEN_SINGULAR_SYSTEM, "is flat"},
                {{3, -1}, BATTEN_INCOMPLETE, "of 2 unknowns did not reach its minimum in 1 "}};
    const int start[] = {0};
    const double linear[] = {1, 1};
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_convex_program program = {
            2, 0, rows[i].hessian, linear, {0, start, NULL, NULL}, NULL, NULL};
        double x[2] = {7, 7};
        bat_convex_solution out = {x, NULL, NULL};
        bat_convex_report report;
        CHECK_STATUS(bat_convex_program_solve(&program, NULL, &out, &report), rows[i].status);
        CHECK_MESSAGE(rows[i].says);
        CHECK(x[0] == 7 && x[1] == 7);
    }
}

TEST(sizes_of_objective_and_rows_change_the_minimum_by_nothing)
{
    test_random random = test_random_begin("scaled");
    for (int c = 0; c < test_cases(10); c++) {
        sample s, scaled;
        const double size = c % 2 ? 1e9 : 1e-9;
        fill_sample(&random, 12, 20, &s);
        set_prices(&random, &s);
        scaled = s;
        for (int k = 0; k < s.n * WIDE; k++)
            scaled.hessian[k] *= size;
        for (int i = 0; i < s.n; i++)
            scaled.linear[i] *= size;
        for (int i = 0; i < s.m;
             i++) { /* rows in another unit: a price is of the objective's */
            for (int k = s.start[i]; k < s.start[i + 1]; k++)
                scaled.value[k] /= 1000;
            scaled.bounds[i] /= 1000;
            scaled.prices[i] *= 1000 * size;
        }
        const bat_convex_program program = program_of(&s), other = program_of(&scaled);
        bat_convex_solution out = solution_of(&s), into = solution_of(&scaled);
        bat_convex_report report;
        CHECK_OK(bat_convex_program_solve(&program, NULL, &out, &report));
        CHECK_OK(bat_convex_program_solve(&other, NULL, &into, &report));
        for (int i = 0; i < s.n; i++)
            CHECK_NEAR(scaled.x[i], s.x[i], 1e-6);
        for (int i = 0; i < s.m; i++) {
            CHECK_NEAR(scaled.beyond[i] * 1000, s.beyond[i], 1e-6);
            CHECK_NEAR(scaled.multipliers[i] / (1000 * size), s.multipliers[i], 1e-4);
        }
    }
}
