#include <batten/nearest.h>
#include <batten/standard.h>

#include "support/test.h"

static int crossings(const batten_curve *curve, double *at, int room)
{
    batten_parameters found = {0};
    CHECK_OK(batten_curve_self_crossings(curve, &found));
    for (int i = 0; i < found.count && i < room; i++)
        at[i] = found.at[i];
    const int count = found.count / 2;
    batten_release(found.at);
    return count;
}

/* (s^2 - 3, s (s^2 - 3)) for s = 4 u - 2 crosses itself at s = +-sqrt 3. */
static batten_curve *loop_of_size(double size)
{
    const double s[4] = {-2, -2.0 / 3, 2.0 / 3, 2};
    const double breaks[2] = {0, 1};
    double points[4][2];
    for (int i = 0; i < 4; i++) {
        /* blossoms of s^2 and s^3 at the control point: i times 2, 3 - i times -2 */
        const double squares[4] = {4, -4.0 / 3, -4.0 / 3, 4}, cubes[4] = {-8, 8, -8, 8};
        points[i][0] = size * (squares[i] - 3);
        points[i][1] = size * (cubes[i] - 3 * s[i]);
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, &points[0][0], NULL,
                                      &curve));
    return curve;
}

TEST(a_loop_crosses_itself_once_in_every_size)
{
    static const double sizes[] = {1, 1e-30, 1e-160, 1e-200, 1e-305, 1e100, 1e150};
    for (int k = 0; k < COUNT(sizes); k++) {
        batten_curve *curve = loop_of_size(sizes[k]);
        double at[2] = {0};
        CHECK_INT(crossings(curve, at, 2), 1);
        CHECK_NEAR(at[0], 0.5 - sqrt(3) / 4, 1e-12);
        CHECK_NEAR(at[1], 0.5 + sqrt(3) / 4, 1e-12);
        batten_curve_unref(curve);
    }
}

TEST(a_curve_of_a_few_smallest_numbers_ends_the_search)
{
    const double tiny = 5e-324,
                 points[4][2] = {{0, 0}, {3 * tiny, tiny}, {-tiny, tiny}, {tiny, 0}};
    const double breaks[2] = {0, 1};
    double at[2];
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, &points[0][0], NULL,
                                      &curve));
    CHECK(crossings(curve, at, 2) <= 1);
    batten_curve_unref(curve);
}

TEST(a_circle_does_not_cross_itself_where_it_closes)
{
    batten_curve *circle = NULL;
    double at[2];
    CHECK_OK(batten_curve_circle(2, 0, &circle));
    CHECK_INT(crossings(circle, at, 2), 0);
    batten_curve_unref(circle);
}
