/* Points and parameters beyond the ends of a row. */
#include "shape/points/mirrored_ends.h"
#include "support/test.h"

enum { N = 5, FAR = 23 };
static const double places[N + 1] = {1, 1.5, 3, 3.25, 5, 6.5};

static double cubic_at(double t, int k)
{
    return k == 0 ? t * (t - 2) * (t + 1) : 3 - t * t * t / 2;
}

static bat_row_beyond row_of(batten_phantoms kind, int degree, bool closed, double points[N][2])
{
    bat_row_beyond row;
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 2; k++)
            points[i][k] = cubic_at(places[i], k);
    const bat_beyond_rule rule = {
        .given = places, .closed = closed, .kind = kind, .degree = degree};
    CHECK_OK(bat_row_beyond_make((batten_points){2, N, &points[0][0]}, &rule, &row));
    return row;
}

TEST(parameters_of_an_open_row_are_mirrored_in_both_ends_without_end)
{
    double points[N][2];
    bat_row_beyond row = row_of(BATTEN_PHANTOM_REPEAT, 3, false, points);
    for (int i = 0; i < N; i++)
        CHECK_BITS(bat_parameter_beyond(&row, i), places[i]);
    for (int i = -FAR; i <= FAR; i++) {
        const double t = bat_parameter_beyond(&row, i);
        CHECK_NEAR(bat_parameter_beyond(&row, -i), 2 * places[0] - t, 1e-12);
        CHECK_NEAR(bat_parameter_beyond(&row, 2 * (N - 1) - i), 2 * places[N - 1] - t, 1e-12);
        CHECK(bat_parameter_beyond(&row, i + 1) > t);
    }
    bat_release(row.t);
}

TEST(reflected_points_are_mirrored_in_both_ends_without_end)
{
    double points[N][2];
    bat_row_beyond row = row_of(BATTEN_PHANTOM_REFLECT, 3, false, points);
    for (int i = -FAR; i <= FAR; i++) {
        double p[2], low[2], high[2];
        bat_point_beyond(&row, i, p);
        bat_point_beyond(&row, -i, low);
        bat_point_beyond(&row, 2 * (N - 1) - i, high);
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(low[k] + p[k], 2 * points[0][k], 1e-10);
            CHECK_NEAR(high[k] + p[k], 2 * points[N - 1][k], 1e-10);
            if (i >= 0 && i < N)
                CHECK_BITS(p[k], points[i][k]);
        }
    }
    bat_release(row.t);
}

TEST(repeated_points_are_the_ends)
{
    double points[N][2], p[2];
    bat_row_beyond row = row_of(BATTEN_PHANTOM_REPEAT, 3, false, points);
    for (int i = -4; i < N + 4; i++) {
        bat_point_beyond(&row, i, p);
        const int inside = i < 0 ? 0 : i < N ? i : N - 1;
        CHECK(p[0] == points[inside][0] && p[1] == points[inside][1]);
    }
    bat_release(row.t);
}

TEST(extrapolation_continues_a_polynomial_of_its_degree)
{
    double points[N][2], p[2];
    for (int degree = 3; degree <= 9; degree += 6) { /* more than the points determine: 4 */
        bat_row_beyond row = row_of(BATTEN_PHANTOM_EXTRAPOLATE, degree, false, points);
        for (int i = -3; i < N + 3; i++) {
            const double t = bat_parameter_beyond(&row, i);
            bat_point_beyond(&row, i, p);
            for (int k = 0; k < 2; k++)
                CHECK_NEAR(p[k], cubic_at(t, k), 1e-9 * (1 + fabs(t * t * t)));
        }
        bat_release(row.t);
    }
    /* A line through the two points of the end. */
    bat_row_beyond row = row_of(BATTEN_PHANTOM_EXTRAPOLATE, 1, false, points);
    bat_point_beyond(&row, -1, p);
    const double slope = (points[1][0] - points[0][0]) / (places[1] - places[0]);
    CHECK_NEAR(p[0], points[0][0] - slope * 0.5, 1e-12);
    bat_point_beyond(&row, N, p);
    const double end_slope = (points[N - 1][0] - points[N - 2][0]) / (places[4] - places[3]);
    CHECK_NEAR(p[0], points[N - 1][0] + end_slope * 1.75, 1e-11);
    bat_release(row.t);
}

TEST(a_closed_row_repeats_and_its_parameters_grow_by_the_period)
{
    double points[N][2];
    for (int kind = 0; kind <= BATTEN_PHANTOM_REPEAT; kind++) {
        bat_row_beyond row = row_of((batten_phantoms)kind, 3, true, points);
        for (int i = -FAR; i <= FAR; i++) {
            double p[2];
            int inside = i, turns = 0;
            for (; inside < 0; turns--)
                inside += N;
            for (; inside >= N; turns++)
                inside -= N;
            bat_point_beyond(&row, i, p);
            CHECK(p[0] == points[inside][0] && p[1] == points[inside][1]);
            CHECK_NEAR(bat_parameter_beyond(&row, i), places[inside] + 5.5 * turns, 1e-13);
        }
        CHECK_BITS(bat_parameter_beyond(&row, N), 6.5);
        bat_release(row.t);
    }
}

TEST(rows_are_parametrized_by_a_power_of_the_chords)
{
    const double points[] = {0, 0, 3, 4, 3, 20};
    for (int closed = 0; closed < 2; closed++)
        for (int a = 0; a <= 4; a++) {
            bat_row_beyond row;
            const bat_beyond_rule rule = {.alpha = a / 4.0, .closed = closed, .degree = 1};
            CHECK_OK(bat_row_beyond_make((batten_points){2, 3, points}, &rule, &row));
            CHECK(row.t[0] == 0);
            CHECK_NEAR(row.t[1], pow(5, a / 4.0), 1e-14);
            CHECK_NEAR(row.t[2], pow(5, a / 4.0) + pow(16, a / 4.0), 1e-14);
            if (closed)
                CHECK_NEAR(row.t[3] - row.t[2], pow(hypot(3, 20), a / 4.0), 1e-14);
            bat_release(row.t);
        }
}

TEST(rows_that_cannot_be_continued_are_refused)
{
    const double points[] = {0, 0, 3, 4, 3, 20}, flat[] = {0, 1, 1, 2};
    static const struct {
        int count;
        bat_beyond_rule rule;
        batten_status status;
    } rows[] = {
        {3, {.kind = (batten_phantoms)-1}, BATTEN_BAD_ARGUMENT},
        {3, {.kind = (batten_phantoms)(BATTEN_PHANTOM_REPEAT + 1)}, BATTEN_BAD_ARGUMENT},
        {3, {.alpha = -0.01}, BATTEN_BAD_ARGUMENT},
        {3, {.alpha = 1.01}, BATTEN_BAD_ARGUMENT},
        {3, {.alpha = NAN}, BATTEN_BAD_ARGUMENT},
        {1, {.alpha = 1}, BATTEN_TOO_FEW_POINTS},
        {2, {.alpha = 1, .closed = true}, BATTEN_TOO_FEW_POINTS},
        {2, {.alpha = 1}, BATTEN_OK},
        {3, {.alpha = 0, .closed = true}, BATTEN_OK},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_row_beyond row;
        CHECK_STATUS(
            bat_row_beyond_make((batten_points){2, rows[i].count, points}, &rows[i].rule, &row),
            rows[i].status);
        bat_release(row.t);
    }
    bat_row_beyond row;
    const bat_beyond_rule given = {.alpha = 7, .given = flat}; /* alpha is not looked at */
    CHECK_STATUS(bat_row_beyond_make((batten_points){2, 3, points}, &given, &row),
                 BATTEN_NOT_INCREASING);
    bat_release(row.t);
    const bat_beyond_rule open = {.alpha = 7, .given = flat};
    CHECK_OK(bat_row_beyond_make((batten_points){2, 2, points}, &open, &row));
    bat_release(row.t);
}
