#include "spline/spline.h"

#include "support/test.h"

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
