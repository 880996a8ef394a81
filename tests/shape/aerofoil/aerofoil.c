#include <batten/nearest.h>

#include "shape/aerofoil/sections.h"

/* Heights of the curve at x, upper first, by its crossings alone. */
static void find_heights(const batten_curve *curve, double x, double y[2])
{
    batten_parameters at = {0};
    CHECK_OK(batten_curve_crossings(curve, 0, x, &at));
    CHECK_INT(at.count, 2);
    for (int k = 0; k < at.count && k < 2; k++) {
        double point[2];
        CHECK_OK(batten_curve_evaluate(curve, at.at[k], 0, point));
        y[k] = point[1];
    }
    batten_release(at.at);
}

static double thickness_at(const batten_curve *curve, double x)
{
    double y[2] = {0, 0};
    find_heights(curve, x, y);
    return y[0] - y[1];
}

TEST(a_section_in_normal_form_is_left_where_it_is)
{
    double points[COUNT_OF_POINTS][2], y[2];
    batten_curve_aerofoil_report report;
    batten_curve *curve = NULL;
    make_points(0.12, 0, points);
    CHECK_OK(batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), NULL, &report, &curve));
    CHECK_INT(batten_curve_point_count(curve), 161);
    CHECK_NEAR(report.given.chord, 1, 1e-9);
    CHECK_NEAR(report.made.chord, 1, 1e-9);
    CHECK_NEAR(report.made.thickness, 2 * 0.12 * naca_half(0.3), 1e-5);
    CHECK_NEAR(report.made.thickness_at, 0.3, 2e-3);
    CHECK_NEAR(report.made.trailing_edge, 2 * 0.12 * naca_half(1), 1e-12);
    CHECK_NEAR(report.made.camber, 0, 1e-9);
    CHECK(report.distance < 1e-6);
    CHECK(report.moved < 1e-9);
    CHECK_INT(report.repeated + report.base + report.crossings, 0);
    CHECK(!report.reversed && !report.halves && !report.mirrored && !report.closed &&
          !report.round_tail);
    for (int i = 1; i < 20; i++) {
        const double x = i / 20.0;
        find_heights(curve, x, y);
        CHECK_NEAR(y[0], 0.12 * naca_half(x), 1e-5);
        CHECK_NEAR(y[1], -0.12 * naca_half(x), 1e-5);
    }
    batten_curve_unref(curve);
}

/* Chord, trailing edge, thickness as asked; camber as it was. */
static const struct {
    double chord, edge, thickness, blend;
} asked[] = {{1, 0, 0, 1},        {2.5, 0.01, 0, 1},      {1, -1, 0.18, 1},
             {0.3, 0, 0.06, 0.5}, {1000, 0.02, 0.1, 0.1}, {0, 0.004, 0.24, 1}};

TEST(chord_trailing_edge_and_thickness_are_what_was_asked_and_camber_stays)
{
    double points[COUNT_OF_POINTS][2];
    make_points(0.12, 0.03, points);
    for (int i = 0; i < COUNT(asked); i++) {
        batten_curve_aerofoil_options options = batten_curve_aerofoil_defaults();
        batten_curve_aerofoil_report report;
        batten_curve *curve = NULL;
        options.chord = asked[i].chord;
        options.trailing_edge = asked[i].edge;
        options.thickness = asked[i].thickness;
        options.blend = asked[i].blend;
        CHECK_OK(batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), &options, &report,
                                       &curve));
        const double chord = asked[i].chord > 0 ? asked[i].chord : report.given.chord;
        const double edge = asked[i].edge >= 0 ? asked[i].edge : report.given.trailing_edge;
        double ends[2][2], y[2];
        for (int k = 0; k < 2; k++) {
            CHECK_OK(batten_curve_evaluate(curve, k, 0, ends[k]));
            CHECK_BITS(ends[k][0], chord);
        }
        CHECK_NEAR(ends[0][1] - ends[1][1], edge * chord, 1e-12 * chord);
        CHECK_NEAR(report.made.trailing_edge, edge, 1e-12);
        CHECK_NEAR(report.made.chord, chord, 1e-5 * chord);
        CHECK_NEAR(report.made.camber, report.given.camber, 2e-6);
        if (asked[i].thickness > 0) {
            CHECK_NEAR(report.made.thickness, asked[i].thickness, 1e-6);
            CHECK_NEAR(thickness_at(curve, report.made.thickness_at * chord),
                       asked[i].thickness * chord, 1e-6 * chord);
        }
        find_heights(curve, 0.4 * chord, y);
        /* The chord of points with camber is turned a little: their nose is not at x = 0. */
        CHECK_NEAR((y[0] + y[1]) / 2, camber_line(0.03, 0.4) * chord, 5e-4 * chord);
        CHECK(report.distance < 1e-5 * chord);
        CHECK_INT(report.crossings, 0);
        batten_curve_unref(curve);
    }
}

TEST(a_closed_section_ends_bit_for_bit_where_it_begins)
{
    double points[COUNT_OF_POINTS][2], ends[2][2];
    batten_curve_aerofoil_options options = batten_curve_aerofoil_defaults();
    batten_curve *curve = NULL;
    make_points(0.15, 0.02, points);
    options.trailing_edge = 0;
    CHECK_OK(batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), &options, NULL, &curve));
    for (int k = 0; k < 2; k++)
        CHECK_OK(batten_curve_evaluate(curve, k, 0, ends[k]));
    for (int k = 0; k < 2; k++)
        CHECK_BITS(ends[0][k], ends[1][k]);
    batten_curve_unref(curve);
}

TEST(a_smaller_blend_keeps_the_change_nearer_to_the_tail)
{
    static const double blends[] = {1, 0.5, 0.2, 0.05};
    double points[COUNT_OF_POINTS][2], least = 1;
    make_points(0.12, 0, points);
    for (int i = 0; i < COUNT(blends); i++) {
        batten_curve_aerofoil_options options = batten_curve_aerofoil_defaults();
        batten_curve *curve = NULL;
        options.trailing_edge = 0.05;
        options.blend = blends[i];
        CHECK_OK(
            batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), &options, NULL, &curve));
        const double added = thickness_at(curve, 0.5) - 0.24 * naca_half(0.5);
        const double wanted =
            (0.05 - 0.24 * naca_half(1)) * 0.5 * exp(0.5 * (1 - 1 / blends[i]));
        CHECK_NEAR(added, wanted, 1e-6);
        CHECK(added < least);
        least = added;
        batten_curve_unref(curve);
    }
}

TEST(the_farthest_given_point_is_told_with_its_distance)
{
    double points[COUNT_OF_POINTS][2], at[2];
    batten_curve_aerofoil_options options = batten_curve_aerofoil_defaults();
    batten_curve_aerofoil_report report;
    batten_deviation deviation;
    batten_curve *curve = NULL;
    make_points(0.12, 0, points);
    options.panels = 8;
    CHECK_OK(
        batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), &options, &report, &curve));
    CHECK_OK(batten_curve_deviation(curve, points_of(points, COUNT_OF_POINTS), NULL, NULL, NULL,
                                    &deviation));
    CHECK_NEAR(report.distance, deviation.max, 1e-9);
    CHECK_NEAR(report.rms, deviation.rms, 1e-9);
    CHECK_INT(report.worst, deviation.worst);
    CHECK(report.distance > 1e-4);
    CHECK_OK(batten_curve_evaluate(curve, deviation.at[0], 0, at));
    CHECK_NEAR(hypot(at[0] - points[report.worst][0], at[1] - points[report.worst][1]),
               report.distance, 1e-9);
    batten_curve_unref(curve);
}

TEST(sides_that_cross_are_counted_and_placed)
{
    double points[COUNT_OF_POINTS][2];
    batten_curve_aerofoil_report report;
    batten_curve *curve = NULL;
    make_points(0.12, 0, points);
    for (int i = 0; i < COUNT_OF_POINTS; i++)
        points[i][1] -= (i < HALF ? 1 : -1) * 0.01 * points[i][0] * points[i][0];
    CHECK_OK(batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), NULL, &report, &curve));
    CHECK_INT(report.crossings, 1);
    CHECK(report.crossing > 0.8 && report.crossing < 1);
    CHECK_NEAR(thickness_at(curve, report.crossing), 0, 1e-8);
    CHECK_NEAR(report.made.trailing_edge, 0.24 * naca_half(1) - 0.02, 1e-9);
    batten_curve_unref(curve);
}

TEST(options_out_of_range_are_refused)
{
    double points[COUNT_OF_POINTS][2];
    make_points(0.12, 0, points);
    static const struct {
        double chord, edge, thickness, blend;
        int panels;
        const char *message;
    } cases[] = {{-1, -1, 0, 1, 160, "the chord is -1"},
                 {0, 0.6, 0, 1, 160, "the trailing edge is 0.6"},
                 {0, (double)NAN, 0, 1, 160, "the trailing edge is"},
                 {0, -1, 1.5, 1, 160, "the thickness is 1.5"},
                 {0, -1, 0, 0, 160, "the blend is 0"},
                 {0, -1, 0, 1, 161, "the number of panels is 161"},
                 {0, -1, 0, 1, 6, "the number of panels is 6"},
                 {0, 0.3, 0.1, 1, 160, "make the thickness larger"}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_curve_aerofoil_options options = batten_curve_aerofoil_defaults();
        batten_curve *curve = NULL;
        options.chord = cases[i].chord;
        options.trailing_edge = cases[i].edge;
        options.thickness = cases[i].thickness;
        options.blend = cases[i].blend;
        options.panels = cases[i].panels;
        CHECK_STATUS(
            batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), &options, NULL, &curve),
            i + 1 < COUNT(cases) ? BATTEN_BAD_ARGUMENT : BATTEN_NOT_COMPATIBLE);
        CHECK_MESSAGE(cases[i].message);
    }
}

static const struct {
    double chord, edge, thickness, blend;
    int panels;
    const char *message;
} bounds[] = {
    {INFINITY, -1, 0, 1, 160, "the chord is inf; it must be 0 or more"},
    {NAN, -1, 0, 1, 160, "the chord is nan; it must be 0 or more"},
    {0, 0.501, 0, 1, 160, "the trailing edge is 0.501 of the chord; it must be from 0 to 0.5"},
    {0, -1, -0.1, 1, 160, "the thickness is -0.1 of the chord; it must be from 0 to 1"},
    {0, -1, NAN, 1, 160, "the thickness is nan of the chord; it must be from 0 to 1"},
    {0, -1, 0, 1.1, 160, "the blend is 1.1; it must be above 0 and up to 1"},
    {0, -1, 0, 1, 10002, "the number of panels is 10002; it must be even, from 8 to 10000"},
};

TEST(both_ends_of_every_bound_are_kept)
{
    double points[COUNT_OF_POINTS][2];
    make_points(0.12, 0, points);
    for (int i = 0; i < COUNT(bounds); i++) {
        batten_curve_aerofoil_options options = batten_curve_aerofoil_defaults();
        batten_curve *curve = NULL;
        options.chord = bounds[i].chord;
        options.trailing_edge = bounds[i].edge;
        options.thickness = bounds[i].thickness;
        options.blend = bounds[i].blend;
        options.panels = bounds[i].panels;
        CHECK_STATUS(
            batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), &options, NULL, &curve),
            BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(bounds[i].message);
        CHECK(!curve);
    }
}

/* Half the thickness grows from `head` by `slope` to the tail, behind a round nose. */
static const struct {
    double head, slope;
} tails[] = {
    {0.03, 0.02}, /* thicker at 0.98 than at 0.02, but less than its edge is */
    {0.06, -0.05},
};

TEST(a_blunt_tail_is_not_a_round_one)
{
    for (int i = 0; i < COUNT(tails); i++) {
        double points[COUNT_OF_POINTS][2];
        batten_curve_aerofoil_report report;
        batten_curve *curve = NULL;
        for (int k = 0; k < COUNT_OF_POINTS; k++) {
            const double part = (double)(k - HALF) / HALF, x = part * part;
            const double half = sqrt(fmin(1, 50 * x)) * (tails[i].head + tails[i].slope * x);
            points[k][0] = x;
            points[k][1] = (k < HALF ? 1 : k > HALF ? -1 : 0) * half;
        }
        CHECK_OK(
            batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), NULL, &report, &curve));
        CHECK(!report.round_tail);
        batten_curve_unref(curve);
    }
}
