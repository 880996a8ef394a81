/* Colours, layers, groups, what is hidden, and names. */
#include "exchange/step/boxes.h"

static const double ORIGIN[] = {0, 0, 0};

/* A box #1000 and a line #1100 in a curve set #1101, with what the text says of their looks. */
static const char *text_with(const char *looks)
{
    box_text text;
    box_shell(box_begin(&text), 1, ORIGIN, 1, 0);
    box_add(&text, "#1000=MANIFOLD_SOLID_BREP('box',#181);\n"
                   "#1100=POLYLINE('keel',(#1,#2));\n"
                   "#1101=GEOMETRIC_CURVE_SET('set',(#1100));\n"
                   "#1110=COLOUR_RGB('',0.25,0.5,0.75);\n"
                   "#1111=DRAUGHTING_PRE_DEFINED_COLOUR('red');\n"
                   "#1120=FILL_AREA_STYLE_COLOUR('',#1110);\n"
                   "#1121=FILL_AREA_STYLE('',(#1120));\n"
                   "#1122=SURFACE_STYLE_FILL_AREA(#1121);\n"
                   "#1123=SURFACE_SIDE_STYLE('',(#1122));\n"
                   "#1124=SURFACE_STYLE_USAGE(.BOTH.,#1123);\n"
                   "#1125=PRESENTATION_STYLE_ASSIGNMENT((#1124));\n"
                   "#1130=CURVE_STYLE('',$,POSITIVE_LENGTH_MEASURE(0.1),#1111);\n"
                   "#1131=PRESENTATION_STYLE_ASSIGNMENT((#1130));\n"
                   "#1140=SURFACE_SIDE_STYLE('',(#1141));\n"
                   "#1141=SURFACE_STYLE_RENDERING_WITH_PROPERTIES($,#1111,(#1142));\n"
                   "#1142=SURFACE_STYLE_TRANSPARENT(0.5);\n"
                   "#1143=SURFACE_STYLE_USAGE(.BOTH.,#1140);\n"
                   "#1144=PRESENTATION_STYLE_ASSIGNMENT((#1143,#1130));\n");
    for (const char *line = looks; *line; line += strcspn(line, "\n") + 1)
        box_add(&text, "%.*s\n", (int)strcspn(line, "\n"), line);
    box_context(&text, 900);
    box_add(&text, "#990=SHAPE_REPRESENTATION('',(#1000,#1101),#900);\n");
    return box_end(&text);
}

static batten_model *read_with(const char *looks)
{
    batten_model *model = NULL;
    const char *file = text_with(looks);
    CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
    CHECK_INT(batten_model_count(model), 2);
    CHECK_TEXT(batten_model_object(model, 0)->name, "box");
    CHECK_TEXT(batten_model_object(model, 1)->name, "keel");
    return model;
}

static void check_colour(bool has, const double colour[3], double r, double g, double b)
{
    CHECK(has);
    CHECK_BITS(colour[0], r);
    CHECK_BITS(colour[1], g);
    CHECK_BITS(colour[2], b);
}

TEST(colours_of_solids_faces_and_curves_are_read)
{
    batten_model *model = read_with("#1200=STYLED_ITEM('',(#1125),#1000);\n"
                                    "#1201=STYLED_ITEM('',(#1131),#1100);\n"
                                    "#1202=STYLED_ITEM('',(#1144),#152);\n");
    const batten_object *box = batten_model_object(model, 0),
                        *line = batten_model_object(model, 1);
    const batten_body_parts *parts = batten_body_view(box->body);
    check_colour(box->has_colour, box->colour, 0.25, 0.5, 0.75);
    check_colour(line->has_colour, line->colour, 1, 0, 0);
    check_colour(parts->faces[1].has_colour, parts->faces[1].colour, 1, 0, 0);
    CHECK(!parts->faces[0].has_colour);
    batten_model_unref(model);
}

TEST(an_overriding_style_counts_wherever_it_stands)
{
    static const char *const looks[] = {
        "#1200=STYLED_ITEM('',(#1125),#1000);\n"
        "#1201=OVER_RIDING_STYLED_ITEM('',(#1144),#1000,#1200);\n",
        "#1200=OVER_RIDING_STYLED_ITEM('',(#1144),#1000,#1201);\n"
        "#1201=STYLED_ITEM('',(#1125),#1000);\n",
        "#1200=STYLED_ITEM('',(#1144),#181);\n"};
    for (int k = 0; k < COUNT(looks); k++) {
        batten_model *model = read_with(looks[k]);
        const batten_object *box = batten_model_object(model, 0);
        check_colour(box->has_colour, box->colour, 1, 0, 0);
        batten_model_unref(model);
    }
}

TEST(styles_that_lead_nowhere_or_in_rings_have_no_effect)
{
    batten_model *model = read_with("#1200=STYLED_ITEM('',(#1300),#1000);\n"
                                    "#1300=PRESENTATION_STYLE_ASSIGNMENT((#1301,#1302));\n"
                                    "#1301=FILL_AREA_STYLE('',(#1301,#1303));\n"
                                    "#1302=SURFACE_STYLE_USAGE(.BOTH.,$);\n"
                                    "#1303=COLOUR_RGB('',.T.,0.,0.);\n"
                                    "#1201=STYLED_ITEM('',(#1125),#7777);\n"
                                    "#1202=STYLED_ITEM('',(NULL_STYLE(.NULL.)),#1100);\n");
    CHECK(!batten_model_object(model, 0)->has_colour);
    CHECK(!batten_model_object(model, 1)->has_colour);
    batten_model_unref(model);
}

TEST(layers_come_from_items_faces_and_styles)
{
    static const char *const members[] = {"#1000", "#181", "#1200",
                                          "#151,#152,#153,#154,#155,#156"};
    for (int k = 0; k < COUNT(members); k++) {
        char looks[400];
        snprintf(looks, sizeof looks,
                 "#1200=STYLED_ITEM('',(#1125),#1000);\n"
                 "#1210=PRESENTATION_LAYER_ASSIGNMENT('hull','',(%s));\n"
                 "#1211=PRESENTATION_LAYER_ASSIGNMENT('lines','',(#1101));\n",
                 members[k]);
        batten_model *model = read_with(looks);
        CHECK_TEXT(batten_model_object(model, 0)->layer, "hull");
        CHECK_TEXT(batten_model_object(model, 1)->layer, "lines");
        CHECK(!batten_model_object(model, 0)->is_hidden);
        batten_model_unref(model);
    }
}

TEST(a_layer_that_only_some_faces_have_is_noted_and_not_taken)
{
    static const struct {
        const char *looks, *layer, *words;
    } cases[] = {
        {"#1210=PRESENTATION_LAYER_ASSIGNMENT('hull','',(#151));\n", "",
         "1 of its 6 faces are on the layer 'hull'"},
        {"#1210=PRESENTATION_LAYER_ASSIGNMENT('hull','',(#153,#154));\n"
         "#1211=PRESENTATION_LAYER_ASSIGNMENT('body','',(#1000,#155));\n",
         "body", "2 of its 6 faces are on the layer 'hull'"},
        {"#1210=PRESENTATION_LAYER_ASSIGNMENT('hull','',(#151,#152,#153));\n"
         "#1211=PRESENTATION_LAYER_ASSIGNMENT('body','',(#154,#155,#156));\n",
         "", "3 of its 6 faces are on the layer 'hull'"},
        {"#1210=PRESENTATION_LAYER_ASSIGNMENT('hull','',(#151,#1000));\n", "hull", ""}};
    for (int k = 0; k < COUNT(cases); k++) {
        batten_model *model =
            read_noting(text_with(cases[k].looks), BATTEN_FORMAT_STEP, cases[k].words);
        CHECK_TEXT(batten_model_object(model, 0)->layer, cases[k].layer);
        batten_model_unref(model);
    }
}

TEST(what_is_invisible_needs_no_style)
{
    batten_model *model = read_with("#1210=PRESENTATION_LAYER_ASSIGNMENT('hull','',(#1000));\n"
                                    "#1220=INVISIBILITY((#1210));\n");
    CHECK(batten_model_object(model, 0)->is_hidden);
    CHECK(!batten_model_object(model, 1)->is_hidden);
    batten_model_unref(model);
}

TEST(what_is_invisible_is_hidden)
{
    static const char *const looks[] = {
        "#1220=INVISIBILITY((#1200));\n", "#1220=INVISIBILITY((#1210));\n",
        "#1220=INVISIBILITY((#1000));\n", "#1220=INVISIBILITY((#990));\n"};
    for (int k = 0; k < COUNT(looks); k++) {
        char text[400];
        snprintf(text, sizeof text,
                 "#1200=STYLED_ITEM('',(#1125),#1000);\n"
                 "#1210=PRESENTATION_LAYER_ASSIGNMENT('hull','',(#1000));\n%s",
                 looks[k]);
        batten_model *model = read_with(text);
        CHECK(batten_model_object(model, 0)->is_hidden);
        CHECK_INT(batten_model_object(model, 1)->is_hidden, k == 3);
        batten_model_unref(model);
    }
}

TEST(groups_lie_in_groups)
{
    batten_model *model = read_with("#1200=GROUP('ship','');\n#1201=GROUP('hull','');\n"
                                    "#1202=GROUP_RELATIONSHIP('','',#1200,#1201);\n"
                                    "#1203=APPLIED_GROUP_ASSIGNMENT(#1201,(#1000));\n"
                                    "#1204=APPLIED_GROUP_ASSIGNMENT(#1200,(#1101));\n");
    CHECK_TEXT(batten_model_object(model, 0)->group, "ship/hull");
    CHECK_TEXT(batten_model_object(model, 1)->group, "ship");
    batten_model_unref(model);
    model = read_with("#1200=GROUP('a','');\n#1201=GROUP('b','');\n"
                      "#1202=GROUP_RELATIONSHIP('','',#1200,#1201);\n"
                      "#1203=GROUP_RELATIONSHIP('','',#1201,#1200);\n"
                      "#1204=APPLIED_GROUP_ASSIGNMENT(#1200,(#1000));\n");
    CHECK(strlen(batten_model_object(model, 0)->group) <= 2 * 64);
    batten_model_unref(model);
}

/* Up to 64 groups around one another, outermost first; of two groups an item lies in the first. */
TEST(the_path_of_a_group_has_up_to_64_names)
{
    for (int count = 63; count <= 65; count++) {
        char *text = test_array(20000, 1), *at = text, due[400] = "";
        for (int i = 0; i < count; i++) {
            at += sprintf(at, "#%d=GROUP('%c','');\n", 1200 + i, 'a' + i % 26);
            if (i > 0)
                at += sprintf(at, "#%d=GROUP_RELATIONSHIP('','',#%d,#%d);\n", 1300 + i,
                              1199 + i, 1200 + i);
        }
        sprintf(at,
                "#1400=APPLIED_GROUP_ASSIGNMENT(#%d,(#1101,#1000));\n"
                "#1401=APPLIED_GROUP_ASSIGNMENT(#1299,(#1000));\n#1299=GROUP('late','');\n",
                1199 + count);
        for (int i = count > 64 ? count - 64 : 0; i < count; i++)
            sprintf(due + strlen(due), "%s%c", due[0] ? "/" : "", 'a' + i % 26);
        batten_model *model = read_with(text);
        CHECK_TEXT(batten_model_object(model, 0)->group, due);
        CHECK_TEXT(batten_model_object(model, 1)->group, due);
        batten_model_unref(model);
    }
}
