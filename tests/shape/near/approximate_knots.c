/* Knots for fits by least squares, and parameters nearer to the feet of the data. */
#include "shape/near/approximate.h"
#include "support/test.h"

#include <batten/approximate.h>

/* Schoenberg and Whitney: the data can be dealt out so that each control value has one of its own
 * between its first knot and its last. */
static bool is_determined(const batten_curve *curve, int n, const double *u)
{
    const int p = batten_curve_degree(curve), count = batten_curve_point_count(curve);
    const double *knots = batten_curve_knots(curve);
    int datum = 0;
    for (int i = 0; i < count; i++, datum++) {
        const bool first = i == 0, last = i == count - 1;
        while (datum < n && !(u[datum] > knots[i] || (first && u[datum] == knots[0])))
            datum++;
        if (datum == n || !(u[datum] < knots[i + p + 1] || (last && u[datum] == knots[count])))
            return false;
    }
    return true;
}

/* Few data in a steep front, many beside it: equal parts of the density alone would take more
 * knots there than there are data. */
static int front(double t[60], double y[60])
{
    int n = 0;
    for (int i = 0; i < 40; i++)
        t[n++] = -1 + 0.8 * i / 39.0;
    for (int i = 1; i < 4; i++)
        t[n++] = -0.2 + 0.1 * i;
    for (int i = 0; i < 15; i++)
        t[n++] = 0.2 + 0.8 * i / 14.0;
    for (int i = 0; i < n; i++)
        y[i] = tanh(40 * (t[i] - 0.02));
    return n;
}

TEST(both_choices_of_knots_leave_data_for_each_control_value)
{
    double t[60], y[60];
    const int n = front(t, y);
    for (int choice = 0; choice < 2; choice++)
        for (int degree = 1; degree <= 5; degree++)
            for (int count = degree + 1; count <= n; count += 1 + count / 8) {
                batten_curve_least_squares_options options =
                    batten_curve_least_squares_defaults();
                batten_fit_report report;
                batten_curve *fit = NULL;
                options.parameters = BATTEN_GIVEN;
                options.given = t;
                options.degree = degree;
                options.point_count = count;
                options.knots = (batten_knot_choice)choice;
                CHECK_OK(batten_curve_least_squares((batten_points){1, n, y}, &options, NULL,
                                                    &report, &fit));
                CHECK_INT(batten_curve_point_count(fit), count);
                const double *knots = batten_curve_knots(fit);
                for (int i = degree + 1; i <= count; i++)
                    CHECK(knots[i] > knots[i - 1]);
                CHECK(is_determined(fit, n, t));
                batten_curve_unref(fit);
            }
}

TEST(knots_by_curvature_are_dense_where_the_curve_is_steep)
{
    double t[401], y[401];
    for (int i = 0; i <= 400; i++) {
        t[i] = i / 400.0;
        y[i] = tanh(60 * (t[i] - 0.3));
    }
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    batten_curve *fit = NULL;
    options.parameters = BATTEN_GIVEN;
    options.given = t;
    options.point_count = 28;
    options.knots = BATTEN_KNOTS_BY_CURVATURE;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, 401, y}, &options, NULL, NULL, &fit));
    const double *knots = batten_curve_knots(fit);
    int near = 0, left = 0, right = 0;
    for (int i = 4; i < 28; i++) {
        near += fabs(knots[i] - 0.3) < 0.1;
        left += knots[i] < 0.15;
        right += knots[i] > 0.65;
    }
    /* A fifth of 24 is spread evenly: on the last third more than none stands. */
    CHECK(near >= 12 && left >= 0 && right >= 1 && right <= 6);
    batten_curve_unref(fit);
}

TEST(parameters_move_to_the_feet_of_the_data_and_never_away)
{
    /* The parabola (u, u^2): feet by Newton's method from nearby, quadratically. */
    const double points[] = {0, 0, 0.5, 0, 1, 1}, breaks[] = {0, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){2, 1, breaks}, points, NULL, &curve));
    enum { N = 9 };
    double q[2 * N], u[N], before[N], feet[N];
    for (int i = 0; i < N; i++) {
        feet[i] = (i + 0.5) / N;
        const double off = 0.05 * (i % 3 - 1), size = sqrt(1 + 4 * feet[i] * feet[i]);
        q[2 * i] = feet[i] - off * 2 * feet[i] / size;
        q[2 * i + 1] = feet[i] * feet[i] + off / size;
        before[i] = u[i] = feet[i] + (i % 2 ? 0.01 : -0.01);
    }
    for (int round = 0; round < 4; round++) {
        CHECK_OK(bat_fit_correct(2, N, q, curve, u));
        for (int i = 0; i < N; i++) {
            CHECK(fabs(u[i] - feet[i]) <= (round == 0 ? 1e-3 : round == 1 ? 1e-6 : 1e-11));
            CHECK(hypot(u[i] - q[2 * i], u[i] * u[i] - q[2 * i + 1]) <=
                  hypot(before[i] - q[2 * i], before[i] * before[i] - q[2 * i + 1]));
        }
    }
    /* Beyond the ends they stay at them; where the order would change they wait for one
     * another. */
    const double outside[] = {-1, -1, 0.5, 0.25, 0.2, 0.04, 3, 3};
    double v[] = {0.01, 0.48, 0.49, 0.99};
    for (int round = 0; round < 5; round++) {
        CHECK_OK(bat_fit_correct(2, 4, outside, curve, v));
        for (int i = 1; i < 4; i++)
            CHECK(v[i] >= v[i - 1]);
    }
    CHECK_NEAR(v[0], 0, 1e-12);
    CHECK_NEAR(v[1], 0.5, 1e-9);
    CHECK_NEAR(v[3], 1, 1e-12);
    batten_curve_unref(curve);
}
