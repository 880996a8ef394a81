#include <batten/local.h>

#include "support/test.h"

enum { MOST = 40 };

typedef struct {
    double t[MOST + 1], leaving[3 * MOST], arriving[3 * MOST];
    batten_tangents_report report;
} tangents;

static batten_tangents_options rule(batten_tangent_rule which, batten_tangent_length length)
{
    batten_tangents_options options = batten_tangents_defaults();
    options.rule = which;
    options.length = length;
    return options;
}

static tangents tangents_of(int d, int count, const double *points,
                            const batten_tangents_options *options)
{
    tangents made = {0};
    CHECK_OK(batten_tangents((batten_points){d, count, points}, options, made.t, &made.report,
                             made.leaving, made.arriving));
    return made;
}

static batten_curve *curve_of(int d, int count, const double *points,
                              const batten_tangents_options *options, tangents *made)
{
    batten_curve *curve = NULL;
    *made = tangents_of(d, count, points, options);
    CHECK_OK(batten_curve_from_tangents((batten_points){d, count, points}, made->t,
                                        made->leaving, made->arriving, options->closed,
                                        &curve));
    return curve;
}

/* Points on a circle in a tilted plane of space, at uneven angles. */
static void on_circle(test_random *random, int count, double *points, double *direct)
{
    double angle = 0;
    for (int i = 0; i < count; i++) {
        const double c = cos(angle), s = sin(angle);
        const double row[3] = {2 * c + 1, 1.2 * s - 4, 1.6 * s + 2};
        const double T[3] = {-s, 0.6 * c, 0.8 * c};
        memcpy(points + 3 * i, row, sizeof row);
        memcpy(direct + 3 * i, T, sizeof T);
        angle += test_random_in(random, 0.1, 6.2 / count);
    }
}

TEST(circle_tangents_are_exact_on_circles_open_and_closed)
{
    test_random random = test_random_begin("circle tangents");
    for (int c = 0; c < test_cases(100); c++) {
        const int count = test_random_int(&random, 3, 20);
        double points[3 * 20], direct[3 * 20];
        on_circle(&random, count, points, direct);
        batten_tangents_options options = rule(BATTEN_TANGENT_CIRCLE, BATTEN_LENGTH_CHORD);
        options.closed = c % 2;
        const tangents made = tangents_of(3, count, points, &options);
        for (int k = 0; k < 3 * count; k++)
            CHECK_NEAR(made.leaving[k], direct[k], 1e-14 * 60);
    }
}

TEST(g2_points_in_line_give_that_line_whatever_the_rule_and_the_steps)
{
    const double line[] = {0, 0, 3, 4, 3.6, 4.8, 9, 12, 12, 16, 15, 20};
    for (int r = 0; r <= BATTEN_TANGENT_BISECTOR; r++)
        for (int l = 0; l <= BATTEN_LENGTH_RULE; l++) {
            const batten_tangents_options options =
                rule((batten_tangent_rule)r, (batten_tangent_length)l);
            for (int count = 2; count <= 6; count++) {
                const tangents made = tangents_of(2, count, line, &options);
                for (int i = 0; i < count; i++) {
                    CHECK_NEAR(made.leaving[2 * i], 0.6, 1e-14);
                    CHECK_NEAR(made.leaving[2 * i + 1], 0.8, 1e-14);
                    CHECK_NEAR(made.t[i], hypot(line[2 * i], line[2 * i + 1]), 1e-13);
                }
            }
        }
}

/* Bessel: the parabola through three points at parameters 0, a, a + b. */
TEST(bessel_tangents_are_those_of_the_parabola_with_chord_parameters)
{
    const double points[] = {0, 0, 1, 2, 4, 1};
    const double a = sqrt(5), b = sqrt(10);
    const batten_tangents_options options = rule(BATTEN_TANGENT_BESSEL, BATTEN_LENGTH_RULE);
    const tangents made = tangents_of(2, 3, points, &options);
    for (int k = 0; k < 2; k++) {
        const double d0 = (points[2 + k] - points[k]) / a,
                     d1 = (points[4 + k] - points[2 + k]) / b, second = (d1 - d0) / (a + b);
        CHECK_NEAR(made.leaving[k], d0 - a * second, 1e-14);
        CHECK_NEAR(made.leaving[2 + k], d0 + a * second, 1e-14);
        CHECK_NEAR(made.leaving[4 + k], d1 + b * second, 1e-14);
    }
    /* Three points determine the parabola nearest to five. */
    const batten_tangents_options five = rule(BATTEN_TANGENT_PARABOLA, BATTEN_LENGTH_RULE);
    const tangents same = tangents_of(2, 3, points, &five);
    for (int k = 0; k < 6; k++)
        CHECK_NEAR(same.leaving[k], made.leaving[k], 1e-14);
}

TEST(renner_keeps_straight_runs_and_rounds_or_keeps_the_corner_between_two)
{
    const double points[] = {0, 0, 1, 0, 2, 0, 3, 0, 3, 1, 3, 3, 3, 4};
    batten_tangents_options options = rule(BATTEN_TANGENT_RENNER, BATTEN_LENGTH_MIDDLE);
    tangents made;
    batten_curve *curve = curve_of(2, 7, points, &options, &made);
    CHECK_NEAR(made.leaving[2 * 3], sqrt(0.5), 1e-15);
    CHECK_NEAR(made.leaving[2 * 3 + 1], sqrt(0.5), 1e-15);
    CHECK_INT(made.report.corners, 0);
    CHECK_INT(batten_curve_point_count(curve), 14);
    for (int i = 0; i <= 20; i++) {
        double at[2];
        CHECK_OK(batten_curve_evaluate(curve, made.t[2] * i / 20, 0, at));
        CHECK_NEAR(at[1], 0, 0);
    }
    batten_curve_unref(curve);
    options.corners = BATTEN_CORNER_KEEP;
    curve = curve_of(2, 7, points, &options, &made);
    CHECK_INT(made.report.corners, 1);
    CHECK_INT(batten_curve_point_count(curve), 15);
    for (int i = 0; i <= 70; i++) {
        double at[2];
        CHECK_OK(batten_curve_evaluate(curve, made.t[6] * i / 70, 0, at));
        CHECK_NEAR(fmin(at[0], 3 - at[0]) * fmin(1, at[1]), 0, 1e-15 * 4);
        CHECK_NEAR(i <= 30 ? at[1] : at[0] - 3, 0, 1e-14);
    }
    batten_curve_unref(curve);
}

/* Where the ends are reached, the chords beyond go on in equal turns. */
TEST(renner_weighs_the_chords_by_the_areas_of_their_neighbours)
{
    const double q[] = {1, 0, 0.8, 0.6, 0, 1, -0.6, 0.8};
    double points[10] = {0};
    for (int k = 0; k < 8; k++)
        points[k + 2] = points[k] + q[k];
    const batten_tangents_options options = rule(BATTEN_TANGENT_RENNER, BATTEN_LENGTH_CHORD);
    const tangents made = tangents_of(2, 5, points, &options);
    const double before = 0.6, after = 0.6, part = before / (before + after);
    double T[2];
    for (int k = 0; k < 2; k++)
        T[k] = (1 - part) * q[2 + k] + part * q[4 + k];
    CHECK_NEAR(made.leaving[4], T[0] / hypot(T[0], T[1]), 1e-15);
    CHECK_NEAR(made.leaving[5], T[1] / hypot(T[0], T[1]), 1e-15);
    /* At the start: q(-1) = 2 q0 - q1 = (1.2, -0.6), q(-2) = (1.4, -1.2). */
    const double outer = fabs(1.4 * -0.6 + 1.2 * 1.2), inner = 0.6, a = outer / (outer + inner);
    const double S[2] = {(1 - a) * 1.2 + a * 1, (1 - a) * -0.6};
    CHECK_NEAR(made.leaving[0], S[0] / hypot(S[0], S[1]), 1e-15);
    CHECK_NEAR(made.leaving[1], S[1] / hypot(S[0], S[1]), 1e-15);
}

TEST(akima_tangents_keep_what_is_straight_in_a_coordinate)
{
    /* y is 0, then rises along a line; noise of decimal fractions must not count. */
    double points[2 * 9];
    for (int i = 0; i < 9; i++) {
        points[2 * i] = 0.1 * i;
        points[2 * i + 1] = i < 4 ? 0 : 0.3 * (i - 4) + 0.3;
    }
    const batten_tangents_options options = rule(BATTEN_TANGENT_AKIMA, BATTEN_LENGTH_RULE);
    const tangents made = tangents_of(2, 9, points, &options);
    for (int i = 0; i < 9; i++) {
        const double T[2] = {made.leaving[2 * i], made.leaving[2 * i + 1]};
        if (i < 3)
            CHECK_NEAR(T[1], 0, 1e-15);
        else if (i > 4)
            CHECK_NEAR(T[1] / T[0], 3, 1e-13);
        CHECK(T[0] > 0 && T[1] >= 0);
    }
}

/* The speed of every span is 1 at its ends and in its middle. */
TEST(middle_lengths_give_each_span_speed_one_in_its_middle)
{
    test_random random = test_random_begin("middle");
    for (int c = 0; c < test_cases(200); c++) {
        const int count = test_random_int(&random, 3, 12), d = 2 + c % 2;
        double points[3 * 12];
        for (int k = 0; k < count * d; k++)
            points[k] = test_random_in(&random, -1, 1);
        batten_tangents_options options =
            rule((batten_tangent_rule)(c % 6), BATTEN_LENGTH_MIDDLE);
        options.closed = c % 3 == 0;
        tangents made;
        batten_curve *curve = curve_of(d, count, points, &options, &made);
        for (int i = 0; i + 1 < count + options.closed; i++)
            for (int half = 0; half < 2; half++) {
                double out[6], speed = 0;
                const double u = made.t[i] + half * (made.t[i + 1] - made.t[i]) / 2;
                CHECK_OK(batten_curve_evaluate(curve, u, 1, out));
                for (int k = 0; k < d; k++)
                    speed += out[d + k] * out[d + k];
                CHECK_NEAR(speed, 1, 1e-11);
            }
        batten_curve_unref(curve);
    }
}

TEST(curves_pass_their_points_with_their_tangents_open_and_closed)
{
    test_random random = test_random_begin("passing");
    for (int c = 0; c < test_cases(300); c++) {
        const int count = test_random_int(&random, 3, 12), d = 2 + c % 2;
        double points[3 * 12];
        for (int k = 0; k < count * d; k++)
            points[k] = test_random_in(&random, -1, 1);
        batten_tangents_options options =
            rule((batten_tangent_rule)(c % 6), (batten_tangent_length)(c / 6 % 3));
        options.closed = c % 5 == 0;
        tangents made;
        batten_curve *curve = curve_of(d, count, points, &options, &made);
        CHECK(batten_curve_is_periodic(curve) == options.closed);
        for (int i = 0; i < count + options.closed; i++)
            for (int side = 0; side < 2; side++) {
                double out[6];
                CHECK_OK(batten_curve_evaluate_side(
                    curve, made.t[i], side ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 1, out));
                for (int k = 0; k < d; k++) {
                    CHECK_NEAR(out[k], points[i % count * d + k], 1e-14);
                    CHECK_NEAR(out[d + k], made.leaving[i % count * d + k], 1e-11);
                }
            }
        batten_curve_unref(curve);
    }
}

TEST(g10_reversed_points_give_reversed_tangents)
{
    test_random random = test_random_begin("reversed");
    for (int c = 0; c < test_cases(200); c++) {
        const int count = test_random_int(&random, 2, 12), d = 2 + c % 2;
        double points[3 * 12], reversed[3 * 12];
        for (int k = 0; k < count * d; k++)
            points[k] = test_random_in(&random, -1, 1);
        for (int i = 0; i < count; i++)
            memcpy(reversed + i * d, points + (count - 1 - i) * d, (size_t)d * sizeof *points);
        batten_tangents_options options =
            rule((batten_tangent_rule)(c % 6), (batten_tangent_length)(c / 6 % 3));
        options.closed = c % 5 == 0 && count > 2;
        options.corners = (batten_corner)(c % 2);
        const tangents there = tangents_of(d, count, points, &options);
        const tangents back = tangents_of(d, count, reversed, &options);
        for (int i = 0; i < count; i++)
            for (int k = 0; k < d; k++)
                CHECK_NEAR(there.leaving[i * d + k], -back.arriving[(count - 1 - i) * d + k],
                           1e-11);
    }
}

TEST(g3_points_where_the_polygon_turns_back_are_flagged_and_get_a_tangent_across)
{
    const double points[] = {0, 0, 1, 0, 3, 0, 2, 0, 2, 1};
    for (int r = 0; r <= BATTEN_TANGENT_BISECTOR; r++) {
        const batten_tangents_options options =
            rule((batten_tangent_rule)r, BATTEN_LENGTH_MIDDLE);
        tangents made;
        batten_curve *curve = curve_of(2, 5, points, &options, &made);
        CHECK_INT(made.report.turned_back, 1);
        CHECK_INT(made.report.first_turned_back, 2);
        CHECK_NEAR(made.leaving[4], 0, 1e-15);
        CHECK_NEAR(made.leaving[5], 1, 1e-15);
        batten_curve_unref(curve);
    }
    const batten_tangents_options circle = rule(BATTEN_TANGENT_CIRCLE, BATTEN_LENGTH_CHORD);
    const double needle[] = {0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1};
    const tangents made = tangents_of(3, 3, needle + 3, &circle);
    CHECK_INT(made.report.turned_back, 0);
    const double thin[] = {0, 0, 0, 0, 0, 1, 0, 0, 0.5};
    const tangents across = tangents_of(3, 3, thin, &circle);
    CHECK_INT(across.report.turned_back, 1);
    CHECK_NEAR(across.leaving[5], 0, 0);
}

TEST(g1_coincident_points_are_named_by_tangents)
{
    const double points[] = {0, 0, 1, 0, 1, 0, 2, 0};
    const double ring[] = {0, 0, 1, 0, 1, 1, 0, 0};
    double t[5], T[8];
    CHECK_STATUS(batten_tangents((batten_points){2, 4, points}, NULL, t, NULL, T, NULL),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3 coincide");
    batten_tangents_options options = batten_tangents_defaults();
    options.closed = true;
    CHECK_STATUS(batten_tangents((batten_points){2, 4, ring}, &options, t, NULL, T, NULL),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 4 and 1 coincide");
}

TEST(n1_what_is_not_finite_is_named_by_tangents)
{
    double t[5] = {7}, T[8];
    const double points[] = {0, 0, 1, NAN, 1, 0, 2, 0}, fine[] = {0, 0, 1, 1};
    CHECK_STATUS(batten_tangents((batten_points){2, 4, points}, NULL, t, NULL, T, NULL),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of point 2");
    CHECK_NEAR(t[0], 7, 0);
    CHECK_STATUS(batten_tangents((batten_points){2, 1, points}, NULL, t, NULL, T, NULL),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_tangents((batten_points){1, 4, fine}, NULL, t, NULL, T, NULL),
                 BATTEN_BAD_ARGUMENT);
    batten_tangents_options options = batten_tangents_defaults();
    options.closed = true;
    CHECK_STATUS(batten_tangents((batten_points){2, 2, fine}, &options, t, NULL, T, NULL),
                 BATTEN_TOO_FEW_POINTS);
    options = rule((batten_tangent_rule)9, BATTEN_LENGTH_CHORD);
    CHECK_STATUS(batten_tangents((batten_points){2, 2, fine}, &options, t, NULL, T, NULL),
                 BATTEN_BAD_ARGUMENT);
    options = rule(BATTEN_TANGENT_CIRCLE, (batten_tangent_length)9);
    CHECK_STATUS(batten_tangents((batten_points){2, 2, fine}, &options, t, NULL, T, NULL),
                 BATTEN_BAD_ARGUMENT);
}

TEST(n2_tiny_and_huge_points_have_the_same_tangents)
{
    const double points[] = {0, 0, 1, 2, 4, 1, 5, 5, 7, 4};
    const double scales[] = {1e-300, 1e-9, 1e9, 1e150, 1e300};
    for (int r = 0; r <= BATTEN_TANGENT_BISECTOR; r++)
        for (int s = 0; s < COUNT(scales); s++) {
            const batten_tangents_options options =
                rule((batten_tangent_rule)r, BATTEN_LENGTH_MIDDLE);
            const tangents plain = tangents_of(2, 5, points, &options);
            double scaled[10];
            for (int k = 0; k < 10; k++)
                scaled[k] = points[k] * scales[s];
            const tangents made = tangents_of(2, 5, scaled, &options);
            for (int k = 0; k < 10; k++)
                CHECK_NEAR(made.leaving[k], plain.leaving[k], 1e-12);
            for (int i = 0; i < 5; i++)
                CHECK_NEAR(made.t[i] / scales[s], plain.t[i], 1e-12 * plain.t[4]);
        }
}

/* A point that moves changes the tangents of two neighbours on each side at most. */
TEST(tangents_are_local)
{
    test_random random = test_random_begin("local");
    for (int r = 0; r <= BATTEN_TANGENT_BISECTOR; r++) {
        const batten_tangents_options options =
            rule((batten_tangent_rule)r, BATTEN_LENGTH_CHORD);
        double points[2 * 15];
        for (int k = 0; k < 30; k++)
            points[k] = test_random_in(&random, -1, 1) + k / 2;
        const tangents before = tangents_of(2, 15, points, &options);
        points[2 * 7] += 0.25;
        const tangents after = tangents_of(2, 15, points, &options);
        for (int i = 0; i < 15; i++)
            if (i < 5 || i > 9)
                for (int k = 0; k < 2; k++)
                    CHECK_BITS(after.leaving[2 * i + k], before.leaving[2 * i + k]);
    }
}

TEST(given_tangents_are_taken_with_the_length_that_is_asked)
{
    const double points[] = {0, 0, 2, 0, 2, 3}, given[] = {3, 0, 0, 5, 0, 2}, zero[6] = {1, 1};
    const double bad[] = {1, 0, NAN, 1, 1, 1};
    batten_tangents_options options = rule(BATTEN_TANGENT_GIVEN, BATTEN_LENGTH_RULE);
    double t[3], T[6];
    CHECK_STATUS(batten_tangents((batten_points){2, 3, points}, &options, t, NULL, T, NULL),
                 BATTEN_BAD_ARGUMENT);
    options.given = given;
    tangents made = tangents_of(2, 3, points, &options);
    for (int k = 0; k < 6; k++)
        CHECK_NEAR(made.leaving[k], given[k], 0);
    options.length = BATTEN_LENGTH_MIDDLE;
    made = tangents_of(2, 3, points, &options);
    CHECK_NEAR(made.leaving[0], 1, 1e-15);
    CHECK_NEAR(made.leaving[3], 1, 1e-15);
    /* The second span is straight: its step is its chord. */
    CHECK_NEAR(made.t[2] - made.t[1], 3, 1e-14);
    options.given = zero;
    CHECK_STATUS(batten_tangents((batten_points){2, 3, points}, &options, t, NULL, T, NULL),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("tangent at point 2");
    options.given = bad;
    CHECK_STATUS(batten_tangents((batten_points){2, 3, points}, &options, t, NULL, T, NULL),
                 BATTEN_NOT_FINITE);
}
