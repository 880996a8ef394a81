#include "body/elementary/elementary.h"
#include "numeric/vector.h"
#include "support/test.h"

#include <batten/standard.h>

static batten_curve *open_cubic(void)
{
    static const double points[] = {0, 0, 0, 1, 2, 0, 3, 2, 1, 4, 0, 2, 6, 1, 0};
    static const double knots[] = {0, 0, 0, 0, 0.4, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 5, points}, 3, NULL, knots, &curve));
    return curve;
}

static batten_curve *circle(void)
{
    const batten_frame frame = batten_frame_world();
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_arc_in(&frame, 2, 0, 2 * BAT_PI, &curve));
    return curve;
}

static void at(const batten_curve *curve, double share, double p[3])
{
    const batten_interval d = batten_curve_domain(curve);
    CHECK_OK(batten_curve_evaluate(curve, d.a + (d.b - d.a) * share, 0, p));
}

static void check_ends(const batten_curve *part, const double p[3], const double q[3],
                       double tolerance)
{
    double found[3];
    at(part, 0, found);
    CHECK_NEAR(bat_distance(3, found, p), 0, tolerance);
    at(part, 1, found);
    CHECK_NEAR(bat_distance(3, found, q), 0, tolerance);
}

TEST(a_curve_with_its_own_ends_is_kept_bit_for_bit)
{
    batten_curve *curve = open_cubic(), *part = NULL;
    double p[3], q[3], miss = -1;
    at(curve, 0, p);
    at(curve, 1, q);
    p[2] += 1e-4;
    CHECK_OK(bat_curve_part(curve, p, q, true, 1e-3, &part, &miss));
    CHECK(part == curve);
    CHECK_NEAR(miss, 1e-4, 1e-12);
    batten_curve_unref(part);
    CHECK_OK(bat_curve_part(curve, q, p, false, 1e-3, &part, &miss));
    CHECK(memcmp(batten_curve_points(part), batten_curve_points(curve) + 12,
                 3 * sizeof(double)) == 0);
    check_ends(part, q, p, 2e-4);
    batten_curve_unref(part);
    batten_curve_unref(curve);
}

TEST(a_part_lies_on_the_curve_and_its_miss_is_told)
{
    batten_curve *curve = open_cubic(), *part = NULL;
    double p[3], q[3], off[3], miss = -1;
    at(curve, 0.2, p);
    at(curve, 0.7, q);
    memcpy(off, q, sizeof off);
    for (int forward = 0; forward < 2; forward++) {
        CHECK_OK(bat_curve_part(curve, forward ? p : q, forward ? q : p, forward, 1e-6, &part,
                                &miss));
        check_ends(part, forward ? p : q, forward ? q : p, 1e-12);
        CHECK_NEAR(miss, 0, 1e-12);
        batten_curve_unref(part);
    }
    off[2] += 0.01;
    CHECK_OK(bat_curve_part(curve, p, off, true, 1e-6, &part, &miss));
    CHECK(miss > 0.005 && miss <= 0.01);
    batten_curve_unref(part);
    /* Of an open curve there is one part between two points, whatever it is told. */
    CHECK_OK(bat_curve_part(curve, q, p, true, 1e-6, &part, &miss));
    check_ends(part, q, p, 1e-12);
    batten_curve_unref(part);
    CHECK_STATUS(bat_curve_part(curve, q, q, true, 1e-6, &part, &miss), BATTEN_COINCIDENT);
    batten_curve_unref(curve);
}

static void check_on_circle(const batten_curve *part)
{
    for (int i = 0; i <= 40; i++) {
        double p[3];
        at(part, i / 40., p);
        CHECK_NEAR(hypot(p[0], p[1]), 2, 1e-14);
    }
}

TEST(G6_a_part_of_a_closed_curve_goes_over_the_seam)
{
    batten_curve *curve = circle(), *part = NULL;
    double p[3] = {0, 2, 0}, q[3] = {0, -2, 0}, middle[3], miss;
    static const double through[4] = {-2, 2, -2, 2}; /* x half way */
    for (int i = 0; i < 4; i++) {
        const bool forward = i == 0 || i == 3, swapped = i == 1 || i == 3;
        const double *from = swapped ? q : p, *to = swapped ? p : q;
        CHECK_OK(bat_curve_part(curve, from, to, forward, 1e-9, &part, &miss));
        check_ends(part, from, to, 1e-14);
        check_on_circle(part);
        at(part, 0.5, middle);
        const double sign = i == 1 ? -2 : i == 2 ? 2 : through[i];
        CHECK_NEAR(middle[0], sign, 1e-14);
        batten_curve_unref(part);
    }
    batten_curve_unref(curve);
}

TEST(a_closed_curve_begins_where_it_is_told)
{
    batten_curve *curve = circle(), *part = NULL;
    double seam[3] = {2, 0, 0}, p[3] = {0, 2, 0}, near_seam[3] = {2, 1e-5, 0}, quarter[3], miss;
    CHECK_OK(bat_curve_part(curve, p, p, true, 1e-9, &part, &miss));
    check_ends(part, p, p, 1e-14);
    check_on_circle(part);
    at(part, 0.25, quarter);
    CHECK_NEAR(quarter[0], -2, 1e-14);
    batten_curve_unref(part);
    CHECK_OK(bat_curve_part(curve, p, p, false, 1e-9, &part, &miss));
    at(part, 0.25, quarter);
    CHECK_NEAR(quarter[0], 2, 1e-14);
    batten_curve_unref(part);
    CHECK_OK(bat_curve_part(curve, seam, seam, true, 1e-9, &part, &miss));
    CHECK(part == curve);
    batten_curve_unref(part);
    CHECK_OK(bat_curve_part(curve, seam, near_seam, true, 1e-4, &part, &miss));
    CHECK(part == curve);
    batten_curve_unref(part);
    CHECK_OK(bat_curve_part(curve, seam, p, true, 1e-9, &part, &miss));
    check_ends(part, seam, p, 1e-14);
    at(part, 0.5, quarter);
    CHECK(quarter[0] > 1 && quarter[1] > 1);
    batten_curve_unref(part);
    CHECK_OK(bat_curve_part(curve, p, seam, true, 1e-9, &part, &miss));
    check_ends(part, p, seam, 1e-14);
    at(part, 0.5, quarter);
    CHECK(quarter[0] < 0);
    batten_curve_unref(part);
    batten_curve_unref(curve);
}

TEST(a_periodic_curve_is_cut_anywhere)
{
    static const double points[] = {1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0};
    static const double knots[] = {0, 1, 2, 3, 4};
    batten_curve *curve = NULL, *part = NULL;
    double p[3], q[3], miss;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){3, 4, points}, 3, NULL, knots, &curve));
    at(curve, 0.8, p);
    at(curve, 0.3, q);
    CHECK_OK(bat_curve_part(curve, p, q, true, 1e-9, &part, &miss));
    check_ends(part, p, q, 1e-13);
    const batten_interval d = batten_curve_domain(part);
    CHECK_NEAR(d.b - d.a, 2, 1e-12);
    batten_curve_unref(part);
    CHECK_OK(bat_curve_part(curve, q, q, true, 1e-9, &part, &miss));
    check_ends(part, q, q, 1e-13);
    batten_curve_unref(part);
    batten_curve_unref(curve);
}
