/* Sides that are kept, and what is inside them, against brute force. */
#include "mesh/faces/side_scene.h"

TEST(random_sides_are_kept_until_they_cross_or_touch_others)
{
    test_random random = test_random_begin("random sides");
    for (int round = 0; round < test_cases(60); round++) {
        scene *c = test_array(1, sizeof *c);
        /* Coarse grids have many points on lines and on circles. */
        const int side = round % 3 == 0 ? 6 : round % 3 == 1 ? 15 : UNIT;
        scene_point(c, 0, 0);
        scene_point(c, side, 0);
        scene_point(c, 0, side);
        for (int i = test_random_int(&random, 2, 40); i > 0; i--)
            scene_point(c, test_random_int(&random, 0, side),
                        test_random_int(&random, 0, side));
        scene_begin(c);
        const long long hull = scene_check(c);
        scene_check_delaunay(c);
        for (int i = 0; i < 60; i++) {
            const int a = test_random_int(&random, 0, c->triangles.vertex_count - 1);
            const int b = test_random_int(&random, 0, c->triangles.vertex_count - 1);
            if (a == b)
                continue;
            scene_keep(c, a, b);
            CHECK_INT(scene_check(c), hull);
        }
        CHECK_OK(bat_sides_settle(&c->triangles));
        CHECK_INT(scene_check(c), hull);
        scene_check_delaunay(c);
        bat_sides_end(&c->triangles);
        CHECK(!c->triangles.at && !c->triangles.triangles && c->triangles.count == 0);
    }
}

TEST(a_hole_is_out_and_an_island_in_it_is_in)
{
    test_random random = test_random_begin("rings");
    for (int round = 0; round < test_cases(20); round++) {
        scene *c = scene_rings(&random, 20);
        scene_check(c);
        scene_check_delaunay(c);
        CHECK(scene_check_inside(c) > 0);
        bat_sides_end(&c->triangles);
    }
}

TEST(a_side_that_is_kept_twice_does_not_part_in_and_out)
{
    scene *c = test_array(1, sizeof *c);
    scene_point(c, 0, 0);
    scene_point(c, 8, 0);
    scene_point(c, 8, 8);
    scene_point(c, 0, 8);
    scene_begin(c);
    scene_keep_star(c, 0, 4);
    for (int i = 0; i < 2; i++)
        scene_keep(c, c->vertex_of[0], c->vertex_of[2]);
    CHECK_OK(bat_sides_settle(&c->triangles));
    scene_check(c);
    CHECK_INT(c->triangles.count, 2);
    CHECK(c->triangles.triangles[0].inside && c->triangles.triangles[1].inside);
    bat_sides_end(&c->triangles);
}

TEST(points_that_are_equal_are_one_vertex)
{
    scene *c = test_array(1, sizeof *c);
    for (int i = 0; i < 2; i++) {
        scene_point(c, 0, 0);
        scene_point(c, 8, 0);
        scene_point(c, 0, 8);
    }
    scene_begin(c);
    CHECK_INT(c->triangles.vertex_count, 3);
    CHECK_INT(c->triangles.count, 1);
    for (int i = 0; i < 3; i++)
        CHECK_INT(c->vertex_of[i], c->vertex_of[i + 3]);
    bat_sides_end(&c->triangles);
    c->count = 2;
    CHECK_STATUS(bat_sides_begin(&c->triangles, 2, (const double(*)[2])c->at, c->vertex_of),
                 BATTEN_TOO_FEW_POINTS);
    CHECK(!c->triangles.at && !c->triangles.triangles);
}
