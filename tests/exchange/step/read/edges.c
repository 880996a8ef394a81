/* Edges of a file: which way they run, gaps to their vertices, and such of no length. */
#include "exchange/step/read/bent_box.h"

/* A line or spline for the edge #81 from (0, 0, 0) to (1, 0, 0); the accuracy is 1e-6. */
#define SPLINE(a, b) \
    "#61=B_SPLINE_CURVE_WITH_KNOTS('',1,(" a "," b "),.U.,.F.,.F.,(2,2),(0.,1.),.U.);\n"
#define LINE_OF(points) \
    "#61=POLYLINE('',(#1300,#1301));\n#1300=CARTESIAN_POINT('',(" points "));\n"
#define TO "));\n#1301=CARTESIAN_POINT('',("
static const struct {
    const char *instead, *note; /* the only one; "" for none */
    double ends[2][3];          /* of the curve of the edge */
} rows[] = {
    {"", "", {{0, 0, 0}, {1, 0, 0}}},
    {"#81=EDGE_CURVE('',#9,#10,#61,.F.);\n",
     "its curve runs with its vertices, the file says otherwise; turned",
     {{0, 0, 0}, {1, 0, 0}}},
    {"#61=LINE('',#2,#1310);\n#1310=VECTOR('',#1311,1.);\n#1311=DIRECTION('',(-1.,0.,0.));\n",
     "its curve runs against its vertices, the file says otherwise; turned",
     {{0, 0, 0}, {1, 0, 0}}},
    {SPLINE("#1", "#2"), "", {{0, 0, 0}, {1, 0, 0}}},
    {SPLINE("#2", "#1"),
     "its curve runs against its vertices, the file says otherwise; turned",
     {{0, 0, 0}, {1, 0, 0}}},
    {SPLINE("#2", "#1") "#81=EDGE_CURVE('',#9,#10,#61,.F.);\n", "", {{0, 0, 0}, {1, 0, 0}}},
    {SPLINE("#1", "#2") "#81=EDGE_CURVE('',#9,#10,#61,.F.);\n",
     "its curve runs with its vertices, the file says otherwise; turned",
     {{0, 0, 0}, {1, 0, 0}}},
    {LINE_OF("0.,9.E-7,0." TO "1.,0.,0."), "", {{0, 9e-7, 0}, {1, 0, 0}}},
    {LINE_OF("0.,1.E-5,0." TO "1.,0.,0."),
     "its curve misses its vertices by 1e-05, the tolerance is 1e-06; its ends are moved to them",
     {{0, 0, 0}, {1, 0, 0}}},
    {LINE_OF("0.,0.,0." TO "1.,0.,2.E-5"),
     "its curve misses its vertices by 2e-05, the tolerance is 1e-06; its ends are moved to them",
     {{0, 0, 0}, {1, 0, 0}}},
    {LINE_OF("0.,5.E-7,0." TO "1.,3.E-5,0."),
     "its curve misses its vertices by 3e-05, the tolerance is 1e-06; its ends are moved to them",
     {{0, 5e-7, 0}, {1, 0, 0}}},
    {LINE_OF("0.,9.9E-5,0." TO "1.,0.,-4.E-5"),
     "its curve misses its vertices by 9.9e-05, the tolerance is 1e-06; its ends are moved to "
     "them",
     {{0, 0, 0}, {1, 0, 0}}},
    {LINE_OF("0.,1.01E-4,0." TO "1.,1.01E-4,0."),
     "its curve misses its vertices by 0.000101, the tolerance is 1e-06; kept so",
     {{0, 1.01e-4, 0}, {1, 1.01e-4, 0}}},
    {LINE_OF("0.,0.25,0." TO "1.,0.25,0."),
     "its curve misses its vertices by 0.25, the tolerance is 1e-06; kept so",
     {{0, 0.25, 0}, {1, 0.25, 0}}},
};

static batten_model *read_with(const char *instead, batten_status due, batten_notes *notes)
{
    batten_model *model = NULL;
    CHECK_STATUS(read_text(box_with(instead), BATTEN_FORMAT_STEP, notes, &model), due);
    CHECK_INT(batten_model_count(model), 1);
    return model;
}

/* Of warnings there is this one, or none for "". */
static void check_notes(const batten_notes *notes, const char *text)
{
    int count = 0;
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const batten_note *note = batten_notes_at(notes, i);
        if (strstr(note->text, " read"))
            continue; /* how many there are */
        CHECK_TEXT(note->text, text);
        count++;
    }
    if (batten_notes_dropped(notes) == 0)
        CHECK(test_cases(10) < 10 || count == (text[0] != '\0'));
}

TEST(an_edge_runs_from_its_first_vertex_to_its_second_whatever_its_curve_does)
{
    for (int i = 0; i < COUNT(rows); i++) {
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(20, &notes));
        batten_model *model = read_with(rows[i].instead, BATTEN_OK, notes);
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        CHECK_INT(p->vertex_count, 8);
        CHECK_INT(p->edge_count, 12);
        const batten_curve *curve = p->edges[0].curve;
        const batten_interval domain = batten_curve_domain(curve);
        for (int end = 0; end < 2; end++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(curve, end ? domain.b : domain.a, 0, at));
            for (int k = 0; k < 3; k++) {
                CHECK_NEAR(at[k], rows[i].ends[end][k], 1e-8);
                CHECK_BITS(p->vertices[3 * p->edges[0].vertices[end] + k], end && k == 0);
            }
        }
        check_notes(notes, rows[i].note);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

/* A gap above a quarter of the curve is no gap: the edge and its two faces are left out. */
TEST(a_curve_that_is_hardly_larger_than_its_gap_is_left_out)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    batten_model *model =
        read_with(LINE_OF("0.,0.26,0." TO "1.,0.26,0."), BATTEN_PARTLY_READ, notes);
    CHECK_INT(batten_body_view(batten_model_object(model, 0)->body)->face_count, 4);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "its curve, 1 large, misses its vertices by 0.26"));
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* Before the first edge of the bottom one from its corner to another vertex in the same place. */
TEST(vertices_of_a_line_without_length_are_one)
{
    static const char *const ends[] = {"0.,0.,0.", "5.E-10,0.,0."};
    for (int i = 0; i < 2 * COUNT(ends); i++) {
        const bool same = i % 2;
        char instead[500];
        batten_notes *notes = NULL;
        snprintf(instead, sizeof instead,
                 "#131=EDGE_LOOP('',(#1204,#101,#102,#103,#104));\n"
                 "#1204=ORIENTED_EDGE('',*,*,#1202,.T.);\n"
                 "#1202=EDGE_CURVE('',#9,%s,#61,.T.);\n#1201=VERTEX_POINT('',#1200);\n"
                 "#1200=CARTESIAN_POINT('',(%s));\n",
                 same ? "#9" : "#1201", ends[i / 2]);
        CHECK_OK(batten_notes_create(20, &notes));
        batten_model *model = read_with(instead, BATTEN_OK, notes);
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        CHECK_INT(p->vertex_count, 8);
        CHECK_INT(p->edge_count, 13);
        CHECK(p->edges[12].curve == NULL);
        CHECK_INT(p->edges[12].vertices[0], p->edges[12].vertices[1]);
        check_notes(notes, same ? "" : "its vertices coincide; taken as one");
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}
