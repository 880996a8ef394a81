/* Solids that no product leads to are read, or left out by name. */
#include "exchange/step/boxes.h"

static const double ORIGIN[3] = {0, 0, 0};

/* A box with its solid #1000, and what the case adds. */
static const char *box_and(const char *rest)
{
    box_text text;
    box_shell(box_begin(&text), 1, ORIGIN, 2, 0);
    box_context(&text, 900);
    box_add(&text, "#1000=MANIFOLD_SOLID_BREP('box',#181);\n%s", rest);
    return box_end(&text);
}

static void check_root(const char *rest, batten_status expected, int solids, const char *words)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_notes_create(50, &notes));
    CHECK_STATUS(read_text(box_and(rest), BATTEN_FORMAT_STEP, notes, &model), expected);
    CHECK_INT(model ? batten_model_count(model) : 0, solids);
    if (solids)
        CHECK_NEAR(box_measure(batten_model_object(model, 0)->body).volume, 8, 1e-9);
    if (batten_notes_dropped(notes) == 0 && words[0])
        CHECK(has_note(notes, words));
    if (batten_notes_dropped(notes) == 0 && !words[0])
        CHECK_INT(count_warnings(notes), 0);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(a_solid_that_no_representation_lists_is_read_with_a_note)
{
    static const char *const cases[] = {
        "#990=ADVANCED_BREP_SHAPE_REPRESENTATION('',(),#900);\n", /* its reference is lost */
        ("#990=ADVANCED_BREP_SHAPE_REPRESENTATION('',(),#900);\n"
         "#991=STYLED_ITEM('',(),#1000);\n"
         "#992=PRESENTATION_LAYER_ASSIGNMENT('1','',(#1000));\n"),
        "", /* nor is there a representation */
    };
    for (int k = 0; k < COUNT(cases); k++)
        check_root(cases[k], BATTEN_OK, 1,
                   "no representation lists it; it is read all the same");
}

TEST(a_solid_in_a_representation_that_no_product_shows_is_left_out_by_name)
{
    static const char *const cases[] = {
        /* of an aspect alone; of something else than a shape; mapped and not placed */
        "#990=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#1000),#900);\n"
        "#991=SHAPE_DEFINITION_REPRESENTATION(#992,#990);\n"
        "#992=PROPERTY_DEFINITION('','',#993);\n#993=SHAPE_ASPECT('','',$,.T.);\n",
        "#990=MAGNETIC_REPRESENTATION('',(#1000),#900);\n",
        "#990=REPRESENTATION_MAP(#991,#992);\n#992=REPRESENTATION('',(#1000),#900);\n"};
    for (int k = 0; k < COUNT(cases); k++)
        check_root(cases[k], BATTEN_UNSUPPORTED, 0,
                   "it stands in a representation that no product leads to");
    check_root("#990=MAGNETIC_REPRESENTATION('',(#1000),#900);\n"
               "#1001=MANIFOLD_SOLID_BREP('seen',#181);\n"
               "#995=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#1001),#900);\n",
               BATTEN_PARTLY_READ, 1, "it stands in a representation that no product leads to");
}

TEST(a_solid_that_is_a_part_of_another_item_is_not_read_for_itself)
{
    check_root("#990=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#1001),#900);\n"
               "#1001=MANIFOLD_SOLID_BREP('seen',#181);\n#1002=HOLDS('#1001',#1000);\n",
               BATTEN_OK, 1, "");
    check_root("#990=CSG_SHAPE_REPRESENTATION('',(#1002),#900);\n"
               "#1002=SOLID_REPLICA('',#1000,$);\n",
               BATTEN_UNSUPPORTED, 0, "its kind is not read");
}
