#include "exchange/step/reading.h"

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
