/* Faces of solids and shells: their loops, their curves in the plane, on which side they are. */
#include "exchange/iges/faces.h"

#include <stdlib.h>

static const char part[] = "00010000", root[] = "00000000";

/* A polygon of vertices `first` to `first` + `count` - 1 of D5, its edges with the same numbers in
 * D(*edges), as a 508. */
typedef struct {
    int first, count;
} polygon;

static int add_polygon(iges_text *file, polygon p, int edges)
{
    char text[300];
    snprintf(text, sizeof text, "508,%d", p.count);
    for (int i = 0; i < p.count; i++)
        snprintf(text + strlen(text), 40, ",0,%d,%d,1,0", edges, p.first + i);
    return iges_add(file, 508, 1, 0, 0, part, strcat(text, ";"));
}

/* A square of 8 with a triangle and a square of 1 as holes, loops of 4, 3 and 4 edges. */
static const double corners[11][2] = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {1, 1}, {1, 3},
                                      {2, 1}, {5, 5}, {5, 6}, {6, 6}, {6, 5}};
static const polygon polygons[3] = {{1, 4}, {5, 3}, {8, 4}};

/* The list of edges of all polygons, with the vertices of D`vertices`. */
static int add_edges(iges_text *file, int vertices)
{
    char list[600] = "504,11", text[120];
    for (int p = 0; p < 3; p++)
        for (int i = 0; i < polygons[p].count; i++) {
            const int a = polygons[p].first + i,
                      b = polygons[p].first + (i + 1) % polygons[p].count;
            snprintf(text, sizeof text, "110,%g,%g,0.,%g,%g,0.;", corners[a - 1][0],
                     corners[a - 1][1], corners[b - 1][0], corners[b - 1][1]);
            const int line = iges_add(file, 110, 0, 0, 0, part, text);
            snprintf(list + strlen(list), 60, ",%d,%d,%d,%d,%d", line, vertices, a, vertices,
                     b);
        }
    return iges_add(file, 504, 1, 0, 0, part, strcat(list, ";"));
}

/* All of it as a 510, with this normal of the plane. */
static int add_pierced(iges_text *file, const char *normal)
{
    char text[600] = "502,11";
    iges_add(file, 116, 0, 0, 0, part, "116,0.,0.,0.;"); /* 1 */
    iges_add(file, 123, 0, 0, 0, part, normal);          /* 3 */
    for (int i = 0; i < 11; i++)
        snprintf(text + strlen(text), 40, ",%g,%g,0.", corners[i][0], corners[i][1]);
    const int vertices = iges_add(file, 502, 1, 0, 0, part, strcat(text, ";"));
    const int edges = add_edges(file, vertices);
    const int plane = iges_add(file, 190, 0, 0, 0, part, "190,1,3;");
    int loops[3];
    for (int p = 0; p < 3; p++)
        loops[p] = add_polygon(file, polygons[p], edges);
    snprintf(text, sizeof text, "510,%d,3,1,%d,%d,%d;", plane, loops[0], loops[1], loops[2]);
    return iges_add(file, 510, 1, 0, 2, part, text);
}

/* By itself, and in a shell with it and against it: loops keep their edges, in the other order
 * where the face is reversed. */
TEST(a_face_keeps_all_its_loops_in_order)
{
    for (int k = 0; k < 3; k++) {
        iges_text file = iges_begin();
        char text[60];
        const int face = add_pierced(&file, "123,0.,0.,1.;");
        if (k > 0) {
            snprintf(text, sizeof text, "514,1,%d,%d;", face, k == 1);
            iges_add(&file, 514, 2, 0, 0, root, text);
        } else
            memcpy(file.directory + (size_t)(file.entries - 1) * 2 * 81 + 64, root, 8);
        batten_model *model = iges_body(&file, "");
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        const bool reversed = k == 2;
        CHECK_INT(p->loop_count, 3);
        CHECK_INT(p->vertex_count, 11);
        CHECK_INT(p->faces[0].reversed, reversed);
        CHECK(p->faces[0].has_colour && p->faces[0].colour[0] == 1);
        for (int l = 0; l < 3; l++) {
            const batten_body_loop *loop = &p->loops[l];
            CHECK_INT(loop->count, polygons[l].count);
            for (int i = 0; i < loop->count; i++) {
                const batten_body_use *use = &p->uses[loop->first + i];
                const int due = polygons[l].first - 1 + (reversed ? loop->count - 1 - i : i);
                CHECK_INT(use->edge, due);
                CHECK_INT(use->reversed, reversed);
            }
        }
        CHECK(!p->is_solid && !p->shells[0].closed);
        iges_check_area(model, 64 - 1 - 1);
        batten_model_unref(model);
    }
}

/* A triangle in a square of parameters: its edges with no curve in (u, v), one, one that runs
 * against it, an index of nothing, two; and a vertex as an edge, which says nothing of its shape. */
static const struct {
    const char *loop, *words;
    int flats;
} uses[] = {
    {"508,3,0,11,1,1,0,0,11,2,1,0,0,11,3,1,0;", "", 0},
    {"508,3,0,11,1,1,1,0,13,0,11,2,1,1,0,15,0,11,3,1,1,0,17;", "", 3},
    {"508,3,0,11,1,1,1,1,13,0,11,2,1,0,0,11,3,1,1,0,19;", "", 2},
    {"508,3,0,11,1,1,1,0,0,0,11,2,1,2,0,15,0,15,0,11,3,1,1,0,17;", "", 1},
    {"508,4,0,11,1,1,0,1,3,2,1,0,0,11,2,1,0,0,11,3,1,0;", "", 0},
    {"508,3,0,11,1,1,1,0,99,0,11,2,1,0,0,11,3,1,0;",
     "it refers to entity D99, which is missing; left out", -1},
    {"508,3,0,11,1,1,0,0,11,4,1,0,0,11,3,1,0;",
     "it refers to number 4 of list D11, which has 3; left out", -1},
    {"508,3,0,11,1,1,0,0,11,0,1,0,0,11,3,1,0;",
     "it refers to number 0 of list D11, which has 3; left out", -1},
    {"508,3,0,11,1,1,-1,0,11,2,1,0,0,11,3,1,0;", "", -1},
    {"508,3,0,3,1,1,0,0,11,2,1,0,0,11,3,1,0;",
     "it refers to entity D3 as type 504, which is of type 502; left out", -1},
    {"508,3,0,11,1,1,0,0,11,2,1,0;", "parameters, need", -1},
};

TEST(edges_of_a_face_have_the_one_curve_in_the_plane_that_is_given)
{
    for (int i = 0; i < COUNT(uses); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);                            /* 1 */
        iges_add(&file, 502, 1, 0, 0, part, "502,3,1.,1.,0.,3.,1.,0.,1.,2.,0.;");    /* 3 */
        iges_add(&file, 110, 0, 0, 0, part, "110,1.,1.,0.,3.,1.,0.;");               /* 5 */
        iges_add(&file, 110, 0, 0, 0, part, "110,3.,1.,0.,1.,2.,0.;");               /* 7 */
        iges_add(&file, 110, 0, 0, 0, part, "110,1.,2.,0.,1.,1.,0.;");               /* 9 */
        iges_add(&file, 504, 1, 0, 0, part, "504,3,5,3,1,3,2,7,3,2,3,3,9,3,3,3,1;"); /* 11 */
        iges_add(&file, 110, 0, 0, 0, "00010500", "110,1.,1.,0.,3.,1.,0.;");         /* 13 */
        iges_add(&file, 110, 0, 0, 0, "00010500", "110,3.,1.,0.,1.,2.,0.;");         /* 15 */
        iges_add(&file, 110, 0, 0, 0, "00010500", "110,1.,2.,0.,1.,1.,0.;");         /* 17 */
        iges_add(&file, 110, 0, 0, 0, "00010500", "110,1.,1.,0.,1.,2.,0.;");         /* 19 */
        iges_add(&file, 508, 1, 0, 0, part, uses[i].loop);                           /* 21 */
        iges_add(&file, 510, 1, 0, 0, root, "510,1,1,1,21;");
        if (uses[i].flats < 0) {
            iges_check_left_out(&file, uses[i].words);
            continue;
        }
        batten_model *model = iges_body(&file, uses[i].words);
        CHECK_INT(batten_body_view(batten_model_object(model, 0)->body)->edge_count, 3);
        CHECK_INT(iges_check_plane_curves(model), uses[i].flats);
        iges_check_area(model, 1);
        batten_model_unref(model);
    }
}

/* 508, 510 and 514 within others stand where they are; lists of vertices and edges as well. */
TEST(matrices_of_parts_are_refused_by_name)
{
    static const struct {
        int type;
        const char *words;
    } cases[] = {{502, "the matrix of list D"},
                 {504, "the matrix of list D"},
                 {508, "the matrix of D"},
                 {510, "the matrix of D"},
                 {514, "the matrix of D"}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        char text[60], words[60];
        const int face = add_pierced(&file, "123,0.,0.,1.;");
        snprintf(text, sizeof text, "514,1,%d,1;", face);
        const int shell = iges_add(&file, 514, 2, 0, 0, part, text);
        snprintf(text, sizeof text, "186,%d,1,0;", shell);
        iges_add(&file, 186, 0, 0, 0, root, text);
        int id = 0;
        for (int k = file.entries; k > 0; k--)
            if (atoi(file.directory + (size_t)(k - 1) * 2 * 81) == cases[i].type)
                id = 2 * k - 1;
        char matrix[12];
        snprintf(matrix, sizeof matrix, "%8d", 2 * file.entries + 1);
        memcpy(file.directory + (size_t)(id - 1) * 81 + 48, matrix, 8);
        iges_add(&file, 124, 0, 0, 0, "00000000", "124,1.,,,,,1.,,,,,1.,;");
        iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
        snprintf(words, sizeof words, "%s%d%s is not read", cases[i].words, id,
                 cases[i].type < 508 ? "" : ", a part,");
        iges_check_partly(&file, words);
    }
}

TEST(a_face_names_what_it_refers_to)
{
    static const struct {
        const char *face, *words;
    } cases[] = {
        {"510,1,1,1,3;", "it refers to entity D3 as type 508, which is of type 110; left out"},
        {"510,1,1,1,99;", "it refers to entity D99, which is missing; left out"},
        {"510,3,0,1;", "it refers to entity D3 as a surface, which is a 110 line; left out"},
        {"510,1,2,1,3;", "5 parameters, need 6; left out"},
        {"510,1,-1,1;", "parameter 2, a count, is -1; left out"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        iges_add(&file, 110, 0, 0, 0, part, IGES_LINE);
        iges_add(&file, 510, 1, 0, 0, root, cases[i].face);
        iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
        iges_check_partly(&file, cases[i].words);
    }
}

/* Without a resolution the tolerance is a millionth or so of the size: of the edges, or of the
 * surface of a face that has none. */
TEST(the_tolerance_of_a_body_is_that_of_its_edges)
{
    static const struct {
        const char *face;
        double size;
    } cases[] = {{"510,1,0,0;", 5.656854249492381}, {"510,1,1,1,9;", 0.02}};
    static const char global[] = "1H,,1H;,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,6,1HM,1,0.,"
                                 "13H260101.000000,0.,,,,11,0,;";
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        iges_add(&file, 502, 1, 0, 0, part, "502,1,2.01,2.,0.;");
        iges_add(&file, 100, 0, 0, 0, part, "100,0.,2.,2.,2.01,2.,2.01,2.;");
        iges_add(&file, 504, 1, 0, 0, part, "504,1,5,3,1,3,1;");
        iges_add(&file, 508, 1, 0, 0, part, "508,1,0,7,1,1,0;");
        iges_add(&file, 510, 1, 0, 0, root, cases[i].face);
        batten_model *model = NULL;
        CHECK_OK(read_text(iges_end(&file, global), BATTEN_FORMAT_AUTO, NULL, &model));
        const batten_object *last = batten_model_object(model, batten_model_count(model) - 1);
        const double tolerance = batten_body_view(last->body)->tolerance;
        CHECK(tolerance >= 0.9e-6 * cases[i].size && tolerance <= 3e-6 * cases[i].size);
        batten_model_unref(model);
    }
}
