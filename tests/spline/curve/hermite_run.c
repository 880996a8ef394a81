/* Runs of quintics: places are gathered, made a curve, and forgotten. */
#include "spline/curve/hermite_run.h"
#include "support/test.h"

#include <string.h>

/* t^5 and its first two derivatives at 1, 2 and 3; across it t^2, up it 3 t. */
static const double power[3][9] = {
    {1, 1, 3, 5, 2, 3, 20, 2, 0},
    {32, 4, 6, 80, 4, 3, 160, 2, 0},
    {243, 9, 9, 405, 6, 3, 540, 2, 0},
};

static batten_status gather(int dimension, int count, batten_curve **out)
{
    bat_hermite_run run = {.dimension = dimension};
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        status = bat_hermite_run_add(&run, i + 1, power[i]);
    if (status == BATTEN_OK)
        status = bat_hermite_run_finish(&run, out);
    if (status == BATTEN_OK)
        CHECK_INT(run.count, 0);
    bat_hermite_run_release(&run);
    return status;
}

TEST(a_run_through_places_of_a_quintic_is_that_quintic_in_every_dimension)
{
    for (int d = 1; d <= 3; d++) {
        batten_curve *curve = NULL;
        CHECK_OK(gather(d, 3, &curve));
        CHECK_INT(batten_curve_dimension(curve), d);
        CHECK_INT(batten_curve_degree(curve), 5);
        CHECK(batten_curve_domain(curve).a == 1 && batten_curve_domain(curve).b == 3);
        for (int i = 0; i <= 8; i++) {
            const double t = 1 + i / 4.0, want[3] = {t * t * t * t * t, t * t, 3 * t};
            double point[3];
            CHECK_OK(batten_curve_evaluate(curve, t, 0, point));
            for (int k = 0; k < d; k++)
                CHECK_NEAR(point[k], want[k], 1e-12 * 243);
        }
        batten_curve_unref(curve);
    }
}

TEST(a_run_of_fewer_than_two_places_makes_no_curve_and_can_start_again)
{
    for (int count = 0; count < 2; count++) {
        batten_curve *curve = (batten_curve *)&curve;
        CHECK_OK(gather(3, count, &curve));
        CHECK(!curve);
    }
}

TEST(a_run_starts_anew_after_it_is_finished)
{
    batten_curve *curve = NULL;
    bat_hermite_run run = {.dimension = 2};
    for (int i = 0; i < 2; i++)
        CHECK_OK(bat_hermite_run_add(&run, i, power[i]));
    CHECK_OK(bat_hermite_run_finish(&run, &curve));
    batten_curve_unref(curve);
    for (int i = 1; i < 3; i++)
        CHECK_OK(bat_hermite_run_add(&run, 10 + i, power[i]));
    CHECK_OK(bat_hermite_run_finish(&run, &curve));
    double end[2];
    CHECK(batten_curve_domain(curve).a == 11 && batten_curve_domain(curve).b == 12);
    CHECK_OK(batten_curve_evaluate(curve, 12, 0, end));
    CHECK(end[0] == 243 && end[1] == 9);
    batten_curve_unref(curve);
    bat_hermite_run_release(&run);
    CHECK(!run.places && run.room == 0);
}

/* Row `row` changed by `by` in coordinate `c`; do sides whose rows count from `first` agree? */
static const struct {
    int dimension, first, row, c;
    double by;
    bool agrees;
} pairs[] = {
    {3, 0, 0, 0, 0, true},    {3, 0, 0, 0, 0.4, true},  {3, 0, 0, 2, 0.6, false},
    {3, 1, 0, 2, 9, true},    {3, 1, 1, 1, 0.45, true}, {3, 1, 1, 1, 0.75, false},
    {3, 1, 2, 0, -2, true},   {3, 1, 2, 0, 2.4, false}, {3, 2, 1, 1, 9, true},
    {2, 0, 2, 2, 1000, true}, {1, 0, 1, 1, 1000, true}, {2, 0, 2, 1, 2.4, false},
};

TEST(sides_agree_when_every_row_from_the_first_differs_by_little_of_the_longer_one)
{
    /* Rows of lengths 5, 6 and 20: a tenth of them, or of a longer other side. */
    static const double left[9] = {3, 0, 4, 0, 6, 0, 0, 20, 0};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        const int d = pairs[i].dimension, first = pairs[i].first;
        double right[9];
        memcpy(right, left, sizeof left);
        right[3 * pairs[i].row + pairs[i].c] += pairs[i].by;
        CHECK_INT(bat_hermite_agrees(d, first, left, right, 0.1), pairs[i].agrees);
        CHECK_INT(bat_hermite_agrees(d, first, right, left, 0.1), pairs[i].agrees);
    }
}
