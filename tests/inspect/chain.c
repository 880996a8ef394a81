#include <batten/curvature.h>
#include <batten/measure.h>

#include "inspect/local.h"
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

static void check_bend(int d, const batten_span *span, double t, bat_bend due)
{
    bat_bend bend = {-7, -7, -7};
    bat_span_bend(d, span, t, &bend);
    CHECK_NEAR(bend.speed, due.speed, 1e-14);
    CHECK_NEAR(bend.curvature, due.curvature, 1e-14);
    CHECK_NEAR(bend.rate, due.rate, 1e-13);
}

/* The parabola (t, t^2 / 2), t^3 / 6 as a function, a curvature of degree 3, and a stop. */
TEST(the_bend_of_a_span_is_that_of_its_formula)
{
    const batten_span parabola = {.kind = BATTEN_SPAN_TENSION,
                                  .length = 1,
                                  .end = {1, 0.5},
                                  .bend = {{0, 1}, {0, 1}}},
                      cube = {.kind = BATTEN_SPAN_TENSION,
                              .length = 1,
                              .end = {1.0 / 6},
                              .bend = {{0}, {1}}},
                      stop = {.kind = BATTEN_SPAN_TENSION,
                              .length = 1,
                              .end = {1, 2},
                              .bend = {{-2, -4}, {-2, -4}}},
                      spiral = {.kind = BATTEN_SPAN_SPIRAL,
                                .length = 1,
                                .curvature = {0.1, 0.3, 0.5, 0.7}},
                      arc = {.kind = BATTEN_SPAN_ARC, .length = 1, .curvature = {-0.25}};
    for (int i = 0; i <= 8; i++) {
        const double t = i / 8.0, s = 1 + t * t;
        check_bend(2, &parabola, t, (bat_bend){sqrt(s), pow(s, -1.5), -3 * t * pow(s, -3)});
        check_bend(3, &parabola, t, (bat_bend){sqrt(s), pow(s, -1.5), -3 * t * pow(s, -3)});
        check_bend(1, &cube, t, (bat_bend){1, t, 1});
        check_bend(2, &arc, t, (bat_bend){1, -0.25, 0});
        check_bend(2, &spiral, t,
                   (bat_bend){1, 0.1 + 0.3 * t + 0.25 * t * t + 0.7 / 6 * t * t * t,
                              0.3 + 0.5 * t + 0.35 * t * t});
        if (i < 8)
            check_bend(2, &stop, t, (bat_bend){2 * (1 - t) * sqrt(5), 0, 0});
    }
    check_bend(2, &stop, 1, (bat_bend){0, 0, 0});
}
