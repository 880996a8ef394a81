/* Which vertices and corners each object of a file has. */
#include "exchange/meshes/meshes.h"
#include "exchange/shapes/paths.h"

#define VERTICES "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\n"

/* Of a group only the vertices that its faces use, in the order of the file. */
TEST(each_group_has_its_own_vertices_and_corners_that_count_among_them)
{
    batten_model *model = NULL;
    CHECK_OK(read_text(VERTICES "g a\nf 3 2 1\nf 1 4 3\ng b\nf 7 6 2\nf 2 5 7\nf 6 7 5\n",
                       BATTEN_FORMAT_OBJ, NULL, &model));
    static const int first[] = {2, 1, 0, 0, 3, 2}, second[] = {3, 2, 0, 0, 1, 3, 2, 3, 1};
    static const double places[] = {1, 0, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1};
    CHECK_INT(batten_model_count(model), 2);
    const batten_mesh_parts *a = mesh_at(model, 0), *b = mesh_at(model, 1);
    CHECK_INT(a->vertex_count, 4);
    CHECK_INT(a->triangle_count, 2);
    CHECK_INT(b->vertex_count, 4);
    CHECK_INT(b->triangle_count, 3);
    for (int i = 0; i < COUNT(first); i++)
        CHECK_INT(a->corners[i], first[i]);
    for (int i = 0; i < COUNT(second); i++)
        CHECK_INT(b->corners[i], second[i]);
    for (int i = 0; i < COUNT(places); i++)
        CHECK_BITS(b->points[i], places[i]);
    batten_model_unref(model);
}

TEST(a_polygon_is_as_many_triangles_as_it_has_corners_but_two)
{
    batten_model *model = NULL;
    CHECK_OK(
        read_text(VERTICES "f 1 2 3 4\nf 5 6 7\nf 2 6 7 3\n", BATTEN_FORMAT_OBJ, NULL, &model));
    const batten_mesh_parts *p = mesh_at(model, 0);
    bool is_used[7] = {false};
    CHECK_INT(p->triangle_count, 5);
    CHECK_INT(p->vertex_count, 7);
    for (int i = 0; i < 15; i++)
        is_used[p->corners[i]] = true;
    for (int i = 0; i < 7; i++)
        CHECK(is_used[i]);
    batten_model_unref(model);
}

TEST(points_of_one_group_are_not_those_of_the_next)
{
    batten_model *model = NULL;
    CHECK_OK(read_text(VERTICES "g a\np 1\ng b\np 2 3\np 7\ng c\np 4\n", BATTEN_FORMAT_OBJ,
                       NULL, &model));
    static const int counts[] = {1, 3, 1};
    static const double x[] = {0, 1, 1, 1, 0}, y[] = {0, 0, 1, 1, 1};
    CHECK_INT(batten_model_count(model), 3);
    for (int i = 0, at = 0; i < 3; i++) {
        const batten_object *object = batten_model_object(model, i);
        CHECK_INT(object->point_count, counts[i]);
        for (int k = 0; k < counts[i]; k++, at++)
            CHECK(object->points[3 * k] == x[at] && object->points[3 * k + 1] == y[at]);
    }
    batten_model_unref(model);
}

/* ---- written ---- */

static const double net[] = {1, 2, 3, 4, 5, 6, 7, 8, 9.5, 10, 11, 12, 13, 14, 15, 16, 17, 18};
static const double weights[] = {1, 2, 4, 8, 0.5, 0.25};
static const double line_knots[] = {0, 0, 1, 1}, bent_knots[] = {0, 0, 1, 3, 3};

/* The object in OBJ, after its first line. */
static void check_written(const batten_object *object, const char *expected)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, object));
    const char *text = written(model, BATTEN_FORMAT_OBJ), *body = strstr(text, "\no ");
    CHECK_TEXT(body ? body + 1 : text, expected);
    batten_model_unref(model);
}

TEST(a_surface_has_its_degrees_domain_points_and_both_knot_vectors)
{
    const batten_axis u = {1, 2, line_knots, false}, v = {1, 3, bent_knots, false};
    batten_surface *plain = NULL, *rational = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, net, NULL, &plain));
    CHECK_OK(batten_surface_create(3, &u, &v, net, weights, &rational));
    check_written(
        &(batten_object){.name = "s", .kind = BATTEN_OBJECT_SURFACE, .surface = plain},
        "o s\nv 1 2 3\nv 4 5 6\nv 7 8 9.5\nv 10 11 12\nv 13 14 15\nv 16 17 18\n"
        "cstype bspline\ndeg 1 1\nsurf 0 1 0 3 1 4 2 5 3 6\n"
        "parm u 0 0 1 1\nparm v 0 0 1 3 3\nend\n");
    check_written(
        &(batten_object){.name = "s", .kind = BATTEN_OBJECT_SURFACE, .surface = rational},
        "o s\nv 1 2 3 1\nv 4 5 6 2\nv 7 8 9.5 4\nv 10 11 12 8\nv 13 14 15 0.5\n"
        "v 16 17 18 0.25\ncstype rat bspline\ndeg 1 1\nsurf 0 1 0 3 1 4 2 5 3 6\n"
        "parm u 0 0 1 1\nparm v 0 0 1 3 3\nend\n");
    batten_surface_unref(plain);
    batten_surface_unref(rational);
}

TEST(a_curve_has_its_degree_domain_points_and_knots)
{
    static const double knots[] = {0, 0, 0, 2, 2, 2};
    batten_curve *plain = NULL, *rational = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, net}, 2, NULL, knots, &plain));
    CHECK_OK(batten_curve_create((batten_points){3, 3, net}, 2, weights, knots, &rational));
    check_written(&(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = plain},
                  "o c\nv 1 2 3\nv 4 5 6\nv 7 8 9.5\ncstype bspline\ndeg 2\n"
                  "curv 0 2 1 2 3\nparm u 0 0 0 2 2 2\nend\n");
    check_written(&(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = rational},
                  "o c\nv 1 2 3 1\nv 4 5 6 2\nv 7 8 9.5 4\ncstype rat bspline\ndeg 2\n"
                  "curv 0 2 1 2 3\nparm u 0 0 0 2 2 2\nend\n");
    batten_curve_unref(plain);
    batten_curve_unref(rational);
}
