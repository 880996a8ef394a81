#include "shape/fill/loops.h"
#include "support/faults.h"

static const double round_corners[8] = {1, 1, 1, 1, 1, 1, 1, 1};
static const double uneven[8] = {1, 1.2, 0.9, 1.1, 0.95, 1.15, 1.05, 0.9};

/* The largest angle, in degrees, to the paraboloid along the sides, and distance from it. */
static hole_misfit from_paraboloid(const hole *h, double bend, bool inside)
{
    enum { PLACES = 25 };
    hole_misfit out = {0, 0};
    for (int i = 0; i < h->report.count; i++)
        for (int k = 0; k <= PLACES; k++)
            for (int j = 0; j <= (inside ? PLACES : 1); j++) {
                const double s = k / (double)PLACES, t = inside ? j / (double)PLACES : 0;
                double p[3], n[3];
                hole_see(h->patches[i], j == 1 && !inside ? 0 : s, j == 1 && !inside ? s : t, p,
                         n);
                const double z = bend * (p[0] * p[0] + p[1] * p[1]) / 2;
                const double m[3] = {-bend * p[0], -bend * p[1], 1}, q[3] = {p[0], p[1], z};
                hole_compare(p, n, q, m, &out);
            }
    return out;
}

TEST(holes_of_three_to_eight_sides_join_smoothly_inside_and_outside)
{
    for (int n = 3; n <= 8; n++)
        for (int shape = 0; shape <= n % 2; shape++) { /* uneven: of 3, 5 and 7 sides */
            hole h;
            hole_on_paraboloid(n, shape == 0 ? round_corners : uneven, 0.8, &h);
            CHECK_OK(batten_surface_fill(n, h.ribbons, NULL, &h.report, h.patches));
            CHECK_INT(h.report.count, n);
            CHECK_INT(h.report.twisted, 0);
            CHECK(!h.report.folded);
            const hole_misfit outer = from_paraboloid(&h, 0.8, false), inner = hole_inner(&h);
            CHECK_NEAR(outer.gap, 0, 1e-13);
            CHECK_NEAR(outer.angle, 0, 1e-8);
            CHECK_NEAR(inner.gap, 0, 1e-13);
            CHECK_NEAR(inner.angle, 0, 1e-8);
            /* degree two is reproduced over regular polygons, and nearly over others */
            CHECK_NEAR(from_paraboloid(&h, 0.8, true).gap, 0, shape == 0 ? 1e-12 : 0.01);
            hole_free(&h);
        }
}

TEST(a_flat_hole_is_filled_flat)
{
    hole h;
    hole_on_paraboloid(3, uneven, 0, &h);
    CHECK_EACH_ALLOCATION(batten_surface_fill(3, h.ribbons, NULL, &h.report, h.patches));
    CHECK_NEAR(from_paraboloid(&h, 0, true).angle, 0, 1e-10);
    hole_free(&h);
    hole_on_paraboloid(5, uneven, 0, &h);
    for (int i = 0; i < 5; i++) /* and with free sides too */
        h.ribbons[i].slope = NULL;
    CHECK_OK(batten_surface_fill(5, h.ribbons, NULL, &h.report, h.patches));
    CHECK_NEAR(from_paraboloid(&h, 0, true).angle, 0, 1e-10);
    CHECK(!h.report.outer[0].has_slope && h.report.inner[0].has_slope);
    hole_free(&h);
}

TEST(G7_sides_in_any_order_and_direction_make_the_same_fill)
{
    static const int order[5] = {0, 3, 1, 4, 2};
    hole h, shuffled = {0};
    hole_on_paraboloid(5, uneven, 0.8, &h);
    CHECK_OK(batten_surface_fill(5, h.ribbons, NULL, &h.report, h.patches));
    shuffled.count = 5;
    for (int i = 0; i < 5; i++) {
        const int from = order[i];
        if (i % 2 == 1) {
            CHECK_OK(batten_curve_reverse(h.curves[from], &shuffled.curves[i]));
            CHECK_OK(batten_curve_reverse(h.slopes[from], &shuffled.slopes[i]));
        } else {
            shuffled.curves[i] = batten_curve_ref(h.curves[from]);
            shuffled.slopes[i] = batten_curve_ref(h.slopes[from]);
        }
        shuffled.ribbons[i] = (batten_ribbon){shuffled.curves[i], shuffled.slopes[i], NULL};
    }
    CHECK_OK(
        batten_surface_fill(5, shuffled.ribbons, NULL, &shuffled.report, shuffled.patches));
    for (int i = 0; i < 5; i++) {
        double p[3], q[3], n[3];
        hole_see(h.patches[i], 0.3, 0.7, p, n);
        hole_see(shuffled.patches[i], 0.3, 0.7, q, n);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(p[c], q[c], 1e-12);
        CHECK_INT(order[shuffled.report.outer[i].curve], h.report.outer[i].curve);
    }
    hole_free(&shuffled);
    hole_free(&h);
}

/* Slopes that lean out of the paraboloid's planes inside the sides twist against each other in
 * the corners. */
static void lean(hole *h)
{
    for (int i = 0; i < h->count; i++) {
        const double *s = batten_curve_points(h->slopes[i]), ends[2] = {0, 1};
        double leaning[3][3];
        for (int c = 0; c < 3; c++) {
            leaning[0][c] = s[c];
            leaning[1][c] = (s[c] + s[3 + c]) / 2 + (c == 2 ? 0.5 : 0);
            leaning[2][c] = s[3 + c];
        }
        batten_curve_unref(h->slopes[i]);
        h->slopes[i] = NULL;
        CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){2, 1, ends}, leaning[0], NULL,
                                          &h->slopes[i]));
        h->ribbons[i].slope = h->slopes[i];
    }
}

TEST(ribbons_that_twist_against_each_other_are_left_in_small_zones_alone)
{
    hole h;
    hole_on_paraboloid(5, uneven, 0.8, &h);
    lean(&h);
    static const double angles[] = {0.001, 0.01, 0.1};
    for (int k = 0; k < COUNT(angles); k++) {
        const double angle = angles[k];
        batten_surface_fill_options options = batten_surface_fill_defaults();
        options.angle = angle / TESTS_DEGREES;
        CHECK_OK(batten_surface_fill(5, h.ribbons, &options, &h.report, h.patches));
        CHECK_INT(h.report.twisted, 5);
        CHECK(h.report.twist > 0.01);
        double worst = 0;
        for (int i = 0; i < 5; i++)
            worst = fmax(worst, h.report.outer[i].angle * TESTS_DEGREES);
        CHECK(worst < 1.01 * angle && worst > 0.5 * angle);
        CHECK_NEAR(hole_inner(&h).angle, 0, 1e-8);
        hole_free_patches(&h);
    }
    hole_free(&h);
}

TEST(two_sides_and_sides_with_corners_are_divided)
{
    static const double points[3][3] = {{0, 0, 0}, {1, 1, 0.5}, {2, 0, 0}};
    static const double back[3][3] = {{2, 0, 0}, {1, -1.2, 0.3}, {0, 0, 0}};
    hole h = {0};
    hole_add(&h, 2, points[0], 0, NULL);
    hole_add(&h, 2, back[0], 0, NULL);
    CHECK_OK(batten_surface_fill(2, h.ribbons, NULL, &h.report, h.patches));
    CHECK_INT(h.report.count, 3);
    CHECK_INT(h.report.flat_corners, 1);
    CHECK_NEAR(hole_inner(&h).angle, 0, 1e-8);
    hole_free(&h);

    static const double bent[4][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0.5}, {2, 1, 0}};
    static const double knots[6] = {0, 0, 1, 3, 4, 4}, ends[2] = {0, 1};
    static const double closing[3][3] = {{2, 1, 0}, {1, 2, 1}, {0, 0, 0}};
    memset(&h, 0, sizeof h);
    h.count = 2;
    CHECK_OK(batten_curve_create((batten_points){3, 4, bent[0]}, 1, NULL, knots, &h.curves[0]));
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){2, 1, ends}, closing[0], NULL,
                                      &h.curves[1]));
    for (int i = 0; i < 2; i++)
        h.ribbons[i].curve = h.curves[i];
    CHECK_OK(batten_surface_fill(2, h.ribbons, NULL, &h.report, h.patches));
    CHECK_INT(h.report.count, 4);
    CHECK_INT(h.report.outer[2].curve, 0);
    CHECK_INT(h.report.outer[3].curve, 1);
    CHECK_NEAR(hole_inner(&h).angle, 0, 1e-8);
    hole_free(&h);
}

TEST(N2_holes_of_any_size_are_filled_alike)
{
    static const double sizes[] = {1e-80, 1e-9, 1e9, 1e80};
    for (int k = 0; k < COUNT(sizes); k++) {
        hole h, plain;
        hole_on_paraboloid(5, uneven, 0.8, &plain);
        memset(&h, 0, sizeof h);
        const batten_affine map = batten_affine_scaling(sizes[k], sizes[k], sizes[k]);
        h.count = 5;
        for (int i = 0; i < 5; i++) {
            CHECK_OK(batten_curve_transform(plain.curves[i], &map, &h.curves[i]));
            CHECK_OK(batten_curve_transform(plain.slopes[i], &map, &h.slopes[i]));
            h.ribbons[i] = (batten_ribbon){h.curves[i], h.slopes[i], NULL};
        }
        CHECK_OK(batten_surface_fill(5, h.ribbons, NULL, &h.report, h.patches));
        for (int i = 0; i < 5; i++) {
            CHECK_NEAR(h.report.outer[i].gap / sizes[k], 0, 1e-13);
            CHECK_NEAR(h.report.outer[i].angle, 0, 1e-9);
            CHECK_NEAR(h.report.inner[i].angle, 0, 1e-9);
        }
        hole_free(&h);
        hole_free(&plain);
    }
}

TEST(G7_open_loops_and_ribbons_that_cannot_be_are_refused_by_name)
{
    hole h;
    batten_ribbon ribbons[9];
    hole_on_paraboloid(5, round_corners, 0.8, &h);
    CHECK_STATUS(batten_surface_fill(1, h.ribbons, NULL, NULL, h.patches), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a hole of 1 sides cannot be filled");
    CHECK_STATUS(batten_surface_fill(9, ribbons, NULL, NULL, h.patches), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_fill(4, h.ribbons, NULL, NULL, h.patches),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("is open by 1.1");
    memcpy(ribbons, h.ribbons, sizeof ribbons);
    ribbons[4] = ribbons[3];
    CHECK_STATUS(batten_surface_fill(5, ribbons, NULL, NULL, h.patches), BATTEN_COINCIDENT);
    ribbons[4] = h.ribbons[4];
    const batten_affine outwards = batten_affine_scaling(-1, -1, -1);
    batten_curve *out = NULL;
    CHECK_OK(batten_curve_transform(h.slopes[2], &outwards, &out));
    ribbons[2].slope = out;
    CHECK_STATUS(batten_surface_fill(5, ribbons, NULL, NULL, h.patches), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the ribbon of curve 3 points out of the hole");
    batten_surface_fill_options options = batten_surface_fill_defaults();
    options.tolerance = -1;
    CHECK_STATUS(batten_surface_fill(5, h.ribbons, &options, NULL, h.patches),
                 BATTEN_BAD_ARGUMENT);
    batten_curve_unref(out);
    hole_free(&h);
}

TEST(G5_a_ribbon_without_a_plane_is_refused)
{
    static const double side[2][3] = {{0, 0, 0}, {1, 0, 0}};
    static const double left[2][3] = {{1, 0, 0}, {0, 1, 0}},
                        right[2][3] = {{0, 1, 0}, {0, 0, 0}};
    static const double knots[4] = {0, 0, 1, 1}, none[2][3] = {{0}};
    hole h = {0};
    hole_add(&h, 1, side[0], 1, none[0]);
    hole_add(&h, 1, left[0], 0, NULL);
    hole_add(&h, 1, right[0], 0, NULL);
    CHECK_STATUS(batten_surface_fill(3, h.ribbons, NULL, NULL, h.patches),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the slope of the ribbon of curve 1 is zero");
    static const double along[2][3] = {{1, 0, 0}, {2, 0, 0}};
    batten_curve_unref(h.slopes[0]);
    h.slopes[0] = NULL;
    CHECK_OK(
        batten_curve_create((batten_points){3, 2, along[0]}, 1, NULL, knots, &h.slopes[0]));
    h.ribbons[0].slope = h.slopes[0];
    CHECK_STATUS(batten_surface_fill(3, h.ribbons, NULL, NULL, h.patches),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("its slope runs along the curve");
    hole_free(&h);
}

/* Sides, slopes and curvatures of z = 0.4 (x^2 + y^2) + 0.1 (x^3 - 3 x y^2) over a regular
 * polygon, exactly. */
static void add_curved_sides(int n, hole *h, batten_curve **curvatures)
{
    memset(h, 0, sizeof *h);
    for (int i = 0; i < n; i++) {
        const double ends[2] = {0, 1}, turn = 2 * 3.14159265358979323846 / n;
        const double a[2] = {cos(turn * i), sin(turn * i)};
        const double b[2] = {cos(turn * (i + 1)), sin(turn * (i + 1))};
        const double in[2] = {a[1] - b[1], b[0] - a[0]};
        const double d[2] = {b[0] - a[0], b[1] - a[1]};
        double curve[3][4][3], points[4][3];
        memset(curve, 0, sizeof curve);
        for (int k = 0; k < 4; k++) {
            const double t = k / 3.0, x = a[0] + t * d[0], y = a[1] + t * d[1];
            const double fx = 0.8 * x + 0.3 * (x * x - y * y), fy = 0.8 * y - 0.6 * x * y;
            const double fxx = 0.8 + 0.6 * x, fxy = -0.6 * y, fyy = 0.8 - 0.6 * x;
            const double z = 0.4 * (x * x + y * y) + 0.1 * (x * x * x - 3 * x * y * y);
            const double values[3][3] = {
                {x, y, z},
                {in[0], in[1], in[0] * fx + in[1] * fy},
                {0, 0, in[0] * in[0] * fxx + 2 * in[0] * in[1] * fxy + in[1] * in[1] * fyy}};
            for (int m = 0; m < 3; m++)
                memcpy(curve[m][k], values[m], sizeof values[m]);
        }
        for (int m = 0; m < 3; m++) {
            for (int c = 0; c < 3; c++) { /* the cubic through four values, in Bezier form */
                const double p = curve[m][0][c], q = curve[m][1][c], r = curve[m][2][c],
                             s = curve[m][3][c];
                points[0][c] = p;
                points[1][c] = (-5 * p + 18 * q - 9 * r + 2 * s) / 6;
                points[2][c] = (2 * p - 9 * q + 18 * r - 5 * s) / 6;
                points[3][c] = s;
            }
            batten_curve **to = m == 0   ? &h->curves[i]
                                : m == 1 ? &h->slopes[i]
                                         : &curvatures[i];
            CHECK_OK(
                batten_curve_from_bezier(3, (batten_pieces){3, 1, ends}, points[0], NULL, to));
        }
        h->ribbons[i] = (batten_ribbon){h->curves[i], h->slopes[i], curvatures[i]};
        h->count = i + 1;
    }
}

TEST(curvature_is_taken_over_along_the_sides)
{
    for (int n = 3; n <= 8; n++) {
        hole h;
        batten_curve *curvatures[8] = {NULL};
        batten_surface_fill_options options = batten_surface_fill_defaults();
        options.curvature = true;
        add_curved_sides(n, &h, curvatures);
        CHECK_OK(batten_surface_fill(n, h.ribbons, &options, &h.report, h.patches));
        CHECK(!h.report.folded);
        CHECK_NEAR(hole_inner(&h).angle, 0, 1e-8);
        for (int i = 0; i < n; i++) {
            const batten_fill_edge *outer = &h.report.outer[i], *inner = &h.report.inner[i];
            CHECK(outer->has_curvature && inner->has_curvature);
            CHECK_NEAR(outer->gap, 0, 1e-13);
            CHECK_NEAR(outer->angle * TESTS_DEGREES, 0, 1e-8);
            CHECK_NEAR(outer->curvature, 0, 5e-4);
            CHECK_NEAR(inner->curvature, 0, 0.05);
        }
        hole_free(&h);
        for (int i = 0; i < n; i++)
            batten_curve_unref(curvatures[i]);
    }
}

TEST(K6_a_knot_of_a_side_next_to_its_middle_leaves_no_sliver)
{
    hole h, plain;
    hole_on_paraboloid(5, uneven, 0.8, &plain);
    hole_on_paraboloid(5, uneven, 0.8, &h);
    batten_curve *side = NULL, *slope = NULL;
    CHECK_OK(batten_curve_insert_knot(h.curves[1], 0.5 + DBL_EPSILON, 1, &side));
    CHECK_OK(batten_curve_insert_knot(h.slopes[1], 0.5 - DBL_EPSILON, 1, &slope));
    h.ribbons[1] = (batten_ribbon){side, slope, NULL};
    CHECK_OK(batten_surface_fill(5, plain.ribbons, NULL, &plain.report, plain.patches));
    CHECK_OK(batten_surface_fill(5, h.ribbons, NULL, &h.report, h.patches));
    for (int i = 0; i < 5; i++) {
        double p[3], q[3], n[3];
        hole_see(plain.patches[i], 0.4, 0.6, p, n);
        hole_see(h.patches[i], 0.4, 0.6, q, n);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(p[c], q[c], 1e-12);
        CHECK_INT(batten_surface_point_count(h.patches[i], BATTEN_U),
                  batten_surface_point_count(plain.patches[i], BATTEN_U));
    }
    batten_curve_unref(side);
    batten_curve_unref(slope);
    hole_free(&h);
    hole_free(&plain);
}

/* A quarter of a circle in space, turned about z; rational. */
static batten_curve *quarter_circle(int i)
{
    const double ends[2] = {0, 1}, weights[3] = {1, sqrt(0.5), 1};
    static const double corners[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    batten_curve *curve = NULL;
    double points[3][3] = {{0}};
    for (int c = 0; c < 2; c++) {
        points[0][c] = corners[i][c];
        points[2][c] = corners[i + 1][c];
        points[1][c] = corners[i][c] + corners[i + 1][c];
    }
    CHECK_OK(
        batten_curve_from_bezier(3, (batten_pieces){2, 1, ends}, points[0], weights, &curve));
    return curve;
}

TEST(G5_a_round_hole_is_filled_though_its_corners_have_no_normal)
{
    static const double up[2][3] = {{0, 0, 1}, {0, 0, 1}}, knots[4] = {0, 0, 1, 1};
    for (int dome = 0; dome < 2; dome++) {
        hole h = {0};
        h.count = 4;
        for (int i = 0; i < 4; i++) {
            h.curves[i] = quarter_circle(i);
            if (dome)
                CHECK_OK(batten_curve_create((batten_points){3, 2, up[0]}, 1, NULL, knots,
                                             &h.slopes[i]));
            h.ribbons[i] = (batten_ribbon){h.curves[i], h.slopes[i], NULL};
        }
        CHECK_OK(batten_surface_fill(4, h.ribbons, NULL, &h.report, h.patches));
        CHECK_INT(h.report.flat_corners, 4);
        CHECK(!h.report.folded);
        CHECK_NEAR(hole_inner(&h).angle, 0, 1e-7);
        double top[3], normal[3];
        hole_see(h.patches[0], 1, 1, top, normal);
        CHECK_NEAR(hypot(top[0], top[1]), 0, 1e-6);
        /* upright ribbons are left at the usual speed: the top is about half a ball's */
        CHECK(dome ? top[2] > 0.2 && top[2] < 1 : fabs(top[2]) < 1e-9);
        CHECK(normal[2] > 0);
        for (int i = 0; dome && i < 4; i++)
            CHECK_NEAR(h.report.outer[i].angle * TESTS_DEGREES, 0, 0.01);
        hole_free(&h);
    }
}

TEST(S5_a_fill_that_would_be_too_large_is_refused_before_the_work)
{
    hole h;
    enum { MANY = 5000 };
    double *knots = test_array(MANY, sizeof *knots);
    batten_ribbon ribbons[5];
    batten_curve *fine[2] = {NULL};
    hole_on_paraboloid(5, uneven, 0.8, &h);
    memcpy(ribbons, h.ribbons, sizeof ribbons);
    for (int k = 0; k < MANY; k++)
        knots[k] = (k + 1.0) / (MANY + 1);
    for (int i = 0; i < 2; i++) {
        CHECK_OK(batten_curve_refine(h.curves[i], MANY, knots, &fine[i]));
        ribbons[i].curve = fine[i];
    }
    CHECK_STATUS(batten_surface_fill(5, ribbons, NULL, NULL, h.patches), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("between curves 1 and 2 would have more than 2502 x 2502 control points");
    batten_curve_unref(fine[0]);
    batten_curve_unref(fine[1]);
    hole_free(&h);
}
