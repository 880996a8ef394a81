/* What is one curve, what is a gap and what is a slit, whatever the tolerance. */
#include "shape/network/networks.h"

#include "support/faults.h"

/* A tube with a slit of 0.045 to 0.06 along it, between its first and its last guide. */
static network slit_tube(void)
{
    network n = {{4, 4}, {{NULL}}};
    const double last = 0.99;
    for (int k = 0; k < 4; k++) {
        n.curves[0][k] = draw(tube, (drawn){0, k / 3.0, 0, last, 0, 60});
        n.curves[1][k] = draw(tube, (drawn){1, last * k / 3.0, 0, 1, 0, 20});
    }
    return n;
}

TEST(G7_sides_of_a_slit_stay_two_however_coarse_the_tolerance)
{
    for (int i = 0; i < 4; i++) {
        network n = slit_tube();
        const batten_surface_gordon_options options = within(0.3 * pow(0.2, i));
        batten_surface_gordon_report report;
        batten_surface *surface = NULL;
        CHECK_OK(gordon(&n, &options, &report, &surface));
        CHECK_INT(report.repeated_count, 0);
        CHECK(!report.closed_u && report.seam == 0);
        CHECK(report.error <= options.tolerance);
        CHECK_NEAR(report.nearest, 0.044, 1e-3); /* at v = 0: 2 pi 0.01 times 0.7 */
        CHECK(report.nearest_is_guide);
        CHECK(report.nearest_curves[0] + report.nearest_curves[1] == 3);
        batten_surface_unref(surface);
        network_end(&n);
    }
}

TEST(G7_a_mixed_list_with_a_slit_is_split_however_coarse_the_tolerance)
{
    for (int i = 0; i < 4; i++) {
        network n = slit_tube();
        const batten_curve *all[8];
        int family[8];
        for (int k = 0; k < 8; k++)
            all[k] = n.curves[k % 2][k / 2];
        CHECK_EACH_ALLOCATION(
            batten_network_split(8, all, 0.3 * pow(0.2, i), NULL, NULL, family));
        for (int k = 0; k < 8; k++)
            CHECK_INT(family[k], k % 2);
        network_end(&n);
    }
}

/* The same without the last guide is a tube whose seam is open by a gap. */
TEST(a_curve_whose_ends_are_within_the_gap_closes_and_it_is_said)
{
    network n = slit_tube();
    batten_surface_gordon_options options = within(0.01);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    n.count[1] = 3;
    options.gap = 0.1;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.closed_u && report.seam > 0.04 && report.seam < 0.1 && !report.seam_is_guide);
    batten_surface_unref(surface);
    n.count[1] = 4;
    network_end(&n);
}

TEST(a_guide_given_twice_is_named_and_so_is_how_far_it_is_from_the_first)
{
    network n = slit_tube();
    for (int k = 0; k < 4; k++) {
        batten_curve_unref(n.curves[0][k]);
        n.curves[0][k] = draw(tube, (drawn){0, k / 3.0, 0, 1, 0, 60});
    }
    batten_curve_unref(n.curves[1][3]);
    n.curves[1][3] = draw(tube, (drawn){1, 1, 0, 1, 0, 20});
    const batten_surface_gordon_options options = within(2e-3);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK_INT(report.repeated_count, 1);
    CHECK(report.repeated[0].is_guide && report.repeated[0].apart <= 1e-6);
    CHECK_INT(report.repeated[0].used, 0);
    CHECK_INT(report.repeated[0].left, 3);
    batten_surface_unref(surface);
    network_end(&n);
}

static void lifted(double u, double v, double *p)
{
    shell(u, v, p);
    p[2] += 0.004;
}

/* Curves may miss each other by more than the surface may be off elsewhere. */
TEST(G7_a_gap_wider_than_the_tolerance_is_bridged_midway)
{
    network n = network_on(shell, 4, 4, 40, 0);
    batten_curve_unref(n.curves[0][1]);
    n.curves[0][1] = draw(lifted, (drawn){0, 1 / 3.0, 0, 1, 0, 40});
    batten_surface_gordon_options options = within(1e-4);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_STATUS(gordon(&n, &options, NULL, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("of 16 pairs 4 are apart, these are the worst");
    options.gap = 0.01;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK(report.gap > 0.002 && report.gap <= 0.004);
    CHECK(report.error > 1e-3 && report.error <= 1e-4 + report.gap);
    CHECK(report.node_error <= 1e-12);
    batten_surface_unref(surface);
    network_end(&n);
}

/* Flat at the profiles, v = 0, 0.5 and 1, with a wave between them. */
static void waved(double u, double v, double *p)
{
    p[0] = u;
    p[1] = v;
    p[2] = 0.03 * sin(8 * acos(0) * v);
}

TEST(waves_of_the_guides_are_measured)
{
    network n = network_on(waved, 3, 3, 60, 0);
    const batten_surface_gordon_options options = within(1e-4);
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    CHECK_OK(gordon(&n, &options, &report, &surface));
    CHECK_NEAR(report.guide_error, 0.03, 1e-4);
    CHECK_NEAR(fabs(report.guide_worst_at.z), 0.03, 1e-3);
    CHECK_NEAR(report.size, sqrt(2 + 0.06 * 0.06), 0.01);
    batten_surface_unref(surface);
    network_end(&n);
}

TEST(the_size_of_a_network_is_that_of_its_box)
{
    const double knots[] = {0, 0, 1, 1}, flat[] = {0, 0, 3, 0}, up[] = {3, 4, 0, 3, 0, 12};
    batten_curve *curves[2] = {NULL};
    CHECK_OK(batten_curve_create((batten_points){2, 2, flat}, 1, NULL, knots, &curves[0]));
    CHECK_OK(batten_curve_create((batten_points){3, 2, up}, 1, NULL, knots, &curves[1]));
    CHECK_NEAR(batten_network_size(2, (const batten_curve *const *)curves), 13, 1e-14);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(curves[k]);
}
