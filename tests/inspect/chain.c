#include <batten/curvature.h>
#include <batten/measure.h>

#include "inspect/local.h"
#include "numeric/quadrature.h"
#include "support/test.h"

TEST(an_arc_of_a_chain_has_its_curvature_tangent_and_length)
{
    const batten_span span = {.kind = BATTEN_SPAN_ARC,
                              .length = 2,
                              .start = {3, 0},
                              .angle = 1,
                              .curvature = {-0.25}};
    batten_chain *chain = NULL;
    batten_curve_local at;
    double length = 0;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
    CHECK_OK(batten_chain_local_at(chain, 1, BATTEN_FROM_RIGHT, &at));
    CHECK_NEAR(at.curvature, -0.25, 1e-15);
    CHECK_NEAR(at.curvature_rate, 0, 1e-15);
    CHECK_NEAR(at.tangent.x, cos(0.75), 1e-15);
    CHECK_NEAR(at.speed, 1, 1e-15);
    CHECK_OK(batten_chain_length(chain, NULL, &length));
    CHECK_NEAR(length, 2, 1e-15);
    CHECK_STATUS(batten_chain_local_at(chain, 3, BATTEN_FROM_RIGHT, &at), BATTEN_OUT_OF_DOMAIN);
    batten_chain_unref(chain);
}

TEST(a_clothoid_has_the_rate_of_its_curvature_in_the_plane_and_in_space)
{
    const batten_span span = {.kind = BATTEN_SPAN_SPIRAL, .length = 2, .curvature = {0.1, 0.3}};
    const batten_frame frame = {{0, 0, 5}, {0, 1, 0}, {1, 0, 0}};
    batten_chain *chain = NULL, *placed = NULL;
    batten_curve_local at;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
    CHECK_OK(batten_chain_place(chain, &frame, &placed));
    for (int i = 0; i <= 8; i++) {
        const double s = i / 4.0;
        CHECK_OK(batten_chain_local_at(chain, s, BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.curvature, 0.1 + 0.3 * s, 1e-14);
        CHECK_NEAR(at.curvature_rate, 0.3, 1e-13);
        CHECK_OK(batten_chain_local_at(placed, s, BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.curvature, 0.1 + 0.3 * s, 1e-14);
        CHECK_NEAR(at.torsion, 0, 1e-13);
    }
    batten_chain_unref(placed);
    batten_chain_unref(chain);
}

/* P = (2 t - t^2) d slows down to a stop at t = 1, P = t^2 d starts from one: the tangent is d both times. */
TEST(where_a_chain_stands_still_its_tangent_is_that_of_the_second_derivative)
{
    const double d[2] = {0.6, -0.8};
    for (int stops = 0; stops < 2; stops++) {
        const double bend = stops ? -2 : 2;
        const batten_span span = {
            .kind = BATTEN_SPAN_TENSION,
            .length = 1,
            .end = {d[0], d[1]},
            .bend = {{bend * d[0], bend * d[1]}, {bend * d[0], bend * d[1]}}};
        batten_chain *chain = NULL;
        batten_curve_local at = {.speed = 7, .curvature = 7};
        CHECK_OK(
            batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
        CHECK_STATUS(batten_chain_local_at(chain, stops,
                                           stops ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &at),
                     BATTEN_SINGULAR_HERE);
        CHECK_MESSAGE("the first derivative vanishes");
        CHECK_NEAR(at.tangent.x, d[0], 1e-14);
        CHECK_NEAR(at.tangent.y, d[1], 1e-14);
        CHECK_NEAR(at.point.x, stops ? d[0] : 0, 1e-15);
        CHECK(at.speed == 0 && at.curvature == 0);
        CHECK_OK(batten_chain_local_at(chain, 0.5, BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.speed, 1, 1e-14);
        CHECK_NEAR(at.tangent.x, d[0], 1e-14);
        batten_chain_unref(chain);
    }
}

static void check_bend(int d, const batten_span *span, double t, bat_bend due)
{
    bat_bend bend = {-7, -7, -7};
    bat_span_bend(d, span, t, &bend);
    CHECK_NEAR(bend.speed, due.speed, 1e-14);
    CHECK_NEAR(bend.curvature, due.curvature, 1e-14);
    CHECK_NEAR(bend.rate, due.rate, 1e-13);
}

/* The parabola (t, t^2 / 2), t^3 / 6 as a function, a curvature of degree 3, and a stop. */
TEST(the_bend_of_a_span_is_that_of_its_formula)
{
    const batten_span parabola = {.kind = BATTEN_SPAN_TENSION,
                                  .length = 1,
                                  .end = {1, 0.5},
                                  .bend = {{0, 1}, {0, 1}}},
                      cube = {.kind = BATTEN_SPAN_TENSION,
                              .length = 1,
                              .end = {1.0 / 6},
                              .bend = {{0}, {1}}},
                      stop = {.kind = BATTEN_SPAN_TENSION,
                              .length = 1,
                              .end = {1, 2},
                              .bend = {{-2, -4}, {-2, -4}}},
                      spiral = {.kind = BATTEN_SPAN_SPIRAL,
                                .length = 1,
                                .curvature = {0.1, 0.3, 0.5, 0.7}},
                      arc = {.kind = BATTEN_SPAN_ARC, .length = 1, .curvature = {-0.25}};
    for (int i = 0; i <= 8; i++) {
        const double t = i / 8.0, s = 1 + t * t;
        check_bend(2, &parabola, t, (bat_bend){sqrt(s), pow(s, -1.5), -3 * t * pow(s, -3)});
        check_bend(3, &parabola, t, (bat_bend){sqrt(s), pow(s, -1.5), -3 * t * pow(s, -3)});
        check_bend(1, &cube, t, (bat_bend){1, t, 1});
        check_bend(2, &arc, t, (bat_bend){1, -0.25, 0});
        check_bend(2, &spiral, t,
                   (bat_bend){1, 0.1 + 0.3 * t + 0.25 * t * t + 0.7 / 6 * t * t * t,
                              0.3 + 0.5 * t + 0.35 * t * t});
        if (i < 8)
            check_bend(2, &stop, t, (bat_bend){2 * (1 - t) * sqrt(5), 0, 0});
    }
    check_bend(2, &stop, 1, (bat_bend){0, 0, 0});
}

static bat_span_sums sums_of(int d, const batten_span *span)
{
    bat_ruler ruler;
    bat_span_sums sums = {-7, -7, -7};
    bat_gauss(BAT_RULER_NODES, ruler.nodes, ruler.weights);
    bat_span_integrate(d, span, &ruler, &sums);
    return sums;
}

/* (t, t^2 / 2) from 0 to T: with s = sin(atan(T)) the energy is s - s^3 / 3, and the variation nine times
 * s^3 / 3 - 3 s^5 / 5 + 3 s^7 / 7 - s^9 / 9. */
TEST(length_energy_and_variation_of_a_parabola_are_those_of_its_formula)
{
    static const double ends[] = {0.5, 1, 4, 40};
    for (int i = 0; i < 2 * COUNT(ends); i++) {
        const double T = ends[i / 2], s = T / sqrt(1 + T * T);
        const batten_span span = {.kind = BATTEN_SPAN_TENSION,
                                  .length = T,
                                  .end = {T, T * T / 2},
                                  .bend = {{0, 1}, {0, 1}}};
        const bat_span_sums sums = sums_of(2 + i % 2, &span);
        const double length = (T * sqrt(1 + T * T) + asinh(T)) / 2, energy = s - s * s * s / 3,
                     variation = 9 * (pow(s, 3) / 3 - 3 * pow(s, 5) / 5 + 3 * pow(s, 7) / 7 -
                                      pow(s, 9) / 9);
        CHECK_NEAR(sums.length, length, 1e-12 * length);
        CHECK_NEAR(sums.energy, energy, 1e-12 * energy);
        CHECK_NEAR(sums.variation, variation, 1e-12 * variation);
    }
}

/* y'' = sinh(t (1 - x)) / sinh(t): the energy is (sinh(2 t) / (4 t) - 1 / 2) / sinh(t)^2, and so on. */
TEST(a_span_in_tension_is_measured_where_it_bends)
{
    static const double tensions[] = {0.5, 8, 60, 70, 1000, 100000};
    for (int i = 0; i < COUNT(tensions); i++) {
        const double t = tensions[i];
        const batten_span span = {
            .kind = BATTEN_SPAN_TENSION, .length = 1, .tension = t, .bend = {{1}, {0}}};
        const bat_span_sums sums = sums_of(1, &span);
        const double over = t < 300 ? 1 / (sinh(t) * sinh(t)) : 0,
                     whole = t < 300 ? sinh(2 * t) * over / (4 * t) : 1 / (2 * t);
        CHECK_NEAR(sums.length, 1, 1e-12);
        CHECK_NEAR(sums.energy, whole - over / 2, 2e-12 * whole);
        CHECK_NEAR(sums.variation, t * t * (whole + over / 2), 2e-12 * t * t * whole);
    }
}

/* Curvatures along arc length: 3 of an arc, 1 + 2 s of a clothoid. */
TEST(spans_by_length_have_exact_sums)
{
    const batten_span arc = {.kind = BATTEN_SPAN_ARC, .length = 2, .curvature = {-3}},
                      clothoid = {.kind = BATTEN_SPAN_SPIRAL, .length = 3, .curvature = {1, 2}};
    const bat_span_sums a = sums_of(2, &arc), c = sums_of(2, &clothoid);
    CHECK_BITS(a.length, 2);
    CHECK_NEAR(a.energy, 18, 1e-13);
    CHECK_BITS(a.variation, 0);
    CHECK_BITS(c.length, 3);
    CHECK_NEAR(c.energy, (343 - 1) / 6.0, 1e-12);
    CHECK_NEAR(c.variation, 12, 1e-13);
}

/* Spans of each kind one after another; with the bound on the error. */
TEST(the_length_of_a_chain_is_the_sum_of_its_spans)
{
    const batten_span spans[] = {{.kind = BATTEN_SPAN_ARC, .length = 2, .start = {0, 0}},
                                 {.kind = BATTEN_SPAN_TENSION,
                                  .length = 1,
                                  .start = {2, 0},
                                  .end = {3, 0.5},
                                  .bend = {{0, 1}, {0, 1}}}};
    batten_chain *chain = NULL;
    double length = 0, error = 0;
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 2, spans, NULL, false}, 1e-9, &chain));
    CHECK_OK(batten_chain_length(chain, &error, &length));
    CHECK_NEAR(length, 2 + (sqrt(2) + asinh(1)) / 2, 1e-12);
    CHECK(error > 1e-13 && error < 1e-11);
    batten_chain_unref(chain);
}
