#include "shape/boundary/coons_formula.h"

#include "support/faults.h"

static batten_curve *bow(const double *a, const double *b, double rise)
{
    const double points[] = {a[0], a[1], 0, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, rise,
                             b[0], b[1], 0};
    const double knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &curve));
    return curve;
}

static void release(batten_curve **curves, int count)
{
    for (int i = 0; i < count; i++)
        batten_curve_unref(curves[i]);
}

static void make_patch(batten_curve *const *sides, batten_surface **out)
{
    batten_ribbon ribbons[4];
    for (int e = 0; e < 4; e++)
        ribbons[e] = (batten_ribbon){sides[e], NULL, NULL};
    CHECK_OK(batten_surface_coons(ribbons, NULL, NULL, out));
}

TEST(six_curves_in_any_order_and_direction_make_four_sides)
{
    static const double at[6][2] = {{0, 0}, {3, 0}, {4, 0}, {5, 3}, {2, 4}, {-1, 3}};
    static const int order[6] = {0, 4, 2, 5, 1, 3}, counts[4] = {2, 1, 2, 1};
    batten_curve *curves[6], *sides[4];
    for (int i = 0; i < 6; i++) {
        const double *a = at[order[i]], *b = at[(order[i] + 1) % 6];
        curves[i] = i % 3 == 1 ? bow(b, a, 0.2 * i) : bow(a, b, 0.2 * i);
    }
    batten_loop_place places[6];
    const batten_curve *const *given = (const batten_curve *const *)curves;
    CHECK_EACH_ALLOCATION(batten_boundary_sides(6, given, counts, 1e-9, places, sides));
    for (int k = 0; k < 6; k++)
        CHECK_INT(order[places[k].curve], k);
    /* v = 0 from (0, 0) to (4, 0) over (3, 0), where its knot is at the share of the lengths.
     */
    static const double ends[4][4] = {{0, 0, 4, 0}, {4, 0, 5, 3}, {-1, 3, 5, 3}, {0, 0, -1, 3}};
    for (int e = 0; e < 4; e++)
        for (int k = 0; k < 2; k++) {
            double out[3];
            CHECK_OK(batten_curve_evaluate(sides[e], k, 0, out));
            CHECK_NEAR(out[0], ends[e][2 * k], 1e-14);
            CHECK_NEAR(out[1], ends[e][2 * k + 1], 1e-14);
        }
    double spans[8];
    CHECK_INT(batten_curve_spans(sides[0], spans), 3);
    CHECK(spans[1] > 0.65 && spans[1] < 0.7);
    batten_surface *surface = NULL, *nurbs = NULL;
    make_patch(sides, &surface);
    CHECK_OK(batten_surface_to_nurbs(surface, 0, NULL, &nurbs));
    CHECK_NEAR(apart(surface, nurbs, 40, 0, 0, false), 0, 1e-13);
    batten_surface_unref(nurbs);
    batten_surface_unref(surface);
    release(sides, 4);

    static const int wrong[4] = {2, 1, 1, 1}, empty[4] = {0, 2, 2, 2};
    CHECK_STATUS(batten_boundary_sides(6, given, wrong, 1e-9, NULL, sides),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("2 + 1 + 1 + 1 curves of 6");
    CHECK_STATUS(batten_boundary_sides(6, given, empty, 1e-9, NULL, sides),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_boundary_sides(6, given, NULL, 1e-9, NULL, sides), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the number on each side is given");
    release(curves, 6);
}

TEST(G5_three_curves_make_a_patch_with_a_pole_and_two_one_with_two)
{
    static const double at[3][2] = {{0, 0}, {4, 0}, {1, 3}};
    batten_curve *curves[3], *sides[4];
    batten_surface *surface = NULL;
    for (int i = 0; i < 3; i++)
        curves[i] = bow(at[i], at[(i + 1) % 3], 0.3 + i);
    CHECK_OK(
        batten_boundary_sides(3, (const batten_curve *const *)curves, NULL, 1e-9, NULL, sides));
    make_patch(sides, &surface);
    batten_vec3 normal;
    bool is_limit = false;
    for (int i = 0; i <= 4; i++) {
        double out[3];
        CHECK_OK(batten_surface_evaluate(surface, 0, i / 4.0, 0, out));
        CHECK(out[0] == 0 && out[1] == 0 && out[2] == 0);
    }
    CHECK_OK(batten_surface_normal(surface, 0.5, 0.5, &is_limit, &normal));
    CHECK(!is_limit);
    batten_surface_unref(surface);
    release(sides, 4);
    batten_curve *two[2] = {bow(at[0], at[1], 1), bow(at[0], at[1], -1)};
    CHECK_OK(
        batten_boundary_sides(2, (const batten_curve *const *)two, NULL, 1e-9, NULL, sides));
    make_patch(sides, &surface);
    batten_surface_unref(surface);
    release(sides, 4);
    release(two, 2);
    release(curves, 3);
}

/* Four curves of a pocket, as its file has them: `count`, then degree, knots, points. */
static int read_loop(const char *path, batten_curve **curves, int most)
{
    int count = 0;
    FILE *file = fopen(path, "r");
    CHECK(file && fscanf(file, "%d", &count) == 1 && count <= most);
    for (int c = 0; c < count; c++) {
        int degree = 0, knot_count = 0, point_count = 0;
        double knots[64] = {0}, points[64 * 3] = {0};
        CHECK(fscanf(file, "%d %d", &degree, &knot_count) == 2 && knot_count <= 64);
        for (int i = 0; i < knot_count; i++)
            CHECK(fscanf(file, "%lf", &knots[i]) == 1);
        CHECK(fscanf(file, "%d", &point_count) == 1 && point_count <= 64);
        for (int i = 0; i < 3 * point_count; i++)
            CHECK(fscanf(file, "%lf", &points[i]) == 1);
        CHECK_INT(knot_count, point_count + degree + 1);
        curves[c] = NULL;
        CHECK_OK(batten_curve_create((batten_points){3, point_count, points}, degree, NULL,
                                     knots, &curves[c]));
    }
    fclose(file);
    return count;
}

TEST(a_pocket_with_four_sides_is_filled_through_all_its_curves)
{
    batten_curve *curves[4], *sides[4];
    CHECK_INT(read_loop(test_data("patches/pocket4sided.lop"), curves, 4), 4);
    batten_loop_place places[4];
    CHECK_EACH_ALLOCATION(batten_boundary_sides(4, (const batten_curve *const *)curves, NULL,
                                                1e-4, places, sides));
    batten_surface *surface = NULL, *nurbs = NULL;
    make_patch(sides, &surface);
    CHECK_OK(batten_surface_to_nurbs(surface, 0, NULL, &nurbs));
    double worst = 0;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i <= 100; i++) {
            const double t = i / 100.0;
            double p[3], q[3];
            const int e = places[c].curve == c ? c : -1;
            CHECK(e >= 0);
            const bool back = places[c].reversed != (e >= 2);
            CHECK_OK(batten_curve_evaluate(curves[c], t, 0, p));
            const double s = back ? 1 - t : t;
            CHECK_OK(
                batten_surface_evaluate(nurbs, e % 2 ? e == 1 : s, e % 2 ? s : e == 2, 0, q));
            for (int x = 0; x < 3; x++)
                worst = fmax(worst, fabs(p[x] - q[x]));
        }
    CHECK_NEAR(worst, 0, 1e-12 * 180);
    CHECK_NEAR(apart(surface, nurbs, 100, 0, 0, false), 0, 1e-12 * 180);
    batten_surface_unref(nurbs);
    batten_surface_unref(surface);
    release(sides, 4);
    release(curves, 4);
}

/* ---- beside other surfaces ---- */

/* Sine of the angle between the normals of patch and neighbour, largest along the patch's edge
 * v = 0, which is the neighbour's `edge` between a and b. */
static double kink(const batten_surface *patch, const batten_surface *neighbour, double a,
                   double b, double far)
{
    double worst = 0;
    for (int i = 0; i <= 40; i++) {
        const double t = i / 40.0;
        double p[9], q[9], n[3], m[3];
        CHECK_OK(batten_surface_evaluate(patch, t, 0, 1, p));
        CHECK_OK(batten_surface_evaluate(neighbour, 1, a + (b - a) * t, 1, q));
        for (int x = 0; x < 3; x++) {
            CHECK_NEAR(p[x], q[x], far);
            const int y = (x + 1) % 3, z = (x + 2) % 3;
            n[x] = p[3 + y] * p[6 + z] - p[3 + z] * p[6 + y];
            m[x] = q[3 + y] * q[6 + z] - q[3 + z] * q[6 + y];
        }
        double nn = 0, mm = 0, cross = 0;
        for (int x = 0; x < 3; x++) {
            const int y = (x + 1) % 3, z = (x + 2) % 3;
            nn += n[x] * n[x];
            mm += m[x] * m[x];
            cross += pow(n[y] * m[z] - n[z] * m[y], 2);
        }
        worst = fmax(worst, sqrt(cross / (nn * mm)));
    }
    return worst;
}

/* A patch beyond the edge u = 1 of a surface, between b and a along it, with sides that leave
 * it in its tangent planes at an angle. */
static void beside(const batten_surface *surface, double a, double b, batten_curve *curves[4])
{
    double tip[2][3];
    for (int k = 0; k < 2; k++) {
        double out[9], points[12];
        static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
        CHECK_OK(batten_surface_evaluate(surface, 1, k ? b : a, 1, out));
        for (int x = 0; x < 3; x++) {
            const double leave = (k ? 0.5 : 0.8) * out[3 + x] + (k ? 0.05 : -0.1) * out[6 + x];
            points[x] = out[x];
            points[3 + x] = out[x] + leave / 3;
            points[6 + x] = out[x] + leave + (x == 2 ? 0.3 : 0);
            points[9 + x] = tip[k][x] = out[x] + 1.4 * leave + (x == 2 ? 0.5 : 0);
        }
        curves[k ? 1 : 3] = NULL;
        CHECK_OK(batten_curve_create((batten_points){3, 4, points}, 3, NULL, knots,
                                     &curves[k ? 1 : 3]));
    }
    curves[2] = bow(tip[0], tip[1], 0);
    double points[9];
    for (int x = 0; x < 3; x++) {
        points[x] = tip[0][x];
        points[3 + x] = (tip[0][x] + tip[1][x]) / 2 + (x == 2 ? 0.1 : 0);
        points[6 + x] = tip[1][x];
    }
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve_unref(curves[2]);
    curves[2] = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &curves[2]));
}

static void check_join(const batten_surface *surface, double a, double b, double tolerance)
{
    batten_curve *curves[4], *edge = NULL, *part = NULL, *ribbon[2] = {NULL, NULL};
    double ends[6], misfit[2] = {1, 1}, error = 1;
    beside(surface, a, b, curves);
    CHECK_OK(batten_surface_isocurve(surface, BATTEN_U, 1, &edge));
    CHECK_OK(batten_curve_subrange(edge, a, b, &part));
    for (int k = 0; k < 2; k++) {
        double out[6];
        CHECK_OK(batten_curve_evaluate(curves[k ? 1 : 3], 0, 1, out));
        memcpy(ends + 3 * k, out + 3, 3 * sizeof *ends);
    }
    CHECK_EACH_ALLOCATION(batten_ribbon_along(
        surface, part, (batten_ribbon_wish){1, ends, 1e-6}, misfit, &error, ribbon));
    CHECK_NEAR(misfit[0], 0, 1e-9);
    CHECK_NEAR(misfit[1], 0, 1e-9);
    const batten_ribbon sides[4] = {{ribbon[0], ribbon[1], NULL},
                                    {curves[1], NULL, NULL},
                                    {curves[2], NULL, NULL},
                                    {curves[3], NULL, NULL}};
    batten_surface_coons_options options = batten_surface_coons_defaults();
    batten_surface_coons_report report;
    batten_surface *patch = NULL;
    options.order = 2;
    options.blending_u = options.blending_v = BATTEN_BLENDING_CUBIC;
    CHECK_OK(batten_surface_coons(sides, &options, &report, &patch));
    CHECK_NEAR(report.slope_gap, 0, 1e-6);
    CHECK_NEAR(kink(patch, surface, a, b, fmin(1e-6, fmax(1e-12, tolerance))), 0, tolerance);
    batten_surface_unref(patch);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(ribbon[k]);
    batten_curve_unref(part);
    batten_curve_unref(edge);
    curves[0] = NULL;
    release(curves, 4);
}

TEST(a_patch_along_an_edge_or_a_part_of_it_has_the_tangent_planes_of_its_neighbour)
{
    test_random random = test_random_begin("along");
    batten_surface *surface = bumpy(&random, 3, 3, 2, 2);
    check_join(surface, 0, 1, 1e-12);
    check_join(surface, 0.2, 0.7, 1e-9);
    batten_surface_unref(surface);
}

TEST(a_rational_neighbour_is_met_within_a_tolerance)
{
    test_random random = test_random_begin("rational");
    batten_surface *surface = bumpy(&random, 2, 2, 1, 2), *rational = NULL;
    double weights[64];
    const int n = batten_surface_point_count(surface, BATTEN_U);
    const int m = batten_surface_point_count(surface, BATTEN_V);
    for (int i = 0; i < n * m; i++)
        weights[i] = test_random_in(&random, 0.7, 1.4);
    const batten_axis u = {2, n, batten_surface_knots(surface, BATTEN_U), false};
    const batten_axis v = {2, m, batten_surface_knots(surface, BATTEN_V), false};
    CHECK_OK(
        batten_surface_create(3, &u, &v, batten_surface_points(surface), weights, &rational));
    check_join(rational, 0, 1, 1e-4);
    batten_surface_unref(rational);
    batten_surface_unref(surface);
}

TEST(surfaces_that_are_not_beside_a_curve_are_told)
{
    test_random random = test_random_begin("far");
    batten_surface *surface = bumpy(&random, 3, 3, 2, 2);
    const double a[] = {4, 4}, b[] = {5, 4}, ends[6] = {0, 1, 0, 0, 1, 0};
    batten_curve *curve = bow(a, b, 1), *ribbon[2];
    CHECK_STATUS(batten_ribbon_along(surface, curve, (batten_ribbon_wish){1, ends, 1e-6}, NULL,
                                     NULL, ribbon),
                 BATTEN_NOT_FOUND);
    CHECK_MESSAGE("no edge of the surface runs along the curve");
    CHECK_STATUS(batten_ribbon_along(surface, curve, (batten_ribbon_wish){1, ends, 0}, NULL,
                                     NULL, ribbon),
                 BATTEN_BAD_ARGUMENT);
    batten_curve_unref(curve);
    batten_surface_unref(surface);
}

/* A surface cut in two: from one half's edge, and the other three sides of the other half, the
 * third kind makes what has the curvatures of both. */
TEST(curvatures_along_a_neighbour_are_its_own)
{
    test_random random = test_random_begin("curvature");
    batten_surface *whole = bumpy(&random, 5, 4, 1, 2), *low = NULL, *high = NULL,
                   *patch = NULL;
    CHECK_OK(batten_surface_split(whole, BATTEN_U, 0.5, &low, &high));
    frame_of_surface frame;
    frame_surface(high, &frame);
    /* The patch runs over [0, 1] in u, the half over [0.5, 1]. */
    double ends[6];
    batten_curve *ribbon[3] = {NULL, NULL, NULL};
    for (int k = 0; k < 2; k++) {
        double out[6];
        CHECK_OK(batten_curve_evaluate(frame.curves[k ? 2 : 0][0], 0.5, 1, out));
        for (int x = 0; x < 3; x++)
            ends[3 * k + x] = out[3 + x] / 2;
    }
    double misfit[2], error = 1;
    CHECK_EACH_ALLOCATION(batten_ribbon_along(
        low, frame.curves[3][0], (batten_ribbon_wish){2, ends, 1e-9}, misfit, &error, ribbon));
    CHECK(error == 0);
    const batten_ribbon sides[4] = {{frame.curves[0][0], NULL, NULL},
                                    {frame.curves[1][0], NULL, NULL},
                                    {frame.curves[2][0], NULL, NULL},
                                    {ribbon[0], ribbon[1], ribbon[2]}};
    batten_surface_coons_options options = batten_surface_coons_defaults();
    batten_surface_coons_report report;
    options.order = 3;
    options.blending_u = options.blending_v = BATTEN_BLENDING_QUINTIC;
    CHECK_OK(batten_surface_coons(sides, &options, &report, &patch));
    CHECK_NEAR(report.slope_gap + report.higher_gap, 0, 1e-11);
    for (int i = 0; i <= 20; i++) {
        double p[18], q[18];
        CHECK_OK(batten_surface_evaluate(patch, 0, i / 20.0, 2, p));
        CHECK_OK(batten_surface_evaluate(whole, 0.5, i / 20.0, 2, q));
        for (int x = 0; x < 3; x++) {
            CHECK_NEAR(p[3 + x], q[3 + x] / 2, 1e-12);
            CHECK_NEAR(p[9 + x], q[9 + x] / 4, 1e-10);
            CHECK_NEAR(p[12 + x], q[12 + x] / 2, 1e-10);
        }
    }
    batten_surface_unref(patch);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(ribbon[k]);
    frame_release(&frame);
    batten_surface_unref(low);
    batten_surface_unref(whole);
}
