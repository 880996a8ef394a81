/* Assemblies: definitions made once, placed with rotations, in units of their own. */
#include "exchange/step/boxes.h"

static const double ZERO[] = {0, 0, 0}, X[] = {1, 0, 0}, Y[] = {0, 1, 0}, Z[] = {0, 0, 1};

/* The product #id with its definition #id + 1, whose shape is the representation. */
static void put_product(box_text *text, int id, const char *name, int representation)
{
    box_add(text, "#%d=PRODUCT('id %s','%s','',());\n", id, name, name);
    box_add(text, "#%d=PRODUCT_DEFINITION('','',#%d,$);\n", id + 1, id + 2);
    box_add(text, "#%d=PRODUCT_DEFINITION_FORMATION('','',#%d);\n", id + 2, id);
    box_add(text, "#%d=PRODUCT_DEFINITION_SHAPE('','',#%d);\n", id + 3, id + 1);
    box_add(text, "#%d=SHAPE_DEFINITION_REPRESENTATION(#%d,#%d);\n", id + 4, id + 3,
            representation);
}

/* The representation `part` placed in `whole`, from placement `from` to `to`. */
static void put_occurrence(box_text *text, int id, const char *name, int part, int whole,
                           int from, int to, int part_product, int whole_product, bool swapped,
                           bool crossed)
{
    box_add(text, "#%d=NEXT_ASSEMBLY_USAGE_OCCURRENCE('%d','%s','',#%d,#%d,$);\n", id, id, name,
            whole_product + 1, part_product + 1);
    box_add(text, "#%d=PRODUCT_DEFINITION_SHAPE('','',#%d);\n", id + 1, id);
    box_add(text, "#%d=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#%d,#%d);\n", id + 2, id + 3,
            id + 1);
    box_add(text,
            "#%d=(REPRESENTATION_RELATIONSHIP('','',#%d,#%d)"
            "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#%d)"
            "SHAPE_REPRESENTATION_RELATIONSHIP());\n",
            id + 3, swapped ? whole : part, swapped ? part : whole, id + 4);
    box_add(text, "#%d=ITEM_DEFINED_TRANSFORMATION('','',#%d,#%d);\n", id + 4,
            swapped != crossed ? to : from, swapped != crossed ? from : to);
}

/* A box of one inch, its corner at the origin of the bolt; two bolts in an arm, the second
 * turned by 90 degrees about z; two arms in the ship, the second turned about x. */
static const char *ship(bool swapped, bool crossed)
{
    static const double bolt_at[] = {10, 0, 0}, arm_at[] = {0, 100, 0};
    box_text text;
    box_shell(box_begin(&text), 1, ZERO, 1, 0);
    box_add(&text, "#1000=MANIFOLD_SOLID_BREP('head',#181);\n"
                   "#920=(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
                   "GLOBAL_UNIT_ASSIGNED_CONTEXT((#921,#902,#903))"
                   "REPRESENTATION_CONTEXT('',''));\n"
                   "#921=(CONVERSION_BASED_UNIT('INCH',#922)LENGTH_UNIT()NAMED_UNIT(#923));\n"
                   "#922=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#901);\n"
                   "#923=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n");
    box_context(&text, 900);
    box_placement(&text, 700, ZERO, Z, X);
    box_placement(&text, 710, bolt_at, Z, Y);
    box_placement(&text, 720, arm_at, Y, X);
    box_add(&text, "#800=SHAPE_REPRESENTATION('ship',(#700,#720,#720),#900);\n"
                   "#801=SHAPE_REPRESENTATION('arm',(#700,#710,#710),#900);\n"
                   "#802=SHAPE_REPRESENTATION('bolt',(#700),#920);\n"
                   "#803=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#1000),#920);\n"
                   "#804=SHAPE_REPRESENTATION_RELATIONSHIP('','',#802,#803);\n");
    put_product(&text, 1100, "ship", 800);
    put_product(&text, 1110, "arm", 801);
    put_product(&text, 1120, "bolt", 802);
    put_occurrence(&text, 1200, "left", 801, 800, 700, 700, 1110, 1100, swapped, crossed);
    put_occurrence(&text, 1210, "right", 801, 800, 700, 720, 1110, 1100, swapped, crossed);
    put_occurrence(&text, 1220, "first", 802, 801, 700, 700, 1120, 1110, swapped, crossed);
    put_occurrence(&text, 1230, "", 802, 801, 700, 710, 1120, 1110, swapped, crossed);
    return box_end(&text);
}

static void check_box(const batten_model *flat, const char *name, const double low[3],
                      const double high[3])
{
    const int index = batten_model_find(flat, name);
    CHECK(index >= 0);
    const batten_box box = batten_body_box(batten_model_object(flat, index)->body);
    const double found[] = {box.low.x,  box.low.y,  box.low.z,
                            box.high.x, box.high.y, box.high.z};
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(found[k], low[k], 1e-12);
        CHECK_NEAR(found[3 + k], high[k], 1e-12);
    }
}

TEST(assemblies_two_deep_are_placed_and_their_parts_made_once)
{
    /* The first two bits: the assembly before the part, the placements the other way about. */
    for (int order = 0; order < 4; order++) {
        const char *file = ship(order & 1, order & 2);
        const char *words =
            order & 2 ? "the items of its relation belong to the opposite representations" : "";
        batten_model *model = read_noting(file, BATTEN_FORMAT_STEP, words), *flat = NULL;
        CHECK_BITS(batten_model_unit_metres(model), 0.001);
        CHECK_INT(batten_model_depth(model), 2);
        CHECK_INT(batten_model_count(model), 2);
        const batten_object *left = batten_model_object(model, 0),
                            *right = batten_model_object(model, 1);
        CHECK_TEXT(left->name, "left");
        CHECK_TEXT(right->name, "right");
        CHECK(left->definition == right->definition);
        const batten_object *first = batten_model_object(left->definition, 0),
                            *second = batten_model_object(left->definition, 1);
        CHECK_TEXT(first->name, "first");
        CHECK_TEXT(second->name, "1230");
        CHECK(first->definition == second->definition);
        CHECK_OK(batten_model_flat(model, &flat));
        CHECK_INT(batten_model_count(flat), 4);
        /* An inch along x, y and z; turned about z: x is y, y is -x; then about x: z is y, y
         * is -z. */
        check_box(flat, "left/first/head", ZERO, (const double[]){25.4, 25.4, 25.4});
        check_box(flat, "left/1230/head", (const double[]){10 - 25.4, 0, 0},
                  (const double[]){10, 25.4, 25.4});
        check_box(flat, "right/first/head", (const double[]){0, 100, -25.4},
                  (const double[]){25.4, 125.4, 0});
        check_box(flat, "right/1230/head", (const double[]){10 - 25.4, 100, -25.4},
                  (const double[]){10, 125.4, 0});
        batten_model_unref(flat);
        batten_model_unref(model);
    }
}

TEST(mapped_items_place_representations_by_placement_or_operator)
{
    static const struct {
        const char *target;
        double low[3], high[3];
    } cases[] = {{"#710", {9, 0, 0}, {10, 1, 1}},
                 {"#730", {10, 0, 0}, {12, 2, 2}},
                 {"#731", {8, 0, 0}, {10, 2, 2}}};
    static const double at[] = {10, 0, 0};
    for (int k = 0; k < COUNT(cases); k++) {
        box_text text;
        batten_model *model = NULL, *flat = NULL;
        box_shell(box_begin(&text), 1, ZERO, 1, 0);
        box_context(&text, 900);
        box_placement(&text, 700, ZERO, Z, X);
        box_placement(&text, 710, at, Z, Y);
        box_add(&text, "#740=DIRECTION('',(0.,1.,0.));\n#741=DIRECTION('',(-1.,0.,0.));\n"
                       "#730=CARTESIAN_TRANSFORMATION_OPERATOR_3D('',$,$,#711,2.,$);\n"
                       "#731=CARTESIAN_TRANSFORMATION_OPERATOR_3D('',#740,#741,#711,2.,"
                       "#712);\n"
                       "#1000=MANIFOLD_SOLID_BREP('head',#181);\n"
                       "#800=SHAPE_REPRESENTATION('whole',(#750),#900);\n"
                       "#801=ADVANCED_BREP_SHAPE_REPRESENTATION('part',(#1000),#900);\n"
                       "#749=REPRESENTATION_MAP(#700,#801);\n");
        box_add(&text, "#750=MAPPED_ITEM('here',#749,%s);\n", cases[k].target);
        const char *file = box_end(&text);
        CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
        CHECK_INT(batten_model_count(model), 1);
        CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_INSTANCE);
        CHECK_OK(batten_model_flat(model, &flat));
        check_box(flat, "here/head", cases[k].low, cases[k].high);
        batten_model_unref(flat);
        batten_model_unref(model);
    }
}

TEST(P1_assemblies_in_a_ring_are_cut_where_the_ring_closes)
{
    box_text text;
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    box_shell(box_begin(&text), 1, ZERO, 1, 0);
    box_context(&text, 900);
    box_placement(&text, 700, ZERO, Z, X);
    box_add(&text, "#1000=MANIFOLD_SOLID_BREP('head',#181);\n"
                   "#800=SHAPE_REPRESENTATION('a',(#1000,#750),#900);\n"
                   "#801=SHAPE_REPRESENTATION('b',(#751),#900);\n"
                   "#748=REPRESENTATION_MAP(#700,#800);\n"
                   "#749=REPRESENTATION_MAP(#700,#801);\n"
                   "#750=MAPPED_ITEM('b in a',#749,#700);\n"
                   "#751=MAPPED_ITEM('a in b',#748,#700);\n");
    const char *file = box_end(&text);
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(file, BATTEN_FORMAT_STEP, notes, &model), BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_TEXT(batten_model_object(model, 0)->name, "head");
    CHECK(batten_notes_dropped(notes) || has_note(notes, "places a shape within itself"));
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(roots_that_stand_side_by_side_are_groups_of_one_model)
{
    static const double there[] = {5, 0, 0};
    box_text text;
    batten_model *model = NULL;
    box_shell(box_begin(&text), 1, ZERO, 1, 0);
    box_shell(&text, 301, there, 1, 0);
    box_context(&text, 900);
    box_add(&text, "#1000=MANIFOLD_SOLID_BREP('one',#181);\n"
                   "#1001=MANIFOLD_SOLID_BREP('',#481);\n"
                   "#800=SHAPE_REPRESENTATION('',(#1000),#900);\n"
                   "#801=SHAPE_REPRESENTATION('',(#1001),#900);\n");
    put_product(&text, 1100, "left", 800);
    put_product(&text, 1110, "right", 801);
    const char *file = box_end(&text);
    CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
    CHECK_INT(batten_model_count(model), 2);
    CHECK_TEXT(batten_model_object(model, 0)->name, "one");
    CHECK_TEXT(batten_model_object(model, 0)->group, "left");
    CHECK_TEXT(batten_model_object(model, 1)->name, "right");
    CHECK_TEXT(batten_model_object(model, 1)->group, "right");
    batten_model_unref(model);
}
