/* The chord is met, with no more triangles than the shape needs; or it is said that it is not.
 */
#include "support/test.h"

#include <batten/mesh.h>
#include <batten/skin.h>
#include <batten/standard.h>

static const double PI = 3.14159265358979323846;

static batten_mesh_options with_chord(double chord)
{
    batten_mesh_options options = batten_mesh_defaults();
    options.chord = chord;
    return options;
}

/* A quarter of a cylinder along x. */
static batten_surface *quarter(double radius, double length)
{
    batten_curve *flat = NULL, *arc = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_arc(radius, PI / 2, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &arc));
    CHECK_OK(batten_surface_extruded(arc, (batten_vec3){0, 0, length}, &surface));
    batten_curve_unref(flat);
    batten_curve_unref(arc);
    return surface;
}

/* The face of the quarter with edges that are off it outwards. */
static batten_body *with_edges_off(double off)
{
    batten_surface *surface = quarter(10, 30), *wider = quarter(10 + off, 30);
    batten_body *around = NULL, *body = NULL;
    CHECK_OK(batten_body_from_surface("quarter", wider, 1e-9, &around));
    batten_body_parts parts = *batten_body_view(around);
    batten_body_face face = parts.faces[0];
    face.surface = surface;
    parts.faces = &face;
    CHECK_OK(batten_body_create(&parts, &body));
    batten_body_unref(around);
    batten_surface_unref(surface);
    batten_surface_unref(wider);
    return body;
}

static int mesh_off(double off, double chord, batten_mesh_report *report)
{
    const batten_mesh_options options = with_chord(chord);
    batten_body *body = with_edges_off(off);
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, report, &mesh));
    const int count = batten_mesh_view(mesh)->triangle_count;
    batten_mesh_unref(mesh);
    batten_body_unref(body);
    return count;
}

TEST(edges_off_their_face_by_less_than_the_chord_leave_it_met)
{
    static const double shares[] = {0, 0.3, 0.6, 0.85};
    for (int i = 0; i < COUNT(shares); i++) {
        batten_mesh_report report;
        mesh_off(shares[i] * 0.02, 0.02, &report);
        CHECK(report.chord <= 0.02);
        CHECK_INT(report.beyond, 0);
        CHECK_NEAR(report.asked, 0.02, 0);
    }
}

TEST(edges_off_their_face_by_more_are_told_with_their_number)
{
    batten_mesh_report report;
    const int count = mesh_off(0.05, 0.02, &report);
    CHECK(report.chord > 0.02 && report.chord < 0.08);
    CHECK(report.beyond > 0 && report.beyond <= count);
    CHECK_NEAR(report.error, 0.05, 1e-6);
}

/* A strip that is long, twists and bends a little along its length and much across: as on a
 * wing its long borders are nearly straight. Across it is a parabola of height 100 and width
 * 400. */
static batten_surface *strip(double bow)
{
    const double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 0, 1, 1, 1};
    const batten_axis along = {2, 3, u, false}, across = {2, 3, v, false};
    double points[3][3][3];
    batten_surface *surface = NULL;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            points[i][j][0] = 5000.0 * i;
            points[i][j][1] = 200.0 * j;
            points[i][j][2] = (j == 1 ? 200 : 0) + (i == 1 && j == 1 ? bow : 0);
        }
    CHECK_OK(batten_surface_create(3, &along, &across, points[0][0], NULL, &surface));
    return surface;
}

TEST(triangles_are_as_long_as_the_surface_is_straight)
{
    /* Second derivatives: 400 across, up to bow along. Cells of widths by which either rises
     * half a chord need two triangles each. */
    const double chord = 0.1, bow = 50;
    const batten_mesh_options options = with_chord(chord);
    const double cells = sqrt(800 / (4 * chord)) * sqrt(2 * bow / (4 * chord));
    batten_surface *surface = strip(bow);
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_mesh_from_surface(surface, &options, NULL, &report, &mesh));
    CHECK(report.chord <= chord);
    CHECK_INT(report.beyond, 0);
    CHECK(batten_mesh_view(mesh)->triangle_count < 4 * cells);
    batten_mesh_unref(mesh);
    batten_surface_unref(surface);
}

TEST(a_long_straight_border_keeps_no_points_away)
{
    const double chord = 0.1;
    const batten_mesh_options options = with_chord(chord);
    batten_surface *surface = strip(3000);
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    batten_mesh_facts facts;
    CHECK_OK(batten_mesh_from_surface(surface, &options, NULL, &report, &mesh));
    CHECK(report.chord <= chord);
    CHECK_INT(report.beyond, 0);
    CHECK_OK(batten_mesh_check(mesh, &facts));
    CHECK_INT(facts.wrong_edges + facts.crowded_edges + facts.flat_triangles, 0);
    CHECK_INT(facts.euler, 1);
    batten_mesh_unref(mesh);
    batten_surface_unref(surface);
}

TEST(a_span_of_no_length_does_not_divide_an_edge_for_ever)
{
    /* A plane whose first span in v is 1e-15 long, and in it points off by roundoff: there the
     * direction of Sv is anything. */
    const double u[] = {0, 0, 1, 1}, v[] = {0, 0, 1e-15, 1, 1};
    const batten_axis along = {1, 2, u, false}, across = {1, 3, v, false};
    const double points[2][3][3] = {
        {{3000, 0, 0}, {3000, -4e-13, 1e-12}, {3000, 1000, 0}},
        {{3000, 0, 9000}, {3000 + 1e-12, 4e-13, 9000}, {3000, 1000, 9000}}};
    const batten_mesh_options options = with_chord(0.5);
    batten_surface *surface = NULL;
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_surface_create(3, &along, &across, points[0][0], NULL, &surface));
    CHECK_OK(batten_mesh_from_surface(surface, &options, NULL, &report, &mesh));
    CHECK(batten_mesh_view(mesh)->triangle_count < 20);
    batten_mesh_unref(mesh);
    batten_surface_unref(surface);
}
