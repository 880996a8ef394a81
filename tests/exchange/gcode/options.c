/* What options ask of a program, in units other than the machine's. */
#include "exchange/shapes/paths.h"

static const char *program(const batten_model *model, const batten_write_gcode_options *options,
                           batten_notes *notes)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_write_gcode(model, options, notes, &data, &size));
    char *text = test_array(size + 1, 1);
    memcpy(text, data, size);
    batten_release(data);
    return text;
}

/* A corner of three points at this height. */
static batten_model *corner(double unit, double z)
{
    const double points[] = {0, 0, z, 1, 0, z, 1, 2, z};
    batten_curve *curve = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, 3, points}, &curve));
    CHECK_OK(batten_model_create(unit, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    batten_curve_unref(curve);
    return model;
}

TEST(lengths_and_feeds_of_options_are_in_the_unit_of_the_model)
{
    static const struct {
        double unit;
        const char *program; /* with feed 3, plunge 2, clearance 1, no decimals */
    } cases[] = {
        {0.01, "G0 Z10\n(c)\nG0 X0 Y0\nG1 Z0 F20\nG1 X10 Y0 F30\nG1 X10 Y20\nG0 Z10\nM2\n%\n"},
        {0.001, "G0 Z1\n(c)\nG0 X0 Y0\nG1 Z0 F2\nG1 X1 Y0 F3\nG1 X1 Y2\nG0 Z1\nM2\n%\n"},
        {0, "G0 Z1\n(c)\nG0 X0 Y0\nG1 Z0 F2\nG1 X1 Y0 F3\nG1 X1 Y2\nG0 Z1\nM2\n%\n"},
        {0.0254, "G0 Z1\n(c)\nG0 X0 Y0\nG1 Z0 F2\nG1 X1 Y0 F3\nG1 X1 Y2\nG0 Z1\nM2\n%\n"}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_write_gcode_options options = batten_write_gcode_defaults();
        batten_model *model = corner(cases[i].unit, 0);
        options.feed = 3, options.plunge = 2, options.clearance = 1, options.decimals = 0;
        const char *text = program(model, &options, NULL);
        const char *moves = strstr(text, "G0 Z");
        CHECK(moves != NULL);
        CHECK_TEXT(moves, cases[i].program);
        CHECK((strstr(text, "G20") != NULL) == (cases[i].unit == 0.0254));
        batten_model_unref(model);
    }
}

TEST(without_options_a_metre_a_minute_a_quarter_down_five_millimetres_up)
{
    batten_model *model = corner(0.001, 2);
    const char *text = program(model, NULL, NULL);
    CHECK_TEXT(strstr(text, "G0 Z"),
               "G0 Z7.0000\n(c)\nG0 X0.0000 Y0.0000\nG1 Z2.0000 F250.0000\n"
               "G1 X1.0000 Y0.0000 F1000.0000\nG1 X1.0000 Y2.0000\nG0 Z7.0000\nM2\n%\n");
    batten_model_unref(model);
    model = corner(0.0254, 2);
    text = program(model, NULL, NULL);
    CHECK_CONTAINS(text, "G1 X1.00000 Y0.00000 F39.37008\n");
    CHECK_CONTAINS(text, "G0 Z2.19685\n");
    batten_model_unref(model);
}

TEST(arcs_to_the_left_are_G3_and_those_to_the_right_G2)
{
    batten_model *left = model_of("s", stadium()), *right = model_of("h", hook());
    const char *one = program(left, NULL, NULL), *other = program(right, NULL, NULL);
    CHECK(strstr(one, "G3 X") && !strstr(one, "G2 X"));
    CHECK(strstr(other, "G2 X") && !strstr(other, "G3 X"));
    CHECK_CONTAINS(one, "G3 X90.0000 Y20.0000 I0.0000 J10.0000\n");
    batten_model_unref(left);
    batten_model_unref(right);
}

TEST(what_cannot_be_cut_is_left_out_with_its_reason)
{
    const double leaning[] = {0, 0, 0, 1, 0, 0, 1, 2, 1};
    batten_curve *curve = NULL;
    batten_notes *notes = NULL;
    batten_model *model = corner(0.001, 0);
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(batten_curve_ellipse(2, 1, 0, 1, &curve));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "egg", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    batten_curve_unref(curve);
    CHECK_OK(batten_curve_polyline((batten_points){3, 3, leaning}, &curve));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "up", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    batten_curve_unref(curve);
    program(model, NULL, notes);
    if (!batten_notes_dropped(notes)) {
        /* A second attempt, after memory was missing, says them again. */
        const int first = batten_notes_count(notes) - 2;
        CHECK(first == 0 || first == 2);
        for (int i = 0; i < 2; i++) {
            const batten_note *note = batten_notes_at(notes, first + i);
            CHECK_TEXT(note->entity, i ? "up" : "egg");
            CHECK_INT(note->line, 0);
            CHECK_CONTAINS(note->text, "left out: this curve");
        }
        CHECK_CONTAINS(batten_notes_at(notes, first)->text, "is not a chain of arcs and lines");
    }
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* One option each that cannot be, and what is said of it; NAN as depth is that of the path. */
static const struct {
    double feed, plunge, clearance, depth, radius;
    int decimals;
    const char *words;
} refusals[] = {
    {-1, 2, 3, NAN, 4, 5, "feed -1, plunge 2 and clearance 3 must be finite, 0 or more"},
    {1, -2, 3, NAN, 4, 5, "feed 1, plunge -2 and clearance 3 must be finite, 0 or more"},
    {1, 2, -3, NAN, 4, 5, "feed 1, plunge 2 and clearance -3 must be finite, 0 or more"},
    {INFINITY, 2, 3, NAN, 4, 5, "feed inf, plunge 2 and clearance 3 must be finite, 0 or more"},
    {1, INFINITY, 3, NAN, 4, 5, "feed 1, plunge inf and clearance 3 must be finite, 0 or more"},
    {1, 2, INFINITY, NAN, 4, 5, "feed 1, plunge 2 and clearance inf must be finite, 0 or more"},
    {1, 2, 3, -INFINITY, 4, 5, "the depth is -inf; it must be finite"},
    {1, 2, 3, INFINITY, 4, 5, "the depth is inf; it must be finite"},
    {1, 2, 3, NAN, -4, 5, "the greatest radius is -4; it must be 0 or more"},
    {1, 2, 3, NAN, 4, -2, "-2 decimals; there may be 0 to 9"},
    {1, 2, 3, NAN, 4, 10, "10 decimals; there may be 0 to 9"},
};

TEST(n1_n6_options_that_cannot_be_are_refused_by_name)
{
    batten_model *model = model_of("hook", hook());
    for (int k = 0; k < COUNT(refusals); k++) {
        batten_write_gcode_options options = batten_write_gcode_defaults();
        char *data = NULL;
        size_t size = 0;
        options.feed = refusals[k].feed;
        options.plunge = refusals[k].plunge;
        options.clearance = refusals[k].clearance;
        options.depth = refusals[k].depth;
        options.greatest_radius = refusals[k].radius;
        options.decimals = refusals[k].decimals;
        CHECK_STATUS(batten_write_gcode(model, &options, NULL, &data, &size),
                     BATTEN_BAD_ARGUMENT);
        CHECK_TEXT(batten_message(), refusals[k].words);
        CHECK(data == NULL);
    }
    batten_write_gcode_options options = batten_write_gcode_defaults();
    options.greatest_radius = options.feed = options.plunge = options.clearance =
        options.decimals = 0;
    program(model, &options, NULL);
    options.greatest_radius = INFINITY;
    options.decimals = 9;
    const char *arcs = strstr(program(model, &options, NULL), "\nG2 X");
    CHECK(arcs && strstr(arcs + 1, "\nG2 X"));
    batten_model_unref(model);
}

TEST(defaults_leave_every_value_to_the_unit_and_the_height_to_each_path)
{
    const batten_write_gcode_options options = batten_write_gcode_defaults();
    CHECK_INT(options.size, sizeof options);
    CHECK(options.feed == 0 && options.plunge == 0 && options.clearance == 0);
    CHECK(isnan(options.depth) && options.greatest_radius == 0);
    CHECK_INT(options.decimals, -1);
    CHECK(!options.absolute_centres && !options.relative_moves);
}
