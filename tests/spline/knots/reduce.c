#include "spline/spline.h"

#include "support/splines.h"

TEST(a_parabola_elevated_twice_is_found_again)
{
    bat_spline spline = {0}, high = {0}, made = {0};
    const double knots[] = {0, 0, 0, 1, 1, 2.5, 4, 4, 4}, values[] = {1, 4, -2, 0, 5, 3};
    double error = -1;
    CHECK_OK(bat_spline_make(2, 6, 1, &spline));
    memcpy(spline.knots, knots, sizeof knots);
    memcpy(spline.values, values, sizeof values);
    CHECK_OK(bat_spline_elevate(&spline, 2, &high));
    CHECK_OK(bat_spline_reduce(&high, 2, 1, 1e-12, &error, &made));
    CHECK_INT(made.count, 6);
    for (int i = 0; i < 9; i++)
        CHECK_BITS(made.knots[i], knots[i]);
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(made.values[i], values[i], 1e-13);
    bat_spline_free(&made);
    CHECK_STATUS(bat_spline_reduce(&spline, 1, 1, 1e-3, &error, &made),
                 BATTEN_TOLERANCE_NOT_MET);
    bat_spline_free(&high);
    bat_spline_free(&spline);
}

TEST(what_was_elevated_is_reduced_to_itself)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        const int p = test_random_int(&random, 1, 5), by = test_random_int(&random, 1, 2);
        bat_spline spline = {0}, clamped = {0}, high = {0}, made = {0};
        double error = -1;
        CHECK_OK(random_spline(&random, p, 2, &spline));
        CHECK_OK(bat_spline_subrange(&spline, spline.knots[p], spline.knots[spline.count],
                                     &clamped));
        CHECK_OK(bat_spline_elevate(&clamped, by, &high));
        CHECK_NEAR(spline_distance(&clamped, &high), 0, 1e-11);
        CHECK_OK(bat_spline_reduce(&high, p, 2, 1e-8, &error, &made));
        CHECK_INT(made.degree, p);
        CHECK_INT(made.count, clamped.count);
        CHECK(error >= 0 && error < 1e-9);
        for (int i = 0; i <= made.count + p; i++)
            CHECK_BITS(made.knots[i], clamped.knots[i]);
        CHECK_NEAR(spline_distance(&clamped, &made), 0, 1e-8);
        bat_spline_free(&made);
        bat_spline_free(&high);
        bat_spline_free(&clamped);
        bat_spline_free(&spline);
    }
}

TEST(a_reduction_stays_within_its_bound_and_keeps_both_ends)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        const int p = test_random_int(&random, 2, 5);
        bat_spline spline = {0}, made = {0}, none = {0};
        double error = -1, kept = -1;
        CHECK_OK(random_spline(&random, p, 1, &spline));
        CHECK_OK(bat_spline_reduce(&spline, p - 1, 1, 1e9, &error, &made));
        CHECK(spline_distance(&spline, &made) <= error * (1 + 1e-12) + 1e-14);
        CHECK(error > 0 && error < 100);
        const double ends[2] = {spline.knots[p], spline.knots[spline.count]};
        for (int e = 0; e < 2; e++)
            CHECK_NEAR(made.values[e ? made.count - 1 : 0],
                       spline_by_definition(&spline, 0, ends[e], BATTEN_FROM_RIGHT, 0), 1e-13);
        bat_spline_free(&made);
        CHECK_OK(bat_spline_reduce(&spline, p - 1, 1, error, &kept, &made));
        CHECK_BITS(kept, error);
        CHECK_STATUS(bat_spline_reduce(&spline, p - 1, 1, nextafter(error, 0), &kept, &none),
                     BATTEN_TOLERANCE_NOT_MET);
        bat_spline_free(&made);
        bat_spline_free(&spline);
    }
}

/* How far the rows of a Bezier spline are from those of another, elevated by one: squares. */
static double squares_of_rows(const bat_spline *low, const bat_spline *high)
{
    double sum = 0;
    bat_spline raised = {0};
    CHECK_OK(bat_spline_elevate(low, 1, &raised));
    CHECK_INT(raised.count, high->count);
    for (int i = 0; i < high->count; i++)
        sum += (raised.values[i] - high->values[i]) * (raised.values[i] - high->values[i]);
    bat_spline_free(&raised);
    return sum;
}

TEST(no_other_inner_rows_come_nearer)
{
    test_random random = test_random_begin(__func__);
    for (int p = 3; p <= 7; p++) {
        bat_spline high = {0}, low = {0};
        double error = -1;
        CHECK_OK(bat_spline_make(p, p + 1, 1, &high));
        for (int i = 0; i <= p; i++) {
            high.knots[p + 1 + i] = 1;
            high.values[i] = test_random_in(&random, -1, 1);
        }
        CHECK_OK(bat_spline_reduce(&high, p - 1, 1, 1e9, &error, &low));
        const double least = squares_of_rows(&low, &high);
        for (int i = 1; i < low.count - 1; i++)
            for (int sign = -1; sign <= 1; sign += 2) {
                const double kept = low.values[i];
                low.values[i] += sign * 1e-4;
                CHECK(squares_of_rows(&low, &high) > least);
                low.values[i] = kept;
            }
        bat_spline_free(&low);
        bat_spline_free(&high);
    }
}
