#include <batten/curve.h>

#include "support/generate.h"

TEST(hermite_data_come_back)
{
    test_random random = test_random_begin(__func__);
    for (int k = 1; k <= 4; k++)
        for (int i = 0; i < test_cases(50); i++) {
            const int count = test_random_int(&random, 2, 8);
            double parameters[8], values[8 * 4 * 2];
            for (int j = 0; j < count; j++)
                parameters[j] = (j ? parameters[j - 1] : 0) + test_random_in(&random, 0.2, 2);
            for (int j = 0; j < count * k * 2; j++)
                values[j] = test_random_in(&random, -1, 1);
            batten_curve *curve = NULL;
            CHECK_OK(batten_curve_from_hermite(2, count, k, parameters, values, &curve));
            CHECK_INT(batten_curve_degree(curve), 2 * k - 1);
            for (int j = 0; j < count; j++)
                for (int side = 0; side < 2; side++) {
                    double out[8];
                    CHECK_OK(batten_curve_evaluate_side(curve, parameters[j], (batten_side)side,
                                                        k - 1, out));
                    for (int c = 0; c < 2 * k; c++)
                        CHECK_NEAR(out[c], values[j * k * 2 + c], c < 4 ? 1e-13 : 1e-9);
                }
            batten_curve_unref(curve);
        }
}

TEST(the_cubic_hermite_matrix_of_the_notes)
{
    /* [2 -2 1 1; -3 3 -2 -1; 0 0 1 0; 1 0 0 0] times P0, P1, R0, R1: coefficients of t^3 .. 1.
     */
    const double ends[] = {0, 1}, values[] = {5, 7, 2, -3}, P0 = 5, R0 = 7, P1 = 2, R1 = -3;
    double c[4];
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_hermite(1, 2, 2, ends, values, &curve));
    CHECK_OK(batten_curve_to_power(curve, c));
    CHECK_NEAR(c[3], 2 * P0 - 2 * P1 + R0 + R1, 1e-13);
    CHECK_NEAR(c[2], -3 * P0 + 3 * P1 - 2 * R0 - R1, 1e-13);
    CHECK_NEAR(c[1], R0, 1e-14);
    CHECK_BITS(c[0], P0);
    const double expected[] = {P0, P0 + R0 / 3, P1 - R1 / 3, P1};
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(batten_curve_points(curve)[i], expected[i], 1e-15);
    batten_curve_unref(curve);
}

TEST(quintic_hermite_functions_of_the_notes)
{
    const double ends[] = {0, 1};
    for (int unit = 0; unit < 6; unit++) {
        double values[6] = {0};
        values[unit] = 1;
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_from_hermite(1, 2, 3, ends, values, &curve));
        for (double t = 0; t <= 1; t += 0.125) {
            const double t3 = t * t * t, t4 = t3 * t, t5 = t4 * t;
            const double expected[] = {
                1 - 10 * t3 + 15 * t4 - 6 * t5,     t - 6 * t3 + 8 * t4 - 3 * t5,
                (t * t - 3 * t3 + 3 * t4 - t5) / 2, 10 * t3 - 15 * t4 + 6 * t5,
                -4 * t3 + 7 * t4 - 3 * t5,          (t3 - 2 * t4 + t5) / 2};
            double value;
            CHECK_OK(batten_curve_evaluate(curve, t, 0, &value));
            CHECK_NEAR(value, expected[unit], 1e-14);
        }
        batten_curve_unref(curve);
    }
}

TEST(powers_and_back)
{
    test_random random = test_random_begin(__func__);
    const test_wish wish = {
        .tame = true, .degree = 4, .rational = TEST_NEVER, .dimension = 2, .most_points = 20};
    for (int i = 0; i < test_cases(100); i++) {
        batten_curve *curve = test_curve(&random, &wish), *back = NULL;
        double breaks[40], coefficients[40 * 5 * 2];
        const int pieces = batten_curve_spans(curve, breaks) - 1;
        CHECK_OK(batten_curve_to_power(curve, coefficients));
        CHECK_OK(batten_curve_from_power(2, (batten_pieces){4, pieces, breaks}, coefficients,
                                         1e-12, &back));
        for (int k = 0; k < 20; k++) {
            const double u = test_parameter(&random, curve);
            CHECK_NEAR(test_curve_distance(curve, u, back, u, 1), 0, 1e-12);
        }
        batten_curve_unref(back);
        batten_curve_unref(curve);
    }
}

TEST(bezier_pieces_and_back_keep_every_point)
{
    test_random random = test_random_begin(__func__);
    const test_wish wish = {0};
    for (int i = 0; i < test_cases(100); i++) {
        batten_curve *curve = test_curve(&random, &wish), *bezier = NULL, *back = NULL;
        double breaks[64];
        const int pieces = batten_curve_spans(curve, breaks) - 1;
        CHECK_OK(batten_curve_to_bezier(curve, &bezier));
        CHECK_OK(batten_curve_from_bezier(
            batten_curve_dimension(bezier),
            (batten_pieces){batten_curve_degree(bezier), pieces, breaks},
            batten_curve_points(bezier), batten_curve_weights(bezier), &back));
        CHECK_INT(batten_curve_knot_count(back), batten_curve_knot_count(bezier));
        for (int k = 0; k < batten_curve_knot_count(back); k++)
            CHECK_BITS(batten_curve_knots(back)[k], batten_curve_knots(bezier)[k]);
        batten_curve_unref(back);
        batten_curve_unref(bezier);
        batten_curve_unref(curve);
    }
}

TEST(forms_refuse_bad_numbers)
{
    const double rising[] = {0, 1, 2}, falling[] = {0, 2, 1}, bad[] = {0, NAN, 1},
                 values[24] = {0, 1, 0, 5};
    batten_curve *none = NULL;
    CHECK_STATUS(
        batten_curve_from_bezier(1, (batten_pieces){1, 2, falling}, values, NULL, &none),
        BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_curve_from_bezier(1, (batten_pieces){1, 2, bad}, values, NULL, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(
        batten_curve_from_bezier(1, (batten_pieces){0, 2, rising}, values, NULL, &none),
        BATTEN_BAD_DEGREE);
    CHECK_STATUS(
        batten_curve_from_bezier(1, (batten_pieces){1, 0, rising}, values, NULL, &none),
        BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_curve_from_bezier(1, (batten_pieces){25, 2147483647, rising}, values,
                                          NULL, &none),
                 BATTEN_TOO_LARGE);
    CHECK_STATUS(batten_curve_from_hermite(1, 2, 5, rising, values, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_from_hermite(1, 1, 2, rising, values, &none),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_curve_from_hermite(1, 3, 2, falling, values, &none),
                 BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_curve_from_hermite(4, 3, 2, rising, values, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_from_hermite(1, 2147483647, 2, rising, values, &none),
                 BATTEN_TOO_LARGE);
    CHECK_STATUS(batten_curve_from_power(1, (batten_pieces){1, 2, rising}, values, 0.1, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("pieces 1 and 2 are 1 apart");
    CHECK_STATUS(batten_curve_from_power(1, (batten_pieces){1, 2, falling}, values, 0.1, &none),
                 BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_curve_from_power(1, (batten_pieces){26, 2, rising}, values, 0.1, &none),
                 BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_from_power(1, (batten_pieces){1, 2, rising}, values, NAN, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_from_power(0, (batten_pieces){1, 2, rising}, values, 1, &none),
                 BATTEN_BAD_ARGUMENT);
}

TEST(a_rational_curve_has_no_form_in_powers)
{
    const double points[] = {0, 1}, weights[] = {1, 2}, knots[] = {0, 0, 1, 1};
    batten_curve *curve = NULL;
    double out[2];
    CHECK_OK(batten_curve_create((batten_points){1, 2, points}, 1, weights, knots, &curve));
    CHECK_STATUS(batten_curve_to_power(curve, out), BATTEN_UNSUPPORTED);
    batten_curve_unref(curve);
}

TEST(forms_refuse_what_they_cannot_hold)
{
    const double ends[] = {0, 1}, values[20] = {0};
    const double bad[] = {-1, NAN, INFINITY};
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_from_hermite(1, 2, 0, ends, values, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_from_hermite(1, 2, 5, ends, values, &none), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("5 values at each parameter");
    for (int d = 0; d <= 4; d += 4) {
        CHECK_STATUS(batten_curve_from_hermite(d, 2, 2, ends, values, &none),
                     BATTEN_BAD_ARGUMENT);
        CHECK_STATUS(batten_curve_from_power(d, (batten_pieces){1, 1, ends}, values, 0, &none),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("must be 1, 2 or 3");
    }
    for (int i = 0; i < COUNT(bad); i++)
        CHECK_STATUS(
            batten_curve_from_power(1, (batten_pieces){1, 1, ends}, values, bad[i], &none),
            BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
}

TEST(N2_coefficients_too_large_for_numbers_are_an_overflow)
{
    const double points[] = {-1e300, 1e300}, knots[] = {0, 0, 1e-100, 1e-100};
    double coefficients[2];
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 2, points}, 1, NULL, knots, &curve));
    CHECK_STATUS(batten_curve_to_power(curve, coefficients), BATTEN_OVERFLOW);
    batten_curve_unref(curve);
}

TEST(breaks_that_do_not_rise_are_named_from_1)
{
    static const struct {
        double breaks[4];
        batten_status status;
        const char *words;
    } rows[] = {
        {{0, 1, 1, 2}, BATTEN_NOT_INCREASING, "break 3 is 1, not above 1 before it"},
        {{0, -1, 1, 2}, BATTEN_NOT_INCREASING, "break 2 is -1, not above 0 before it"},
        {{0, 1, 2, 2}, BATTEN_NOT_INCREASING, "break 4 is 2, not above 2 before it"},
        {{NAN, 1, 2, 2}, BATTEN_NOT_FINITE, "break 1 is nan"},
        {{0, 1, 2, INFINITY}, BATTEN_NOT_FINITE, "break 4 is inf"},
    };
    static const double points[6] = {0, 1, 2, 3, 4, 5};
    batten_curve *curve = NULL;
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(batten_curve_from_bezier(1, (batten_pieces){1, 3, rows[i].breaks}, points,
                                              NULL, &curve),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].words);
    }
    CHECK_STATUS(batten_curve_from_bezier(1, (batten_pieces){1, 0, rows[0].breaks}, points,
                                          NULL, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("0 pieces; at least 1 is needed");
    CHECK(!curve);
}

/* A function of two pieces over [2, 5], of uneven weights: its graph has u beside every value. */
TEST(the_graph_of_a_function_is_its_argument_beside_its_value)
{
    static const double knots[] = {2, 2, 2, 3, 5, 5, 5}, values[] = {1, -2, 4, 0.5};
    static const double weights[] = {1, 3, 0.5, 2};
    for (int rational = 0; rational < 2; rational++) {
        batten_curve *function = NULL, *graph = NULL;
        CHECK_OK(batten_curve_create((batten_points){1, 4, values}, 2,
                                     rational ? weights : NULL, knots, &function));
        CHECK_OK(batten_curve_from_function(function, &graph));
        CHECK_INT(batten_curve_dimension(graph), 2);
        CHECK_INT(batten_curve_degree(graph), rational ? 3 : 2);
        CHECK(batten_curve_domain(graph).a == 2 && batten_curve_domain(graph).b == 5);
        CHECK_INT(batten_curve_is_rational(graph), rational);
        for (int i = 0; i <= 24; i++) {
            double value, point[2];
            CHECK_OK(batten_curve_evaluate(function, 2 + i / 8.0, 0, &value));
            CHECK_OK(batten_curve_evaluate(graph, 2 + i / 8.0, 0, point));
            CHECK_NEAR(point[0], 2 + i / 8.0, 4e-15);
            CHECK_NEAR(point[1], value, 4e-15);
        }
        batten_curve_unref(graph);
        batten_curve_unref(function);
    }
    batten_curve *plane = NULL, *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 2, values}, 1, NULL,
                                 (const double[]){0, 0, 1, 1}, &plane));
    CHECK_STATUS(batten_curve_from_function(plane, &none), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a graph is of a function, not of 2 dimensions");
    CHECK(!none);
    batten_curve_unref(plane);
}

TEST(powers_have_one_to_three_coordinates)
{
    static const double breaks[] = {0, 1}, coefficients[8] = {0};
    static const int dimensions[] = {-1, 0, 4};
    batten_curve *curve = NULL;
    for (int i = 0; i < COUNT(dimensions); i++) {
        CHECK_STATUS(batten_curve_from_power(dimensions[i], (batten_pieces){1, 1, breaks},
                                             coefficients, 0, &curve),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("it must be 1, 2 or 3");
        CHECK(!curve);
    }
    for (int d = 1; d <= 3; d++) {
        CHECK_OK(
            batten_curve_from_power(d, (batten_pieces){1, 1, breaks}, coefficients, 0, &curve));
        CHECK_INT(batten_curve_dimension(curve), d);
        batten_curve_unref(curve);
    }
}
