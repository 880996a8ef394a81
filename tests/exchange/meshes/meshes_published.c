/* Meshes and clouds of other programs, with the counts that were published of them. */
#include "exchange/meshes/meshes.h"

typedef struct {
    const char *name;
    int vertices, triangles; /* vertices: of all objects together */
    double area, volume;     /* 0: not to be compared */
    bool is_closed;
} published;

static batten_model *read_published(const char *folder, const char *name)
{
    char path[200];
    batten_model *model = NULL;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    CHECK_OK(batten_read_file(test_data(path), NULL, NULL, NULL, &model));
    return model;
}

static void check_published(const published *row)
{
    batten_model *model = read_published("meshes", row->name);
    batten_mesh_facts sum = {0};
    int vertices = 0, triangles = 0;
    for (int i = 0; i < batten_model_count(model); i++) {
        batten_mesh_facts facts;
        const batten_object *object = batten_model_object(model, i);
        if (object->kind != BATTEN_OBJECT_MESH)
            continue;
        CHECK_OK(batten_mesh_check(object->mesh, &facts));
        vertices += batten_mesh_view(object->mesh)->vertex_count;
        triangles += batten_mesh_view(object->mesh)->triangle_count;
        sum.area += facts.area;
        sum.volume += facts.volume;
        sum.rim_edges += facts.rim_edges;
        sum.crowded_edges += facts.crowded_edges;
    }
    if (triangles != row->triangles || vertices != row->vertices)
        printf("%s: %d vertices, %d triangles\n", row->name, vertices, triangles);
    CHECK_INT(triangles, row->triangles);
    CHECK_INT(vertices, row->vertices);
    CHECK_NEAR(sum.area, row->area, 1e-5 * row->area);
    if (row->is_closed) {
        CHECK_INT(sum.rim_edges, 0);
        CHECK_INT(sum.crowded_edges, 0);
        CHECK_NEAR(sum.volume, row->volume, 1e-5 * fabs(row->volume));
    }
    batten_model_unref(model);
}

static void check_all(int count, const published *rows)
{
    for (int i = 0; i < count; i++)
        check_published(&rows[i]);
}

TEST(published_stl_files_have_their_counts)
{
    static const published rows[] = {
        {"bad-stl-pcbvicebar.stl", 132, 260, 5899.08, 11700.6, true},
        {"gmsh_t13.stl", 788, 1580, 48896.4, 67815.8, true},
        {"netgen_part1.stl", 190, 380, 122.957, 76.3675, true},
        /* 1722 vertices and closed to those who take points nearly the same for one. */
        {"trimesh_featuretype.STL", 2010, 3476, 53.8274, 0, false},
        {"trimesh_unit_cube.STL", 8, 12, 6, 1, true},
        {"trimesh_unit_sphere.STL", 642, 1280, 12.5065, 4.15274, true},
        {"viewer_cube_meshlab_ascii.stl", 8, 12, 6, 1, true},
        {"viewer_cube_meshlab_binary.stl", 8, 12, 6, 1, true},
        {"viewer_single_triangle.stl", 3, 1, 0.5, 0, false},
        {"viewer_single_triangle_no_normal.stl", 3, 1, 0.5, 0, false},
        {"viewer_stl_ascii.stl", 304, 572, 29.4242, 4.9147, true},
        {"viewer_two_triangles.stl", 6, 2, 1, 0, false},
    };
    check_all(COUNT(rows), rows);
}

/* Six solids, which are six objects: vertices between them are in both. */
TEST(a_published_car_of_six_solids_is_six_meshes)
{
    batten_model *model = read_published("meshes", "simple_car.stl");
    int triangles = 0;
    for (int i = 0; i < batten_model_count(model); i++)
        triangles += mesh_at(model, i)->triangle_count;
    CHECK_INT(batten_model_count(model), 6);
    CHECK_INT(triangles, 3154);
    CHECK_TEXT(batten_model_object(model, 0)->name, "body_bottom");
    batten_model_unref(model);
}

TEST(published_ply_files_have_their_counts)
{
    static const published rows[] = {
        {"viewer_cube.ply", 8, 12, 6, 1, true},
        {"viewer_cube_meshlab_ascii.ply", 8, 12, 6, 1, true},
        {"viewer_cube_meshlab_binary.ply", 8, 12, 6, 1, true},
        {"viewer_single_rectangle.ply", 4, 2, 1, 0, false},
        {"viewer_single_triangle.ply", 3, 1, 0.5, 0, false},
    };
    check_all(COUNT(rows), rows);
}

/* A published file counts vertices that several objects share once. */
TEST(published_obj_files_have_their_counts)
{
    static const published rows[] = {
        {"trimesh_fandisk.obj", 2877, 5750, 6.2977, 0.679353, true},
        {"viewer_cube with white spaces.obj", 8, 12, 6, 1, true},
        {"viewer_cube_rgb.obj", 8, 12, 6, 1, true},
        {"viewer_cube_with_edges.obj", 8, 12, 6, 1, true},
        {"viewer_cube_with_materials.obj", 8, 12, 6, 1, true},
        {"viewer_cube_with_materials_comments.obj", 8, 12, 6, 1, true},
        {"viewer_empty_meshes.obj", 6, 2, 1, 0, false},
        {"viewer_hundred_cubes.obj", 800, 1200, 600, 100, true},
        {"viewer_icosahedron.obj", 12, 20, 9.57454, 2.53615, true},
        {"viewer_lines.obj", 0, 0, 0, 0, false},
        {"viewer_lines_colors.obj", 0, 0, 0, 0, false},
        {"viewer_lines_in_meshes.obj", 0, 0, 0, 0, false},
        {"viewer_lines_in_meshes_2.obj", 0, 0, 0, 0, false},
        {"viewer_lines_triangles_colors.obj", 12, 6, 3, 0, false},
        {"viewer_lines_with_vt.obj", 0, 0, 0, 0, false},
    };
    check_all(COUNT(rows), rows);
}

TEST(published_off_files_have_their_counts)
{
    static const published rows[] = {
        {"viewer_cube.off", 8, 12, 6, 1, true},
        {"viewer_rectangle_face_colors_int.off", 4, 2, 1, 0, false},
        {"viewer_rectangle_vertex_colors_float.off", 4, 2, 1, 0, false},
        {"viewer_rectangle_vertex_colors_int.off", 4, 2, 1, 0, false},
        {"viewer_single_rectangle.off", 4, 2, 1, 0, false},
        {"viewer_single_triangle.off", 3, 1, 0.5, 0, false},
        {"viewer_two_triangles.off", 6, 2, 1, 0, false},
    };
    check_all(COUNT(rows), rows);
}

TEST(published_clouds_have_their_counts)
{
    static const struct {
        const char *name;
        int points;
    } rows[] = {{"pcl_cat.pcd", 3400},
                {"pcl_lidar_samp21.pcd", 12960},
                {"pcl_lidar_samp21_ground.pcd", 10085},
                {"pcl_object_template_1.pcd", 1552}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_model *model = read_published("pointclouds", rows[i].name);
        CHECK_INT(batten_model_count(model), 1);
        CHECK_INT(batten_model_object(model, 0)->point_count, rows[i].points);
        batten_model_unref(model);
    }
}
