#include <batten/bent.h>
#include <batten/fair.h>
#include <batten/measure.h>

#include "support/test.h"

static const double test_points[3][2] = {{0, 0}, {1, 0.6}, {2, 0.1}};

static batten_chain *spline_of(batten_span_family family)
{
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    batten_chain *chain = NULL;
    options.family = family;
    CHECK_OK(batten_chain_nonlinear((batten_points){2, 3, &test_points[0][0]}, &options, NULL,
                                    NULL, NULL, &chain));
    return chain;
}

TEST(the_energies_of_the_nonlinear_splines_are_the_published_ones)
{
    static const struct {
        batten_span_family family;
        double energy, digits;
    } cases[] = {{BATTEN_FAMILY_ELASTICA, 1.28447309, 5e-9},
                 {BATTEN_FAMILY_GEOMETRIC, 1.2848377, 5e-8},
                 {BATTEN_FAMILY_EULER_SPIRAL, 1.2848596, 5e-8}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_chain *chain = spline_of(cases[i].family);
        batten_fairness fairness;
        CHECK_OK(batten_chain_fairness(
            chain, (batten_points){batten_chain_dimension(chain), 0, NULL}, NULL, &fairness));
        CHECK_NEAR(fairness.energy, cases[i].energy, cases[i].digits);
        CHECK_INT(fairness.inflections, 0);
        CHECK_INT(fairness.corners + fairness.curvature_jumps, 0);
        CHECK(isfinite(fairness.variation));
        batten_chain_unref(chain);
    }
}

/* k = k0 + c s: energy k0^2 s + k0 c s^2 + c^2 s^3 / 3, variation c^2 s. */
TEST(a_clothoid_has_the_energy_of_its_integral_and_one_inflection_at_zero)
{
    const batten_span span = {
        .kind = BATTEN_SPAN_SPIRAL, .length = 3, .curvature = {-0.5, 0.4}};
    batten_chain *chain = NULL;
    batten_fairness fairness;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
    CHECK_OK(batten_chain_fairness(
        chain, (batten_points){batten_chain_dimension(chain), 0, NULL}, NULL, &fairness));
    CHECK_NEAR(fairness.energy, 0.25 * 3 - 0.2 * 9 + 0.16 * 27 / 3, 1e-14);
    CHECK_NEAR(fairness.variation, 0.16 * 3, 1e-14);
    CHECK_NEAR(fairness.max_curvature, 0.7, 1e-15);
    CHECK_INT(fairness.inflections, 1);
    CHECK_INT(fairness.curvature_extrema, 0);
    batten_chain_unref(chain);
}

TEST(steps_of_curvature_over_zero_are_inflections)
{
    const double pi = 3.14159265358979323846;
    const batten_span spans[2] = {{.kind = BATTEN_SPAN_ARC, .length = pi, .curvature = {1}},
                                  {.kind = BATTEN_SPAN_ARC,
                                   .length = pi,
                                   .start = {0, 2},
                                   .angle = pi,
                                   .curvature = {-1}}};
    batten_chain *chain = NULL;
    batten_fairness fairness;
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 2, spans, NULL, false}, 1e-12, &chain));
    CHECK_OK(batten_chain_fairness(
        chain, (batten_points){batten_chain_dimension(chain), 0, NULL}, NULL, &fairness));
    CHECK_INT(fairness.inflections, 1);
    CHECK_INT(fairness.corners, 0);
    CHECK_INT(fairness.curvature_jumps, 1);
    CHECK(!isfinite(fairness.variation));
    CHECK_NEAR(fairness.energy, 2 * pi, 1e-14);
    batten_chain_unref(chain);
}

/* The curve of a chain, a quintic within 1e-10, has nearly the same numbers by another way. */
TEST(a_chain_and_its_curve_are_judged_alike)
{
    for (int family = BATTEN_FAMILY_LOCAL_CUBIC; family <= BATTEN_FAMILY_HOBBY; family++) {
        batten_chain *chain = spline_of((batten_span_family)family);
        batten_curve *curve = NULL;
        batten_fairness one, other;
        CHECK_OK(batten_chain_to_curve(chain, 1e-10, NULL, &curve));
        CHECK_OK(batten_chain_fairness(
            chain, (batten_points){batten_chain_dimension(chain), 0, NULL}, NULL, &one));
        CHECK_OK(batten_curve_fairness(
            curve, (batten_points){batten_curve_dimension(curve), 0, NULL}, NULL, &other));
        CHECK_NEAR(one.energy, other.energy, 1e-7 * other.energy);
        CHECK_INT(one.inflections, other.inflections);
        CHECK_NEAR(one.max_curvature, other.max_curvature, 0.01 * other.max_curvature);
        double exact, length;
        CHECK_OK(batten_chain_length(chain, NULL, &exact));
        CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
        CHECK_NEAR(exact, length, 1e-8);
        batten_curve_unref(curve);
        batten_chain_unref(chain);
    }
}

/* In space a curve may turn from left to right without being straight: no inflection counts. */
TEST(a_chain_in_space_has_no_inflections_and_its_points_require_none)
{
    /* x^3 - x over [-1, 1], out of the plane by x^2 / 4. */
    const batten_span span = {.kind = BATTEN_SPAN_TENSION,
                              .length = 2,
                              .start = {-1, 0, 0.25},
                              .end = {1, 0, 0.25},
                              .bend = {{0, -6, 0.5}, {0, 6, 0.5}}};
    const double points[6][3] = {{-1, 0, 0},       {-0.6, 0.384, 0}, {-0.2, 0.192, 0},
                                 {0.2, -0.192, 0}, {0.6, -0.384, 0}, {1, 0, 0}};
    batten_chain *chain = NULL;
    batten_fairness fairness;
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){3, 1, &span, NULL, false}, 1e-12, &chain));
    CHECK_OK(
        batten_chain_fairness(chain, (batten_points){3, 6, &points[0][0]}, NULL, &fairness));
    CHECK_INT(fairness.inflections, 0);
    CHECK_INT(fairness.excess_inflections, 0);
    CHECK(fairness.fair && fairness.max_curvature > 1);
    batten_chain_unref(chain);
}

/* With P'' = m at the start and 0 at the end of a function over [0, 1] the second derivative is
 * m sinh(s (1 - t)) / sinh(s) for a tension s: for large ones m exp(-s t), of energy m^2 / (2 s)
 * and variation m^2 s / 2, within a strip as thin as the tension is large. */
TEST(the_energy_of_a_span_in_tension_is_right_however_tight)
{
    for (double s = 50; s < 1e9; s *= 3) {
        const batten_span span = {
            .kind = BATTEN_SPAN_TENSION, .length = 1, .tension = s, .bend = {{3}, {0}}};
        const double energy = 4.5 / s, variation = 4.5 * s;
        batten_chain *chain = NULL;
        batten_fairness found;
        CHECK_OK(batten_chain_create(&(batten_chain_parts){1, 1, &span, NULL, false}, 1e-12,
                                     &chain));
        CHECK_OK(batten_chain_fairness(chain, (batten_points){1, 0, NULL}, NULL, &found));
        CHECK_NEAR(found.energy, energy, 1e-12 * energy);
        CHECK_NEAR(found.variation, variation, 1e-12 * variation);
        batten_chain_unref(chain);
    }
}

/* The integral of the square of the polynomial k0 + k1 s + k2 s^2 / 2, or of its rate. */
static double sum_of_squares(const double k[3], bool rate, double s)
{
    const double a = rate ? k[1] : k[0], b = rate ? k[2] : k[1], c = rate ? 0 : k[2] / 2;
    return s * (a * a +
                s * (a * b + s * ((2 * a * c + b * b) / 3 + s * (b * c / 2 + s * c * c / 5))));
}

static const struct {
    double curvature[4], largest;
    int inflections, extrema;
} spirals[] = {
    {{0.1, 0.3, -0.2, 0}, 0.325, 0, 1},  /* highest in the middle */
    {{-0.1, -0.3, 0.2, 0}, 0.325, 0, 1}, /* its image */
    {{0.25, -0.6, 0.4, 0}, 0.25, 2, 1},  /* -0.2 in the middle */
    {{0.25, 0.6, 0.4, 0}, 3.85, 0, 0},   /* rises from end to end */
};

TEST(spirals_have_the_sums_and_the_extrema_of_their_polynomials)
{
    for (int i = 0; i < COUNT(spirals); i++) {
        const double *k = spirals[i].curvature, length = 3;
        const batten_span span = {.kind = BATTEN_SPAN_SPIRAL,
                                  .length = length,
                                  .curvature = {k[0], k[1], k[2], k[3]}};
        batten_chain *chain = NULL;
        batten_fairness found;
        CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1e-12,
                                     &chain));
        CHECK_OK(batten_chain_fairness(chain, (batten_points){2, 0, NULL}, NULL, &found));
        CHECK_NEAR(found.energy, sum_of_squares(k, false, length), 1e-13);
        CHECK_NEAR(found.variation, sum_of_squares(k, true, length), 1e-13);
        CHECK(found.energy_error > 0 && found.energy_error <= 1e-9 * found.energy);
        CHECK(found.variation_error > 0 && found.variation_error <= 1e-9 * found.variation);
        CHECK_NEAR(found.max_curvature, spirals[i].largest, 1e-14);
        CHECK_INT(found.inflections, spirals[i].inflections);
        CHECK_INT(found.curvature_extrema, spirals[i].extrema);
        batten_chain_unref(chain);
    }
}

/* A cubic whose second derivative goes from 3 to -1 over a length of 2: over a parameter that runs
 * 4 times as fast derivatives are 16 times as large. */
static batten_chain *fast_function(void)
{
    const batten_span span = {.kind = BATTEN_SPAN_TENSION, .length = 2, .bend = {{3}, {-1}}};
    static const double breaks[2] = {1, 1.5};
    batten_chain *chain = NULL;
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){1, 1, &span, breaks, false}, 1e-12, &chain));
    return chain;
}

TEST(a_function_is_judged_by_its_own_parameter)
{
    batten_chain *chain = fast_function();
    batten_fairness found;
    CHECK_OK(batten_chain_fairness(chain, (batten_points){1, 2, (const double[]){0, 0}}, NULL,
                                   &found));
    CHECK_NEAR(found.energy, 64 * 2 * (9 - 3 + 1) / 3., 1e-11);
    CHECK_NEAR(found.variation, 1024 * 2 * 4, 1e-9);
    CHECK_NEAR(found.max_curvature, 48, 1e-12);
    CHECK_INT(found.inflections, 1);
    CHECK_INT(found.excess_inflections, 1);
    CHECK_INT(found.curvature_extrema, 0);
    batten_chain_unref(chain);
}

TEST(points_that_do_not_fit_a_chain_are_refused_with_their_numbers)
{
    static const double values[] = {0, 1, NAN, 3}, plane[] = {0, 0, 1, 1, 2, INFINITY};
    batten_chain *function = fast_function(), *chain = spline_of(BATTEN_FAMILY_EULER_SPIRAL);
    const struct {
        const batten_chain *chain;
        batten_points points;
        batten_status status;
        const char *message;
    } rows[] = {
        {function, {1, 3, values}, BATTEN_NOT_FINITE, "point 3 is not finite"},
        {function,
         {1, 1, values},
         BATTEN_NOT_COMPATIBLE,
         "1 value, but the function has 2 breaks"},
        {function,
         {1, 3, plane},
         BATTEN_NOT_COMPATIBLE,
         "3 values, but the function has 2 breaks"},
        {chain, {2, 3, plane}, BATTEN_NOT_FINITE, "point 3 is not finite"},
        {chain, {2, -1, plane}, BATTEN_BAD_ARGUMENT, "there are -1 points"},
        {chain, {2, -2, plane}, BATTEN_BAD_ARGUMENT, "there are -2 points"},
        {chain,
         {3, 1, plane},
         BATTEN_UNSUPPORTED,
         "the points have 3 coordinates, 2 are expected"},
    };
    batten_fairness found = {.energy = 42};
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(batten_chain_fairness(rows[i].chain, rows[i].points, NULL, &found),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].message);
    }
    CHECK_NEAR(found.energy, 42, 0);
    batten_chain_unref(chain);
    batten_chain_unref(function);
}

/* Four half circles that bend outwards and inwards in turn, and two that make a whole circle. */
TEST(closed_chains_are_counted_once_around)
{
    const double pi = 3.14159265358979323846;
    const batten_span round[2] = {{.kind = BATTEN_SPAN_ARC, .length = pi, .curvature = {1}},
                                  {.kind = BATTEN_SPAN_ARC,
                                   .length = pi,
                                   .start = {0, 2},
                                   .angle = pi,
                                   .curvature = {1}}};
    const batten_span waves[4] = {
        {.kind = BATTEN_SPAN_ARC, .length = 1.5 * pi, .curvature = {1}, .start = {0, 0}},
        {.kind = BATTEN_SPAN_ARC,
         .length = pi / 2,
         .curvature = {-1},
         .start = {-1, 1},
         .angle = -pi / 2},
        {.kind = BATTEN_SPAN_ARC,
         .length = 1.5 * pi,
         .curvature = {1},
         .start = {-2, 0},
         .angle = pi},
        {.kind = BATTEN_SPAN_ARC,
         .length = pi / 2,
         .curvature = {-1},
         .start = {-1, -1},
         .angle = pi / 2}};
    for (int wavy = 0; wavy < 2; wavy++) {
        batten_chain *chain = NULL;
        batten_fairness found;
        CHECK_OK(batten_chain_create(
            &(batten_chain_parts){2, wavy ? 4 : 2, wavy ? waves : round, NULL, true}, 1e-9,
            &chain));
        CHECK_OK(batten_chain_fairness(chain, (batten_points){2, 0, NULL}, NULL, &found));
        CHECK_INT(found.inflections, wavy ? 4 : 0);
        CHECK_INT(found.curvature_jumps, wavy ? 4 : 0);
        CHECK_INT(found.corners, 0);
        CHECK_NEAR(found.energy, wavy ? 4 * pi : 2 * pi, 1e-13);
        batten_chain_unref(chain);
    }
}
