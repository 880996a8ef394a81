/* Where curves are flat and where they stand still: zeros without a change of sign (inflections.c). */
#include "inspect/shapes.h"

#include <batten/curvature.h>
#include <math.h>

/* The Bezier points of (u - c)^power over [0, 1], as of this degree: its blossom at some ones and zeros. */
static void power_points(double c, int power, int degree, int stride, double *points)
{
    for (int i = 0; i <= degree; i++) {
        double sum = 0, ways = 1, all = 1;
        /* the mean over all choices of `power` arguments, k of which are one of the i ones */
        for (int k = 0; k < power; k++)
            all *= (double)(degree - k) / (k + 1);
        for (int k = 0; k <= power && k <= i; k++) {
            double zeros = 1;
            for (int m = 0; m < power - k; m++)
                zeros *= (double)(degree - i - m) / (m + 1);
            if (degree - i >= power - k)
                sum += ways * zeros * pow(1 - c, k) * pow(-c, power - k);
            ways *= (double)(i - k) / (k + 1);
        }
        points[stride * i] = sum / all;
    }
}

/* x = (u - c)^powers[0] and so on, of degree 4. */
static batten_curve *powers_at(int dimension, const int *powers, double c)
{
    double points[15];
    batten_curve *curve = NULL;
    for (int k = 0; k < dimension; k++)
        power_points(c, powers[k], 4, dimension, points + k);
    CHECK_OK(shape_bezier(dimension, 4, points, &curve));
    return curve;
}

static const double places[] = {0, 0.125, 0.5, 0.8, 1};

static void check_only(const batten_parameters *found, double at, double allowed)
{
    CHECK_INT(found->count, 1);
    CHECK_NEAR(found->at[0], at, allowed);
}

TEST(a_curve_is_flat_where_its_curvature_vanishes_with_or_without_an_inflection)
{
    static const struct {
        int dimension, powers[3];
        bool inflected;
    } rows[] = {
        {2, {1, 4}, false}, {2, {1, 3}, true}, {3, {1, 3, 4}, false}, {3, {4, 1, 3}, false}};
    for (int r = 0; r < COUNT(rows); r++)
        for (int i = 0; i < COUNT(places); i++) {
            batten_curve *curve = powers_at(rows[r].dimension, rows[r].powers, places[i]);
            batten_parameters flat = {0, NULL}, inflections = {0, NULL};
            CHECK_OK(batten_curve_flat_points(curve, &flat));
            check_only(&flat, places[i], 1e-12);
            if (rows[r].dimension == 2) {
                const bool inside = places[i] > 0 && places[i] < 1;
                CHECK_OK(batten_curve_inflections(curve, &inflections));
                CHECK_INT(inflections.count, rows[r].inflected && inside);
            }
            batten_release(inflections.at);
            batten_release(flat.at);
            batten_curve_unref(curve);
        }
}

TEST(a_curve_stands_still_where_its_first_derivative_vanishes)
{
    static const struct {
        int dimension, powers[3];
        double
            allowed; /* the square of the speed has a zero of order 4 where the speed has one of 2 */
    } rows[] = {
        {2, {2, 3}, 1e-12}, {2, {3, 4}, 2e-4}, {3, {4, 2, 3}, 1e-12}, {1, {2, 0, 0}, 1e-12}};
    for (int r = 0; r < COUNT(rows); r++)
        for (int i = 0; i < COUNT(places); i++) {
            batten_curve *curve = powers_at(rows[r].dimension, rows[r].powers, places[i]);
            batten_curve *cut = NULL;
            batten_parameters still = {0, NULL}, halves = {0, NULL};
            CHECK_OK(batten_curve_standstills(curve, &still));
            check_only(&still, places[i], rows[r].allowed);
            CHECK_OK(batten_curve_insert_knot(curve, 0.5, 4, &cut));
            CHECK_OK(
                batten_curve_standstills(cut, &halves)); /* at the knot too it is one place */
            check_only(&halves, places[i], rows[r].allowed);
            batten_release(still.at);
            batten_release(halves.at);
            batten_curve_unref(cut);
            batten_curve_unref(curve);
        }
}

TEST(a_curve_that_neither_flattens_nor_halts_has_no_such_points)
{
    static const int powers[] = {1, 2, 3};
    for (int d = 2; d <= 3; d++) {
        batten_curve *curve = powers_at(d, powers, 0.3);
        batten_parameters found = {7, NULL};
        CHECK_OK(batten_curve_flat_points(curve, &found));
        CHECK_INT(found.count, 0);
        batten_release(found.at);
        CHECK_OK(batten_curve_standstills(curve, &found));
        CHECK_INT(found.count, 0);
        batten_release(found.at);
        batten_curve_unref(curve);
    }
}
