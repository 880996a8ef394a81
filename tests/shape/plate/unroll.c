#include <batten/measure.h>
#include <batten/plate.h>
#include <batten/skin.h>
#include <batten/standard.h>
#include <batten/sweep.h>

#include "support/faults.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;

static batten_surface_unroll_options within(double tolerance)
{
    batten_surface_unroll_options options = batten_surface_unroll_defaults();
    options.tolerance = tolerance;
    return options;
}

static double gap(const double *a, const double *b, int dimension)
{
    double sum = 0;
    for (int c = 0; c < dimension; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(sum);
}

TEST(a_cylinder_unrolls_to_a_rectangle)
{
    const batten_frame world = batten_frame_world();
    batten_surface *cylinder = NULL;
    batten_unrolled flat = {0};
    const batten_surface_unroll_options options = within(1e-9);
    CHECK_OK(batten_surface_cylinder(&world, 2, 3, &cylinder));
    CHECK_OK(batten_surface_unroll(cylinder, &options, &flat));
    const double *last = flat.points + 4 * (flat.count - 1);
    CHECK_NEAR(fabs(last[0]), 4 * pi, 1e-10);
    CHECK_NEAR(last[1], 0, 1e-10);
    CHECK_NEAR(last[3] - last[1], 3, 1e-12);
    CHECK_NEAR(flat.area[1], 12 * pi, 1e-10);
    CHECK_NEAR(flat.area[0], flat.area[1], 1e-12);
    CHECK_NEAR(flat.turn, 0, 1e-12);
    CHECK(flat.error <= 1e-9 && flat.strain < 1e-14 && flat.diagonal[0] < 1e-2);
    batten_unrolled_release(&flat);
    batten_surface_unref(cylinder);
}

/* Half-angle 30 degrees: the sector is the half plane. */
TEST(a_cone_of_30_degrees_unrolls_to_a_sector_of_180)
{
    const batten_frame world = batten_frame_world();
    batten_surface *cone = NULL;
    batten_unrolled flat = {0};
    const batten_surface_unroll_options options = within(1e-8);
    CHECK_OK(batten_surface_cone(&world, 1, 0, sqrt(3), &cone));
    CHECK_OK(batten_surface_unroll(cone, &options, &flat));
    CHECK_NEAR(fabs(flat.turn), pi, 1e-11);
    CHECK_NEAR(flat.area[1], 2 * pi, 1e-10);
    CHECK_NEAR(flat.length_first[0] + flat.length_second[0], 2 * pi, 1e-10);
    CHECK_NEAR(flat.length_first[1] + flat.length_second[1], 2 * pi, 1e-10);
    CHECK(flat.strain < 1e-14 && flat.error <= 1e-8);
    /* One edge is the apex, the other the circle about it with the slant height. */
    const int apex = flat.length_first[0] < flat.length_second[0] ? 0 : 1;
    for (int k = 0; k <= 200; k++) {
        double centre[2], rim[2];
        const double u = flat.u[0] + (flat.u[flat.count - 1] - flat.u[0]) * k / 200;
        CHECK_OK(batten_curve_evaluate(apex ? flat.second : flat.first, u, 0, centre));
        CHECK_OK(batten_curve_evaluate(apex ? flat.first : flat.second, u, 0, rim));
        CHECK_NEAR(gap(centre, rim, 2), 2, 2e-8);
        CHECK_NEAR(gap(centre, flat.points + 2 * apex, 2), 0, 1e-10);
    }
    batten_unrolled_release(&flat);
    batten_surface_unref(cone);
}

/* The tangent surface of a helix, from 0.5 to 1.5 along its tangents. */
static batten_surface *tangents_of_a_helix(void)
{
    enum { COUNT = 60 };
    double t[COUNT], values[2][COUNT][3][3];
    batten_curve *edges[2] = {NULL, NULL};
    batten_surface *surface = NULL;
    for (int i = 0; i < COUNT; i++) {
        t[i] = 2.0 * i / (COUNT - 1);
        const double c = cos(t[i]), s = sin(t[i]);
        for (int e = 0; e < 2; e++) {
            const double w = e ? 1.5 : 0.5;
            const double rows[3][3] = {{c - w * s, s + w * c, 0.7 * (t[i] + w)},
                                       {-s - w * c, c - w * s, 0.7},
                                       {-c + w * s, -s - w * c, 0}};
            memcpy(values[e][i], rows, sizeof rows);
        }
    }
    for (int e = 0; e < 2; e++)
        CHECK_OK(batten_curve_from_hermite(3, COUNT, 3, t, &values[e][0][0][0], &edges[e]));
    CHECK_OK(batten_surface_ruled(edges[0], edges[1], &surface));
    batten_curve_unref(edges[0]);
    batten_curve_unref(edges[1]);
    return surface;
}

TEST(the_tangents_of_a_helix_unroll_without_strain_onto_the_tangents_of_a_circle)
{
    batten_surface *surface = tangents_of_a_helix();
    batten_unrolled flat = {0};
    const batten_surface_unroll_options options = within(1e-9);
    CHECK_OK(batten_surface_unroll(surface, &options, &flat));
    CHECK(flat.strain < 1e-10);
    CHECK_NEAR(flat.area[0], flat.area[1], 1e-9);
    CHECK_NEAR(flat.length_first[0], flat.length_first[1], 1e-9);
    CHECK_NEAR(flat.length_second[0], flat.length_second[1], 1e-9);
    /* The helix becomes a circle of its radius of curvature, 1 + 0.7^2: lengths and turn. */
    CHECK_NEAR(fabs(flat.turn), 2 / sqrt(1.49), 1e-9);
    /* Flat edges as curves are as long as the edges in space. */
    double length = 0;
    CHECK_OK(batten_curve_length(flat.second, 1e-11, NULL, &length));
    CHECK_NEAR(length, flat.length_second[0], 1e-8);
    /* A mark midway along a ruling lies midway in the plane. */
    batten_vec2 mark;
    CHECK_EACH_ALLOCATION(batten_unrolled_at(&flat, flat.u[5], 0.5, &mark));
    CHECK_NEAR(mark.x, (flat.points[20] + flat.points[22]) / 2, 1e-11);
    CHECK_NEAR(mark.y, (flat.points[21] + flat.points[23]) / 2, 1e-11);
    batten_unrolled_release(&flat);
    batten_surface_unref(surface);
}

/* A frustum has few knots, so that the rulings are chosen by the error alone. */
TEST(the_flat_edges_converge_with_the_fourth_order)
{
    const batten_frame world = batten_frame_world();
    batten_surface *cone = NULL;
    CHECK_OK(batten_surface_cone(&world, 2, 1, 1.5, &cone));
    double error = 0;
    int count = 0;
    for (int k = 0; k < 8; k++) {
        const batten_surface_unroll_options options = within(k == 0 ? 1e-3 : error / 1.01);
        batten_unrolled flat = {0};
        CHECK_OK(batten_surface_unroll(cone, &options, &flat));
        if (k > 0) {
            CHECK_INT(flat.count - 1, 2 * (count - 1));
            CHECK(flat.error < error / 12 && flat.error > error / 20);
        }
        error = flat.error;
        count = flat.count;
        batten_unrolled_release(&flat);
        if (error < 1e-11)
            break;
    }
    batten_surface_unref(cone);
}

/* z = a x y on [0, 1]^2: the tangent planes along x = const turn by about a. */
static batten_surface *saddle(double a)
{
    const double south[6] = {0, 0, 0, 1, 0, 0}, north[6] = {0, 1, 0, 1, 1, a};
    batten_curve *first = NULL, *second = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_line(3, south, south + 3, &first));
    CHECK_OK(batten_curve_line(3, north, north + 3, &second));
    CHECK_OK(batten_surface_ruled(first, second, &surface));
    batten_curve_unref(first);
    batten_curve_unref(second);
    return surface;
}

TEST(the_strain_of_a_warped_plate_is_that_of_its_tilt)
{
    const double a = 0.1;
    batten_surface *surface = saddle(a);
    batten_unrolled flat = {0};
    CHECK_OK(batten_surface_unroll(surface, NULL, &flat));
    /* At the ends of a ruling the tilt from the middle is about a / 2. */
    const double tilt = atan(a / 2);
    CHECK_NEAR(flat.strain, 1 - cos(tilt), 1e-5);
    CHECK(flat.strain_rms > 0.3 * flat.strain && flat.strain_rms < flat.strain);
    CHECK(flat.area[0] > flat.area[1] && flat.length_first[0] > flat.length_first[1]);
    CHECK_NEAR(flat.strain_at[1] * (1 - flat.strain_at[1]), 0, 1e-12);
    const double at_unit = flat.strain_at[1], strain = flat.strain;
    batten_unrolled_release(&flat);
    /* Over another domain the same place has its parameter there. */
    batten_surface *wide = NULL;
    batten_unrolled other = {0};
    CHECK_OK(batten_surface_set_domain(surface, BATTEN_V, 2, 5, &wide));
    CHECK_OK(batten_surface_unroll(wide, NULL, &other));
    CHECK_NEAR(other.strain_at[1], 2 + 3 * at_unit, 1e-9);
    CHECK_NEAR(other.strain, strain, 1e-9);
    batten_unrolled_release(&other);
    batten_surface_unref(wide);
    batten_surface_unref(surface);
}

TEST(a_sphere_cannot_be_unrolled_and_it_is_said_how_far_its_lines_are_from_straight)
{
    const batten_frame world = batten_frame_world();
    batten_surface *sphere = NULL;
    batten_unrolled flat = {0};
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    CHECK_STATUS(batten_surface_unroll(sphere, NULL, &flat), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("from its chord");
    batten_surface_unroll_options options = within(-1);
    CHECK_STATUS(batten_surface_unroll(sphere, &options, &flat), BATTEN_BAD_ARGUMENT);
    batten_surface_unref(sphere);
}

/* Two lines that cross: the ruling at the crossing has no length. */
TEST(g4_edges_that_cross_are_refused_with_the_place)
{
    const double a[6] = {0, 0, 0, 1, 1, 0}, b[6] = {0, 1, 0, 1, 0, 0};
    batten_curve *first = NULL, *second = NULL;
    batten_surface *surface = NULL;
    batten_unrolled flat = {0};
    CHECK_OK(batten_curve_line(3, a, a + 3, &first));
    CHECK_OK(batten_curve_line(3, b, b + 3, &second));
    CHECK_OK(batten_surface_ruled(first, second, &surface));
    CHECK_STATUS(batten_surface_unroll(surface, NULL, &flat), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("cannot be laid flat at 0.5");
    batten_curve_unref(first);
    batten_curve_unref(second);
    batten_surface_unref(surface);
}

TEST(huge_and_tiny_cylinders_unroll_alike)
{
    const double scales[2] = {1e80, 1e-80};
    const batten_frame world = batten_frame_world();
    for (int k = 0; k < 2; k++) {
        const double r = scales[k];
        batten_surface *cylinder = NULL;
        batten_unrolled flat = {0};
        const batten_surface_unroll_options options = within(1e-7 * r);
        CHECK_OK(batten_surface_cylinder(&world, r, r, &cylinder));
        CHECK_OK(batten_surface_unroll(cylinder, &options, &flat));
        CHECK_NEAR(fabs(flat.points[4 * (flat.count - 1)]) / r, 2 * pi, 1e-10);
        batten_unrolled_release(&flat);
        batten_surface_unref(cylinder);
    }
}

TEST(what_rounding_does_not_allow_is_refused_with_what_was_reached)
{
    const double low[6] = {0, 0, 0, 4, 0, 0}, high[6] = {0, 2, 0, 4, 2, 1};
    batten_curve *first = NULL, *second = NULL;
    batten_surface *warped = NULL;
    batten_unrolled flat = {0};
    batten_surface_unroll_options options = within(1e-17);
    options.straight = BATTEN_STRAIGHT_V;
    CHECK_OK(batten_curve_line(3, low, low + 3, &first));
    CHECK_OK(batten_curve_line(3, high, high + 3, &second));
    CHECK_OK(batten_surface_ruled(first, second, &warped));
    CHECK_STATUS(batten_surface_unroll(warped, &options, &flat), BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("the flat edges are within ");
    CHECK_MESSAGE("not within 1e-17");
    CHECK(!flat.surface && !flat.first && flat.count == 0);
    batten_curve_unref(first);
    batten_curve_unref(second);
    batten_surface_unref(warped);
}

static batten_surface *ruled_between(const double *first, const double *second)
{
    batten_curve *a = NULL, *b = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_line(3, first, first + 3, &a));
    CHECK_OK(batten_curve_line(3, second, second + 3, &b));
    CHECK_OK(batten_surface_ruled(a, b, &surface));
    batten_curve_unref(a);
    batten_curve_unref(b);
    return surface;
}

/* From the common point of two edges of lengths 4 and 5 at 90 degrees, or to it. */
TEST(a_triangle_unrolls_to_itself_from_either_end)
{
    for (int reversed = 0; reversed < 2; reversed++) {
        const double there[2][6] = {{0, 0, 0, 4, 0, 0}, {0, 0, 0, 0, 3, 4}};
        const double back[2][6] = {{4, 0, 0, 0, 0, 0}, {0, 3, 4, 0, 0, 0}};
        batten_surface *triangle =
            reversed ? ruled_between(back[0], back[1]) : ruled_between(there[0], there[1]);
        batten_surface_unroll_options options = within(1e-6);
        batten_unrolled flat = {0};
        options.straight = BATTEN_STRAIGHT_V;
        CHECK_OK(batten_surface_unroll(triangle, &options, &flat));
        CHECK_NEAR(flat.area[0], 10, 1e-9);
        CHECK_NEAR(flat.area[1], 10, 1e-9);
        CHECK_NEAR(flat.length_first[0], 4, 1e-12);
        CHECK_NEAR(flat.length_first[1], 4, 1e-12);
        CHECK_NEAR(flat.length_second[0], 5, 1e-12);
        CHECK_NEAR(flat.length_second[1], 5, 1e-12);
        CHECK_NEAR(flat.turn, 0, 1e-12); /* all rulings are parallel */
        CHECK(flat.strain < 1e-12 && flat.strain_rms < 1e-12 && flat.diagonal[0] < 1e-12);
        CHECK(flat.bow < 1e-15 && flat.error < 1e-6);
        const double *p = flat.points, *q = p + 4 * (flat.count - 1);
        const double *tip = reversed ? q : p, *base = reversed ? p : q;
        CHECK_NEAR(hypot(tip[2] - tip[0], tip[3] - tip[1]), 0, 1e-12);
        CHECK_NEAR(hypot(base[2] - base[0], base[3] - base[1]), sqrt(41), 1e-12);
        CHECK(p[0] == 0 && p[1] == 0 && (reversed ? p[2] < 1e-12 && p[3] > 6 : true));
        batten_unrolled_release(&flat);
        CHECK(!flat.surface && !flat.u && flat.count == 0);
        batten_surface_unref(triangle);
    }
}

TEST(rulings_without_a_tangent_plane_are_refused_with_the_reason)
{
    const double a[6] = {0, 0, 0, 0, 1, 0}, b[6] = {0, 3, 0, 0, 5, 0};
    batten_surface *line = ruled_between(a, b);
    batten_surface_unroll_options options = within(1e-6);
    batten_unrolled flat = {0};
    options.straight = BATTEN_STRAIGHT_V;
    CHECK_STATUS(batten_surface_unroll(line, &options, &flat), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the surface cannot be laid flat at 0: it has no tangent plane midway along "
                  "its ruling");
    batten_surface_unref(line);
}

TEST(surfaces_of_one_coordinate_and_tolerances_of_nothing_are_refused)
{
    const double knots[4] = {0, 0, 1, 1}, z[4] = {0, 1, 2, 4};
    const batten_axis axis = {1, 2, knots, false};
    const double tolerances[3] = {0, -1, HUGE_VAL};
    batten_surface *function = NULL;
    batten_unrolled flat = {0};
    CHECK_OK(batten_surface_create(1, &axis, &axis, z, NULL, &function));
    CHECK_STATUS(batten_surface_unroll(function, NULL, &flat), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("surfaces of dimension 1 are not laid flat");
    for (int i = 0; i < 3; i++) {
        const batten_surface_unroll_options options = within(tolerances[i]);
        CHECK_STATUS(batten_surface_unroll(function, &options, &flat), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("not above 0");
    }
    batten_surface_unref(function);
}

/* On a cylinder of radius 2 the mark at (u, v) lies at the arc length and the height. */
TEST(marks_of_a_cylinder_lie_at_arc_length_and_height)
{
    const batten_frame world = batten_frame_world();
    batten_surface *cylinder = NULL;
    batten_unrolled flat = {0};
    const batten_surface_unroll_options options = within(1e-9);
    CHECK_OK(batten_surface_cylinder(&world, 2, 5, &cylinder));
    CHECK_OK(batten_surface_unroll(cylinder, &options, &flat));
    const batten_interval u = batten_surface_domain(flat.surface, BATTEN_U);
    const batten_interval v = batten_surface_domain(flat.surface, BATTEN_V);
    for (int i = 0; i <= 4; i++)
        for (int j = 0; j <= 2; j++) {
            const double at[2] = {u.a + i / 4.0 * (u.b - u.a), v.a + j / 2.0 * (v.b - v.a)};
            batten_vec2 mark;
            CHECK_OK(batten_unrolled_at(&flat, at[0], at[1], &mark));
            CHECK_NEAR(fabs(mark.x), i * pi, 1e-8);
            CHECK_NEAR(mark.y, 2.5 * j, 1e-8);
        }
    batten_vec2 mark = {7, 8};
    CHECK_STATUS(batten_unrolled_at(&flat, u.a, v.b + 1, &mark), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_unrolled_at(&flat, u.b + 1, v.a, &mark), BATTEN_OUT_OF_DOMAIN);
    CHECK(mark.x == 7 && mark.y == 8);
    batten_unrolled_release(&flat);
    batten_surface_unref(cylinder);
}

/* The share by which a diagonal between neighbouring rulings changes, from what is delivered. */
static double changed_diagonal(const batten_unrolled *flat, int i, int from)
{
    const batten_interval v = batten_surface_domain(flat->surface, BATTEN_V);
    const double *p = flat->points + 4 * i + 2 * from, *q = flat->points + 4 * i + 6 - 2 * from;
    double a[3], b[3];
    CHECK_OK(batten_surface_evaluate(flat->surface, flat->u[i], from ? v.b : v.a, 0, a));
    CHECK_OK(batten_surface_evaluate(flat->surface, flat->u[i + 1], from ? v.a : v.b, 0, b));
    const double space = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
    return fabs(hypot(q[0] - p[0], q[1] - p[1]) - space) / space;
}

TEST(the_largest_change_of_a_diagonal_is_reported_with_its_place)
{
    const double low[6] = {0, 0, 0, 4, 0, 0}, high[6] = {0, 2, 0, 5, 3, 1};
    batten_surface *warped = ruled_between(low, high);
    batten_surface_unroll_options options = within(1e-4);
    batten_unrolled flat = {0};
    double largest = 0, at = 0;
    options.straight = BATTEN_STRAIGHT_V;
    CHECK_OK(batten_surface_unroll(warped, &options, &flat));
    for (int i = 0; i + 1 < flat.count; i++)
        for (int from = 0; from < 2; from++) {
            const double change = changed_diagonal(&flat, i, from);
            at = change > largest ? i : at;
            largest = fmax(largest, change);
        }
    CHECK(largest > 1e-5);
    CHECK_NEAR(flat.diagonal[0], largest, 1e-12);
    CHECK_NEAR(flat.diagonal[1], flat.u[(int)at], 1e-12);
    batten_unrolled_release(&flat);
    batten_surface_unref(warped);
}
