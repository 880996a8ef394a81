/* How far edges and faces reach. */
#include "body/measure/extent.h"

#include "body/by_hand.h"
#include "numeric/box.h"
#include "support/test.h"

#include <batten/standard.h>

/* The part of a ball of radius 5 above z = 4, or below. */
static batten_body *cap(bool below)
{
    hand m = hand_begin();
    batten_surface *ball = NULL;
    batten_body *body = NULL, *traced = NULL;
    CHECK_OK(batten_surface_sphere(&hand_world, 5, &ball));
    hand_arc(&m, 3, 4, 0, 360);
    hand_face(&m, ball, false);
    HAND_LOOP(&m, below ? -1 : 1);
    m.builder.parts.tolerance = 1e-6;
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, NULL, &traced));
    batten_body_unref(body);
    return traced;
}

static void check_box(batten_box box, const double low[3], const double high[3], double error)
{
    CHECK_NEAR(box.low.x, low[0], error);
    CHECK_NEAR(box.low.y, low[1], error);
    CHECK_NEAR(box.low.z, low[2], error);
    CHECK_NEAR(box.high.x, high[0], error);
    CHECK_NEAR(box.high.y, high[1], error);
    CHECK_NEAR(box.high.z, high[2], error);
}

TEST(edges_reach_as_far_as_their_curves_and_faces_to_their_own_extremes)
{
    static const double low[2][3] = {{-3, -3, 4}, {-5, -5, -5}};
    static const double high[2][3] = {{3, 3, 5}, {5, 5, 4}};
    for (int below = 0; below < 2; below++) {
        batten_body *body = cap(below);
        const batten_body_parts *parts = batten_body_view(body);
        bat_extent extent = {bat_box_of_nothing(), bat_box_of_nothing()};
        CHECK_OK(bat_edges_extent(parts, &extent)); /* also the seam, up to the pole */
        CHECK(extent.reached.low.z <= 4 && extent.reached.high.z >= 4);
        CHECK_NEAR(bat_extent_slack(&extent), 0, 1e-9);
        for (int f = 0; f < parts->face_count; f++)
            CHECK_OK(bat_face_extent(parts, f, 1e-6, &extent));
        check_box(extent.reached, low[below], high[below], 1e-5);
        check_box(extent.within, low[below], high[below], 1e-5);
        batten_body_unref(body);
    }
}
