/* Solids of IGES: shared edges and vertices, flags of orientation. */
#include "exchange/iges/read/topology.h"

#include "exchange/iges/text.h"

static const char part[] = "00010000";

/* A cube with a corner at (at, at, at) as 514 of planes 190. The outside of the shell is away
 * from the middle or not; bit f says that face f agrees with its normal, and loops run around
 * the normals or around the outside. */
typedef struct {
    double at, size;
    bool outward, around_outside;
    unsigned agrees;
} cube;

static const int cube_edges[12][2] = {{1, 2}, {2, 4}, {4, 3}, {3, 1}, {5, 6}, {6, 8},
                                      {8, 7}, {7, 5}, {1, 5}, {2, 6}, {3, 7}, {4, 8}};
/* Each loop as its corners, counter-clockwise seen from outside; vertex 1 + x + 2 y + 4 z.
 */
static const int cube_loops[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                                     {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
static const double cube_normals[6][3] = {{0, 0, -1}, {0, 0, 1},  {0, -1, 0},
                                          {0, 1, 0},  {-1, 0, 0}, {1, 0, 0}};

static int add_shell(iges_text *file, const cube *c)
{
    char text[600] = "502,8";
    for (int k = 0; k < 8; k++)
        snprintf(text + strlen(text), 60, ",%g,%g,%g", c->at + c->size * (k & 1),
                 c->at + c->size * (k >> 1 & 1), c->at + c->size * (k >> 2));
    strcat(text, ";");
    const int vertices = iges_add(file, 502, 1, 0, 0, part, text);
    char list[600] = "504,12";
    for (int k = 0; k < 12; k++) {
        const int a = cube_edges[k][0] - 1, b = cube_edges[k][1] - 1;
        snprintf(text, sizeof text, "110,%g,%g,%g,%g,%g,%g;", c->at + c->size * (a & 1),
                 c->at + c->size * (a >> 1 & 1), c->at + c->size * (a >> 2),
                 c->at + c->size * (b & 1), c->at + c->size * (b >> 1 & 1),
                 c->at + c->size * (b >> 2));
        const int curve = iges_add(file, 110, 0, 0, 0, part, text);
        snprintf(list + strlen(list), 60, ",%d,%d,%d,%d,%d", curve, vertices, a + 1, vertices,
                 b + 1);
    }
    strcat(list, ";");
    const int all = iges_add(file, 504, 1, 0, 0, part, list);
    char shell[200] = "514,6";
    for (int f = 0; f < 6; f++) {
        char loop[200] = "508,4";
        const bool agrees = c->agrees >> f & 1, normal_outward = c->outward == agrees;
        const bool runs_outward = c->around_outside ? c->outward : normal_outward;
        for (int i = 0; i < 4; i++) {
            /* Around what points inwards the loop runs the other way. */
            const int at = runs_outward ? i : 3 - i,
                      next = runs_outward ? (i + 1) % 4 : (6 - i) % 4;
            const int from = cube_loops[f][at], to = cube_loops[f][next];
            int k = 0;
            while (!((cube_edges[k][0] == from && cube_edges[k][1] == to) ||
                     (cube_edges[k][0] == to && cube_edges[k][1] == from)))
                k++;
            snprintf(loop + strlen(loop), 60, ",0,%d,%d,%d,0", all, k + 1,
                     cube_edges[k][0] == from);
        }
        strcat(loop, ";");
        const int corner = cube_loops[f][0] - 1;
        snprintf(text, sizeof text, "116,%g,%g,%g;", c->at + c->size * (corner & 1),
                 c->at + c->size * (corner >> 1 & 1), c->at + c->size * (corner >> 2));
        const int point = iges_add(file, 116, 0, 0, 0, part, text);
        const double side = normal_outward ? 1 : -1;
        snprintf(text, sizeof text, "123,%g,%g,%g;", side * cube_normals[f][0],
                 side * cube_normals[f][1], side * cube_normals[f][2]);
        const int normal = iges_add(file, 123, 0, 0, 0, part, text);
        snprintf(text, sizeof text, "190,%d,%d;", point, normal);
        const int plane = iges_add(file, 190, 0, 0, 0, part, text);
        const int around = iges_add(file, 508, 1, 0, 0, part, loop);
        snprintf(text, sizeof text, "510,%d,1,1,%d;", plane, around);
        const int face = iges_add(file, 510, 1, 0, f == 0 ? 2 : 0, part, text);
        snprintf(shell + strlen(shell), 40, ",%d,%d", face, agrees);
    }
    strcat(shell, ";");
    return iges_add(file, 514, 1, 0, 0, part, shell);
}

/* A cube from (0, 0, 0) to (1, 1, 1) as 186. The flags say whether the shell of the solid, and
 * all faces, agree; loops run around the normals. */
static void add_cube(iges_text *file, bool shell_agrees, bool faces_agree)
{
    char text[60];
    const cube c = {0, 1, shell_agrees, false, faces_agree ? 63 : 0};
    snprintf(text, sizeof text, "186,%d,%d,0;", add_shell(file, &c), shell_agrees);
    iges_add(file, 186, 0, 0, 0, "00000000", text);
}

TEST(a_cube_is_a_solid_with_its_outside_outside_whatever_the_flags)
{
    for (int k = 0; k < 4; k++) {
        iges_text file = iges_begin();
        add_cube(&file, k & 1, k >> 1);
        batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
        CHECK_INT(batten_model_count(model), 1);
        const batten_body *body = batten_model_object(model, 0)->body;
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->vertex_count, 8);
        CHECK_INT(p->edge_count, 12);
        CHECK_INT(p->use_count, 24);
        CHECK_INT(p->face_count, 6);
        CHECK(p->is_solid && p->shells[0].closed);
        CHECK(p->faces[0].has_colour && !p->faces[1].has_colour);
        batten_body_trace_report report;
        batten_body *traced = NULL;
        batten_body_measures measures;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(batten_body_trace(body, 1e-6, NULL, notes, &report, &traced));
        CHECK_INT(report.failed, 0);
        CHECK_INT(batten_notes_count(notes), 0);
        CHECK_OK(batten_body_measure(traced, 1e-9, NULL, &measures));
        CHECK_NEAR(measures.area, 6, 1e-9);
        CHECK_NEAR(measures.volume, 1, 1e-9);
        CHECK(measures.is_closed);
        batten_notes_free(notes);
        batten_body_unref(traced);
        batten_model_unref(model);
    }
}

/* 4^3 less a void of 1, of faces that agree with their surfaces and others: loops run around
 * the normals or the outside, and the solid takes each shell as it is or inside out. */
TEST(a_void_stays_one_whichever_way_its_loops_run)
{
    for (int k = 0; k < 8; k++) {
        const bool around = k & 1, void_outward = k >> 1 & 1, outer_outward = k >> 2 & 1;
        const cube outer = {0, 4, outer_outward, around, 42},
                   hole = {1, 1, void_outward, around, 11};
        iges_text file = iges_begin();
        char text[60];
        const int shells[2] = {add_shell(&file, &outer), add_shell(&file, &hole)};
        snprintf(text, sizeof text, "186,%d,%d,1,%d,%d;", shells[0], outer_outward, shells[1],
                 !void_outward);
        iges_add(&file, 186, 0, 0, 0, "00000000", text);
        batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
        const batten_body *body = batten_model_object(model, 0)->body;
        batten_body_measures measures;
        CHECK_OK(batten_body_measure(body, 1e-9, NULL, &measures));
        CHECK(measures.is_closed);
        CHECK_NEAR(measures.volume, 63, 1e-9);
        CHECK_NEAR(measures.area, 102, 1e-9);
        batten_model_unref(model);
    }
}

/* A disc of radius 2 at z = 0 and a surface above it, each bounded by that circle only. */
static void add_tip(iges_text *file, int type, const char *surface)
{
    char text[100];
    const int ground = iges_add(file, 116, 0, 0, 0, part, "116,0.,0.,0.;"); /* 1 */
    const int down = iges_add(file, 123, 0, 0, 0, part, "123,0.,0.,-1.;");  /* 3 */
    snprintf(text, sizeof text, "190,%d,%d;", ground, down);
    const int plane = iges_add(file, 190, 0, 0, 0, part, text);
    const int side = iges_add(file, type, 0, 0, 0, part, surface);
    const int vertex = iges_add(file, 502, 1, 0, 0, part, "502,1,2.,0.,0.;");
    const int circle = iges_add(file, 100, 0, 0, 0, part, "100,0.,0.,0.,2.,0.,2.,0.;");
    snprintf(text, sizeof text, "504,1,%d,%d,1,%d,1;", circle, vertex, vertex);
    const int edge = iges_add(file, 504, 1, 0, 0, part, text);
    int faces[2];
    for (int k = 0; k < 2; k++) {
        snprintf(text, sizeof text, "508,1,0,%d,1,%d,0;", edge, k);
        const int loop = iges_add(file, 508, 1, 0, 0, part, text);
        snprintf(text, sizeof text, "510,%d,1,1,%d;", k ? side : plane, loop);
        faces[k] = iges_add(file, 510, 1, 0, 0, part, text);
    }
    snprintf(text, sizeof text, "514,2,%d,1,%d,1;", faces[0], faces[1]);
    const int shell = iges_add(file, 514, 1, 0, 0, part, text);
    snprintf(text, sizeof text, "186,%d,1,0;", shell);
    iges_add(file, 186, 0, 0, 0, "00000000", text);
}

TEST(a_cone_with_one_loop_around_it_is_read_to_its_apex_and_a_cylinder_is_not_read)
{
    const double pi = acos(-1);
    for (int k = 0; k < 2; k++) {
        iges_text file = iges_begin();
        add_tip(&file, k ? 192 : 194, k ? "192,1,3,2.;" : "194,1,3,2.,45.;");
        batten_model *model =
            read_so(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO,
                    k ? BATTEN_PARTLY_READ : BATTEN_OK, k ? "goes around the cylinder" : "");
        const batten_body *body = batten_model_object(model, 0)->body;
        batten_body_measures measures;
        CHECK_OK(batten_body_measure(body, 1e-9, NULL, &measures));
        CHECK(measures.is_closed == !k);
        CHECK_NEAR(measures.volume, k ? 0 : 8 * pi / 3, 1e-6);
        CHECK_NEAR(measures.area, 4 * pi + (k ? 0 : 4 * sqrt(2) * pi), 1e-6);
        batten_model_unref(model);
    }
}

TEST(a_face_that_is_bad_leaves_the_others_as_an_open_shell)
{
    iges_text file = iges_begin();
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    add_cube(&file, true, true);
    char *bad = strstr(file.data, "123,0,1,0;");
    memcpy(bad, "123,0,0,0;", 10);
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
    CHECK_INT(p->face_count, 5);
    CHECK(!p->is_solid && !p->shells[0].closed);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "an axis or normal without a direction"));
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(P1_solids_of_nothing_are_left_out)
{
    static const struct {
        const char *solid, *shell, *words;
    } cases[] = {
        {"186,99,1,0;", "514,0;", "it refers to entity D99, which is missing"},
        {"186,3,1,0;", "514,0;", "none of its faces could be read"},
        {"186,1,1,0;", "514,0;", "as type 514, which is of type 186"},
        {"186,3,1,1000000;", "514,0;", "parameters, need 2000004"},
        {"186,3,1,0;", "514,1,1,1;", "as type 510, which is of type 186"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 186, 0, 0, 0, "00000000", cases[i].solid);
        iges_add(&file, 514, 1, 0, 0, part, cases[i].shell);
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        iges_check_partly(&file, cases[i].words);
    }
}

/* A disc whose only vertex is off its circle: a face may be loose, but not as loose as that. */
TEST(an_edge_far_off_its_vertices_leaves_the_face_out)
{
    static const char *const vertices[] = {"502,1,1.,0.,1e300;", "502,1,1.,0.,4e9;",
                                           "502,1,1.,0.,0.01;"};
    for (size_t k = 0; k < 3; k++) {
        iges_text file = iges_begin();
        iges_add(&file, 116, 0, 0, 0, part, "116,0.,0.,0.;");
        iges_add(&file, 123, 0, 0, 0, part, "123,0.,0.,1.;");
        iges_add(&file, 190, 0, 0, 0, part, "190,1,3;");
        iges_add(&file, 502, 1, 0, 0, part, vertices[k]);
        iges_add(&file, 100, 0, 0, 0, part, "100,0.,0.,0.,1.,0.,1.,0.;");
        iges_add(&file, 504, 1, 0, 0, part, "504,1,9,7,1,7,1;");
        iges_add(&file, 508, 1, 0, 0, part, "508,1,0,11,1,1,0;");
        iges_add(&file, 510, 1, 0, 0, "00000000", "510,5,1,1,13;");
        iges_check_left_out(&file, "an edge misses its vertices by");
    }
}
