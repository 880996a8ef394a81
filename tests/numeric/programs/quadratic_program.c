#include "numeric/programs/quadratic_program.h"

#include "support/test.h"

enum { N = 8, M = 10 };

static double dot(int n, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

/* H = the sum of squares of `rank` random rows. */
static void fill(test_random *random, int count, double *a)
{
    for (int i = 0; i < count; i++)
        a[i] = test_random_in(random, -1, 1);
}

static void fill_form(test_random *random, int n, int rank, double *h)
{
    double rows[N * N];
    fill(random, rank * n, rows);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            h[i * n + j] = 0;
            for (int k = 0; k < rank; k++)
                h[i * n + j] += rows[k * n + i] * rows[k * n + j];
        }
}

TEST(the_minimum_of_a_quadratic_program_meets_the_conditions_of_kuhn_and_tucker)
{
    test_random random = test_random_begin("quadratic program");
    for (int c = 0; c < test_cases(300); c++) {
        const int n = 3 + c % 6, equal = c % 3, least = c % (M + 1);
        double h[N * N], g[N], a[2 * N], b[2], e[M * N], f[M], inside[N], x[N], forces[M];
        fill_form(&random, n, n, h);
        fill(&random, n, g);
        fill(&random, equal * n, a);
        fill(&random, least * n, e);
        fill(&random, n, inside);
        /* All conditions hold at one point. */
        for (int i = 0; i < equal; i++)
            b[i] = dot(n, a + i * n, inside);
        for (int i = 0; i < least; i++)
            f[i] = dot(n, e + i * n, inside) - (i % 2 ? 0.1 : 0);
        bat_quadratic_report report;
        const bat_quadratic_program program = {n, h, g, equal, a, b, least, e, f};
        CHECK_OK(bat_quadratic_program_solve(&program, x, forces, &report));
        CHECK_INT(report.redundant, -1);
        for (int i = 0; i < equal; i++)
            CHECK_NEAR(dot(n, a + i * n, x), b[i], 1e-12);
        /* Forces do not pull, and press only where the inequality just holds. */
        double size = 1;
        for (int i = 0; i < n; i++)
            size = fmax(size, fabs(x[i]));
        for (int i = 0; i < least; i++) {
            const double room = dot(n, e + i * n, x) - f[i];
            CHECK(room > -1e-9 * size);
            CHECK(forces[i] >= -1e-12);
            CHECK_NEAR(forces[i] * room, 0, 1e-8 * (1 + forces[i]) * size);
        }
        /* No direction along the equations is downhill against the forces. */
        double gradient[N];
        for (int i = 0; i < n; i++) {
            gradient[i] = dot(n, h + i * n, x) - g[i];
            for (int j = 0; j < least; j++)
                gradient[i] -= forces[j] * e[j * n + i];
        }
        if (equal == 1) {
            const double part = dot(n, gradient, a) / dot(n, a, a);
            for (int i = 0; i < n; i++)
                gradient[i] -= part * a[i];
        }
        for (int i = 0; i < n && equal < 2; i++)
            CHECK_NEAR(gradient[i], 0, 1e-8 * (1 + size));
    }
}

/* The point of a polytope that is nearest to another, with many faces on the way. */
TEST(many_inequalities_are_taken_up_and_dropped_without_losing_the_minimum)
{
    enum { MANY = 24, FACES = 150 };
    test_random random = test_random_begin("polytope");
    static double h[MANY * MANY], e[FACES * MANY];
    double f[FACES], g[MANY], x[MANY], forces[FACES], gradient[MANY];
    int dropped = 0;
    for (int i = 0; i < MANY; i++)
        h[i * MANY + i] = 1;
    for (int c = 0; c < test_cases(20); c++) {
        fill(&random, FACES * MANY, e);
        for (int i = 0; i < FACES; i++)
            f[i] = -sqrt(dot(MANY, e + i * MANY, e + i * MANY));
        for (int i = 0; i < MANY; i++)
            g[i] = test_random_in(&random, -9, 9);
        bat_quadratic_report report;
        const bat_quadratic_program program = {MANY, h, g, 0, NULL, NULL, FACES, e, f};
        CHECK_OK(bat_quadratic_program_solve(&program, x, forces, &report));
        dropped += report.steps - report.active_count;
        CHECK(report.active_count > 3);
        for (int i = 0; i < MANY; i++)
            gradient[i] = x[i] - g[i];
        for (int j = 0; j < FACES; j++) {
            const double room = dot(MANY, e + j * MANY, x) - f[j];
            CHECK(room > -1e-9 && forces[j] >= 0);
            CHECK_NEAR(forces[j] * room, 0, 1e-9);
            for (int i = 0; i < MANY; i++)
                gradient[i] -= forces[j] * e[j * MANY + i];
        }
        for (int i = 0; i < MANY; i++)
            CHECK_NEAR(gradient[i], 0, 1e-11);
    }
    CHECK(dropped > 0);
}

TEST(a_form_that_vanishes_somewhere_is_enough_where_conditions_fix_the_rest)
{
    /* (x - y)^2 alone, with x + y = 2, and with y >= 3. */
    const double h[4] = {2, -2, -2, 2}, a[2] = {1, 1}, b[1] = {2}, e[2] = {0, 1}, f[1] = {3};
    double x[2], force[1];
    bat_quadratic_program program = {2, h, NULL, 1, a, b, 0, NULL, NULL};
    CHECK_OK(bat_quadratic_program_solve(&program, x, NULL, NULL));
    CHECK_NEAR(x[0], 1, 1e-14);
    CHECK_NEAR(x[1], 1, 1e-14);
    program.least_count = 1;
    program.least_rows = e;
    program.least_values = f;
    CHECK_OK(bat_quadratic_program_solve(&program, x, force, NULL));
    CHECK_NEAR(x[0], -1, 1e-14);
    CHECK_NEAR(x[1], 3, 1e-14);
    CHECK_NEAR(force[0], 16, 1e-12);
    program.equal_count = program.least_count = 0;
    CHECK_STATUS(bat_quadratic_program_solve(&program, x, NULL, NULL), BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("leave 2 of 2 unknowns free");
}

TEST(g9_conditions_that_repeat_or_contradict_are_named)
{
    const double h[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double a[9] = {1, 1, 0, 0, 1, 1, 1, 2, 1};
    double b[3] = {1, 2, 3}, x[3];
    bat_quadratic_report report;
    const bat_quadratic_program program = {3, h, NULL, 3, a, b, 0, NULL, NULL};
    CHECK_OK(bat_quadratic_program_solve(&program, x, NULL, &report));
    CHECK_INT(report.redundant, 2);
    CHECK_INT(report.redundant_count, 1);
    CHECK_INT(report.refused_equation, -1);
    CHECK_INT(report.refused_inequality, -1);
    CHECK_NEAR(x[0] + x[1], 1, 1e-14);
    b[2] = 4;
    CHECK_STATUS(bat_quadratic_program_solve(&program, x, NULL, &report),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("condition 3 contradicts those before it: they make it 3, not 4");
}

TEST(g9_inequalities_that_cannot_hold_are_named)
{
    /* x >= 1, y >= 1, x + y <= 1. */
    const double h[4] = {1, 0, 0, 1}, e[6] = {1, 0, 0, 1, -1, -1}, f[3] = {1, 1, -1};
    double x[2] = {7, 7};
    const bat_quadratic_program program = {2, h, NULL, 0, NULL, NULL, 3, e, f};
    bat_quadratic_report report;
    CHECK_STATUS(bat_quadratic_program_solve(&program, x, NULL, &report),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("inequality 3 cannot hold together with the others: it is missed by 1");
    CHECK_INT(report.refused_inequality, 2);
    CHECK_INT(report.refused_equation, -1);
    CHECK_NEAR(report.missed, 1, 1e-15);
    CHECK_NEAR(x[0], 7, 0);
    /* An impossible one without any unknown: 0 >= 1. */
    const double zero[2] = {0, 0}, one[1] = {1};
    const bat_quadratic_program never = {2, h, NULL, 0, NULL, NULL, 1, zero, one};
    CHECK_STATUS(bat_quadratic_program_solve(&never, x, NULL, NULL), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("inequality 1 cannot hold together with the others: it is missed by 1");
}

TEST(as_many_conditions_as_unknowns_leave_no_choice)
{
    const double h[4] = {0, 0, 0, 0}, a[4] = {2, 1, 1, -1}, b[2] = {5, 1};
    const double e[2] = {1, 0}, f[1] = {3};
    double x[2];
    bat_quadratic_program program = {2, h, NULL, 2, a, b, 0, e, f};
    CHECK_OK(bat_quadratic_program_solve(&program, x, NULL, NULL));
    CHECK_NEAR(x[0], 2, 1e-14);
    CHECK_NEAR(x[1], 1, 1e-14);
    program.least_count = 1;
    CHECK_STATUS(bat_quadratic_program_solve(&program, x, NULL, NULL), BATTEN_NOT_COMPATIBLE);
}

TEST(inequalities_that_the_equations_determine_are_held_or_named)
{
    /* x + y = 0.3 and x - y = 0.1: x is 0.2 but for rounding. */
    const double hessian[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, equal[] = {1, 1, 0, 1, -1, 0};
    const double values[] = {0.1 + 0.2, 0.1}, least[] = {1, 0, 0, 3, 1, 0};
    double bounds[] = {0.2, 0.7}, x[3];
    bat_quadratic_program program = {.count = 3,
                                     .hessian = hessian,
                                     .equal_count = 2,
                                     .equal_rows = equal,
                                     .equal_values = values,
                                     .least_count = 2,
                                     .least_rows = least,
                                     .least_values = bounds};
    bat_quadratic_report report;
    CHECK_OK(bat_quadratic_program_solve(&program, x, NULL, &report));
    CHECK_NEAR(x[0], 0.2, 1e-15);
    CHECK_INT(report.active_count, 0);
    bounds[1] = 0.8;
    CHECK_STATUS(bat_quadratic_program_solve(&program, x, NULL, &report),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_INT(report.refused_inequality, 1);
}

/* Of x = 1 and a row (1, tilt, 0) with this value: does the second follow, contradict, or say more? */
static const struct {
    double tilt, value;
    batten_status status;
    int redundant;
} seconds[] = {
    {0, 1, BATTEN_OK, 1},
    {0, 1 + 1.9e-9, BATTEN_OK, 1},
    {0, 1 - 1.9e-9, BATTEN_OK, 1},
    {0, 1 + 2.1e-9, BATTEN_NOT_COMPATIBLE, 0},
    {0, -1, BATTEN_NOT_COMPATIBLE, 0},
    {96 * DBL_EPSILON, 1, BATTEN_OK, 1},
    {97 * DBL_EPSILON, 1, BATTEN_OK, 0},
    {-97 * DBL_EPSILON, 1 + 97 * DBL_EPSILON, BATTEN_OK, 0},
};

TEST(an_equation_follows_from_others_within_their_rounding)
{
    static const double h[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (int i = 0; i < COUNT(seconds); i++) {
        const double rows[6] = {1, 0, 0, 1, seconds[i].tilt, 0};
        const double values[2] = {1, seconds[i].value};
        const bat_quadratic_program program = {3, h, NULL, 2, rows, values, 0, NULL, NULL};
        bat_quadratic_report report;
        double x[3];
        CHECK_STATUS(bat_quadratic_program_solve(&program, x, NULL, &report),
                     seconds[i].status);
        if (seconds[i].status == BATTEN_OK) {
            const double y = seconds[i].redundant ? 0 : (values[1] - 1) / rows[4];
            CHECK_INT(report.redundant_count, seconds[i].redundant);
            CHECK_INT(report.redundant, seconds[i].redundant ? 1 : -1);
            CHECK_INT(report.steps, 0);
            CHECK(x[0] == 1 && x[2] == 0);
            CHECK_NEAR(x[1], y, 1e-15);
        } else {
            CHECK_INT(report.refused_equation, 1);
            CHECK_NEAR(report.missed, fabs(values[1] - 1), 1e-15);
        }
    }
}

/* x^2 + least y^2 in two unknowns, where 16 roundings of the largest are too little. */
TEST(a_form_determines_what_it_has_more_of_than_rounding)
{
    static const double rounds[] = {17, 16};
    for (int i = 0; i < 2; i++) {
        const double h[4] = {1, 0, 0, rounds[i] * DBL_EPSILON}, g[2] = {2, DBL_EPSILON};
        const bat_quadratic_program program = {2, h, g, 0, NULL, NULL, 0, NULL, NULL};
        double x[2] = {7, 7};
        CHECK_STATUS(bat_quadratic_program_solve(&program, x, NULL, NULL),
                     i == 0 ? BATTEN_OK : BATTEN_SINGULAR_SYSTEM);
        CHECK(x[0] == (i == 0 ? 2 : 7));
        CHECK_NEAR(x[1], i == 0 ? 1 / 17.0 : 7, 1e-15);
    }
    CHECK_MESSAGE("leave 2 of 2 unknowns free");
}

/* The point of the corner x >= 1, y >= 2, x + y >= 4 that is nearest to (0, 0) and so on. */
static const struct {
    double g[2], x[2], force[3];
    int active;
} corners[] = {
    {{0, 0}, {2, 2}, {0, 0, 2}, 1},  {{0, 1}, {1.5, 2.5}, {0, 0, 1.5}, 1},
    {{-5, 4}, {1, 4}, {6, 0, 0}, 1}, {{-5, 2}, {1, 3}, {5, 0, 1}, 2},
    {{5, 1}, {5, 2}, {0, 1, 0}, 1},  {{2, -3}, {2, 2}, {0, 5, 0}, 1},
    {{0, -3}, {2, 2}, {0, 3, 2}, 2}, {{3, 3}, {3, 3}, {0, 0, 0}, 0},
};

TEST(the_nearest_point_of_a_corner_is_held_by_the_forces_of_its_sides)
{
    static const double h[4] = {1, 0, 0, 1}, e[6] = {1, 0, 0, 1, 1, 1}, f[3] = {1, 2, 4};
    for (int i = 0; i < COUNT(corners); i++) {
        const bat_quadratic_program program = {2, h, corners[i].g, 0, NULL, NULL, 3, e, f};
        bat_quadratic_report report;
        double x[2], force[3];
        CHECK_OK(bat_quadratic_program_solve(&program, x, force, &report));
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(x[k], corners[i].x[k], 1e-14);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(force[k], corners[i].force[k], 1e-14);
        CHECK(report.active_count >= corners[i].active && report.refused_inequality == -1);
    }
}
