#include "spline/chain/chain.h"

#include "support/test.h"

/* x, y, angle, curvature and its derivative, by Runge and Kutta's fourth order in long double:
 * the equation itself, no closed form. */
typedef struct {
    long double v[5];
} state;

static state slope_of(state at)
{
    const long double k = at.v[3];
    return (state){{cosl(at.v[2]), sinl(at.v[2]), k, at.v[4], -k * k * k / 2}};
}

static state along(state at, long double h, state slope)
{
    for (int i = 0; i < 5; i++)
        at.v[i] += h * slope.v[i];
    return at;
}

static state integrate(const batten_span *span, double t, int steps)
{
    state at = {
        {span->start[0], span->start[1], span->angle, span->curvature[0], span->curvature[1]}};
    const long double h = (long double)t / steps;
    for (int i = 0; i < steps; i++) {
        const state a = slope_of(at), b = slope_of(along(at, h / 2, a)),
                    c = slope_of(along(at, h / 2, b)), d = slope_of(along(at, h, c));
        for (int k = 0; k < 5; k++)
            at.v[k] += h / 6 * (a.v[k] + 2 * b.v[k] + 2 * c.v[k] + d.v[k]);
    }
    return at;
}

static void check_against_integration(const batten_span *span, double accuracy)
{
    double out[8];
    for (int i = 1; i <= 4; i++) {
        const double t = span->length * i / 4;
        const state at = integrate(span, t, 4000);
        const double angle = (double)at.v[2], k = (double)at.v[3];
        bat_span_elastica(2, span, t, 3, out);
        const double turning = fabs(k) * span->length + 1;
        CHECK_NEAR(out[0], (double)at.v[0], accuracy * span->length);
        CHECK_NEAR(out[1], (double)at.v[1], accuracy * span->length);
        CHECK_NEAR(out[2], cos(angle), accuracy * turning);
        CHECK_NEAR(out[3], sin(angle), accuracy * turning);
        CHECK_NEAR(out[2] * out[5] - out[3] * out[4], k, accuracy * turning / span->length);
        CHECK_NEAR(out[2] * out[7] - out[3] * out[6], (double)at.v[4],
                   10 * accuracy * turning * turning / span->length / span->length);
    }
}

TEST(an_elastica_is_what_its_equation_integrates_to)
{
    test_random random = test_random_begin("elastica");
    for (int c = 0; c < test_cases(40); c++) {
        const double size = pow(10, test_random_in(&random, -6, 0.6));
        const double l = pow(10, test_random_in(&random, -3, 3));
        const batten_span span = {.kind = BATTEN_SPAN_ELASTICA,
                                  .length = l,
                                  .angle = test_random_in(&random, -3, 3),
                                  .curvature = {size * test_random_in(&random, -1, 1) / l,
                                                size * test_random_in(&random, -1, 1) / l / l}};
        check_against_integration(&span, 1e-13);
    }
}

TEST(a_straight_elastica_is_a_line_and_one_almost_straight_a_cubic)
{
    double out[8];
    const batten_span line = {.kind = BATTEN_SPAN_ELASTICA, .length = 3, .angle = 0.5};
    bat_span_elastica(2, &line, 2, 3, out);
    CHECK_NEAR(out[0], 2 * cos(0.5), 1e-15);
    CHECK_NEAR(out[1], 2 * sin(0.5), 1e-15);
    CHECK_NEAR(hypot(out[4], out[5]) + hypot(out[6], out[7]), 0, 0);
    for (double size = 1e-5; size > 1e-300; size *= 1e-5) {
        const batten_span span = {
            .kind = BATTEN_SPAN_ELASTICA, .length = 1, .curvature = {size, -2 * size}};
        bat_span_elastica(2, &span, 0.5, 2, out);
        CHECK_NEAR(out[1] / size, 0.125 - 2 * 0.125 / 6, 1e-9);
        CHECK_NEAR(out[3] / size, 0.5 - 2 * 0.25 / 2, 1e-9);
    }
}

TEST(the_rectangular_elastica_has_its_known_constants)
{
    /* From the inflection, lambda^2 = slope; the largest distance from the axis is 1 with
     * lambda = sqrt(2): a quarter wave is B long and A wide. */
    const double A = 0.5990701173677961, B = 1.3110287771460599;
    const double pi = 3.14159265358979323846;
    bat_elastica at;
    bat_elastica_at(0, -2, B, &at);
    /* It begins at a right angle to the axis along which it waves. */
    CHECK_NEAR(at.point[0], 1, 1e-14);
    CHECK_NEAR(-at.point[1], A, 1e-14);
    CHECK_NEAR(-at.point[1] * B, pi / 4, 1e-14);
    CHECK_NEAR(at.turn, -pi / 2, 1e-14);
    /* The arch of least energy between parallel tangents that are 2 apart. */
    bat_elastica_at(0, -2, 2 * B, &at);
    CHECK_NEAR(at.energy * fabs(at.point[1]) / 2, 8 * A * A, 1e-13);
    CHECK_NEAR(at.energy * fabs(at.point[1]) / 2, 2.8710800442, 1e-10);
    CHECK_NEAR(at.turn, -pi, 1e-14);
    CHECK_NEAR(at.waves / 2, 1.8540746773013719, 1e-14);
}

TEST(elastica_are_right_to_rounding)
{
    /* Near the inflection, with 30 digits by Taylor series. */
    bat_elastica at;
    bat_elastica_at(-0.0399572, 0.261332, 1, &at);
    CHECK_NEAR(at.point[0], 0.999332283746271873, 1e-15);
    CHECK_NEAR(at.point[1], 0.0235591363574610224, 1e-15);
    bat_elastica_at(-2.5, 4, 1.5, &at);
    CHECK_NEAR(at.point[0], 1.2463409668594716, 4e-15);
    CHECK_NEAR(at.point[1], -0.15848871664404078, 4e-15);
    CHECK_NEAR(at.turn, 1.41269997366977507, 4e-15);
}

TEST(many_waves_of_an_elastica_repeat)
{
    const double quarter = 1.8540746773013719, width = 0.847213084793979087;
    double out[2];
    for (int waves = 1; waves <= 1000; waves *= 10) {
        /* From the crest: lambda = 1. */
        const batten_span span = {.kind = BATTEN_SPAN_ELASTICA,
                                  .length = 4 * quarter * waves,
                                  .start = {1, 2},
                                  .curvature = {sqrt(2)}};
        bat_span_elastica(2, &span, span.length, 0, out);
        CHECK_NEAR(out[0], 1 + 4 * width * waves, 1e-14 * waves);
        CHECK_NEAR(out[1], 2, 1e-13 * waves);
    }
}

TEST(n1_an_elastica_of_too_many_waves_is_refused)
{
    batten_chain *chain = NULL;
    batten_span span = {.kind = BATTEN_SPAN_ELASTICA, .length = 1e9, .curvature = {1, 0}};
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain),
        BATTEN_TOO_LARGE);
    CHECK_MESSAGE("span 1");
    span.length = 1;
    span.curvature[1] = NAN;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain),
        BATTEN_NOT_FINITE);
    CHECK(!chain);
}

TEST(a_chain_of_elastica_converts_to_quintics_and_moves)
{
    const batten_span span = {
        .kind = BATTEN_SPAN_ELASTICA, .length = 2, .angle = 1, .curvature = {-1, 0.4}};
    batten_chain *chain = NULL, *moved = NULL;
    batten_curve *curve = NULL;
    double error = 1, a[2], b[2];
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1e-9, &chain));
    CHECK_OK(batten_chain_to_curve(chain, 1e-9, &error, &curve));
    CHECK(error <= 1e-9);
    CHECK_OK(batten_chain_evaluate(chain, 1.3, 0, a));
    CHECK_OK(batten_curve_evaluate(curve, 1.3, 0, b));
    CHECK_NEAR(hypot(a[0] - b[0], a[1] - b[1]), 0, 1e-9);
    /* Mirrored and doubled. */
    const batten_affine map = batten_affine_scaling(-2, 2, 2);
    CHECK_OK(batten_chain_transform(chain, &map, &moved));
    CHECK_OK(batten_chain_evaluate(moved, 1.3, 0, b));
    CHECK_NEAR(hypot(-2 * a[0] - b[0], 2 * a[1] - b[1]), 0, 1e-14);
    batten_curve_unref(curve);
    batten_chain_unref(moved);
    batten_chain_unref(chain);
}
