/* What the header, the layers and the blocks say before the entities are read. */
#include "exchange/listed.h"

/* Groups as "code value|", with an end of the line for each blank behind a code and each bar. */
static char *lines(const char *text)
{
    char *made = test_array(strlen(text) + 2, 1), *to = made;
    bool is_code = true;
    for (; *text; text++) {
        *to++ = *text == '|' || (is_code && *text == ' ') ? '\n' : *text;
        is_code = *text == '|' || (is_code && *text != ' ');
    }
    return made;
}

#define SECTION(name) "0 SECTION|2 " name "|"
#define END "0 ENDSEC|"
#define LINE(layer) "0 LINE|8 " layer "|10 0|20 0|11 1|21 1|"

static batten_model *read_dxf(const char *header, const char *rest)
{
    char text[2000];
    batten_model *model = NULL;
    snprintf(text, sizeof text, "%s%s" END "%s" SECTION("ENTITIES") LINE("a") END "0 EOF|",
             SECTION("HEADER"), header, rest);
    CHECK_OK(read_text(lines(text), BATTEN_FORMAT_DXF, NULL, &model));
    return model;
}

TEST(the_unit_is_the_number_behind_its_own_name)
{
    static const struct {
        const char *header;
        double metres;
    } cases[] = {
        {"9 $INSUNITS|70 4|", 0.001},
        {"9 $TDCREATE|40 2|9 $INSUNITS|70 5|9 $ANGDIRXX|70 6|", 0.01},
        {"9 $TDCREATE|40 2|", 0},
        {"9 $INSUNITZ|70 4|", 0},
        {"9 $INSUNITSX|70 4|", 0},
        {"9 $INSUNIT|70 4|", 0},
        {"1 $INSUNITS|70 4|", 0},
        {"9 $INSUNITS|70 0|", 0},
        {"9 $INSUNITS|70 -1|", 0},
        {"9 $INSUNITS|70 25|", 0},
        {"9 $INSUNITS|70 24|", 6336000.0 / 3937},
        {"9 $INSUNITS|70 x|", 0},
        {"9 $INSUNITS|", 0},
        {"", 0},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = read_dxf(cases[i].header, "");
        CHECK_BITS(batten_model_unit_metres(model), cases[i].metres);
        batten_model_unref(model);
    }
}

/* A layer is hidden when its colour is below 0 or it is frozen; 7 is no colour. */
TEST(a_layer_says_its_colour_and_whether_it_is_shown_by_its_numbers)
{
    static const struct {
        const char *layer;
        bool is_hidden, has_colour;
        double red;
    } cases[] = {
        {"62 1|70 0|", false, true, 1},
        {"62 -1|70 0|", true, true, 1},
        {"62 1|70 1|", true, true, 1},
        {"62 1|70 4|", false, true, 1},
        {"62 1|70 5|", true, true, 1},
        {"62 7|70 0|", false, false, 0},
        {"62 -7|70 0|", true, false, 0},
        {"70 0|", false, false, 0},
        {"62 7|420 3342336|", false, true, 0.2},
        {"62 7|420 0|", false, true, 0},
        {"62 7|420 -1|", false, false, 0},
        {"62 256|", false, false, 0},
        {"62 -300|", true, true, 1},
        {"62 255|", false, true, 1},
        {"62 x|70 x|", false, false, 0},
        {"62 250|", false, true, 0.2},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char rest[300];
        snprintf(rest, sizeof rest, "%s0 TABLE|2 LAYER|0 LAYER|2 a|%s0 ENDTAB|" END,
                 SECTION("TABLES"), cases[i].layer);
        batten_model *model = read_dxf("9 $INSUNITS|70 4|", rest);
        const batten_object *object = batten_model_object(model, 0);
        CHECK(object->is_hidden == cases[i].is_hidden);
        CHECK(object->has_colour == cases[i].has_colour);
        if (object->has_colour)
            CHECK_NEAR(object->colour[0], cases[i].red, 1e-15);
        batten_model_unref(model);
    }
}

/* Of layers that differ in capitals alone the very same name comes before the like. */
TEST(a_layer_is_found_by_its_name_and_else_by_one_like_it)
{
    static const char tables[] =
        SECTION("TABLES") "0 TABLE|2 LAYER|0 LAYER|2 B|62 2|"
                          "0 LAYER|2 A|62 3|0 LAYER|2 a|62 1|0 LAYER|2 AB|62 5|"
                          "0 LAYER|2 a|62 4|0 ENDTAB|" END;
    batten_model *model = read_dxf("9 $INSUNITS|70 4|", tables);
    const double *colour = batten_model_object(model, 0)->colour;
    CHECK(colour[0] == 1 && colour[1] == 0 && colour[2] == 0); /* the first `a` */
    batten_model_unref(model);
}

/* Old polylines and meshes of faces within blocks. */
TEST(a_block_may_hold_polylines_and_meshes)
{
    static const char blocks[] = SECTION(
        "BLOCKS") "0 BLOCK|2 b|10 0|20 0|30 0|"
                  "0 POLYLINE|8 0|66 1|70 8|0 VERTEX|10 1|20 2|30 3|70 32|0 VERTEX|10 4|20 5|30 6|70 32|"
                  "0 VERTEX|10 7|20 8|30 10|70 32|0 SEQEND|"
                  "0 POLYLINE|8 0|66 1|70 64|71 3|72 1|0 VERTEX|10 0|20 0|30 0|70 192|"
                  "0 VERTEX|10 1|20 0|30 0|70 192|0 VERTEX|10 0|20 1|30 2|70 192|"
                  "0 VERTEX|10 0|20 0|30 0|70 128|71 1|72 2|73 3|0 SEQEND|"
                  "0 3DFACE|10 0|20 0|30 0|11 1|21 0|31 0|12 1|22 1|32 0|13 1|23 1|33 0|"
                  "0 ENDBLK|" END;
    char text[1500];
    batten_model *model = NULL;
    snprintf(text, sizeof text, "%s" SECTION("ENTITIES") "0 INSERT|2 b|10 0|20 0|" END "0 EOF|",
             blocks);
    CHECK_OK(read_text(lines(text), BATTEN_FORMAT_DXF, NULL, &model));
    const batten_model *block = batten_model_object(model, 0)->definition;
    static const double points[] = {1, 2, 3, 4, 5, 6, 7, 8, 10};
    CHECK_INT(batten_model_count(block), 3);
    const batten_curve *curve = batten_model_object(block, 0)->curve;
    CHECK(curve && batten_curve_point_count(curve) == 3);
    for (int i = 0; i < 9; i++)
        CHECK_BITS(batten_curve_points(curve)[i], points[i]);
    const batten_mesh_parts *mesh = batten_mesh_view(batten_model_object(block, 1)->mesh);
    CHECK_INT(mesh->vertex_count, 3);
    CHECK_INT(mesh->triangle_count, 1);
    CHECK_BITS(mesh->points[8], 2);
    CHECK_INT(batten_mesh_view(batten_model_object(block, 2)->mesh)->triangle_count, 1);
    batten_model_unref(model);
}

TEST(a_block_whose_base_is_no_number_has_its_base_at_0)
{
    static const char text[] = SECTION("BLOCKS") "0 BLOCK|2 b|10 x|20 5|" LINE(
        "0") "0 ENDBLK|" END SECTION("ENTITIES") "0 INSERT|2 b|10 2|20 3|" END "0 EOF|";
    batten_model *model = read_noting(lines(text), BATTEN_FORMAT_DXF,
                                      "group 10 is 'x', not a number; its base is taken as 0");
    const batten_affine *place = &batten_model_object(model, 0)->place;
    CHECK(place->t[0] == 2 && place->t[1] == 3 && place->t[2] == 0);
    batten_model_unref(model);
}

TEST(a_file_that_gives_no_unit_is_noted)
{
    check_listed(lines(SECTION("HEADER") END SECTION("ENTITIES") LINE("a") END "0 EOF|"),
                 BATTEN_FORMAT_DXF, BATTEN_OK, "0: the file gives no unit\n~0: LINE: 1 read\n");
}
