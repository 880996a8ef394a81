#include "shape/sections.h"

#include <batten/standard.h>

#include "support/faults.h"

typedef const batten_curve *const *curves;

static double apart(const batten_surface *a, const batten_surface *b)
{
    const batten_interval v = batten_surface_domain(a, BATTEN_V);
    double worst = 0;
    for (int i = 0; i <= 40; i++)
        for (int j = 0; j <= 20; j++) {
            double p[3], q[3];
            const double y = v.a + (v.b - v.a) * j / 20;
            CHECK_OK(batten_surface_evaluate(a, i / 40.0, y, 0, p));
            CHECK_OK(batten_surface_evaluate(b, i / 40.0, y, 0, q));
            worst = fmax(worst, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
        }
    return worst;
}

TEST(a_procedural_skin_is_the_exact_skin_of_polynomial_sections)
{
    test_random random = test_random_begin("procedural");
    const batten_end_kind kinds[] = {BATTEN_END_NOT_A_KNOT, BATTEN_END_NATURAL,
                                     BATTEN_END_CLAMPED, BATTEN_END_BESSEL, BATTEN_END_FAIR};
    batten_curve *sections[6];
    for (int k = 0; k < 6; k++)
        sections[k] = jittered(&random, 9, k, airfoil);
    for (int c = 0; c < COUNT(kinds) + 2; c++) {
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.start = options.end = (batten_end){kinds[c % COUNT(kinds)], {1, 0.2, 0.1}};
        options.closed = c == COUNT(kinds);
        if (c == COUNT(kinds) + 1) {
            options.degree = 2;
            options.start.kind = options.end.kind = BATTEN_END_NOT_A_KNOT;
        }
        double v[7];
        batten_surface *free = NULL, *skin = NULL, *exact = NULL;
        CHECK_EACH_ALLOCATION(batten_surface_skin_procedural(
            (batten_curve_row){6, (curves)sections}, &options, v, &free));
        CHECK_TEXT(batten_surface_kind(free), "skin");
        options.parameters = BATTEN_GIVEN;
        options.given = v;
        v[6] = batten_surface_domain(free, BATTEN_V).b;
        CHECK_OK(batten_surface_skin((batten_curve_row){6, (curves)sections}, &options, NULL,
                                     NULL, NULL, &skin));
        CHECK(apart(free, skin) < 2e-13 * 6);
        double error = 1, a[18], b[18];
        CHECK_OK(batten_surface_to_nurbs(free, 0, &error, &exact));
        CHECK(apart(skin, exact) < 2e-13 * 6 && error < 1e-14);
        CHECK_OK(batten_surface_evaluate(free, 0.313, 0.417, 2, a));
        CHECK_OK(batten_surface_evaluate(skin, 0.313, 0.417, 2, b));
        for (int i = 0; i < 18; i++)
            CHECK_NEAR(a[i], b[i], 1e-9);
        batten_surface_unref(exact);
        batten_surface_unref(skin);
        batten_surface_unref(free);
    }
    unref_all(6, sections);
}

TEST(a_procedural_skin_becomes_few_knots_within_a_tolerance)
{
    test_random random = test_random_begin("few");
    batten_curve *sections[8];
    for (int k = 0; k < 8; k++)
        sections[k] = jittered(&random, 24, 3.0 * k / 7, airfoil);
    batten_surface *free = NULL, *few = NULL;
    double error = 0, spans[200];
    CHECK_EACH_ALLOCATION(batten_surface_skin_procedural(
        (batten_curve_row){8, (curves)sections}, NULL, NULL, &free));
    CHECK_INT(batten_surface_spans(free, BATTEN_U, spans), 8 * 20 + 2);
    CHECK_OK(batten_surface_to_nurbs(free, 1e-3, &error, &few));
    CHECK(batten_surface_spans(few, BATTEN_U, NULL) < 30);
    CHECK(error > 0 && error <= 1e-3 * (1 + 1e-12));
    CHECK(apart(free, few) <= error);
    batten_surface_unref(few);
    batten_surface_unref(free);
    unref_all(8, sections);
}

TEST(rational_sections_are_blended_at_their_points)
{
    batten_curve *sections[4] = {NULL, NULL, NULL, NULL};
    for (int k = 0; k < 4; k++) {
        batten_curve *arc = NULL, *space = NULL;
        const batten_affine map = batten_affine_translation(0, 0, k);
        CHECK_OK(batten_curve_arc(1 + 0.5 * k, 1 + 0.7 * k, &arc));
        CHECK_OK(batten_curve_to_dimension(arc, 3, &space));
        CHECK_OK(batten_curve_transform(space, &map, &sections[k]));
        batten_curve_unref(space);
        batten_curve_unref(arc);
    }
    batten_surface *free = NULL, *near = NULL;
    double v[4], error = 0;
    CHECK_OK(batten_surface_skin_procedural((batten_curve_row){4, (curves)sections}, NULL, v,
                                            &free));
    for (int k = 0; k < 4; k++)
        for (int i = 0; i <= 50; i++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(free, i / 50.0, v[k], 0, p));
            CHECK_NEAR(hypot(p[0], p[1]), 1 + 0.5 * k, 1e-14 * 4);
            CHECK_NEAR(p[2], k, 1e-14 * 4);
        }
    CHECK_STATUS(batten_surface_to_nurbs(free, 0, &error, &near), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("as NURBS the surface needs a tolerance");
    CHECK_OK(batten_surface_to_nurbs(free, 1e-4, &error, &near));
    CHECK(!batten_surface_is_rational(near) && error <= 1e-4);
    CHECK(apart(free, near) <= error);
    batten_surface_unref(near);
    batten_surface_unref(free);
    unref_all(4, sections);
}

TEST(a_procedural_skin_has_no_ends_with_a_direction)
{
    test_random random = test_random_begin("directions");
    batten_curve *sections[3];
    for (int k = 0; k < 3; k++)
        sections[k] = jittered(&random, 6, k, airfoil);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.end = (batten_end){BATTEN_END_DIRECTION, {1, 0, 0}};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_skin_procedural((batten_curve_row){3, (curves)sections},
                                                &options, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_skin_procedural((batten_curve_row){1, (curves)sections}, NULL,
                                                NULL, &surface),
                 BATTEN_TOO_FEW_POINTS);
    CHECK(surface == NULL);
    unref_all(3, sections);
}

TEST(S5_cardinal_splines_of_too_many_sections_are_refused)
{
    const double a[] = {0, 0, 0}, b[] = {1, 0, 0};
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    const int count = test_cases(3) < 3 ? 10 : 1200;
    const batten_curve **sections = test_array((size_t)count, sizeof *sections);
    for (int k = 0; k < count; k++)
        sections[k] = line;
    batten_surface *surface = NULL;
    if (count > 10) {
        CHECK_STATUS(batten_surface_skin_procedural((batten_curve_row){count, sections}, NULL,
                                                    NULL, &surface),
                     BATTEN_TOO_LARGE);
        CHECK_MESSAGE("1200 sections have cardinal splines");
    }
    batten_curve_unref(line);
}
