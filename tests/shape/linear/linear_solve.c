#include "shape/linear/linear_solve.h"

#include "support/test.h"

static const double t[] = {0, 0.7, 1, 1.9, 2.2, 3.5, 4};

TEST(bessels_slope_is_that_of_the_parabola)
{
    const double a[] = {1, 0}, b[] = {4, 1}, c[] = {16, 3}; /* (1 + t)^2 and t at 0, 1, 3 */
    double slope[2];
    bat_bessel_slope(2, (const double[]){1, 2}, (const double *const[]){a, b, c}, slope);
    CHECK_NEAR(slope[0], 2, 1e-15);
    CHECK_NEAR(slope[1], 1, 1e-15);
    bat_bessel_slope(1, (const double[]){-2, -1}, (const double *const[]){c, b, a}, slope);
    CHECK_NEAR(slope[0], 8, 1e-14);
}

/* Columns know nothing of each other, so any number of them gives the same bits. */
TEST(one_factorisation_serves_all_columns_with_the_same_bits)
{
    test_random random = test_random_begin("columns");
    const batten_end_kind kinds[] = {BATTEN_END_NOT_A_KNOT, BATTEN_END_CLAMPED,
                                     BATTEN_END_BESSEL, BATTEN_END_FAIR, BATTEN_END_PARABOLIC};
    for (int c = 0; c < 10; c++) {
        const bat_request r = {.degree = 3,
                               .count = c < 5 ? 7 : 6,
                               .parameters = t,
                               .knots_at_data = true,
                               .periodic = c >= 5,
                               .start = kinds[c % 5],
                               .end = kinds[c % 5]};
        double data[35], ends[10], all[9 * 5];
        for (int i = 0; i < 35; i++)
            data[i] = test_random_in(&random, -1, 1);
        for (int i = 0; i < 10; i++)
            ends[i] = test_random_in(&random, -1, 1);
        bat_operator op;
        CHECK_OK(bat_operator_make(&r, &op));
        CHECK_OK(
            bat_operator_apply(&op, &(bat_spline_data){5, data, ends, ends + 5, NULL}, all));
        for (int k = 0; k < 5; k++) {
            double column[7], one[9];
            for (int i = 0; i < 7; i++)
                column[i] = data[5 * i + k];
            CHECK_OK(bat_operator_apply(
                &op, &(bat_spline_data){1, column, &ends[k], &ends[5 + k], NULL}, one));
            for (int i = 0; i < op.count; i++)
                CHECK_BITS(all[5 * i + k], one[i]);
        }
        bat_operator_free(&op);
    }
}

TEST(ends_without_values_have_zeros)
{
    const bat_request r = {.degree = 3,
                           .count = 7,
                           .parameters = t,
                           .knots_at_data = true,
                           .start = BATTEN_END_CLAMPED,
                           .end = BATTEN_END_SECOND};
    double data[7] = {0}, control[9];
    bat_operator op;
    CHECK_OK(bat_operator_make(&r, &op));
    CHECK_OK(bat_operator_apply(&op, &(bat_spline_data){.width = 1, .data = data}, control));
    for (int i = 0; i < 9; i++)
        CHECK_NEAR(control[i], 0, 0);
    bat_operator_free(&op);
}

/* Spoil the factors a little: refinement mends that. Spoil them much: it is found out. */
TEST(solutions_are_checked_refined_and_refused)
{
    const bat_request r = {.degree = 3, .count = 7, .parameters = t, .knots_at_data = true};
    const double data[7] = {1, 2, 0, 1, -1, 3, 2};
    double right[7], mended[7];
    bat_operator op;
    CHECK_OK(bat_operator_make(&r, &op));
    CHECK_OK(bat_operator_apply(&op, &(bat_spline_data){.width = 1, .data = data}, right));
    for (int i = 0; i < 7 * (op.lower + op.upper + 1); i++)
        op.factor[i] *= 1 + 1e-9 * (i % 3);
    CHECK_OK(bat_operator_apply(&op, &(bat_spline_data){.width = 1, .data = data}, mended));
    for (int i = 0; i < 7; i++)
        CHECK_NEAR(mended[i], right[i], 1e-14);
    for (int i = 0; i < 7 * (op.lower + op.upper + 1); i++)
        op.factor[i] *= 1 + 0.1 * (i % 3);
    CHECK_STATUS(bat_operator_apply(&op, &(bat_spline_data){.width = 1, .data = data}, mended),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("more than 8 eps of the largest number");
    bat_operator_free(&op);
}

TEST(a_refined_periodic_solution_begins_with_the_same_point)
{
    const double period[] = {0, 1, 2.5, 3, 4.2, 5};
    const bat_request r = {.degree = 3, .count = 5, .parameters = period, .periodic = true};
    const double data[5] = {1, 2, 0, 1, -1};
    double right[5], mended[5];
    bat_operator op;
    CHECK_OK(bat_operator_make(&r, &op));
    CHECK_OK(bat_operator_apply(&op, &(bat_spline_data){.width = 1, .data = data}, right));
    for (int i = 0; i < 15; i++)
        op.matrix[i] *= 1 + 1e-9 * (i % 3);
    CHECK_OK(bat_operator_apply(&op, &(bat_spline_data){.width = 1, .data = data}, mended));
    for (int i = 0; i < 5; i++)
        CHECK_NEAR(mended[i], right[i], 1e-7);
    bat_operator_free(&op);
}
