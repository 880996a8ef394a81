/* Curvatures brought together at the joins of corrected curves. */
#include "support/test.h"
#include <batten/curvature.h>
#include <batten/local.h>

enum { COUNT_OF_RING = 11 };

/* The closed spline through the points from `first` on, corrected. */
static batten_curve *corrected_ring(const double points[2 * COUNT_OF_RING], int first,
                                    batten_curve_correct_tangents_report *report)
{
    double turned[2 * COUNT_OF_RING];
    for (int i = 0; i < 2 * COUNT_OF_RING; i++)
        turned[i] = points[(i + 2 * first) % (2 * COUNT_OF_RING)];
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    batten_curve_correct_tangents_options c = batten_curve_correct_tangents_defaults();
    batten_curve *curve = NULL, *made = NULL;
    o.parameters = BATTEN_UNIFORM;
    o.closed = true;
    c.joins = BATTEN_CORRECT_CURVATURE;
    CHECK_OK(
        batten_curve_interpolate((batten_points){2, COUNT_OF_RING, turned}, &o, NULL, &curve));
    CHECK_OK(batten_curve_correct_tangents(curve, &c, NULL, report, &made));
    batten_curve_unref(curve);
    return made;
}

TEST(a_closed_curve_is_corrected_alike_wherever_it_begins)
{
    test_random random = test_random_begin("rings");
    int rejoined = 0;
    for (int n = test_cases(12); n > 0; n--) {
        double points[2 * COUNT_OF_RING];
        for (int i = 0; i < COUNT_OF_RING; i++) {
            const double a =
                6.283185307179586 * (i + test_random_in(&random, -0.42, 0.42)) / COUNT_OF_RING;
            const double r = test_random_in(&random, 0.85, 1.15);
            points[2 * i] = r * cos(a);
            points[2 * i + 1] = r * sin(a);
        }
        batten_curve_correct_tangents_report report, other;
        batten_curve *whole = corrected_ring(points, 0, &report);
        rejoined += report.rejoined;
        for (int first = 1; first < COUNT_OF_RING; first += 3) {
            batten_curve *turned = corrected_ring(points, first, &other);
            CHECK_INT(other.corrected, report.corrected);
            CHECK_INT(other.incurable, report.incurable);
            CHECK_INT(other.rejoined, report.rejoined);
            CHECK_INT(other.broken, report.broken);
            for (int i = 0; i < 8 * COUNT_OF_RING; i++) {
                double p[2], q[2];
                const double at = (i + 0.5) / 8, there = fmod(at + first, COUNT_OF_RING);
                CHECK_OK(batten_curve_evaluate(turned, at, 0, q));
                CHECK_OK(batten_curve_evaluate(whole, there, 0, p));
                CHECK_NEAR(hypot(p[0] - q[0], p[1] - q[1]), 0, 1e-9);
            }
            batten_curve_unref(turned);
        }
        batten_curve_unref(whole);
    }
    CHECK(rejoined > 0);
}
