#include "shape/fill/loops.h"

static const double round_corners[8] = {1, 1, 1, 1, 1, 1, 1, 1};

static batten_surface_fill_options form_of(batten_fill_form form)
{
    batten_surface_fill_options options = batten_surface_fill_defaults();
    options.form = form;
    return options;
}

TEST(formulas_over_polygons_have_the_positions_and_planes_of_their_ribbons)
{
    static const char *kinds[] = {"nurbs", "kato", "charrot-gregory"};
    static const int sides[] = {3, 4, 6};
    for (int form = BATTEN_FILL_KATO; form <= BATTEN_FILL_CHARROT_GREGORY; form++)
        for (int k = 0; k < COUNT(sides); k++) {
            const int n = sides[k];
            hole h;
            const batten_surface_fill_options options = form_of((batten_fill_form)form);
            hole_on_paraboloid(n, round_corners, 0.8, &h);
            CHECK_OK(batten_surface_fill(n, h.ribbons, &options, &h.report, h.patches));
            CHECK_INT(h.report.count, n);
            CHECK_TEXT(batten_surface_kind(h.patches[n - 1]), kinds[form]);
            const hole_misfit inner = hole_inner(&h);
            CHECK_NEAR(inner.gap, 0, 1e-13);
            CHECK_NEAR(inner.angle, 0, 1e-9);
            for (int i = 0; i < n; i++) {
                CHECK_NEAR(h.report.outer[i].gap, 0, 1e-12);
                CHECK_NEAR(h.report.outer[i].angle * TESTS_DEGREES, 0, 1e-4);
            }
            double p[3], normal[3];
            hole_see(h.patches[0], 1, 1, p, normal);
            CHECK_NEAR(p[0], 0, 1e-12);
            /* Kato's go on straight from the middles of the sides; corners know the twist */
            const double middle = cos(3.14159265358979323846 / n);
            if (form == BATTEN_FILL_KATO)
                CHECK_NEAR(p[2], -0.4 * middle * middle, 1e-12);
            else if (n == 4) /* Gregory's square: of degree two it makes no error */
                CHECK_NEAR(p[2], 0, 1e-12);
            hole_free(&h);
        }
}

TEST(formulas_that_come_as_splines_are_measured_as_splines)
{
    static const struct {
        batten_fill_form form;
        int sides;
        double degrees;
    } rows[] = {{BATTEN_FILL_KATO, 3, 0.2},
                {BATTEN_FILL_CHARROT_GREGORY, 3, 0.1},
                {BATTEN_FILL_CHARROT_GREGORY, 5, 0.2}};
    for (int k = 0; k < COUNT(rows); k++) {
        const int n = rows[k].sides;
        hole h;
        batten_surface_fill_options options = form_of(rows[k].form);
        options.as_splines = true;
        options.tolerance = 1e-4;
        options.angle = rows[k].degrees / TESTS_DEGREES;
        hole_on_paraboloid(n, round_corners, 0.8, &h);
        CHECK_OK(batten_surface_fill(n, h.ribbons, &options, &h.report, h.patches));
        /* a neighbour on each side may be off by the angle */
        CHECK(hole_inner(&h).angle <= 2 * rows[k].degrees);
        for (int i = 0; i < n; i++) {
            CHECK_TEXT(batten_surface_kind(h.patches[i]), "nurbs");
            CHECK(h.report.outer[i].angle * TESTS_DEGREES <= 1.05 * rows[k].degrees);
            CHECK(h.report.outer[i].gap <= 1e-4);
        }
        hole_free(&h);
    }
}

TEST(a_formula_without_slopes_or_with_twists_keeps_its_sides)
{
    static const double loop[3][3][3] = {{{0, 0, 0}, {1, -0.3, 0.5}, {2, 0, 0}},
                                         {{2, 0, 0}, {2, 1, 0.7}, {1, 1.8, 0.2}},
                                         {{1, 1.8, 0.2}, {0, 1, -0.4}, {0, 0, 0}}};
    for (int form = BATTEN_FILL_KATO; form <= BATTEN_FILL_CHARROT_GREGORY; form++) {
        hole h = {0};
        const batten_surface_fill_options options = form_of((batten_fill_form)form);
        for (int i = 0; i < 3; i++)
            hole_add(&h, 2, loop[i][0], 0, NULL);
        CHECK_OK(batten_surface_fill(3, h.ribbons, &options, &h.report, h.patches));
        for (int i = 0; i < 3; i++) {
            CHECK_NEAR(h.report.outer[i].gap, 0, 1e-12);
            CHECK_NEAR(h.report.inner[i].gap, 0, 1e-12);
            CHECK_NEAR(h.report.inner[i].angle, 0, 1e-9);
        }
        double p[3];
        CHECK_OK(batten_surface_evaluate(h.patches[1], 0, 0, 0, p));
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(p[c], loop[1][0][c], 1e-14);
        hole_free(&h);
    }
}

TEST(formulas_are_finite_in_their_corners)
{
    static const double at[] = {0, 1e-300, 1e-12, 1e-7, 1e-3, 1};
    for (int form = BATTEN_FILL_KATO; form <= BATTEN_FILL_CHARROT_GREGORY; form++)
        for (int n = 3; n <= 6; n += 3) {
            hole h;
            const batten_surface_fill_options options = form_of((batten_fill_form)form);
            hole_on_paraboloid(n, round_corners, 0.8, &h);
            CHECK_OK(batten_surface_fill(n, h.ribbons, &options, NULL, h.patches));
            for (int i = 0; i < COUNT(at); i++)
                for (int j = 0; j < COUNT(at); j++) {
                    double all[30];
                    CHECK_OK(batten_surface_evaluate(h.patches[1], at[i], at[j], 3, all));
                    for (int k = 0; k < 30; k++)
                        CHECK(isfinite(all[k]));
                    for (int k = 0; k < 9; k++)
                        CHECK(fabs(all[k]) < 10);
                }
            hole_free(&h);
        }
}

TEST(a_formula_becomes_a_spline_within_the_tolerance)
{
    hole h;
    const batten_surface_fill_options options = form_of(BATTEN_FILL_CHARROT_GREGORY);
    hole_on_paraboloid(5, round_corners, 0.8, &h);
    CHECK_OK(batten_surface_fill(5, h.ribbons, &options, NULL, h.patches));
    batten_surface *spline = NULL;
    double error = 1;
    CHECK_OK(batten_surface_to_nurbs(h.patches[0], 1e-5, &error, &spline));
    CHECK(error <= 1e-5);
    batten_surface_unref(spline);
    hole_free(&h);
}

TEST(a_formula_takes_no_curvature)
{
    hole h;
    batten_surface_fill_options options = form_of(BATTEN_FILL_KATO);
    options.curvature = true;
    hole_on_paraboloid(5, round_corners, 0.8, &h);
    CHECK_STATUS(batten_surface_fill(5, h.ribbons, &options, NULL, h.patches),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("takes no curvature over");
    hole_free(&h);
}
