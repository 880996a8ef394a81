/* Faces whose loops cross themselves or each other bound no area. */
#include "body/by_hand.h"
#include "support/test.h"

/* A plate within straight lines from corner to corner, of any size. */
static batten_body *plate_within(int count, const double corners[][2], double size)
{
    hand m = hand_begin();
    int edges[8];
    batten_body *body = NULL;
    for (int i = 0; i < count; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % count];
        edges[i] = 1 + hand_line(&m, size * a[0], size * a[1], 0, size * b[0], size * b[1], 0);
    }
    hand_plate(&m, -size, -size, 5 * size, 5 * size, 0);
    hand_loop(&m, count, edges);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    return body;
}

TEST(the_area_in_a_loop_that_crosses_itself_is_not_met)
{
    /* Two triangles of 16/3 and 4/3, one around each way. */
    static const double corners[][2] = {{0, 0}, {4, 4}, {4, 0}, {0, 2}};
    for (double size = 0.01; size < 200; size *= 100) {
        batten_body *body = plate_within(4, corners, size);
        batten_body_measures m;
        CHECK_STATUS(batten_body_measure(body, 1e-8, NULL, &m), BATTEN_TOLERANCE_NOT_MET);
        CHECK_MESSAGE("1 of 1 faces have loops that cross, face 1 first");
        CHECK(fabs(m.area - 20.0 / 3 * size * size) <= m.area_error);
        CHECK(m.area_error < 36 * size * size);
        batten_body_unref(body);
    }
}

TEST(a_hole_that_crosses_the_outer_loop_leaves_the_area_open)
{
    hand m = hand_begin();
    batten_body *body = NULL;
    batten_body_measures measures;
    hand_line(&m, 0, 0, 0, 2, 0, 0);
    hand_line(&m, 2, 0, 0, 2, 2, 0);
    hand_line(&m, 2, 2, 0, 0, 2, 0);
    hand_line(&m, 0, 2, 0, 0, 0, 0);
    hand_arc(&m, 0.75, 0, 30, 360);
    hand_plate(&m, -1, -1, 5, 5, 0);
    HAND_LOOP(&m, 1, 2, 3, 4);
    HAND_LOOP(&m, -5);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_STATUS(batten_body_measure(body, 1e-8, NULL, &measures), BATTEN_TOLERANCE_NOT_MET);
    CHECK(fabs(measures.area - (4 - 0.5625 * acos(-1) / 4)) <= measures.area_error);
    batten_body_unref(body);
}

/* As where edges of a file overshoot their corner. */
TEST(a_small_crossing_is_a_part_of_the_error)
{
    static const double corners[][2] = {
        {0, 0}, {1, 0}, {1, 1}, {-1e-5, 1}, {-1e-5, 1 + 1e-5}, {0, 1 + 1e-5}};
    for (double size = 1; size < 2000; size *= 1000) {
        batten_body *body = plate_within(6, corners, size);
        batten_body_measures m;
        CHECK_OK(batten_body_measure(body, 1e-8, NULL, &m));
        CHECK(fabs(m.area / size / size - 1) <= m.area_error / size / size);
        CHECK(m.area_error / size / size >= 1e-10 && m.area_error / size / size < 1e-7);
        batten_body_unref(body);
    }
}
