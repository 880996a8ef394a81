#include "exchange/step/references.h"
#include "support/bodies.h"
#include "support/drilled_box.h"

#include <batten/standard.h>

/* Edges, uses of edges, and vertices of the face that a surface becomes. */
static void check_face(batten_surface *surface, int edges, int uses, int vertices)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    add_surface(model, "face", surface);
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "EDGE_CURVE"), edges);
    CHECK_INT(step_count(text, "ORIENTED_EDGE"), uses);
    CHECK_INT(step_count(text, "VERTEX_POINT"), vertices);
    CHECK_INT(step_count(text, "ADVANCED_FACE"), 1);
    batten_model_unref(model);
    batten_surface_unref(surface);
}

TEST(borders_that_coincide_are_one_edge_and_poles_are_left_out)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *surface = NULL;
    test_random random = test_random_begin(__func__);
    check_face(random_surface(&random), 4, 4, 4);
    CHECK_OK(batten_surface_cylinder(&frame, 2, 5, &surface));
    check_face(surface, 3, 4, 2);
    CHECK_OK(batten_surface_cone(&frame, 2, 0, 5, &surface));
    check_face(surface, 2, 3, 2);
    CHECK_OK(batten_surface_sphere(&frame, 2, &surface));
    check_face(surface, 1, 2, 2);
    CHECK_OK(batten_surface_torus(&frame, 5, 1, &surface));
    check_face(surface, 2, 4, 1);
}

TEST(a_patch_with_one_collapsed_side_has_three_edges)
{
    const double points[] = {0, 0, 0, 0, 0, 0, 5, 0, 0, 5, 4, 1}, knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    check_face(surface, 3, 3, 3);
}

TEST(a_surface_whose_border_is_a_point_is_left_out_with_a_note)
{
    const double points[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_notes_create(4, &notes));
    add_surface(model, "nothing", surface);
    CHECK_INT(step_count(step_text(model, notes), "ADVANCED_FACE"), 0);
    CHECK(batten_notes_dropped(notes) ||
          has_note(notes, "the border of the surface is one point"));
    batten_notes_free(notes);
    batten_model_unref(model);
    batten_surface_unref(surface);
}

static batten_model *model_of(batten_body *body, const char *name)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = name, .kind = BATTEN_OBJECT_BODY, .body = body}));
    batten_body_unref(body);
    return model;
}

TEST(a_solid_shares_its_edges_and_its_faces_have_sides)
{
    batten_body *body = NULL;
    CHECK_OK(drilled_box(&body));
    batten_model *model = model_of(body, "block");
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "MANIFOLD_SOLID_BREP"), 1);
    CHECK_INT(step_count(text, "ADVANCED_BREP_SHAPE_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "CLOSED_SHELL"), 1);
    CHECK_INT(step_count(text, "ADVANCED_FACE"), 8);
    CHECK_INT(step_count(text, "FACE_OUTER_BOUND"), 8);
    CHECK_INT(step_count(text, "FACE_BOUND"), 2);
    CHECK_INT(step_count(text, "EDGE_CURVE"), DRILLED_EDGES);
    CHECK_INT(step_count(text, "ORIENTED_EDGE"), DRILLED_USES);
    CHECK_INT(step_count(text, "VERTEX_POINT"), DRILLED_VERTICES);
    CHECK_INT(step_count(text, "SURFACE_CURVE"), DRILLED_EDGES);
    CHECK_INT(step_count(text, "PCURVE"), DRILLED_USES);
    CHECK_INT(step_count(text, "COLOUR_RGB"), 1);
    CHECK_CONTAINS(text, "ADVANCED_FACE('top',(");
    const char *wall = strstr(text, "ADVANCED_FACE('',(");
    CHECK(wall && strncmp(strchr(wall, ';') - 4, ".F.)", 4) == 0);
    batten_model_unref(model);
}

TEST(parameter_curves_are_left_out_where_that_is_asked)
{
    batten_write_options options = batten_write_defaults();
    batten_body *body = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(drilled_box(&body));
    batten_model *model = model_of(body, "block");
    options.format = BATTEN_FORMAT_STEP;
    options.no_parameter_curves = true;
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    step_check(data);
    CHECK_INT(step_count(data, "PCURVE"), 0);
    CHECK_INT(step_count(data, "SURFACE_CURVE"), 0);
    CHECK_INT(step_count(data, "EDGE_CURVE"), DRILLED_EDGES);
    CHECK(strstr(data, "'2D'") == NULL);
    batten_release(data);
    batten_model_unref(model);
}

TEST(seams_have_two_curves_in_the_parameters_and_poles_none)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *sphere = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_sphere(&frame, 2, &sphere));
    CHECK_OK(batten_body_from_surface("ball", sphere, 1e-6, &body));
    batten_surface_unref(sphere);
    batten_model *model = model_of(body, "ball");
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "SEAM_CURVE"), 1);
    CHECK_INT(step_count(text, "PCURVE"), 2);
    CHECK_INT(step_count(text, "CLOSED_SHELL"), 1);
    CHECK_INT(step_count(text, "SHELL_BASED_SURFACE_MODEL"), 1);
    batten_model_unref(model);
}

/* A box with a box-shaped void in it: the sides of the void's faces are turned inside. */
static batten_body *hollow_box(void)
{
    batten_body *boxes[2] = {test_box((batten_vec3){0, 0, 0}, (batten_vec3){4, 4, 4}),
                             test_box((batten_vec3){1, 1, 1}, (batten_vec3){3, 3, 3})};
    batten_body *made = NULL;
    batten_body_edge edges[24];
    batten_body_use uses[48];
    batten_body_loop loops[12];
    batten_body_face faces[12];
    double vertices[48];
    for (int b = 0; b < 2; b++) {
        const batten_body_parts *p = batten_body_view(boxes[b]);
        memcpy(&vertices[24 * b], p->vertices, 24 * sizeof *vertices);
        for (int i = 0; i < 12; i++) {
            edges[12 * b + i] = p->edges[i];
            for (int k = 0; k < 2; k++)
                edges[12 * b + i].vertices[k] += 8 * b;
        }
        for (int f = 0; f < 6; f++) {
            loops[6 * b + f] = (batten_body_loop){24 * b + 4 * f, 4};
            faces[6 * b + f] = p->faces[f];
            faces[6 * b + f].first = 6 * b + f;
            faces[6 * b + f].reversed = b == 1;
            for (int k = 0; k < 4; k++) {
                const batten_body_use *use = &p->uses[4 * f + (b ? 3 - k : k)];
                uses[24 * b + 4 * f + k] =
                    (batten_body_use){use->edge + 12 * b, use->reversed != (b == 1), NULL};
            }
        }
    }
    const batten_body_shell shells[] = {{0, 6, true}, {6, 6, true}};
    CHECK_OK(batten_body_create(&(batten_body_parts){.vertex_count = 16,
                                                     .vertices = vertices,
                                                     .edge_count = 24,
                                                     .edges = edges,
                                                     .use_count = 48,
                                                     .uses = uses,
                                                     .loop_count = 12,
                                                     .loops = loops,
                                                     .face_count = 12,
                                                     .faces = faces,
                                                     .shell_count = 2,
                                                     .shells = shells,
                                                     .is_solid = true,
                                                     .tolerance = 1e-6},
                                &made));
    for (int b = 0; b < 2; b++)
        batten_body_unref(boxes[b]);
    return made;
}

TEST(a_solid_with_a_void_has_an_oriented_shell)
{
    batten_model *model = model_of(hollow_box(), "hollow");
    const char *text = step_text(model, NULL);
    step_check(text);
    step_check_references(text);
    CHECK_INT(step_count(text, "BREP_WITH_VOIDS"), 1);
    CHECK_INT(step_count(text, "CLOSED_SHELL"), 2);
    CHECK_INT(step_count(text, "ORIENTED_CLOSED_SHELL"), 1);
    CHECK_INT(step_count(text, "EDGE_CURVE"), 24);
    batten_model_unref(model);
}

/* ---- what refers to what ---- */

/* The first instance of a keyword that `instance` refers to, or NULL. */
static const char *refers_to(const char *text, const char *instance, const char *keyword)
{
    int ids[200];
    const int count = step_ids(instance, COUNT(ids), ids);
    for (int i = 0; i < count; i++)
        if (step_is(step_instance(text, ids[i]), keyword, strlen(keyword)))
            return step_instance(text, ids[i]);
    return NULL;
}

/* An edge of a face has a curve in the parameters of that face's surface. */
static void check_edge(const char *text, const char *oriented, int surface)
{
    const char *edge = refers_to(text, oriented, "EDGE_CURVE");
    const char *curve = refers_to(text, edge, "SURFACE_CURVE");
    int ids[4], pcurve[4], own = 0;
    curve = curve ? curve : refers_to(text, edge, "SEAM_CURVE");
    CHECK(curve != NULL);
    const int count = step_ids(curve, 4, ids);
    CHECK(count == 2 || count == 3);
    for (int i = 1; i < count; i++) {
        step_ids(step_instance(text, ids[i]), 4, pcurve);
        own += pcurve[0] == surface;
    }
    CHECK_INT(own, strncmp(curve, "SEAM", 4) == 0 ? 2 : 1);
}

static int check_faces(const char *text)
{
    int faces = 0;
    const char *instance;
    for (int id = 1; (instance = step_instance(text, id)); id++) {
        int ids[20], loops[2], edges[50];
        if (strncmp(instance, "ADVANCED_FACE(", 14) != 0)
            continue;
        const int count = step_ids(instance, COUNT(ids), ids);
        CHECK(step_is(step_instance(text, ids[count - 1]), "B_SPLINE_SURFACE_WITH_KNOTS", 27));
        for (int l = 0; l + 1 < count; l++) {
            CHECK_INT(step_ids(step_instance(text, ids[l]), 2, loops), 1);
            const int uses = step_ids(step_instance(text, loops[0]), COUNT(edges), edges);
            for (int u = 0; u < uses; u++)
                check_edge(text, step_instance(text, edges[u]), ids[count - 1]);
        }
        faces++;
    }
    return faces;
}

TEST(each_edge_has_its_curve_in_the_parameters_of_each_of_its_faces)
{
    const batten_frame frame = batten_frame_world();
    batten_body *body = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(drilled_box(&body));
    batten_model *model = model_of(body, "block");
    CHECK_OK(batten_surface_cylinder(&frame, 2, 5, &surface));
    add_surface(model, "pipe", surface);
    batten_surface_unref(surface);
    const char *text = step_text(model, NULL);
    step_check_references(text);
    CHECK_INT(check_faces(text), 9);
    batten_model_unref(model);
}

/* A surface of 4 x 5 points whose borders are its edges: they refer to its points, of which none is written twice;
 * further points are 4 vertices, and in the parameters of the surface 2 for each edge. */
TEST(borders_refer_to_the_points_of_the_surface)
{
    const double u[] = {0, 0, 0, 0, 1, 1, 1, 1}, v[] = {0, 0, 0, 0.5, 0.75, 1, 1, 1};
    const batten_axis axes[] = {{3, 4, u, false}, {2, 5, v, false}};
    double points[60];
    for (int i = 0; i < 20; i++) {
        points[3 * i] = i / 5;
        points[3 * i + 1] = i % 5;
        points[3 * i + 2] = (i * 7 % 5) / 8.;
    }
    batten_surface *surface = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_surface_create(3, &axes[0], &axes[1], points, NULL, &surface));
    CHECK_OK(batten_model_create(1, &model));
    add_surface(model, "side", surface);
    const char *text = step_text(model, NULL);
    step_check_references(text);
    CHECK_INT(check_faces(text), 1);
    CHECK_INT(step_count(text, "CARTESIAN_POINT"), 20 + 4 + 4 * 2 + 1); /* and the origin */
    batten_surface_unref(surface);
    batten_model_unref(model);
}
