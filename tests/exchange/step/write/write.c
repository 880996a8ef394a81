#include "exchange/step/reading.h"

static batten_model *curve_model(double unit)
{
    test_random random = test_random_begin("curve_model");
    batten_curve *curve = random_curve(&random);
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(unit, &model));
    add_curve(model, "keel", curve);
    batten_curve_unref(curve);
    return model;
}

TEST(the_unit_stands_in_the_context)
{
    const struct {
        double unit;
        const char *words;
    } cases[] = {
        {1, "(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.))"},
        {0.001, "SI_UNIT(.MILLI.,.METRE.)"},
        {0.01, "SI_UNIT(.CENTI.,.METRE.)"},
        {0, "SI_UNIT(.MILLI.,.METRE.)"},
        {0.0254, "(CONVERSION_BASED_UNIT('INCH',#"},
        {0.3048, "(CONVERSION_BASED_UNIT('FOOT',#"},
        {2.5, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.5),#"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = curve_model(cases[i].unit);
        const char *text = step_text(model, NULL);
        step_check(text);
        CHECK_CONTAINS(text, cases[i].words);
        batten_model_unref(model);
    }
}

TEST(the_accuracy_is_a_millionth_of_a_metre_or_what_is_asked)
{
    batten_model *model = curve_model(0.001);
    CHECK_CONTAINS(step_text(model, NULL),
                   "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.001),#");
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_FORMAT_STEP;
    options.tolerance = 0.25;
    options.date = "2026-11-21T10:25:00";
    options.name = "it's";
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    CHECK_CONTAINS(data, "LENGTH_MEASURE(0.25)");
    CHECK_CONTAINS(data, "FILE_NAME('it''s','2026-11-21T10:25:00',(''),(''),'Batten ");
    CHECK_CONTAINS(data, "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));");
    batten_release(data);
    batten_model_unref(model);
}

TEST(faces_and_curves_have_representations_of_their_own)
{
    test_random random = test_random_begin(__func__);
    batten_model *model = curve_model(1);
    const char *text = step_text(model, NULL);
    CHECK_INT(step_count(text, "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "SHAPE_REPRESENTATION"), 0);
    batten_surface *surface = random_surface(&random);
    add_surface(model, "side", surface);
    text = step_text(model, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "SHAPE_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "SHAPE_REPRESENTATION_RELATIONSHIP"), 2);
    CHECK_INT(step_count(text, "SHAPE_DEFINITION_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "STYLED_ITEM"), 0);
    batten_surface_unref(surface);
    batten_model_unref(model);
}

TEST(points_are_written_and_tables_are_not)
{
    const double points[] = {1, 2, 3, 4, 5, 6};
    const batten_table_point side = {0, 1, 2, -1};
    const batten_table_station station = {"0", 0, 1, &side};
    batten_offset_table *offsets = NULL;
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_notes_create(4, &notes));
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 1, &station, &offsets));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "data",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 2,
                                                      .points = points}));
    CHECK_OK(batten_model_add(model,
                              &(batten_object){.name = "none", .kind = BATTEN_OBJECT_POINTS}));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "table",
                                                      .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                                      .offset_table = offsets}));
    const char *text = step_text(model, notes);
    step_check(text);
    CHECK_INT(step_count(text, "GEOMETRIC_CURVE_SET"), 1);
    CHECK_CONTAINS(text, "GEOMETRIC_CURVE_SET('data',(#");
    CHECK(batten_notes_dropped(notes) ||
          has_note(notes, "left out: STEP files hold points, curves"));
    batten_notes_free(notes);
    batten_offset_table_unref(offsets);
    batten_model_unref(model);
}

/* ISO 10303-46, marker_type: dot, x, plus, asterisk, ring, square, triangle. */
TEST(coloured_points_have_a_marker_that_the_standard_knows)
{
    static const double points[] = {0, 0, 0, 1, 2, 3};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.has_colour = true,
                                                      .colour = {1, 0.5, 0},
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 2,
                                                      .points = points}));
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_CONTAINS(text, "POINT_STYLE('',MARKER_TYPE(.DOT.),POSITIVE_LENGTH_MEASURE(1.),#");
    batten_model_unref(model);
}

TEST(colours_are_styles_of_faces_and_curves)
{
    test_random random = test_random_begin(__func__);
    batten_surface *surface = random_surface(&random);
    batten_curve *curve = random_curve(&random);
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.has_colour = true,
                                                      .colour = {1, 0.5, 0},
                                                      .kind = BATTEN_OBJECT_SURFACE,
                                                      .surface = surface}));
    CHECK_OK(batten_model_add(model, &(batten_object){.has_colour = true,
                                                      .colour = {0, 0.25, 0},
                                                      .kind = BATTEN_OBJECT_CURVE,
                                                      .curve = curve}));
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_CONTAINS(text, "COLOUR_RGB('',1.,0.5,0.)");
    CHECK_CONTAINS(text, "COLOUR_RGB('',0.,0.25,0.)");
    CHECK_INT(step_count(text, "STYLED_ITEM"), 2);
    CHECK_INT(step_count(text, "CURVE_STYLE"), 1);
    CHECK_INT(step_count(text, "SURFACE_STYLE_USAGE"), 1);
    batten_model_unref(model);
    batten_curve_unref(curve);
    batten_surface_unref(surface);
}
