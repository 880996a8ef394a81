#include <batten/bent.h>

#include "support/test.h"

/* Rounding of the directions alone makes jumps of curvature when spans are short and the points
 * uneven: no step of Newton takes these away, and the spline is none the worse. */
TEST(short_uneven_spans_do_not_keep_the_driver_from_its_end)
{
    static const batten_span_family families[] = {
        BATTEN_FAMILY_LOCAL_CUBIC, BATTEN_FAMILY_EULER_SPIRAL, BATTEN_FAMILY_ELASTICA};
    enum { POINTS = 20000 };
    double *points = test_array(2 * POINTS, sizeof *points);
    test_random random = test_random_begin("uneven");
    for (int i = 0; i < POINTS; i++) {
        const double a = 6 * (i + 0.3 * test_random_in(&random, -1, 1)) / POINTS;
        points[2 * i] = 10 * cos(a) + 0.2 * sin(9 * a);
        points[2 * i + 1] = 10 * sin(a);
    }
    for (int k = 0; k < COUNT(families); k++) {
        batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
        batten_chain_nonlinear_report report;
        batten_chain *chain = NULL;
        options.family = families[k];
        CHECK_OK(batten_chain_nonlinear((batten_points){2, POINTS, points}, &options, NULL,
                                        NULL, &report, &chain));
        CHECK(report.error <= 1e-10 * report.curvature);
        batten_chain_unref(chain);
    }
}
