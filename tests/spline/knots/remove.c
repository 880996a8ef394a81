#include "spline/spline.h"

#include "support/splines.h"

TEST(what_was_inserted_is_removed_and_no_more)
{
    bat_spline spline = {0}, refined = {0}, made = {0};
    const double knots[] = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, values[] = {1, 4, -2, 0, 5, 3},
                 u[] = {1.5, 1.5};
    int removed = -1;
    double error = -1;
    CHECK_OK(bat_spline_make(3, 6, 1, &spline));
    memcpy(spline.knots, knots, sizeof knots);
    memcpy(spline.values, values, sizeof values);
    CHECK_OK(bat_spline_insert(&spline, 2, u, &refined));
    CHECK_OK(bat_spline_remove(&refined, 1.5, 9, 1, 1e-12, &removed, &error, &made));
    CHECK_INT(removed, 2);
    CHECK(error < 1e-14);
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(made.values[i], values[i], 1e-13);
    bat_spline_free(&made);
    CHECK_OK(bat_spline_remove_all(&refined, 1, 1e-12, &removed, &error, &made));
    CHECK_INT(removed, 2);
    CHECK_INT(made.count, 6);
    bat_spline_free(&made);
    bat_spline_free(&refined);
    bat_spline_free(&spline);
}

TEST(inserted_knots_go_again_for_any_degree_and_width)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(80); c++) {
        const int p = test_random_int(&random, 2, 5);
        bat_spline spline = {0}, refined = {0}, one = {0}, all = {0};
        CHECK_OK(random_spline(&random, p, 2, &spline));
        const double a = spline.knots[p], b = spline.knots[spline.count];
        double u[2];
        u[0] = u[1] = a + test_random_in(&random, 0.1, 0.9) * (b - a);
        int removed = -1;
        double error = -1;
        CHECK_OK(bat_spline_insert(&spline, 2, u, &refined));
        CHECK_OK(bat_spline_remove(&refined, u[0], 1, 2, 1e-9, &removed, &error, &one));
        CHECK_INT(removed, 1);
        CHECK_INT(one.count, spline.count + 1);
        CHECK(error >= 0 && error < 1e-10);
        CHECK(spline_distance(&spline, &one) < 1e-10);
        CHECK_OK(bat_spline_remove(&refined, u[0], 5, 2, 1e-9, &removed, &error, &all));
        CHECK_INT(removed, 2);
        CHECK_INT(all.count, spline.count);
        for (int i = 0; i <= spline.count + p; i++)
            CHECK_BITS(all.knots[i], spline.knots[i]);
        for (int i = 0; i < 2 * spline.count; i++)
            CHECK_NEAR(all.values[i], spline.values[i], 1e-9);
        bat_spline_free(&all);
        bat_spline_free(&one);
        bat_spline_free(&refined);
        bat_spline_free(&spline);
    }
}

TEST(what_a_removal_moves_is_bounded_by_its_error)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(80); c++) {
        const int p = test_random_int(&random, 2, 4);
        bat_spline spline = {0}, made = {0};
        CHECK_OK(random_spline(&random, p, 1, &spline));
        double *errors = test_array((size_t)(spline.count + p + 1), sizeof *errors);
        CHECK_OK(bat_spline_removal_errors(&spline, 1, errors));
        for (int r = 0; r <= spline.count + p; r++) {
            const double u = spline.knots[r];
            int removed = -1;
            double error = -1;
            const bool inner = r < spline.count && u > spline.knots[p] &&
                               u < spline.knots[spline.count] && u != spline.knots[r + 1];
            CHECK(inner == isfinite(errors[r]));
            if (!inner)
                continue;
            CHECK_OK(bat_spline_remove(&spline, u, 1, 1, errors[r], &removed, &error, &made));
            CHECK_INT(removed, 1);
            CHECK_BITS(error, errors[r]);
            CHECK(spline_distance(&spline, &made) <= error * (1 + 1e-12));
            CHECK(spline_distance(&spline, &made) > 0);
            bat_spline_free(&made);
            /* With a little less nothing goes, and every bit stays. */
            CHECK_OK(bat_spline_remove(&spline, u, 1, 1, nextafter(errors[r], 0), &removed,
                                       &error, &made));
            CHECK_INT(removed, 0);
            CHECK_BITS(error, 0);
            CHECK(memcmp(made.values, spline.values, (size_t)spline.count * 8) == 0);
            bat_spline_free(&made);
        }
        bat_spline_free(&spline);
    }
}

TEST(a_knot_that_is_not_there_is_not_removed)
{
    test_random random = test_random_begin(__func__);
    bat_spline spline = {0}, made = {0};
    int removed = -1;
    double error = -1;
    CHECK_OK(random_spline(&random, 3, 1, &spline));
    const double u = spline.knots[3] + 1e-3;
    CHECK_OK(bat_spline_remove(&spline, u, 3, 1, HUGE_VAL, &removed, &error, &made));
    CHECK(removed == 0 || made.count < spline.count);
    bat_spline_free(&made);
    CHECK_OK(bat_spline_remove(&spline, u, 3, 1, 1e300, &removed, &error, &made));
    CHECK_INT(removed, 0);
    CHECK_INT(made.count, spline.count);
    bat_spline_free(&made);
    bat_spline_free(&spline);
}

TEST(the_distance_of_points_counts_and_not_that_of_rows)
{
    /* One row of two points: the farther of both counts; as one point, their common norm. */
    const double knots[] = {0, 0, 1, 2, 2};
    const double values[3][4] = {{0, 0, 0, 0}, {3, 4, 6, 8}, {0, 0, 0, 0}};
    bat_spline spline = {0};
    double two[5], one[5], each[5];
    CHECK_OK(bat_spline_make(1, 3, 4, &spline));
    memcpy(spline.knots, knots, sizeof knots);
    memcpy(spline.values, values, sizeof values);
    CHECK_OK(bat_spline_removal_errors(&spline, 2, two));
    CHECK_OK(bat_spline_removal_errors(&spline, 4, one));
    CHECK_OK(bat_spline_removal_errors(&spline, 1, each));
    CHECK_NEAR(two[2], 10, 1e-14);
    CHECK_NEAR(one[2], sqrt(125), 1e-14);
    CHECK_NEAR(each[2], 8, 1e-14);
    for (int j = 0; j < 5; j++)
        CHECK(j == 2 || isinf(two[j]));
    bat_spline_free(&spline);
}

TEST(values_whose_differences_overflow_count_as_too_far)
{
    const double knots[] = {0, 0, 1, 2, 2}, values[] = {1.7e308, -1.7e308, 1.7e308};
    bat_spline spline = {0}, made = {0};
    int removed = -1;
    double error = -1;
    CHECK_OK(bat_spline_make(1, 3, 1, &spline));
    memcpy(spline.knots, knots, sizeof knots);
    memcpy(spline.values, values, sizeof values);
    CHECK_OK(bat_spline_remove(&spline, 1, 1, 1, 1e308, &removed, &error, &made));
    CHECK_INT(removed, 0);
    bat_spline_free(&made);
    bat_spline_free(&spline);
}

TEST(thinning_keeps_its_tolerance_and_says_how_far_it_went)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(40); c++) {
        const int p = test_random_int(&random, 1, 4);
        bat_spline spline = {0}, thin = {0}, again = {0};
        CHECK_OK(random_spline(&random, p, 1, &spline));
        for (int t = 0; t < 3; t++) {
            const double tolerance = t == 0 ? 0.01 : t == 1 ? 0.3 : 3;
            int removed = -1, more = -1;
            double error = -1, rest = -1;
            CHECK_OK(bat_spline_insert(&spline, 0, NULL, &thin));
            CHECK_OK(bat_spline_thin(&thin, 1, tolerance, &removed, &error));
            CHECK_INT(thin.count, spline.count - removed);
            CHECK(error >= 0 && error <= tolerance && (removed > 0) == (error > 0));
            CHECK(spline_distance(&spline, &thin) <= error + 1e-14);
            CHECK_OK(bat_knots_check(p, thin.count, thin.knots, "knot"));
            /* What is left costs more than the tolerance, from where it started. */
            CHECK_OK(bat_spline_insert(&thin, 0, NULL, &again));
            CHECK_OK(bat_spline_thin(&again, 1, 0, &more, &rest));
            CHECK(more == 0 || rest == 0);
            bat_spline_free(&again);
            bat_spline_free(&thin);
        }
        bat_spline_free(&spline);
    }
}
