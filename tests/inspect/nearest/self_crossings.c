#include "inspect/nearest/self_crossings.h"
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

/* ---- brute force ---- */

enum { MOST_CORNERS = 40 };

static batten_curve *polyline(int count, const double (*corners)[2])
{
    double knots[MOST_CORNERS + 2];
    batten_curve *curve = NULL;
    for (int i = 0; i < count; i++)
        knots[i + 1] = i;
    knots[0] = 0;
    knots[count + 1] = count - 1;
    CHECK_OK(
        batten_curve_create((batten_points){2, count, corners[0]}, 1, NULL, knots, &curve));
    return curve;
}

/* Where lines cross: in parts of both; false when they do not. */
static bool legs_cross(const double *a, const double *b, const double *c, const double *d,
                       double at[2])
{
    const double x = b[0] - a[0], y = b[1] - a[1], p = d[0] - c[0], q = d[1] - c[1];
    const double det = x * q - y * p;
    at[0] = ((c[0] - a[0]) * q - (c[1] - a[1]) * p) / det;
    at[1] = ((c[0] - a[0]) * y - (c[1] - a[1]) * x) / det;
    return at[0] > 0 && at[0] < 1 && at[1] > 0 && at[1] < 1;
}

static int sort_pairs(int count, bat_crossing *all)
{
    for (int i = 1; i < count; i++)
        for (int j = i; j > 0; j--) {
            const bat_crossing a = all[j - 1], b = all[j];
            const bool in_order = a.curve[0] != b.curve[0] ? a.curve[0] < b.curve[0]
                                  : a.u[0] != b.u[0]       ? a.u[0] < b.u[0]
                                                           : a.curve[1] < b.curve[1];
            if (in_order)
                break;
            all[j - 1] = b;
            all[j] = a;
        }
    return count;
}

/* Several polylines, each a curve; neighbours share an end when they are a chain. */
static void check_polylines(test_random *random, int curves, int each, bool closed)
{
    double corners[3][MOST_CORNERS][2];
    const batten_curve *made[3];
    static bat_crossing exact[1000];
    bat_crossings found = {0};
    int count = 0;
    for (int c = 0; c < curves; c++) {
        for (int i = 0; i < each; i++)
            for (int k = 0; k < 2; k++)
                corners[c][i][k] = c > 0 && i == 0 ? corners[c - 1][each - 1][k]
                                   : closed && c == curves - 1 && i == each - 1
                                       ? corners[0][0][k]
                                       : test_random_in(random, -1, 1);
        made[c] = polyline(each, (const double(*)[2])corners[c]);
    }
    for (int c = 0; c < curves; c++)
        for (int i = 0; i + 1 < each; i++)
            for (int e = c; e < curves; e++)
                for (int j = e == c ? i + 2 : 0; j + 1 < each; j++) {
                    double at[2];
                    if (legs_cross(corners[c][i], corners[c][i + 1], corners[e][j],
                                   corners[e][j + 1], at) &&
                        fmin(fmin(at[0], 1 - at[0]), fmin(at[1], 1 - at[1])) > 1e-9)
                        exact[count++] = (bat_crossing){{c, e}, {i + at[0], j + at[1]}};
                }
    sort_pairs(count, exact);
    CHECK_OK(bat_crossings_find(curves, made, closed, &found));
    CHECK_INT(found.count, count);
    sort_pairs(found.count, found.at);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++) {
            CHECK_INT(found.at[i].curve[k], exact[i].curve[k]);
            CHECK_NEAR(found.at[i].u[k], exact[i].u[k], 1e-9);
        }
    batten_release(found.at);
    for (int c = 0; c < curves; c++)
        batten_curve_unref((batten_curve *)(uintptr_t)made[c]);
}

TEST(the_crossings_of_polylines_are_those_of_their_legs)
{
    test_random random = test_random_begin("polylines");
    for (int i = 0; i < test_cases(60); i++) {
        const int curves = 1 + i % 3;
        check_polylines(&random, curves, 4 + i % 9, i & 4);
    }
}

/* Cubics, every other one rational. A loop smaller than a step of the polyline may be missed by it. */
TEST(the_crossings_of_random_curves_are_those_of_fine_polylines)
{
    enum { FINE = 1500 };
    test_random random = test_random_begin("random crossings");
    for (int round = 0; round < test_cases(25); round++) {
        enum { COUNT_OF_POINTS = 9 };
        double points[COUNT_OF_POINTS][2], weights[COUNT_OF_POINTS];
        const double knots[] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6};
        static double at[FINE + 1][2];
        batten_curve *curve = NULL;
        for (int i = 0; i < COUNT_OF_POINTS; i++) {
            weights[i] = test_random_in(&random, 0.5, 2);
            for (int k = 0; k < 2; k++)
                points[i][k] = test_random_in(&random, -1, 1);
        }
        CHECK_OK(batten_curve_create((batten_points){2, COUNT_OF_POINTS, points[0]}, 3,
                                     round % 2 ? weights : NULL, knots, &curve));
        batten_parameters found = {0};
        CHECK_OK(batten_curve_self_crossings(curve, &found));
        for (int i = 0; i <= FINE; i++)
            CHECK_OK(batten_curve_evaluate(curve, 6.0 * i / FINE, 0, at[i]));
        int count = 0;
        for (int i = 0; i < FINE; i++)
            for (int j = i + 2; j < FINE; j++) {
                double s[2];
                if (!legs_cross(at[i], at[i + 1], at[j], at[j + 1], s))
                    continue;
                double best = 1;
                for (int k = 0; k < found.count; k += 2)
                    best = fmin(best, fmax(fabs(found.at[k] - 6 * (i + s[0]) / FINE),
                                           fabs(found.at[k + 1] - 6 * (j + s[1]) / FINE)));
                CHECK(best < 0.02);
                count++;
            }
        CHECK(found.count >= 2 * (count - 1) && found.count <= 2 * (count + 1));
        for (int k = 0; k < found.count; k += 2) {
            double p[2], q[2];
            CHECK_OK(batten_curve_evaluate(curve, found.at[k], 0, p));
            CHECK_OK(batten_curve_evaluate(curve, found.at[k + 1], 0, q));
            CHECK_NEAR(hypot(p[0] - q[0], p[1] - q[1]), 0, 1e-10);
            CHECK(found.at[k] < found.at[k + 1]);
        }
        batten_release(found.at);
        batten_curve_unref(curve);
    }
}

TEST(crossings_are_those_of_plane_curves)
{
    batten_curve *line = NULL;
    batten_parameters found = {0};
    CHECK_OK(batten_curve_line(3, (double[]){0, 0, 0}, (double[]){1, 1, 1}, &line));
    CHECK_STATUS(batten_curve_self_crossings(line, &found), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("this one has 3 dimensions");
    batten_curve_unref(line);
}

TEST(crossings_at_corners_and_knots_are_found_once)
{
    /* both legs through (1, 1) have a corner of the polyline there, at 1 and at 4 */
    static const double through[6][2] = {{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}};
    /* (3, 0) is a corner, at 1, and lies inside the last leg, midway between 4 and 5 */
    static const double beside[6][2] = {{0, 0}, {3, 0}, {6, 4}, {6, -2}, {3, -2}, {3, 2}};
    static const double expected[2][2] = {{1, 4}, {1, 4.5}};
    const double knots[8] = {0, 0, 1, 2, 3, 4, 5, 5};
    for (int i = 0; i < 2; i++) {
        batten_curve *curve = NULL;
        double at[2] = {0};
        CHECK_OK(
            batten_curve_create((batten_points){2, 6, i == 0 ? &through[0][0] : &beside[0][0]},
                                1, NULL, knots, &curve));
        CHECK_INT(crossings(curve, at, 2), 1);
        CHECK_NEAR(at[0], expected[i][0], 1e-12);
        CHECK_NEAR(at[1], expected[i][1], 1e-12);
        batten_curve_unref(curve);
    }
}
