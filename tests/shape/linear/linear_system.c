#include "shape/linear/linear_system.h"

#include "support/test.h"

static const double t[] = {0, 0.7, 1, 1.9, 2.2, 3.5, 4};

static bat_request request(batten_end_kind ends)
{
    return (bat_request){.degree = 3,
                         .count = 7,
                         .parameters = t,
                         .knots_at_data = true,
                         .start = ends,
                         .end = ends};
}

TEST(the_rows_of_a_cubic_with_knots_at_the_data_have_a_closed_form)
{
    const bat_request clamped = request(BATTEN_END_CLAMPED);
    bat_operator op;
    CHECK_OK(bat_operator_make(&clamped, &op));
    CHECK_INT(op.count, 9);
    CHECK(op.lower == 1 && op.upper == 1);
    for (int i = 2; i < 7; i++) {
        /* Steps around the knot of data point i - 1. */
        const double *U = op.knots + i - 1;
        double h[5];
        for (int k = 0; k < 5; k++)
            h[k] = U[k + 1] - U[k];
        const double *row = op.matrix + 3 * i;
        const double a = h[3] * h[3] / ((h[1] + h[2] + h[3]) * (h[2] + h[3]));
        const double c = h[2] * h[2] / ((h[2] + h[3] + h[4]) * (h[2] + h[3]));
        CHECK_NEAR(row[0], a, 1e-15);
        CHECK_NEAR(row[1], 1 - a - c, 1e-15);
        CHECK_NEAR(row[2], c, 1e-15);
    }
    bat_operator_free(&op);
}

TEST(knots_are_left_out_where_conditions_are_missing)
{
    const bat_request free_ends = request(BATTEN_END_NOT_A_KNOT),
                      natural = request(BATTEN_END_NATURAL);
    bat_operator op;
    CHECK_OK(bat_operator_make(&free_ends, &op));
    CHECK_INT(op.count, 7);
    CHECK(op.knots[4] == t[2] && op.knots[6] == t[4]);
    bat_operator_free(&op);
    CHECK_OK(bat_operator_make(&natural, &op));
    CHECK_INT(op.count, 9);
    CHECK(op.knots[4] == t[1] && op.knots[8] == t[5]);
    bat_operator_free(&op);
}

TEST(averaged_knots_lie_between_their_parameters)
{
    bat_request averaged = request(BATTEN_END_NOT_A_KNOT);
    averaged.knots_at_data = false;
    for (averaged.degree = 1; averaged.degree <= 6; averaged.degree++) {
        const int p = averaged.degree;
        bat_operator op;
        CHECK_OK(bat_operator_make(&averaged, &op));
        for (int j = 1; j < 7 - p; j++) {
            double sum = 0;
            for (int i = j; i < j + p; i++)
                sum += t[i] / p;
            CHECK_NEAR(op.knots[j + p], sum, 1e-15);
        }
        CHECK(op.lower < bat_max_int(p, 2) && op.upper < bat_max_int(p, 2));
        bat_operator_free(&op);
    }
}

TEST(the_equations_of_a_period_have_their_centre_on_the_diagonal)
{
    const double period[] = {0, 1, 2, 3, 4, 5, 6, 7};
    const double rows[2][3] = {{1 / 8.0, 6 / 8.0, 1 / 8.0}, {1 / 6.0, 4 / 6.0, 1 / 6.0}};
    for (int degree = 2; degree <= 3; degree++) {
        const bat_request closed = {.degree = degree,
                                    .count = 7,
                                    .parameters = period,
                                    .knots_at_data = true,
                                    .periodic = true};
        bat_operator op;
        CHECK_OK(bat_operator_make(&closed, &op));
        CHECK(op.lower == 1 && op.upper == 1 && op.count == 7);
        for (int i = 0; i < 21; i++)
            CHECK_NEAR(op.matrix[i], rows[degree - 2][i % 3], 1e-15);
        CHECK_NEAR(op.knots[0], degree == 2 ? -0.5 : 0, 0);
        bat_operator_free(&op);
    }
}

TEST(fair_ends_need_as_many_jumps_as_there_are_of_them)
{
    bat_request fair = request(BATTEN_END_FAIR);
    for (fair.count = 2; fair.count <= 7; fair.count++) {
        bat_operator op;
        CHECK_OK(bat_operator_make(&fair, &op));
        CHECK_INT(op.fair_count, fair.count > 3 ? 2 : 0);
        bat_operator_free(&op);
    }
}
