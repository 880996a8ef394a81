#include "spline/chain/chain.h"

#include "support/test.h"

/* The pendulum in arc length, which has no singularity: x, y and the angle from the chord by
 * Runge and Kutta in long double, up to arc length s. */
typedef struct {
    long double v[3];
} state;

static state slope_of(const batten_span *span, state at)
{
    return (state){
        {cosl(at.v[2]), sinl(at.v[2]), span->curvature[0] + span->curvature[1] * at.v[0]}};
}

static state along(state at, long double h, state slope)
{
    for (int i = 0; i < 3; i++)
        at.v[i] += h * slope.v[i];
    return at;
}

static state integrate(const batten_span *span, double s, int steps)
{
    state at = {{0, 0, span->angle - span->chord}};
    const long double h = (long double)s / steps;
    for (int i = 0; i < steps; i++) {
        const state a = slope_of(span, at), b = slope_of(span, along(at, h / 2, a)),
                    c = slope_of(span, along(at, h / 2, b)),
                    d = slope_of(span, along(at, h, c));
        for (int k = 0; k < 3; k++)
            at.v[k] += h / 6 * (a.v[k] + 2 * b.v[k] + 2 * c.v[k] + d.v[k]);
    }
    return at;
}

/* A span whose sine stays within `steepest`. */
static batten_span random_span(test_random *random, double steepest)
{
    const double l = pow(10, test_random_in(random, -3, 3));
    const double first = steepest * test_random_in(random, -1, 1);
    const double last = steepest * test_random_in(random, -1, 1);
    const double room = steepest - fmax(fabs(first), fabs(last));
    const double b = 8 * room * test_random_in(random, -1, 1);
    return (batten_span){.kind = BATTEN_SPAN_GEOMETRIC,
                         .length = l,
                         .angle = asin(first),
                         .curvature = {(last - first - b / 2) / l, b / l / l}};
}

TEST(a_geometric_span_is_the_beam_under_a_linear_moment)
{
    test_random random = test_random_begin("geometric");
    for (int c = 0; c < test_cases(40); c++) {
        batten_span span = random_span(&random, c % 3 == 0 ? 0.99999 : 0.9);
        double out[8];
        for (double s = span.length / 8; s < 4 * span.length; s += span.length / 4) {
            const state at = integrate(&span, s, 4000);
            const double x = (double)at.v[0], l = span.length;
            if (x >= l)
                break;
            bat_span_geometric(2, &span, x, 2, out);
            CHECK_NEAR(out[0], x, 0);
            /* x itself is rounded, and a steep curve turns that into more. */
            const double slope = fabs(tan((double)at.v[2])) + 1;
            CHECK_NEAR(out[1], (double)at.v[1], 2e-13 * l * slope);
            CHECK_NEAR(atan(out[3]), (double)at.v[2], 2e-13 * slope);
        }
    }
}

TEST(a_geometric_span_without_a_slope_of_curvature_is_an_arc)
{
    const double angles[] = {1e-8, 0.3, 1.2, 1.5};
    for (int i = 0; i < COUNT(angles); i++) {
        const double a = angles[i], k = -2 * sin(a);
        const batten_span span = {.kind = BATTEN_SPAN_GEOMETRIC,
                                  .length = 1,
                                  .start = {1, 1},
                                  .angle = 0.7 + a,
                                  .chord = 0.7,
                                  .curvature = {k}};
        for (int j = 0; j <= 10; j++) {
            double out[8];
            bat_span_geometric(2, &span, j / 10.0, 2, out);
            const double x = cos(0.7) * (out[0] - 1) + sin(0.7) * (out[1] - 1);
            const double y = cos(0.7) * (out[1] - 1) - sin(0.7) * (out[0] - 1);
            const double centre = 1 / (2 * tan(a));
            CHECK_NEAR(x, j / 10.0, 1e-15);
            if (a > 0.1)
                CHECK_NEAR(hypot(x - 0.5, y + centre), -1 / k, 1e-13);
        }
    }
}

TEST(derivatives_of_a_geometric_span_are_limits_of_differences)
{
    const batten_span span = {.kind = BATTEN_SPAN_GEOMETRIC,
                              .length = 2,
                              .angle = 0.9,
                              .chord = 0.2,
                              .curvature = {-0.6, 0.3}};
    const double h = 1e-4;
    for (int i = 1; i < 8; i++) {
        double before[8], at[8], after[8];
        bat_span_geometric(2, &span, i / 4.0 - h, 3, before);
        bat_span_geometric(2, &span, i / 4.0, 3, at);
        bat_span_geometric(2, &span, i / 4.0 + h, 3, after);
        for (int k = 0; k < 6; k++)
            CHECK_NEAR(at[k + 2], (after[k] - before[k]) / (2 * h), 1e-6);
        const double bend = at[2] * at[5] - at[3] * at[4];
        CHECK_NEAR(bend / pow(hypot(at[2], at[3]), 3), -0.6 + 0.3 * i / 4.0, 1e-13);
    }
}

TEST(integrals_of_a_geometric_span_are_those_of_an_arc)
{
    for (double a = 0.1; a < 1.55; a += 0.1) {
        bat_geometric at;
        const double k = 2 * sin(a);
        bat_geometric_at(sin(a), -k, 0, &at);
        CHECK_NEAR(at.rise, 0, 1e-15 / cos(a));
        CHECK_NEAR(at.length, 2 * a / k, 1e-13);
        CHECK_NEAR(at.energy, 2 * a * k, 1e-13);
        CHECK_NEAR(at.moments[0], 2 * tan(a) / k, 1e-12 / pow(cos(a), 3));
    }
}

TEST(n1_a_geometric_span_that_turns_over_is_refused)
{
    batten_chain *chain = NULL;
    batten_span span = {.kind = BATTEN_SPAN_GEOMETRIC, .length = 1, .angle = 1.6};
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("span 1 begins at 1.6 radians");
    /* Steepest between its ends. */
    span.angle = 0.5;
    span.curvature[0] = 4;
    span.curvature[1] = -8;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("right angle away from its chord");
    span.chord = NAN;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain),
        BATTEN_NOT_FINITE);
    CHECK(!chain);
}

TEST(g4_a_geometric_span_may_come_close_to_a_right_angle)
{
    /* The sine touches 1 - gap in the middle; the rise grows like the logarithm of the gap. */
    double before = 0;
    for (double gap = 1e-2; gap > 1e-12; gap /= 10) {
        bat_geometric at;
        bat_geometric_at(-gap, 4, -8, &at);
        CHECK(isfinite(at.rise) && at.rise > before);
        if (gap < 1e-6)
            CHECK_NEAR(at.rise - before, log(10) / 2 * sqrt(0.5), 1e-4);
        before = at.rise;
    }
}
