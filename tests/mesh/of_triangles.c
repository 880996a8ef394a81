#include "support/test.h"

#include <batten/mesh.h>

/* A bump over the square: two quartic triangles that share an edge. */
static batten_triangles *bump(void)
{
    enum { DEGREE = 4, EACH = BATTEN_TRIANGLE_POINTS(DEGREE) };
    static const double corners[2][3][2] = {{{0, 0}, {1, 0}, {0, 1}}, {{1, 1}, {0, 1}, {1, 0}}};
    double points[2][EACH][3];
    batten_triangles *made = NULL;
    for (int t = 0; t < 2; t++)
        for (int j = 0; j <= DEGREE; j++)
            for (int k = 0; j + k <= DEGREE; k++) {
                double *p = points[t][BATTEN_TRIANGLE_POINT(j, k)];
                for (int i = 0; i < 2; i++)
                    p[i] = ((DEGREE - j - k) * corners[t][0][i] + j * corners[t][1][i] +
                            k * corners[t][2][i]) /
                           DEGREE;
                p[2] = sin(3 * p[0]) * cos(2 * p[1]);
            }
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){3, DEGREE, 2, points[0][0], NULL, NULL}, &made));
    return made;
}

TEST(bezier_triangles_share_the_vertices_of_their_edges)
{
    batten_triangles *triangles = bump();
    const double chords[] = {0.1, 1e-2, 1e-3, 1e-4};
    for (int i = 0; i < COUNT(chords); i++) {
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh_report report;
        batten_mesh_facts f;
        batten_mesh *mesh = NULL;
        options.chord = chords[i];
        CHECK_OK(batten_mesh_from_triangles(triangles, &options, NULL, &report, &mesh));
        CHECK_OK(batten_mesh_check(mesh, &f));
        CHECK(report.chord <= chords[i]);
        CHECK(report.angle <= options.angle);
        CHECK_INT(f.pieces, 1);
        CHECK_INT(f.euler, 1);
        CHECK_INT(f.wrong_edges + f.crowded_edges, 0);
        batten_mesh_unref(mesh);
    }
    batten_triangles_unref(triangles);
}

TEST(too_many_parts_of_triangles_are_refused)
{
    batten_triangles *triangles = bump();
    batten_mesh_options options = batten_mesh_defaults();
    batten_mesh *mesh = NULL;
    options.chord = 1e-12;
    CHECK_STATUS(batten_mesh_from_triangles(triangles, &options, NULL, NULL, &mesh),
                 BATTEN_TOO_LARGE);
    options.chord = -1;
    CHECK_STATUS(batten_mesh_from_triangles(triangles, &options, NULL, NULL, &mesh),
                 BATTEN_BAD_ARGUMENT);
    batten_triangles_unref(triangles);
}
