#include "exchange/reading.h"

#include <batten/standard.h>

/* Groups are written with blanks between code and value, entities by lines; this makes the
 * lines of the format of them: "0 LINE|8 keel|10 1|20 2|11 3|21 4". */
static char *lines(const char *text)
{
    const size_t size = strlen(text);
    char *made = test_array(size + 2, 1);
    bool code = true;
    for (size_t i = 0; i < size; i++) {
        made[i] = text[i];
        if (text[i] == '|' || (code && text[i] == ' '))
            made[i] = '\n';
        code = text[i] == '|' || (code && text[i] != ' ');
    }
    made[size] = '\n';
    return made;
}

/* A whole file around entities. */
static char *file_of(const char *tables, const char *blocks, const char *entities)
{
    const size_t size = strlen(tables) + strlen(blocks) + strlen(entities) + 400;
    char *text = test_array(size, 1);
    snprintf(text, size,
             "0 SECTION|2 HEADER|9 $ACADVER|1 AC1015|9 $INSUNITS|70 4|0 ENDSEC|"
             "0 SECTION|2 TABLES|0 TABLE|2 LAYER|%s0 ENDTAB|0 ENDSEC|"
             "0 SECTION|2 BLOCKS|%s0 ENDSEC|0 SECTION|2 ENTITIES|%s0 ENDSEC|0 EOF",
             tables, blocks, entities);
    return lines(text);
}

static batten_model *read_entities(const char *entities)
{
    batten_model *model = NULL;
    CHECK_OK(read_text(file_of("", "", entities), BATTEN_FORMAT_AUTO, NULL, &model));
    return model;
}

/* The point of curve `index` at the share s of its domain. */
static void point_of(const batten_model *model, int index, double s, double p[3])
{
    const batten_curve *curve = batten_model_object(model, index)->curve;
    CHECK(curve != NULL);
    const batten_interval domain = batten_curve_domain(curve);
    p[2] = 0;
    CHECK_OK(batten_curve_evaluate(curve, domain.a + s * (domain.b - domain.a), 0, p));
}

static void check_point(const batten_model *model, int index, double s, double x, double y,
                        double z)
{
    double p[3];
    point_of(model, index, s, p);
    CHECK_NEAR(p[0], x, 1e-12);
    CHECK_NEAR(p[1], y, 1e-12);
    CHECK_NEAR(p[2], z, 1e-12);
}

TEST(lines_arcs_and_circles_of_dxf_files_are_read)
{
    batten_model *model = read_entities("0 LINE|8 keel|10 1|20 2|30 3|11 3|21 4|31 5|"
                                        "0 ARC|8 0|10 1|20 0|40 2|50 350|51 80|"
                                        "0 CIRCLE|8 0|10 0|20 0|30 7|40 3|"
                                        "0 POINT|8 0|10 4|20 5|30 6|");
    CHECK_INT(batten_model_count(model), 4);
    CHECK_BITS(batten_model_unit_metres(model), 0.001);
    CHECK_TEXT(batten_model_object(model, 0)->layer, "keel");
    check_point(model, 0, 0.5, 2, 3, 4);
    const double degree = acos(0) / 90;
    check_point(model, 1, 0, 1 + 2 * cos(10 * degree), -2 * sin(10 * degree), 0);
    check_point(model, 1, 0.5, 1 + 2 * cos(35 * degree), 2 * sin(35 * degree), 0);
    check_point(model, 1, 1, 1 + 2 * cos(80 * degree), 2 * sin(80 * degree), 0);
    check_point(model, 2, 0, 3, 0, 7);
    check_point(model, 2, 1, 3, 0, 7);
    CHECK_BITS(batten_model_object(model, 3)->points[2], 6);
    batten_model_unref(model);
}

TEST(a_plane_has_the_axes_that_the_format_gives_it)
{
    /* Normal -z: the axes are -x and y. Normal x: they are y and z. */
    batten_model *model = read_entities("0 CIRCLE|8 0|10 1|20 2|30 3|40 1|210 0|220 0|230 -1|"
                                        "0 CIRCLE|8 0|10 1|20 2|30 3|40 1|210 1|220 0|230 0|");
    check_point(model, 0, 0, -2, 2, -3);
    check_point(model, 1, 0, 3, 2, 2);
    batten_model_unref(model);
}

TEST(ellipses_of_dxf_files_are_read)
{
    const double half = acos(0);
    char text[256];
    snprintf(text, sizeof text,
             "0 ELLIPSE|8 0|10 1|20 1|30 0|11 0|21 4|31 0|40 0.5|41 0|42 %.17g|", half);
    batten_model *model = read_entities(text);
    check_point(model, 0, 0, 1, 5, 0);
    check_point(model, 0, 1, -1, 1, 0);
    batten_model_unref(model);
}

TEST(polylines_with_bulges_become_lines_and_arcs)
{
    /* A stadium: two lines and two half circles. */
    batten_model *model =
        read_entities("0 LWPOLYLINE|8 0|90 4|70 1|38 2|10 0|20 0|10 4|20 0|42 1|"
                      "10 4|20 2|10 0|20 2|42 1|");
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    CHECK(batten_curve_is_closed(curve, 1e-14));
    CHECK_INT(batten_curve_degree(curve), 2);
    double top[3];
    bool seen = false;
    for (int i = 0; i <= 400; i++) {
        point_of(model, 0, i / 400.0, top);
        const double out = top[0] > 4   ? hypot(top[0] - 4, top[1] - 1) - 1
                           : top[0] < 0 ? hypot(top[0], top[1] - 1) - 1
                                        : fmin(fabs(top[1]), fabs(top[1] - 2));
        CHECK_NEAR(out, 0, 1e-14);
        CHECK_NEAR(top[2], 2, 0);
        seen |= top[0] > 4.99;
    }
    CHECK(seen);
    batten_model_unref(model);

    model = read_entities("0 LWPOLYLINE|8 0|90 3|70 0|10 0|20 0|10 4|20 0|10 4|20 2|");
    CHECK_INT(batten_curve_degree(batten_model_object(model, 0)->curve), 1);
    CHECK_INT(batten_curve_point_count(batten_model_object(model, 0)->curve), 3);
    batten_model_unref(model);
}

TEST(old_polylines_are_read_with_their_vertices)
{
    batten_model *model = read_entities(
        "0 POLYLINE|8 deck|66 1|10 0|20 0|30 3|70 0|"
        "0 VERTEX|8 deck|10 0|20 0|30 0|42 1|0 VERTEX|8 deck|10 2|20 0|30 0|0 SEQEND|8 0|"
        "0 POLYLINE|8 0|66 1|10 0|20 0|30 0|70 9|"
        "0 VERTEX|8 0|10 0|20 0|30 1|70 32|0 VERTEX|8 0|10 1|20 0|30 2|70 32|"
        "0 VERTEX|8 0|10 1|20 1|30 3|70 32|0 SEQEND|8 0|");
    CHECK_INT(batten_model_count(model), 2);
    check_point(model, 0, 0.5, 1, -1, 3);
    const batten_curve *closed = batten_model_object(model, 1)->curve;
    CHECK_INT(batten_curve_point_count(closed), 4);
    CHECK(batten_curve_is_closed(closed, 0));
    batten_model_unref(model);
}

TEST(splines_of_dxf_files_are_read)
{
    batten_model *model = read_entities(
        "0 SPLINE|8 0|70 4|71 2|72 6|73 3|40 0|40 0|40 0|40 1|40 1|40 1|41 1|41 0.5|41 1|"
        "10 0|20 0|30 0|10 1|20 2|30 0|10 2|20 0|30 0|"
        "0 SPLINE|8 0|70 8|71 3|72 0|73 0|74 3|11 0|21 0|31 0|11 1|21 1|31 0|11 2|21 0|31 0|");
    const batten_curve *rational = batten_model_object(model, 0)->curve;
    CHECK_BITS(batten_curve_weights(rational)[1], 0.5);
    check_point(model, 0, 0.5, 1, 2.0 / 3, 0);
    check_point(model, 1, 0, 0, 0, 0);
    check_point(model, 1, 0.5, 1, 1, 0);
    batten_model_unref(model);
}

/* Four points, with what else stands in the entity. */
static batten_model *read_fit(const char *more)
{
    char text[600];
    snprintf(text, sizeof text,
             "0 SPLINE|8 0|70 8|%s11 0|21 0|31 0|11 1|21 1|31 0|11 2|21 0|31 0|11 3|21 1|31 0|",
             more);
    return read_entities(text);
}

/* The direction of the first curve at an end of it. */
static double angle_at(const batten_model *model, bool at_end)
{
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    const batten_interval domain = batten_curve_domain(curve);
    double d[6];
    CHECK_OK(batten_curve_evaluate(curve, at_end ? domain.b : domain.a, 1, d));
    return atan2(d[4], d[3]) * 45 / atan(1);
}

TEST(splines_through_points_keep_the_directions_at_their_ends)
{
    batten_model *model = read_fit("71 3|12 1|22 1|32 0|13 0|23 -2|33 0|");
    CHECK_NEAR(angle_at(model, false), 45, 1e-10);
    CHECK_NEAR(angle_at(model, true), -90, 1e-10);
    batten_model_unref(model);
    model = read_fit("71 3|12 1|22 0|32 0|13 0|23 0|33 0|");
    CHECK_NEAR(angle_at(model, false), 0, 1e-10);
    batten_model_unref(model);
    batten_model *plain = read_fit("71 2|");
    model = read_fit("71 2|12 1|22 0|32 0|");
    CHECK_NEAR(angle_at(model, false), angle_at(plain, false), 0);
    batten_model_unref(plain);
    batten_model_unref(model);
}

TEST(every_unit_of_dxf_is_known)
{
    for (int code = 1; code <= 24; code++) {
        char text[200];
        batten_model *model = NULL;
        snprintf(
            text, sizeof text,
            "0 SECTION|2 HEADER|9 $INSUNITS|70 %d|0 ENDSEC|0 SECTION|2 ENTITIES|0 POINT|8 0|"
            "10 1|20 2|0 ENDSEC|0 EOF",
            code);
        CHECK_OK(read_text(lines(text), BATTEN_FORMAT_AUTO, NULL, &model));
        const double unit = batten_model_unit_metres(model);
        CHECK(unit > 0);
        if (code == 21)
            CHECK_NEAR(unit, 0.3048006096012192, 1e-16);
        batten_model_unref(model);
    }
}

TEST(thickness_is_told)
{
    const char *text = file_of("", "",
                               "0 LINE|8 0|39 5|10 0|20 0|11 1|21 1|"
                               "0 LINE|8 0|39 0|10 0|20 0|11 1|21 1|");
    batten_model_unref(
        read_noting(text, BATTEN_FORMAT_DXF, "entities with a thickness: 1; they are read"));
}

TEST(layers_say_colour_and_whether_they_are_shown)
{
    batten_model *model = NULL;
    CHECK_OK(read_text(file_of("0 LAYER|2 keel|70 0|62 5|0 LAYER|2 off|70 0|62 -1|"
                               "0 LAYER|2 full|70 1|62 7|420 16744448|",
                               "",
                               "0 LINE|8 keel|10 0|20 0|11 1|21 1|"
                               "0 LINE|8 off|62 3|10 0|20 0|11 1|21 1|"
                               "0 LINE|8 full|10 0|20 0|11 1|21 1|"
                               "0 LINE|8 keel|60 1|62 12|10 0|20 0|11 1|21 1|"),
                       BATTEN_FORMAT_AUTO, NULL, &model));
    const batten_object *o = batten_model_object(model, 0);
    CHECK(o->has_colour && o->colour[2] == 1 && o->colour[0] == 0 && !o->is_hidden);
    o = batten_model_object(model, 1);
    CHECK(o->is_hidden && o->colour[1] == 1);
    o = batten_model_object(model, 2);
    CHECK(o->is_hidden);
    CHECK_BITS(o->colour[0], 1);
    CHECK_NEAR(o->colour[1], 128 / 255.0, 1e-15);
    CHECK(batten_model_object(model, 3)->is_hidden);
    CHECK_NEAR(batten_model_object(model, 3)->colour[0], 0.65, 1e-15);
    batten_model_unref(model);
}

/* By layer and on its own; within a block it is black, for an INSERT may have another. */
TEST(colour_7_is_none)
{
    batten_model *model = NULL, *flat = NULL;
    CHECK_OK(read_text(
        file_of("0 LAYER|2 plain|70 0|62 7|0 LAYER|2 off|70 0|62 -7|0 LAYER|2 red|70 0|62 1|",
                "0 BLOCK|8 0|2 b|70 0|10 0|20 0|30 0|0 POINT|8 plain|10 0|20 0|"
                "0 POINT|8 red|62 7|10 0|20 0|0 POINT|8 0|62 0|10 0|20 0|0 POINT|8 0|10 0|20 0|"
                "0 ENDBLK|8 0|",
                "0 LINE|8 plain|10 0|20 0|11 1|21 1|0 LINE|8 red|62 7|10 0|20 0|11 1|21 1|"
                "0 LINE|8 off|10 0|20 0|11 1|21 1|0 LINE|8 0|10 0|20 0|11 1|21 1|"
                "0 INSERT|8 red|2 b|10 0|20 0|0 INSERT|8 plain|2 b|10 0|20 0|"),
        BATTEN_FORMAT_AUTO, NULL, &model));
    for (int i = 0; i < 4; i++)
        CHECK(!batten_model_object(model, i)->has_colour);
    CHECK(batten_model_object(model, 2)->is_hidden);
    CHECK_OK(batten_model_flat(model, &flat));
    for (int i = 0; i < 8; i++) {
        const batten_object *object = batten_model_object(flat, 4 + i);
        CHECK_INT(object->has_colour, i < 6);
        CHECK(object->colour[0] == (i == 2 || i == 3) && object->colour[1] == 0);
    }
    batten_model_unref(flat);
    batten_model_unref(model);
}

TEST(blocks_are_placed_as_instances)
{
    batten_model *model = NULL, *flat = NULL;
    CHECK_OK(read_text(
        file_of(
            "",
            "0 BLOCK|8 0|2 outer|70 0|10 0|20 0|30 0|0 INSERT|8 0|2 bolt|10 1|20 0|30 0|"
            "0 ENDBLK|8 0|"
            "0 BLOCK|8 0|2 bolt|70 0|10 5|20 0|30 0|0 POINT|8 0|10 6|20 0|30 0|0 ENDBLK|8 0|",
            "0 INSERT|8 parts|2 outer|10 10|20 0|30 0|50 90|41 2|42 2|43 2|"
            "0 INSERT|8 0|2 bolt|10 0|20 0|30 0|"),
        BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_INT(batten_model_count(model), 2);
    CHECK_TEXT(batten_model_object(model, 0)->name, "outer");
    CHECK(batten_model_object(batten_model_object(model, 0)->definition, 0)->definition ==
          batten_model_object(model, 1)->definition);
    CHECK_OK(batten_model_flat(model, &flat));
    CHECK_NEAR(batten_model_object(flat, 0)->points[0], 10, 1e-14);
    CHECK_NEAR(batten_model_object(flat, 0)->points[1], 4, 1e-14);
    CHECK_NEAR(batten_model_object(flat, 1)->points[0], 1, 0);
    batten_model_unref(flat);
    batten_model_unref(model);
}

/* Layer and colour of object `index` of the model without its instances; colour -1 for none,
 * else in hexadecimal. */
static void check_look(const batten_model *model, int index, const char *layer, int colour)
{
    batten_model *flat = NULL;
    CHECK_OK(batten_model_flat(model, &flat));
    const batten_object *o = batten_model_object(flat, index);
    int found = 0;
    for (int k = 0; k < 3; k++)
        found = found << 8 | (int)(255 * o->colour[k] + 0.5);
    CHECK_TEXT(o->layer, layer);
    CHECK_INT(o->has_colour ? found : -1, colour);
    batten_model_unref(flat);
}

static batten_model *read_blocks(const char *blocks, const char *entities)
{
    batten_model *model = NULL;
    CHECK_OK(read_text(
        file_of("0 LAYER|2 green|70 0|62 3|0 LAYER|2 blue|70 0|62 5|", blocks, entities),
        BATTEN_FORMAT_AUTO, NULL, &model));
    return model;
}

/* By layer on layer 0, by block, by another layer, and red. */
static const char four[] = "0 BLOCK|8 0|2 four|70 0|10 0|20 0|0 POINT|8 0|10 1|20 0|"
                           "0 POINT|8 0|62 0|10 2|20 0|0 POINT|8 blue|10 3|20 0|"
                           "0 POINT|8 0|62 1|10 4|20 0|0 ENDBLK|8 0|";

TEST(what_lies_on_layer_0_of_a_block_has_the_layer_of_the_insert)
{
    enum { RED = 0xff0000, GREEN = 0x00ff00, BLUE = 0x0000ff, YELLOW = 0xffff00 };
    batten_model *model = read_blocks(four, "0 INSERT|8 green|2 four|10 0|20 0|"
                                            "0 INSERT|8 green|62 2|2 four|10 0|20 0|"
                                            "0 INSERT|8 green|62 1|2 four|10 0|20 0|"
                                            "0 INSERT|8 new|2 four|10 0|20 0|"
                                            "0 INSERT|8 new|62 2|2 four|10 0|20 0|");
    static const int colours[] = {GREEN, GREEN, YELLOW, RED, -1, YELLOW};
    for (int i = 0; i < 5; i++) {
        const char *layer = i < 3 ? "green" : "new";
        check_look(model, 4 * i, layer, i < 3 ? GREEN : i == 3 ? -1 : 0);
        check_look(model, 4 * i + 1, layer, colours[i + 1]);
        check_look(model, 4 * i + 2, "blue", BLUE);
        check_look(model, 4 * i + 3, layer, RED);
    }
    /* Only another colour than that of the layer needs a copy, and one does for two. */
    const batten_model *first = batten_model_object(model, 0)->definition;
    const batten_model *second = batten_model_object(model, 1)->definition;
    CHECK(first == batten_model_object(model, 3)->definition);
    CHECK(first != second && second == batten_model_object(model, 2)->definition);
    batten_model_unref(model);
}

TEST(colours_go_through_blocks_within_blocks)
{
    enum { RED = 0xff0000, GREEN = 0x00ff00, BLUE = 0x0000ff };
    static const char *const inner[] = {"8 0|", "8 0|62 0|", "8 0|62 1|", "8 blue|",
                                        "8 blue|62 1|"};
    static const int by_layer[] = {GREEN, GREEN, GREEN, BLUE, BLUE};
    static const int by_block[] = {GREEN, 0xffff00, RED, BLUE, RED};
    for (int i = 0; i < COUNT(inner); i++) {
        char blocks[800];
        snprintf(
            blocks, sizeof blocks,
            "%s0 BLOCK|8 0|2 outer|70 0|10 0|20 0|0 INSERT|%s2 four|10 0|20 0|0 ENDBLK|8 0|",
            four, inner[i]);
        batten_model *model = read_blocks(blocks, "0 INSERT|8 green|62 2|2 outer|10 0|20 0|");
        check_look(model, 0, i < 3 ? "green" : "blue", by_layer[i]);
        check_look(model, 1, i < 3 ? "green" : "blue", by_block[i]);
        check_look(model, 2, "blue", BLUE);
        batten_model_unref(model);
        model = read_blocks(blocks, "0 INSERT|8 green|2 outer|10 0|20 0|");
        check_look(model, 0, i < 3 ? "green" : "blue", by_layer[i]);
        check_look(model, 1, i < 3 ? "green" : "blue", i == 1 ? GREEN : by_block[i]);
        batten_model_unref(model);
    }
}

TEST(P1_a_block_that_holds_itself_is_left_out)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(
        read_text(file_of("",
                          "0 BLOCK|8 0|2 a|10 0|20 0|0 INSERT|8 0|2 b|10 0|20 0|0 ENDBLK|8 0|"
                          "0 BLOCK|8 0|2 b|10 0|20 0|0 INSERT|8 0|2 a|10 0|20 0|0 ENDBLK|8 0|",
                          "0 INSERT|8 0|2 a|10 0|20 0|0 INSERT|8 0|2 none|10 0|20 0|"
                          "0 LINE|8 0|10 0|20 0|11 0|21 1|"),
                  BATTEN_FORMAT_AUTO, notes, &model),
        BATTEN_PARTLY_READ);
    if (!batten_notes_dropped(notes)) {
        CHECK(has_note(notes, "block 'a' contains itself"));
        CHECK(has_note(notes, "block 'b' is empty: its contents are left out"));
        CHECK(has_note(notes, "there is no block 'none'"));
    }
    batten_model_unref(model);
    batten_notes_free(notes);
}

/* The last of `count` blocks holds a line, each other one the next. */
static const char *nest(int count)
{
    char *blocks = test_array(100 * (size_t)count, 1);
    for (int k = 0; k < count; k++)
        sprintf(
            blocks + strlen(blocks),
            k < count - 1
                ? "0 BLOCK|8 0|2 b%d|10 0|20 0|0 INSERT|8 0|2 b%d|10 1|20 0|0 ENDBLK|8 0|"
                : "0 BLOCK|8 0|2 b%d|10 0|20 0|0 LINE|8 0|10 0|20 0|11 1|21 0|0 ENDBLK|8 0|",
            k, k + 1);
    return file_of("", blocks, "0 INSERT|8 0|2 b0|10 0|20 0|0 LINE|8 0|10 0|20 0|11 0|21 1|");
}

TEST(P1_blocks_lie_32_deep_and_what_is_deeper_leaves_no_empty_instances)
{
    batten_model *model = NULL, *flat = NULL;
    CHECK_OK(read_text(nest(32), BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_OK(batten_model_flat(model, &flat));
    CHECK_INT(batten_model_count(flat), 2);
    CHECK_NEAR(batten_curve_box(batten_model_object(flat, 0)->curve).high.x, 32, 1e-12);
    batten_model_unref(flat);
    batten_model_unref(model);
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_STATUS(read_text(nest(33), BATTEN_FORMAT_AUTO, notes, &model), BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_CURVE);
    if (!batten_notes_dropped(notes)) {
        CHECK(has_note(notes, "block 'b32' lies more than 32 deep"));
        CHECK(has_note(notes, "block 'b0' is empty: its contents are left out"));
    }
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(faces_on_one_layer_become_one_mesh)
{
    batten_model *model = read_entities(
        "0 3DFACE|8 hull|10 0|20 0|30 0|11 1|21 0|31 0|12 1|22 1|32 0|13 0|23 1|33 0|"
        "0 3DFACE|8 hull|10 1|20 0|30 0|11 2|21 0|31 0|12 1|22 1|32 0|13 1|23 1|33 0|"
        "0 3DFACE|8 deck|10 0|20 0|30 1|11 1|21 0|31 1|12 1|22 1|32 1|13 1|23 1|33 1|");
    CHECK_INT(batten_model_count(model), 2);
    const batten_mesh_parts *mesh = batten_mesh_view(batten_model_object(model, 0)->mesh);
    CHECK_INT(mesh->triangle_count, 3);
    CHECK_INT(mesh->vertex_count, 5);
    CHECK_TEXT(batten_model_object(model, 1)->layer, "deck");
    batten_model_unref(model);
}

TEST(faces_of_other_colours_are_other_meshes)
{
    batten_model *model = read_entities("0 3DFACE|8 hull|10 0|11 1|12 1|22 1|62 1|"
                                        "0 3DFACE|8 hull|10 0|11 1|12 2|22 1|62 1|"
                                        "0 3DFACE|8 hull|10 0|11 1|12 1|22 2|62 5|"
                                        "0 3DFACE|8 hull|10 0|11 1|12 1|22 3|62 5|60 1|");
    CHECK_INT(batten_model_count(model), 3);
    CHECK_INT(batten_mesh_view(batten_model_object(model, 0)->mesh)->triangle_count, 2);
    CHECK_BITS(batten_model_object(model, 0)->colour[0], 1);
    CHECK_BITS(batten_model_object(model, 1)->colour[2], 1);
    CHECK(!batten_model_object(model, 1)->is_hidden &&
          batten_model_object(model, 2)->is_hidden);
    batten_model_unref(model);
}

TEST(texts_of_blocks_are_counted_as_left_out)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(read_text(file_of("", "0 BLOCK|2 a|10 0|0 POINT|10 1|0 ENDBLK|",
                                   "0 INSERT|2 a|66 1|0 ATTRIB|1 words|0 SEQEND|"),
                           BATTEN_FORMAT_DXF, notes, &model),
                 BATTEN_PARTLY_READ);
    if (!batten_notes_dropped(notes))
        CHECK(has_note(notes, "0 read, 1 left out"));
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(P2_a_bad_entity_is_left_out_and_the_next_is_read)
{
    static const struct {
        const char *entity, *words;
    } cases[] = {
        {"0 LINE|8 0|10 x|20 0|11 1|21 1|", "group 10 is 'x', not a number"},
        {"0 LINE|8 0|10 1e999|20 0|11 1|21 1|", "too large for a number"},
        {"0 LINE|8 0|10 nan|20 0|11 1|21 1|", "not a number"},
        {"0 CIRCLE|8 0|10 0|20 0|40 -1|", "its radius is -1"},
        {"0 CIRCLE|8 0|10 0|20 0|40 1|230 0|", "the normal of its plane is 0"},
        {"0 ELLIPSE|8 0|10 0|20 0|11 0|21 0|40 1|", "its half axes are 0 and 0"},
        {"0 SPLINE|8 0|70 0|71 3|40 0|40 1|10 0|20 0|10 1|20 1|",
         "group 40 appears 2 times, expected 6"},
        {"0 SPLINE|8 0|70 0|71 99|10 0|20 0|", "its degree is 99"},
        {"0 SPLINE|8 0|70 0|71 1|40 0|40 0|40 1|40 1|10 0|20 0|10 1|",
         "group 20 appears 1 times"},
        {"0 LWPOLYLINE|8 0|90 1|10 0|20 0|", "a path of 1 point"},
        {"0 POLYLINE|8 0|70 64|0 VERTEX|10 0|20 0|0 SEQEND|8 0|",
         "it is a mesh, and its 0 faces are not valid"},
        {"0 POLYLINE|8 0|70 64|0 VERTEX|70 192|10 0|20 0|0 VERTEX|70 128|71 1|72 1|73 2|"
         "0 SEQEND|8 0|",
         "it is a mesh, and its 1 face is not valid"},
        {"0 POLYLINE|8 0|70 16|71 2|72 1000000|0 VERTEX|70 64|10 0|20 0|0 SEQEND|8 0|",
         "it has 1 points where its grid of 2 x 1000000"},
        {"0 INSERT|8 0|2 nothing|", "there is no block 'nothing'"},
        {"0 LINE|8 0|67 1|10 0|20 0|11 1|21 1|", "it is on paper"},
        {"0 TEXT|8 0|1 hello|", "0 read, 1 left out"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[512];
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        snprintf(text, sizeof text, "%s0 POINT|8 0|10 4|20 5|30 6|", cases[i].entity);
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_STATUS(read_text(file_of("", "", text), BATTEN_FORMAT_DXF, notes, &model),
                     BATTEN_PARTLY_READ);
        CHECK_INT(batten_model_count(model), 1);
        if (!batten_notes_dropped(notes))
            CHECK(has_note(notes, cases[i].words));
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(Q1_lines_that_are_no_codes_are_refused_by_number)
{
    check_refused("0\nSECTION\n2\nENTITIES\nzero\nLINE\n", BATTEN_FORMAT_DXF, BATTEN_BAD_FORMAT,
                  "t:5: 'zero' is not the code of a group");
    check_refused(lines("0 SECTION|2 ENTITIES|0 TEXT|1 a|0 ENDSEC|0 EOF"), BATTEN_FORMAT_AUTO,
                  BATTEN_UNSUPPORTED, "its 1 entity could not be read");
}

TEST(F3_line_ends_of_every_kind_say_the_same)
{
    const char *text = file_of("", "", "0 LINE|8 0|10 0|20 0|11 1|21 1|");
    const size_t size = strlen(text);
    char *windows = test_array(2 * size + 1, 1), *mac = test_array(size + 1, 1);
    size_t at = 0;
    for (size_t i = 0; i < size; i++) {
        if (text[i] == '\n')
            windows[at++] = '\r';
        windows[at++] = text[i];
        mac[i] = text[i] == '\n' ? '\r' : text[i];
    }
    const char *const texts[] = {windows, mac};
    for (int i = 0; i < 2; i++) {
        batten_model *model = NULL;
        CHECK_OK(read_text(texts[i], BATTEN_FORMAT_AUTO, NULL, &model));
        CHECK_INT(batten_model_count(model), 1);
        batten_model_unref(model);
    }
}

TEST(F2_a_dxf_file_cut_anywhere_is_never_whole)
{
    const char *text = file_of("0 LAYER|2 a|70 0|62 1|", "0 BLOCK|2 b|10 0|20 0|0 ENDBLK|8 0|",
                               "0 LINE|8 0|10 0|20 0|11 1|21 1|0 INSERT|2 b|8 0|");
    const size_t size = strlen(text);
    for (size_t length = 12; length < size - 4; length++) {
        batten_model *model = NULL;
        CHECK(read_bytes(text, length, BATTEN_FORMAT_DXF, NULL, &model) != BATTEN_OK);
        batten_model_unref(model);
    }
}

TEST(what_is_written_as_dxf_reads_back)
{
    const double points[] = {0, 0, 1, 1, 2, 1.5, 3, -1, 2, 4, 0, 0.25};
    const double knots[] = {0, 0, 0, 0.5, 1, 1, 1};
    const batten_frame frame = batten_frame_across(0, 2);
    batten_curve *spline = NULL, *arc = NULL;
    batten_model *model = NULL, *back = NULL;
    char *first = NULL;
    size_t size = 0;
    CHECK_OK(batten_curve_create((batten_points){3, 4, points}, 2, NULL, knots, &spline));
    CHECK_OK(batten_curve_arc_in(&frame, 3, 0.5, 4, &arc));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){
                   .name = "s", .layer = "L", .kind = BATTEN_OBJECT_CURVE, .curve = spline}));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "a", .kind = BATTEN_OBJECT_CURVE, .curve = arc}));
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_DXF, &first, &size));
    CHECK_OK(read_bytes(first, size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_INT(batten_model_count(back), 2);
    CHECK_BITS(batten_model_unit_metres(back), 1);
    CHECK_TEXT(batten_model_object(back, 0)->layer, "L");
    const batten_curve *read = batten_model_object(back, 0)->curve;
    for (int i = 0; i < 12; i++)
        CHECK_BITS(batten_curve_points(read)[i], points[i]);
    for (int i = 0; i <= 20; i++) { /* the arc, cut at other places */
        double p[3];
        point_of(back, 1, i / 20.0, p);
        CHECK_NEAR(p[0], 2, 1e-14);
        CHECK_NEAR(hypot(p[1], p[2]), 3, 1e-13);
    }
    batten_release(first);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_curve_unref(spline);
    batten_curve_unref(arc);
}

/* Its parts may be bare. */
TEST(polylines_of_dxf_lie_on_the_layer_of_their_first_entity)
{
    batten_model *model = read_entities("0 POLYLINE|8 deck|62 1|66 1|70 8|0 VERTEX|10 0|20 0|"
                                        "0 VERTEX|10 1|20 1|30 1|0 SEQEND|");
    CHECK_INT(batten_model_count(model), 1);
    CHECK_TEXT(batten_model_object(model, 0)->layer, "deck");
    CHECK(batten_model_object(model, 0)->has_colour);
    batten_model_unref(model);
}

TEST(N4_codes_beyond_an_integer_are_refused)
{
    static const char *const codes[] = {"1e154", "-1e99", "1e10", "1.5", "1072", "-6", "nan"};
    for (int i = 0; i < COUNT(codes); i++) {
        char text[80];
        snprintf(text, sizeof text, "0\nSECTION\n2\nENTITIES\n%s\nLINE\n0\nEOF\n", codes[i]);
        check_refused(text, BATTEN_FORMAT_DXF, BATTEN_BAD_FORMAT, "t:5: ");
    }
}

/* A name with just these letters goes before one with other capitals. */
TEST(names_of_blocks_and_layers_are_the_same_in_capitals_or_not)
{
    enum { GREEN = 0x00ff00, BLUE = 0x0000ff };
    batten_model *model =
        read_blocks("0 BLOCK|8 0|2 Bolt|10 0|20 0|0 POINT|8 0|10 1|20 0|"
                    "0 ENDBLK|8 0|0 BLOCK|8 0|2 bolt|10 0|20 0|"
                    "0 POINT|8 0|10 2|20 0|0 ENDBLK|8 0|"
                    "0 BLOCK|8 0|2 C_\xc3\xa9|10 0|20 0|0 POINT|8 0|10 3|20 0|"
                    "0 ENDBLK|8 0|",
                    "0 INSERT|8 GREEN|2 bolt|10 0|20 0|"
                    "0 INSERT|8 Green|2 BOLT|10 0|20 0|"
                    "0 INSERT|8 other|2 c_\xc3\xa9|10 0|20 0|"
                    "0 LINE|8 BLUE|10 0|20 0|11 1|21 1|");
    batten_model *flat = NULL;
    CHECK_INT(batten_model_count(model), 4);
    check_look(model, 0, "green", GREEN);
    check_look(model, 1, "green", GREEN);
    check_look(model, 3, "blue", BLUE);
    CHECK_TEXT(batten_model_object(model, 1)->name, "Bolt");
    CHECK_OK(batten_model_flat(model, &flat));
    CHECK_NEAR(batten_model_object(flat, 0)->points[0], 2, 0);
    CHECK_NEAR(batten_model_object(flat, 1)->points[0], 1, 0);
    CHECK_NEAR(batten_model_object(flat, 2)->points[0], 3, 0);
    batten_model_unref(flat);
    batten_model_unref(model);
}

/* The ways from place to place are turned with the block, and not scaled. */
TEST(arrays_of_blocks_are_as_many_instances)
{
    enum { RED = 0xff0000, GREEN = 0x00ff00 };
    batten_model *model = read_blocks("0 BLOCK|8 0|2 b|10 5|20 0|0 POINT|8 0|10 6|20 0|"
                                      "0 POINT|8 0|62 0|10 5|20 0|0 ENDBLK|8 0|",
                                      "0 INSERT|8 green|62 1|2 b|10 100|20 10|41 2|42 2|43 2|"
                                      "50 90|70 3|71 2|44 7|45 20|210 0|220 0|230 -1|"
                                      "0 INSERT|8 0|2 b|10 0|20 0|70 0|71 -3|");
    batten_model *flat = NULL;
    CHECK_INT(batten_model_count(model), 7);
    check_look(model, 10, "green", GREEN);
    check_look(model, 11, "green", RED);
    CHECK(batten_model_object(model, 0)->definition ==
          batten_model_object(model, 5)->definition);
    CHECK_OK(batten_model_flat(model, &flat));
    for (int i = 0; i < 6; i++) { /* x of the plane is -x of the world */
        const double *p = batten_model_object(flat, 2 * i)->points;
        const double x = 100 - i / 3 * 20, y = 10 + i % 3 * 7;
        CHECK_NEAR(p[0], -x, 1e-13);
        CHECK_NEAR(p[1], y + 2, 1e-13);
        CHECK_NEAR(p[2], 0, 1e-13);
    }
    batten_model_unref(flat);
    batten_model_unref(model);
}

TEST(P1_arrays_that_are_too_large_or_in_one_place_are_told)
{
    static const struct {
        const char *array, *words;
        int count;
    } cases[] = {
        {"70 1000000|71 1000000|44 1|45 1|", "it is an array of 1000000 x 1000000", 1},
        {"70 2147483647|71 2147483647|44 1|45 1|", "arrays may have at most 100000 places", 1},
        {"70 3|71 30000|44 1|45 1|", "it is an array of 3 x 30000", 20001},
        {"70 5|71 2|45 1|", "its 5 columns lie 0 apart", 3},
        {"70 5|71 2|44 1|", "its 2 rows lie 0 apart", 6},
        {"70 5|44 1e999|", "which is too large for a number", 1},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[512];
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        snprintf(text, sizeof text, "%s0 INSERT|8 0|2 b|10 0|20 0|%s0 POINT|8 0|10 1|20 0|",
                 i == 2 ? "0 INSERT|8 0|2 b|10 0|20 0|70 2|71 10000|44 1|45 1|" : "",
                 cases[i].array);
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_STATUS(
            read_text(file_of("",
                              "0 BLOCK|8 0|2 b|10 0|20 0|0 POINT|8 0|10 6|20 0|0 ENDBLK|8 0|",
                              text),
                      BATTEN_FORMAT_DXF, notes, &model),
            i == 3 || i == 4 ? BATTEN_OK : BATTEN_PARTLY_READ);
        CHECK_INT(batten_model_count(model), cases[i].count);
        if (!batten_notes_dropped(notes))
            CHECK(has_note(notes, cases[i].words));
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

/* A tetrahedron without its last side, whose faces have hidden sides and one a corner twice; a
 * vertex that is no corner; the look is that of the POLYLINE. */
TEST(polylines_that_are_meshes_of_faces_are_read)
{
    batten_model *model =
        read_entities("0 POLYLINE|8 deck|62 1|66 1|70 64|71 4|72 3|"
                      "0 VERTEX|70 192|10 0|20 0|30 0|0 VERTEX|70 192|10 1|20 0|30 0|"
                      "0 VERTEX|70 192|10 0|20 1|30 0|0 VERTEX|70 192|10 0|20 0|30 1|"
                      "0 VERTEX|70 128|10 0|20 0|30 0|71 1|72 -3|73 2|74 2|"
                      "0 VERTEX|70 128|10 0|20 0|30 0|71 -1|72 2|73 4|"
                      "0 VERTEX|70 128|10 0|20 0|30 0|71 1|72 4|73 3|74 0|0 SEQEND|8 0|");
    const batten_object *object = batten_model_object(model, 0);
    CHECK(batten_model_count(model) == 1 && object->kind == BATTEN_OBJECT_MESH);
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    CHECK_TEXT(object->layer, "deck");
    CHECK(object->has_colour && object->colour[0] == 1 && object->colour[1] == 0);
    CHECK_INT(p->vertex_count, 4);
    CHECK_INT(p->triangle_count, 3);
    CHECK(p->corners[0] == 0 && p->corners[1] == 2 && p->corners[2] == 1);
    batten_model_unref(model);
}

/* A ring of 4 by 3 points, closed one way, and its smooth form among which control points lie.
 */
TEST(polylines_that_are_grids_are_read)
{
    for (int kind = 0; kind < 4; kind++) {
        char text[4096];
        const bool is_smooth = kind / 2, across = kind % 2;
        snprintf(text, sizeof text, "0 POLYLINE|8 0|66 1|70 %d|71 %d|72 %d|73 4|74 3|75 %d|",
                 16 + (across ? 32 : 1) + (is_smooth ? 4 : 0), is_smooth ? 9 : 4,
                 is_smooth ? 9 : 3, is_smooth ? 5 : 0);
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 3; j++)
                snprintf(text + strlen(text), sizeof text - strlen(text),
                         "0 VERTEX|70 %d|10 %d|20 %d|30 %d|%s", is_smooth ? 72 : 64, i, j,
                         i * i + j * j, is_smooth ? "0 VERTEX|70 80|10 5|20 5|30 5|" : "");
        strcat(text, "0 SEQEND|8 0|");
        batten_model *model = read_entities(text);
        CHECK(batten_model_object(model, 0)->kind == BATTEN_OBJECT_MESH);
        const batten_mesh_parts *p = batten_mesh_view(batten_model_object(model, 0)->mesh);
        CHECK_INT(p->vertex_count, 12);
        CHECK_INT(p->triangle_count, across ? 2 * 3 * 3 : 2 * 4 * 2);
        CHECK_BITS(p->points[3 * 7], 2.0);
        batten_model_unref(model);
    }
}

TEST(faces_of_polylines_without_their_corners_are_left_out_with_their_line)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(read_text(file_of("", "",
                                   "0 POLYLINE|8 0|70 64|0 VERTEX|70 192|10 0|20 0|"
                                   "0 VERTEX|70 192|10 1|20 0|0 VERTEX|70 192|10 1|20 1|"
                                   "0 VERTEX|70 128|71 1|72 2|73 3|"
                                   "0 VERTEX|70 128|71 1|72 2|73 7|0 SEQEND|8 0|"),
                           BATTEN_FORMAT_DXF, notes, &model),
                 BATTEN_PARTLY_READ);
    CHECK_INT(batten_mesh_view(batten_model_object(model, 0)->mesh)->triangle_count, 1);
    bool said = batten_notes_dropped(notes) > 0;
    for (int i = 0; i < batten_notes_count(notes); i++)
        said |= strstr(batten_notes_at(notes, i)->text, "its corner 3 is vertex 7") &&
                batten_notes_at(notes, i)->line == 78;
    CHECK(said);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(a_file_without_entities_is_an_empty_model)
{
    batten_model *model =
        read_noting("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", BATTEN_FORMAT_DXF, "");
    CHECK_INT(batten_model_count(model), 0);
    batten_model_unref(model);
}
