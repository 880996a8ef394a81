/* What is written of each kind of curve, to the letter, and what is said of it. */
#include "exchange/reading.h"
#include "exchange/shapes/paths.h"

#define SHEET(width, height)                                                           \
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" width "mm\" height=\"" height \
    "mm\" viewBox=\"0 0 " width " " height "\">\n"
#define PATH "<path fill=\"none\" stroke-width=\"0.1\" stroke=\"#000000\""

static batten_curve *polyline(int dimension, int count, const double *points)
{
    batten_curve *made = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){dimension, count, points}, &made));
    return made;
}

static batten_curve *bezier(int dimension, int degree, const double *points,
                            const double *weights)
{
    static const double knots[8][8] = {
        {0}, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}};
    batten_curve *made = NULL;
    CHECK_OK(batten_curve_create((batten_points){dimension, degree + 1, points}, degree,
                                 weights, knots[degree], &made));
    return made;
}

/* The curve, whose reference is given back, in a model of that unit. */
static void check_written(batten_curve *curve, double unit, const char *expected)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(unit, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    CHECK_TEXT(written(model, BATTEN_FORMAT_SVG), expected);
    batten_model_unref(model);
    batten_curve_unref(curve);
}

/* The sheet reaches 5 mm beyond the points of the curve; y counts down from its top. */
TEST(lines_are_drawn_at_full_size_on_a_sheet_with_a_margin)
{
    static const double line[] = {1, 2, 11, 22}, triangle[] = {0, 0, 30, 0, 0, 40, 0, 0};
    check_written(polyline(2, 2, line), 0.001,
                  SHEET("20", "30") PATH " d=\"M5 25L15 5\"/>\n</svg>\n");
    check_written(polyline(2, 2, line), 0,
                  SHEET("20", "30") PATH " d=\"M5 25L15 5\"/>\n</svg>\n");
    check_written(polyline(2, 2, line), 0.01,
                  SHEET("110", "210") PATH " d=\"M5 205L105 5\"/>\n</svg>\n");
    check_written(polyline(2, 4, triangle), 0.001,
                  SHEET("40", "50") PATH " d=\"M5 45L35 45L5 5L5 45Z\"/>\n</svg>\n");
}

/* Seen along z, the height is lost; looking down the sense of arcs is turned. */
TEST(curves_in_space_are_drawn_as_seen_along_z)
{
    static const double level[] = {0, 0, 7, 10, 0, 7, 10, 10, 7};
    static const double rising[] = {0, 0, 0, 10, 0, 5, 10, 10, 5};
    check_written(polyline(3, 3, level), 0.001,
                  SHEET("20", "20") PATH " d=\"M5 15L15 15L15 5\"/>\n</svg>\n");
    check_written(polyline(3, 3, rising), 0.001,
                  SHEET("20", "20") PATH " d=\"M5 15C8.333333333333334 15 11.666666666666666 15"
                                         " 15 15C15 11.666666666666666 15 8.333333333333334 15 "
                                         "5\"/>\n</svg>\n");
}

TEST(arcs_of_circles_are_arcs_that_turn_as_seen)
{
    const batten_frame up = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const batten_frame down = {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}};
    for (int i = 0; i < 2; i++) {
        batten_curve *half = NULL;
        batten_model *model = NULL;
        double x = 0, y = 0, r[2] = {0, 0};
        int sweep = -1;
        CHECK_OK(batten_curve_arc_in(i ? &down : &up, 10, 0, 2, &half));
        model = model_of_curve(half, "");
        const char *at = strchr(strstr(written(model, BATTEN_FORMAT_SVG), " d=\"M"), 'A');
        CHECK(at && sscanf(at, "A%lf %lf 0 0 %d %lf %lf", &r[0], &r[1], &sweep, &x, &y) == 5);
        CHECK_INT(sweep, i); /* counter-clockwise is 0, for y counts down */
        CHECK_NEAR(r[0], 10, 1e-12);
        CHECK_NEAR(r[1], 10, 1e-12);
        batten_model_unref(model);
    }
}

TEST(cubics_are_cubics_and_lower_degrees_are_raised_to_them)
{
    static const double parabola[] = {0, 0, 15, 30, 30, 0},
                        cubic[] = {0, 0, 0, 10, 20, 20, 20, 0};
    static const double half[] = {0.5, 0.5, 0.5, 0.5};
    check_written(bezier(2, 3, cubic, NULL), 0.001,
                  SHEET("30", "30") PATH " d=\"M5 25C5 15 25 5 25 25\"/>\n</svg>\n");
    check_written(bezier(2, 3, cubic, half), 0.001,
                  SHEET("30", "30") PATH " d=\"M5 25C5 15 25 5 25 25\"/>\n</svg>\n");
    check_written(bezier(2, 2, parabola, NULL), 0.001,
                  SHEET("40", "40") PATH " d=\"M5 35C15 15 25 15 35 35\"/>\n</svg>\n");
}

TEST(a_shape_has_its_colour_name_layer_and_whether_it_is_shown)
{
    static const double line[] = {0, 0, 10, 0};
    const struct {
        batten_object object;
        const char *attributes;
    } cases[] = {
        {{.name = "a"}, "#000000\" id=\"a\" d="},
        {{.name = "", .layer = "l"}, "#000000\" class=\"l\" d="},
        {{.name = "a", .layer = "l", .is_hidden = true},
         "#000000\" id=\"a\" class=\"l\" display=\"none\" d="},
        {{.name = "", .has_colour = true, .colour = {1, 0.5, 0.2}}, "#ff8033\" d="},
        {{.name = "", .has_colour = true, .colour = {0.07, 0, 0.999}}, "#1200ff\" d="},
        {{.name = "", .has_colour = false, .colour = {1, 1, 1}}, "#000000\" d="},
        {{.name = "a&b<c\"d>e\nf"}, "#000000\" id=\"a&amp;b&lt;c&quot;d>e_f\" d="},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_curve *curve = polyline(2, 2, line);
        batten_model *model = NULL;
        char expected[200];
        batten_object object = cases[i].object;
        object.kind = BATTEN_OBJECT_CURVE;
        object.curve = curve;
        CHECK_OK(batten_model_create(0.001, &model));
        CHECK_OK(batten_model_add(model, &object));
        snprintf(expected, sizeof expected,
                 "<path fill=\"none\" stroke-width=\"0.1\" stroke=\"%s\"M5 5L15 5\"/>\n",
                 cases[i].attributes);
        CHECK_CONTAINS(written(model, BATTEN_FORMAT_SVG), expected);
        batten_model_unref(model);
        batten_curve_unref(curve);
    }
}

/* ---- what is said ---- */

/* A flat line, and the curve, whose reference is given back; all notes but remarks, one a line. */
static void check_said(batten_curve *curve, const char *expected)
{
    static const double line[] = {0, 0, 10, 10};
    batten_curve *beside = polyline(2, 2, line);
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    batten_write_options options = batten_write_defaults();
    char *data = NULL, *list = test_array(1000, 1), *at = list;
    size_t size = 0;
    options.format = BATTEN_FORMAT_SVG;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_notes_create(9, &notes));
    const batten_object objects[] = {
        {.name = "beside", .kind = BATTEN_OBJECT_CURVE, .curve = beside},
        {.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = curve}};
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &objects[i]));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    for (int i = 0; i < batten_notes_count(notes); i++)
        if (!batten_notes_at(notes, i)->is_remark)
            at += sprintf(at, "%s: %s\n", batten_notes_at(notes, i)->entity,
                          batten_notes_at(notes, i)->text);
    if (test_cases(1000) >= 1000)
        CHECK_TEXT(list, expected);
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
    batten_curve_unref(beside);
    batten_curve_unref(curve);
}

TEST(what_a_drawing_loses_is_said_of_each_curve)
{
    static const double level[] = {0, 0, 7, 10, 5, 7}, rising[] = {0, 0, 1, 10, 5, 3};
    static const double upright[] = {3, 4, 1, 3, 4, 5};
    check_said(polyline(3, 2, level), "");
    check_said(polyline(3, 2, rising),
               "c: it is drawn as seen along z; its extent from z = 1 to 3 is lost\n");
    check_said(polyline(3, 2, upright), "c: left out: this curve is one point of the sheet\n");
}

TEST(a_curve_of_one_coordinate_lies_in_no_plane)
{
    check_said(polyline(1, 2, (double[]){0, 1}), "c: left out: this curve lies in no plane\n");
}

/* A quarter of a circle whose weights are 1, 1, 2 is an arc as one of 1, w, 1 is. */
TEST(a_conic_whose_weights_are_uneven_is_an_arc_and_a_rational_cubic_is_approximated)
{
    static const double quarter[] = {10, 0, 10, 10, 0, 10}, uneven[] = {1, 1, 2};
    static const double cubic[] = {0, 0, 0, 10, 20, 20, 20, 0}, rising[] = {1, 2, 3, 4};
    batten_model *model = model_of_curve(bezier(2, 2, quarter, uneven), "");
    const char *path = strstr(written(model, BATTEN_FORMAT_SVG), " d=\"M");
    double r[2] = {0, 0};
    CHECK(strchr(path, 'A') && sscanf(strchr(path, 'A'), "A%lf %lf", &r[0], &r[1]) == 2);
    CHECK_NEAR(r[0], 10, 1e-12);
    CHECK_NEAR(r[1], 10, 1e-12);
    batten_model_unref(model);
    model = model_of_curve(bezier(2, 3, cubic, rising), "");
    path = strstr(written(model, BATTEN_FORMAT_SVG), " d=\"M");
    CHECK(strchr(path, 'C') && strchr(strchr(path, 'C') + 1, 'C'));
    batten_model_unref(model);
}
