#include <batten/blend.h>
#include <batten/curvature.h>
#include <batten/standard.h>

#include "support/faults.h"
#include "support/surfaces.h"

static batten_surface *make_dome(double scale, double x0)
{
    const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    double points[75];
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            const double x = i / 4.0, y = j / 4.0;
            const double p[] = {x0 + x + 0.05 * y * y, y - 0.04 * x,
                                0.6 * x * (1 - x) + 0.3 * y * y * y};
            for (int c = 0; c < 3; c++)
                points[15 * i + 3 * j + c] = scale * p[c];
        }
    const batten_axis axis = {3, 5, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

static void set_ends(batten_surface_blend_end ends[2], batten_edge first, batten_edge second,
                     int continuity)
{
    ends[0] = batten_surfaces_blend_defaults(first);
    ends[1] = batten_surfaces_blend_defaults(second);
    ends[0].continuity = ends[1].continuity = continuity;
}

/* All pairs of edges and orders: contact, tangent planes, curvatures to rounding. */
TEST(blends_go_over_into_both_surfaces_exactly)
{
    static const batten_edge edges[] = {BATTEN_EDGE_V0, BATTEN_EDGE_U1, BATTEN_EDGE_V1,
                                        BATTEN_EDGE_U0};
    batten_surface *a = make_dome(1, 0), *b = make_dome(1, 2.5), *made = NULL;
    const batten_surface *const pair[2] = {a, b};
    for (int i = 0; i < 16; i++)
        for (int order = 0; order < 3; order++) {
            batten_surface_blend_end ends[2];
            batten_surfaces_blend_report report;
            set_ends(ends, edges[i % 4], edges[i / 4], order);
            ends[0].bulge = 0.7;
            ends[1].from = 0.2;
            CHECK_EACH_ALLOCATION(batten_surfaces_blend(pair, ends, 0, &report, &made));
            CHECK_INT(batten_surface_degree(made, BATTEN_V), 2 * order + 1);
            CHECK(report.error == 0);
            for (int k = 0; k < 2; k++) {
                CHECK_NEAR(report.gap[k], 0, 1e-14);
                if (order > 0)
                    CHECK_NEAR(report.angle[k], 0, 1e-12);
                if (order > 1)
                    CHECK_NEAR(report.curvature[k], 0, 1e-10);
            }
            batten_surface_unref(made);
        }
    batten_surface_unref(a);
    batten_surface_unref(b);
}

/* The middle third of a plane cut out and blended again is plane, the middle of a cylinder's
 * arc nearly round. */
TEST(a_blend_between_parts_of_a_plane_is_plane)
{
    batten_surface *plane = NULL, *low = NULL, *rest = NULL, *high = NULL, *made = NULL;
    const batten_vec3 p[] = {{0, 0, 1}, {3, 0, 2}, {0, 2, 1}, {3, 2, 2}};
    CHECK_OK(batten_surface_bilinear(p[0], p[1], p[2], p[3], &plane));
    CHECK_OK(batten_surface_split(plane, BATTEN_U, 1.0 / 3, &low, &rest));
    CHECK_OK(batten_surface_subrange(rest, BATTEN_U, 2.0 / 3, 1, &high));
    const batten_surface *const pair[2] = {low, high};
    batten_surface_blend_end ends[2];
    batten_surfaces_blend_report report;
    set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 2);
    CHECK_EACH_ALLOCATION(batten_surfaces_blend(pair, ends, 0, &report, &made));
    CHECK(!report.folded && !report.reversed);
    for (int i = 0; i < 30; i++) {
        double at[3];
        const double u = i / 29.0, v = fmod(0.37 * i, 1);
        CHECK_OK(batten_surface_evaluate(made, u, v, 0, at));
        CHECK_NEAR(at[0], 1 + v, 1e-14);
        CHECK_NEAR(at[1], 2 * u, 1e-14);
        CHECK_NEAR(at[2], 1 + at[0] / 3, 1e-14);
    }
    batten_surface_unref(plane);
    batten_surface_unref(low);
    batten_surface_unref(rest);
    batten_surface_unref(high);
    batten_surface_unref(made);
}

/* Pipes of one radius on one axis: their weights agree, so the blend is exact; a sphere's edge
 * beside one has others, and is met within the tolerance. */
TEST(rational_edges_with_the_same_weights_are_blended_exactly)
{
    batten_frame frame = batten_frame_world();
    batten_surface *low = NULL, *high = NULL, *made = NULL, *sphere = NULL, *cap = NULL;
    batten_surface_blend_end ends[2];
    batten_surfaces_blend_report report;
    CHECK_OK(batten_surface_cylinder(&frame, 1, 1, &low));
    frame.origin.z = 3;
    CHECK_OK(batten_surface_cylinder(&frame, 0.5, 1, &high));
    const batten_surface *const pair[2] = {low, high};
    set_ends(ends, BATTEN_EDGE_V1, BATTEN_EDGE_V0, 2);
    CHECK_OK(batten_surfaces_blend(pair, ends, 0, &report, &made));
    CHECK(report.error == 0 && !report.folded);
    for (int k = 0; k < 2; k++) {
        CHECK_NEAR(report.gap[k], 0, 1e-14);
        CHECK_NEAR(report.angle[k], 0, 1e-12);
        CHECK_NEAR(report.curvature[k], 0, 1e-10);
    }
    for (int i = 0; i < 30; i++) {
        double a[3], b[3];
        CHECK_OK(batten_surface_evaluate(made, i / 29.0, 0.5, 0, a));
        CHECK_OK(batten_surface_evaluate(made, 0, 0.5, 0, b));
        CHECK_NEAR(hypot(a[0], a[1]), hypot(b[0], b[1]), 1e-14);
    }
    batten_surface_unref(made);
    made = NULL;
    CHECK_OK(batten_surface_sphere(&frame, 1, &sphere));
    CHECK_OK(batten_surface_subrange(sphere, BATTEN_U, 0.1, 0.4, &cap));
    const batten_surface *const other[2] = {low, cap};
    set_ends(ends, BATTEN_EDGE_V1, BATTEN_EDGE_U0, 1);
    CHECK_OK(batten_surfaces_blend(other, ends, 1e-5, &report, &made));
    CHECK(report.error > 0 && report.error < 1e-4);
    for (int k = 0; k < 2; k++) {
        CHECK(report.gap[k] <= 1e-5);
        CHECK(report.angle[k] < 5e-3 || isinf(report.angle[k]));
    }
    batten_surface_unref(made);
    batten_surface_unref(low);
    batten_surface_unref(high);
    batten_surface_unref(sphere);
    batten_surface_unref(cap);
}

/* Bulges far too large make a blend in a plane run to and fro. */
TEST(folds_of_blends_are_found)
{
    batten_surface *a = NULL, *b = NULL, *made = NULL;
    const batten_vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const batten_vec3 q[] = {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {3, 1, 0}};
    CHECK_OK(batten_surface_bilinear(p[0], p[1], p[2], p[3], &a));
    CHECK_OK(batten_surface_bilinear(q[0], q[1], q[2], q[3], &b));
    const batten_surface *const pair[2] = {a, b};
    batten_surface_blend_end ends[2];
    batten_surfaces_blend_report report;
    set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 1);
    ends[0].bulge = ends[1].bulge = 9; /* where it turns back there is no normal */
    CHECK_OK(batten_surfaces_blend(pair, ends, 0, &report, &made));
    CHECK(report.folded && report.fold[1] > 0 && report.fold[1] < 0.5);
    CHECK_NEAR(report.fold[0], 0, 0); /* on the first line of the grid */
    CHECK_NEAR(remainder(report.fold[1], 1.0 / 32), 0, 0);
    batten_surface_unref(a);
    batten_surface_unref(b);
    batten_surface_unref(made);
}

TEST(G7_edges_that_cannot_be_blended_are_refused)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *a = make_dome(1, 0), *ball = NULL, *made = NULL;
    const batten_surface *const same[2] = {a, a};
    batten_surface_blend_end ends[2];
    CHECK_OK(batten_surface_sphere(&frame, 1, &ball));
    const batten_surface *const balls[2] = {ball, ball};
    set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U1, 1);
    CHECK_STATUS(batten_surfaces_blend(same, ends, 0, NULL, &made), BATTEN_COINCIDENT);
    CHECK_MESSAGE("the edges are the same");
    set_ends(ends, BATTEN_EDGE_V0, BATTEN_EDGE_V1, 1);
    CHECK_STATUS(batten_surfaces_blend(balls, ends, 1e-4, NULL, &made), BATTEN_COINCIDENT);
    CHECK_MESSAGE("both edges are points");
    set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 1);
    ends[1].bulge = (double)NAN;
    CHECK_STATUS(batten_surfaces_blend(same, ends, 0, NULL, &made), BATTEN_NOT_FINITE);
    ends[1].bulge = -1;
    CHECK_STATUS(batten_surfaces_blend(same, ends, 0, NULL, &made), BATTEN_BAD_ARGUMENT);
    CHECK(made == NULL);
    batten_surface_unref(a);
    batten_surface_unref(ball);
}

TEST(K7_huge_and_tiny_blends)
{
    const double scales[] = {1e80, 1e-80};
    for (int i = 0; i < 2; i++) {
        batten_surface *a = make_dome(scales[i], 0), *b = make_dome(scales[i], 2);
        batten_surface *made = NULL;
        const batten_surface *const pair[2] = {a, b};
        batten_surface_blend_end ends[2];
        batten_surfaces_blend_report report;
        set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 2);
        CHECK_OK(batten_surfaces_blend(pair, ends, 0, &report, &made));
        CHECK_NEAR(report.gap[0] / scales[i], 0, 1e-14);
        CHECK_NEAR(report.curvature[1] * scales[i], 0, 1e-10);
        batten_surface_unref(a);
        batten_surface_unref(b);
        batten_surface_unref(made);
    }
}

static const struct {
    int side, edge, continuity;
    double from, to, bulge;
    batten_status status;
    const char *message;
} refused[] = {
    {0, 1, 2, NAN, 1, 1, BATTEN_NOT_FINITE, "side 1: from nan to 1, bulge 1"},
    {1, 1, 2, 0, INFINITY, 1, BATTEN_NOT_FINITE, "side 2: from 0 to inf, bulge 1"},
    {1, 1, 2, 0, 1, NAN, BATTEN_NOT_FINITE, "side 2: from 0 to 1, bulge nan"},
    {0, 4, 2, 0, 1, 1, BATTEN_BAD_ARGUMENT, "side 1: a surface has no edge 4"},
    {1, -1, 2, 0, 1, 1, BATTEN_BAD_ARGUMENT, "side 2: a surface has no edge -1"},
    {0, 1, 2, -0.1, 1, 1, BATTEN_BAD_ARGUMENT, "side 1: a part from -0.1 to 1"},
    {0, 1, 2, 0.5, 0.5, 1, BATTEN_BAD_ARGUMENT, "a part from 0.5 to 0.5; parts go forwards"},
    {1, 1, 2, 0, 1.1, 1, BATTEN_BAD_ARGUMENT, "side 2: a part from 0 to 1.1"},
    {1, 1, 2, 0, 1, 0, BATTEN_BAD_ARGUMENT, "side 2: a bulge of 0; bulges are above 0"},
    {0, 1, -1, 0, 1, 1, BATTEN_BAD_ARGUMENT, "side 1: continuity G-1"},
    {0, 1, 3, 0, 1, 1, BATTEN_BAD_ARGUMENT,
     "continuity G3; surfaces are blended with G0, G1 or G2"},
};

TEST(ends_of_blends_out_of_bounds_are_named_with_their_numbers)
{
    const double knots[4] = {0, 0, 1, 1}, z[4] = {0, 1, 2, 3};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *a = make_dome(1, 0), *b = make_dome(1, 2), *function = NULL, *made = NULL;
    const batten_surface *const pair[2] = {a, b};
    batten_surface_blend_end ends[2];
    for (int i = 0; i < COUNT(refused); i++) {
        set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 2);
        batten_surface_blend_end *end = &ends[refused[i].side];
        end->edge = (batten_edge)refused[i].edge;
        end->continuity = refused[i].continuity;
        end->from = refused[i].from;
        end->to = refused[i].to;
        end->bulge = refused[i].bulge;
        CHECK_STATUS(batten_surfaces_blend(pair, ends, 1e-6, NULL, &made), refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 2);
    CHECK_OK(batten_surface_create(1, &axis, &axis, z, NULL, &function));
    const batten_surface *const flat[2] = {a, function};
    CHECK_STATUS(batten_surfaces_blend(flat, ends, 1e-6, NULL, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("surface 2 is not in space");
    CHECK(!made);
    batten_surface_unref(function);
    batten_surface_unref(a);
    batten_surface_unref(b);
}

/* From the edge x = 1 of one plane to the edge x = 2 of another that lies 1 higher: z = 3 v^2 - 2 v^3 with a level start and
 * end, so that it bends there by 6 over the square of the speed; the second plane may run back. */
TEST(the_report_of_a_blend_has_the_curvature_that_jumps_at_both_ends)
{
    for (int back = 0; back < 2; back++) {
        const batten_vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
        const batten_vec3 q[] = {
            {2, back, 1}, {3, back, 1}, {2, 1 - back, 1}, {3, 1 - back, 1}};
        batten_surface *a = NULL, *b = NULL, *made = NULL;
        batten_surface_blend_end ends[2];
        batten_surfaces_blend_report report;
        CHECK_OK(batten_surface_bilinear(p[0], p[1], p[2], p[3], &a));
        CHECK_OK(batten_surface_bilinear(q[0], q[1], q[2], q[3], &b));
        set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 1);
        CHECK_OK(batten_surfaces_blend((const batten_surface *const[]){a, b}, ends, 0, &report,
                                       &made));
        CHECK_INT(report.reversed, back);
        CHECK(!report.folded && report.error == 0);
        const batten_interval v = batten_surface_domain(made, BATTEN_V);
        for (int k = 0; k < 2; k++) {
            double at[9];
            CHECK_OK(batten_surface_evaluate(made, 0.3, k ? v.b : v.a, 1, at));
            CHECK_NEAR(at[0], 1 + k, 1e-14);
            CHECK_NEAR(at[2], k, 1e-14);
            CHECK_NEAR(report.gap[k], 0, 1e-14);
            CHECK_NEAR(report.angle[k], 0, 1e-13);
            CHECK_NEAR(report.curvature[k], 6 / (at[6] * at[6]), 1e-12);
        }
        batten_surface_unref(made);
        batten_surface_unref(b);
        batten_surface_unref(a);
    }
}

/* (u^2, v, z): it comes to rest where it begins. */
static batten_surface *make_resting(double x, double z)
{
    const double slow[] = {0, 0, 0, 1, 1, 1}, knots[] = {0, 0, 1, 1};
    const double points[] = {x, 0, z, x, 1, z, x, 0, z, x, 1, z, x + 1, 0, z, x + 1, 1, z};
    const batten_axis u = {2, 3, slow, false}, v = {1, 2, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
    return surface;
}

TEST(G5_a_surface_that_rests_at_its_edge_is_refused_by_its_number)
{
    batten_surface *a = make_resting(0, 0), *b = make_resting(5, 1), *made = NULL;
    const batten_surface *const pair[2] = {a, b};
    batten_surface_blend_end ends[2];
    set_ends(ends, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 1);
    CHECK_STATUS(batten_surfaces_blend(pair, ends, 1e-6, NULL, &made), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("surface 2 stands still across its edge: its mean speed there is 0");
    set_ends(ends, BATTEN_EDGE_U0, BATTEN_EDGE_U1, 1);
    CHECK_STATUS(batten_surfaces_blend(pair, ends, 1e-6, NULL, &made), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("surface 1 stands still across its edge");
    CHECK(!made);
    batten_surface_unref(a);
    batten_surface_unref(b);
}

/* (u, -v, v c(u)) along the x-axis, c quadratic with its bend between two of 33 even places. */
static batten_surface *make_fin(batten_curve **height)
{
    const double us[] = {0, 0, 0, 0.5, 0.53125, 1, 1, 1}, vs[] = {0, 0, 1, 1};
    const double c[] = {0, 0.2, 9, 0.2, 0}, x[] = {0, 0.25, 0.515625, 0.765625, 1};
    double points[30];
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 2; j++)
            memcpy(points + 6 * i + 3 * j, (const double[]){x[i], -j, j * c[i]},
                   3 * sizeof *points);
    const batten_axis u = {2, 5, us, false}, v = {1, 2, vs, false};
    batten_surface *fin = NULL;
    batten_curve *curve = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &fin));
    CHECK_OK(batten_curve_create((batten_points){1, 5, c}, 2, NULL, us, &curve));
    *height = curve;
    return fin;
}

/* Across the plane z = 0 the angle is atan |c(u)|; 33 even places miss its peak. */
TEST(the_largest_angle_of_a_blend_is_found_between_samples)
{
    const batten_vec3 p[] = {{0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}};
    batten_curve *height = NULL;
    batten_surface *fin = make_fin(&height), *plane = NULL, *made = NULL;
    batten_surface_blend_end ends[2];
    batten_surfaces_blend_report report;
    double largest = 0, seen = 0;
    for (int i = 0; i <= 32000; i++) {
        double c;
        CHECK_OK(batten_curve_evaluate(height, i / 32000.0, 0, &c));
        largest = fmax(largest, atan(fabs(c)));
        if (i % 1000 == 0)
            seen = fmax(seen, atan(fabs(c)));
    }
    CHECK(seen < largest - 1e-4);
    CHECK_OK(batten_surface_bilinear(p[0], p[1], p[2], p[3], &plane));
    set_ends(ends, BATTEN_EDGE_V0, BATTEN_EDGE_V0, 0);
    CHECK_OK(batten_surfaces_blend((const batten_surface *const[]){fin, plane}, ends, 0,
                                   &report, &made));
    CHECK_NEAR(report.angle[0], largest, 1e-8);
    CHECK_NEAR(report.angle[1], 0, 1e-12);
    batten_surface_unref(made);
    batten_surface_unref(plane);
    batten_surface_unref(fin);
    batten_curve_unref(height);
}
