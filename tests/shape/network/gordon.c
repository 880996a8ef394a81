#include "shape/network/networks.h"

#include "base/base.h"
#include <batten/continuity.h>
#include <batten/nearest.h>
#include <batten/skin.h>
#include <batten/standard.h>

/* The farthest that points of the known surface are from the made one. */
static double distance_from(surface_at at, const batten_surface *surface)
{
    enum { SIDE = 13 };
    double points[SIDE * SIDE * 3];
    batten_deviation found;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++)
            at(i / (SIDE - 1.0), j / (SIDE - 1.0), points + 3 * (i * SIDE + j));
    CHECK_OK(batten_surface_deviation(surface, (batten_points){3, SIDE * SIDE, points}, NULL,
                                      NULL, NULL, &found));
    return found.max;
}

/* The farthest that places of a curve are from the surface, wherever it is nearest. */
static double curve_off(const batten_curve *curve, const batten_surface *surface)
{
    double points[3 * 41];
    batten_deviation found;
    const batten_interval domain = batten_curve_domain(curve);
    for (int i = 0; i <= 40; i++)
        CHECK_OK(batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * (i / 40.0), 0,
                                       points + 3 * i));
    CHECK_OK(batten_surface_deviation(surface, (batten_points){3, 41, points}, NULL, NULL, NULL,
                                      &found));
    return found.max;
}

/* Is the deviation that is reported true of every curve? */
static void check_curves(const network *n, const batten_surface *surface,
                         const batten_surface_gordon_report *report)
{
    for (int f = 0; f < 2; f++)
        for (int k = 0; k < n->count[f]; k++)
            CHECK(curve_off(n->curves[f][k], surface) <= report->error * 1.02 + 1e-12);
}

/* ---- what is exact ---- */

TEST(a_bicubic_polynomial_comes_back_exactly_from_its_net)
{
    network n = network_on(bicubic, 4, 5, 9, 0);
    const batten_surface_gordon_options options = within(1e-6);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.exact_u && report.exact_v);
    CHECK(report.error < 1e-14);
    CHECK(report.node_error < 1e-14);
    for (int i = 0; i <= 10; i++)
        for (int j = 0; j <= 10; j++) {
            double wanted[3], found[3];
            bicubic(i / 10.0, j / 10.0, wanted);
            CHECK_OK(batten_surface_evaluate(surface, i / 10.0, j / 10.0, 0, found));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(found[c], wanted[c], 1e-13);
        }
    batten_surface_unref(surface);
    network_end(&n);
}

/* With two curves each way and straight cardinal functions it is Coons' surface. */
TEST(four_curves_make_the_bilinear_surface_of_Coons)
{
    network n = network_on(shell, 2, 2, 20, 0);
    const batten_surface_gordon_options options = within(1e-5);
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, NULL, &surface));
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 8; j++) {
            const double u = i / 8.0, v = j / 8.0;
            double c[2][3], d[2][3], corners[2][2][3], found[3];
            for (int k = 0; k < 2; k++) {
                CHECK_OK(batten_curve_evaluate(n.curves[0][k], u, 0, c[k]));
                CHECK_OK(batten_curve_evaluate(n.curves[1][k], v, 0, d[k]));
                for (int l = 0; l < 2; l++)
                    shell(k, l, corners[k][l]);
            }
            CHECK_OK(batten_surface_evaluate(surface, u, v, 0, found));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(found[k],
                           (1 - v) * c[0][k] + v * c[1][k] + (1 - u) * d[0][k] + u * d[1][k] -
                               (1 - u) * ((1 - v) * corners[0][0][k] + v * corners[0][1][k]) -
                               u * ((1 - v) * corners[1][0][k] + v * corners[1][1][k]),
                           1e-13);
        }
    batten_surface_unref(surface);
    network_end(&n);
}

TEST(a_finer_net_is_nearer_to_the_surface_it_lies_on)
{
    double last = 1;
    for (int count = 4; count <= 8; count += 4) {
        network n = network_on(shell, count, count, 40, 0);
        const batten_surface_gordon_options options = within(1e-7);
        batten_surface *surface = NULL;
        CHECK_OK(gordon(&n, &options, NULL, &surface));
        const double here = distance_from(shell, surface);
        CHECK(here < last / 8);
        last = here;
        batten_surface_unref(surface);
        network_end(&n);
    }
    CHECK(last < 1e-5);
}

/* ---- speeds, order and directions of their own ---- */

TEST(curves_of_any_speed_are_reparametrised_within_the_tolerance)
{
    network n = network_on(shell, 5, 6, 40, 0.6);
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.spread > 0.05);
    CHECK(!report.exact_u && !report.exact_v);
    CHECK(report.error <= 1e-3);
    CHECK(report.node_error < 1e-14);
    CHECK(report.points_u < 40 && report.points_v < 40);
    CHECK(distance_from(shell, surface) < 5e-3);
    check_curves(&n, surface, &report);
    batten_surface_unref(surface);
    network_end(&n);
}

TEST(K7_curves_with_knots_of_their_own_make_no_heavy_surface)
{
    network n = {{6, 5}, {{NULL}}};
    for (int f = 0; f < 2; f++)
        for (int k = 0; k < n.count[f]; k++)
            n.curves[f][k] = draw(shell, (drawn){f, k / (n.count[f] - 1.0), 0, 1,
                                                 k % 2 ? 0.3 : -0.2, 23 + 2 * k});
    const batten_surface_gordon_options options = within(1e-4);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.exact_knots_u > 100 && report.exact_knots_v > 80);
    CHECK(report.points_u <= 40 && report.points_v <= 40);
    check_curves(&n, surface, &report);
    batten_surface_unref(surface);
    network_end(&n);
}

TEST(G7_shuffled_and_reversed_curves_make_the_same_surface)
{
    network n = network_on(shell, 5, 4, 20, 0), other = n;
    const int order[2][5] = {{0, 3, 1, 4, 2}, {0, 2, 3, 1, 0}};
    for (int f = 0; f < 2; f++)
        for (int k = 0; k < n.count[f]; k++) {
            const batten_curve *from = n.curves[f][order[f][k]];
            if (k % 2 == 1)
                CHECK_OK(batten_curve_reverse(from, &other.curves[f][k]));
            else
                other.curves[f][k] = batten_curve_ref(from);
        }
    const batten_surface_gordon_options options = within(1e-6);
    batten_surface_gordon_report report;
    batten_surface *first = NULL, *second = NULL;
    CHECK_OK(gordon(&n, &options, NULL, &first));
    CHECK_OK(gordon(&other, &options, &report, &second));
    CHECK_INT(report.reversed_count, 4);
    for (int i = 0; i <= 6; i++)
        for (int j = 0; j <= 6; j++) {
            double a[3], b[3];
            CHECK_OK(batten_surface_evaluate(first, i / 6.0, j / 6.0, 0, a));
            CHECK_OK(batten_surface_evaluate(second, i / 6.0, j / 6.0, 0, b));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(a[c], b[c], 1e-9);
        }
    batten_surface_unref(second);
    batten_surface_unref(first);
    network_end(&other);
    network_end(&n);
}

TEST(the_other_cardinal_functions_meet_the_curves_too)
{
    network n = network_on(shell, 4, 5, 16, 0);
    for (int blend = BATTEN_GORDON_LINEAR; blend <= BATTEN_GORDON_LAGRANGE; blend++) {
        batten_surface_gordon_options options = within(1e-3);
        options.blend = (batten_gordon_blend)blend;
        batten_surface_gordon_report report;
        batten_surface *surface = NULL;
        CHECK_OK(gordon(&n, &options, &report, &surface));
        check_curves(&n, surface, &report);
        CHECK(report.error <= 1e-3);
        batten_surface_unref(surface);
    }
    network_end(&n);
}

/* ---- closed networks ---- */

/* A tube whose profiles begin anywhere. */
static network closed_network(surface_at at, int profiles, int guides, bool both)
{
    network n = {{profiles, guides}, {{NULL}}};
    for (int k = 0; k < profiles; k++) {
        const double from = 0.13 * k * k, turn = k % 3 == 1 ? -1 : 1;
        n.curves[0][k] =
            draw(at, (drawn){0, k / (profiles - (both ? 0.0 : 1.0)), from, from + turn, 0, 60});
    }
    for (int k = 0; k < guides; k++) {
        const double from = both ? 0.07 * k : 0;
        n.curves[1][k] = draw(at, (drawn){1, k / (double)guides, from, from + 1, 0, 60});
    }
    return n;
}

/* Both sides of the seam: points, and derivatives across up to the second. */
static void check_seam(const batten_surface *surface, bool along_u, double tolerance)
{
    for (int i = 0; i <= 10; i++) {
        double sides[2][18];
        const double s = i / 10.0;
        for (int k = 0; k < 2; k++) {
            const batten_side side = k ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
            CHECK_OK(
                batten_surface_evaluate_side(surface, along_u ? k : s, along_u ? s : k,
                                             (batten_sides){along_u ? side : BATTEN_FROM_RIGHT,
                                                            along_u ? BATTEN_FROM_RIGHT : side},
                                             2, sides[k]));
        }
        for (int c = 0; c < 18; c++)
            CHECK_NEAR(sides[0][c], sides[1][c], c < 3 ? 1e-13 : tolerance);
    }
}

TEST(G6_closed_profiles_may_begin_anywhere_and_the_surface_closes_smoothly)
{
    network n = closed_network(tube, 5, 6, false);
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.closed_u && report.smooth_u && !report.closed_v);
    CHECK(batten_surface_is_periodic(surface, BATTEN_U));
    CHECK(batten_surface_is_closed(surface, BATTEN_U, 1e-12));
    check_seam(surface, true, 1e-7);
    check_curves(&n, surface, &report);
    CHECK(distance_from(tube, surface) < 1e-2);
    batten_surface_unref(surface);
    network_end(&n);
}

TEST(a_net_may_close_both_ways)
{
    network n = closed_network(torus, 7, 6, true);
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.smooth_u && report.smooth_v);
    CHECK(batten_surface_is_periodic(surface, BATTEN_U) &&
          batten_surface_is_periodic(surface, BATTEN_V));
    check_seam(surface, true, 1e-6);
    check_seam(surface, false, 1e-6);
    CHECK(distance_from(torus, surface) < 0.05);
    batten_surface_unref(surface);
    network_end(&n);
}

TEST(closed_profiles_with_two_guides_and_with_one_that_is_given_twice)
{
    for (int guides = 2; guides <= 3; guides++) {
        network n = closed_network(tube, 4, 2, false);
        n.count[1] = guides;
        if (guides == 3)
            CHECK_OK(batten_curve_reverse(n.curves[1][0], &n.curves[1][2]));
        const batten_surface_gordon_options options = within(2e-3);
        batten_surface_gordon_report report;
        batten_surface *surface = NULL;
        CHECK_OK(gordon(&n, &options, &report, &surface));
        CHECK_INT(report.repeated_count, guides - 2);
        CHECK(report.smooth_u);
        check_curves(&n, surface, &report);
        check_seam(surface, true, 1e-6);
        batten_surface_unref(surface);
        network_end(&n);
    }
}

TEST(closed_profiles_with_one_guide)
{
    network n = closed_network(tube, 4, 1, false);
    const batten_surface_gordon_options options = within(2e-3);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.closed_u && report.smooth_u);
    check_curves(&n, surface, &report);
    check_seam(surface, true, 1e-6);
    batten_surface_unref(surface);
    network_end(&n);
}

/* A wing whose trailing edge is blunt at the root and sharp at the tip, where the profile
 * closes. */
static void wing(double u, double v, double *p)
{
    const double turn = 4 * acos(0) * u, blunt = 0.04 * (1 - v) * (2 * u - 1);
    p[0] = (1 - 0.4 * v) * (1 + cos(turn)) / 2 + 0.5 * v;
    p[1] = 3 * v;
    p[2] = 0.1 * sin(turn) * (1.5 - cos(turn)) - blunt;
}

TEST(a_closed_profile_may_stand_among_open_ones)
{
    for (int backward = 0; backward < 2; backward++) {
        network n = network_on(wing, 4, 3, 60, 0.1);
        if (backward) {
            batten_curve *reversed = NULL;
            CHECK_OK(batten_curve_reverse(n.curves[0][3], &reversed));
            batten_curve_unref(n.curves[0][3]);
            n.curves[0][3] = reversed;
        }
        const batten_surface_gordon_options options = within(1e-3);
        batten_surface_gordon_report report;
        batten_surface *surface = NULL;
        CHECK_OK(gordon(&n, &options, &report, &surface));
        CHECK(!report.closed_u);
        CHECK_INT(report.reversed_count, backward);
        CHECK(distance_from(wing, surface) < 0.02);
        batten_surface_unref(surface);
        network_end(&n);
    }
}

/* ---- poles ---- */

static network meridians_and_parallels(int meridians, int parallels)
{
    network n = {{parallels, meridians}, {{NULL}}};
    for (int k = 0; k < parallels; k++)
        n.curves[0][k] =
            draw(globe, (drawn){0, (k + 1.0) / (parallels + 1), 0.1 * k, 0.1 * k + 1, 0, 50});
    for (int k = 0; k < meridians; k++)
        n.curves[1][k] = draw(globe, (drawn){1, k / (double)meridians, 0, 1, 0, 50});
    return n;
}

TEST(G5_guides_that_end_in_a_point_make_poles)
{
    network n = meridians_and_parallels(8, 3);
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK_INT(report.pole_count, 2);
    CHECK(distance_from(globe, surface) < 5e-3);
    const int across = batten_surface_point_count(surface, BATTEN_V);
    const double *P = batten_surface_points(surface);
    for (int i = 0; i < batten_surface_point_count(surface, BATTEN_U); i++)
        for (int c = 0; c < 3; c++) {
            CHECK_BITS(P[3 * i * across + c], P[c]);
            CHECK_BITS(P[3 * (i * across + across - 1) + c], P[3 * (across - 1) + c]);
        }
    /* The tangents in the pole lie in a plane only within the tolerance: so the normal there
     * has a limit only then, and nearby it is that of the globe. */
    const double u[] = {0, 0.3, 0.7}, v[] = {0, 1e-3, 0.999, 1};
    double normals[12 * 3];
    CHECK_OK(
        batten_surface_normal_grid(surface, (batten_uv_grid){3, 4, u, v}, NULL, NULL, normals));
    for (int i = 0; i < 12; i++) {
        for (int c = 0; c < 3; c++)
            CHECK(isfinite(normals[3 * i + c]));
        if (i % 4 == 1 || i % 4 == 2)
            CHECK_NEAR(fabs(normals[3 * i + 2]), 1, 1e-3);
    }
    batten_surface_unref(surface);
    network_end(&n);
}

TEST(a_profile_may_be_a_point)
{
    network n = meridians_and_parallels(6, 3);
    const double pole[] = {0, 0, -1, 0, 0, -1}, knots[] = {0, 0, 1, 1};
    n.count[0] = 4;
    CHECK_OK(batten_curve_create((batten_points){3, 2, pole}, 1, NULL, knots, &n.curves[0][3]));
    const batten_surface_gordon_options options = within(2e-3);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK_INT(report.pole_count, 1); /* that of the other end */
    check_curves(&n, surface, &report);
    batten_surface_unref(surface);
    network_end(&n);
}

/* ---- what does not fit ---- */

TEST(curves_that_go_on_are_cut_or_refused)
{
    network n = network_on(shell, 3, 3, 30, 0);
    batten_curve_unref(n.curves[0][1]);
    n.curves[0][1] = draw(shell, (drawn){0, 0.5, -0.2, 1.1, 0, 40});
    batten_surface_gordon_options options = within(1e-4);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK_INT(report.cut_count, 1);
    CHECK_NEAR(report.cut, 0.8, 0.1);
    CHECK(distance_from(shell, surface) < 0.02);
    batten_surface_unref(surface);
    surface = NULL;
    options.cut = false;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("profile 2 extends 0.");
    network_end(&n);
}

static void moved_shell(double u, double v, double *p)
{
    shell(u, v, p);
    p[2] += 0.012;
}

TEST(G7_a_gap_is_refused_with_names_and_its_size)
{
    network n = network_on(shell, 3, 3, 30, 0);
    batten_curve_unref(n.curves[0][1]);
    n.curves[0][1] = draw(moved_shell, (drawn){0, 0.5, 0, 1, 0, 30});
    const char *ribs[] = {"rib 5", "rib 7", "rib 9"}, *spars[] = {"spar 1", "spar 2", "spar 3"};
    batten_surface_gordon_options options = within(1e-3);
    batten_surface *surface = NULL;
    options.profile_names = ribs;
    options.guide_names = spars;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("profile 'rib 7' (2 of 3) misses guide 'spar 1' (1 of 3) by 0.0116");
    CHECK_MESSAGE("misses guide 'spar 3' (3 of 3) by 0.00929");
    CHECK_MESSAGE("more than the gap allowed, 0.001; of 9 pairs 3 are apart");
    CHECK_MESSAGE("a gap of 0.012 would join them");
    options.tolerance = 0.02;
    batten_surface_gordon_report report;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.gap > 0.008 && report.gap <= 0.0121);
    CHECK(report.error >= report.gap / 2 * 0.9 && report.error <= 0.02);
    CHECK_INT(report.gap_profile, 1);
    check_curves(&n, surface, &report);
    batten_surface_unref(surface);
    network_end(&n);
}

static batten_curve *polyline(int count, const double *points)
{
    double knots[32] = {0};
    for (int i = 0; i < count; i++)
        knots[i + 1] = i;
    knots[count + 1] = count - 1;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, count, points}, 1, NULL, knots, &curve));
    return curve;
}

TEST(a_curve_that_crosses_another_twice_is_refused)
{
    const double a[] = {0, 0, 0, 4, 0, 0}, b[] = {0, 1, 0, 4, 1, 0}, c[] = {0, 0, 0, 0, 1, 0},
                 d[] = {2, 0, 0, 2, 1, 0, 3, 2, 0, 4, 1, 0, 4, 0.5, 0};
    network n = {{2, 2}, {{polyline(2, a), polyline(2, b)}, {polyline(2, c), polyline(5, d)}}};
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface *surface = NULL;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("profile 2 and guide 2 meet twice, at (2, 1, 0) and (4, 1, 0)");
    network_end(&n);
}

TEST(another_order_of_crossings_is_refused)
{
    const double a[] = {0, 0, 0, 4, 0, 0}, b[] = {0, 1, 0, 4, 1, 0}, c[] = {0, 0, 0, 0, 1, 0},
                 d[] = {1, 0, 0, 3, 1, 0}, e[] = {3, 0, 0, 1, 1, 0};
    network n = {
        {2, 3},
        {{polyline(2, a), polyline(2, b)}, {polyline(2, c), polyline(2, d), polyline(2, e)}}};
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface *surface = NULL;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("profile 2 meets guide 2 and guide 3 in another order than profile 1 does");
    network_end(&n);
}

TEST(two_guides_through_one_point_are_refused)
{
    const double a[] = {0, 0, 0, 4, 0, 0}, b[] = {0, 1, 0, 4, 1, 0}, c[] = {0, 0, 0, 0, 1, 0},
                 d[] = {2, 0, 0, 3, 1, 0}, e[] = {2, 0, 0, 4, 1, 0};
    network n = {
        {2, 3},
        {{polyline(2, a), polyline(2, b)}, {polyline(2, c), polyline(2, d), polyline(2, e)}}};
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface *surface = NULL;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_COINCIDENT);
    CHECK_MESSAGE(
        "guide 2 and guide 3 meet profile 1 in the same point, (2, 0, 0): they are 0 apart");
    network_end(&n);
}

TEST(curves_that_run_along_each_other_end_soon)
{
    network n = network_on(shell, 3, 3, 40, 0);
    batten_curve_unref(n.curves[1][1]);
    n.curves[1][1] = batten_curve_ref(n.curves[0][1]);
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface *surface = NULL;
    const batten_status status = gordon(&n, &options, NULL, &surface);
    CHECK(status == BATTEN_NOT_COMPATIBLE || status == BATTEN_OUT_OF_MEMORY);
    network_end(&n);
}

TEST(corners_of_the_curves_stay)
{
    const double a[] = {0, 0, 0, 1, 0, 1, 2, 0, 0}, b[] = {0, 2, 0, 1, 2, 1, 2, 2, 0},
                 c[] = {0, 0, 0, 0, 2, 0}, d[] = {1, 0, 1, 1, 2, 1}, e[] = {2, 0, 0, 2, 2, 0};
    network n = {
        {2, 3},
        {{polyline(3, a), polyline(3, b)}, {polyline(2, c), polyline(2, d), polyline(2, e)}}};
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.error < 1e-14);
    CHECK(report.points_u < 12);
    batten_surface_unref(surface);
    network_end(&n);
}

TEST(rational_curves_become_polynomial_within_the_tolerance)
{
    batten_frame frames[2];
    network n = {{2, 2}, {{NULL}}};
    for (int k = 0; k < 2; k++)
        frames[k] = (batten_frame){{0, 0, 2.0 * k}, {1, 0, 0}, {0, 0, 1}};
    for (int k = 0; k < 2; k++)
        CHECK_OK(batten_curve_arc_in(&frames[k], 1, 0, acos(0), &n.curves[0][k]));
    const double c[] = {1, 0, 0, 1, 0, 2}, d[] = {0, 1, 0, 0, 1, 2};
    n.curves[1][0] = polyline(2, c);
    n.curves[1][1] = polyline(2, d);
    const batten_surface_gordon_options options = within(1e-5);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.error <= 1e-5 && report.error > 0);
    CHECK(!batten_surface_is_rational(surface));
    CHECK(curve_off(n.curves[0][1], surface) <= 1e-5);
    batten_surface_unref(surface);
    network_end(&n);
}

/* ---- bad numbers, sizes, budgets ---- */

TEST(N6_options_that_mean_nothing_are_refused)
{
    network n = network_on(shell, 2, 2, 8, 0);
    batten_surface_gordon_options options = within(0);
    batten_surface *surface = NULL;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_BAD_ARGUMENT);
    options.tolerance = NAN;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_NOT_FINITE);
    options.tolerance = 1e-18;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("lost in the rounding");
    options.tolerance = 1e-3;
    options.gap = -1;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the gap is -1");
    options.gap = INFINITY;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_NOT_FINITE);
    options.gap = 0;
    n.count[1] = 1;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("there is 1 guide");
    n.count[1] = 2;
    network_end(&n);
}

TEST(S5_too_many_nodes_are_refused_before_the_work)
{
    network n = network_on(shell, 2, 2, 8, 0);
    const int many = 1000;
    const batten_curve **curves = test_array((size_t)many, sizeof *curves);
    for (int k = 0; k < many; k++)
        curves[k] = n.curves[0][0];
    const batten_surface_gordon_options options = within(1e-3);
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_gordon((batten_curve_row){many, curves},
                                       (batten_curve_row){many, curves}, &options, NULL, NULL,
                                       &surface),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("1e+06 nodes");
    network_end(&n);
}

TEST(a_budget_of_work_ends_it)
{
    network n = network_on(shell, 4, 4, 30, 0.4);
    const batten_surface_gordon_options options = within(1e-5);
    batten_job job = BATTEN_JOB;
    job.work_limit = 300;
    batten_surface *surface = NULL;
    CHECK_STATUS(
        batten_surface_gordon((batten_curve_row){4, (const batten_curve *const *)n.curves[0]},
                              (batten_curve_row){4, (const batten_curve *const *)n.curves[1]},
                              &options, &job, NULL, &surface),
        BATTEN_INCOMPLETE);
    network_end(&n);
}

TEST(huge_and_tiny_networks_are_the_same_networks)
{
    const double scales[] = {1, 1e80, 1e-80};
    batten_surface_gordon_report reports[3];
    for (int s = 0; s < 3; s++) {
        network n = network_on(shell, 3, 4, 20, 0.3);
        const batten_affine map = batten_affine_scaling(scales[s], scales[s], scales[s]);
        for (int f = 0; f < 2; f++)
            for (int k = 0; k < n.count[f]; k++) {
                batten_curve *scaled = NULL;
                CHECK_OK(batten_curve_transform(n.curves[f][k], &map, &scaled));
                batten_curve_unref(n.curves[f][k]);
                n.curves[f][k] = scaled;
            }
        const batten_surface_gordon_options options = within(1e-3 * scales[s]);
        batten_surface *surface = NULL;
        CHECK_OK(gordon(&n, &options, &reports[s], &surface));
        CHECK_INT(reports[s].points_u, reports[0].points_u);
        CHECK_INT(reports[s].points_v, reports[0].points_v);
        CHECK_NEAR(reports[s].error / scales[s], reports[0].error, 1e-9);
        batten_surface_unref(surface);
        network_end(&n);
    }
}

static const struct {
    double tolerance, gap;
    int profiles, guides;
    batten_status status;
    const char *message;
} refused[] = {
    {NAN, 0, 2, 2, BATTEN_NOT_FINITE, "the tolerance is nan"},
    {0, 0, 2, 2, BATTEN_BAD_ARGUMENT, "the tolerance is 0, not above 0"},
    {-1, 0, 2, 2, BATTEN_BAD_ARGUMENT, "the tolerance is -1, not above 0"},
    {1e-3, INFINITY, 2, 2, BATTEN_NOT_FINITE, "the gap is inf"},
    {1e-3, -0.5, 2, 2, BATTEN_BAD_ARGUMENT, "the gap is -0.5, below 0"},
    {1e-3, 0, 0, 2, BATTEN_TOO_FEW_POINTS,
     "there are 0 profiles and 2 guides; a network has both"},
    {1e-3, 0, 2, 0, BATTEN_TOO_FEW_POINTS,
     "there are 2 profiles and 0 guides; a network has both"},
    {1e-3, 0, 2, 1, BATTEN_TOO_FEW_POINTS,
     "there is 1 guide; a network whose profiles are open needs 2"},
    {1e-3, 0, 1, 2, BATTEN_TOO_FEW_POINTS,
     "there is 1 profile; a network whose guides are open needs 2"},
};

TEST(what_is_no_network_is_named_with_its_numbers)
{
    network n = network_on(shell, 2, 2, 8, 0);
    batten_surface *surface = NULL;
    for (int i = 0; i < COUNT(refused); i++) {
        batten_surface_gordon_options options = within(refused[i].tolerance);
        options.gap = refused[i].gap;
        CHECK_STATUS(
            batten_surface_gordon(
                (batten_curve_row){refused[i].profiles,
                                   (const batten_curve *const *)n.curves[0]},
                (batten_curve_row){refused[i].guides, (const batten_curve *const *)n.curves[1]},
                &options, NULL, NULL, &surface),
            refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    CHECK(!surface);
    network_end(&n);
}

/* Functions have no place, and curves of one point no size. */
TEST(functions_and_networks_of_one_point_are_refused)
{
    const double values[2] = {1, 2}, still[6] = {1, 2, 3, 1, 2, 3}, knots[4] = {0, 0, 1, 1};
    batten_curve *function = NULL, *point = NULL;
    batten_surface *surface = NULL;
    const batten_surface_gordon_options options = within(1e-3);
    CHECK_OK(batten_curve_create((batten_points){1, 2, values}, 1, NULL, knots, &function));
    CHECK_OK(batten_curve_create((batten_points){3, 2, still}, 1, NULL, knots, &point));
    const batten_curve *profiles[2] = {point, point}, *guides[2] = {point, function};
    CHECK_STATUS(batten_surface_gordon((batten_curve_row){2, profiles},
                                       (batten_curve_row){2, guides}, &options, NULL, NULL,
                                       &surface),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("curve 4 of the network is a function");
    CHECK_STATUS(batten_surface_gordon((batten_curve_row){2, profiles},
                                       (batten_curve_row){2, profiles}, &options, NULL, NULL,
                                       &surface),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("all curves of the network are one point");
    batten_curve_unref(function);
    batten_curve_unref(point);
}

TEST(polynomials_take_twelve_curves_and_no_more)
{
    for (int count = 12; count <= 13; count++) {
        network n = network_on(bicubic, count, 2, 6, 0);
        batten_surface_gordon_options options = within(1e-3);
        batten_surface *surface = NULL;
        options.blend = BATTEN_GORDON_LAGRANGE;
        if (count == 12) {
            CHECK_OK(gordon(&n, &options, NULL, &surface));
        } else {
            CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_BAD_ARGUMENT);
            CHECK_MESSAGE("polynomials through 13 curves swing; 12 are the limit");
        }
        batten_surface_unref(surface);
        network_end(&n);
    }
}
