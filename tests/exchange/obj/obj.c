#include "exchange/meshes/meshes.h"
#include "exchange/shapes.h"

static const char start[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";

/* `start`, then the text. */
static const char *after_start(const char *text)
{
    char *all = test_array(strlen(start) + strlen(text) + 1, 1);
    strcpy(all, start);
    strcat(all, text);
    return all;
}

TEST(corners_are_spelled_in_many_ways)
{
    static const char *const faces[] = {"f 1 2 3\n",          "f 1/1 2/1 3/1\n",
                                        "f 1//1 2//1 3//1\n", "f 1/1/1 2/1/1 3/1/1\n",
                                        "f -4 -3 -2\n",       "f -4//-1 -3//-1 -2//-1\n",
                                        "f 1 2 3 # all\n",    "f 1 \\\n 2 3\n",
                                        "f 1 2\\\n3",         "f 1 2 \\\r\n3\r\n",
                                        "  f\t1 2 3 \n\n",    "fo 1 2 3\n"};
    for (int i = 0; i < COUNT(faces); i++) {
        batten_model *model = NULL;
        CHECK_OK(read_text(after_start(faces[i]), BATTEN_FORMAT_AUTO, NULL, &model));
        const batten_mesh_parts *p = mesh_at(model, 0);
        CHECK_INT(p->triangle_count, 1);
        CHECK_INT(p->vertex_count, 3);
        CHECK(p->corners[0] == 0 && p->corners[1] == 1 && p->corners[2] == 2);
        CHECK((p->normals != NULL) == (strstr(faces[i], "//") || strstr(faces[i], "/1/")));
        batten_model_unref(model);
    }
}

TEST(N4_indices_that_are_none_leave_the_face_out)
{
    static const struct {
        const char *face, *words;
    } cases[] = {
        {"f 1 2 5\n", "its corner 3 has vertex 5, which does not exist"},
        {"f 1 2 0\n", "1 of its 3 corners are not indices"},
        {"f 1 2 -5\n", "1 of its 3 corners are not indices"},
        {"f 1 2 x\n", "1 of its 3 corners are not indices"},
        {"f 1 2 3e1\n", "1 of its 3 corners are not indices"},
        {"f 1 2 99999999999\n", "1 of its 3 corners are not indices"},
        {"f 1 2 3/1/1/1\n", "1 of its 3 corners are not indices"},
        {"f 1//2 2//1 3//1\n", "its corner 1 has normal 2, which does not exist"},
        {"f 1 2\n", "0 of its 2 corners are not indices"},
        {"l 1\n", "0 of its 1 corners are not indices"},
        {"p 7\n", "its corner 1 has vertex 7"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char body[100];
        snprintf(body, sizeof body, "%sf 1 2 3\n", cases[i].face);
        const char *text = after_start(body);
        batten_model *model =
            read_partly(text, strlen(text), BATTEN_FORMAT_AUTO, cases[i].words);
        CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
        batten_model_unref(model);
    }
}

TEST(N1_vertices_that_are_no_numbers_leave_out_their_faces)
{
    const char *text = "v 0 0 0\nv nan 0 0\nv 1 1 0\nv 0 1 0\nv 1 2\nf 1 2 3\nf 1 3 4\n";
    batten_model *model = read_partly(text, strlen(text), BATTEN_FORMAT_OBJ,
                                      "vertex 2 is left out: it is not of 3, 4 or 6 numbers");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    CHECK_INT(mesh_at(model, 0)->vertex_count, 3);
    batten_model_unref(model);
}

TEST(groups_and_objects_are_objects_with_names)
{
    const char *text = after_start("o hull\nf 1 2 3\ng port side\nf 1 2 4\ng star\nl 1 2 3\no "
                                   "keel # a comment\nf 2 3 4\ng deck\nf 1 3 4\n");
    static const struct {
        const char *name, *group;
        batten_object_kind kind;
    } expected[] = {{"hull", "", BATTEN_OBJECT_MESH},
                    {"port side", "hull", BATTEN_OBJECT_MESH},
                    {"star", "hull", BATTEN_OBJECT_CURVE},
                    {"keel", "", BATTEN_OBJECT_MESH},
                    {"deck", "keel", BATTEN_OBJECT_MESH}};
    batten_model *model = NULL;
    CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, NULL, &model));
    for (int round = 0; round < 2; round++) {
        CHECK_INT(batten_model_count(model), COUNT(expected));
        for (int i = 0; i < COUNT(expected); i++) {
            const batten_object *object = batten_model_object(model, i);
            CHECK_TEXT(object->name, expected[i].name);
            CHECK_TEXT(object->group, expected[i].group);
            CHECK_INT(object->kind, expected[i].kind);
        }
        batten_model *back = check_second(model, BATTEN_FORMAT_OBJ, false);
        batten_model_unref(model);
        model = back;
    }
    batten_model_unref(model);
}

TEST(N1_a_cloud_is_read_without_its_bad_vertices)
{
    const char *text = "v 1 2 3\nv 4 x 6\nv 7 8 9\n";
    batten_model *model = read_partly(text, strlen(text), BATTEN_FORMAT_OBJ,
                                      "vertex 2 is left out: it is not of 3, 4 or 6 numbers");
    const batten_object *cloud = batten_model_object(model, 0);
    CHECK_INT(cloud->point_count, 2);
    CHECK_BITS(cloud->points[3], 7);
    batten_model_unref(model);
}

TEST(lines_points_and_clouds_are_read)
{
    batten_model *model =
        read_noting(after_start("l 1/1 2/1 3/1\np 4\nf 1 2 3\np 1 2\n"), BATTEN_FORMAT_OBJ,
                    "1 coordinates of textures are not kept");
    CHECK_INT(batten_model_count(model), 3);
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    CHECK_INT(batten_curve_degree(curve), 1);
    CHECK_INT(batten_curve_point_count(curve), 3);
    CHECK_BITS(batten_curve_domain(curve).b, 2.0);
    CHECK_INT(batten_model_object(model, 1)->point_count, 3);
    CHECK_BITS(batten_model_object(model, 1)->points[1], 1.0);
    batten_model *back = check_second(model, BATTEN_FORMAT_OBJ, false);
    check_same_curve(curve, batten_model_object(back, 0)->curve);
    batten_model_unref(back);
    batten_model_unref(model);

    model = read_noting("# cloud\nv 1 2 3\nv 4 5 6\n", BATTEN_FORMAT_AUTO, "");
    CHECK(batten_model_object(model, 0)->kind == BATTEN_OBJECT_POINTS);
    CHECK_BITS(batten_model_object(model, 0)->points[5], 6.0);
    batten_model_unref(model);
}

TEST(colours_and_normals_of_meshes_come_back)
{
    const char *text =
        "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.1\nv 9 9 9\nvn 0 0 1\nvn 0 1 "
        "0\nf 1//1 2//1 3//2\nf 1//1 3//2 2//2\n";
    batten_model *model =
        read_noting(text, BATTEN_FORMAT_OBJ, "1 of 4 vertices belong to no element; not kept");
    const batten_mesh_parts *p = mesh_at(model, 0);
    CHECK_INT(p->vertex_count, 3);
    CHECK_BITS(p->colours[8], 0.1);
    CHECK_BITS(p->normals[7], 1.0);
    batten_model *back = check_second(model, BATTEN_FORMAT_OBJ, false);
    check_same_mesh(p, mesh_at(back, 0));
    batten_model_unref(back);
    batten_model_unref(model);
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 5\nf 1//1 2//1 3//1\n";
    batten_model_unref(read_noting(text, BATTEN_FORMAT_OBJ, "(0, 0, 5) has not the length 1"));
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2 3//1\n";
    batten_model_unref(read_noting(text, BATTEN_FORMAT_OBJ, "some corners have none"));
}

/* ---- free-form ---- */

static void check_at(const batten_curve *curve, double u, double x, double y)
{
    double p[3];
    CHECK_OK(batten_curve_evaluate(curve, u, 0, p));
    CHECK_NEAR(p[0], x, 1e-15);
    CHECK_NEAR(p[1], y, 1e-15);
}

static batten_curve *read_curve(const char *statements)
{
    batten_model *model = read_noting(after_start(statements), BATTEN_FORMAT_OBJ, "textures");
    batten_curve *curve = batten_curve_ref(batten_model_object(model, 0)->curve);
    batten_model_unref(model);
    return curve;
}

/* The basis of uniform cubic B-splines, Bezier's and Catmull and Rom's say the same through
 * matrices: the values at the ends of pieces are known in closed form. */
TEST(free_form_curves_of_every_basis_are_read)
{
    static const char bspline[] =
        "bmat u 0.16666666666666666 -0.5 0.5 -0.16666666666666666 0.66666666666666663 0 -1 0.5 "
        "0.16666666666666666 0.5 0.5 -0.5 0 0 0 0.16666666666666666\n";
    char text[512];
    batten_curve *curve = read_curve("cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 "
                                     "1\nend\n");
    check_at(curve, 0.5, 0.75, 0.5);
    batten_curve_unref(curve);
    curve = read_curve("cstype bezier\ndeg 1\ncurv 0 3 1 2 3 4\nparm u 0 1 2 3\nend\n");
    check_at(curve, 1.5, 1, 0.5);
    batten_curve_unref(curve);
    curve =
        read_curve("cstype bspline\ndeg 2\ncurv 0.5 1.5 1 2 3 4\nparm u 0 0 0 1 2 2 2\nend\n");
    check_at(curve, 1, 1, 0.5);
    CHECK_BITS(batten_curve_domain(curve).a, 0.5);
    batten_curve_unref(curve);
    curve = read_curve("cstype cardinal\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n");
    check_at(curve, 0, 1, 0);
    check_at(curve, 0.5, 1.125, 0.5);
    batten_curve_unref(curve);
    snprintf(text, sizeof text,
             "cstype bmatrix\ndeg 3\nstep 1\n%scurv 0 2 1 2 3 4 1\nparm u 0 1 2\nend\n",
             bspline);
    curve = read_curve(text);
    check_at(curve, 0, 5 / 6.0, 1 / 6.0);
    check_at(curve, 1, 5 / 6.0, 5 / 6.0);
    CHECK_INT(batten_curve_point_count(curve), 7);
    batten_curve_unref(curve);
}

TEST(N6_a_knot_of_minus_zero_comes_back)
{
    batten_model *model =
        read_noting("v 0 0 0\nv 1 0 0\ncstype bspline\ndeg 1\ncurv 0 1 1 2\n"
                    "parm u -0 0 1 1\nend\ncurv 0 1 1 2\nparm u -0 -0 1 1\nend\n",
                    BATTEN_FORMAT_OBJ, "");
    batten_model *back = check_second(model, BATTEN_FORMAT_OBJ, false);
    for (int i = 0; i < 2; i++)
        check_same_curve(batten_model_object(model, i)->curve,
                         batten_model_object(back, i)->curve);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(a_rational_quarter_circle_stays_round)
{
    batten_model *model = read_noting("v 1 0 0 1\nv 1 1 0 0.70710678118654757\nv 0 1 0 1\n"
                                      "cstype rat bezier\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 1\n"
                                      "end\n",
                                      BATTEN_FORMAT_AUTO, "");
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    for (int i = 0; i <= 20; i++) {
        double p[3];
        CHECK_OK(batten_curve_evaluate(curve, i / 20.0, 0, p));
        CHECK_NEAR(hypot(p[0], p[1]), 1, 4 * DBL_EPSILON);
    }
    batten_model_unref(model);
}

TEST(surfaces_are_read_with_u_fastest)
{
    const char *text = after_start("v 0 2 5\nv 1 2 7\ncstype bspline\ndeg 1 2\nsurf 0 1 0 1 "
                                   "1 2 4 3 5 6\nparm u 0 0 1 1\nparm v 0 0 0 1 1 1\nend\n");
    batten_model *model = NULL;
    double p[3];
    CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, NULL, &model));
    const batten_surface *surface = batten_model_object(model, 0)->surface;
    CHECK_INT(batten_surface_degree(surface, BATTEN_V), 2);
    CHECK_OK(batten_surface_evaluate(surface, 1, 1, 0, p));
    CHECK(p[0] == 1 && p[1] == 2 && p[2] == 7);
    CHECK_OK(batten_surface_evaluate(surface, 1, 0, 0, p));
    CHECK(p[0] == 1 && p[1] == 0 && p[2] == 0);
    batten_model_unref(model);
}

/* The uniform bicubic B-spline through its matrix is that through its knots. */
TEST(surfaces_of_a_matrix_are_those_of_the_knots)
{
    char text[4096];
    size_t at = 0;
    for (int i = 0; i < 25; i++)
        at += (size_t)snprintf(text + at, sizeof text - at, "v %d %d %d\n", i % 5, i / 5,
                               i * 7 % 11);
    static const char numbers[] =
        "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25";
    static const char matrix[] =
        "0.16666666666666666 -0.5 0.5 -0.16666666666666666 0.66666666666666663 0 -1 0.5 "
        "0.16666666666666666 0.5 0.5 -0.5 0 0 0 0.16666666666666666";
    snprintf(
        text + at, sizeof text - at,
        "cstype bmatrix\ndeg 3 3\nstep 1 1\nbmat u %s\nbmat v %s\nsurf 0 2 0 2 %s\nparm u 0 "
        "1 2\nparm v 0 1 2\nend\ncstype bspline\nsurf 0 2 0 2 %s\nparm u -3 -2 -1 0 1 2 3 4 "
        "5\nparm v -3 -2 -1 0 1 2 3 4 5\nend\n",
        matrix, matrix, numbers, numbers);
    batten_model *model = read_noting(text, BATTEN_FORMAT_OBJ, "");
    CHECK_INT(batten_model_count(model), 2);
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 8; j++) {
            double p[3], q[3];
            for (int k = 0; k < 2; k++)
                CHECK_OK(batten_surface_evaluate(batten_model_object(model, k)->surface,
                                                 i / 4.0, j / 4.0, 0, k ? q : p));
            CHECK_NEAR(hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]), 0, 1e-14);
        }
    batten_model_unref(model);
}

TEST(free_form_shapes_that_are_none_are_left_out_with_the_reason)
{
    static const struct {
        const char *text, *words;
    } cases[] = {
        {"deg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n", "no 'cstype' stands before it"},
        {"cstype taylor\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n", "its 'cstype' is not"},
        {"cstype bezier\ndeg 26\ncurv 0 1 1 2\nparm u 0 1\nend\n",
         "its degree is not in 1..25"},
        {"cstype bezier\ncurv 0 1 1 2\nparm u 0 1\nend\n", "its degree is not in 1..25"},
        {"cstype bezier\ndeg 3\ncurv 0 1 1 2 3\nparm u 0 1\nend\n",
         "not as many control points as its parameters ask for"},
        {"cstype bspline\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n",
         "more knots than 'parm'"},
        {"cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\n", "fewer than two parameters"},
        {"cstype cardinal\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 1\nend\n", "have degree 3"},
        {"cstype bmatrix\ndeg 1\ncurv 0 1 1 2\nparm u 0 1\nend\n", "its step is missing"},
        {"cstype bmatrix\ndeg 1\nstep 1\ncurv 0 1 1 2\nparm u 0 1\nend\n",
         "its basis matrix has not (degree + 1)^2 numbers"},
        {"cstype bmatrix\ndeg 1\nstep 1\nbmat u 1 -1 0 2\ncurv 0 1 1 2 3\nparm u 0 1 2\nend\n",
         "its pieces do not meet"},
        {"cstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 1 0 1\nend\n", "knot 3 is 0"},
        {"cstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 nan 1\nend\n", "left out"},
        {"cstype bspline\ndeg 1\ncurv 0 2 1 2\nparm u 0 0 1 1\nend\n", "outside its knots"},
        {"cstype bspline\ndeg 1\ncurv 1 0 1 2\nparm u 0 0 1 1\nend\n", "outside its knots"},
        {"cstype bspline\ndeg 1\ncurv nan 1 1 2\nparm u 0 0 1 1\nend\n", "outside its knots"},
        {"cstype bspline\ndeg 1\ncurv 0 1 1 9\nparm u 0 0 1 1\nend\n", "that there is not"},
        {"cstype bspline\ndeg 1\ncurv 0 1 1 x\nparm u 0 0 1 1\nend\n",
         "a control point is not an index"},
        {"cstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 1\n", "its 'end' is missing"},
        {"v 1 1 1 -1\ncstype rat bspline\ndeg 1\ncurv 0 1 1 5\nparm u 0 0 1 1\nend\n",
         "weight 2 is -1"},
        {"cstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 4\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\n",
         "the free-form surface is left out"},
        {"gibberish 1 2\n", "unknown statement 'gibberish'"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char body[300];
        snprintf(body, sizeof body, "f 1 2 3\n%s", cases[i].text);
        const char *text = after_start(body);
        batten_model *model =
            read_partly(text, strlen(text), BATTEN_FORMAT_OBJ, cases[i].words);
        CHECK_INT(batten_model_count(model), 1);
        batten_model_unref(model);
    }
}

TEST(trims_are_told_and_the_surface_is_whole)
{
    const char *text =
        after_start("cstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 4 3\nparm u 0 0 1 "
                    "1\nparm v 0 0 1 1\ntrim 0 1 1\nhole 0 1 2\nend\n");
    batten_model *model = read_partly(text, strlen(text), BATTEN_FORMAT_OBJ,
                                      "the surface is whole: 2 statements that trim it");
    CHECK(batten_model_object(model, 0)->kind == BATTEN_OBJECT_SURFACE);
    batten_model_unref(model);
}

TEST(random_curves_and_surfaces_come_back_to_the_bit)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(20); i++) {
        batten_model *model = random_model(&random, 0.001);
        batten_model *back = check_second(model, BATTEN_FORMAT_OBJ, false);
        CHECK_INT(batten_model_count(back), batten_model_count(model));
        for (int k = 0; k < batten_model_count(model); k++) {
            const batten_object *p = batten_model_object(model, k),
                                *q = batten_model_object(back, k);
            CHECK_INT(q->kind, p->kind);
            if (p->curve)
                check_same_curve(p->curve, q->curve);
            else
                check_same_surface(p->surface, q->surface);
        }
        batten_model_unref(back);
        batten_model_unref(model);
    }
}

TEST(obj_is_written_so)
{
    batten_model *model = NULL;
    const batten_mesh_parts parts = {.vertex_count = 3,
                                     .points = tetrahedron_points,
                                     .triangle_count = 1,
                                     .corners = (const int[]){0, 1, 2}};
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, " a #1", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_OBJ, false, NULL, &data, &size));
    CHECK_TEXT(data, "o a _1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    batten_release(data);
    batten_model_unref(model);
}

TEST(F1_obj_files_with_nothing_in_them_are_refused)
{
    check_refused("", BATTEN_FORMAT_OBJ, BATTEN_BAD_FORMAT, "the file is empty");
    check_refused("# nothing\n", BATTEN_FORMAT_OBJ, BATTEN_BAD_FORMAT,
                  "no vertex, face or curve");
    check_refused("f 1 2 3\n", BATTEN_FORMAT_OBJ, BATTEN_BAD_FORMAT,
                  "no vertex, face or curve");
}

TEST(S3_very_many_groups_are_read_in_one_go)
{
    enum { MANY = 20000 };
    char *text = test_array(40 * MANY + 100, 1);
    size_t at = (size_t)sprintf(text, "%s", start);
    for (int i = 0; i < MANY; i++)
        at += (size_t)sprintf(text + at, "g a\nf 1 2 3\n");
    batten_model *model = NULL;
    CHECK_OK(read_bytes(text, at, BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_INT(batten_model_count(model), MANY);
    batten_model_unref(model);
}
