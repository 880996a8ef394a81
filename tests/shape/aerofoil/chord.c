/* Sections that are turned, enlarged, moved and mirrored. */
#include "shape/aerofoil/sections.h"

static const struct {
    double angle, size, shift[2];
    bool is_mirrored;
} places[] = {{0.3, 1, {0, 0}, false},
              {-1.2, 250, {1e3, -7}, false},
              {0.05, 1e-3, {0.2, 3}, true},
              {0.2, 4, {-1, 1}, true}};

TEST(a_section_comes_to_its_place_from_any_other)
{
    double points[COUNT_OF_POINTS][2], moved[COUNT_OF_POINTS][2];
    batten_curve *plain = NULL;
    batten_curve_aerofoil_options options = batten_curve_aerofoil_defaults();
    options.chord = 1;
    make_points(0.14, 0.04, points);
    batten_curve_aerofoil_report first;
    CHECK_OK(
        batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), &options, &first, &plain));
    for (int k = 0; k < COUNT(places); k++) {
        const double c = cos(places[k].angle), s = sin(places[k].angle);
        batten_curve_aerofoil_report report;
        batten_curve *curve = NULL;
        for (int i = 0; i < COUNT_OF_POINTS; i++) {
            const double x = (places[k].is_mirrored ? -1 : 1) * points[i][0], y = points[i][1];
            moved[i][0] = places[k].size * (c * x - s * y) + places[k].shift[0];
            moved[i][1] = places[k].size * (s * x + c * y) + places[k].shift[1];
        }
        CHECK_OK(batten_curve_aerofoil(points_of(moved, COUNT_OF_POINTS), &options, &report,
                                       &curve));
        CHECK(report.mirrored == places[k].is_mirrored);
        CHECK(!report.reversed);
        CHECK_NEAR(report.given.chord, first.given.chord * places[k].size,
                   1e-9 * places[k].size);
        CHECK_NEAR(report.turn - first.turn,
                   places[k].is_mirrored ? -places[k].angle : places[k].angle, 1e-8);
        for (int i = 0; i <= 50; i++) {
            double p[2], q[2];
            CHECK_OK(batten_curve_evaluate(plain, i / 50.0, 0, p));
            CHECK_OK(batten_curve_evaluate(curve, i / 50.0, 0, q));
            CHECK_NEAR(p[0], q[0], 1e-8);
            CHECK_NEAR(p[1], q[1], 1e-8);
        }
        batten_curve_unref(curve);
    }
    batten_curve_unref(plain);
}

TEST(no_place_of_the_curve_is_farther_from_the_tail_than_the_nose)
{
    double points[COUNT_OF_POINTS][2];
    batten_curve *curve = NULL;
    make_points(0.2, 0.08, points);
    CHECK_OK(batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), NULL, NULL, &curve));
    double nose[2], ends[2][2], at[2];
    CHECK_OK(batten_curve_evaluate(curve, 0.5, 0, nose));
    CHECK_NEAR(nose[0], 0, 1e-12);
    CHECK_NEAR(nose[1], 0, 1e-12);
    for (int k = 0; k < 2; k++)
        CHECK_OK(batten_curve_evaluate(curve, k, 0, ends[k]));
    const double x = (ends[0][0] + ends[1][0]) / 2, y = (ends[0][1] + ends[1][1]) / 2;
    CHECK_NEAR(y, 0, 1e-12);
    for (int i = 0; i <= 4000; i++) {
        CHECK_OK(batten_curve_evaluate(curve, i / 4000.0, 0, at));
        CHECK(hypot(at[0] - x, at[1] - y) <= hypot(x, y) + 1e-9);
    }
    batten_curve_unref(curve);
}

/* Below the nose hangs a chin that is nearly as far from the tail, above or below. */
TEST(the_farthest_place_is_the_nose_also_where_another_is_nearly_as_far)
{
    static const double section[][2] = {
        {1, 0.01},   {0.7, 0.08},   {0.4, 0.1},    {0.2, 0.09},   {0.05, 0.05},
        {0, 0},      {0.06, -0.03}, {0.09, -0.07}, {0.05, -0.12}, {0.04, -0.16},
        {0.1, -0.2}, {0.3, -0.16},  {0.6, -0.08},  {1, -0.01}};
    enum { N = COUNT(section) };
    for (int flipped = 0; flipped < 2; flipped++) {
        double points[N][2], farthest = 0;
        batten_curve_aerofoil_report report;
        batten_curve *curve = NULL;
        for (int i = 0; i < N; i++) {
            const double *from = section[flipped ? N - 1 - i : i];
            points[i][0] = from[0];
            points[i][1] = flipped ? -from[1] : from[1];
            farthest = fmax(farthest, hypot(from[0] - 1, from[1]));
        }
        CHECK_OK(batten_curve_aerofoil(points_of(points, N), NULL, &report, &curve));
        CHECK(report.given.chord >= farthest && report.given.chord < 1.01 * farthest);
        batten_curve_unref(curve);
    }
}
