#include "body/builder.h"
#include "support/bodies.h"
#include "support/drilled_box.h"
#include "support/test.h"

#include <batten/mesh.h>
#include <batten/standard.h>

static const double PI = 3.14159265358979323846;

static batten_mesh_facts mesh_of(const batten_body *body, const batten_mesh_options *options,
                                 batten_mesh_report *report, batten_mesh **out)
{
    batten_mesh *mesh = NULL;
    batten_mesh_facts facts;
    CHECK_OK(batten_mesh_from_body(body, options, NULL, NULL, report, &mesh));
    CHECK_OK(batten_mesh_check(mesh, &facts));
    CHECK_INT(facts.wrong_edges + facts.crowded_edges + facts.loose_vertices, 0);
    CHECK_INT(facts.flat_triangles, 0);
    if (out)
        *out = mesh;
    else
        batten_mesh_unref(mesh);
    return facts;
}

/* Corners go round as seen from their normals. */
static void check_sides(const batten_mesh *mesh)
{
    const batten_mesh_parts *m = batten_mesh_view(mesh);
    for (int t = 0; t < m->triangle_count; t++) {
        double d[2][3], n[3];
        for (int k = 0; k < 6; k++)
            d[k / 3][k % 3] = m->points[3 * m->corners[3 * t + 1 + k / 3] + k % 3] -
                              m->points[3 * m->corners[3 * t] + k % 3];
        for (int k = 0; k < 3; k++)
            n[k] =
                d[0][(k + 1) % 3] * d[1][(k + 2) % 3] - d[0][(k + 2) % 3] * d[1][(k + 1) % 3];
        for (int c = 0; c < 3; c++) {
            const double *normal = &m->normals[9 * t + 3 * c];
            CHECK(n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2] > 0);
        }
    }
}

TEST(a_box_without_parameters_is_twelve_triangles)
{
    batten_body *box = test_box((batten_vec3){1, 2, 3}, (batten_vec3){3, 5, 7});
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    const batten_mesh_facts f = mesh_of(box, NULL, &report, &mesh);
    CHECK(f.is_watertight);
    CHECK_INT(batten_mesh_view(mesh)->triangle_count, 12);
    CHECK_INT(f.euler, 2);
    CHECK_NEAR(f.volume, 24, 24e-12);
    CHECK_NEAR(f.area, 52, 52e-12);
    CHECK_NEAR(f.centroid[2], 5, 1e-12);
    CHECK_NEAR(report.chord, 0, 1e-12);
    check_sides(mesh);
    batten_mesh_unref(mesh);
    batten_body_unref(box);
}

TEST(a_drilled_box_has_a_hole)
{
    batten_body *box = NULL;
    CHECK_OK(drilled_box(&box));
    const double chords[] = {0.1, 0.01, 1e-3, 1e-4};
    for (int i = 0; i < COUNT(chords); i++) {
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh_report report;
        batten_mesh *mesh = NULL;
        options.chord = chords[i];
        const batten_mesh_facts f = mesh_of(box, &options, &report, &mesh);
        CHECK(f.is_watertight);
        CHECK_INT(f.euler, 0);
        CHECK_INT(report.failed, 0);
        CHECK(report.chord <= chords[i]);
        CHECK(f.volume >= 48 - 2 * PI);
        CHECK(f.volume <= 48 - 2 * PI + 4 * PI * chords[i]);
        check_sides(mesh);
        for (int t = 0; t < batten_mesh_view(mesh)->triangle_count; t++)
            CHECK(batten_mesh_view(mesh)->faces[t] < DRILLED_FACES);
        batten_mesh_unref(mesh);
    }
    batten_body_unref(box);
}

TEST(a_mirrored_body_has_its_outside_outside)
{
    batten_body *box = NULL, *mirrored = NULL;
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    CHECK_OK(drilled_box(&box));
    CHECK_OK(batten_body_transform(box, &mirror, &mirrored));
    const batten_mesh_facts straight = mesh_of(box, NULL, &report, NULL);
    const batten_mesh_facts f = mesh_of(mirrored, NULL, &report, &mesh);
    CHECK(f.is_watertight);
    CHECK_NEAR(f.volume, straight.volume, 0.05);
    check_sides(mesh);
    batten_mesh_unref(mesh);
    batten_body_unref(mirrored);
    batten_body_unref(box);
}

/* ---- faces in the plane z = 0, whose (u, v) are (x, y) ---- */

typedef struct {
    bat_builder builder;
    batten_surface *plane;
} sheet;

static void sheet_begin(sheet *s, double width, double height)
{
    const double u[] = {0, 0, width, width}, v[] = {0, 0, height, height};
    const double points[4][3] = {{0, 0, 0}, {0, height, 0}, {width, 0, 0}, {width, height, 0}};
    const batten_axis axis_u = {1, 2, u, false}, axis_v = {1, 2, v, false};
    s->plane = NULL;
    CHECK_OK(batten_surface_create(3, &axis_u, &axis_v, points[0], NULL, &s->plane));
    bat_builder_begin(&s->builder, 1e-9);
    CHECK_OK(bat_builder_shell(&s->builder, false));
    CHECK_OK(bat_builder_face(&s->builder,
                              &(batten_body_face){.name = "plane", .surface = s->plane}));
}

static void sheet_add(sheet *s, const batten_curve *flat, int from, int to, bool reversed)
{
    batten_curve *lifted = NULL;
    int edge = 0;
    CHECK_OK(batten_curve_to_dimension(flat, 3, &lifted));
    CHECK_OK(bat_builder_edge(&s->builder, lifted, from, to, &edge));
    CHECK_OK(bat_builder_use(&s->builder, edge, reversed, flat));
    batten_curve_unref(lifted);
}

static void sheet_polygon(sheet *s, int count, const double (*points)[2])
{
    int first = 0;
    CHECK_OK(bat_builder_loop(&s->builder));
    for (int i = 0; i < count; i++) {
        int vertex = 0;
        CHECK_OK(bat_builder_vertex(&s->builder, (double[]){points[i][0], points[i][1], 0},
                                    &vertex));
        first = i ? first : vertex;
    }
    for (int i = 0; i < count; i++) {
        batten_curve *line = NULL;
        CHECK_OK(batten_curve_line(2, points[i], points[(i + 1) % count], &line));
        sheet_add(s, line, first + i, first + (i + 1) % count, false);
        batten_curve_unref(line);
    }
}

static void sheet_circle(sheet *s, double x, double y, double radius, bool is_hole)
{
    const batten_affine place = batten_affine_translation(x, y, 0);
    batten_curve *circle = NULL, *placed = NULL;
    int vertex = 0;
    CHECK_OK(batten_curve_circle(radius, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_OK(batten_curve_transform(circle, &place, &placed));
    CHECK_OK(bat_builder_loop(&s->builder));
    CHECK_OK(bat_builder_vertex(&s->builder, (double[]){x + radius, y, 0}, &vertex));
    sheet_add(s, placed, vertex, vertex, is_hole);
    batten_curve_unref(circle);
    batten_curve_unref(placed);
}

static batten_body *sheet_end(sheet *s)
{
    batten_body *body = NULL;
    batten_surface_unref(s->plane);
    s->builder.parts.is_traced = true;
    const batten_status status = bat_builder_finish(&s->builder, false, &body);
    if (test_memory_failed(status, BATTEN_OK)) /* the builder is empty now */
        SKIP("no memory for the body");
    CHECK(status == BATTEN_OK);
    return body;
}

TEST(an_l_is_four_triangles)
{
    static const double corners[6][2] = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    sheet s;
    batten_mesh_report report;
    sheet_begin(&s, 4, 3);
    sheet_polygon(&s, 6, corners);
    batten_body *body = sheet_end(&s);
    const batten_mesh_facts f = mesh_of(body, NULL, &report, NULL);
    CHECK_INT(f.rim_edges, 6);
    CHECK_INT(f.edges, 9);
    CHECK_NEAR(f.area, 6, 1e-14);
    batten_body_unref(body);
}

/* A line and an arc that leaves it by less than the chord: their only samples are their ends.
 */
TEST(a_sliver_between_a_line_and_an_arc_is_meshed_at_every_chord)
{
    static const double chords[] = {1, 0.3, 0.1, 0.03, 0.01, 1e-3};
    static const double ends[2][2] = {{1, 0}, {1, 4}}, knots[] = {0, 0, 0, 1, 1, 1};
    static const double arc[3][2] = {{1, 0}, {1.1, 2}, {1, 4}};
    for (int i = 0; i < COUNT(chords); i++) {
        batten_curve *line = NULL, *bow = NULL;
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh_report report;
        int vertices[2];
        sheet s;
        options.chord = chords[i];
        sheet_begin(&s, 2, 4);
        CHECK_OK(bat_builder_loop(&s.builder));
        for (int k = 0; k < 2; k++)
            CHECK_OK(bat_builder_vertex(&s.builder, (double[]){ends[k][0], ends[k][1], 0},
                                        &vertices[k]));
        CHECK_OK(batten_curve_line(2, ends[0], ends[1], &line));
        CHECK_OK(batten_curve_create((batten_points){2, 3, arc[0]}, 2, NULL, knots, &bow));
        sheet_add(&s, bow, vertices[0], vertices[1], false);
        sheet_add(&s, line, vertices[0], vertices[1], true);
        batten_curve_unref(line);
        batten_curve_unref(bow);
        batten_body *body = sheet_end(&s);
        const batten_mesh_facts f = mesh_of(body, &options, &report, NULL);
        CHECK_INT(report.failed, 0);
        CHECK_NEAR(f.area, 0.4 / 3, bat_min(0.04, 4 * chords[i]));
        batten_body_unref(body);
    }
}

/* Each loop has a vertex of its own there, as a file says it that cannot share them. */
TEST(loops_that_touch_at_a_vertex_are_meshed)
{
    static const double square[4][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    static const double hole[3][2] = {{0, 0}, {1, 2}, {2, 1}};
    for (int i = 0; i < 3; i++) { /* exactly, within the tolerance, beyond */
        const double off = i == 0 ? 0 : i == 1 ? 1e-9 : 1e-7;
        double moved[3][2];
        for (int k = 0; k < 6; k++)
            moved[k / 2][k % 2] = hole[k / 2][k % 2] - off;
        sheet s;
        batten_mesh_report report;
        sheet_begin(&s, 4, 4);
        sheet_polygon(&s, 4, square);
        sheet_polygon(&s, 3, (const double(*)[2])moved);
        batten_body *body = sheet_end(&s);
        const batten_mesh_facts f = mesh_of(body, NULL, &report, NULL);
        CHECK_INT(report.failed, i == 2);
        CHECK_NEAR(f.area, i == 2 ? 0 : 14.5, 1e-7);
        batten_body_unref(body);
    }
}

TEST(a_plate_with_200_holes)
{
    static const double corners[4][2] = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};
    sheet s;
    batten_mesh_report report;
    batten_mesh_options options = batten_mesh_defaults();
    options.chord = 1e-3;
    sheet_begin(&s, 20, 10);
    sheet_polygon(&s, 4, corners);
    for (int i = 0; i < 200; i++)
        sheet_circle(&s, 0.5 + i % 20, 0.5 + i / 20, 0.2 + 0.001 * i, true);
    batten_body *body = sheet_end(&s);
    const batten_mesh_facts f = mesh_of(body, &options, &report, NULL);
    double holes = 0, rims = 0;
    for (int i = 0; i < 200; i++) {
        holes += PI * pow(0.2 + 0.001 * i, 2);
        rims += 2 * PI * (0.2 + 0.001 * i);
    }
    CHECK_INT(f.euler, 1 - 200);
    CHECK_INT(f.pieces, 1);
    CHECK(f.area >= 200 - holes);
    CHECK(f.area <= 200 - holes + rims * 1e-3);
    CHECK(report.chord <= 1e-3);
    batten_body_unref(body);
}

TEST(a_thin_ring_gets_as_many_points_as_it_needs)
{
    const double gaps[] = {1e-2, 1e-3, 1e-5};
    for (int i = 0; i < COUNT(gaps); i++) {
        sheet s;
        batten_mesh_report report;
        batten_mesh_options options = batten_mesh_defaults();
        options.chord = 0.01;
        sheet_begin(&s, 2, 2);
        sheet_circle(&s, 1, 1, 1, false);
        sheet_circle(&s, 1, 1, 1 - gaps[i], true);
        batten_body *body = sheet_end(&s);
        const batten_mesh_facts f = mesh_of(body, &options, &report, NULL);
        CHECK_INT(report.failed, 0);
        CHECK_INT(f.euler, 0);
        CHECK_INT(f.pieces, 1);
        CHECK_NEAR(f.area, PI * (1 - pow(1 - gaps[i], 2)), 4 * gaps[i]);
        batten_body_unref(body);
    }
}

TEST(a_face_that_crosses_itself_is_left_out_with_a_note)
{
    static const double crossed[4][2] = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    static const double square[4][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    sheet s;
    batten_mesh_report report;
    batten_notes *notes = NULL;
    batten_mesh *mesh = NULL;
    sheet_begin(&s, 2, 2);
    sheet_polygon(&s, 4, crossed);
    CHECK_OK(
        bat_builder_face(&s.builder, &(batten_body_face){.name = "good", .surface = s.plane}));
    sheet_polygon(&s, 4, square);
    batten_body *body = sheet_end(&s);
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_mesh_from_body(body, NULL, NULL, notes, &report, &mesh));
    CHECK_INT(report.failed, 1);
    CHECK_INT(batten_mesh_view(mesh)->triangle_count, 2);
    CHECK_INT(batten_mesh_view(mesh)->faces[0], 1);
    if (batten_notes_count(notes)) {
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "plane");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "crosses or touches itself");
    }
    batten_notes_free(notes);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}

/* The front of the box is far from its edges, so it cannot be traced: the triangles of the
 * other five name them by their numbers in the given body. */
TEST(triangles_name_the_faces_of_the_given_body)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3}), *body = NULL;
    batten_body_parts parts = *batten_body_view(box);
    batten_body_face faces[6];
    batten_surface *away = NULL;
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    batten_notes *notes = NULL;
    const batten_affine lift = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 9, 0}};
    int found[6] = {0};
    for (int i = 0; i < 6; i++)
        faces[i] = parts.faces[i];
    CHECK_OK(batten_surface_transform(faces[2].surface, &lift, &away));
    faces[2].surface = away;
    parts.faces = faces;
    CHECK_OK(batten_body_create(&parts, &body));
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_mesh_from_body(body, NULL, NULL, notes, &report, &mesh));
    CHECK_INT(report.failed, 1);
    if (batten_notes_count(notes))
        CHECK_CONTAINS(batten_notes_at(notes, 0)->entity, "face 3, front");
    const batten_mesh_parts *made = batten_mesh_view(mesh);
    for (int i = 0; i < made->triangle_count; i++)
        found[made->faces[i]]++;
    for (int i = 0; i < 6; i++)
        CHECK_INT(found[i], i == 2 ? 0 : 2);
    batten_notes_free(notes);
    batten_mesh_unref(mesh);
    batten_surface_unref(away);
    batten_body_unref(body);
    batten_body_unref(box);
}

/* Two discs on one another share nothing but their rim, however alike their triangles are. */
TEST(two_discs_with_one_rim_are_closed)
{
    sheet s;
    batten_mesh_report report;
    sheet_begin(&s, 2, 2);
    sheet_circle(&s, 1, 1, 1, false);
    CHECK_OK(bat_builder_face(
        &s.builder, &(batten_body_face){.name = "back", .surface = s.plane, .reversed = true}));
    CHECK_OK(bat_builder_loop(&s.builder));
    CHECK_OK(bat_builder_use(&s.builder, 0, true, s.builder.parts.uses[0].parameters));
    batten_body *body = sheet_end(&s);
    const batten_mesh_facts f = mesh_of(body, NULL, &report, NULL);
    CHECK(f.is_watertight);
    CHECK_INT(f.euler, 2);
    CHECK_NEAR(f.volume, 0, 1e-15);
    batten_body_unref(body);
}

TEST(a_body_without_faces_is_an_empty_mesh_or_refused)
{
    const batten_body_parts parts = {.tolerance = 1e-6, .is_traced = true};
    batten_body *body = NULL;
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_body_create(&parts, &body));
    CHECK_STATUS(batten_mesh_from_body(body, NULL, NULL, NULL, NULL, &mesh),
                 BATTEN_BAD_ARGUMENT);
    batten_body_unref(body);
}

/* A square of side 2 whose edges are at a height over it, in a body that promises 1e-9. */
static batten_body *raised_edges(double height)
{
    const double corners[4][3] = {
        {0, 0, height}, {2, 0, height}, {2, 2, height}, {0, 2, height}};
    sheet s;
    batten_body *body = NULL;
    int vertices[4], edge;
    sheet_begin(&s, 2, 2);
    CHECK_OK(bat_builder_loop(&s.builder));
    for (int i = 0; i < 4; i++)
        CHECK_OK(bat_builder_vertex(&s.builder, corners[i], &vertices[i]));
    for (int i = 0; i < 4; i++) {
        batten_curve *line = NULL;
        CHECK_OK(batten_curve_line(3, corners[i], corners[(i + 1) % 4], &line));
        CHECK_OK(bat_builder_edge(&s.builder, line, vertices[i], vertices[(i + 1) % 4], &edge));
        CHECK_OK(bat_builder_use(&s.builder, edge, false, NULL));
        batten_curve_unref(line);
    }
    batten_surface_unref(s.plane);
    const batten_status status = bat_builder_finish(&s.builder, false, &body);
    if (test_memory_failed(status, BATTEN_OK))
        SKIP("no memory for the body");
    return body;
}

/* Up to 5e-3 of the size of the body they are traced, and up to the chord. */
TEST(edges_off_their_face_are_borne_and_told)
{
    static const struct {
        double height, chord;
        bool borne;
    } cases[] = {
        {0.002, 0.01, true}, {0.002, 0.001, true}, {0.02, 0.03, true}, {0.02, 0.001, false}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_mesh_report report;
        batten_mesh *mesh = NULL;
        batten_mesh_options options = batten_mesh_defaults();
        batten_body *body = raised_edges(cases[i].height);
        options.chord = cases[i].chord;
        CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, &report, &mesh));
        CHECK_INT(report.failed, !cases[i].borne);
        if (cases[i].borne) {
            batten_mesh_facts f;
            CHECK_OK(batten_mesh_check(mesh, &f));
            CHECK_NEAR(report.chord, cases[i].height, 1e-6);
            CHECK_NEAR(f.area, 4, 1e-2);
        } else {
            CHECK_INT(batten_mesh_view(mesh)->triangle_count, 0);
        }
        batten_mesh_unref(mesh);
        batten_body_unref(body);
    }
}

/* However fine their samples, they stay on one another: that must not take time with the square
 * of the samples, nor go on beyond what is allowed. */
TEST(S3_a_border_that_lies_on_itself_is_given_up_in_time)
{
    sheet s;
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    batten_mesh_options options = batten_mesh_defaults();
    options.most = 5000;
    sheet_begin(&s, 4, 4);
    sheet_circle(&s, 2, 2, 1.5, false);
    sheet_circle(&s, 2, 2, 1, true);
    sheet_circle(&s, 2, 2, 1, true);
    batten_body *body = sheet_end(&s);
    CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, &report, &mesh));
    CHECK_INT(report.failed, 1);
    CHECK_INT(batten_mesh_view(mesh)->triangle_count, 0);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}

/* The surface (s^2, y, s^3): its normal is turned about along s = 0, at a cusp. */
static batten_body *cusp(void)
{
    const double u[] = {0, 0, 0, 0, 1, 1, 1, 1}, v[] = {0, 0, 2, 2};
    const double a = -0.371, b = 0.629; /* s there is in no middle */
    const double x[] = {a * a, (a * a + 2 * a * b) / 3, (b * b + 2 * a * b) / 3, b * b};
    const double z[] = {a * a * a, a * a * b, a * b * b, b * b * b};
    double points[8][3];
    const batten_axis along = {3, 4, u, false}, across = {1, 2, v, false};
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    for (int i = 0; i < 8; i++) {
        points[i][0] = x[i / 2];
        points[i][1] = i % 2 ? 2 : 0;
        points[i][2] = z[i / 2];
    }
    CHECK_OK(batten_surface_create(3, &along, &across, points[0], NULL, &surface));
    CHECK_OK(batten_body_from_surface("cusp", surface, 1e-9, &body));
    batten_surface_unref(surface);
    return body;
}

TEST(a_face_that_turns_about_is_divided_so_far_and_no_further)
{
    batten_mesh_report report;
    batten_mesh *mesh = NULL;
    batten_notes *notes = NULL;
    batten_mesh_options options = batten_mesh_defaults();
    batten_body *body = cusp();
    options.chord = 1e-5;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_mesh_from_body(body, &options, NULL, notes, &report, &mesh));
    CHECK_INT(report.failed, 0);
    CHECK(batten_mesh_view(mesh)->triangle_count < 100000);
    /* Twice where memory failed and it was meshed again. */
    CHECK(batten_notes_count(notes) + batten_notes_dropped(notes) >= 1);
    if (!batten_notes_dropped(notes))
        CHECK(strstr(batten_notes_at(notes, 0)->text, "face 1 was divided no further at"));
    batten_notes_free(notes);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}
