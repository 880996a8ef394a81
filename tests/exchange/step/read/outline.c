/* Representations and what they are the shape of: what is wrong there costs a name or a tie, not the shape. */
#include "exchange/step/read/bent_box.h"

#define PRODUCT "#1100=PRODUCT('id','hull','',());\n"
#define DEFINITION "#1101=PRODUCT_DEFINITION('','',#1102,$);\n"
#define FORMATION "#1102=PRODUCT_DEFINITION_FORMATION('','',#1100);\n"
#define SHAPE "#1103=PRODUCT_DEFINITION_SHAPE('','',#1101);\n"
#define SHAPE_OF "#1104=SHAPE_DEFINITION_REPRESENTATION(#1103,#990);\n"

/* The chain from a representation to its product, whole and broken at each of its members. */
static const struct {
    const char *chain;
    bool loses_name;
} chains[] = {
    {PRODUCT DEFINITION FORMATION SHAPE SHAPE_OF, false},
    {PRODUCT DEFINITION FORMATION SHAPE "#1104=SHAPE_DEFINITION_REPRESENTATION(#9999,#990);\n",
     true},
    {PRODUCT DEFINITION FORMATION SHAPE "#1104=SHAPE_DEFINITION_REPRESENTATION(#1103,$);\n",
     true},
    {PRODUCT DEFINITION FORMATION "#1103=PRODUCT_DEFINITION_SHAPE('','',$);\n" SHAPE_OF, true},
    {PRODUCT "#1101=PRODUCT_DEFINITION('','',$,$);\n" FORMATION SHAPE SHAPE_OF, true},
    {PRODUCT DEFINITION "#1102=PRODUCT_DEFINITION_FORMATION('','',#9999);\n" SHAPE SHAPE_OF,
     true},
    /* of what is no representation: nothing to name */
    {PRODUCT DEFINITION FORMATION SHAPE "#1104=SHAPE_DEFINITION_REPRESENTATION(#1103,#1);\n",
     false},
};

TEST(a_product_whose_chain_is_broken_loses_its_name_and_keeps_its_shape)
{
    for (int i = 0; i < COUNT(chains); i++) {
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(50, &notes));
        CHECK_OK(read_text(box_with(chains[i].chain), BATTEN_FORMAT_STEP, notes, &model));
        CHECK_INT(batten_model_count(model), 1);
        if (batten_notes_dropped(notes) == 0)
            CHECK_INT(has_note(notes, "; a product loses its name"), chains[i].loses_name);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

/* The box is in the first or in the second of two representations, which are one definition when they are tied,
 * in either order, by relations of both kinds. */
TEST(tied_representations_are_one_definition_and_a_bad_tie_is_left_out)
{
    static const struct {
        const char *relation;
        batten_status status;
        const char *note;
    } cases[] = {
        {"#1201=SHAPE_REPRESENTATION_RELATIONSHIP('','',#990,#1200);\n", BATTEN_OK, ""},
        {"#1201=SHAPE_REPRESENTATION_RELATIONSHIP('','',#1200,#990);\n", BATTEN_OK, ""},
        {"#1201=(REPRESENTATION_RELATIONSHIP('','',#1200,#990)"
         "SHAPE_REPRESENTATION_RELATIONSHIP());\n",
         BATTEN_OK, ""},
        {"#1201=SHAPE_REPRESENTATION_RELATIONSHIP('','',#990,#1);\n", BATTEN_OK, ""},
        {"#1201=SHAPE_REPRESENTATION_RELATIONSHIP('','',#990,$);\n", BATTEN_PARTLY_READ,
         "argument 4"},
        {"#1201=SHAPE_REPRESENTATION_RELATIONSHIP('','',#9999,#990);\n", BATTEN_PARTLY_READ,
         "#9999"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[400];
        snprintf(text, sizeof text, "#1200=SHAPE_REPRESENTATION('',(),#900);\n%s",
                 cases[i].relation);
        check_read(box_with(text), cases[i].status, cases[i].note, 6, true);
    }
}
