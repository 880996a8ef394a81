#include "support/test.h"

#include <batten/mesh.h>
#include <math.h>
#include <string.h>

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

/* z = x^2 - y^2 / 2 over the square as two quadratic triangles: the middle point of an edge has
 * the polar form of its ends for a height. */
static batten_triangles *saddle_of_triangles(const double *weights)
{
    static const double corners[2][3][2] = {{{0, 0}, {1, 0}, {0, 1}}, {{1, 1}, {0, 1}, {1, 0}}};
    double points[2][6][3];
    batten_triangles *made = NULL;
    for (int t = 0; t < 2; t++)
        for (int j = 0; j <= 2; j++)
            for (int k = 0; j + k <= 2; k++) {
                double *p = points[t][BATTEN_TRIANGLE_POINT(j, k)];
                const int first = j + k < 2 ? 0 : j > 0 ? 1 : 2;
                const int last = k > 0 ? 2 : j > 0 ? 1 : 0;
                const double *a = corners[t][first], *b = corners[t][last];
                p[0] = (a[0] + b[0]) / 2;
                p[1] = (a[1] + b[1]) / 2;
                p[2] = a[0] * b[0] - a[1] * b[1] / 2;
            }
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){3, 2, 2, points[0][0], weights, NULL}, &made));
    return made;
}

/* The longest side of the triangles. */
static double longest_side(const batten_mesh *mesh)
{
    const batten_mesh_parts *made = batten_mesh_view(mesh);
    double longest = 0;
    for (int i = 0; i < 3 * made->triangle_count; i++) {
        const double *a = made->points + 3 * made->corners[i];
        const double *b = made->points + 3 * made->corners[i % 3 == 2 ? i - 2 : i + 1];
        longest = fmax(longest, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
    }
    return longest;
}

/* The largest second difference is 1, that of x: with n parts a triangle is 1 / (3 n^2) off at
 * most, and angles ask for nothing. 11 parts of the diagonal of the box, 1 by 1 by 3/2, are as long
 * as 0.2, but the side from (1, 10/11) to (10/11, 1) is 0.290 long: so 11 * 1.1 * 1.45 parts are made. */
TEST(triangles_are_divided_as_often_as_their_second_differences_need)
{
    batten_triangles *triangles = saddle_of_triangles(NULL);
    static const struct {
        double chord, longest;
        int parts;
    } cases[] = {{0.5, 0, 1},    {0.3, 0, 2}, {1.0 / 26, 0, 3}, {1e-2, 0, 6}, {1e-4, 0, 58},
                 {0.5, 0.2, 18}, {0.5, 2, 2}, {1e-2, 0.2, 18},  {1e-2, 10, 6}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh_report report;
        batten_mesh *mesh = NULL;
        options.chord = cases[i].chord;
        options.longest = cases[i].longest;
        options.angle = 3;
        CHECK_OK(batten_mesh_from_triangles(triangles, &options, NULL, &report, &mesh));
        CHECK_INT(batten_mesh_view(mesh)->triangle_count, 2 * cases[i].parts * cases[i].parts);
        CHECK_NEAR(report.asked, cases[i].chord, 0);
        CHECK(report.chord > 0 && report.chord <= 1.0 / 3 / cases[i].parts / cases[i].parts);
        CHECK_INT(report.beyond, 0);
        CHECK(cases[i].longest == 0 || longest_side(mesh) <= cases[i].longest * (1 + 1e-12));
        batten_mesh_unref(mesh);
    }
    batten_triangles_unref(triangles);
}

/* A flat triangle whose sides run slowly at one end and fast at the other. */
TEST(sides_of_uneven_triangles_are_no_longer_than_the_longest)
{
    double points[10][3] = {{0}};
    batten_triangles *triangles = NULL;
    for (int j = 0; j <= 3; j++)
        for (int k = 0; j + k <= 3; k++) {
            points[BATTEN_TRIANGLE_POINT(j, k)][0] = j * j * j / 27.0;
            points[BATTEN_TRIANGLE_POINT(j, k)][1] = k * k * k / 27.0;
        }
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 3, 1, points[0], NULL, NULL},
                                     &triangles));
    static const double lengths[] = {1, 0.3, 0.1};
    for (int i = 0; i < COUNT(lengths); i++) {
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh *mesh = NULL;
        options.chord = 1;
        options.longest = lengths[i];
        CHECK_OK(batten_mesh_from_triangles(triangles, &options, NULL, NULL, &mesh));
        CHECK(longest_side(mesh) <= lengths[i] * (1 + 1e-12));
        batten_mesh_unref(mesh);
    }
    batten_triangles_unref(triangles);
}

static const struct {
    double chord, angle, longest;
    int most;
    batten_status status;
    const char *message;
} refused[] = {
    {-1, 1, 0, 9, BATTEN_BAD_ARGUMENT, "the chord is -1; it must not be below 0"},
    {INFINITY, 1, 0, 9, BATTEN_BAD_ARGUMENT, "the chord is inf"},
    {NAN, 1, 0, 9, BATTEN_BAD_ARGUMENT, "the chord is nan"},
    {1, 0, 0, 9, BATTEN_BAD_ARGUMENT, "the angle is 0; it must be above 0"},
    {1, INFINITY, 0, 9, BATTEN_BAD_ARGUMENT, "the angle is inf"},
    {1, 1, -2, 9, BATTEN_BAD_ARGUMENT, "the longest edge is -2; it must not be below 0"},
    {1, 1, NAN, 9, BATTEN_BAD_ARGUMENT, "the longest edge is nan"},
    {1, 1, 0, 0, BATTEN_BAD_ARGUMENT, "0 triangles are allowed"},
    {1e-16, 1, 0, 9, BATTEN_BAD_ARGUMENT,
     "a chord of 1e-16 is in the roundoff of size 2.06155"},
    {0.3, 3, 0, 7, BATTEN_TOO_LARGE,
     "8 triangles are needed for a chord of 0.3 and an angle of 3; 7 are allowed"},
};

TEST(options_that_triangles_cannot_meet_are_refused_and_named)
{
    batten_triangles *triangles = saddle_of_triangles(NULL);
    batten_mesh *mesh = NULL;
    for (int i = 0; i < COUNT(refused); i++) {
        batten_mesh_options options = batten_mesh_defaults();
        options.chord = refused[i].chord;
        options.angle = refused[i].angle;
        options.longest = refused[i].longest;
        options.most = refused[i].most;
        CHECK_STATUS(batten_mesh_from_triangles(triangles, &options, NULL, NULL, &mesh),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    batten_mesh_options options = batten_mesh_defaults();
    options.chord = 0.3;
    options.angle = 3;
    options.most = 8; /* as many as are needed */
    CHECK(!mesh);
    CHECK_OK(batten_mesh_from_triangles(triangles, &options, NULL, NULL, &mesh));
    batten_mesh_unref(mesh);
    batten_triangles_unref(triangles);
}

TEST(without_a_chord_triangles_keep_a_thousandth_of_their_size)
{
    batten_triangles *triangles = saddle_of_triangles(NULL);
    batten_mesh_report report;
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_mesh_from_triangles(triangles, NULL, NULL, &report, &mesh));
    CHECK_NEAR(report.asked, 1e-3 * sqrt(1 + 1 + 2.25), 1e-15);
    CHECK(report.chord <= report.asked);
    batten_mesh_unref(mesh);
    batten_triangles_unref(triangles);
}

/* The largest angle between two normals of one triangle. */
static double widest_turn(const batten_mesh *mesh)
{
    const batten_mesh_parts *made = batten_mesh_view(mesh);
    double widest = 0;
    for (int t = 0; t < made->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const double *a = made->normals + 9 * t + 3 * k;
            const double *b = made->normals + 9 * t + 3 * ((k + 1) % 3);
            const double off = hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
            widest = fmax(widest, 2 * asin(off / 2));
        }
    return widest;
}

TEST(more_parts_are_made_until_normals_turn_no_more_than_the_angle)
{
    batten_triangles *triangles = saddle_of_triangles(NULL);
    static const double angles[] = {1, 0.3, 0.1, 0.03};
    for (int i = 0; i < COUNT(angles); i++) {
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh_report report;
        batten_mesh *mesh = NULL;
        options.chord = 10;
        options.angle = angles[i];
        CHECK_OK(batten_mesh_from_triangles(triangles, &options, NULL, &report, &mesh));
        CHECK_NEAR(report.angle, widest_turn(mesh), 1e-12);
        CHECK(report.angle <= angles[i]);
        /* Slopes change by 2 in all, so an angle needs no more than 2 / angle parts, and rounding
         * up with a tenth to spare. */
        const double parts = sqrt(batten_mesh_view(mesh)->triangle_count / 2.0);
        CHECK(parts <= 1.1 * 2 * sqrt(2) / angles[i] + 2);
        batten_mesh_unref(mesh);
    }
    batten_triangles_unref(triangles);
}

TEST(vertices_lie_on_the_triangles_and_normals_stand_on_them)
{
    static const double weights[12] = {2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2};
    for (int w = 0; w < 2; w++) {
        batten_triangles *triangles = saddle_of_triangles(w ? weights : NULL);
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh *mesh = NULL;
        options.chord = 1e-3;
        CHECK_OK(batten_mesh_from_triangles(triangles, &options, NULL, NULL, &mesh));
        const batten_mesh_parts *made = batten_mesh_view(mesh);
        for (int i = 0; i < made->vertex_count; i++) {
            const double *p = made->points + 3 * i;
            CHECK(p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1);
            CHECK_NEAR(p[2], p[0] * p[0] - p[1] * p[1] / 2, 1e-15);
        }
        for (int i = 0; i < 3 * made->triangle_count; i++) {
            const double *p = made->points + 3 * made->corners[i], *n = made->normals + 3 * i;
            const double length = sqrt(1 + 4 * p[0] * p[0] + p[1] * p[1]);
            CHECK_NEAR(n[0], -2 * p[0] / length, 1e-13);
            CHECK_NEAR(n[1], p[1] / length, 1e-13);
            CHECK_NEAR(n[2], 1 / length, 1e-13);
        }
        batten_mesh_unref(mesh);
        batten_triangles_unref(triangles);
    }
}

/* Two triangles that share an edge with uneven weights, in either order of its ends. */
TEST(edges_of_rational_triangles_are_shared_to_the_bit)
{
    test_random random = test_random_begin("rational triangles");
    for (int turn = test_cases(20); turn > 0; turn--) {
        double points[2][10][3], weights[2][10];
        batten_triangles *triangles = NULL;
        batten_mesh *mesh = NULL;
        batten_mesh_facts facts;
        batten_mesh_options options = batten_mesh_defaults();
        for (int t = 0; t < 2; t++)
            for (int j = 0; j <= 3; j++)
                for (int k = 0; j + k <= 3; k++) {
                    const int at = BATTEN_TRIANGLE_POINT(j, k);
                    double *p = points[t][at];
                    p[0] = (t ? 3 - j : j) / 3.0;
                    p[1] = (t ? 3 - k : k) / 3.0;
                    p[2] = test_random_in(&random, -0.2, 0.2);
                    weights[t][at] = test_random_in(&random, 0.5, 2);
                    /* Edge j + k = 3 of the first is (j, k) -> (3 - j, 3 - k) of the second. */
                    if (t && j + k == 3) {
                        memcpy(p, points[0][BATTEN_TRIANGLE_POINT(k, j)], sizeof points[0][0]);
                        weights[1][at] = weights[0][BATTEN_TRIANGLE_POINT(k, j)];
                    }
                }
        CHECK_OK(batten_triangles_create(
            &(batten_triangles_parts){3, 3, 2, points[0][0], weights[0], NULL}, &triangles));
        options.chord = 0.01;
        options.angle = 3;
        CHECK_OK(batten_mesh_from_triangles(triangles, &options, NULL, NULL, &mesh));
        CHECK_OK(batten_mesh_check(mesh, &facts));
        CHECK_INT(facts.pieces, 1);
        CHECK_INT(facts.euler, 1);
        batten_mesh_unref(mesh);
        batten_triangles_unref(triangles);
    }
}

TEST(triangles_of_the_plane_are_not_meshed)
{
    static const double corners[] = {0, 0, 1, 0, 0, 1};
    batten_triangles *flat = NULL;
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){2, 1, 1, corners, NULL, NULL},
                                     &flat));
    CHECK_STATUS(batten_mesh_from_triangles(flat, NULL, NULL, NULL, &mesh),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the triangles have 2 dimensions, not 3");
    CHECK(!mesh);
    batten_triangles_unref(flat);
}
