#include "numeric/dense.h"

#include "support/test.h"

static void random_numbers(test_random *random, int count, double *out)
{
    for (int i = 0; i < count; i++)
        out[i] = test_random_in(random, -1, 1);
}

/* b[rows][width] = a[rows][columns] x[columns][width]. */
static void multiply(int rows, int columns, int width, const double *a, const double *x,
                     double *b)
{
    for (int i = 0; i < rows; i++)
        for (int k = 0; k < width; k++) {
            b[i * width + k] = 0;
            for (int j = 0; j < columns; j++)
                b[i * width + k] += a[i * columns + j] * x[j * width + k];
        }
}

TEST(a_dense_solution_leaves_a_residual_of_rounding)
{
    test_random random = test_random_begin("dense");
    for (int n = 1; n <= 24; n++) {
        const int width = 1 + n % 3;
        double a[24 * 24], lu[24 * 24], x[24 * 3], b[24 * 3], again[24 * 3];
        int pivots[24];
        random_numbers(&random, n * n, a);
        random_numbers(&random, n * width, b);
        memcpy(lu, a, sizeof a);
        memcpy(x, b, sizeof b);
        CHECK_OK(bat_dense_factor(n, lu, pivots));
        bat_dense_solve(n, lu, pivots, (size_t)width, x);
        multiply(n, n, width, a, x, again);
        double size = 0;
        for (int i = 0; i < n * width; i++)
            size = fmax(size, fabs(x[i]));
        for (int i = 0; i < n * width; i++)
            CHECK_NEAR(again[i], b[i], 10 * n * n * DBL_EPSILON * size);
    }
}

TEST(a_zero_on_the_diagonal_is_pivoted_away)
{
    double a[4] = {0, 2, 3, 0}, b[2] = {4, 9};
    int pivots[2];
    CHECK_OK(bat_dense_factor(2, a, pivots));
    bat_dense_solve(2, a, pivots, 1, b);
    CHECK_BITS(b[0], 3);
    CHECK_BITS(b[1], 2);
}

TEST(scales_of_rows_and_columns_do_not_make_a_matrix_singular)
{
    double a[4] = {1e-200, 1e100, 2e-200, -1e100};
    int pivots[2];
    CHECK_OK(bat_dense_factor(2, a, pivots));
}

TEST(dependent_rows_are_refused_naming_the_unknown)
{
    double a[9] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
    int pivots[3];
    CHECK_STATUS(bat_dense_factor(3, a, pivots), BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("unknown 3 of 3");
    double zero[1] = {0}, infinite[1] = {INFINITY};
    CHECK_STATUS(bat_dense_factor(1, zero, pivots), BATTEN_SINGULAR_SYSTEM);
    CHECK_STATUS(bat_dense_factor(1, infinite, pivots), BATTEN_SINGULAR_SYSTEM);
}

/* The residual of a least squares solution is orthogonal to every column. */
TEST(a_least_squares_residual_is_orthogonal_to_the_columns)
{
    test_random random = test_random_begin("squares");
    for (int rows = 1; rows <= 20; rows++)
        for (int columns = 1; columns <= rows && columns <= 6; columns++) {
            double a[20 * 6], qr[20 * 6], b[40], x[40], fitted[40];
            random_numbers(&random, rows * columns, a);
            random_numbers(&random, rows * 2, b);
            memcpy(qr, a, sizeof a);
            memcpy(x, b, sizeof b);
            CHECK_OK(bat_dense_least_squares(rows, columns, qr, 2, x));
            multiply(rows, columns, 2, a, x, fitted);
            double size = 1, rest = 0, left = 0;
            for (int i = 0; i < columns * 2; i++)
                size = fmax(size, fabs(x[i]));
            for (int j = 0; j < columns; j++)
                for (int k = 0; k < 2; k++) {
                    double dot = 0;
                    for (int i = 0; i < rows; i++)
                        dot += a[i * columns + j] * (fitted[i * 2 + k] - b[i * 2 + k]);
                    CHECK_NEAR(dot, 0, 100 * rows * DBL_EPSILON * size);
                }
            for (int i = 0; i < rows; i++)
                rest += pow(fitted[i * 2] - b[i * 2], 2);
            for (int i = columns; i < rows; i++)
                left += x[i * 2] * x[i * 2];
            CHECK_NEAR(rest, left, 1000 * rows * DBL_EPSILON * size * size);
        }
}

TEST(N2_least_squares_do_not_care_for_the_scale)
{
    static const double scales[] = {1e-300, 1e-160, 1, 1e160, 1e300};
    for (int s = 0; s < COUNT(scales); s++) {
        double a[6] = {1, 1, 1, 2, 1, 4}, b[3] = {3, 5, 9};
        for (int i = 0; i < 6; i++)
            a[i] *= scales[s];
        CHECK_OK(bat_dense_least_squares(3, 2, a, 1, b));
        CHECK_NEAR(b[0] * scales[s], 1, 32 * DBL_EPSILON);
        CHECK_NEAR(b[1] * scales[s], 2, 32 * DBL_EPSILON);
    }
}

TEST(a_dependent_column_is_refused_naming_it)
{
    double a[8] = {1, 2, 3, 6, -1, -2, 0.1, 0.2}, b[4] = {1, 2, 3, 4};
    CHECK_STATUS(bat_dense_least_squares(4, 2, a, 1, b), BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("unknown 2 of 2");
    double infinite[2] = {INFINITY, 1};
    CHECK_STATUS(bat_dense_least_squares(2, 1, infinite, 1, b), BATTEN_SINGULAR_SYSTEM);
    double zero[2] = {0, 0};
    CHECK_STATUS(bat_dense_least_squares(2, 1, zero, 1, b), BATTEN_SINGULAR_SYSTEM);
}
