#include "support/test.h"
#include <batten/fair.h>
#include <batten/standard.h>

enum { N = 16, WIDTH = 2 };

/* A parabola's control points over uneven knots, clamped or periodic, one of them pushed off. */
static batten_curve *pushed(int degree, bool periodic, int which, double by)
{
    double points[WIDTH * N], knots[N + 26];
    batten_curve *curve = NULL;
    for (int i = 0; i < N; i++) {
        const double a = periodic ? 6.28318530717958648 * i / N : 0.1 * i;
        points[2 * i] = cos(a) * 3;
        points[2 * i + 1] = sin(a) * 3;
    }
    points[2 * which + 1] += by;
    if (periodic) {
        for (int i = 0; i <= N; i++)
            knots[i] = i;
        CHECK_OK(batten_curve_create_periodic((batten_points){2, N, points}, degree, NULL,
                                              knots, &curve));
        return curve;
    }
    for (int i = 0; i < N + degree + 1; i++) {
        const int j = i < degree ? 0 : i > N ? N - degree : i - degree;
        knots[i] = j + 0.3 * sin(2 * j);
    }
    CHECK_OK(batten_curve_create((batten_points){2, N, points}, degree, NULL, knots, &curve));
    return curve;
}

static double jump(const batten_curve *curve, double u)
{
    double left[8], right[8];
    CHECK_OK(batten_curve_evaluate(curve, u, 3, right));
    CHECK_OK(batten_curve_evaluate_side(curve, u, BATTEN_FROM_LEFT, 3, left));
    return hypot(left[6] - right[6], left[7] - right[7]);
}

/* ---- knots ---- */

TEST(the_first_move_makes_the_third_derivative_continuous_at_its_knot)
{
    for (int which = 2; which < N - 2; which++) {
        batten_curve *curve = pushed(3, false, which, 0.2), *made = NULL;
        batten_fair_report report = {0};
        batten_curve_fair_options options = batten_curve_fair_defaults(10);
        options.max_moves = 1;
        CHECK_OK(batten_curve_fair(curve, &options, NULL, &report, &made));
        CHECK_INT(report.move_count, 1);
        const double *knots = batten_curve_knots(curve);
        const double u = knots[report.moves[0].index + 2];
        for (int i = 2; i < N - 2; i++)
            CHECK(jump(curve, knots[i + 2]) <= jump(curve, u));
        CHECK_NEAR(jump(made, u), 0, 1e-12);
        batten_fair_report_release(&report);
        batten_curve_unref(made);
        batten_curve_unref(curve);
    }
}

TEST(periodic_curves_are_faired_over_their_seam)
{
    for (int which = 0; which < N; which++) {
        batten_curve *curve = pushed(3, true, which, 0.1), *made = NULL;
        batten_fair_report report = {0};
        batten_curve_fair_options options = batten_curve_fair_defaults(10);
        options.max_moves = 1;
        CHECK_OK(batten_curve_fair(curve, &options, NULL, &report, &made));
        CHECK(batten_curve_is_periodic(made));
        CHECK_INT(report.moves[0].index, which);
        /* The knot of the point, in the domain from 0 to N. */
        const double u = (which + 2 - 3 + N) % N;
        if (u > 0)
            CHECK_NEAR(jump(made, u), 0, 1e-12);
        CHECK(report.before.excess_inflections == 0 && report.after.fair);
        batten_fair_report_release(&report);
        batten_curve_unref(made);
        batten_curve_unref(curve);
    }
}

/* ---- what all methods keep ---- */

static double farthest(const batten_curve *a, const batten_curve *b)
{
    const batten_interval domain = batten_curve_domain(a);
    double worst = 0, p[2], q[2];
    for (int k = 0; k <= 4000; k++) {
        const double u = fmin(domain.b, domain.a + (domain.b - domain.a) * k / 4000);
        CHECK_OK(batten_curve_evaluate(a, u, 0, p));
        CHECK_OK(batten_curve_evaluate(b, u, 0, q));
        worst = fmax(worst, hypot(p[0] - q[0], p[1] - q[1]));
    }
    return worst;
}

TEST(no_point_of_the_curve_leaves_its_bound_and_held_points_stay)
{
    for (int method = 0; method < 2; method++)
        for (int hold = 0; hold <= 3; hold++) {
            batten_curve *curve = pushed(3, false, 7, 0.2), *made = NULL;
            batten_fair_report report = {0};
            batten_curve_fair_options options = batten_curve_fair_defaults(0.05);
            options.method = (batten_curve_fair_method)method;
            options.hold = hold;
            CHECK_OK(batten_curve_fair(curve, &options, NULL, &report, &made));
            const double *from = batten_curve_points(curve), *to = batten_curve_points(made);
            CHECK(farthest(curve, made) <= 0.05 && farthest(curve, made) > 0.04);
            for (int i = 0; i < hold; i++) {
                CHECK(memcmp(from + 2 * i, to + 2 * i, 2 * sizeof *to) == 0);
                CHECK(memcmp(from + 2 * (N - 1 - i), to + 2 * (N - 1 - i), 2 * sizeof *to) ==
                      0);
            }
            CHECK(report.max_move >= farthest(curve, made) &&
                  report.max_move <= 1.05 * farthest(curve, made));
            CHECK(report.after.jumps < report.before.jumps);
            CHECK_INT(report.moved_count, report.move_count);
            batten_fair_report_release(&report);
            batten_curve_unref(made);
            batten_curve_unref(curve);
        }
}

/* ---- coefficients ---- */

static double integral(const batten_curve *curve, int order)
{
    double sum = 0, at[8];
    const batten_interval domain = batten_curve_domain(curve);
    enum { PLACES = 20000 };
    for (int k = 0; k < PLACES; k++) {
        const double u = domain.a + (domain.b - domain.a) * (k + 0.5) / PLACES;
        CHECK_OK(batten_curve_evaluate(curve, u, order, at));
        sum += (at[2 * order] * at[2 * order] + at[2 * order + 1] * at[2 * order + 1]) *
               (domain.b - domain.a) / PLACES;
    }
    return sum;
}

/* One control point at its best place: the integral is stationary in it. */
TEST(the_first_coefficient_goes_to_where_the_integral_is_least)
{
    for (int degree = 2; degree <= 5; degree++) {
        batten_curve *curve = pushed(degree, degree == 4, 7, 0.2), *made = NULL;
        batten_fair_report report = {0};
        batten_curve_fair_options options = batten_curve_fair_defaults(10);
        const int order = degree < 3 ? 2 : 3;
        options.method = BATTEN_CURVE_FAIR_COEFFICIENTS;
        options.max_moves = 1;
        CHECK_OK(batten_curve_fair(curve, &options, NULL, &report, &made));
        CHECK_INT(report.move_count, 1);
        const int index = report.moves[0].index;
        const double least = integral(made, order);
        CHECK(least < integral(curve, order));
        for (int k = 0; k < 4; k++) {
            double points[2 * (N + 5)];
            batten_curve *beside = NULL;
            memcpy(points, batten_curve_points(made), (size_t)(2 * N) * sizeof *points);
            points[2 * index + k / 2] += k % 2 ? 0.02 : -0.02;
            const batten_points moved = {2, N, points};
            CHECK_OK(degree == 4
                         ? batten_curve_create_periodic(
                               moved, degree, NULL, batten_curve_knots(made) + degree, &beside)
                         : batten_curve_create(moved, degree, NULL, batten_curve_knots(made),
                                               &beside));
            CHECK(integral(beside, order) > least);
            batten_curve_unref(beside);
        }
        batten_fair_report_release(&report);
        batten_curve_unref(made);
        batten_curve_unref(curve);
    }
}

TEST(a_wavy_curve_loses_its_jumps_and_inflections_by_either_method)
{
    for (int method = 0; method < 2; method++) {
        double points[2 * N];
        batten_curve *curve = pushed(3, false, 7, 0), *made = NULL;
        batten_fair_report report = {0};
        test_random random = test_random_begin("waves");
        memcpy(points, batten_curve_points(curve), sizeof points);
        for (int i = 0; i < 2 * N; i++)
            points[i] += test_random_in(&random, -0.05, 0.05);
        batten_curve *wavy = NULL;
        CHECK_OK(batten_curve_create((batten_points){2, N, points}, 3, NULL,
                                     batten_curve_knots(curve), &wavy));
        batten_curve_fair_options options = batten_curve_fair_defaults(0.12);
        options.method = (batten_curve_fair_method)method;
        options.max_moves = 2000;
        CHECK_OK(batten_curve_fair(wavy, &options, NULL, &report, &made));
        CHECK(report.before.excess_inflections >= 2 && !report.before.fair);
        CHECK(report.after.jumps < 0.01 * report.before.jumps);
        /* Taking out knots leaves the first and the last two points, and what they make. */
        CHECK(report.after.excess_inflections <= (method == 0 ? 2 : 0));
        CHECK(method == 0 || report.after.fair);
        batten_fair_report_release(&report);
        batten_curve_unref(made);
        batten_curve_unref(wavy);
        batten_curve_unref(curve);
    }
}

TEST(a_parabola_stays_bit_for_bit)
{
    const double points[8] = {0, 0, 1, 2, 2, 2, 3, 0}, refined[4] = {0.2, 0.4, 0.5, 0.8},
                 knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    batten_curve *cubic = NULL, *fine = NULL, *made = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 4, points}, 3, NULL, knots, &cubic));
    CHECK_OK(batten_curve_refine(cubic, 4, refined, &fine));
    const batten_curve_fair_options options = batten_curve_fair_defaults(0.1);
    CHECK_OK(batten_curve_fair(fine, &options, NULL, NULL, &made));
    for (int i = 0; i < 16; i++)
        CHECK_NEAR(batten_curve_points(made)[i], batten_curve_points(fine)[i], 1e-7);
    batten_curve_unref(made);
    batten_curve_unref(fine);
    batten_curve_unref(cubic);
}

/* A cubic over a line with its inflection at a parameter: the turns of nine points begin at 1/8 and end at 7/8. */
TEST(the_inflections_required_are_those_of_8_points_of_a_span)
{
    static const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    static const struct {
        double inflection;
        int excess;
    } rows[] = {{0.12, 1}, {0.13, 0}, {0.5, 0}, {0.87, 0}, {0.88, 1}};
    for (int i = 0; i < COUNT(rows); i++) {
        /* y = u^3 / 6 - a u^2 / 2 */
        const double a = rows[i].inflection;
        const double points[8] = {0, 0, 1 / 3., 0, 2 / 3., -a / 6, 1, 1 / 6. - a / 2};
        batten_curve *curve = NULL, *made = NULL;
        batten_fair_report report = {0};
        batten_curve_fair_options options = batten_curve_fair_defaults(1e-7);
        options.method = BATTEN_CURVE_FAIR_COEFFICIENTS;
        CHECK_OK(batten_curve_create((batten_points){2, 4, points}, 3, NULL, knots, &curve));
        CHECK_OK(batten_curve_fair(curve, &options, NULL, &report, &made));
        CHECK_INT(report.before.inflections, 1);
        CHECK_INT(report.before.excess_inflections, rows[i].excess);
        batten_fair_report_release(&report);
        batten_curve_unref(made);
        batten_curve_unref(curve);
    }
}

/* ---- what is refused ---- */

TEST(curves_and_options_that_mean_nothing_are_refused)
{
    batten_curve *cubic = pushed(3, false, 7, 0.2), *quintic = pushed(5, false, 7, 0.2),
                 *line = pushed(1, false, 7, 0.2), *arc = NULL, *made = NULL;
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &arc));
    const struct {
        const batten_curve *curve;
        double within;
        int method, hold, max_moves;
        batten_status status;
        const char *message;
    } rows[] = {
        {cubic, 0, 0, 1, 0, BATTEN_BAD_ARGUMENT, "the bound is 0, not above 0"},
        {cubic, NAN, 0, 1, 0, BATTEN_BAD_ARGUMENT, "the bound is nan, not above 0"},
        {cubic, 1, 2, 1, 0, BATTEN_BAD_ARGUMENT, "there is no method 2 of fairing curves"},
        {cubic, 1, 0, -1, 0, BATTEN_BAD_ARGUMENT, "-1 control points are to be held"},
        {cubic, 1, 0, 1, -1, BATTEN_BAD_ARGUMENT, "the most moves are -1, below 0"},
        {quintic, 1, 0, 1, 0, BATTEN_UNSUPPORTED, "this is of degree 5"},
        {line, 1, 1, 1, 0, BATTEN_UNSUPPORTED, "a polyline has corners"},
        {arc, 1, 1, 1, 0, BATTEN_UNSUPPORTED, "the curve is rational"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve_fair_options options = batten_curve_fair_defaults(rows[i].within);
        options.method = (batten_curve_fair_method)rows[i].method;
        options.hold = rows[i].hold;
        options.max_moves = rows[i].max_moves;
        CHECK_STATUS(batten_curve_fair(rows[i].curve, &options, NULL, NULL, &made),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].message);
    }
    CHECK(made == NULL);
    batten_curve_unref(cubic);
    batten_curve_unref(quintic);
    batten_curve_unref(line);
    batten_curve_unref(arc);
}
