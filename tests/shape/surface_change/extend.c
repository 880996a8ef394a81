#include <batten/curvature.h>
#include <batten/extend.h>
#include <batten/standard.h>

#include "support/faults.h"
#include "support/surfaces.h"

static const batten_edge edges[] = {BATTEN_EDGE_V0, BATTEN_EDGE_U1, BATTEN_EDGE_V1,
                                    BATTEN_EDGE_U0};

static batten_surface *make_dome(double scale)
{
    const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    double points[75];
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            const double x = i / 4.0, y = j / 4.0;
            const double p[] = {x + 0.05 * y * y, y - 0.04 * x,
                                0.6 * x * (1 - x) + 0.3 * y * y * y};
            for (int c = 0; c < 3; c++)
                points[15 * i + 3 * j + c] = scale * p[c];
        }
    const batten_axis axis = {3, 5, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

/* Is the old part what it was, at equal parameters? */
static void check_old_part(const batten_surface *surface, const batten_surface *longer,
                           double tolerance)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    for (int i = 0; i < 60; i++) {
        const double s = i / 59.0, t = fmod(0.37 * i, 1);
        double a[3], b[3];
        CHECK_OK(batten_surface_evaluate(surface, (1 - s) * u.a + s * u.b,
                                         (1 - t) * v.a + t * v.b, 0, a));
        CHECK_OK(batten_surface_evaluate(longer, (1 - s) * u.a + s * u.b,
                                         (1 - t) * v.a + t * v.b, 0, b));
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(b[c], a[c], tolerance);
    }
}

/* The ends of the domain stand at both ends of the knots, degree + 1 times. */
static void check_clamped(const batten_surface *surface, batten_direction direction)
{
    const batten_interval domain = batten_surface_domain(surface, direction);
    const int p = batten_surface_degree(surface, direction);
    const int n = batten_surface_point_count(surface, direction);
    const double *knots = batten_surface_knots(surface, direction);
    for (int i = 0; i <= p; i++)
        CHECK(knots[i] == domain.a && knots[n + i] == domain.b);
}

TEST(every_edge_goes_on_straight_and_naturally)
{
    const batten_extension kinds[] = {BATTEN_EXTEND_LINE, BATTEN_EXTEND_NATURAL,
                                      BATTEN_EXTEND_ARC};
    batten_surface *dome = make_dome(1);
    for (int i = 0; i < 12; i++) {
        const batten_extension kind = kinds[i / 4];
        batten_surface_extend_report report;
        batten_surface *longer = NULL;
        CHECK_EACH_ALLOCATION(batten_surface_extend(
            dome, edges[i % 4], (batten_lengthening){kind, 1e-7}, 0.3, &report, &longer));
        check_old_part(dome, longer, kind == BATTEN_EXTEND_ARC ? 1e-7 : 1e-14);
        CHECK_NEAR(report.least, 0.3, kind == BATTEN_EXTEND_ARC ? 1e-5 : 1e-11);
        CHECK(report.most >= report.least && report.most < 1);
        CHECK(report.angle < (kind == BATTEN_EXTEND_ARC ? 1e-4 : 1e-12));
        if (kind == BATTEN_EXTEND_NATURAL) {
            CHECK(report.curvature < 1e-11);
            CHECK_INT(report.multiplicity, 0);
        } else if (kind == BATTEN_EXTEND_LINE) {
            CHECK_INT(report.multiplicity, 2);
            CHECK_NEAR(report.turn, 0, 1e-12);
        } else {
            CHECK(report.error <= 1e-7 && report.curvature < 0.02);
        }
        const batten_direction across = i % 2 ? BATTEN_U : BATTEN_V;
        check_clamped(longer, across);
        const batten_interval domain = batten_surface_domain(longer, across);
        CHECK(report.to == (edges[i % 4] == BATTEN_EDGE_U0 || edges[i % 4] == BATTEN_EDGE_V0
                                ? domain.a
                                : domain.b));
        batten_surface_unref(longer);
    }
    batten_surface_unref(dome);
}

/* A part of a sphere that goes on naturally, or along arcs of its meridians, stays one. */
TEST(a_sphere_goes_on_as_a_sphere)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *sphere = NULL, *part = NULL, *whole = NULL, *longer = NULL;
    CHECK_OK(batten_surface_sphere(&frame, 2, &sphere));
    CHECK_OK(batten_surface_subrange(sphere, BATTEN_U, 0.02, 0.2, &whole));
    CHECK_OK(batten_surface_subrange(whole, BATTEN_V, 0.3, 0.45, &part));
    for (int i = 0; i < 4; i++) {
        batten_surface_extend_report report;
        CHECK_EACH_ALLOCATION(batten_surface_extend(
            part, edges[i], (batten_lengthening){BATTEN_EXTEND_NATURAL, 1e-6}, 0.2, &report,
            &longer));
        CHECK(report.curvature < 1e-10 && report.angle < 1e-12);
        for (int k = 0; k < 40; k++) {
            const batten_interval u = batten_surface_domain(longer, BATTEN_U);
            const batten_interval v = batten_surface_domain(longer, BATTEN_V);
            const double s = k / 39.0, t = fmod(0.41 * k, 1);
            double p[3];
            CHECK_OK(batten_surface_evaluate(longer, (1 - s) * u.a + s * u.b,
                                             (1 - t) * v.a + t * v.b, 0, p));
            CHECK_NEAR(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), 2, 1e-12);
        }
        batten_surface_unref(longer);
    }
    batten_surface_unref(sphere);
    batten_surface_unref(whole);
    batten_surface_unref(part);
}

/* z = x^2 over -1 <= y <= 1, gone on by arcs at x = 1: radius 5^1.5 / 2 about its centre. */
TEST(an_arc_goes_on_along_the_circle_of_curvature)
{
    const double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 1, 1};
    const double points[] = {0, -1, 0, 0, 1, 0, 0.5, -1, 0, 0.5, 1, 0, 1, -1, 1, 1, 1, 1};
    const batten_axis axes[] = {{2, 3, u, false}, {1, 2, v, false}};
    const double radius = pow(5, 1.5) / 2;
    const double centre[] = {1 - radius * 2 / sqrt(5), 1 + radius / sqrt(5)};
    batten_surface *bowl = NULL, *longer = NULL;
    batten_surface_extend_report report;
    CHECK_OK(batten_surface_create(3, &axes[0], &axes[1], points, NULL, &bowl));
    CHECK_OK(batten_surface_extend(bowl, BATTEN_EDGE_U1,
                                   (batten_lengthening){BATTEN_EXTEND_ARC, 1e-8}, 3, &report,
                                   &longer));
    CHECK_NEAR(report.least, 3, 1e-7);
    CHECK_NEAR(report.most, 3, 1e-7);
    CHECK_NEAR(report.turn, 3 / radius, 1e-6);
    for (int i = 0; i < 40; i++) {
        double p[3];
        CHECK_OK(batten_surface_evaluate(longer, 1 + (report.to - 1) * i / 39, fmod(0.3 * i, 1),
                                         0, p));
        CHECK_NEAR(hypot(p[0] - centre[0], p[2] - centre[1]), radius, 2e-8);
    }
    batten_surface_unref(bowl);
    batten_surface_unref(longer);
}

/* The weights of a sphere change both ways: straight lines along its tangents all the same. */
TEST(rational_surfaces_go_on_straight)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *sphere = NULL, *part = NULL, *longer = NULL;
    batten_surface_extend_report report;
    CHECK_OK(batten_surface_sphere(&frame, 2, &sphere));
    CHECK_OK(batten_surface_subrange(sphere, BATTEN_V, 0.1, 0.4, &part));
    CHECK_OK(batten_surface_extend(part, BATTEN_EDGE_V1,
                                   (batten_lengthening){BATTEN_EXTEND_LINE, 1}, 9, &report,
                                   &longer));
    CHECK_NEAR(report.least, 9, 1e-9);
    CHECK_NEAR(report.most, 9, 1e-9);
    CHECK(report.angle < 1e-12 && report.turn < 1e-7);
    CHECK_NEAR(report.curvature, 0.5, 1e-9);
    check_old_part(part, longer, 1e-14);
    batten_surface_unref(sphere);
    batten_surface_unref(part);
    batten_surface_unref(longer);
}

TEST(G7_edges_that_cannot_go_on_are_refused)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *sphere = NULL, *dome = make_dome(1), *made = NULL;
    CHECK_OK(batten_surface_sphere(&frame, 2, &sphere));
    CHECK_STATUS(batten_surface_extend(sphere, BATTEN_EDGE_V1,
                                       (batten_lengthening){BATTEN_EXTEND_LINE, 1}, 1, NULL,
                                       &made),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("is a point");
    CHECK_STATUS(batten_surface_extend(dome, BATTEN_EDGE_V1,
                                       (batten_lengthening){BATTEN_EXTEND_LINE, 1}, -1, NULL,
                                       &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_extend(dome, BATTEN_EDGE_V1,
                                       (batten_lengthening){BATTEN_EXTEND_LINE, 1}, (double)NAN,
                                       NULL, &made),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_extend(dome, BATTEN_EDGE_V1,
                                       (batten_lengthening){BATTEN_EXTEND_SPIRAL, 1}, 1, NULL,
                                       &made),
                 BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_surface_extend(dome, BATTEN_EDGE_V1,
                                       (batten_lengthening){BATTEN_EXTEND_ARC, 1}, 1e3, NULL,
                                       &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("more than once");
    CHECK(made == NULL);
    batten_surface_unref(sphere);
    batten_surface_unref(dome);
}

TEST(K7_huge_and_tiny_surfaces_go_on)
{
    const double scales[] = {1e80, 1e-80};
    for (int i = 0; i < 2; i++) {
        batten_surface_extend_report report;
        batten_surface *dome = make_dome(scales[i]), *made = NULL;
        CHECK_OK(batten_surface_extend(dome, BATTEN_EDGE_U0,
                                       (batten_lengthening){BATTEN_EXTEND_LINE, 1},
                                       0.5 * scales[i], &report, &made));
        CHECK_NEAR(report.least / scales[i], 0.5, 1e-11);
        batten_surface_unref(made);
        made = NULL;
        CHECK_OK(batten_surface_extend(
            dome, BATTEN_EDGE_V1, (batten_lengthening){BATTEN_EXTEND_ARC, 1e-6 * scales[i]},
            0.5 * scales[i], &report, &made));
        CHECK_NEAR(report.least / scales[i], 0.5, 1e-5);
        batten_surface_unref(made);
        batten_surface_unref(dome);
    }
}

static const struct {
    int edge, kind;
    double length, tolerance;
    batten_status status;
    const char *message;
} refused[] = {
    {BATTEN_EDGE_V1, BATTEN_EXTEND_LINE, INFINITY, 1, BATTEN_NOT_FINITE,
     "an extension by inf within 1"},
    {BATTEN_EDGE_V1, BATTEN_EXTEND_LINE, 2, NAN, BATTEN_NOT_FINITE,
     "an extension by 2 within nan"},
    {BATTEN_EDGE_U0 + 1, BATTEN_EXTEND_LINE, 2, 1, BATTEN_BAD_ARGUMENT,
     "there is no edge 4 or extension 0"},
    {-1, BATTEN_EXTEND_LINE, 2, 1, BATTEN_BAD_ARGUMENT, "there is no edge -1 or extension 0"},
    {BATTEN_EDGE_V1, BATTEN_EXTEND_NATURAL + 1, 2, 1, BATTEN_BAD_ARGUMENT,
     "there is no edge 2 or extension "},
    {BATTEN_EDGE_V1, -1, 2, 1, BATTEN_BAD_ARGUMENT, "there is no edge 2 or extension -1"},
    {BATTEN_EDGE_V1, BATTEN_EXTEND_LINE, 0, 1, BATTEN_BAD_ARGUMENT,
     "an extension by 0 within 1: both must be above 0"},
    {BATTEN_EDGE_V1, BATTEN_EXTEND_ARC, 2, 0, BATTEN_BAD_ARGUMENT,
     "an extension by 2 within 0: both must be above 0"},
    {BATTEN_EDGE_V1, BATTEN_EXTEND_SPIRAL, 2, 1, BATTEN_UNSUPPORTED,
     "surfaces cannot be extended along spirals"},
};

TEST(requests_that_cannot_be_are_named_with_their_numbers)
{
    batten_surface *dome = make_dome(1), *made = NULL;
    for (int i = 0; i < COUNT(refused); i++) {
        CHECK_STATUS(
            batten_surface_extend(
                dome, (batten_edge)refused[i].edge,
                (batten_lengthening){(batten_extension)refused[i].kind, refused[i].tolerance},
                refused[i].length, NULL, &made),
            refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    /* Without arcs the tolerance does not matter. */
    CHECK_OK(batten_surface_extend(
        dome, BATTEN_EDGE_V1, (batten_lengthening){BATTEN_EXTEND_LINE, 0}, 0.1, NULL, &made));
    batten_surface_unref(made);
    batten_surface_unref(dome);
}

TEST(functions_and_periodic_edges_cannot_be_extended)
{
    const double knots[4] = {0, 0, 1, 1}, z[4] = {0, 1, 2, 3};
    const double around[5] = {0, 1, 2, 3, 4},
                 ring[18] = {1, 0, 0, 1, 0, 1, -1, 1, 0, -1, 1, 1, -1, -1, 0, -1, -1, 1};
    const batten_axis axis = {1, 2, knots, false}, periodic = {2, 3, around, true};
    const batten_lengthening line = {BATTEN_EXTEND_LINE, 1};
    batten_surface *function = NULL, *tube = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(1, &axis, &axis, z, NULL, &function));
    CHECK_STATUS(batten_surface_extend(function, BATTEN_EDGE_V1, line, 1, NULL, &made),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("only NURBS surfaces in space can be extended");
    CHECK_OK(batten_surface_create(3, &periodic, &axis, ring, NULL, &tube));
    CHECK_STATUS(batten_surface_extend(tube, BATTEN_EDGE_U1, line, 1, NULL, &made),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("a periodic surface has no edge there");
    CHECK_OK(batten_surface_extend(tube, BATTEN_EDGE_V1, line, 1, NULL, &made));
    CHECK(batten_surface_is_periodic(made, BATTEN_U));
    batten_surface_unref(made);
    batten_surface_unref(tube);
    batten_surface_unref(function);
}

/* (u, v (1 + u)): lines across v are as fast as 1 + u, those across u as sqrt(1 + v^2). */
static batten_surface *trapezoid(void)
{
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 2, 0};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

static const struct {
    batten_edge edge;
    double to, most; /* of an extension whose shortest line is 0.5 long */
} trapezoid_rows[] = {{BATTEN_EDGE_V0, -0.5, 1},
                      {BATTEN_EDGE_V1, 1.5, 1},
                      {BATTEN_EDGE_U0, -0.5, 0.5 * 1.4142135623730951},
                      {BATTEN_EDGE_U1, 1.5, 0.5 * 1.4142135623730951}};

TEST(the_shortest_line_of_an_extension_is_as_long_as_asked_and_all_is_reported)
{
    for (int i = 0; i < 2 * COUNT(trapezoid_rows); i++) {
        const int row = i / 2;
        const batten_edge edge = trapezoid_rows[row].edge;
        const bool across_v = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1;
        batten_surface *surface = trapezoid(), *longer = NULL;
        batten_surface_extend_report report;
        const batten_lengthening how = {.kind =
                                            i % 2 ? BATTEN_EXTEND_NATURAL : BATTEN_EXTEND_LINE};
        CHECK_OK(batten_surface_extend(surface, edge, how, 0.5, &report, &longer));
        CHECK_NEAR(report.to, trapezoid_rows[row].to, 1e-12);
        CHECK_NEAR(report.least, 0.5, 1e-12);
        CHECK_NEAR(report.most, trapezoid_rows[row].most, 1e-12);
        CHECK_NEAR(report.turn, 0, 1e-12);
        CHECK_NEAR(report.angle, 0, 1e-7);
        CHECK_NEAR(report.curvature, 0, 1e-12);
        CHECK_NEAR(report.error, 0, 1e-12);
        const batten_interval range =
            batten_surface_domain(longer, across_v ? BATTEN_V : BATTEN_U);
        CHECK_NEAR(report.to < 0 ? range.a : range.b, report.to, 0);
        CHECK_NEAR(report.to < 0 ? range.b : range.a, report.to < 0 ? 1 : 0, 0);
        for (int k = 0; k <= 8; k++) {
            double p[3];
            const double t = k / 8.0, u = across_v ? t : report.to,
                         v = across_v ? report.to : t;
            CHECK_OK(batten_surface_evaluate(longer, u, v, 0, p));
            CHECK_NEAR(p[0], u, 1e-12);
            CHECK_NEAR(p[1], v * (1 + u), 1e-12);
            CHECK_NEAR(p[2], 0, 1e-12);
        }
        batten_surface_unref(longer);
        batten_surface_unref(surface);
    }
}

/* (u, sin-like bend): the quadratic (u, v, v^2 / 2) has slope 1 and curvature 1 / 2^(3/2) at v = 1; straight
 * on, that is the jump of the curvature, and nothing turns. Naturally, to v = 1 + w it turns from 45 degrees to
 * atan(1 + w). */
TEST(the_jump_of_curvature_and_the_turn_of_an_extension_are_measured)
{
    const double knots[2][6] = {{0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}};
    const double points[] = {0, 0, 0, 0, 0.5, 0, 0, 1, 0.5, 1, 0, 0, 1, 0.5, 0, 1, 1, 0.5};
    const batten_axis u = {1, 2, knots[0], false}, v = {2, 3, knots[1], false};
    for (int natural = 0; natural < 2; natural++) {
        batten_surface *surface = NULL, *longer = NULL;
        batten_surface_extend_report report;
        const batten_lengthening how = {.kind = natural ? BATTEN_EXTEND_NATURAL
                                                        : BATTEN_EXTEND_LINE};
        CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
        CHECK_OK(batten_surface_extend(surface, BATTEN_EDGE_V1, how, 1, &report, &longer));
        CHECK_NEAR(report.least, 1, 1e-9);
        CHECK_NEAR(report.most, 1, 1e-9);
        CHECK_NEAR(report.curvature, natural ? 0 : pow(2, -1.5), 1e-12);
        CHECK_NEAR(report.turn, natural ? atan(report.to) - atan(1) : 0, 1e-12);
        CHECK_NEAR(report.angle, 0, 1e-7);
        if (!natural)
            CHECK_NEAR(report.to, 1 + sqrt(0.5), 1e-12);
        else /* the length of a parabola */
            CHECK_NEAR((report.to * hypot(1, report.to) + asinh(report.to)) / 2 -
                           (sqrt(2) + asinh(1)) / 2,
                       1, 1e-9);
        CHECK_INT(report.multiplicity, natural ? 0 : 1);
        batten_surface_unref(longer);
        batten_surface_unref(surface);
    }
}
