/* What is written of each object, to the letter, and what is said of it. */
#include "body/builder.h"
#include "exchange/listed.h"
#include "exchange/shapes/paths.h"
#include "support/bodies.h"

#include <batten/standard.h>

static const double coordinates[] = {1,  2,  3,  4,  5,  6,  7,  8,  9.5,
                                     10, 11, 12, 13, 14, 15, 16, 17, 18};
static const double weights[] = {1, 2, 4, 8, 0.5, 0.25};
static const double line_knots[] = {0, 0, 1, 1}, bent_knots[] = {0, 0, 1, 3, 3};

static batten_model *model_of_object(const batten_object *object)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, object));
    return model;
}

static void check_written(const batten_object *object, const char *expected)
{
    batten_model *model = model_of_object(object);
    CHECK_TEXT(written(model, BATTEN_FORMAT_G2), expected);
    batten_model_unref(model);
}

TEST(points_have_a_header_a_count_and_a_line_each)
{
    batten_object points = {
        .name = "p", .kind = BATTEN_OBJECT_POINTS, .point_count = 2, .points = coordinates};
    check_written(&points, "400 1 0 0\n2\n1 2 3\n4 5 6\n");
    points.has_colour = true;
    memcpy(points.colour, (double[]){1, 0.5, 0.2}, sizeof points.colour);
    check_written(&points, "400 1 0 4 255 128 51 255\n2\n1 2 3\n4 5 6\n");
}

/* Dimension, rational or not; count, order, knots; a line for each point. */
TEST(a_curve_has_its_dimension_knots_and_points)
{
    batten_curve *flat = NULL, *space = NULL;
    CHECK_OK(
        batten_curve_create((batten_points){2, 3, coordinates}, 1, NULL, bent_knots, &flat));
    CHECK_OK(
        batten_curve_create((batten_points){3, 2, coordinates}, 1, NULL, line_knots, &space));
    check_written(&(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = flat},
                  "100 1 0 0\n2 0\n3 2\n0 0 1 3 3\n1 2\n3 4\n5 6\n");
    check_written(&(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = space},
                  "100 1 0 0\n3 0\n2 2\n0 0 1 1\n1 2 3\n4 5 6\n");
    batten_curve_unref(flat);
    batten_curve_unref(space);
}

TEST(points_of_rational_curves_are_multiplied_by_the_weight_that_stands_behind_them)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, coordinates}, 1, weights, bent_knots,
                                 &curve));
    check_written(&(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = curve},
                  "100 1 0 0\n3 1\n3 2\n0 0 1 3 3\n1 2 3 1\n8 10 12 2\n28 32 38 4\n");
    batten_curve_unref(curve);
}

/* The index of u runs first. */
TEST(a_surface_has_both_knot_vectors_and_its_points_row_by_row_along_u)
{
    const batten_axis u = {1, 2, line_knots, false}, v = {1, 3, bent_knots, false};
    batten_surface *plain = NULL, *rational = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, coordinates, NULL, &plain));
    CHECK_OK(batten_surface_create(3, &u, &v, coordinates, weights, &rational));
    check_written(
        &(batten_object){.name = "s", .kind = BATTEN_OBJECT_SURFACE, .surface = plain},
        "200 1 0 0\n3 0\n2 2\n0 0 1 1\n3 2\n0 0 1 3 3\n"
        "1 2 3\n10 11 12\n4 5 6\n13 14 15\n7 8 9.5\n16 17 18\n");
    check_written(
        &(batten_object){.name = "s", .kind = BATTEN_OBJECT_SURFACE, .surface = rational},
        "200 1 0 0\n3 1\n2 2\n0 0 1 1\n3 2\n0 0 1 3 3\n"
        "1 2 3 1\n80 88 96 8\n8 10 12 2\n6.5 7 7.5 0.5\n28 32 38 4\n4 4.25 4.5 0.25\n");
    batten_surface_unref(plain);
    batten_surface_unref(rational);
}

TEST(a_curve_that_is_not_clamped_is_written_clamped)
{
    static const double knots[] = {0, 1, 2, 3, 4, 5};
    batten_curve *curve = NULL;
    batten_model *back = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, coordinates}, 2, NULL, knots, &curve));
    batten_model *model = model_of_object(
        &(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = curve});
    CHECK_OK(read_text(written(model, BATTEN_FORMAT_G2), BATTEN_FORMAT_G2, NULL, &back));
    const batten_curve *read = batten_model_object(back, 0)->curve;
    CHECK(batten_curve_is_clamped(read) && batten_curve_domain(read).a == 2 &&
          batten_curve_domain(read).b == 3);
    for (int i = 0; i <= 4; i++) {
        double p[3], q[3];
        CHECK_OK(batten_curve_evaluate(curve, 2 + i / 4.0, 0, p));
        CHECK_OK(batten_curve_evaluate(read, 2 + i / 4.0, 0, q));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(q[k], p[k], 1e-14);
    }
    batten_model_unref(back);
    batten_model_unref(model);
    batten_curve_unref(curve);
}

/* ---- faces ---- */

#define PLANE "3 0\n2 2\n0 0 2 2\n2 2\n0 0 2 2\n0 0 0\n2 0 0\n0 2 0\n2 2 0\n"
#define SEGMENT(p, q) "2 2\n0 0 1 1\n" p "\n" q "\n"
#define BOTH(mark, a, b) mark " 100 100\n2 0\n" SEGMENT(a, b) "3 0\n" SEGMENT(a " 0", b " 0")
#define ONLY(a, b) "0 0 100\n3 0\n" SEGMENT(a " 0", b " 0")

/* A triangle: two sides with curves in the parameters, one without, and its last corner twice,
 * as at a pole. */
#define TRIANGLE                                                                     \
    "1\n4 1e-6\n" BOTH("0", "0 0", "2 0") BOTH("0", "2 0", "0 2") ONLY("0 2", "0 0") \
        ONLY("0 0", "0 0")

TEST(a_face_is_a_surface_and_loops_of_curves_in_the_parameters_and_in_space)
{
    static const char text[] = "210 1 0 0\n200\n" PLANE TRIANGLE;
    batten_model *model = NULL;
    CHECK_OK(read_text(text, BATTEN_FORMAT_G2, NULL, &model));
    const batten_body_parts *parts = batten_body_view(batten_model_object(model, 0)->body);
    CHECK_INT(parts->edge_count, 4);
    CHECK(parts->edges[3].curve == NULL || parts->edges[0].curve == NULL);
    const char *const again = written(model, BATTEN_FORMAT_G2);
    CHECK(strncmp(again, text, strlen("210 1 0 0\n200\n" PLANE "1\n4 ")) == 0);
    CHECK_CONTAINS(again, BOTH("0", "0 0", "2 0") BOTH("0", "2 0", "0 2") ONLY("0 2", "0 0"));
    batten_model_unref(model);
}

/* The square from (0, 0) to (2, 2) in the plane z = 0, whose first edge runs from corner 2 to
 * corner 1; the face has its own colour or not, looks up or down, and has a loop or not. */
static batten_body *square(bool has_colour, bool reversed, bool has_loop)
{
    static const double at[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    static const int ends[4][2] = {{1, 0}, {1, 2}, {2, 3}, {3, 0}};
    bat_builder b;
    batten_surface *plane = NULL;
    batten_body *body = NULL;
    int index;
    bat_builder_begin(&b, 1e-6);
    for (int i = 0; i < 4; i++)
        CHECK_OK(bat_builder_vertex(&b, at[i], &index));
    for (int i = 0; i < 4; i++) {
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_line(3, at[ends[i][0]], at[ends[i][1]], &curve));
        CHECK_OK(bat_builder_edge(&b, curve, ends[i][0], ends[i][1], &index));
        batten_curve_unref(curve);
    }
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){2, 0, 0},
                                     (batten_vec3){0, 2, 0}, (batten_vec3){2, 2, 0}, &plane));
    CHECK_OK(bat_builder_shell(&b, false));
    CHECK_OK(bat_builder_face(&b, &(batten_body_face){.surface = plane,
                                                      .reversed = reversed,
                                                      .has_colour = has_colour,
                                                      .colour = {0, 0, 1}}));
    if (has_loop)
        CHECK_OK(bat_builder_loop(&b));
    for (int i = 0; i < 4 && has_loop; i++) {
        const int k = reversed ? 3 - i : i;
        CHECK_OK(bat_builder_use(&b, k, (k == 0) != reversed, NULL));
    }
    batten_surface_unref(plane);
    CHECK_OK(batten_body_create(&b.parts, &body));
    bat_builder_end(&b);
    return body;
}

#define UNIT_PLANE "3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0\n2 0 0\n0 2 0\n2 2 0\n"
#define AROUND                                                                             \
    "0 0 100\n3 0\n2 2\n-1 -1 -0 -0\n0 0 0\n2 0 0\n" ONLY("2 0", "2 2") ONLY("2 2", "0 2") \
        ONLY("0 2", "0 0")

/* Edges run as the loop does, the first one backwards; a loop of a face that looks down is turned to be counter-clockwise. */
TEST(loops_run_counter_clockwise_in_the_parameters_whichever_way_the_face_looks)
{
    for (int reversed = 0; reversed < 2; reversed++) {
        batten_body *body = square(false, reversed, true);
        check_written(&(batten_object){.name = "b", .kind = BATTEN_OBJECT_BODY, .body = body},
                      "210 1 0 0\n200\n" UNIT_PLANE "1\n4 1e-6\n" AROUND);
        batten_body_unref(body);
    }
}

TEST(a_face_has_its_own_colour_or_that_of_its_object)
{
    static const char *const heads[] = {
        "200 1 0 0\n" UNIT_PLANE, "200 1 0 4 0 0 255 255\n" UNIT_PLANE,
        "200 1 0 4 255 0 0 255\n" UNIT_PLANE, "200 1 0 4 0 0 255 255\n" UNIT_PLANE};
    for (int i = 0; i < 4; i++) {
        batten_body *body = square(i % 2, false, false);
        check_written(&(batten_object){.name = "b",
                                       .kind = BATTEN_OBJECT_BODY,
                                       .body = body,
                                       .has_colour = i / 2,
                                       .colour = {1, 0, 0}},
                      heads[i]);
        batten_body_unref(body);
    }
}

/* ---- what is said ---- */

/* All notes of writing the object, as lines "name: text", remarks with a "~". */
static void check_said(const batten_object *object, const char *expected)
{
    batten_model *model = model_of_object(object);
    batten_write_options options = batten_write_defaults();
    batten_notes *notes = NULL;
    char *data = NULL, *list = test_array(2000, 1), *at = list;
    size_t size = 0;
    options.format = BATTEN_FORMAT_G2;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const batten_note *n = batten_notes_at(notes, i);
        at += sprintf(at, "%s%s: %s\n", n->is_remark ? "~" : "", n->entity, n->text);
    }
    if (!batten_notes_dropped(notes) && test_cases(1000) >= 1000)
        CHECK_TEXT(list, expected);
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}

#define UNIT "~: the format has no unit; its numbers are in mm\n"

TEST(what_a_body_loses_in_G2_is_said)
{
    batten_body *bodies[] = {square(false, false, true), square(false, true, true),
                             test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3})};
    static const char *const said[] = {
        UNIT, ": the sides of reversed faces are lost: the format has none\n" UNIT,
        ": 6 faces are written one by one: the format has no shells\n" UNIT};
    for (int i = 0; i < COUNT(bodies); i++) {
        check_said(&(batten_object){.name = "", .kind = BATTEN_OBJECT_BODY, .body = bodies[i]},
                   said[i]);
        batten_body_unref(bodies[i]);
    }
}

/* Coordinates just above 1 with weights just below 2: some have no product that gives them back. */
TEST(coordinates_that_come_back_changed_are_counted)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(20); i++) {
        double points[6], heavy[2];
        char expected[200] = UNIT;
        batten_curve *curve = NULL;
        batten_model *back = NULL;
        int changed = 0;
        for (int k = 0; k < 6; k++)
            points[k] = test_random_in(&random, 1, 1.2);
        for (int k = 0; k < 2; k++)
            heavy[k] = test_random_in(&random, 1.7, 1.9);
        CHECK_OK(
            batten_curve_create((batten_points){3, 2, points}, 1, heavy, line_knots, &curve));
        const batten_object object = {.name = "", .kind = BATTEN_OBJECT_CURVE, .curve = curve};
        batten_model *model = model_of_object(&object);
        CHECK_OK(read_text(written(model, BATTEN_FORMAT_G2), BATTEN_FORMAT_G2, NULL, &back));
        for (int k = 0; k < 6; k++)
            changed += batten_curve_points(batten_model_object(back, 0)->curve)[k] != points[k];
        if (changed)
            snprintf(expected, sizeof expected,
                     ": the format has points times weights; %d coordinate%s "
                     "back changed in the last place\n" UNIT,
                     changed, changed > 1 ? "s come" : " comes");
        check_said(&object, expected);
        batten_model_unref(back);
        batten_model_unref(model);
        batten_curve_unref(curve);
    }
}
