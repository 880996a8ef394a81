/* Which knots rows of points take. */
#include "shape/skin/rows_of_points.h"
#include "support/test.h"

/* Knots that are there, a row of parameters, and the knots afterwards. */
static const struct {
    int degree, before, count, after;
    double margin, knots[4], u[6], wanted[5];
} rows[] = {
    /* Degree 1: a knot at each inner parameter, as there is room. */
    {1, 0, 4, 2, 0, {0}, {0, 0.25, 0.5, 1}, {0.25, 0.5}},
    /* The nearest ones that are there; the third, wished at 0.6, keeps a quarter of its room away from that at 0.5. */
    {1, 2, 5, 3, 0, {0.25, 0.5}, {0, 0.3, 0.45, 0.6, 1}, {0.25, 0.5, 0.625}},
    /* The mean of two parameters, and of three. */
    {2, 0, 4, 1, 0, {0}, {0, 0.2, 0.6, 1}, {0.4}},
    {3, 0, 5, 1, 0, {0}, {0, 0.2, 0.4, 0.9, 1}, {0.5}},
    /* With a margin of 0.22 that at 0.2 is too far left, and a new one a sixteenth away from it. */
    {1, 1, 3, 2, 0.22, {0.2}, {0, 0.25, 1}, {0.2, 0.2625}},
    {1, 1, 3, 1, 0.2, {0.2}, {0, 0.25, 1}, {0.2}},
    /* As far to the right as to the left. */
    {1, 1, 3, 2, 0.22, {0.8}, {0, 0.75, 1}, {0.7375, 0.8}},
    /* The margin moves what is wished. */
    {1, 2, 4, 3, 0.15, {0.2, 0.3}, {0, 0.25, 0.28, 1}, {0.2, 0.3, 0.3625}},
    /* No more points than a polynomial has. */
    {3, 1, 4, 1, 0, {0.5}, {0, 0.2, 0.6, 1}, {0.5}},
    {2, 0, 2, 0, 0, {0}, {0, 1}, {0}},
};

TEST(a_row_takes_the_knots_that_are_there_and_new_ones_where_none_fits)
{
    for (int i = 0; i < COUNT(rows); i++) {
        double knots[8] = {0};
        bat_shared_knots shared = {rows[i].before, 8, knots};
        memcpy(knots, rows[i].knots, sizeof rows[i].knots);
        bat_shared_knots_take(&shared, rows[i].degree, rows[i].count, rows[i].u,
                              rows[i].margin);
        CHECK_INT(shared.count, rows[i].after);
        for (int k = 0; k < shared.count; k++)
            CHECK_NEAR(knots[k], rows[i].wanted[k], 1e-15);
    }
}
