#include "body/builder.h"
#include "body/check/sheet.h"
#include "support/bodies.h"
#include "support/test.h"

#include <batten/base.h>
#include <batten/standard.h>

static batten_body_faults faults_of(const batten_body *body, double tolerance)
{
    batten_body_faults f = {.gaps = -1};
    CHECK_OK(batten_body_check(body, tolerance, NULL, NULL, &f));
    return f;
}

static batten_body *unit_box(void)
{
    return test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 1, 1});
}

TEST(a_good_box_has_no_faults)
{
    batten_body *box = unit_box();
    const batten_body_faults f = faults_of(box, 1e-6);
    CHECK_INT(f.shared_edges, 12);
    CHECK_INT(f.free_edges + f.wrong_edges + f.crowded_edges + f.tiny_edges + f.gaps + f.loose +
                  f.crossing_loops + f.poles + f.seams + f.close_knots + f.open_shells +
                  f.turned_shells,
              0);
    CHECK_BITS(f.largest_gap, 0);
    CHECK_NEAR(f.largest_miss, 0, 1e-15);
    batten_body_unref(box);
}

TEST(a_whole_sphere_has_a_seam_and_two_poles)
{
    const batten_frame world = batten_frame_world();
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_sphere(&world, 2, &surface));
    CHECK_OK(batten_body_from_surface("ball", surface, 1e-9, &body));
    const batten_body_faults f = faults_of(body, 1e-6);
    CHECK_INT(f.seams, 1);
    CHECK_INT(f.poles, 2);
    CHECK_INT(f.shared_edges, 1);
    CHECK_INT(f.free_edges, 0);
    CHECK_INT(f.crossing_loops, 0);
    CHECK_INT(f.gaps + f.loose, 0);
    batten_body_unref(body);
    batten_surface_unref(surface);
}

/* The box with some of its parts changed; arrays are the test's own. */
typedef struct {
    batten_body *box;
    batten_body_parts parts;
    double vertices[8 * 3];
    batten_body_edge edges[12];
    batten_body_use uses[24];
    batten_body_loop loops[6];
    batten_body_face faces[6];
    batten_body_shell shells[1];
} changed;

static changed *begin_change(void)
{
    changed *c = test_array(1, sizeof *c);
    c->box = unit_box();
    const batten_body_parts *p = batten_body_view(c->box);
    memcpy(c->vertices, p->vertices, sizeof c->vertices);
    memcpy(c->edges, p->edges, sizeof c->edges);
    memcpy(c->uses, p->uses, sizeof c->uses);
    memcpy(c->loops, p->loops, sizeof c->loops);
    memcpy(c->faces, p->faces, sizeof c->faces);
    memcpy(c->shells, p->shells, sizeof c->shells);
    c->parts = *p;
    c->parts.vertices = c->vertices;
    c->parts.edges = c->edges;
    c->parts.uses = c->uses;
    c->parts.loops = c->loops;
    c->parts.faces = c->faces;
    c->parts.shells = c->shells;
    return c;
}

static batten_body_faults end_change(changed *c, double tolerance, batten_notes *notes)
{
    batten_body *body = NULL;
    batten_body_faults f = {.gaps = -1};
    CHECK_OK(batten_body_create(&c->parts, &body));
    CHECK_OK(batten_body_check(body, tolerance, NULL, notes, &f));
    batten_body_unref(body);
    batten_body_unref(c->box);
    return f;
}

static batten_notes *new_notes(void)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    return notes;
}

/* So many notes say this of this entity, or of any. */
static void check_noted(const batten_notes *notes, const char *entity, const char *text,
                        int due)
{
    int count = 0;
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const batten_note *note = batten_notes_at(notes, i);
        CHECK_INT(note->line, 0); /* a body has no lines */
        count +=
            strcmp(note->text, text) == 0 && (!entity || strcmp(note->entity, entity) == 0);
    }
    /* With failing allocations a check is tried again, and says it twice. */
    if (test_cases(10) >= 10)
        CHECK_INT(count, due);
    else
        CHECK(due == 0 ? count == 0 : count >= due || batten_notes_dropped(notes) > 0);
}

TEST(a_missing_face_leaves_free_edges_and_an_open_shell)
{
    changed *c = begin_change();
    batten_notes *notes = new_notes();
    c->parts.face_count = c->parts.loop_count = 5;
    c->parts.use_count = 20;
    c->shells[0].count = 5;
    const batten_body_faults f = end_change(c, 1e-6, notes);
    CHECK_INT(f.free_edges, 4);
    CHECK_INT(f.shared_edges, 8);
    CHECK_INT(f.open_shells, 1);
    if (batten_notes_dropped(notes) == 0) {
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "shell 1");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "4 of its edges");
    }
    batten_notes_free(notes);
}

/* The loop of a face run the other way. */
TEST(a_turned_face_has_wrong_edges)
{
    changed *c = begin_change();
    for (int i = 0; i < 4; i++) {
        c->uses[i] = batten_body_view(c->box)->uses[3 - i];
        c->uses[i].reversed = !c->uses[i].reversed;
    }
    batten_notes *notes = new_notes();
    const batten_body_faults f = end_change(c, 1e-6, notes);
    CHECK_INT(f.wrong_edges, 4);
    CHECK_INT(f.shared_edges, 8);
    CHECK_INT(f.open_shells, 0);
    check_noted(notes, NULL,
                "two uses the same way: its faces are turned against each other: 2 uses; "
                "it is of face 1 \"left\"",
                4);
    batten_notes_free(notes);
}

/* The same face twice: its edges have three uses. */
TEST(edges_of_three_faces_are_crowded)
{
    changed *c = begin_change();
    batten_body_use uses[28];
    batten_body_loop loops[7];
    batten_body_face faces[7];
    memcpy(uses, c->uses, sizeof c->uses);
    memcpy(uses + 24, c->uses, 4 * sizeof *uses);
    memcpy(loops, c->loops, sizeof c->loops);
    loops[6] = (batten_body_loop){24, 4};
    memcpy(faces, c->faces, sizeof c->faces);
    faces[6] = faces[0];
    faces[6].first = 6;
    c->parts.uses = uses;
    c->parts.loops = loops;
    c->parts.faces = faces;
    c->parts.use_count = 28;
    c->parts.loop_count = c->parts.face_count = 7;
    c->shells[0].count = 7;
    batten_notes *notes = new_notes();
    const batten_body_faults f = end_change(c, 1e-6, notes);
    CHECK_INT(f.crowded_edges, 4);
    CHECK_INT(f.shared_edges, 8);
    check_noted(notes, NULL, "more than two uses: 3 uses; it is of face 1 \"left\"", 4);
    batten_notes_free(notes);
}

TEST(a_moved_vertex_leaves_gaps_with_their_size)
{
    changed *c = begin_change();
    batten_notes *notes = new_notes();
    c->vertices[2] -= 0.01;
    const batten_body_faults f = end_change(c, 1e-3, notes);
    CHECK_INT(f.gaps, 3);
    CHECK_NEAR(f.largest_gap, 0.01, 1e-15);
    if (batten_notes_dropped(notes) == 0) {
        CHECK(batten_notes_count(notes) >= 3);
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "0.01");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->entity, "edge");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "face 1 \"left\"");
    }
    batten_notes_free(notes);
    c = begin_change();
    c->vertices[2] -= 0.01;
    CHECK_INT(end_change(c, 0.1, NULL).gaps, 0);
}

TEST(an_edge_that_leaves_its_faces_is_loose)
{
    changed *c = begin_change();
    batten_notes *notes = new_notes();
    batten_curve *bent = NULL;
    const double *a = c->vertices + 3 * (size_t)c->edges[0].vertices[0],
                 *b = c->vertices + 3 * (size_t)c->edges[0].vertices[1];
    double middle[3];
    for (int k = 0; k < 3; k++)
        middle[k] = (a[k] + b[k]) / 2 - 0.02 * (a[k] == b[k]);
    CHECK_OK(batten_curve_conic(3, a, middle, b, 1, &bent));
    c->edges[0].curve = bent;
    const batten_body_faults f = end_change(c, 1e-3, notes);
    batten_curve_unref(bent);
    CHECK_INT(f.loose, 2);
    CHECK_NEAR(f.largest_miss, sqrt(2) * 0.01, 1e-3 + 0.0042); /* from the rim of the surface */
    CHECK(f.largest_miss >= 0.01 - 1e-12);
    if (batten_notes_dropped(notes) == 0)
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "edge 1 misses its surface by");
    batten_notes_free(notes);
}

TEST(edges_below_the_tolerance_are_tiny)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 1, 1e-4});
    CHECK_INT(faults_of(box, 1e-3).tiny_edges, 4);
    CHECK_INT(faults_of(box, 1.0001e-4).tiny_edges, 4);
    CHECK_INT(faults_of(box, 0.9999e-4).tiny_edges, 0);
    CHECK_INT(faults_of(box, 1e-5).tiny_edges, 0);
    batten_body_unref(box);
}

/* An edge of length 1 with 8 teeth, whose feet are the places that are looked at first. */
TEST(an_edge_is_tiny_by_its_length_and_not_by_a_few_places)
{
    static const double tolerances[] = {5, 9};
    double points[9 * 3];
    for (int i = 0; i < 2; i++) {
        changed *c = begin_change();
        batten_notes *notes = new_notes();
        batten_curve *saw = NULL;
        const double *a = c->vertices + 3 * (size_t)c->edges[0].vertices[0],
                     *b = c->vertices + 3 * (size_t)c->edges[0].vertices[1];
        for (int k = 0; k < 27; k++)
            points[k] = a[k % 3] + (b[k % 3] - a[k % 3]) * (k / 3) / 8 +
                        (k / 3 % 2 && a[k % 3] == b[k % 3] ? sqrt(0.5) : 0);
        CHECK_OK(batten_curve_polyline((batten_points){3, 9, points}, &saw));
        c->edges[0].curve = saw;
        CHECK_INT(end_change(c, tolerances[i], notes).tiny_edges, i ? 12 : 11);
        check_noted(notes, "edge 1",
                    "shorter than the tolerance: 8.06226 units; it is of face 1 \"left\"", i);
        batten_notes_free(notes);
        batten_curve_unref(saw);
    }
}

TEST(K6_knots_that_nearly_coincide_are_told)
{
    changed *c = begin_change();
    batten_curve *refined = NULL;
    batten_surface *divided = NULL;
    batten_notes *notes = new_notes();
    static const double more[] = {0.5, 0.5 + 0x1p-24};
    CHECK_OK(batten_curve_refine(c->edges[3].curve, 2, more, &refined));
    CHECK_OK(batten_surface_refine(c->faces[4].surface, BATTEN_V, 2, more, &divided));
    c->edges[3].curve = refined;
    c->faces[4].surface = divided;
    CHECK_INT(end_change(c, 1e-6, notes).close_knots, 2);
    check_noted(notes, "edge 4",
                "its curve has knots very near each other: 5.96046e-08 of the domain; it "
                "is of face 1 \"left\"",
                1);
    check_noted(notes, "face 5 \"bottom\"",
                "its surface has knots very near each other: 5.96046e-08 of the domain", 1);
    batten_notes_free(notes);
    batten_curve_unref(refined);
    batten_surface_unref(divided);
}

/* An edge that no face uses: its curve is looked at, its uses are not. */
TEST(an_edge_of_no_face_is_looked_at_alone)
{
    changed *c = begin_change();
    batten_notes *notes = new_notes();
    batten_body_edge edges[13];
    memcpy(edges, c->edges, sizeof c->edges);
    edges[12] = c->edges[0];
    edges[12].vertices[0] = c->edges[0].vertices[1];
    c->parts.edges = edges;
    c->parts.edge_count = 13;
    const batten_body_faults f = end_change(c, 1e-6, notes);
    CHECK_INT(f.shared_edges, 12);
    CHECK_INT(f.free_edges + f.wrong_edges + f.crowded_edges + f.poles, 0);
    CHECK_INT(f.gaps, 1);
    CHECK_BITS(f.largest_gap, 1);
    check_noted(notes, "edge 13",
                "an end of the curve misses its vertex: 1 units; it is of no face", 1);
    batten_notes_free(notes);
}

TEST(N6_a_tolerance_of_nothing_is_refused)
{
    batten_body *box = unit_box();
    batten_body_faults f;
    CHECK_STATUS(batten_body_check(box, 0, NULL, NULL, &f), BATTEN_BAD_ARGUMENT);
    CHECK_TEXT(batten_message(), "the tolerance is 0; it must be positive");
    CHECK_STATUS(batten_body_check(box, NAN, NULL, NULL, &f), BATTEN_BAD_ARGUMENT);
    batten_body_unref(box);
}

/* Faces of a box that look inward; of a shell that does not close the side is not asked. */
TEST(a_box_that_is_turned_inward_is_told)
{
    for (int i = 0; i < 2; i++) {
        changed *c = begin_change();
        for (int f = 0; f < 6; f++)
            c->faces[f].reversed = !c->faces[f].reversed;
        for (int u = 0; u < 24; u++) {
            c->uses[u] = batten_body_view(c->box)->uses[u / 4 * 4 + 3 - u % 4];
            c->uses[u].reversed = !c->uses[u].reversed;
        }
        if (i) {
            c->parts.face_count = c->parts.loop_count = 5;
            c->parts.use_count = 20;
            c->shells[0].count = 5;
        }
        const batten_body_faults f = end_change(c, 1e-6, NULL);
        CHECK_INT(f.wrong_edges, 0);
        CHECK_INT(f.turned_shells, !i);
    }
}

/* Cancelled when asked for the first time, the second, and so on. */
typedef struct {
    int asked, most;
} patience;

static bool runs_out(void *user)
{
    patience *p = user;
    return p->asked++ >= p->most;
}

TEST(a_check_that_is_cancelled_anywhere_says_so_and_leaves_the_faults_as_they_were)
{
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is said by the other tests");
    batten_body *box = unit_box();
    patience p = {0, 1 << 30};
    batten_job job = BATTEN_JOB;
    job.is_cancelled = runs_out;
    job.user = &p;
    batten_body_faults faults = {.gaps = -1};
    CHECK_OK(batten_body_check(box, 1e-6, &job, NULL, &faults));
    const int all = p.asked;
    CHECK(all >= 1);
    for (int k = 0; k < all; k++) {
        p = (patience){0, k};
        faults.gaps = -7;
        CHECK_STATUS(batten_body_check(box, 1e-6, &job, NULL, &faults), BATTEN_CANCELLED);
        CHECK_INT(faults.gaps, -7);
    }
    batten_body_unref(box);
}

TEST(a_check_reports_each_allocation_that_fails)
{
    if (test_cases(1000) < 1000)
        SKIP("its allocations fail one by one already");
    changed *c = begin_change();
    batten_body *body = NULL;
    batten_body_faults faults;
    c->parts.face_count = c->parts.loop_count = 1;
    c->parts.use_count = 4;
    c->shells[0] = (batten_body_shell){0, 1, false};
    c->parts.is_solid = false;
    CHECK_OK(batten_body_create(&c->parts, &body));
    test_fail_allocation(0);
    CHECK_OK(batten_body_check(body, 1e-6, NULL, NULL, &faults));
    const long all = test_allocations();
    for (long k = 1; k <= all; k++) {
        test_fail_allocation(k);
        const batten_status status = batten_body_check(body, 1e-6, NULL, NULL, &faults);
        test_fail_allocation(0);
        CHECK_INT(status, BATTEN_OUT_OF_MEMORY);
    }
    batten_body_unref(body);
    batten_body_unref(c->box);
}
