/* What is said of drawings, to the letter and the line; and what elements inherit. */
#include "exchange/listed.h"
#include "exchange/svg/svg.h"

#define SVG "<svg width=\"10mm\" height=\"10mm\" viewBox=\"0 0 10 10\">\n"
#define LINE "<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/>\n"

static const struct {
    const char *text;
    batten_status status;
    const char *listing;
} drawings[] = {
    {SVG LINE "</svg>\n", BATTEN_OK, "~0: line: 1 read\n"},
    {SVG LINE "</svg>\n<!-- a -->\n<!--b--> \n", BATTEN_OK, "~0: line: 1 read\n"},
    {SVG LINE "</svg><!----><!-- -->", BATTEN_OK, "~0: line: 1 read\n"},
    {SVG "<line x1=\"1\" y1=\"2\" x2=\"1\" y2=\"2\"/>\n" LINE "</svg>\n", BATTEN_OK,
     "~2: line: it has no length and makes no curve\n~0: line: 2 read\n"},
    {SVG LINE "<text>a<tspan>b</tspan></text>\n<text/>" LINE "</svg>\n", BATTEN_PARTLY_READ,
     "~0: line: 2 read\n0: text: 0 read, 2 left out\n"},
    {SVG LINE "<svg viewBox=\"0 0 1 1\">" LINE "</svg>\n" LINE "</svg>\n", BATTEN_PARTLY_READ,
     "3: svg: a drawing within the drawing, on a sheet of its own; left out\n"
     "~0: line: 2 read\n0: svg: 0 read, 1 left out\n"},
    {SVG LINE "<defs>" LINE "</defs><title>t</title><style/><symbol>" LINE
              "</symbol>\n</svg>\n",
     BATTEN_OK, "~0: line: 1 read\n"},
    {SVG "<text/><image/>\n</svg>\n", BATTEN_UNSUPPORTED,
     "t: none of its 2 shapes could be read; the first is a 'text'\n"},
    {"<g>" LINE "</g>\n", BATTEN_BAD_FORMAT, "t:1: the drawing does not begin with <svg>\n"},
};

TEST(what_is_wrong_in_a_drawing_is_named_with_its_line)
{
    for (int i = 0; i < COUNT(drawings); i++)
        check_listed(drawings[i].text, BATTEN_FORMAT_SVG, drawings[i].status,
                     drawings[i].listing);
}

static const struct {
    const char *style;
    bool is_hidden, has_colour;
    double red, x;
} looks[] = {
    {"", false, false, 0, 1},
    {"display=\"none\"", true, false, 0, 1},
    {"visibility=\"hidden\"", true, false, 0, 1},
    {"display=\"inline\"", false, false, 0, 1},
    {"style=\"display:none\"", true, false, 0, 1},
    {"style=\"stroke:#ff0000;display:none\"", true, true, 1, 1},
    {"style=\" stroke:#ff0000;\n display:none ; \"", true, true, 1, 1},
    {"style=\"display: none\"", true, false, 0, 1},
    {"style=\"display :\tnone\"", true, false, 0, 1},
    {"display=\" none\n\"", true, false, 0, 1},
    {"style=\"stroke: #ff0000 ;\"", false, true, 1, 1},
    {"style=\"display none;\"", false, false, 0, 1},
    {"style=\":none\"", false, false, 0, 1},
    {"style=\"\" stroke=\"#330000\"", false, true, 0.2, 1},
    {"style=\"fill:red; stroke:#330000\"", false, true, 0.2, 1},
    {"style=\"strokes:#ff0000\"", false, false, 0, 1},
    {"style=\"strok:#ff0000\"", false, false, 0, 1},
    {"style=\"stroke\"", false, false, 0, 1},
    {"style=\"stroke\" stroke=\"#ff0000\"", false, true, 1, 1},
    /* the style before the attribute */
    {"style=\"stroke:#ff0000\" stroke=\"#330000\"", false, true, 1, 1},
    {"style=\";;stroke:#ff0000\"", false, true, 1, 1},
    {"stroke=\"none\"", false, false, 0, 1},
    {"transform=\"translate(2)\"", false, false, 0, 3},
    {"transform=\"none\"", false, false, 0, 1},
    {"style=\"transform:translate(4px,0)\"", false, false, 0, 5},
};

/* The same of an element and of the group around it. */
TEST(an_element_has_the_look_of_its_style_its_attributes_and_its_groups)
{
    for (int i = 0; i < 2 * COUNT(looks); i++) {
        const char *style = looks[i / 2].style;
        char text[400];
        batten_model *model = NULL;
        snprintf(text, sizeof text,
                 SVG "<g %s><line %s x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/></g>" LINE "</svg>",
                 i % 2 ? style : "", i % 2 ? "" : style);
        CHECK_OK(read_text(text, BATTEN_FORMAT_SVG, NULL, &model));
        const batten_object *object = batten_model_object(model, 0),
                            *behind = batten_model_object(model, 1);
        CHECK(object->is_hidden == looks[i / 2].is_hidden);
        CHECK(object->has_colour == looks[i / 2].has_colour);
        if (object->has_colour)
            CHECK_NEAR(object->colour[0], looks[i / 2].red, 1e-15);
        CHECK_NEAR(batten_curve_points(object->curve)[0], looks[i / 2].x, 1e-14);
        CHECK(!behind->is_hidden && !behind->has_colour);
        CHECK_NEAR(batten_curve_points(behind->curve)[0], 1, 1e-14);
        batten_model_unref(model);
    }
}

/* Names of groups follow one another; a shape without a name is called by its number. */
TEST(shapes_have_the_names_of_their_groups_and_parts)
{
    static const struct {
        const char *name, *group, *layer;
    } due[] = {{"line 1", "", ""},      {"keel", "a", "cut"}, {"path 3", "a/b", ""},
               {"path 3.2", "a/b", ""}, {"line 4", "a", ""},  {"line 5", "a", ""},
               {"line 6", "", ""}};
    batten_model *model = NULL;
    CHECK_OK(read_text(SVG LINE "<g id=\"a\"><line id=\"keel\" class=\"cut\" x2=\"3\"/>"
                                "<g id=\"b\"><path d=\"M0 0h1M2 2h1\"/></g>" LINE
                                "<a id=\"c\">" LINE "</a></g>" LINE "</svg>",
                       BATTEN_FORMAT_SVG, NULL, &model));
    CHECK_INT(batten_model_count(model), COUNT(due));
    for (int i = 0; i < COUNT(due); i++) {
        const batten_object *object = batten_model_object(model, i);
        CHECK_TEXT(object->name, due[i].name);
        CHECK_TEXT(object->group, due[i].group);
        CHECK_TEXT(object->layer, due[i].layer);
    }
    batten_model_unref(model);
}

TEST(a_drawing_begins_with_an_element_svg)
{
    static const struct {
        const char *text;
        bool is_svg;
    } cases[] = {{"<svg/>", false},
                 {"<svg>", true},
                 {" \n<svg a=\"1\">", true},
                 {"<!-- c --><svg>", true},
                 {"<?xml version=\"1.0\"?>\n<svg>", true},
                 {"<html>", false},
                 {"<svgs>", false},
                 {"svg>", false},
                 {"<", false},
                 {"", false},
                 {"<g><svg>", false},
                 {"</svg>", false}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_read_options options = batten_read_defaults();
        bat_input input;
        bool is_svg = true;
        CHECK_OK(bat_input_begin(cases[i].text, strlen(cases[i].text), &options, NULL, NULL,
                                 &input));
        CHECK_OK(bat_svg_recognise(&input, &is_svg));
        CHECK(is_svg == cases[i].is_svg);
    }
}
