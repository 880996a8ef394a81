#include "body/builder.h"
#include "support/bodies.h"
#include "support/test.h"

#include <batten/standard.h>

static batten_body *unit_box(void)
{
    return test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
}

TEST(a_body_keeps_what_it_is_made_of)
{
    batten_body *body = unit_box();
    const batten_body_parts *parts = batten_body_view(body);
    CHECK_INT(parts->vertex_count, 8);
    CHECK_INT(parts->edge_count, 12);
    CHECK_INT(parts->use_count, 24);
    CHECK_INT(parts->loop_count, 6);
    CHECK_INT(parts->face_count, 6);
    CHECK_INT(parts->shell_count, 1);
    CHECK(parts->is_solid && parts->shells[0].closed);
    CHECK_TEXT(parts->faces[5].name, "top");
    const batten_box box = batten_body_box(body);
    CHECK_BITS(box.low.x, 0);
    CHECK_BITS(box.high.y, 2);
    CHECK_BITS(box.high.z, 3);
    batten_body *again = batten_body_ref(body);
    batten_body_unref(body);
    CHECK_INT(batten_body_view(again)->face_count, 6);
    batten_body_unref(again);
    batten_body_unref(NULL);
}

/* Where the loop of a face begins and ends, as the edges and their directions say. */
static int start_of(const batten_body_parts *p, const batten_body_use *use)
{
    return p->edges[use->edge].vertices[use->reversed];
}

TEST(every_edge_of_a_box_is_used_once_each_way)
{
    batten_body *body = unit_box();
    const batten_body_parts *p = batten_body_view(body);
    int ways[12][2] = {{0}};
    for (int i = 0; i < p->use_count; i++)
        ways[p->uses[i].edge][p->uses[i].reversed]++;
    for (int i = 0; i < 12; i++)
        CHECK(ways[i][0] == 1 && ways[i][1] == 1);
    batten_body_unref(body);
}

TEST(a_mirror_turns_loops_and_sides)
{
    batten_body *body = unit_box(), *mirrored = NULL, *bad = NULL;
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){0, 1, 0});
    const batten_affine flat = batten_affine_scaling(1, 1, 0);
    CHECK_OK(batten_body_transform(body, &mirror, &mirrored));
    const batten_body_parts *p = batten_body_view(mirrored), *was = batten_body_view(body);
    for (int f = 0; f < 6; f++) {
        const batten_body_loop *loop = &p->loops[p->faces[f].first];
        const batten_body_loop *old = &was->loops[was->faces[f].first];
        CHECK(p->faces[f].reversed);
        for (int k = 0; k < 4; k++)
            CHECK_INT(start_of(p, &p->uses[loop->first + k]),
                      start_of(was, &was->uses[old->first + (8 - k) % 4]));
    }
    CHECK_NEAR(batten_body_box(mirrored).low.y, -2, 1e-15);
    CHECK_STATUS(batten_body_transform(body, &flat, &bad), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("singular");
    batten_body_unref(mirrored);
    batten_body_unref(body);
}

TEST(P3_parts_that_do_not_fit_together_are_refused)
{
    batten_body *body = unit_box(), *made = NULL;
    const batten_body_parts good = *batten_body_view(body);
    batten_body_use uses[24];
    batten_body_edge edges[12];
    batten_body_face faces[6];
    double vertices[24];
    batten_body_parts bad = good;
    bad.uses = uses;
    bad.edges = edges;
    bad.vertices = vertices;
    bad.faces = faces;
    const struct {
        int use, edge, vertex, face;
        batten_status status;
        const char *words;
    } cases[] = {{0, -1, -1, -1, BATTEN_BAD_ARGUMENT, "use 1 is of edge 100, of 12"},
                 {-1, 3, -1, -1, BATTEN_BAD_ARGUMENT, "edge 4 has vertex 9, of 8"},
                 {-1, -1, 7, -1, BATTEN_NOT_FINITE, "coordinate 2 of vertex 3"},
                 {-1, -1, -1, 2, BATTEN_BAD_ARGUMENT, "face 3 has the parts"},
                 {-2, -1, -1, -1, BATTEN_BAD_ARGUMENT, "loop 1 is broken"}};
    for (int i = 0; i < COUNT(cases); i++) {
        memcpy(uses, good.uses, sizeof uses);
        memcpy(edges, good.edges, sizeof edges);
        memcpy(faces, good.faces, sizeof faces);
        memcpy(vertices, good.vertices, sizeof vertices);
        if (cases[i].use >= 0)
            uses[cases[i].use].edge = 99;
        if (cases[i].use == -2)
            uses[1].reversed = !uses[1].reversed;
        if (cases[i].edge >= 0)
            edges[cases[i].edge].vertices[1] = 8;
        if (cases[i].vertex >= 0)
            vertices[cases[i].vertex] = NAN;
        if (cases[i].face >= 0)
            faces[cases[i].face].count = 9;
        CHECK_STATUS(batten_body_create(&bad, &made), cases[i].status);
        CHECK_MESSAGE(cases[i].words);
    }
    CHECK(!made);
    batten_body_unref(body);
}

/* The first two faces of a box, the first taken back. */
static batten_status make_second_face(const batten_body_parts *p, batten_body **out)
{
    bat_builder builder;
    int index;
    batten_status status = BATTEN_OK;
    bat_builder_begin(&builder, 1e-6);
    for (int i = 0; status == BATTEN_OK && i < 8; i++)
        status = bat_builder_vertex(&builder, &p->vertices[3 * i], &index);
    for (int i = 0; status == BATTEN_OK && i < 12; i++)
        status = bat_builder_edge(&builder, p->edges[i].curve, p->edges[i].vertices[0],
                                  p->edges[i].vertices[1], &index);
    if (status == BATTEN_OK)
        status = bat_builder_shell(&builder, false);
    for (int f = 0; status == BATTEN_OK && f < 2; f++) {
        const int mark = bat_builder_mark(&builder);
        status = bat_builder_face(&builder, &p->faces[f]);
        if (status == BATTEN_OK)
            status = bat_builder_loop(&builder);
        for (int k = 0; status == BATTEN_OK && k < 4; k++) {
            const batten_body_use *use = &p->uses[p->loops[p->faces[f].first].first + k];
            status = bat_builder_use(&builder, use->edge, use->reversed, NULL);
        }
        if (f == 0)
            bat_builder_back(&builder, mark);
    }
    if (status == BATTEN_OK)
        return bat_builder_finish(&builder, false, out);
    bat_builder_end(&builder);
    return status;
}

TEST(a_face_that_turns_out_bad_is_taken_back)
{
    batten_body *body = unit_box(), *made = NULL;
    CHECK_OK(make_second_face(batten_body_view(body), &made));
    const batten_body_parts *q = batten_body_view(made);
    CHECK_INT(q->face_count, 1);
    CHECK_TEXT(q->faces[0].name, "right");
    CHECK_INT(q->edge_count, 4);
    CHECK_INT(q->vertex_count, 4);
    batten_body_unref(made);
    batten_body_unref(body);
}

TEST(counts_below_zero_and_tolerances_of_nothing_are_refused)
{
    static const char *const words[] = {"-1 vertices", "-1 edges", "-1 uses",
                                        "-1 loops",    "-1 faces", "-1 shells"};
    static const double tolerances[] = {0, -1, NAN, INFINITY};
    batten_body *body = unit_box(), *made = NULL;
    for (int i = 0; i < COUNT(words); i++) {
        batten_body_parts bad = *batten_body_view(body);
        int *const counts[] = {&bad.vertex_count, &bad.edge_count, &bad.use_count,
                               &bad.loop_count,   &bad.face_count, &bad.shell_count};
        *counts[i] = -1;
        CHECK_STATUS(batten_body_create(&bad, &made), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(words[i]);
    }
    for (int i = 0; i < COUNT(tolerances); i++) {
        batten_body_parts bad = *batten_body_view(body);
        bad.tolerance = tolerances[i];
        CHECK_STATUS(batten_body_create(&bad, &made), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the tolerance of the body is");
    }
    CHECK(!made);
    batten_body_unref(body);
}

TEST(an_edge_has_its_curve_in_space_and_vertices_that_are_there)
{
    batten_body *body = unit_box(), *made = NULL;
    const batten_body_parts good = *batten_body_view(body);
    batten_body_edge edges[12];
    batten_body_parts bad = good;
    batten_curve *flat = NULL;
    CHECK_OK(batten_curve_line(2, (double[]){0, 0}, (double[]){1, 0}, &flat));
    static const struct {
        int vertex, other;
        const char *words;
    } cases[] = {{-1, 0, "edge 5 has vertex 0, of 8"},
                 {8, 0, "edge 5 has vertex 9, of 8"},
                 {0, -1, "edge 5 has vertex 0, of 8"}};
    bad.edges = edges;
    for (int i = 0; i < COUNT(cases); i++) {
        memcpy(edges, good.edges, sizeof edges);
        edges[4].vertices[0] = cases[i].vertex;
        edges[4].vertices[1] = cases[i].other;
        CHECK_STATUS(batten_body_create(&bad, &made), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(cases[i].words);
    }
    memcpy(edges, good.edges, sizeof edges);
    edges[4].curve = flat;
    CHECK_STATUS(batten_body_create(&bad, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the curve of edge 5 has 2 dimensions, not 3");
    batten_curve_unref(flat);
    CHECK(!made);
    batten_body_unref(body);
}

/* A box whose arrays may be damaged. */
typedef struct {
    batten_body_edge edges[12];
    batten_body_use uses[24];
    batten_body_loop loops[6];
    batten_body_face faces[6];
    batten_body_shell shells[1];
    batten_body_parts parts;
} loose_box;

static void copy_box(const batten_body *body, loose_box *box)
{
    box->parts = *batten_body_view(body);
    memcpy(box->edges, box->parts.edges, sizeof box->edges);
    memcpy(box->uses, box->parts.uses, sizeof box->uses);
    memcpy(box->loops, box->parts.loops, sizeof box->loops);
    memcpy(box->faces, box->parts.faces, sizeof box->faces);
    memcpy(box->shells, box->parts.shells, sizeof box->shells);
    box->parts.edges = box->edges;
    box->parts.uses = box->uses;
    box->parts.loops = box->loops;
    box->parts.faces = box->faces;
    box->parts.shells = box->shells;
}

TEST(indices_and_ranges_that_do_not_fit_are_refused_with_their_numbers)
{
    loose_box b;
    const struct {
        int *number, value;
        const char *message;
    } rows[] = {
        {&b.uses[23].edge, -1, "use 24 is of edge 0, of 12"},
        {&b.uses[23].edge, 12, "use 24 is of edge 13, of 12"},
        {&b.loops[5].count, 3, "loop 6 is broken: edge"},
        {&b.loops[5].first, 19,
         "loop 6 has the parts 20 .. 23, of 24; it should begin with 21"},
        {&b.loops[5].count, 5, "loop 6 has the parts 21 .. 25, of 24; it should begin with 21"},
        {&b.loops[0].count, 0, "loop 1 has the parts 1 .. 0, of 24; it should begin with 1"},
        {&b.parts.loop_count, 5, "4 of 24 uses are in no loop"},
        {&b.faces[5].first, 4, "face 6 has the parts 5 .. 5, of 6; it should begin with 6"},
        {&b.faces[5].count, 2, "face 6 has the parts 6 .. 7, of 6; it should begin with 6"},
        {&b.faces[5].count, -1, "face 6 has the parts 6 .. 4, of 6; it should begin with 6"},
        {&b.faces[5].count, 0, "1 loop is of no face, 0 faces of no shell"},
        {&b.parts.face_count, 5, "shell 1 has the parts 1 .. 6, of 5; it should begin with 1"},
        {&b.shells[0].count, 5, "0 loops are of no face, 1 face of no shell"},
        {&b.shells[0].count, 0, "shell 1 has the parts 1 .. 0, of 6; it should begin with 1"},
        {&b.shells[0].first, 1, "shell 1 has the parts 2 .. 7, of 6; it should begin with 1"},
        {&b.parts.shell_count, 0, "0 loops are of no face, 6 faces of no shell"},
    };
    batten_body *body = unit_box(), *made = NULL;
    for (int i = 0; i < COUNT(rows); i++) {
        copy_box(body, &b);
        *rows[i].number = rows[i].value;
        CHECK_STATUS(batten_body_create(&b.parts, &made), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(rows[i].message);
    }
    CHECK(!made);
    batten_body_unref(body);
}

TEST(faces_have_surfaces_and_colours_and_edges_without_a_curve_stay_where_they_are)
{
    static const double colours[] = {1.5, -0.125, NAN};
    loose_box b;
    batten_body *body = unit_box(), *made = NULL;
    for (int i = 0; i < 3; i++) {
        char message[80];
        copy_box(body, &b);
        b.faces[1].has_colour = true;
        b.faces[1].colour[i] = colours[i];
        snprintf(message, sizeof message, "colour part %d of face 2 is %g, not in 0..1", i + 1,
                 colours[i]);
        CHECK_STATUS(batten_body_create(&b.parts, &made), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(message);
    }
    copy_box(body, &b);
    b.faces[3].surface = NULL;
    CHECK_STATUS(batten_body_create(&b.parts, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("face 4 has no surface in space");
    copy_box(body, &b);
    b.edges[7].curve = NULL;
    CHECK_STATUS(batten_body_create(&b.parts, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("edge 8 has no curve, but goes from vertex");
    copy_box(body, &b);
    b.uses[2].parameters = b.edges[0].curve;
    CHECK_STATUS(batten_body_create(&b.parts, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the parameter curve of use 3 has 3 dimensions, not 2");
    copy_box(body, &b);
    b.parts.is_traced = true;
    CHECK_STATUS(batten_body_create(&b.parts, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("use 1 of a traced body has no parameters");
    CHECK(!made);
    copy_box(body, &b);
    b.faces[1] = (batten_body_face){
        NULL, true, {0, 1, 0.5}, b.faces[1].surface, b.faces[1].reversed, 1, 1};
    CHECK_OK(batten_body_create(&b.parts, &made));
    CHECK_TEXT(batten_body_view(made)->faces[1].name, "");
    CHECK_NEAR(batten_body_view(made)->faces[1].colour[1], 1, 0);
    batten_body_unref(made);
    batten_body_unref(body);
}
