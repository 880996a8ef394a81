/* Thickness and camber as they are measured, against their formulas. */
#include "shape/aerofoil/sections.h"

TEST(thickness_and_camber_agree_with_the_formulas)
{
    static const double cases[][2] = {{0.06, 0}, {0.12, 0.01}, {0.24, 0.02}};
    double points[COUNT_OF_POINTS][2];
    for (int i = 0; i < COUNT(cases); i++) {
        const double thickness = cases[i][0], camber = cases[i][1];
        batten_curve_aerofoil_report report;
        batten_curve *curve = NULL;
        make_points(thickness, camber, points);
        CHECK_OK(
            batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), NULL, &report, &curve));
        /* The nose of a section with camber lies beside x = 0, which turns its chord a little. */
        CHECK_NEAR(report.given.thickness, 2 * thickness * naca_half(0.3), 1e-5 + camber / 100);
        CHECK_NEAR(report.given.camber, camber, 1e-6 + camber / 50);
        if (camber > 0)
            CHECK_NEAR(report.given.camber_at, 0.5, 0.02);
        CHECK_NEAR(report.made.thickness, report.given.thickness, 1e-6);
        CHECK_NEAR(report.made.camber, report.given.camber, 1e-6);
        batten_curve_unref(curve);
    }
}

TEST(a_section_upside_down_has_the_opposite_camber)
{
    double points[COUNT_OF_POINTS][2];
    batten_curve_aerofoil_report report;
    batten_curve *curve = NULL;
    make_points(0.12, -0.03, points);
    CHECK_OK(batten_curve_aerofoil(points_of(points, COUNT_OF_POINTS), NULL, &report, &curve));
    CHECK_NEAR(report.made.camber, -0.03, 1e-3);
    batten_curve_unref(curve);
}
