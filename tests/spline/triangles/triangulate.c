#include <batten/scattered.h>

#include "numeric/plane_signs.h"
#include "support/test.h"

static const double *at(const batten_plane_triangles *t, int triangle, int corner)
{
    return t->vertices + 2 * t->corners[3 * triangle + corner % 3];
}

/* Neighbours know each other, no neighbour's corner is inside a circle, and the triangles are
 * as many as a hull with that rim has. */
static void check_delaunay(const batten_plane_triangles *t)
{
    int rim = 0;
    for (int i = 0; i < t->count; i++) {
        CHECK_INT(bat_orientation(at(t, i, 0), at(t, i, 1), at(t, i, 2)), 1);
        for (int e = 0; e < 3; e++) {
            const int other = t->beside[3 * i + e];
            if (other < 0) {
                rim++;
                continue;
            }
            int k = 0;
            while (k < 3 &&
                   t->corners[3 * other + (k + 1) % 3] != t->corners[3 * i + (e + 2) % 3])
                k++;
            CHECK(k < 3);
            CHECK_INT(t->corners[3 * other + (k + 2) % 3], t->corners[3 * i + (e + 1) % 3]);
            CHECK_INT(t->beside[3 * other + k], i);
            CHECK(bat_in_circle(at(t, i, 0), at(t, i, 1), at(t, i, 2), at(t, other, k)) <= 0);
        }
    }
    CHECK_INT(t->count, 2 * t->vertex_count - 2 - rim);
}

static void check_points(int count, const double *points)
{
    batten_plane_triangles made;
    batten_triangulate_options options = batten_triangulate_defaults();
    options.sliver = 0;
    CHECK_OK(batten_triangulate((batten_points){2, count, points}, &options, &made));
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            CHECK(made.vertices[2 * made.vertex_of[i] + k] == points[2 * i + k]);
    CHECK_INT(made.vertex_count + made.merged, count);
    check_delaunay(&made);
    batten_plane_triangles_release(&made);
}

TEST(no_point_is_inside_the_circle_round_a_triangle)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        double points[2 * 300];
        const int count = c < 30 ? 3 + c : 300, kind = c % 6;
        for (int i = 0; i < count; i++) {
            const double x = test_random_in(&random, -1, 1), y = test_random_in(&random, -1, 1);
            const double scale = kind == 1 ? ldexp(1, test_random_int(&random, -150, 0)) : 1;
            points[2 * i] = kind == 2 ? floor(8 * x) : kind == 3 ? 0.1 * i : scale * x;
            points[2 * i + 1] = kind == 2 ? floor(8 * y) : kind == 3 ? 0.3 * i : scale * y;
            if (kind == 4) { /* all on one circle, but for rounding */
                points[2 * i] = 1e3 + cos(i);
                points[2 * i + 1] = sin(i);
            }
            if (kind == 5) /* clusters far from each other */
                points[2 * i] = floor(3 * x) + 1e-12 * y;
        }
        if (kind == 3)
            points[1] = 1;
        check_points(count, points);
    }
}

TEST(grids_of_decimal_steps_are_triangulated)
{
    double points[2 * 400];
    for (int i = 0; i < 400; i++) {
        points[2 * i] = 0.1 * (i % 20);
        points[2 * i + 1] = 1e6 + 0.1 * (i / 20);
    }
    check_points(400, points);
}

TEST(N2_tiny_and_huge_coordinates_are_triangulated_alike)
{
    test_random random = test_random_begin(__func__);
    double points[2 * 50], scaled[2 * 50];
    for (int i = 0; i < 100; i++)
        points[i] = test_random_in(&random, -1, 1);
    const int exponents[] = {-1000, -300, 300, 1020};
    batten_plane_triangles made, other;
    CHECK_OK(batten_triangulate((batten_points){2, 50, points}, NULL, &made));
    for (int c = 0; c < COUNT(exponents); c++) {
        for (int i = 0; i < 100; i++)
            scaled[i] = ldexp(points[i], exponents[c]);
        CHECK_OK(batten_triangulate((batten_points){2, 50, scaled}, NULL, &other));
        CHECK_INT(other.count, made.count);
        CHECK(!memcmp(other.corners, made.corners, 3 * (size_t)made.count * sizeof(int)));
        batten_plane_triangles_release(&other);
    }
    batten_plane_triangles_release(&made);
}

TEST(G1_points_within_the_tolerance_are_one_vertex)
{
    const double points[] = {0, 0, 1, 0, 0, 1, 1e-3, 0, 1, 1, 0, -1e-3, -0.0, 1, 1, 1};
    batten_triangulate_options options = batten_triangulate_defaults();
    batten_plane_triangles made;
    CHECK_OK(batten_triangulate((batten_points){2, 8, points}, &options, &made));
    CHECK_INT(made.vertex_count, 6);
    CHECK_INT(made.merged, 2);
    batten_plane_triangles_release(&made);
    options.tolerance = 2e-3;
    CHECK_OK(batten_triangulate((batten_points){2, 8, points}, &options, &made));
    CHECK_INT(made.vertex_count, 4);
    CHECK_INT(made.merged, 4);
    CHECK_INT(made.count, 2);
    CHECK_INT(made.vertex_of[3], 0);
    CHECK_INT(made.vertex_of[5], 0);
    CHECK_INT(made.first[3], 4);
    batten_plane_triangles_release(&made);
}

TEST(G2_points_on_one_line_or_too_few_are_refused)
{
    const double line[] = {0, 0, 1, 1, 2, 2, 5, 5}, same[] = {1, 2, 1, 2, 1, 2, 3, 3};
    batten_plane_triangles made;
    CHECK_STATUS(batten_triangulate((batten_points){2, 4, line}, NULL, &made),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("on one line");
    CHECK_STATUS(batten_triangulate((batten_points){2, 4, same}, NULL, &made),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("only 2 of 4 points differ");
    CHECK_STATUS(batten_triangulate((batten_points){2, 2, line}, NULL, &made),
                 BATTEN_TOO_FEW_POINTS);
}

TEST(N1_a_coordinate_that_is_no_number_is_refused)
{
    const double points[] = {0, 0, 1, 0, 0, NAN};
    batten_plane_triangles made;
    batten_triangulate_options options = batten_triangulate_defaults();
    CHECK_STATUS(batten_triangulate((batten_points){2, 3, points}, NULL, &made),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 3");
    options.tolerance = -1;
    CHECK_STATUS(batten_triangulate((batten_points){2, 2 + 1, points + 0}, &options, &made),
                 BATTEN_NOT_FINITE);
    const double good[] = {0, 0, 1, 0, 0, 1};
    CHECK_STATUS(batten_triangulate((batten_points){2, 3, good}, &options, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_triangulate((batten_points){2, 2000000000, good}, NULL, &made),
                 BATTEN_TOO_LARGE);
}

TEST(slivers_on_the_rim_are_left_out_and_no_vertex_with_them)
{
    /* a side of five points that bends inwards by a millionth */
    const double points[] = {0, 0, 1, 1e-6, 2, 2e-6, 3, 1e-6, 4, 0, 2, 3, 1, 1.4};
    batten_triangulate_options options = batten_triangulate_defaults();
    batten_plane_triangles made;
    CHECK_OK(batten_triangulate((batten_points){2, 7, points}, &options, &made));
    CHECK_INT(made.slivers, 0);
    const int all = made.count;
    batten_plane_triangles_release(&made);
    options.sliver = 1e-3;
    CHECK_OK(batten_triangulate((batten_points){2, 7, points}, &options, &made));
    CHECK_INT(made.slivers, 3);
    CHECK_INT(made.count, all - 3);
    bool used[7] = {false};
    for (int i = 0; i < 3 * made.count; i++)
        used[made.corners[i]] = true;
    for (int i = 0; i < 7; i++)
        CHECK(used[i]);
    check_delaunay(&made);
    batten_plane_triangles_release(&made);
}

TEST(walking_finds_every_place_in_the_hull_and_none_outside)
{
    test_random random = test_random_begin(__func__);
    double points[2 * 200];
    for (int i = 0; i < 400; i++)
        points[i] = test_random_in(&random, 0, 1);
    batten_plane_triangles made;
    CHECK_OK(batten_triangulate((batten_points){2, 200, points}, NULL, &made));
    int found = 0;
    for (int c = 0; c < 400; c++) {
        const double p[2] = {test_random_in(&random, 0, 1), test_random_in(&random, 0, 1)};
        double b[3];
        const int t = batten_plane_triangles_find(
            &made, test_random_int(&random, 0, made.count - 1), (batten_vec2){p[0], p[1]}, b);
        if (t < 0)
            continue;
        found++;
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(b[0] * at(&made, t, 0)[k] + b[1] * at(&made, t, 1)[k] +
                           b[2] * at(&made, t, 2)[k],
                       p[k], 1e-13);
        CHECK(b[0] >= -1e-12 && b[1] >= -1e-12 && b[2] >= -1e-12);
    }
    CHECK(found > 340);
    double b[3];
    const double outside[2] = {2, 0.5}, nowhere[2] = {NAN, 0};
    CHECK_INT(batten_plane_triangles_find(&made, 0, (batten_vec2){outside[0], outside[1]}, b),
              -1);
    CHECK_INT(batten_plane_triangles_find(&made, 0, (batten_vec2){nowhere[0], nowhere[1]}, b),
              -1);
    batten_plane_triangles_release(&made);
}

TEST(options_of_triangulations_are_checked_and_points_lie_in_the_plane)
{
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    batten_plane_triangles made;
    batten_triangulate_options options = batten_triangulate_defaults();
    CHECK_STATUS(batten_triangulate((batten_points){3, 3, points}, NULL, &made),
                 BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_triangulate((batten_points){2, 1, points}, NULL, &made),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("there is 1 point");
    options.tolerance = INFINITY;
    CHECK_STATUS(batten_triangulate((batten_points){2, 3, points}, &options, &made),
                 BATTEN_BAD_ARGUMENT);
    options = batten_triangulate_defaults();
    for (int i = 0; i < 3; i++) {
        options.sliver = i == 0 ? -0.1 : i == 1 ? 0.5 : NAN;
        CHECK_STATUS(batten_triangulate((batten_points){2, 3, points}, &options, &made),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("it must be in [0, 0.5)");
    }
    const double origin[8] = {0};
    CHECK_STATUS(batten_triangulate((batten_points){2, 4, origin}, NULL, &made),
                 BATTEN_COINCIDENT);
}
