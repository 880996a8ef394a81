#include <batten/chain.h>

#include "support/test.h"

static const double PI = 3.14159265358979323846;

static batten_span arc(double x, double y, double angle, double curvature, double length)
{
    return (batten_span){.kind = BATTEN_SPAN_ARC,
                         .length = length,
                         .start = {x, y},
                         .angle = angle,
                         .curvature = {curvature}};
}

/* A span in tension whose bends are those of (sin u, cos 2 u, u / 3). */
static void wave(int d, double tension, double a, double b, batten_span *span)
{
    *span = (batten_span){.kind = BATTEN_SPAN_TENSION, .length = b - a, .tension = tension};
    for (int e = 0; e < 2; e++) {
        const double u = e ? b : a, point[3] = {sin(u), cos(2 * u), u / 3},
                     bend[3] = {-sin(u), -4 * cos(2 * u), 0};
        for (int k = 0; k < d; k++) {
            (e ? span->end : span->start)[k] = point[k];
            span->bend[e][k] = bend[k];
        }
    }
}

static batten_chain *waves(int d, int count, double tension)
{
    batten_span *spans = test_array((size_t)count, sizeof *spans);
    double *breaks = test_array((size_t)count + 1, sizeof *breaks);
    batten_chain *chain = NULL;
    for (int i = 0; i < count; i++) {
        wave(d, tension, 4.0 * i / count, 4.0 * (i + 1) / count, &spans[i]);
        breaks[i + 1] = 4.0 * (i + 1) / count;
    }
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){d, count, spans, breaks, false}, 0, &chain));
    return chain;
}

/* The largest distance at equal parameters among `count` samples. */
static double distance(const batten_chain *chain, const batten_curve *curve, int count)
{
    const int d = batten_chain_dimension(chain);
    const batten_interval domain = batten_chain_domain(chain);
    double largest = 0;
    for (int i = 0; i <= count; i++) {
        const double u = i == count ? domain.b : domain.a + (domain.b - domain.a) * i / count;
        double p[3], q[3], sum = 0;
        CHECK_OK(batten_chain_evaluate(chain, u, 0, p));
        CHECK_OK(batten_curve_evaluate(curve, u, 0, q));
        for (int k = 0; k < d; k++)
            sum += (p[k] - q[k]) * (p[k] - q[k]);
        largest = fmax(largest, sqrt(sum));
    }
    return largest;
}

TEST(a_circle_of_arcs_becomes_an_exact_circle)
{
    const double turns[] = {0.1, 1.5, PI / 2, 1.6, 3, 2 * PI, 20};
    for (int i = 0; i < COUNT(turns); i++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const batten_span span = arc(3, 4, 0.7, sign / 2.0, 2 * turns[i]);
            batten_chain *chain = NULL;
            batten_curve *curve = NULL;
            double error = 1;
            CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0,
                                         &chain));
            CHECK_OK(batten_chain_to_curve(chain, 1e-3, &error, &curve));
            CHECK_NEAR(error, 0, 0);
            CHECK_INT(batten_curve_degree(curve), 2);
            CHECK_INT(batten_curve_point_count(curve),
                      2 * (int)ceil(turns[i] / (PI / 2) - 1e-9) + 1);
            CHECK_NEAR(batten_curve_domain(curve).b, 2 * turns[i], 0);
            for (int j = 0; j <= 300; j++) {
                double p[2];
                CHECK_OK(batten_curve_evaluate(curve, 2 * turns[i] * j / 300, 0, p));
                CHECK_NEAR(
                    hypot(p[0] - 3 + sign * 2 * sin(0.7), p[1] - 4 - sign * 2 * cos(0.7)), 2,
                    1e-14);
            }
            batten_curve_unref(curve);
            batten_chain_unref(chain);
        }
}

TEST(lines_and_arcs_meet_in_one_curve_with_the_breaks_of_the_chain)
{
    const batten_span spans[] = {arc(0, 0, 0, 0, 3), arc(3, 0, 0, 1, PI), arc(3, 2, PI, 0, 3),
                                 arc(0, 2, PI, 1, PI)};
    const double breaks[] = {0, 1, 2, 3, 4};
    batten_chain *track = NULL;
    batten_curve *curve = NULL;
    double error = 1, p[2];
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, breaks, true}, 1e-14, &track));
    CHECK_OK(batten_chain_to_curve(track, 1e-3, &error, &curve));
    CHECK_NEAR(error, 0, 0);
    CHECK(batten_curve_is_closed(curve, 1e-14));
    for (int i = 0; i <= 4; i++) {
        const double x[] = {0, 3, 3, 0, 0}, y[] = {0, 0, 2, 2, 0};
        CHECK_OK(batten_curve_evaluate(curve, i, 0, p));
        CHECK_NEAR(p[0], x[i], 1e-14);
        CHECK_NEAR(p[1], y[i], 1e-14);
    }
    batten_curve_unref(curve);
    batten_chain_unref(track);
}

TEST(a_chain_in_space_becomes_a_curve_in_space)
{
    const batten_span span = arc(3, 4, 0.7, 0.5, 7);
    const batten_frame frame = {{10, 20, 30}, {0, 3, 0}, {1, 1, 0}};
    batten_chain *flat = NULL, *chain = NULL;
    batten_curve *curve = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &flat));
    CHECK_OK(batten_chain_place(flat, &frame, &chain));
    CHECK_OK(batten_chain_to_curve(chain, 1e-3, NULL, &curve));
    CHECK_INT(batten_curve_dimension(curve), 3);
    for (int i = 0; i <= 10; i++) { /* the pieces are equal: a tenth is a piece's middle */
        double p[3], q[3];
        CHECK_OK(batten_chain_evaluate(chain, i * 0.7, 0, p));
        CHECK_OK(batten_curve_evaluate(curve, i * 0.7, 0, q));
        CHECK_NEAR(q[0] + q[1], p[0] + p[1], 1e-2); /* in the plane, near in parameter */
        CHECK_NEAR(q[0] + q[1], 30, 1e-13);
    }
    batten_curve_unref(curve);
    batten_chain_unref(chain);
    batten_chain_unref(flat);
}

TEST(spans_without_tension_become_exact_cubics)
{
    for (int d = 1; d <= 3; d++) {
        batten_chain *chain = waves(d, 7, 0);
        batten_curve *curve = NULL;
        double error = 1;
        CHECK_OK(batten_chain_to_curve(chain, 1e-3, &error, &curve));
        CHECK_NEAR(error, 0, 0);
        CHECK_INT(batten_curve_degree(curve), 3);
        CHECK_INT(batten_curve_point_count(curve), 22);
        CHECK_NEAR(distance(chain, curve, 333), 0, 4e-15);
        batten_curve_unref(curve);
        batten_chain_unref(chain);
    }
}

TEST(a_conversion_of_spans_in_tension_keeps_its_word)
{
    const double tensions[] = {0.1, 5, 100, 1e4};
    for (int i = 0; i < COUNT(tensions); i++)
        for (double tolerance = 1e-2; tolerance > 1e-10; tolerance /= 100) {
            batten_chain *chain = waves(2, 5, tensions[i]);
            batten_curve *curve = NULL;
            double error = 1;
            CHECK_OK(batten_chain_to_curve(chain, tolerance, &error, &curve));
            CHECK(error > 0 && error <= tolerance);
            CHECK_INT(batten_curve_degree(curve), 5);
            CHECK(distance(chain, curve, 4001) <= error);
            batten_curve_unref(curve);
            batten_chain_unref(chain);
        }
}

TEST(a_conversion_to_quintics_is_of_order_6)
{
    /* One piece a span: the error falls by 2^6 when the spans are halved. */
    double last = 0;
    for (int count = 16; count <= 64; count *= 2) {
        batten_chain *chain = waves(2, count, 3);
        batten_curve *curve = NULL;
        CHECK_OK(batten_chain_to_curve(chain, 1, NULL, &curve));
        CHECK_INT(batten_curve_point_count(curve), 5 * count + 1);
        const double error = distance(chain, curve, 16 * count + 1);
        if (last > 0)
            CHECK_NEAR(log2(last / error), 6, 0.25);
        last = error;
        batten_curve_unref(curve);
        batten_chain_unref(chain);
    }
}

TEST(a_conversion_agrees_to_the_second_derivative_at_the_breaks)
{
    batten_chain *chain = waves(3, 6, 4);
    batten_curve *curve = NULL;
    CHECK_OK(batten_chain_to_curve(chain, 1e-6, NULL, &curve));
    for (int i = 0; i <= 6; i++)
        for (int side = 0; side < 2; side++) {
            const double u = batten_chain_breaks(chain)[i];
            double p[9], q[9];
            CHECK_OK(batten_chain_evaluate_side(chain, u, (batten_side)side, 2, p));
            CHECK_OK(batten_curve_evaluate_side(curve, u, (batten_side)side, 2, q));
            for (int k = 0; k < 9; k++)
                CHECK_NEAR(q[k], p[k], 1e-11);
        }
    batten_curve_unref(curve);
    batten_chain_unref(chain);
}

TEST(a_conversion_counts_the_gaps_that_were_let_pass)
{
    const batten_span spans[] = {arc(0, 0, 0, 0, 1), arc(1.25, 0, 0, 0, 1)};
    batten_chain *chain = NULL;
    batten_curve *curve = NULL;
    double error = 0;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 2, spans, NULL, false}, 0.5, &chain));
    CHECK_OK(batten_chain_to_curve(chain, 1e-3, &error, &curve));
    CHECK_NEAR(error, 0.25, 1e-15);
    batten_curve_unref(curve);
    batten_chain_unref(chain);
}

TEST(a_conversion_says_when_a_tolerance_cannot_be_met)
{
    batten_chain *chain = waves(2, 3, 5);
    batten_curve *none = NULL;
    double error = 7;
    CHECK_STATUS(batten_chain_to_curve(chain, 1e-300, &error, &none), BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("span 1 of the chain comes within");
    CHECK_STATUS(batten_chain_to_curve(chain, NAN, &error, &none), BATTEN_BAD_ARGUMENT);
    CHECK_NEAR(error, 7, 0);
    CHECK(none == NULL);
    batten_chain_unref(chain);
}

TEST(n2_chains_of_any_size_convert_with_the_same_relative_error)
{
    const double sizes[] = {1e-9, 1, 1e9};
    for (int i = 0; i < COUNT(sizes); i++) {
        const double s = sizes[i];
        const batten_span span = arc(s, 0, 0.3, 0.25 / s, 9 * s);
        batten_chain *chain = NULL;
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
        CHECK_OK(batten_chain_to_curve(chain, 1e-6 * s, NULL, &curve));
        double p[2];
        CHECK_OK(batten_curve_evaluate(curve, 4 * s, 0, p));
        CHECK_NEAR(hypot(p[0] / s - 1 + 4 * sin(0.3), p[1] / s - 4 * cos(0.3)), 4, 1e-14);
        batten_curve_unref(curve);
        batten_chain_unref(chain);
    }
}

/* One random span of a kind that is not exact, about `turn` radians long. */
static batten_span random_span(test_random *random, batten_span_kind kind, double turn)
{
    const double size = pow(10, test_random_in(random, -3, 3));
    batten_span span = {.kind = kind, .length = size, .angle = test_random_in(random, -3, 3)};
    const double k = turn / size;
    if (kind == BATTEN_SPAN_SPIRAL)
        for (int i = 0; i < 4; i++)
            span.curvature[i] = test_random_in(random, -1, 1) * k * pow(size, -i);
    else if (kind == BATTEN_SPAN_ELASTICA) {
        span.curvature[0] = test_random_in(random, -1, 1) * k;
        span.curvature[1] = test_random_in(random, -1, 1) * k / size;
    } else {
        span.chord = span.angle - asin(test_random_in(random, -0.1, 0.1));
        span.curvature[0] = test_random_in(random, 0.25, 0.4) / size;
        span.curvature[1] = test_random_in(random, -0.1, 0.1) / (size * size);
    }
    return span;
}

TEST(the_error_of_a_conversion_bounds_the_true_one_and_is_of_its_size)
{
    const batten_span_kind kinds[] = {BATTEN_SPAN_SPIRAL, BATTEN_SPAN_ELASTICA,
                                      BATTEN_SPAN_GEOMETRIC};
    /* The largest sixth derivative of a piece bounds it: one by the abscissa grows steeply. */
    const double allowed[] = {6, 6, 20};
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < COUNT(kinds); i++)
        for (int round = 0; round < 60; round++) {
            const batten_span span =
                random_span(&random, kinds[i], test_random_in(&random, 2, 6));
            batten_chain *chain = NULL;
            batten_curve *curve = NULL;
            double error = 0;
            CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0,
                                         &chain));
            CHECK_OK(batten_chain_to_curve(chain, 1e-10 * span.length, &error, &curve));
            const double most = distance(chain, curve, 2000);
            CHECK(most <= error && error <= 1e-10 * span.length);
            CHECK(error <= allowed[i] * most + 1e-13 * span.length);
            batten_curve_unref(curve);
            batten_chain_unref(chain);
        }
}

TEST(the_error_of_a_beam_near_a_right_angle_is_bounded)
{
    /* Sines of 0.6 to 0.9 against the chord, whose rate changes on the span. */
    test_random random = test_random_begin(__func__);
    for (int round = 0; round < 60; round++) {
        const double sine = test_random_in(&random, 0.6, 0.85) * (round % 2 ? 1 : -1);
        batten_span span = {.kind = BATTEN_SPAN_GEOMETRIC, .length = 1, .chord = -asin(sine)};
        span.curvature[0] = test_random_in(&random, -0.05, 0.05);
        span.curvature[1] = (sine > 0 ? -1 : 1) * test_random_in(&random, 0.2, 1.2);
        batten_chain *chain = NULL;
        batten_curve *curve = NULL;
        double error = 0;
        CHECK_OK(
            batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &chain));
        CHECK_OK(batten_chain_to_curve(chain, 1e-9, &error, &curve));
        CHECK(distance(chain, curve, 2000) <= error && error <= 1e-9);
        batten_curve_unref(curve);
        batten_chain_unref(chain);
    }
}
