/* The box around the edges of a body. */
#include "body/edge_box.h"

#include "body/by_hand.h"
#include "support/test.h"

#include <batten/standard.h>

static void check_low_high(batten_box box, const double low[3], const double high[3])
{
    CHECK_NEAR(box.low.x, low[0], 1e-12);
    CHECK_NEAR(box.low.y, low[1], 1e-12);
    CHECK_NEAR(box.low.z, low[2], 1e-12);
    CHECK_NEAR(box.high.x, high[0], 1e-12);
    CHECK_NEAR(box.high.y, high[1], 1e-12);
    CHECK_NEAR(box.high.z, high[2], 1e-12);
}

static batten_body *finish(hand *m)
{
    batten_body *body = NULL;
    m->builder.parts.tolerance = 1e-6;
    CHECK_OK(batten_body_create(&m->builder.parts, &body));
    bat_builder_end(&m->builder);
    return body;
}

TEST(a_face_with_loops_counts_by_its_edges_and_one_without_by_its_surface)
{
    hand m = hand_begin();
    batten_surface *ball = NULL;
    hand_arc(&m, 2, 1, 0, 360);
    hand_face(&m, hand_cylinder(2, 9), false); /* 9 high; its edge is at 1 */
    HAND_LOOP(&m, 1);
    batten_body *body = finish(&m);
    check_low_high(bat_body_edge_box(body), (const double[3]){-2, -2, 1},
                   (const double[3]){2, 2, 1});
    batten_body_unref(body);
    m = hand_begin();
    CHECK_OK(batten_surface_sphere(&hand_world, 3, &ball));
    hand_face(&m, ball, false);
    body = finish(&m);
    check_low_high(bat_body_edge_box(body), (const double[3]){-3, -3, -3},
                   (const double[3]){3, 3, 3});
    batten_body_unref(body);
}
