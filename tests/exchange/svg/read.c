#include "exchange/reading.h"

#include <batten/standard.h>

/* A sheet of 100 mm x 50 mm, one number to a millimetre: (x, y) becomes (x, 50 - y). */
static char *sheet(const char *shapes)
{
    const size_t size = strlen(shapes) + 200;
    char *text = test_array(size, 1);
    snprintf(
        text, size,
        "<?xml version=\"1.0\"?>\n<!-- a > sheet -->\n<svg width=\"100mm\" height=\"50mm\" "
        "viewBox=\"0 0 100 50\">\n%s</svg>\n",
        shapes);
    return text;
}

static batten_model *read_shapes(const char *shapes)
{
    batten_model *model = NULL;
    CHECK_OK(read_text(sheet(shapes), BATTEN_FORMAT_AUTO, NULL, &model));
    return model;
}

static void check_point(const batten_model *model, int index, double s, double x, double y)
{
    const batten_curve *curve = batten_model_object(model, index)->curve;
    const batten_interval domain = batten_curve_domain(curve);
    double p[2];
    CHECK_OK(batten_curve_evaluate(curve, domain.a + s * (domain.b - domain.a), 0, p));
    CHECK_NEAR(p[0], x, 1e-12);
    CHECK_NEAR(p[1], y, 1e-12);
}

TEST(paths_of_lines_are_polylines)
{
    batten_model *model =
        read_shapes("<path id=\"keel\" class=\"cut\" d=\"M10 10 L20 10 h5v5 z\"/>");
    const batten_object *object = batten_model_object(model, 0);
    CHECK_TEXT(object->name, "keel");
    CHECK_TEXT(object->layer, "cut");
    CHECK_BITS(batten_model_unit_metres(model), 0.001);
    CHECK_INT(batten_curve_degree(object->curve), 1);
    CHECK_INT(batten_curve_point_count(object->curve), 5);
    CHECK_BITS(batten_curve_points(object->curve)[7], 35);
    CHECK(batten_curve_is_closed(object->curve, 0));
    batten_model_unref(model);
}

TEST(every_command_of_a_path_draws)
{
    batten_model *model =
        read_shapes("<path d=\"M0,0C0 10 10 10 10 0S20-10 20 0Q25 10 30 0T40 0\"/>");
    check_point(model, 0, 1.0 / 8, 5, 42.5);
    check_point(model, 0, 3.0 / 8, 15, 57.5);
    check_point(model, 0, 5.0 / 8, 25, 45);
    check_point(model, 0, 7.0 / 8, 35, 55);
    batten_model_unref(model);

    /* The same in relative commands, numbers side by side. */
    model = read_shapes("<path d=\"m0 0c0 10 10 10 10 0s10-10 10 0q5 10 10 0t10 0\"/>");
    check_point(model, 0, 3.0 / 8, 15, 57.5);
    check_point(model, 0, 7.0 / 8, 35, 55);
    batten_model_unref(model);

    model = read_shapes("<path d=\"M1 2 3 4m5 5 1 1M.5.5-1-1\"/>");
    CHECK_INT(batten_model_count(model), 3);
    check_point(model, 1, 0, 8, 41);
    check_point(model, 1, 1, 9, 40);
    check_point(model, 2, 0, 0.5, 49.5);
    check_point(model, 2, 1, -1, 51);
    CHECK_TEXT(batten_model_object(model, 0)->name, "path 1");
    CHECK_TEXT(batten_model_object(model, 1)->name, "path 1.2");
    batten_model_unref(model);
}

TEST(arcs_of_paths_lie_on_their_ellipses)
{
    /* All four ways from (10, 20) to (30, 20) about circles of radius 12.5: centres (20, 12.5)
     * and (20, 27.5). Flags stand without blanks in the second. */
    static const struct {
        const char *path;
        double y, middle;
    } cases[] = {{"M10 20 A12.5 12.5 0 0 0 30 20", 12.5, 25},
                 {"M10 20a12.5 12.5 0 0120 0", 27.5, 15},
                 {"M10 20 A12.5 12.5 0 1 0 30 20", 27.5, 40},
                 {"M10 20 A12.5 12.5 0 1 1 30 20", 12.5, 0}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[200];
        snprintf(text, sizeof text, "<path d=\"%s\"/>", cases[i].path);
        batten_model *model = read_shapes(text);
        const batten_curve *curve = batten_model_object(model, 0)->curve;
        const batten_interval domain = batten_curve_domain(curve);
        for (int k = 0; k <= 50; k++) {
            double p[2];
            CHECK_OK(
                batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * k / 50, 0, p));
            CHECK_NEAR(hypot(p[0] - 20, 50 - p[1] - cases[i].y), 12.5, 1e-12);
        }
        check_point(model, 0, 0.5, 20, 50 - cases[i].middle);
        batten_model_unref(model);
    }
    /* Radii that are too small grow: half a circle. */
    batten_model *model = read_shapes("<path d=\"M10 20 A1 1 0 0 1 30 20\"/>");
    check_point(model, 0, 0.5, 20, 40);
    batten_model_unref(model);
    /* A turned ellipse. */
    model = read_shapes("<path d=\"M10 20 A20 5 90 0 1 10 60\"/>");
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    double p[2];
    CHECK_OK(batten_curve_evaluate(curve, batten_curve_domain(curve).b / 2, 0, p));
    CHECK_NEAR(p[0], 15, 1e-12);
    batten_model_unref(model);
}

TEST(arcs_that_cannot_be_computed_are_noted_and_keep_what_stands_before)
{
    static const char *const ends[] = {"A1e-310 1e-310 0 0 1 1e10 3",
                                       "A1e-300 1e300 0 0 1 30 20",
                                       "A1e300 1e-300 30 1 1 30 20"};
    for (int i = 0; i < COUNT(ends); i++) {
        char text[200];
        batten_model *model = NULL;
        snprintf(text, sizeof text, "<path d=\"M1 2L3 4%s\"/>", ends[i]);
        CHECK_STATUS(read_text(sheet(text), BATTEN_FORMAT_AUTO, NULL, &model),
                     BATTEN_PARTLY_READ);
        CHECK_INT(batten_model_count(model), 1);
        CHECK_INT(batten_curve_point_count(batten_model_object(model, 0)->curve), 2);
        batten_model_unref(model);
    }
    /* Half axes that are too long by far are an arc still, all but straight. */
    batten_model *model = read_shapes("<path d=\"M10 20A1e12 1e12 0 0 1 30 20\"/>");
    check_point(model, 0, 1, 30, 30);
    batten_model_unref(model);
}

TEST(shapes_are_curves)
{
    batten_model *model =
        read_shapes("<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/>"
                    "<rect x=\"10\" y=\"10\" width=\"20\" height=\"5\"/>"
                    "<rect x=\"10\" y=\"10\" width=\"20\" height=\"8\" rx=\"2\"/>"
                    "<circle cx=\"50\" cy=\"25\" r=\"10\"/>"
                    "<ellipse cx=\"50\" cy=\"25\" rx=\"10\" ry=\"5\"/>"
                    "<polyline points=\"0,0 1,1 2,0\"/>"
                    "<polygon points=\"0,0 1,1 2,0\"/>");
    CHECK_INT(batten_model_count(model), 7);
    check_point(model, 0, 0.5, 2, 47);
    CHECK_INT(batten_curve_point_count(batten_model_object(model, 1)->curve), 5);
    CHECK(batten_curve_is_closed(batten_model_object(model, 2)->curve, 1e-12));
    CHECK_INT(batten_curve_degree(batten_model_object(model, 2)->curve), 3);
    check_point(model, 3, 0, 60, 25);
    check_point(model, 3, 0.5, 40, 25);
    check_point(model, 4, 0.25, 50, 20);
    CHECK(!batten_curve_is_closed(batten_model_object(model, 5)->curve, 0));
    CHECK(batten_curve_is_closed(batten_model_object(model, 6)->curve, 0));
    batten_model_unref(model);
}

TEST(groups_hand_down_places_colours_and_names)
{
    batten_model *model =
        read_shapes("<g id=\"frames\" transform=\"translate(10 0)\" stroke=\"#ff0000\">"
                    "<g id=\"aft\" transform=\"scale(2)\" style=\"display:none\">"
                    "<line x1=\"1\" y1=\"1\" x2=\"2\" y2=\"1\"/></g>"
                    "<line id=\"a &amp; b\" x1=\"1\" y1=\"1\" x2=\"2\" y2=\"1\" "
                    "style=\"fill:none;stroke: rgb(0, 128, 255)\"/></g>"
                    "<line x1=\"1\" y1=\"0\" x2=\"1\" y2=\"1\" transform=\"rotate(90)\"/>");
    const batten_object *o = batten_model_object(model, 0);
    CHECK_TEXT(o->group, "frames/aft");
    CHECK(o->is_hidden && o->has_colour && o->colour[0] == 1);
    check_point(model, 0, 0, 12, 48);
    o = batten_model_object(model, 1);
    CHECK_TEXT(o->group, "frames");
    CHECK_TEXT(o->name, "a & b");
    CHECK(!o->is_hidden);
    CHECK_NEAR(o->colour[1], 128 / 255.0, 1e-15);
    CHECK_TEXT(batten_model_object(model, 2)->group, "");
    check_point(model, 2, 0, 0, 49);
    check_point(model, 2, 1, -1, 49);
    batten_model_unref(model);
}

TEST(the_sheet_says_how_large_numbers_are)
{
    static const struct {
        const char *head;
        double x; /* of a line that ends at 96 */
    } cases[] = {{"<svg>", 25.4},
                 {"<svg width=\"96\" height=\"96\">", 25.4},
                 {"<svg width=\"192px\" height=\"192px\" viewBox=\"0 0 96 96\">", 50.8},
                 {"<svg width=\"1in\" height=\"1in\" viewBox=\"0 0 96 96\">", 25.4},
                 {"<svg width=\"9.6cm\" viewBox=\"0 0 96 10\">", 96},
                 {"<svg:svg width='96mm' height='96mm' viewBox='-96 0 192 192'>", 96}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[256];
        batten_model *model = NULL;
        snprintf(text, sizeof text, "%s<line x1=\"0\" y1=\"0\" x2=\"96\" y2=\"0\"/></%s",
                 cases[i].head, i == 5 ? "svg:svg>" : "svg>");
        CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, NULL, &model));
        const double *p = batten_curve_points(batten_model_object(model, 0)->curve);
        CHECK_NEAR(p[2], cases[i].x, 1e-12);
        batten_model_unref(model);
    }
}

TEST(what_is_only_there_to_be_used_is_not_drawn)
{
    batten_model *model = read_shapes(
        "<defs><path d=\"M0 0L1 1\"/><g><path d=\"M0 0L1 1\"/></g></defs>"
        "<style>path > g { stroke: red }</style><![CDATA[ <path d=\"M0 0L1 1\"/> ]]>"
        "<path d=\"M0 0L1 1\"><title>a line</title></path>");
    CHECK_INT(batten_model_count(model), 1);
    batten_model_unref(model);
}

TEST(P2_a_bad_shape_is_left_out_and_the_next_is_read)
{
    static const struct {
        const char *shape, *words;
    } cases[] = {
        {"<path d=\"L1 1\"/>", "the path is broken at its character 1"},
        {"<path d=\"M0 0L1 1L2\"/>", "the path is broken at its character 9"},
        {"<path d=\"M0 0X1 1\"/>", "broken at its character 5"},
        {"<path d=\"M0 0L1e999 1\"/>", "broken"},
        {"<path d=\"M0 0L1 1\" transform=\"turn(3)\"/>", "the transform has 'turn'"},
        {"<path d=\"M0 0L1 1\" transform=\"matrix(1 2 3)\"/>", "'matrix' with 3 numbers"},
        {"<circle r=\"-1\"/>", "its half axes are -1 and -1"},
        {"<rect width=\"0\" height=\"5\"/>", "it is 0 wide"},
        {"<polyline points=\"1 1\"/>", "it has 1 point"},
        {"<text x=\"1\" y=\"2\">hello</text>", "0 read, 1 left out"},
        {"<polyline points=\"1 1 2 2 3\"/>", "its points are broken after the first 2; what"},
        {"<polygon points=\"1 1 2 2, 3 3 x\"/>", "its points are broken after the first 3"},
        {"<path d=\"M0 0L1 1L2\"/>", "what stands before it is kept"},
        {"<circle r=\"50%\"/>", "its r is '50%', which is not a length"},
        {"<rect width=\"wide\" height=\"1\"/>", "its width is 'wide', which is not a length"},
        {"<svg viewBox=\"0 0 1 1\"><path d=\"M0 0L1 1\"/></svg>", "on a sheet of its own"},
        {"<use href=\"#a\"/>", "0 read, 1 left out"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[300];
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        snprintf(text, sizeof text, "%s<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/>",
                 cases[i].shape);
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_STATUS(read_text(sheet(text), BATTEN_FORMAT_SVG, notes, &model),
                     BATTEN_PARTLY_READ);
        if (!batten_notes_dropped(notes))
            CHECK(has_note(notes, cases[i].words));
        const int last = batten_model_count(model) - 1;
        check_point(model, last, 0.5, 2, 47);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(lengths_of_shapes_have_units)
{
    batten_model *model = read_shapes("<line x1=\"1in\" y1=\"2.54cm \" x2=\"96px\" y2=\"0\"/>"
                                      "<circle cx=\"1\" cy=\"1\" r=\"1pc\"/>");
    check_point(model, 0, 0, 96, 50 - 96);
    check_point(model, 0, 1, 96, 50);
    check_point(model, 1, 0, 17, 49);
    batten_model_unref(model);
}

/* A unit square on a sheet of 9 x 7 mm: its lower left corner, where y is 1 downwards, and its
 * size along and up. */
TEST(a_drawing_fits_on_its_sheet_as_it_says)
{
    static const struct {
        const char *said;
        double x, y, along, up;
        const char *note;
    } fits[] = {{"none", 0, 0, 9, 7, ""},
                {"xMidYMid", 1, 0, 7, 7, ""},
                {"xMinYMin meet", 0, 0, 7, 7, ""},
                {" xMaxYMid  meet ", 2, 0, 7, 7, ""},
                {"xMidYMid slice", 0, -1, 9, 9, ""},
                {"xMinYMin slice", 0, -2, 9, 9, ""},
                {"xMaxYMax slice", 0, 0, 9, 9, ""},
                {"middle", 1, 0, 7, 7, "is not understood"},
                {"xMidYMid meet slice", 1, 0, 7, 7, "is not understood"}};
    for (int i = 0; i < COUNT(fits); i++) {
        char text[300];
        snprintf(text, sizeof text,
                 "<svg width=\"9mm\" height=\"7mm\" viewBox=\"0 0 1 1\" "
                 "preserveAspectRatio=\"%s\"><path d=\"M0 1L1 0\"/></svg>",
                 fits[i].said);
        batten_model *model = read_noting(text, BATTEN_FORMAT_SVG, fits[i].note);
        check_point(model, 0, 0, fits[i].x, fits[i].y);
        check_point(model, 0, 1, fits[i].x + fits[i].along, fits[i].y + fits[i].up);
        batten_model_unref(model);
    }
}

TEST(a_style_may_transform)
{
    batten_model *model =
        read_shapes("<path style=\"stroke:red; transform: translate(2px, 3px) rotate(90deg)\" "
                    "transform=\"scale(9)\" d=\"M0 0L4 0\"/>"
                    "<path style=\"transform:none\" d=\"M1 1L4 0\"/>");
    check_point(model, 0, 0, 2, 50 - 3);
    check_point(model, 0, 1, 2, 50 - 7);
    check_point(model, 1, 0, 1, 49);
    batten_model_unref(model);
}

TEST(shapes_without_length_are_remarked_on)
{
    batten_model *model = read_noting(sheet("<line x1=\"1\" x2=\"1\"/><path d=\"\"/>"),
                                      BATTEN_FORMAT_SVG, "it has no length");
    CHECK_INT(batten_model_count(model), 0);
    batten_model_unref(model);
}

TEST(F7_after_the_end_of_a_drawing_only_comments_may_stand)
{
    static const struct {
        const char *tail, *words;
    } cases[] = {{"\n<!-- <g> -->\n<!---->", ""},
                 {"<svg/>", "6 bytes follow where the file should end"},
                 {"<!-- no end", ""},
                 {" text", "4 bytes follow"},
                 {"\x1a", ""}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[400];
        snprintf(text, sizeof text, "%s%s", sheet("<path d=\"M0 0L1 1\"/>"), cases[i].tail);
        batten_model_unref(read_noting(text, BATTEN_FORMAT_SVG, cases[i].words));
    }
}

TEST(references_by_number_are_what_they_mean)
{
    batten_model *model = read_noting(
        sheet("<path id=\"&#x4c;&#228;&#38;&amp;#49;&#34;\" d=\"M0 0&#76;&#x31;0 0\"/>"),
        BATTEN_FORMAT_SVG, "");
    const batten_object *object = batten_model_object(model, 0);
    const batten_box box = batten_curve_box(object->curve);
    CHECK_TEXT(object->name, "L\xC3\xA4&&#49;\"");
    CHECK(box.high.x - box.low.x > 9 * (box.high.y - box.low.y));
    batten_model_unref(model);
    /* What is no reference stays as it is. */
    model = read_noting(sheet("<path id=\"&#;&#x110000;&#9\" d=\"M0 0L1 1\"/>"),
                        BATTEN_FORMAT_SVG, "");
    CHECK_TEXT(batten_model_object(model, 0)->name, "&#;&#x110000;&#9");
    batten_model_unref(model);
}

TEST(S4_groups_within_groups_have_a_limit)
{
    enum { DEEP = 100000 };
    char *text = test_array(8 * DEEP + 100, 1);
    size_t at = (size_t)snprintf(text, 100, "<svg><path id=\"shown\" d=\"M0 0L1 1\"/>");
    for (int i = 0; i < DEEP; i++)
        at += (size_t)snprintf(text + at, 4, "<g>");
    at += (size_t)snprintf(text + at, 40, "<path d=\"M0 0L1 1\"/>");
    for (int i = 0; i < DEEP; i++)
        at += (size_t)snprintf(text + at, 5, "</g>");
    snprintf(text + at, 10, "</svg>");
    batten_model *model =
        read_so(text, BATTEN_FORMAT_SVG, BATTEN_PARTLY_READ, "nested deeper than 64 groups");
    CHECK_INT(batten_model_count(model), 1);
    CHECK_TEXT(batten_model_object(model, 0)->name, "shown");
    batten_model_unref(model);
}

TEST(a_drawing_without_a_shape_that_is_read_says_of_what_it_is)
{
    check_refused(sheet("<use href=\"#a\"/><text>b</text>"), BATTEN_FORMAT_SVG,
                  BATTEN_UNSUPPORTED,
                  "none of its 2 shapes could be read; the first is a 'use'");
}

TEST(F2_a_drawing_cut_anywhere_is_never_whole)
{
    const char *text = sheet("<g><path d=\"M0 0L1 1\"/></g><circle r=\"3\"/>");
    const size_t size = strlen(text);
    for (size_t length = 5; length < size - 7; length++) {
        batten_model *model = NULL;
        CHECK(read_bytes(text, length, BATTEN_FORMAT_SVG, NULL, &model) != BATTEN_OK);
        batten_model_unref(model);
    }
}

TEST(what_is_written_as_svg_reads_back_at_its_size)
{
    const batten_frame world = batten_frame_world();
    const double polygon[] = {0, 0, 0.03, 0.01, 0.05, 0.04};
    batten_curve *arc = NULL, *line = NULL;
    batten_model *model = NULL, *back = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_curve_arc_in(&world, 0.02, 0, 3, &arc));
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, polygon}, &line));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "arc", .kind = BATTEN_OBJECT_CURVE, .curve = arc}));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "line", .kind = BATTEN_OBJECT_CURVE, .curve = line}));
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_SVG, &data, &size));
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_INT(batten_model_count(back), 2);
    CHECK_TEXT(batten_model_object(back, 0)->name, "arc");
    /* The lower left corner is the origin: only differences are kept. */
    const double *p = batten_curve_points(batten_model_object(back, 1)->curve);
    CHECK_NEAR(p[4] - p[0], 50, 1e-9);
    CHECK_NEAR(p[5] - p[1], 40, 1e-9);
    const batten_curve *read = batten_model_object(back, 0)->curve;
    for (int i = 0; i <= 10; i++) {
        double at[2];
        CHECK_OK(batten_curve_evaluate(read, batten_curve_domain(read).b * i / 10, 0, at));
        CHECK_NEAR(hypot(at[0] - p[0], at[1] - p[1]), 20, 1e-9);
    }
    batten_release(data);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_curve_unref(arc);
    batten_curve_unref(line);
}
