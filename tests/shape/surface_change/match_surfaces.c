#include <batten/continuity.h>
#include <batten/standard.h>

#include "support/faults.h"
#include "support/test.h"

#include <string.h>

/* A wavy bicubic over [0, 1] x [0, 1] of the parameters, its x from `x0` to `x0 + 2`. */
static batten_surface *wavy(double x0, double phase, int count_v)
{
    double points[6 * 9 * 3];
    batten_surface *surface = NULL;
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < count_v; j++) {
            double *p = points + (i * count_v + j) * 3;
            p[0] = x0 + 0.4 * i;
            p[1] = 3.0 * j / (count_v - 1) + 0.05 * sin(phase + i);
            p[2] = 0.3 * sin(phase + 0.8 * p[0] + 1.3 * p[1]);
        }
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 6, count_v, points}, NULL, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &surface));
    return surface;
}

static void check_match(const batten_surface *first, batten_edge e1,
                        const batten_surface *second, batten_edge e2, int order, bool reversed)
{
    batten_surface *made = NULL;
    batten_surface_match_report report;
    CHECK_EACH_ALLOCATION(batten_surface_match((batten_surface_edge){first, e1},
                                               (batten_surface_edge){second, e2}, order, 1e-9,
                                               &report, &made));
    CHECK(report.reversed == reversed);
    CHECK(report.moved > 0 && report.moved < 1);
    CHECK_NEAR(report.gap, 0, 1e-14);
    if (order > 0)
        CHECK_NEAR(report.angle, 0, 1e-13);
    else
        CHECK(report.angle > 0.01);
    if (order > 1)
        CHECK_NEAR(report.curvature, 0, 1e-11);
    else
        CHECK(report.curvature > 0.01);
    for (int k = 0; k < 2; k++)
        CHECK_NEAR(batten_surface_domain(made, (batten_direction)k).b, 1, 0);
    /* The opposite edge has not moved. */
    const bool along_u = e1 == BATTEN_EDGE_V0 || e1 == BATTEN_EDGE_V1;
    const double far = e1 == BATTEN_EDGE_V0 || e1 == BATTEN_EDGE_U0 ? 1 : 0;
    for (int i = 0; i <= 10; i++) {
        double p[3], q[3];
        const double t = i / 10.0;
        CHECK_OK(batten_surface_evaluate(first, along_u ? t : far, along_u ? far : t, 0, p));
        CHECK_OK(batten_surface_evaluate(made, along_u ? t : far, along_u ? far : t, 0, q));
        for (int x = 0; x < 3; x++)
            CHECK_NEAR(p[x], q[x], 1e-14);
    }
    batten_surface_unref(made);
}

TEST(a_surface_joins_another_with_tangent_plane_and_curvature)
{
    batten_surface *left = wavy(0, 0, 5), *right = wavy(2.1, 0.4, 7);
    for (int order = 0; order <= 2; order++) {
        check_match(right, BATTEN_EDGE_U0, left, BATTEN_EDGE_U1, order, false);
        check_match(left, BATTEN_EDGE_U1, right, BATTEN_EDGE_U0, order, false);
    }
    batten_surface_unref(left);
    batten_surface_unref(right);
}

TEST(edges_of_any_kind_and_direction_are_matched)
{
    batten_surface *left = wavy(0, 0, 5), *right = wavy(2.1, 0.4, 7), *turned = NULL,
                   *reversed = NULL;
    CHECK_OK(batten_surface_swap(right, &turned));
    CHECK_OK(batten_surface_reverse(turned, BATTEN_U, &reversed));
    batten_surface *unit = NULL;
    CHECK_OK(batten_surface_set_domain(reversed, BATTEN_U, 0, 1, &unit));
    batten_edge e1 = BATTEN_EDGE_V1, e2 = BATTEN_EDGE_V1;
    double apart = 0;
    CHECK_EACH_ALLOCATION(batten_surfaces_near_edges(unit, left, &e1, &e2, &apart));
    CHECK_INT(e1, BATTEN_EDGE_V0);
    CHECK_INT(e2, BATTEN_EDGE_U1);
    CHECK(apart > 0.01 && apart < 0.5);
    check_match(unit, e1, left, e2, 2, true);
    check_match(left, e2, unit, e1, 2, true);
    batten_surface_unref(left);
    batten_surface_unref(right);
    batten_surface_unref(turned);
    batten_surface_unref(reversed);
    batten_surface_unref(unit);
}

/* What joins already does not move: a part of a surface and the rest of it. */
TEST(a_surface_that_is_cut_and_matched_again_stays)
{
    batten_surface *whole = wavy(0, 0, 6), *low = NULL, *high = NULL, *made = NULL;
    batten_surface_match_report report;
    CHECK_OK(batten_surface_split(whole, BATTEN_U, 0.45, &low, &high));
    CHECK_EACH_ALLOCATION(batten_surface_match((batten_surface_edge){high, BATTEN_EDGE_U0},
                                               (batten_surface_edge){low, BATTEN_EDGE_U1}, 2,
                                               1e-9, &report, &made));
    CHECK_NEAR(report.moved, 0, 1e-13);
    batten_surface_unref(whole);
    batten_surface_unref(low);
    batten_surface_unref(high);
    batten_surface_unref(made);
}

/* The edge of a cylinder is rational: it is met within the tolerance, and said how well. */
TEST(a_rational_edge_is_met_within_the_tolerance)
{
    double points[5 * 4 * 3];
    batten_surface *flange = NULL, *tube = NULL, *quarter = NULL, *made = NULL;
    const batten_frame frame = {.origin = {0, 0, 0}, .x = {1, 0, 0}, .z = {0, 0, 1}};
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 4; j++) {
            const double a = 1.5707963267948966 * i / 4, r = 1 + 0.1 * j * j;
            double *p = points + (i * 4 + j) * 3;
            p[0] = r * cos(a);
            p[1] = r * sin(a);
            p[2] = 2.05 + 0.3 * j;
        }
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 5, 4, points}, NULL, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &flange));
    CHECK_OK(batten_surface_cylinder(&frame, 1, 2, &tube));
    CHECK_OK(batten_surface_subrange(tube, BATTEN_U, 0, 0.25, &quarter));
    for (double tolerance = 1e-3; tolerance > 1e-9; tolerance *= 1e-2) {
        batten_surface_match_report report;
        CHECK_OK(batten_surface_match((batten_surface_edge){flange, BATTEN_EDGE_V0},
                                      (batten_surface_edge){quarter, BATTEN_EDGE_V1}, 1,
                                      tolerance, &report, &made));
        CHECK(report.gap <= tolerance && report.angle <= 100 * tolerance);
        batten_surface_unref(made);
    }
    batten_surface_unref(flange);
    batten_surface_unref(tube);
    batten_surface_unref(quarter);
}

/* Two tubes, closed along the edge where they meet, one running round the other way. */
TEST(closed_edges_that_run_against_each_other_are_seen)
{
    double points[8 * 4 * 3];
    batten_surface *tubes[2] = {NULL}, *made = NULL;
    for (int t = 0; t < 2; t++) {
        for (int i = 0; i < 8; i++)
            for (int j = 0; j < 4; j++) {
                const double a = 6.283185307179586 * i / 8 * (t ? -1 : 1);
                double *p = points + (i * 4 + j) * 3;
                p[0] = (1 + 0.1 * j) * cos(a);
                p[1] = (1 + 0.1 * j) * sin(a);
                p[2] = t ? 0.05 + j : -j;
            }
        batten_surface_interpolate_options o = batten_surface_interpolate_defaults();
        o.closed_u = true;
        CHECK_OK(batten_surface_interpolate((batten_grid){3, 8, 4, points}, &o, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &tubes[t]));
    }
    batten_surface_match_report report;
    CHECK_OK(batten_surface_match((batten_surface_edge){tubes[1], BATTEN_EDGE_V0},
                                  (batten_surface_edge){tubes[0], BATTEN_EDGE_V0}, 1, 1e-9,
                                  &report, &made));
    CHECK(report.reversed && report.moved < 0.3);
    CHECK(report.gap < 1e-12 && report.angle < 1e-10);
    batten_surface_unref(made);
    batten_surface_unref(tubes[0]);
    batten_surface_unref(tubes[1]);
}

TEST(what_cannot_be_matched_is_refused)
{
    batten_surface *left = wavy(0, 0, 5), *ball = NULL, *made = NULL, *linear = NULL;
    CHECK_OK(batten_surface_sphere(&(batten_frame){.z = {0, 0, 1}, .x = {1, 0, 0}}, 1, &ball));
    CHECK_STATUS(batten_surface_match((batten_surface_edge){ball, BATTEN_EDGE_U0},
                                      (batten_surface_edge){left, BATTEN_EDGE_U1}, 1, 1e-9,
                                      NULL, &made),
                 BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_surface_match((batten_surface_edge){left, BATTEN_EDGE_U0},
                                      (batten_surface_edge){ball, BATTEN_EDGE_V0}, 1, 1e-9,
                                      NULL, &made),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_surface_match((batten_surface_edge){left, BATTEN_EDGE_U0},
                                      (batten_surface_edge){left, BATTEN_EDGE_U1}, 3, 1e-9,
                                      NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    const double corners[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0};
    const double knots[4] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    CHECK_OK(batten_surface_create(3, &axis, &axis, corners, NULL, &linear));
    CHECK_STATUS(batten_surface_match((batten_surface_edge){linear, BATTEN_EDGE_U0},
                                      (batten_surface_edge){left, BATTEN_EDGE_U1}, 2, 1e-9,
                                      NULL, &made),
                 BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_surface_match((batten_surface_edge){linear, BATTEN_EDGE_U0},
                                      (batten_surface_edge){left, BATTEN_EDGE_U1}, 1, 1e-9,
                                      NULL, &made),
                 BATTEN_TOO_FEW_POINTS);
    batten_surface_unref(left);
    batten_surface_unref(ball);
    batten_surface_unref(linear);
}

TEST(what_cannot_be_matched_is_named_with_its_numbers)
{
    const double corners[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, z[4] = {0, 1, 2, 3};
    const double knots[4] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    const batten_frame world = {.z = {0, 0, 1}, .x = {1, 0, 0}};
    batten_surface *left = wavy(0, 0, 5), *ball = NULL, *linear = NULL, *function = NULL;
    CHECK_OK(batten_surface_sphere(&world, 1, &ball));
    CHECK_OK(batten_surface_create(3, &axis, &axis, corners, NULL, &linear));
    CHECK_OK(batten_surface_create(1, &axis, &axis, z, NULL, &function));
    const struct {
        const batten_surface *first, *second;
        int order;
        batten_status status;
        const char *message;
    } rows[] = {
        {ball, left, 1, BATTEN_UNSUPPORTED,
         "the surface that moves must be a B-spline surface without weights"},
        {left, left, -1, BATTEN_BAD_ARGUMENT, "the order is -1; it must be 0, 1 or 2"},
        {left, left, 3, BATTEN_BAD_ARGUMENT, "the order is 3; it must be 0, 1 or 2"},
        {left, function, 1, BATTEN_NOT_COMPATIBLE, "the surfaces have the dimensions 3 and 1"},
        {function, left, 1, BATTEN_NOT_COMPATIBLE, "the surfaces have the dimensions 1 and 3"},
        {linear, left, 2, BATTEN_BAD_DEGREE,
         "the degree across the edge is 1; to join with order 2 it must be 2"},
        {linear, left, 1, BATTEN_TOO_FEW_POINTS,
         "2 rows of control points across the edge; 2 would move and the opposite edge must stay"},
    };
    batten_surface *made = NULL;
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(batten_surface_match((batten_surface_edge){rows[i].first, BATTEN_EDGE_U0},
                                          (batten_surface_edge){rows[i].second, BATTEN_EDGE_U1},
                                          rows[i].order, 1e-9, NULL, &made),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].message);
    }
    CHECK(!made);
    batten_surface_unref(left);
    batten_surface_unref(ball);
    batten_surface_unref(linear);
    batten_surface_unref(function);
}

/* (x, y, 0) for x in [0, 1] of degree 2, and a square from (1.5, 0, 0.2) on along x, whose y may run back. */
static batten_surface *plane_piece(int degree, double x, double z, bool back)
{
    const double knots[2][6] = {{0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}};
    double points[6][3];
    for (int i = 0; i <= degree; i++)
        for (int j = 0; j < 2; j++)
            memcpy(points[2 * i + j], (double[]){x + (double)i / degree, back ? 1 - j : j, z},
                   sizeof points[0]);
    const batten_axis u = {degree, degree + 1, knots[degree - 1], false},
                      v = {1, 2, knots[0], false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0], NULL, &surface));
    return surface;
}

/* The edge moves by (0.5, 0, 0.2). Of degree 1 the plane then rises by 0.2 over 1.5; of degree 2 the row beside the edge
 * moves alike, so that the section (0, 0), (1, 0.2), (1.5, 0.2) is left, which ends level with the curvature 0.4. */
TEST(the_report_of_a_match_has_the_move_the_angle_and_the_curvature)
{
    for (int i = 0; i < 4; i++) {
        const int order = i / 2;
        const bool back = i % 2;
        batten_surface *first = plane_piece(order + 1, 0, 0, false),
                       *second = plane_piece(1, 1.5, 0.2, back), *made = NULL;
        batten_surface_match_report report;
        CHECK_OK(batten_surface_match((batten_surface_edge){first, BATTEN_EDGE_U1},
                                      (batten_surface_edge){second, BATTEN_EDGE_U0}, order,
                                      1e-9, &report, &made));
        CHECK_INT(report.reversed, back);
        CHECK_NEAR(report.gap, 0, 1e-14);
        CHECK_NEAR(report.moved, hypot(0.5, 0.2), 1e-14);
        CHECK_NEAR(report.angle, order ? 0 : atan(0.2 / 1.5), 1e-13);
        CHECK_NEAR(report.curvature, order ? 0.4 : 0, 1e-13);
        double p[3];
        CHECK_OK(batten_surface_evaluate(made, 1, 0.25, 0, p));
        CHECK_NEAR(p[0], 1.5, 1e-14);
        CHECK_NEAR(p[1], 0.25, 1e-14);
        CHECK_NEAR(p[2], 0.2, 1e-14);
        batten_surface_unref(made);
        batten_surface_unref(second);
        batten_surface_unref(first);
    }
}

/* A strip over the unit square whose last two rows, or whose first two, are one: it stands still there. */
static batten_surface *standing(double x, bool at_end)
{
    const double knots[2][6] = {{0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}};
    const double rows[3] = {x, x + at_end, x + 1};
    double points[6][3];
    for (int i = 0; i < 6; i++)
        memcpy(points[i], (double[]){rows[i / 2], i % 2, 0}, sizeof points[0]);
    const batten_axis u = {2, 3, knots[1], false}, v = {1, 2, knots[0], false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0], NULL, &surface));
    return surface;
}

TEST(a_surface_that_stands_still_across_its_edge_is_named)
{
    for (int second = 0; second < 2; second++) {
        /* Its edge U1 or U0 is that of the match when it is in this place. */
        batten_surface *one = standing(0, !second), *other = standing(1, !second), *made = NULL;
        CHECK_STATUS(batten_surface_match((batten_surface_edge){one, BATTEN_EDGE_U1},
                                          (batten_surface_edge){other, BATTEN_EDGE_U0}, 1, 1e-9,
                                          NULL, &made),
                     BATTEN_NOT_COMPATIBLE);
        CHECK_MESSAGE(second ? "the second surface has no slope across its edge"
                             : "the first surface has no slope across its edge");
        batten_surface_unref(one);
        batten_surface_unref(other);
    }
}
