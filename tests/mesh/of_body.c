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
