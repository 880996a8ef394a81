#include "support/test.h"

#include <batten/mesh.h>

static const double cube_points[8][3] = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0},
                                         {0, 0, 4}, {2, 0, 4}, {2, 3, 4}, {0, 3, 4}};
static const int cube_corners[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7},
                                        {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                                        {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

static batten_mesh *make(int vertices, const double *points, int triangles, const int *corners)
{
    batten_mesh *mesh = NULL;
    const batten_mesh_parts parts = {.vertex_count = vertices,
                                     .points = points,
                                     .triangle_count = triangles,
                                     .corners = corners};
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    return mesh;
}

static batten_mesh_facts facts_of(batten_mesh *mesh)
{
    batten_mesh_facts facts;
    CHECK_OK(batten_mesh_check(mesh, &facts));
    batten_mesh_unref(mesh);
    return facts;
}

TEST(a_box_is_closed_and_measured)
{
    const batten_mesh_facts f = facts_of(make(8, cube_points[0], 12, cube_corners[0]));
    CHECK(f.is_watertight);
    CHECK_INT(f.edges, 18);
    CHECK_INT(f.euler, 2);
    CHECK_INT(f.pieces, 1);
    CHECK_INT(f.flat_triangles + f.loose_vertices, 0);
    CHECK_NEAR(f.area, 52, 1e-13);
    CHECK_NEAR(f.volume, 24, 1e-13);
    CHECK_NEAR(f.centroid[0], 1, 1e-14);
    CHECK_NEAR(f.centroid[1], 1.5, 1e-14);
    CHECK_NEAR(f.centroid[2], 2, 1e-14);
}

TEST(a_box_of_any_size_and_place_is_measured)
{
    const double scales[] = {1e80, 1e-80, 1e-3};
    for (int i = 0; i < COUNT(scales); i++) {
        double points[8][3];
        for (int k = 0; k < 24; k++)
            points[k / 3][k % 3] = scales[i] * (cube_points[k / 3][k % 3] + 5);
        const batten_mesh_facts f = facts_of(make(8, points[0], 12, cube_corners[0]));
        CHECK_NEAR(f.volume / scales[i] / scales[i] / scales[i], 24, 1e-12);
        CHECK_NEAR(f.centroid[1] / scales[i], 6.5, 1e-13);
        CHECK_INT(f.flat_triangles, 0);
    }
}

TEST(an_area_beyond_all_numbers_is_told)
{
    double points[8][3];
    for (int k = 0; k < 24; k++)
        points[k / 3][k % 3] = 1e200 * cube_points[k / 3][k % 3];
    batten_mesh *mesh = make(8, points[0], 12, cube_corners[0]);
    batten_mesh_facts facts;
    CHECK_STATUS(batten_mesh_check(mesh, &facts), BATTEN_OVERFLOW);
    CHECK_MESSAGE("the area or volume of a mesh of size 1.");
    batten_mesh_unref(mesh);
}

TEST(rims_turned_and_crowded_edges_are_counted)
{
    int corners[13][3];
    memcpy(corners, cube_corners, sizeof cube_corners);
    batten_mesh_facts f = facts_of(make(8, cube_points[0], 10, corners[0]));
    CHECK_INT(f.rim_edges, 4);
    CHECK(!f.is_watertight);
    CHECK_INT(f.euler, 1);
    CHECK_NEAR(f.volume, 0, 0);
    corners[0][1] = 1, corners[0][2] = 2; /* the first triangle turned */
    f = facts_of(make(8, cube_points[0], 12, corners[0]));
    CHECK_INT(f.wrong_edges, 3);
    CHECK_INT(f.rim_edges, 0);
    memcpy(corners, cube_corners, sizeof cube_corners);
    corners[12][0] = 0, corners[12][1] = 1, corners[12][2] = 6; /* a fin on edge 0 - 1 */
    f = facts_of(make(8, cube_points[0], 13, corners[0]));
    CHECK_INT(f.crowded_edges, 2); /* 0 - 1 and 1 - 6 */
    CHECK_INT(f.rim_edges, 1);
}

TEST(flat_triangles_and_loose_vertices_are_counted)
{
    const double points[6][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                 {9, 9, 9}, {2, 0, 0}, {0.1, 0.1, 0.3}};
    const int corners[4][3] = {{0, 1, 2}, {0, 1, 1}, {0, 1, 4}, {0, 1, 5}};
    const batten_mesh_facts f = facts_of(make(6, points[0], 4, corners[0]));
    CHECK_INT(f.flat_triangles, 2);
    CHECK_INT(f.loose_vertices, 1);
    CHECK_INT(f.crowded_edges, 1);
}

TEST(pieces_are_connected_by_edges)
{
    /* Two boxes that share a vertex. */
    double points[15][3];
    int corners[24][3];
    for (int i = 0; i < 15; i++)
        for (int k = 0; k < 3; k++)
            points[i][k] = i < 8 ? cube_points[i][k] : -cube_points[i - 7][k];
    for (int i = 0; i < 12; i++)
        for (int k = 0; k < 3; k++) {
            const int v = cube_corners[i][k], turned = cube_corners[i][(3 - k) % 3];
            corners[i][k] = v;
            corners[12 + i][k] = turned ? turned + 7 : 0;
        }
    const batten_mesh_facts f = facts_of(make(15, points[0], 24, corners[0]));
    CHECK_INT(f.pieces, 2);
    CHECK(f.is_watertight);
    CHECK_NEAR(f.volume, 48, 1e-12);
    CHECK_NEAR(f.centroid[2], 0, 1e-13);
}

TEST(an_empty_mesh_has_nothing)
{
    const batten_mesh_facts f = facts_of(make(0, cube_points[0], 0, cube_corners[0]));
    CHECK_INT(f.edges + f.pieces + f.euler, 0);
    CHECK(!f.is_watertight);
}

TEST(welding_makes_a_soup_of_triangles_one_piece)
{
    double points[36][3];
    int corners[12][3];
    for (int i = 0; i < 36; i++) {
        corners[i / 3][i % 3] = i;
        for (int k = 0; k < 3; k++) /* 0 and -0 are one place */
            points[i][k] = (i % 2 ? -1 : 1) * 0.0 + cube_points[cube_corners[i / 3][i % 3]][k];
    }
    batten_mesh *soup = make(36, points[0], 12, corners[0]), *welded = NULL;
    CHECK_OK(batten_mesh_weld(soup, &welded));
    CHECK_INT(batten_mesh_view(welded)->vertex_count, 8);
    CHECK(facts_of(welded).is_watertight);
    CHECK_INT(facts_of(soup).rim_edges, 36);
}

TEST(welding_keeps_colours_and_attributes_of_the_first)
{
    const double points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}};
    const double colours[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    const double heights[4] = {1, 2, 3, 4};
    const int corners[2][3] = {{0, 1, 3}, {2, 1, 3}};
    const batten_mesh_attribute attribute = {"height", heights};
    const batten_mesh_parts parts = {.vertex_count = 4,
                                     .points = points[0],
                                     .colours = colours[0],
                                     .triangle_count = 2,
                                     .corners = corners[0],
                                     .attribute_count = 1,
                                     .attributes = &attribute};
    batten_mesh *mesh = NULL, *welded = NULL;
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_mesh_weld(mesh, &welded));
    const batten_mesh_parts *made = batten_mesh_view(welded);
    CHECK_INT(made->vertex_count, 3);
    CHECK_INT(made->corners[3], 0);
    CHECK_NEAR(made->colours[0], 1, 0);
    CHECK_NEAR(made->attributes[0].values[2], 4, 0);
    CHECK_TEXT(made->attributes[0].name, "height");
    batten_mesh_unref(mesh);
    batten_mesh_unref(welded);
}

/* Of a size of 4 at 2^40: sums about the middle of the box are exact, those about the origin are not. */
TEST(a_box_far_from_the_origin_is_measured_exactly)
{
    const double far = 1099511627776.;
    double points[8][3];
    for (int k = 0; k < 24; k++)
        points[k / 3][k % 3] = cube_points[k / 3][k % 3] + (k % 3 + 1) * far;
    const batten_mesh_facts f = facts_of(make(8, points[0], 12, cube_corners[0]));
    CHECK_NEAR(f.volume, 24, 0);
    CHECK_NEAR(f.area, 52, 0);
    CHECK_NEAR(f.centroid[0] - far, 1, 0);
    CHECK_NEAR(f.centroid[1] - 2 * far, 1.5, 0);
    CHECK_NEAR(f.centroid[2] - 3 * far, 2, 0);
    CHECK_INT(f.flat_triangles, 0);
}

TEST(an_open_mesh_has_the_centroid_of_its_area)
{
    /* 1 by 1 at z = 0 and 2 by 1 upright at its end x = 1 */
    const double points[6][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                 {0, 1, 0}, {1, 0, 2}, {1, 1, 2}};
    const int corners[4][3] = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    const batten_mesh_facts f = facts_of(make(6, points[0], 4, corners[0]));
    CHECK_NEAR(f.area, 3, 1e-15);
    CHECK_NEAR(f.volume, 0, 0);
    CHECK_NEAR(f.centroid[0], (0.5 + 2 * 1) / 3, 1e-15);
    CHECK_NEAR(f.centroid[1], 0.5, 1e-15);
    CHECK_NEAR(f.centroid[2], 2. / 3, 1e-15);
    CHECK_INT(f.pieces, 1);
    CHECK_INT(f.edges, 9);
    CHECK_INT(f.rim_edges, 6);
    CHECK_INT(f.euler, 1);
}

TEST(triangles_of_fewer_than_three_vertices_have_no_edges_and_are_no_pieces)
{
    const double points[5][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {6, 6, 6}};
    const int corners[5][3] = {{3, 3, 4}, {4, 3, 3}, {3, 4, 3}, {0, 1, 2}, {4, 4, 4}};
    const batten_mesh_facts f = facts_of(make(5, points[0], 5, corners[0]));
    CHECK_INT(f.edges, 3);
    CHECK_INT(f.rim_edges, 3);
    CHECK_INT(f.flat_triangles, 4);
    CHECK_INT(f.loose_vertices, 0);
    CHECK_INT(f.pieces, 1);
    CHECK_INT(f.euler, 1);
    CHECK_NEAR(f.area, 0.5, 1e-15);
}

TEST(a_mesh_of_one_point_has_its_centroid_there)
{
    const double points[3] = {1, 2, 3};
    const int corners[3] = {0, 0, 0};
    const batten_mesh_facts f = facts_of(make(1, points, 1, corners));
    CHECK_NEAR(f.centroid[0], 1, 0);
    CHECK_NEAR(f.centroid[1], 2, 0);
    CHECK_NEAR(f.centroid[2], 3, 0);
    CHECK_NEAR(f.area + f.volume, 0, 0);
    CHECK_INT(f.flat_triangles, 1);
}
