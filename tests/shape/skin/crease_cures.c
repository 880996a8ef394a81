#include "shape/sections.h"

typedef const batten_curve *const *curves;

/* A quadratic with a corner-free joint at a place of its own: speeds jump there by `ratio`. */
static batten_curve *uneven(double x, double place, double ratio)
{
    const double points[] = {
        x, 0, 0, x, 1, 0, x, 1 + ratio / 4, ratio / 4, x, 1 + ratio / 2, ratio / 2, x, 1.5, 2};
    const double bent[] = {
        x, 0, 0, x, 1, 1, x, 1 + ratio / 4, 1 + ratio / 4, x, 1 + ratio / 2, 1 + ratio / 2,
        x, 2, 3};
    const double knots[] = {0, 0, 0, place, place, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 5, place < 0.45 ? points : bent}, 2, NULL,
                                 knots, &curve));
    return curve;
}

/* The example of the notes: C0' = (1, 0, 0) with ratio 1 and C1' = (0, 1, 0) with ratio 3 make
 * a crease of 26.57 degrees in the middle. */
TEST(speeds_that_jump_by_different_factors_make_the_crease_of_the_notes)
{
    const double knots[] = {0, 0, 0.5, 1, 1};
    const double first[] = {-1, 0, 0, 0, 0, 0, 1, 0, 0},
                 second[] = {0, -1, 1, 0, 0, 1, 0, 3, 1};
    batten_curve *sections[2] = {NULL, NULL};
    CHECK_OK(batten_curve_create((batten_points){3, 3, first}, 1, NULL, knots, &sections[0]));
    CHECK_OK(batten_curve_create((batten_points){3, 3, second}, 1, NULL, knots, &sections[1]));
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    double left[9], right[9];
    CHECK_OK(batten_surface_skin((batten_curve_row){2, (curves)sections}, &options, NULL, NULL,
                                 &report, &surface));
    CHECK_OK(batten_surface_evaluate_side(
        surface, 0.5, 0.5, (batten_sides){BATTEN_FROM_LEFT, BATTEN_FROM_RIGHT}, 1, left));
    CHECK_OK(batten_surface_evaluate(surface, 0.5, 0.5, 1, right));
    CHECK_NEAR(atan2(right[4], right[3]) - atan2(left[4], left[3]), 26.565 * acos(0) / 90,
               1e-5);
    CHECK(report.crease > 0.3 && report.normal_jump == report.crease);
    CHECK_NEAR(report.speed_jump, 1 - 1.0 / 3, 1e-12);
    CHECK_INT(report.cure, BATTEN_CURE_NONE);
    batten_surface_unref(surface);

    options.creases = BATTEN_CREASES_CURE;
    CHECK_OK(batten_surface_skin((batten_curve_row){2, (curves)sections}, &options, NULL, NULL,
                                 &report, &surface));
    CHECK_INT(report.cure, BATTEN_CURE_STRETCHED);
    CHECK(report.crease < 1e-12 && report.error == 0);
    batten_surface_unref(surface);
    unref_all(2, sections);
}

TEST(creases_from_speeds_are_cured_exactly_when_asked)
{
    batten_curve *sections[4];
    for (int k = 0; k < 4; k++)
        sections[k] = uneven(k, 0.3 + 0.1 * k, 0.5 + 0.5 * k);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report kept, cured;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL, NULL,
                                 &kept, &surface));
    batten_surface_unref(surface);
    options.creases = BATTEN_CREASES_CURE;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL, NULL,
                                 &cured, &surface));
    batten_surface_unref(surface);
    CHECK(kept.crease > 0.01 && kept.cure == BATTEN_CURE_NONE);
    CHECK(cured.crease < 1e-9 && cured.cure == BATTEN_CURE_STRETCHED);
    CHECK(cured.error == 0);
    options.creases = BATTEN_CREASES_KEEP;
    options.tolerance = 1e-6;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL, NULL,
                                 &kept, &surface));
    CHECK(kept.crease > 0.01 && kept.cure == BATTEN_CURE_NONE);
    batten_surface_unref(surface);
    unref_all(4, sections);
}

/* An arc of `angle` from x = radius on, of `count` rational quadratics that take these shares.
 */
static batten_curve *arcs(double z, double radius, double angle, int count,
                          const double *shares)
{
    double points[21], weights[7], knots[10] = {0}, at = 0, share = 0;
    for (int i = 0; i < count; i++) {
        const double half = angle * shares[i] / 2;
        const double place[] = {at, at + half, at + 2 * half}, r[] = {1, 1 / cos(half), 1};
        for (int j = 0; j < 3; j++) {
            double *p = points + 3 * (2 * i + j);
            p[0] = radius * r[j] * cos(place[j]);
            p[1] = radius * r[j] * sin(place[j]);
            p[2] = z;
            weights[2 * i + j] = j == 1 ? cos(half) : 1;
        }
        at += 2 * half;
        share += shares[i];
        knots[2 * i + 3] = knots[2 * i + 4] = i + 1 < count ? share : 1;
    }
    knots[2 * count + 3] = 1;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2 * count + 1, points}, 2, weights, knots,
                                 &curve));
    return curve;
}

static batten_curve *two_arcs(double z, double radius, double angle, double share)
{
    const double shares[] = {share, 1 - share};
    return arcs(z, radius, angle, 2, shares);
}

static double off_circle(const batten_surface *surface, double v, double radius)
{
    double worst = 0;
    for (int i = 0; i <= 100; i++) {
        double p[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 100.0, v, 0, p));
        worst = fmax(worst, fabs(hypot(p[0], p[1]) - radius));
    }
    return worst;
}

TEST(weights_that_jump_make_creases_and_are_rescaled_exactly)
{
    const double shares[] = {0.3, 0.55, 0.4};
    batten_curve *sections[3];
    for (int k = 0; k < 3; k++)
        sections[k] = two_arcs(k, 2 + 0.3 * k * k, 2.2, shares[k]);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    double v[3];
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options, NULL, v,
                                 &report, &surface));
    CHECK(report.crease > 1e-3 && report.cure == BATTEN_CURE_NONE);
    batten_surface_unref(surface);
    options.creases = BATTEN_CREASES_CURE;
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options, NULL, v,
                                 &report, &surface));
    CHECK_INT(report.cure, BATTEN_CURE_RESCALED);
    CHECK(report.crease < 1e-9 && report.error == 0);
    CHECK(batten_surface_is_rational(surface));
    for (int k = 0; k < 3; k++)
        CHECK(off_circle(surface, v[k], 2 + 0.3 * k * k) < 1e-12);
    batten_surface_unref(surface);
    unref_all(3, sections);
}

TEST(sections_with_proportional_weights_need_no_cure)
{
    batten_curve *sections[3];
    for (int k = 0; k < 3; k++)
        sections[k] = two_arcs(k, 2 + 0.3 * k * k, 2.2, 0.5);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.creases = BATTEN_CREASES_CURE;
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options, NULL, NULL,
                                 &report, &surface));
    CHECK(report.cure == BATTEN_CURE_NONE && report.crease < 1e-12);
    batten_surface_unref(surface);
    unref_all(3, sections);
}

TEST(what_cannot_be_rescaled_becomes_polynomial_within_the_tolerance)
{
    /* A circle in one rational parameter would run through infinity: weights that do not jump
     * anywhere around it do not exist. */
    batten_curve *sections[3];
    const double shares[][3] = {{0.3, 0.4, 0.3}, {0.3, 0.3, 0.4}, {0.4, 0.25, 0.35}};
    for (int k = 0; k < 3; k++)
        sections[k] = arcs(k, 2 + 0.5 * k * k, 4 * acos(0), 3, shares[k]);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    options.creases = BATTEN_CREASES_CURE;
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options, NULL, NULL,
                                 &report, &surface));
    CHECK(report.cure == BATTEN_CURE_NONE && report.crease > 1e-3); /* it is said, not hidden */
    batten_surface_unref(surface);
    options.tolerance = 1e-4;
    options.creases = BATTEN_CREASES_WITHIN;
    double v[3];
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options, NULL, v,
                                 &report, &surface));
    CHECK(report.crease <= 1e-4 && report.error <= 1e-4);
    for (int k = 0; k < 3; k++)
        CHECK(off_circle(surface, v[k], 2 + 0.5 * k * k) <= 1e-4);
    batten_surface_unref(surface);
    unref_all(3, sections);
}

TEST(weights_that_would_fall_below_zero_are_cured_within_a_tolerance)
{
    const double weights[] = {1, 1, 30, 1e-3, 1, 1}, knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve *sections[6];
    for (int k = 0; k < 6; k++) {
        const double points[] = {k, 0, 0, k, 1, 1, k, 2, 0}, w[] = {1, weights[k], 1};
        sections[k] = NULL;
        CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, w, knots, &sections[k]));
    }
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.tolerance = 1e-3;
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    double v[6];
    CHECK_OK(batten_surface_skin((batten_curve_row){6, (curves)sections}, &options, NULL, v,
                                 &report, &surface));
    CHECK_INT(report.cure, BATTEN_CURE_POLYNOMIAL);
    CHECK(!batten_surface_is_rational(surface) && report.error <= 1e-3);
    for (int k = 0; k < 6; k++)
        for (int i = 0; i <= 50; i++) {
            double p[3], q[3];
            CHECK_OK(batten_curve_evaluate(sections[k], i / 50.0, 0, p));
            CHECK_OK(batten_surface_evaluate(surface, i / 50.0, v[k], 0, q));
            CHECK(hypot(p[1] - q[1], p[2] - q[2]) <= 1e-3);
        }
    batten_surface_unref(surface);
    unref_all(6, sections);
}
