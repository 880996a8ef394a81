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

/* P = (2 t - t^2) d slows down to a stop at t = 1, P = t^2 d starts from one: the tangent is d both times. */
TEST(where_a_chain_stands_still_its_tangent_is_that_of_the_second_derivative)
{
    const double d[2] = {0.6, -0.8};
    for (int stops = 0; stops < 2; stops++) {
        const double bend = stops ? -2 : 2;
        const batten_span span = {
            .kind = BATTEN_SPAN_TENSION,
            .length = 1,
            .end = {d[0], d[1]},
            .bend = {{bend * d[0], bend * d[1]}, {bend * d[0], bend * d[1]}}};
        batten_chain *chain = NULL;
        batten_curve_local at = {.speed = 7, .curvature = 7};
        CHECK_OK(
            batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
        CHECK_STATUS(batten_chain_local_at(chain, stops,
                                           stops ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &at),
                     BATTEN_SINGULAR_HERE);
        CHECK_MESSAGE("the first derivative vanishes");
        CHECK_NEAR(at.tangent.x, d[0], 1e-14);
        CHECK_NEAR(at.tangent.y, d[1], 1e-14);
        CHECK_NEAR(at.point.x, stops ? d[0] : 0, 1e-15);
        CHECK(at.speed == 0 && at.curvature == 0);
        CHECK_OK(batten_chain_local_at(chain, 0.5, BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.speed, 1, 1e-14);
        CHECK_NEAR(at.tangent.x, d[0], 1e-14);
        batten_chain_unref(chain);
    }
}
