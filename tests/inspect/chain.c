#include <batten/curvature.h>
#include <batten/measure.h>

#include "support/test.h"

TEST(an_arc_of_a_chain_has_its_curvature_tangent_and_length)
{
    const batten_span span = {.kind = BATTEN_SPAN_ARC,
                              .length = 2,
                              .start = {3, 0},
                              .angle = 1,
                              .curvature = {-0.25}};
    batten_chain *chain = NULL;
    batten_curve_local at;
    double length = 0;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
    CHECK_OK(batten_chain_local_at(chain, 1, BATTEN_FROM_RIGHT, &at));
    CHECK_NEAR(at.curvature, -0.25, 1e-15);
    CHECK_NEAR(at.curvature_rate, 0, 1e-15);
    CHECK_NEAR(at.tangent.x, cos(0.75), 1e-15);
    CHECK_NEAR(at.speed, 1, 1e-15);
    CHECK_OK(batten_chain_length(chain, NULL, &length));
    CHECK_NEAR(length, 2, 1e-15);
    CHECK_STATUS(batten_chain_local_at(chain, 3, BATTEN_FROM_RIGHT, &at), BATTEN_OUT_OF_DOMAIN);
    batten_chain_unref(chain);
}

TEST(a_clothoid_has_the_rate_of_its_curvature_in_the_plane_and_in_space)
{
    const batten_span span = {.kind = BATTEN_SPAN_SPIRAL, .length = 2, .curvature = {0.1, 0.3}};
    const batten_frame frame = {{0, 0, 5}, {0, 1, 0}, {1, 0, 0}};
    batten_chain *chain = NULL, *placed = NULL;
    batten_curve_local at;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
    CHECK_OK(batten_chain_place(chain, &frame, &placed));
    for (int i = 0; i <= 8; i++) {
        const double s = i / 4.0;
        CHECK_OK(batten_chain_local_at(chain, s, BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.curvature, 0.1 + 0.3 * s, 1e-14);
        CHECK_NEAR(at.curvature_rate, 0.3, 1e-13);
        CHECK_OK(batten_chain_local_at(placed, s, BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.curvature, 0.1 + 0.3 * s, 1e-14);
        CHECK_NEAR(at.torsion, 0, 1e-13);
    }
    batten_chain_unref(placed);
    batten_chain_unref(chain);
}
