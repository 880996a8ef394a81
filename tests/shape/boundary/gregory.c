#include <batten/fill.h>

#include "support/faults.h"
#include "support/test.h"

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static double norm(const double a[3])
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* The sine of the angle between two directions, either way. */
static double apart(const double a[3], const double b[3])
{
    double c[3];
    cross(a, b, c);
    return norm(c) / (norm(a) * norm(b));
}

static void bezier(int degree, const double (*points)[3], double t, double out[3])
{
    double b[8][3];
    memcpy(b, points, (size_t)(degree + 1) * sizeof *b);
    for (int r = degree; r > 0; r--)
        for (int i = 0; i < r; i++)
            for (int c = 0; c < 3; c++)
                b[i][c] = (1 - t) * b[i][c] + t * b[i + 1][c];
    memcpy(out, b[0], sizeof b[0]);
}

TEST(the_field_across_an_edge_gives_both_faces_the_same_planes)
{
    test_random random = test_random_begin("gregory fields");
    for (int n = 0; n < test_cases(200); n++) {
        double edge[4][3], across[2][2][3], fields[2][4][3], hodograph[3][3];
        for (int i = 0; i < 4; i++)
            for (int c = 0; c < 3; c++)
                edge[i][c] = (c == 0 ? i : 0) + test_random_in(&random, -0.3, 0.3);
        for (int i = 0; i < 3; i++)
            for (int c = 0; c < 3; c++)
                hodograph[i][c] = 3 * (edge[i + 1][c] - edge[i][c]);
        for (int end = 0; end < 2; end++) {
            const double factor = test_random_in(&random, 0.5, 2);
            const double along = test_random_in(&random, -0.3, 0.3);
            for (int c = 0; c < 3; c++) {
                across[0][end][c] = (c == 1) + test_random_in(&random, -0.4, 0.4);
                across[1][end][c] = -factor * across[0][end][c] + along * hodograph[2 * end][c];
            }
        }
        for (int face = 0; face < 2; face++)
            CHECK_EACH_ALLOCATION(
                batten_gregory_field(edge[0], across[face][0], NULL, fields[face][0]));
        for (int end = 0; end < 2; end++)
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(fields[0][3 * end][c], across[0][end][c], 1e-15);
        for (int k = 0; k <= 20; k++) {
            double tangent[3], a[3], b[3], normals[2][3];
            bezier(2, (const double(*)[3])hodograph, k / 20.0, tangent);
            bezier(3, (const double(*)[3])fields[0], k / 20.0, a);
            bezier(3, (const double(*)[3])fields[1], k / 20.0, b);
            cross(tangent, a, normals[0]);
            cross(tangent, b, normals[1]);
            CHECK_NEAR(apart(normals[0], normals[1]), 0, 1e-12);
        }
    }
}

static void random_square(test_random *random, double points[16][3], double inner[8][3])
{
    for (int k = 0; k < 24; k++)
        for (int c = 0; c < 3; c++) {
            const int i = k < 16 ? k / 4 : 1 + (k - 16) / 4;
            const int j = k < 16 ? k % 4 : 1 + (k - 16) / 2 % 2;
            double *to = k < 16 ? points[k] : inner[k - 16];
            to[c] = (c == 0 ? i : c == 1 ? j : 0) + test_random_in(random, -0.4, 0.4);
        }
}

TEST(each_edge_of_a_gregory_patch_sees_its_own_inner_points)
{
    test_random random = test_random_begin("gregory edges");
    double points[16][3], inner[8][3], row[4][3];
    batten_surface *patch = NULL;
    random_square(&random, points, inner);
    CHECK_EACH_ALLOCATION(batten_surface_gregory(points[0], inner[0], &patch));
    CHECK_TEXT(batten_surface_kind(patch), "gregory");
    for (int edge = 0; edge < 4; edge++) /* v = 0, v = 1, u = 0, u = 1 */
        for (int k = 0; k <= 20; k++) {
            const int high = edge % 2, along_u = edge < 2;
            const double t = k / 20.0;
            double all[3][3], wanted[3];
            for (int i = 0; i < 4; i++)
                for (int c = 0; c < 3; c++) {
                    const int here = along_u ? 4 * i + 3 * high : 12 * high + i;
                    const int next = along_u ? 4 * i + 1 + high : 4 * (1 + high) + i;
                    const int seen =
                        along_u ? 4 * (i - 1) + 2 * high : 4 * high + 2 * (i - 1) + 1;
                    const double to = i == 0 || i == 3 ? points[next][c] : inner[seen][c];
                    row[i][c] = 3 * (high ? points[here][c] - to : to - points[here][c]);
                }
            bezier(3, (const double(*)[3])row, t, wanted);
            CHECK_OK(batten_surface_evaluate(patch, along_u ? t : high, along_u ? high : t, 1,
                                             all[0]));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(all[along_u ? 2 : 1][c], wanted[c], 1e-13);
        }
    batten_surface_unref(patch);
}

TEST(equal_inner_points_make_the_bicubic_bezier_surface)
{
    test_random random = test_random_begin("gregory bicubic");
    static const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    const batten_axis axis = {3, 4, knots, false};
    double points[16][3], inner[8][3];
    batten_surface *patch = NULL, *plain = NULL, *spline = NULL;
    random_square(&random, points, inner);
    for (int k = 0; k < 8; k++)
        memcpy(inner[k], points[4 * (1 + k / 4) + 1 + k / 2 % 2], sizeof inner[k]);
    CHECK_EACH_ALLOCATION(batten_surface_gregory(points[0], inner[0], &patch));
    CHECK_OK(batten_surface_create(3, &axis, &axis, points[0], NULL, &plain));
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 8; j++) {
            double a[30], b[30];
            CHECK_OK(batten_surface_evaluate(patch, i / 8.0, j / 8.0, 3, a));
            CHECK_OK(batten_surface_evaluate(plain, i / 8.0, j / 8.0, 3, b));
            for (int k = 0; k < 30; k++)
                CHECK_NEAR(a[k], b[k], 1e-11);
        }
    double error = 0;
    CHECK_OK(batten_surface_to_nurbs(patch, 1e-6, &error, &spline));
    CHECK(error <= 1e-6);
    batten_surface_unref(spline);
    batten_surface_unref(plain);
    batten_surface_unref(patch);
}

TEST(gregory_patches_are_finite_everywhere)
{
    static const double at[] = {0, 1e-300, 1e-15, 1e-9, 0.5, 1 - 1e-15, 1};
    test_random random = test_random_begin("gregory finite");
    double points[16][3], inner[8][3];
    batten_surface *surfaces[2] = {NULL};
    random_square(&random, points, inner);
    CHECK_OK(batten_surface_gregory(points[0], inner[0], &surfaces[0]));
    memcpy(points[5], points[4], sizeof points[5]);
    memcpy(points[10], points[9], sizeof points[10]);
    memcpy(points[14], points[0], sizeof points[14]);
    CHECK_EACH_ALLOCATION(batten_surface_gregory_triangle(points[0], inner[0], &surfaces[1]));
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < COUNT(at); i++)
            for (int j = 0; j < COUNT(at); j++) {
                double all[30];
                CHECK_OK(batten_surface_evaluate(surfaces[s], at[i], at[j], 3, all));
                for (int k = 0; k < 18; k++) /* up to second derivatives they are bounded */
                    CHECK(fabs(all[k]) < 1e4);
                for (int k = 18; k < 30; k++)
                    CHECK(isfinite(all[k]));
            }
    batten_surface_unref(surfaces[0]);
    batten_surface_unref(surfaces[1]);
}

/* ---- patches that know nothing of each other ---- */

/* A cubic from corner to corner, its tangents in the planes across the corners' directions. */
static batten_curve *arc(const double a[3], const double b[3])
{
    static const double ends[2] = {0, 1};
    double P[4][3];
    batten_curve *curve = NULL;
    for (int c = 0; c < 3; c++) {
        P[0][c] = a[c];
        P[3][c] = b[c];
    }
    for (int end = 0; end < 2; end++) {
        const double *here = end == 0 ? a : b, *there = end == 0 ? b : a;
        double up = 0, size = 0;
        for (int c = 0; c < 3; c++) {
            up += here[c] * (there[c] - here[c]);
            size += here[c] * here[c];
        }
        for (int c = 0; c < 3; c++)
            P[1 + end][c] = here[c] + 0.4 * (there[c] - here[c] - up / size * here[c]);
    }
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){3, 1, ends}, P[0], NULL, &curve));
    return curve;
}

/* A point and the normal of a patch at the end of its parameter range. */
static void normal_at(const batten_surface *patch, double u, double v, double point[3],
                      double normal[3])
{
    double all[3][3];
    CHECK_OK(batten_surface_evaluate(patch, u, v, 1, all[0]));
    memcpy(point, all[0], sizeof all[0]);
    cross(all[1], all[2], normal);
}

TEST(gregory_patches_made_alone_join_smoothly)
{
    /* a prism: two triangles and three squares, every edge shared by two faces */
    double corners[6][3];
    for (int i = 0; i < 6; i++) {
        const double angle = 2 * 3.14159265358979323846 * (i % 3) / 3 + 0.1 * i;
        corners[i][0] = cos(angle);
        corners[i][1] = 1.2 * sin(angle);
        corners[i][2] = i < 3 ? -0.7 : 0.9;
    }
    static const int pairs[9][2] = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5},
                                    {5, 3}, {0, 3}, {1, 4}, {2, 5}};
    static const int faces[5][4] = {
        {0, 1, 2, -1}, {3, 4, 5, -1}, {0, 7, 3, 6}, {1, 8, 4, 7}, {2, 6, 5, 8}};
    batten_curve *edges[9] = {NULL};
    batten_surface *patches[5] = {NULL};
    for (int e = 0; e < 9; e++)
        edges[e] = arc(corners[pairs[e][0]], corners[pairs[e][1]]);
    for (int f = 0; f < 5; f++) {
        const batten_curve *sides[4];
        const int count = faces[f][3] < 0 ? 3 : 4;
        for (int k = 0; k < count; k++)
            sides[k] = edges[faces[f][k]];
        CHECK_EACH_ALLOCATION(
            batten_surface_gregory_between(count, sides, 1e-9, NULL, &patches[f]));
    }
    int compared = 0;
    for (int f = 0; f < 5; f++)
        for (int g = f + 1; g < 5; g++)
            for (int k = 0; k < 3 * 4 * 41; k++) {
                /* edges of both: of a triangle v = 0, u = 1, v = 1 */
                const double t = (k % 41) / 40.0;
                const int e = k / 41;
                static const int which[4] = {0, 1, 2, 3};
                if (e >= 4)
                    break;
                const double u = which[e] == 0 || which[e] == 2 ? t : e == 1;
                const double v = which[e] == 0 || which[e] == 2 ? e == 2 : t;
                double p[3], n[3], q[3], m[3];
                normal_at(patches[f], u, v, p, n);
                if (norm(n) < 1e-9)
                    continue; /* the pole */
                for (int other = 0; other < 4 * 41; other++) {
                    const double s = (other % 41) / 40.0;
                    const int h = other / 41;
                    normal_at(patches[g], h == 0 || h == 2 ? s : h == 1,
                              h == 0 || h == 2 ? h == 2 : s, q, m);
                    const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
                    if (norm(d) > 1e-12 || norm(m) < 1e-9)
                        continue;
                    CHECK_NEAR(apart(n, m), 0, 1e-10);
                    compared++;
                }
            }
    CHECK(compared > 9 * 35);
    for (int k = 0; k < 9; k++)
        batten_curve_unref(edges[k]);
    for (int k = 0; k < 5; k++)
        batten_surface_unref(patches[k]);
}

TEST(G7_gregory_patches_of_unfit_curves_are_refused_by_name)
{
    static const double corners[4][3] = {
        {1, 1, 0.3}, {-1, 1, 0.4}, {-1, -1, 0.5}, {1, -1, 0.2}};
    batten_curve *sides[4] = {NULL};
    const batten_curve *some[4];
    batten_surface *patch = NULL;
    for (int i = 0; i < 4; i++)
        some[i] = sides[i] = arc(corners[i], corners[(i + 1) % 4]);
    CHECK_STATUS(batten_surface_gregory_between(2, some, 1e-9, NULL, &patch),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_gregory_between(3, some, 1e-9, NULL, &patch),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("is open by");
    batten_curve *raised = NULL;
    CHECK_OK(batten_curve_elevate(sides[2], 1, &raised));
    some[2] = raised;
    CHECK_STATUS(batten_surface_gregory_between(4, some, 1e-9, NULL, &patch),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("curve 3 has dimension 3, degree 4");
    double points[16][3] = {{0}}, inner[8][3] = {{0}};
    inner[3][1] = NAN;
    CHECK_STATUS(batten_surface_gregory(points[0], inner[0], &patch), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of point 20 is not finite");
    points[4][0] = 1;
    CHECK_STATUS(batten_surface_gregory_triangle(points[0], inner[0], &patch),
                 BATTEN_NOT_COMPATIBLE);
    double field[4][3];
    CHECK_STATUS(batten_gregory_field(points[0], inner[0], NULL, field[0]),
                 BATTEN_SINGULAR_HERE);
    batten_curve_unref(raised);
    for (int i = 0; i < 4; i++)
        batten_curve_unref(sides[i]);
}

TEST(N2_edges_beyond_all_numbers_are_an_overflow)
{
    static const double edge[12] = {0, 0, 0, 1e300, 0, 0, 2e300, 0, 0, 3e300, 0, 0};
    static const double across[6] = {0, 1e300, 0, 0, 1e300, 0};
    double field[12];
    CHECK_STATUS(batten_gregory_field(edge, across, NULL, field), BATTEN_OVERFLOW);
    CHECK_MESSAGE("the edge is too large");
}
