#include <batten/triangles.h>

#include "support/test.h"
#include "support/triangles.h"

static const double vertices[] = {0, 0, 2, 0, 2, 1.5, -0.5, 1};
static const int corners[] = {0, 1, 2, 3, 0, 2};
static const batten_triangulation square = {4, vertices, corners};

static batten_triangle_join only_join(const batten_triangles *triangles)
{
    batten_triangle_joins joins = {0, NULL};
    batten_triangle_join join = {{0}, {0}, false, 0, 0, 0, 0};
    CHECK_OK(batten_triangles_joins(triangles, 1e-9, &joins));
    if (joins.count == 1)
        join = joins.at[0];
    CHECK_INT(joins.count, 1);
    batten_triangle_joins_release(&joins);
    return join;
}

TEST(parts_of_one_polynomial_meet_with_equal_slopes)
{
    batten_triangles *triangles = NULL, *graph = NULL;
    CHECK_OK(example_triangles(2, &square, &triangles));
    const batten_triangle_join join = only_join(triangles);
    CHECK(join.triangle[0] == 0 && join.edge[0] == 1 && join.triangle[1] == 1 &&
          join.edge[1] == 0 && !join.same_way);
    CHECK_NEAR(join.gap, 0, 1e-15);
    CHECK_NEAR(join.slope, 0, 1e-14);
    CHECK(join.angle == -1 && join.coplanarity == -1);
    CHECK_OK(batten_triangles_from_function(triangles, &graph));
    const batten_triangle_join smooth = only_join(graph);
    CHECK_NEAR(smooth.slope, 0, 1e-14);
    CHECK_NEAR(smooth.angle, 0, 1e-14);
    CHECK_NEAR(smooth.coplanarity, 0, 1e-15);
    batten_triangles_unref(triangles);
    batten_triangles_unref(graph);
}

TEST(a_fold_between_two_planes_has_its_angle)
{
    /* Two triangles of a roof of 90 degrees; the second is given the same way round the edge,
     * so that its own normal looks the other way. */
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    batten_triangles *triangles = NULL;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 1, 2, points, NULL, NULL},
                                     &triangles));
    const batten_triangle_join join = only_join(triangles);
    CHECK(join.edge[0] == 2 && join.edge[1] == 2 && join.same_way);
    CHECK_NEAR(join.gap, 0, 0);
    CHECK_NEAR(join.slope, -1, 0);
    CHECK_NEAR(join.angle, acos(0.0), 1e-15);
    CHECK_NEAR(join.coplanarity, sqrt(1.0), 1e-15);
    batten_triangles_unref(triangles);
}

TEST(derivatives_made_equal_are_equal_and_the_rest_stays)
{
    test_random random = test_random_begin(__func__);
    for (int order = 0; order <= 4; order++) {
        batten_triangles *triangles = NULL, *joined = NULL;
        double moved = -1;
        CHECK_OK(random_triangles(&random, 3, 4, 2, false, &square, &triangles));
        CHECK_OK(batten_triangles_join_smoothly(triangles, 0, 1, order, &moved, &joined));
        const batten_triangle_join join = only_join(joined);
        CHECK_NEAR(join.gap, 0, 1e-14);
        if (order > 0)
            CHECK_NEAR(join.slope, 0, 1e-13);
        if (order > 0)
            CHECK_NEAR(join.angle, 0, 1e-11);
        CHECK(moved > 0);
        /* What is 4 - order rows from the edge is as it was: corner 0 of triangle 1. */
        const double *before = batten_triangles_points(triangles) + 15 * 3;
        const double *after = batten_triangles_points(joined) + 15 * 3;
        CHECK((memcmp(before, after, 3 * sizeof *before) == 0) == (order < 4));
        batten_triangles_unref(triangles);
        batten_triangles_unref(joined);
    }
}

/* Two quartics that share an edge, and are coplanar at its ends where `flat`. */
static batten_status two_quartics(test_random *random, bool flat, batten_triangles **out)
{
    double points[2 * 15 * 3];
    const double corner[4][3] = {{0, 0, 0}, {2, 0, 0.5}, {2, 1.5, 0}, {-0.5, 1, -0.3}};
    double *to = points;
    for (int t = 0; t < 2; t++)
        for (int row = 0; row <= 4; row++)
            for (int k = 0; k <= row; k++)
                for (int c = 0; c < 3; c++) {
                    const int *of = corners + 3 * t;
                    const double bend = c == 2 ? 0.5 : 0.1;
                    *to++ = ((4 - row) * corner[of[0]][c] + (row - k) * corner[of[1]][c] +
                             k * corner[of[2]][c]) /
                                4 +
                            test_random_in(random, -bend, bend);
                }
    /* edge 1 of the first: (2, 0): points (j, k) = (0, s); edge 0 of the second, 0 to 2. */
    for (int s = 0; s <= 4; s++)
        memcpy(points + 45 + 3 * BATTEN_TRIANGLE_POINT(4 - s, s),
               points + 3 * BATTEN_TRIANGLE_POINT(0, s), 3 * sizeof *points);
    for (int end = 0; flat && end < 2; end++) {
        const double *here = points + 3 * BATTEN_TRIANGLE_POINT(0, end ? 4 : 0);
        const double *next = points + 3 * BATTEN_TRIANGLE_POINT(0, end ? 3 : 1);
        const double *inner = points + 3 * BATTEN_TRIANGLE_POINT(1, end ? 3 : 0);
        double *change = points + 45 + 3 * BATTEN_TRIANGLE_POINT(end ? 0 : 3, end ? 3 : 0);
        for (int c = 0; c < 3; c++)
            change[c] = here[c] - 0.8 * (inner[c] - here[c]) + 0.3 * (next[c] - here[c]);
    }
    return batten_triangles_create(&(batten_triangles_parts){3, 4, 2, points, NULL, NULL}, out);
}

TEST(tangent_planes_made_equal_agree_along_the_whole_edge)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(10); c++) {
        batten_triangles *rough = NULL, *smooth = NULL, *elevated = NULL;
        double moved = 0;
        CHECK_OK(two_quartics(&random, true, &rough));
        const batten_triangle_join before = only_join(rough);
        CHECK(before.angle > 1e-3 && before.coplanarity > 1e-3);
        CHECK_OK(batten_triangles_join_tangents(rough, (batten_triangle_edge){0, 1},
                                                (batten_triangle_edge){1, 0}, 1e-12, &moved,
                                                &smooth));
        const batten_triangle_join after = only_join(smooth);
        CHECK_NEAR(after.gap, 0, 1e-15);
        CHECK_NEAR(after.angle, 0, 1e-12);
        CHECK_NEAR(after.coplanarity, 0, 1e-13);
        CHECK(moved > 0);
        /* The corners' tangents lay in common planes: they stay. */
        CHECK_OK(batten_triangles_elevate(rough, 1, &elevated));
        const int ends[2] = {BATTEN_TRIANGLE_POINT(4, 0), BATTEN_TRIANGLE_POINT(0, 4)};
        for (int end = 0; end < 2; end++)
            for (int x = 0; x < 3; x++)
                CHECK_NEAR(batten_triangles_points(smooth)[3 * (21 + ends[end]) + x],
                           batten_triangles_points(elevated)[3 * (21 + ends[end]) + x], 1e-13);
        batten_triangles_unref(rough);
        batten_triangles_unref(smooth);
        batten_triangles_unref(elevated);
    }
}

TEST(joints_that_cannot_be_are_refused)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *triangles = NULL, *none = NULL;
    CHECK_OK(two_quartics(&random, false, &triangles));
    CHECK_STATUS(batten_triangles_join_tangents(triangles, (batten_triangle_edge){0, 0},
                                                (batten_triangle_edge){1, 0}, 1e-12, NULL,
                                                &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("edge 1 of triangle 1 and edge 1 of triangle 2");
    CHECK_STATUS(batten_triangles_join_smoothly(triangles, 0, 1, 1, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    batten_triangles_unref(triangles);
    /* The second lies over the first. */
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.1, 0.1, 0, 1, 0, 0, 0, 1, 0};
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 1, 2, points, NULL, NULL},
                                     &triangles));
    CHECK_STATUS(batten_triangles_join_tangents(triangles, (batten_triangle_edge){0, 0},
                                                (batten_triangle_edge){1, 0}, 1e-12, NULL,
                                                &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("folds back");
    batten_triangle_joins joins = {0, NULL};
    CHECK_STATUS(batten_triangles_joins(triangles, 0, &joins), BATTEN_BAD_ARGUMENT);
    CHECK(!none && !joins.at);
    batten_triangles_unref(triangles);
}

TEST(rational_triangles_of_one_surface_are_coplanar_along_their_edges)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *whole = NULL, *parts = NULL;
    batten_triangle_joins joins = {0, NULL};
    CHECK_OK(random_triangles(&random, 3, 4, 1, true, NULL, &whole));
    CHECK_OK(batten_triangles_halve(whole, &parts));
    CHECK_OK(batten_triangles_joins(parts, 1e-9, &joins));
    CHECK_INT(joins.count, 3);
    for (int i = 0; i < joins.count; i++) {
        CHECK_NEAR(joins.at[i].gap, 0, 1e-14);
        CHECK_NEAR(joins.at[i].coplanarity, 0, 1e-12);
        CHECK_NEAR(joins.at[i].angle, 0, 1e-9);
        CHECK(joins.at[i].triangle[1] == 3 && !joins.at[i].same_way);
    }
    batten_triangle_joins_release(&joins);
    batten_triangles_unref(whole);
    batten_triangles_unref(parts);
}

/* A flat grid: along x or y alone half a million pairs of corners would have to be compared. */
TEST(S3_the_joints_of_a_grid_are_found_in_good_time)
{
    enum { SIDE = 60 };
    double *points = test_array(SIDE * SIDE * 2 * 9, sizeof *points), *to = points;
    static const int at[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    for (int cell = 0; cell < SIDE * SIDE; cell++)
        for (int k = 0; k < 6; k++, to += 3) {
            to[1] = (cell / SIDE + at[k][0]) / 8.0;
            to[2] = (cell % SIDE + at[k][1]) / 8.0;
        }
    batten_triangles *triangles = NULL;
    batten_triangle_joins joins = {0, NULL};
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){3, 1, SIDE * SIDE * 2, points, NULL, NULL}, &triangles));
    CHECK_OK(batten_triangles_joins(triangles, 1e-9, &joins));
    CHECK_INT(joins.count, SIDE * SIDE + 2 * SIDE * (SIDE - 1));
    for (int i = 0; i < joins.count; i++)
        CHECK(joins.at[i].gap == 0 && joins.at[i].angle < 1e-14 && !joins.at[i].same_way);
    batten_triangle_joins_release(&joins);
    batten_triangles_unref(triangles);
}

TEST(smooth_joins_take_polynomials_over_a_domain_that_share_an_edge)
{
    /* Two triangles of a square, and a third that touches the first at a corner alone. */
    const double plane[] = {0, 0, 1, 0, 0, 1, 1, 1, -1, 0, -1, -1};
    const int order[] = {0, 1, 2, 3, 2, 1, 0, 4, 5};
    const batten_triangulation domain = {6, plane, order};
    const double values[9] = {0, 0, 0, 1, 0, 0, 0, 0, 0},
                 weights[9] = {1, 1, 1, 1, 2, 1, 1, 1, 1};
    batten_triangles *set = NULL, *rational = NULL, *made = NULL;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){1, 1, 3, values, NULL, &domain},
                                     &set));
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){1, 1, 3, values, weights, &domain}, &rational));
    CHECK_STATUS(batten_triangles_join_smoothly(rational, 0, 1, 1, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_triangles_join_smoothly(set, 0, 1, -1, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_triangles_join_smoothly(set, 0, 1, 2, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("order 2 is not in 0..1");
    CHECK_STATUS(batten_triangles_join_smoothly(set, 1, 1, 1, NULL, &made),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_triangles_join_smoothly(set, 0, 2, 1, NULL, &made),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("triangles 1 and 3 share no edge");
    CHECK(!made);
    /* All values of the first are 0, and so becomes the far corner of the second. */
    CHECK_OK(batten_triangles_join_smoothly(set, 0, 1, 1, NULL, &made));
    CHECK_NEAR(batten_triangles_points(made)[3], 0, 0);
    batten_triangles_unref(set);
    batten_triangles_unref(rational);
    batten_triangles_unref(made);
}

TEST(tangent_planes_are_made_equal_where_there_are_some)
{
    /* The first triangle's inner point lies on its edge's end: no plane there. */
    const double flat[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0},
                 line[] = {2, -1, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0},
                 weights[] = {1, 2, 1, 1, 2, 1};
    const batten_triangle_edge kept = {0, 0}, changed = {1, 0};
    batten_triangles *set = NULL, *made = NULL;
    CHECK_OK(
        batten_triangles_create(&(batten_triangles_parts){3, 1, 2, flat, NULL, NULL}, &set));
    CHECK_OK(batten_triangles_join_tangents(set, kept, changed, 0, NULL, &made));
    batten_triangles_unref(made);
    made = NULL;
    CHECK_STATUS(batten_triangles_join_tangents(set, kept, kept, 0, NULL, &made),
                 BATTEN_NOT_COMPATIBLE);
    batten_triangles_unref(set);
    CHECK_OK(
        batten_triangles_create(&(batten_triangles_parts){3, 1, 2, line, NULL, NULL}, &set));
    CHECK_STATUS(batten_triangles_join_tangents(set, kept, changed, 0, NULL, &made),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("triangle 1 has no tangent plane at one end of edge 1");
    batten_triangles_unref(set);
    CHECK_OK(
        batten_triangles_create(&(batten_triangles_parts){3, 1, 2, flat, weights, NULL}, &set));
    CHECK_STATUS(batten_triangles_join_tangents(set, kept, changed, 0, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    batten_triangles_unref(set);
    CHECK_OK(
        batten_triangles_create(&(batten_triangles_parts){2, 1, 2, flat, NULL, NULL}, &set));
    CHECK_STATUS(batten_triangles_join_tangents(set, kept, changed, 9, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    batten_triangles_unref(set);
    CHECK(!made);
}
