#include "exchange/dxf/dxf.h"
#include "exchange/dxf/groups.h"
#include "exchange/reading.h"
#include "exchange/shapes/paths.h"

TEST(a_chain_of_arcs_is_a_polyline_with_bulges)
{
    batten_model *model = model_of("stadium", stadium());
    const char *text = written(model, BATTEN_FORMAT_DXF), *at = entity(text, "LWPOLYLINE");
    double x[8], y[8], bulge[8], flag = 0;
    CHECK_INT(numbers(at, 10, x, 8), 4);
    CHECK_INT(numbers(at, 20, y, 8), 4);
    CHECK_INT(numbers(at, 42, bulge, 8), 2);
    CHECK_INT(numbers(at, 70, &flag, 1), 1);
    CHECK_NEAR(flag, 1, 0);
    CHECK_NEAR(bulge[0], 1, 1e-15);
    CHECK_NEAR(x[1], 90, 1e-13);
    CHECK_NEAR(y[2], 20, 1e-13);
    batten_model_unref(model);
}

TEST(nurbs_curves_of_lines_and_arcs_are_polylines_with_bulges)
{
    batten_model *model = model_of_curve(filleted(3, 1), "frame");
    const char *text = written(model, BATTEN_FORMAT_DXF), *at = entity(text, "LWPOLYLINE");
    double x[9], y[9], bulge[9], z = 0;
    CHECK(strstr(text, "\nSPLINE\n") == NULL);
    CHECK_INT(numbers(at, 10, x, 9), 8);
    CHECK_INT(numbers(at, 20, y, 9), 8);
    CHECK_INT(numbers(at, 42, bulge, 9), 4);
    CHECK_INT(numbers(at, 38, &z, 1), 1);
    CHECK_NEAR(z, 3, 0);
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(bulge[i], tan(acos(-1) / 8), 1e-12);
    CHECK_NEAR(x[1], 70, 1e-11);
    CHECK_NEAR(y[2], 10, 1e-11);
    batten_model_unref(model);
}

TEST(other_curves_are_splines_to_the_bit)
{
    batten_model *model = NULL;
    batten_curve *curve = NULL;
    double knots[32], weights[32];
    CHECK_OK(batten_model_create(1, &model));
    /* A hyperbola: DXF has no entity for it. */
    const double points[6] = {0, 0, 1, 3, 2, 0.1}, weights_of[3] = {1, 2, 1};
    const double knots_of[6] = {0, 0, 0, 1, 1, 1};
    CHECK_OK(
        batten_curve_create((batten_points){2, 3, points}, 2, weights_of, knots_of, &curve));
    const batten_object object = {
        .name = "hyperbola", .layer = "", .kind = BATTEN_OBJECT_CURVE, .curve = curve};
    CHECK_OK(batten_model_add(model, &object));
    const char *at = entity(written(model, BATTEN_FORMAT_DXF), "SPLINE");
    CHECK_INT(numbers(at, 40, knots, 32), batten_curve_knot_count(curve));
    CHECK_INT(numbers(at, 41, weights, 32), batten_curve_point_count(curve));
    for (int i = 0; i < batten_curve_knot_count(curve); i++)
        CHECK_BITS(knots[i], batten_curve_knots(curve)[i]);
    for (int i = 0; i < batten_curve_point_count(curve); i++)
        CHECK_BITS(weights[i], batten_curve_weights(curve)[i]);
    batten_curve_unref(curve);
    batten_model_unref(model);
}

TEST(a_plane_that_looks_aside_has_its_normal_and_its_own_axes)
{
    batten_model *model = NULL;
    batten_chain *plane = stadium(), *placed = NULL;
    const batten_frame frame = {{1, 2, 3}, {0, 1, 0}, {1, 0, 0}}; /* the yz-plane at x = 1 */
    double normal[3] = {0}, z = 0, x[4], y[4];
    CHECK_OK(batten_chain_place(plane, &frame, &placed));
    CHECK_OK(batten_model_create(0.001, &model));
    add_chain(model, "frame", "", placed);
    const char *at = entity(written(model, BATTEN_FORMAT_DXF), "LWPOLYLINE");
    for (int k = 0; k < 3; k++)
        CHECK_INT(numbers(at, 210 + 10 * k, &normal[k], 1), 1);
    CHECK_NEAR(normal[0], 1, 1e-15);
    CHECK_INT(numbers(at, 38, &z, 1), 1);
    CHECK_NEAR(z, 1, 1e-15);
    /* By the format's rule the x-axis of this plane is the world's y, its y-axis the world's z.
     */
    numbers(at, 10, x, 4);
    numbers(at, 20, y, 4);
    CHECK_NEAR(x[0], 12, 1e-13);
    CHECK_NEAR(y[0], 3, 1e-13);
    batten_chain_unref(plane);
    batten_model_unref(model);
}

TEST(handles_are_distinct_and_below_the_seed)
{
    batten_model *model = NULL;
    const double points[9] = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    CHECK_OK(batten_model_create(1, &model));
    add_chain(model, "a", "", hook());
    add_chain(model, "b", "cut", stadium());
    const batten_object object = {.name = "p",
                                  .layer = "cut",
                                  .kind = BATTEN_OBJECT_POINTS,
                                  .point_count = 3,
                                  .points = points};
    CHECK_OK(batten_model_add(model, &object));
    const char *text = written(model, BATTEN_FORMAT_DXF);
    bool used[256] = {false};
    int code = -1, seen = 0;
    char value[VALUE];
    long seed = 0;
    for (const char *at = text; (at = next_group(at, &code, value));) {
        if (code == 9 && strcmp(value, "$HANDSEED") == 0) {
            at = next_group(at, &code, value);
            seed = strtol(value, NULL, 16);
        } else if (code == 5 || code == 105) {
            const long handle = strtol(value, NULL, 16);
            CHECK(handle > 0 && handle < seed && handle < 256 && !used[handle]);
            used[handle] = true;
            seen++;
        }
    }
    CHECK(seen > 20);
    batten_model_unref(model);
}

TEST(f4_layer_names_have_no_forbidden_letters)
{
    char out[BAT_DXF_NAME];
    bat_dxf_layer("a/b:c*\n|d", out);
    CHECK_TEXT(out, "a_b_c___d");
    bat_dxf_layer("Spanten \xC3\xA4", out);
    CHECK_TEXT(out, "Spanten \\U+00E4");
    bat_dxf_layer("\xFF\xFE", out);
    CHECK_TEXT(out, "__");
    bat_dxf_layer("", out);
    CHECK_TEXT(out, "0");
    char longest[600];
    memset(longest, 'x', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    bat_dxf_layer(longest, out);
    CHECK(strlen(out) < BAT_DXF_NAME);
}

TEST(a_straight_curve_of_any_degree_is_a_line)
{
    const double from[3] = {1, 2, 0}, to[3] = {4, 6, 0};
    batten_curve *line = NULL, *raised = NULL;
    CHECK_OK(batten_curve_line(3, from, to, &line));
    CHECK_OK(batten_curve_elevate(line, 2, &raised));
    batten_model *model = model_of_curve(raised, "keel");
    const char *at = entity(written(model, BATTEN_FORMAT_DXF), "LINE");
    double ends[4];
    for (int k = 0; k < 4; k++)
        CHECK_INT(numbers(at, 10 * (k % 2 + 1) + k / 2, &ends[k], 1), 1);
    CHECK(ends[0] == 1 && ends[1] == 2 && ends[2] == 4 && ends[3] == 6);
    batten_curve_unref(line);
    batten_model_unref(model);
}

TEST(dxf_leaves_out_curves_without_length)
{
    static const double points[] = {1, 2, 3, 1, 2, 3, 1, 2, 3, 4, 2, 3};
    batten_curve *curve[2] = {NULL, NULL};
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_curve_line(3, points, points + 3, &curve[0]));
    CHECK_OK(batten_curve_line(3, points + 6, points + 9, &curve[1]));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_notes_create(10, &notes));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = i ? "line" : "point",
                                                          .kind = BATTEN_OBJECT_CURVE,
                                                          .curve = curve[i]}));
    const batten_format formats[] = {BATTEN_FORMAT_DXF, BATTEN_FORMAT_SVG};
    for (int k = 0; k < 2; k++) {
        batten_write_options options = batten_write_defaults();
        batten_model *back = NULL;
        options.format = formats[k];
        CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
        if (!batten_notes_dropped(notes))
            CHECK(has_note(notes, k ? "this curve is one point of the sheet"
                                    : "this curve has no length"));
        CHECK_OK(read_bytes(data, size, formats[k], NULL, &back));
        CHECK_INT(batten_model_count(back), 1);
        batten_release(data);
        batten_model_unref(back);
    }
    batten_notes_free(notes);
    batten_model_unref(model);
    batten_curve_unref(curve[0]);
    batten_curve_unref(curve[1]);
}

TEST(dxf_of_a_model_without_curves_is_refused)
{
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_write_options options = batten_write_defaults();
    batten_surface *sphere = NULL;
    const batten_frame world = batten_frame_world();
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    CHECK_OK(batten_model_create(1, &model));
    const batten_object object = {
        .name = "s", .kind = BATTEN_OBJECT_SURFACE, .surface = sphere};
    CHECK_OK(batten_model_add(model, &object));
    options.format = BATTEN_FORMAT_DXF;
    CHECK_STATUS(batten_write_memory(model, &options, NULL, &data, &size), BATTEN_UNSUPPORTED);
    batten_surface_unref(sphere);
    batten_model_unref(model);
}

/* Every point and every vertex takes a handle. */
TEST(the_seed_is_above_the_handles_of_many_points_and_vertices)
{
    enum { MANY = 400 };
    double points[3 * MANY], knots[MANY + 2];
    batten_curve *curve = NULL;
    batten_model *model = NULL;
    for (int i = 0; i < 3 * MANY; i++)
        points[i] = i % 7 + 10 * (i % 3) * i;
    for (int i = 0; i < MANY + 2; i++)
        knots[i] = i < 1 ? 0 : i > MANY ? MANY - 1 : i - 1;
    CHECK_OK(batten_curve_create((batten_points){3, MANY, points}, 1, NULL, knots, &curve));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "p",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = MANY,
                                                      .points = points}));
    long seed = 0, highest = 0;
    int code = -1;
    char value[VALUE];
    for (const char *at = written(model, BATTEN_FORMAT_DXF);
         (at = next_group(at, &code, value));)
        if (code == 5) {
            const long handle = strtol(value, NULL, 16);
            seed = seed ? seed : handle;
            highest = handle != seed && handle > highest ? handle : highest;
        }
    CHECK(highest > 2 * MANY && seed > highest && seed < 2 * highest);
    batten_curve_unref(curve);
    batten_model_unref(model);
}
