/* How far a piece of a curve is from the quintic that replaces it by arc length. */
#include "shape/near/arc_length_bound.h"
#include "support/test.h"

#include <batten/curve.h>
#include <batten/measure.h>
#include <batten/standard.h>

static batten_curve *bezier(int dimension, int degree, const double *points,
                            const double *weights)
{
    const double breaks[] = {0, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(dimension, (batten_pieces){degree, 1, breaks}, points,
                                      weights, &curve));
    return curve;
}

TEST(the_bound_of_an_arc_is_that_of_its_sixth_derivative)
{
    /* On a circle of radius r it is 1 / r^5, whatever the parameters of the rational curve. */
    for (int i = 1; i <= 6; i++)
        for (int degree = 2; degree <= 5; degree++) {
            const double radius = 3, half = 0.1 * i;
            const double points[] = {radius * cos(half), -radius * sin(half),
                                     radius / cos(half), 0,
                                     radius * cos(half), radius * sin(half)};
            const double weights[] = {1, cos(half), 1};
            batten_curve *arc = bezier(2, 2, points, weights), *raised = NULL;
            CHECK_OK(batten_curve_elevate(arc, degree - 2, &raised));
            const double h = 2 * half * radius;
            double bound = 0;
            CHECK_OK(bat_arc_length_bound(raised, h, &bound));
            const double exact = pow(h, 6) / pow(radius, 5) / 46080;
            CHECK(bound >= exact * (1 - 1e-9) && bound <= (i <= 3 ? 1.2 : 2) * exact);
            batten_curve_unref(raised);
            batten_curve_unref(arc);
        }
}

TEST(a_straight_piece_has_no_error_at_any_speed)
{
    const double points[] = {1, 2, 3, 1.1, 2.2, 3.3, 1.4, 2.8, 4.2, 2, 4, 6};
    const double weights[] = {1, 3, 0.5, 2};
    for (int rational = 0; rational < 2; rational++)
        for (int degree = 1; degree <= 3; degree += 2) {
            batten_curve *line = bezier(3, degree, points, rational ? weights : NULL);
            const double t = degree == 1 ? 0.1 : 1;
            double bound = 1;
            CHECK_OK(bat_arc_length_bound(line, t * sqrt(14), &bound));
            CHECK_NEAR(bound, 0, 1e-8); /* rounding of the derivative alone */
            batten_curve_unref(line);
        }
}

/* The largest distance of the quintic from the piece at equal arc length, among many. */
static double largest_distance(int d, const batten_curve *curve, double h)
{
    double ends[2] = {0, h}, values[2 * 3 * 3], worst = 0, s[40], u[40];
    batten_curve *quintic = NULL;
    for (int e = 0; e < 2; e++) {
        double c[9], v = 0, along = 0;
        CHECK_OK(batten_curve_evaluate(curve, e, 2, c));
        for (int k = 0; k < d; k++) {
            v += c[d + k] * c[d + k];
            along += c[d + k] * c[2 * d + k];
        }
        for (int k = 0; k < d; k++) {
            double *row = values + e * 3 * d + k;
            row[0] = c[k];
            row[d] = c[d + k] / sqrt(v);
            row[2 * d] = (c[2 * d + k] - along / v * c[d + k]) / v;
        }
    }
    CHECK_OK(batten_curve_from_hermite(d, 2, 3, ends, values, &quintic));
    for (int i = 0; i < 40; i++)
        s[i] = h * (i + 0.5) / 40;
    CHECK_OK(batten_curve_at_length(curve, 40, s, 1e-13 * h, u));
    for (int i = 0; i < 40; i++) {
        double p[3], q[3], sum = 0;
        CHECK_OK(batten_curve_evaluate(curve, u[i], 0, p));
        CHECK_OK(batten_curve_evaluate(quintic, s[i], 0, q));
        for (int k = 0; k < d; k++)
            sum += (p[k] - q[k]) * (p[k] - q[k]);
        worst = fmax(worst, sqrt(sum));
    }
    batten_curve_unref(quintic);
    return worst;
}

TEST(random_pieces_are_within_the_bound_which_is_close_on_short_ones)
{
    test_random random = test_random_begin("arc length bound");
    for (int n = test_cases(60); n > 0; n--) {
        const int d = test_random_int(&random, 2, 3), p = test_random_int(&random, 2, 5);
        const bool rational = test_random_int(&random, 0, 1);
        const double size = n % 3 ? 0.3 : 0.05; /* of the part by its parameter */
        double points[18], weights[6], h, bound = -1;
        for (int i = 0; i <= p; i++) {
            weights[i] = test_random_in(&random, 0.5, 2);
            for (int k = 0; k < d; k++)
                points[i * d + k] = (k ? 0 : i) + test_random_in(&random, -0.4, 0.4);
        }
        batten_curve *whole = bezier(d, p, points, rational ? weights : NULL), *cut = NULL;
        const double a = test_random_in(&random, 0, 1 - size);
        CHECK_OK(batten_curve_subrange(whole, a, a + size, &cut));
        double row[18], scale[6];
        memcpy(row, batten_curve_points(cut), (size_t)((p + 1) * d) * sizeof *row);
        if (rational)
            memcpy(scale, batten_curve_weights(cut), (size_t)(p + 1) * sizeof *scale);
        batten_curve *piece = bezier(d, p, row, rational ? scale : NULL);
        CHECK_OK(batten_curve_length(piece, 1e-13, NULL, &h));
        CHECK_OK(bat_arc_length_bound(piece, h, &bound));
        const double far = largest_distance(d, piece, h);
        CHECK(far <= bound + 1e-13);
        if (size < 0.1 && far > 1e-12)
            CHECK(bound <= 8 * far);
        batten_curve_unref(piece);
        batten_curve_unref(cut);
        batten_curve_unref(whole);
    }
}

TEST(a_piece_that_may_stand_still_has_no_bound)
{
    const double cusp[] = {0, 0, 1, 1, 0, 1, 1, 0}, slow[] = {0, 0, 0, 0, 1, 1, 2, 0};
    const double *const rows[] = {cusp, slow};
    for (int i = 0; i < 2; i++) {
        batten_curve *curve = bezier(2, 3, rows[i], NULL);
        double bound = 0;
        CHECK_OK(bat_arc_length_bound(curve, 2, &bound));
        CHECK(bound > 1e9); /* where rounding leaves a speed, hardly any */
        batten_curve_unref(curve);
    }
}
