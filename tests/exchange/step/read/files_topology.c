/* Loops, faces and shells, with all their flags: whatever is turned, outside stays outside. */
#include "exchange/step/boxes.h"

static const double ORIGIN[] = {1, 2, 3};

/* A file with one item, #1000, in a representation. */
static const char *finish(box_text *text)
{
    box_context(text, 900);
    box_add(text, "#990=SHAPE_REPRESENTATION('',(#1000),#900);\n");
    return box_end(text);
}

TEST(whatever_is_turned_of_a_box_its_outside_stays_outside)
{
    for (unsigned turns = 0; turns < BOX_ALL; turns++) {
        box_text text;
        batten_model *model = NULL;
        box_shell(box_begin(&text), 1, ORIGIN, 2, turns);
        box_add(&text, "#1000=MANIFOLD_SOLID_BREP('box',#181);\n");
        const char *file = finish(&text);
        CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
        CHECK_INT(batten_model_count(model), 1);
        const batten_object *object = batten_model_object(model, 0);
        CHECK_TEXT(object->name, "box");
        CHECK_INT(object->kind, BATTEN_OBJECT_BODY);
        const batten_body_parts *parts = batten_body_view(object->body);
        CHECK_INT(parts->vertex_count, 8);
        CHECK_INT(parts->edge_count, 12);
        CHECK_INT(parts->use_count, 24);
        CHECK_INT(parts->face_count, 6);
        CHECK_TEXT(parts->faces[3].name, "side 3");
        CHECK(parts->is_solid && parts->shells[0].closed);
        const batten_body_measures measures = box_measure(object->body);
        CHECK(measures.is_closed);
        CHECK_NEAR(measures.volume, 8, 1e-9);
        CHECK_NEAR(measures.area, 24, 1e-9);
        CHECK_NEAR(measures.centroid[2], 4, 1e-9);
        batten_model_unref(model);
    }
}

TEST(a_void_is_a_further_shell_that_looks_into_itself)
{
    static const double inner[] = {1.5, 2.5, 3.5};
    static const char *const solids[] = {
        "#1000=BREP_WITH_VOIDS('hollow',#181,(#850));\n",
        "#1000=(BREP_WITH_VOIDS((#850))GEOMETRIC_REPRESENTATION_ITEM()MANIFOLD_SOLID_BREP(#181)"
        "REPRESENTATION_ITEM('hollow')SOLID_MODEL());\n"};
    for (int k = 0; k < 2; k++) {
        box_text text;
        batten_model *model = NULL;
        box_shell(box_begin(&text), 1, ORIGIN, 2, 0);
        box_shell(&text, 301, inner, 1, 0);
        box_add(&text, "#850=ORIENTED_CLOSED_SHELL('',*,#481,.F.);\n%s", solids[k]);
        const char *file = finish(&text);
        CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
        const batten_object *object = batten_model_object(model, 0);
        CHECK_TEXT(object->name, "hollow");
        CHECK_INT(batten_body_view(object->body)->shell_count, 2);
        CHECK_NEAR(box_measure(object->body).volume, 7, 1e-9);
        batten_model_unref(model);
    }
}

TEST(shells_and_faces_alone_are_sheets)
{
    static const struct {
        const char *item;
        int faces, shells;
    } cases[] = {{"#1000=SHELL_BASED_SURFACE_MODEL('s',(#181));\n", 6, 1},
                 {"#1000=FACE_BASED_SURFACE_MODEL('s',(#1001));\n"
                  "#1001=CONNECTED_FACE_SET('',(#151,#152));\n",
                  2, 1},
                 {"#1000=OPEN_SHELL('s',(#151,#153,#155));\n", 3, 1},
                 {"#1000=ORIENTED_OPEN_SHELL('s',*,#1001,.F.);\n"
                  "#1001=OPEN_SHELL('',(#151,#153,#155));\n",
                  3, 1},
                 {"#1000=ADVANCED_FACE('s',(#141),#231,.T.);\n", 1, 1},
                 {"#1000=GEOMETRIC_SET('s',(#151,#152));\n", 1, 1}};
    for (int k = 0; k < COUNT(cases); k++) {
        box_text text;
        batten_model *model = NULL;
        box_shell(box_begin(&text), 1, ORIGIN, 2, 0);
        box_add(&text, "%s", cases[k].item);
        const char *file = finish(&text);
        CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->kind, BATTEN_OBJECT_BODY);
        CHECK_INT(batten_body_view(object->body)->face_count, cases[k].faces);
        CHECK_INT(batten_body_view(object->body)->shell_count, cases[k].shells);
        CHECK(!batten_body_view(object->body)->is_solid);
        batten_model_unref(model);
    }
}

TEST(polygons_share_their_sides_and_make_their_planes)
{
    static const char *const surfaces[] = {"", ",#1100,.T."};
    for (int k = 0; k < 2; k++) {
        static const int corners[4][3] = {{1, 3, 2}, {1, 2, 5}, {1, 5, 3}, {2, 3, 5}};
        static const double z[3] = {0, 0, -1}, x[3] = {1, 0, 0};
        box_text text;
        batten_model *model = NULL;
        box_edges(box_begin(&text), 1, ORIGIN, 2, 0);
        for (int f = 0; f < 4; f++) {
            box_add(&text, "#%d=POLY_LOOP('',(#%d,#%d,#%d));\n", 1010 + f, corners[f][0],
                    corners[f][1], corners[f][2]);
            box_add(&text, "#%d=FACE_OUTER_BOUND('',#%d,.T.);\n", 1020 + f, 1010 + f);
            box_add(&text, "#%d=%s('',(#%d)%s);\n", 1030 + f,
                    f == 0 && k ? "FACE_SURFACE" : "FACE", 1020 + f, f == 0 ? surfaces[k] : "");
        }
        box_placement(&text, 1110, ORIGIN, z, x);
        box_add(&text, "#1100=PLANE('',#1110);\n"
                       "#1001=CLOSED_SHELL('',(#1030,#1031,#1032,#1033));\n"
                       "#1000=FACETED_BREP('tetrahedron',#1001);\n");
        const char *file = finish(&text);
        CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
        const batten_body *body = batten_model_object(model, 0)->body;
        CHECK_INT(batten_body_view(body)->edge_count, 6);
        CHECK_INT(batten_body_view(body)->vertex_count, 4);
        CHECK_NEAR(box_measure(body).volume, 8.0 / 6, 1e-9);
        batten_model_unref(model);
    }
}
