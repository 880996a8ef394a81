#include <batten/chain.h>

#include "support/test.h"

static const double PI = 3.14159265358979323846;

/* ---- chains to test with ---- */

static batten_span arc(double x, double y, double angle, double curvature, double length)
{
    return (batten_span){.kind = BATTEN_SPAN_ARC,
                         .length = length,
                         .start = {x, y},
                         .angle = angle,
                         .curvature = {curvature}};
}

/* Where an arc ends, by turning about its centre. */
static batten_span arc_after(const batten_span *span, double curvature, double length)
{
    const double k = span->curvature[0], a = span->angle, b = a + k * span->length;
    double x = span->start[0] + span->length * cos(a),
           y = span->start[1] + span->length * sin(a);
    if (k != 0) {
        x = span->start[0] + (sin(b) - sin(a)) / k;
        y = span->start[1] - (cos(b) - cos(a)) / k;
    }
    return arc(x, y, b, curvature, length);
}

/* A straight quay, a left bend, a right bend, a straight. */
static void harbour(batten_span spans[4])
{
    spans[0] = arc(1, 2, 0.3, 0, 2);
    spans[1] = arc_after(&spans[0], 0.5, 3);
    spans[2] = arc_after(&spans[1], -0.25, 5);
    spans[3] = arc_after(&spans[2], 0, 1);
}

static batten_chain *harbour_chain(const double *breaks)
{
    batten_span spans[4];
    batten_chain *chain = NULL;
    harbour(spans);
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, breaks, false}, 1e-12, &chain));
    return chain;
}

static batten_chain *circle_chain(double radius)
{
    batten_span spans[3];
    batten_chain *chain = NULL;
    spans[0] = arc(radius, 0, PI / 2, 1 / radius, radius * 2 * PI / 3);
    spans[1] = arc_after(&spans[0], 1 / radius, radius * 2 * PI / 3);
    spans[2] = arc_after(&spans[1], 1 / radius, radius * 2 * PI / 3);
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 3, spans, NULL, true}, 1e-14 * radius,
                                 &chain));
    return chain;
}

/* Random spans in tension, one after another: not smooth at the breaks. */
static batten_chain *tense_chain(test_random *random, int dimension, int count, double most)
{
    batten_span *spans = test_array((size_t)count, sizeof *spans);
    batten_chain *chain = NULL;
    for (int i = 0; i < count; i++) {
        spans[i] = (batten_span){.kind = BATTEN_SPAN_TENSION,
                                 .length = test_random_in(random, 0.5, 2),
                                 .tension = i == 0 ? 0 : test_random_in(random, 0, most)};
        for (int k = 0; k < dimension; k++) {
            spans[i].start[k] = i ? spans[i - 1].end[k] : 1;
            spans[i].end[k] = test_random_in(random, -3, 3);
            for (int e = 0; e < 2; e++)
                spans[i].bend[e][k] = test_random_in(random, -5, 5);
        }
    }
    CHECK_OK(batten_chain_create(&(batten_chain_parts){dimension, count, spans, NULL, false}, 0,
                                 &chain));
    return chain;
}

/* ---- evaluation ---- */

TEST(arcs_follow_their_curvature_by_arc_length)
{
    batten_chain *chain = harbour_chain(NULL);
    CHECK_INT(batten_chain_dimension(chain), 2);
    CHECK_INT(batten_chain_span_count(chain), 4);
    CHECK(batten_chain_is_arcs(chain));
    CHECK(!batten_chain_is_closed(chain));
    CHECK(!batten_chain_frame(chain, NULL));
    CHECK_NEAR(batten_chain_domain(chain).b, 11, 0);
    const double *breaks = batten_chain_breaks(chain);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j <= 20; j++) {
            const double k = batten_chain_span(chain, i)->curvature[0];
            const double u = breaks[i] + (breaks[i + 1] - breaks[i]) * j / 20;
            double p[8];
            CHECK_OK(batten_chain_evaluate_side(
                chain, u, j == 20 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 3, p));
            CHECK_NEAR(hypot(p[2], p[3]), 1, 4 * DBL_EPSILON);
            CHECK_NEAR(p[2] * p[5] - p[3] * p[4], k, 4 * DBL_EPSILON);
            CHECK_NEAR(p[2] * p[4] + p[3] * p[5], 0, 4 * DBL_EPSILON);
            CHECK_NEAR(p[6] + k * k * p[2], 0, 4 * DBL_EPSILON);
            CHECK_NEAR(p[7] + k * k * p[3], 0, 4 * DBL_EPSILON);
            if (k != 0) /* the centre of the circle is where it was at the start of the span */
                CHECK_NEAR(p[0] - p[3] / k,
                           batten_chain_span(chain, i)->start[0] -
                               sin(batten_chain_span(chain, i)->angle) / k,
                           1e-13);
        }
    batten_chain_unref(chain);
}

TEST(an_arc_of_tiny_curvature_is_a_line)
{
    const batten_span straight = arc(0, 0, 0.5, 1e-200, 4), bent = arc(0, 0, 0.5, 1e-9, 4);
    batten_chain *a = NULL, *b = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &straight, NULL, false}, 0, &a));
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &bent, NULL, false}, 0, &b));
    double p[2], q[2];
    CHECK_OK(batten_chain_evaluate(a, 4, 0, p));
    CHECK_OK(batten_chain_evaluate(b, 4, 0, q));
    CHECK_NEAR(p[0], 4 * cos(0.5), 0);
    CHECK_NEAR(p[1], 4 * sin(0.5), 0);
    /* The deviation is k L^2 / 2 across. */
    CHECK_NEAR((q[1] - p[1]) * cos(0.5) - (q[0] - p[0]) * sin(0.5), 8e-9, 1e-15);
    batten_chain_unref(a);
    batten_chain_unref(b);
}

TEST(at_a_break_the_named_side_counts)
{
    batten_chain *chain = harbour_chain(NULL);
    double left[6], right[6], plain[6];
    CHECK_OK(batten_chain_evaluate_side(chain, 5, BATTEN_FROM_LEFT, 2, left));
    CHECK_OK(batten_chain_evaluate_side(chain, 5, BATTEN_FROM_RIGHT, 2, right));
    CHECK_OK(batten_chain_evaluate(chain, 5, 2, plain));
    CHECK_NEAR(left[2] * left[5] - left[3] * left[4], 0.5, 1e-15);
    CHECK_NEAR(right[2] * right[5] - right[3] * right[4], -0.25, 1e-15);
    CHECK_NEAR(hypot(left[0] - right[0], left[1] - right[1]), 0, 2e-15);
    CHECK(memcmp(plain, right, sizeof plain) == 0);
    CHECK_OK(batten_chain_evaluate(chain, 11, 2, plain)); /* the end: from the left */
    CHECK_NEAR(plain[2] * plain[5] - plain[3] * plain[4], 0, 0);
    batten_chain_unref(chain);
}

TEST(breaks_of_another_unit_change_the_pace)
{
    const double breaks[] = {-1, 0, 0.25, 100, 101};
    batten_chain *by_length = harbour_chain(NULL), *chain = harbour_chain(breaks);
    const double *own = batten_chain_breaks(by_length);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 8; j++) {
            const double pace = (own[i + 1] - own[i]) / (breaks[i + 1] - breaks[i]);
            double p[8], q[8];
            CHECK_OK(
                batten_chain_evaluate(by_length, own[i] + (own[i + 1] - own[i]) * j / 8, 3, p));
            CHECK_OK(batten_chain_evaluate(
                chain, breaks[i] + (breaks[i + 1] - breaks[i]) * j / 8, 3, q));
            for (int k = 0; k < 8; k++)
                CHECK_NEAR(q[k], p[k] * pow(pace, k / 2), 2e-12 * pow(pace, k / 2));
        }
    batten_chain_unref(by_length);
    batten_chain_unref(chain);
}

TEST(a_closed_chain_takes_any_parameter)
{
    batten_chain *circle = circle_chain(5);
    const double period = batten_chain_domain(circle).b;
    CHECK(batten_chain_is_closed(circle));
    CHECK_NEAR(period, 10 * PI, 1e-14 * period);
    for (int i = -7; i <= 12; i++) {
        double p[4];
        CHECK_OK(batten_chain_evaluate(circle, i * 2.0, 1, p));
        CHECK_NEAR(p[0], 5 * cos(i * 0.4), 1e-13);
        CHECK_NEAR(p[1], 5 * sin(i * 0.4), 1e-13);
        CHECK_NEAR(p[2], -sin(i * 0.4), 1e-13);
    }
    double start[2], end[2];
    CHECK_OK(batten_chain_evaluate(circle, 0, 0, start));
    CHECK_OK(batten_chain_evaluate(circle, period, 0, end));
    CHECK(memcmp(start, end, sizeof start) == 0); /* the end is the start again */
    CHECK_OK(batten_chain_evaluate(circle, -1e-300, 0, end));
    CHECK_NEAR(end[0], 5, 1e-14);
    CHECK_OK(batten_chain_evaluate_side(circle, 0, BATTEN_FROM_LEFT, 0, end));
    CHECK_NEAR(end[1], 0, 1e-14);
    CHECK_STATUS(batten_chain_evaluate(circle, NAN, 0, end), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_chain_evaluate(circle, INFINITY, 0, end), BATTEN_NOT_FINITE);
    batten_chain_unref(circle);
}

TEST(n7_a_chain_ends_at_its_end_and_4_ulps_beyond)
{
    batten_chain *chain = harbour_chain(NULL);
    double end[2], beyond[2], kept[2] = {7, 7};
    double u = 11;
    CHECK_OK(batten_chain_evaluate(chain, u, 0, end));
    for (int i = 0; i < 4; i++)
        u = nextafter(u, 12);
    CHECK_OK(batten_chain_evaluate(chain, u, 0, beyond));
    CHECK(memcmp(end, beyond, sizeof end) == 0);
    CHECK_STATUS(batten_chain_evaluate(chain, 11.0001, 0, kept), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_chain_evaluate(chain, -0.0001, 0, kept), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_chain_evaluate(chain, NAN, 0, kept), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_chain_evaluate(chain, 1, 4, kept), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_chain_evaluate(chain, 1, -1, kept), BATTEN_BAD_ARGUMENT);
    CHECK_BITS(kept[0], 7.0);
    batten_chain_unref(chain);
}

/* ---- making ---- */

TEST(n1_a_chain_refuses_what_is_not_finite)
{
    batten_span spans[4], bad[4];
    batten_chain *none = NULL;
    harbour(spans);
    for (int field = 0; field < 8; field++) {
        memcpy(bad, spans, sizeof bad);
        double *const places[] = {&bad[2].length,       &bad[2].start[1], &bad[2].angle,
                                  &bad[2].curvature[3], &bad[2].chord,    &bad[2].end[2],
                                  &bad[2].bend[1][0],   &bad[2].tension};
        *places[field] = field % 2 ? NAN : INFINITY;
        CHECK_STATUS(
            batten_chain_create(&(batten_chain_parts){2, 4, bad, NULL, false}, 1, &none),
            BATTEN_NOT_FINITE);
        CHECK_MESSAGE("span 3");
    }
    const double breaks[] = {0, 1, NAN, 3, 4};
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, breaks, false}, 1, &none),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("break 3 is nan");
    const double level[] = {0, 1, 1, 3, 4}, wide[] = {-1.5e308, 1, 2, 3, 1.5e308};
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, level, false}, 1, &none),
        BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("break 3 is 1, not above 1 before it");
    CHECK_STATUS(batten_chain_create(&(batten_chain_parts){2, 4, spans, wide, false}, 1, &none),
                 BATTEN_OVERFLOW);
    CHECK_MESSAGE("the breaks, from -1.5e+308 to 1.5e+308, are too far apart");
    static const int unknown[] = {-1, BATTEN_SPAN_TENSION + 1, 99};
    for (int i = 0; i < COUNT(unknown); i++) {
        memcpy(bad, spans, sizeof bad);
        bad[3].kind = (batten_span_kind)unknown[i];
        CHECK_STATUS(
            batten_chain_create(&(batten_chain_parts){2, 4, bad, NULL, false}, 1, &none),
            BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("span 4");
    }
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, NULL, false}, NAN, &none),
        BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
}

TEST(n6_a_tolerance_below_0_is_refused_by_chains)
{
    const batten_span line = arc(0, 0, 0, 0, 1);
    batten_chain *chain = NULL;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &line, NULL, false}, -1e-9, &chain),
        BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &line, NULL, false}, 0, &chain));
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_chain_to_curve(chain, 0, NULL, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_chain_to_curve(chain, INFINITY, NULL, &curve), BATTEN_BAD_ARGUMENT);
    CHECK(curve == NULL);
    batten_chain_unref(chain);
}

TEST(a_chain_names_the_gap_it_refuses)
{
    batten_span spans[4];
    batten_chain *chain = NULL;
    harbour(spans);
    spans[2].start[0] += 1e-3;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, NULL, false}, 9e-4, &chain),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("span 2 ends 0.001 from where span 3 begins");
    spans[2].start[0] -= 1e-3;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, NULL, true}, 1e-3, &chain),
        BATTEN_NOT_COMPATIBLE); /* it is not closed */
    CHECK_MESSAGE("span 1 begins");
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, NULL, true}, INFINITY, &chain));
    batten_chain_unref(chain);
}

TEST(a_chain_refuses_spans_that_cannot_be)
{
    batten_span spans[4], bad;
    batten_chain *none = NULL;
    harbour(spans);
    CHECK_STATUS(batten_chain_create(&(batten_chain_parts){2, 0, spans, NULL, false}, 1, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_chain_create(&(batten_chain_parts){0, 4, spans, NULL, false}, 1, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_chain_create(&(batten_chain_parts){4, 4, spans, NULL, false}, 1, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_chain_create(&(batten_chain_parts){3, 4, spans, NULL, false}, 1, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("arc");
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 2000000000, spans, NULL, false}, 1, &none),
        BATTEN_TOO_LARGE);
    for (int i = 0; i < 5; i++) {
        bad = spans[0];
        if (i == 0)
            bad.length = 0;
        if (i == 1)
            bad.length = -1;
        if (i == 2)
            bad.tension = -1;
        if (i == 3)
            bad.kind = (batten_span_kind)99;
        if (i == 4)
            bad.kind = (batten_span_kind)-1;
        CHECK_STATUS(
            batten_chain_create(&(batten_chain_parts){2, 1, &bad, NULL, false}, 1, &none),
            BATTEN_BAD_ARGUMENT);
    }
    const double equal[] = {0, 1, 1, 2, 3}, far[] = {-1.5e308, 0, 1, 2, 1.5e308};
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, equal, false}, 1, &none),
        BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_chain_create(&(batten_chain_parts){2, 4, spans, far, false}, 1, &none),
                 BATTEN_OVERFLOW);
    bad = arc(1e308, 0, 0, 0, 1e308);
    CHECK_STATUS(batten_chain_create(&(batten_chain_parts){2, 1, &bad, NULL, false}, 1, &none),
                 BATTEN_OVERFLOW);
    bad = (batten_span){.kind = BATTEN_SPAN_TENSION, .length = 1e200, .tension = 1e200};
    CHECK_STATUS(batten_chain_create(&(batten_chain_parts){1, 1, &bad, NULL, false}, 1, &none),
                 BATTEN_OVERFLOW);
    CHECK_MESSAGE("tension");
    CHECK(none == NULL);
}

TEST(references_to_a_chain_are_counted)
{
    batten_chain *chain = harbour_chain(NULL), *again = batten_chain_ref(chain);
    CHECK(again == chain);
    batten_chain_unref(chain);
    double p[2];
    CHECK_OK(batten_chain_evaluate(again, 3, 0, p));
    batten_chain_unref(again);
    batten_chain_unref(NULL);
}

/* ---- placing and mapping ---- */

TEST(a_placed_chain_lies_in_its_plane)
{
    batten_chain *chain = harbour_chain(NULL), *placed = NULL, *none = NULL;
    const batten_frame frame = {{10, 20, 30}, {0, 3, 0}, {1, 1, 0}};
    CHECK_OK(batten_chain_place(chain, &frame, &placed));
    CHECK_INT(batten_chain_dimension(placed), 3);
    batten_frame square;
    CHECK(batten_chain_frame(placed, &square));
    /* x made square to z: (-1, 1, 0) / sqrt 2; y = z x x = (0, 0, 1). */
    CHECK_NEAR(square.x.x, -sqrt(0.5), 1e-15);
    for (int i = 0; i <= 22; i++) {
        double p[8], q[12];
        CHECK_OK(batten_chain_evaluate(chain, i / 2.0, 3, p));
        CHECK_OK(batten_chain_evaluate(placed, i / 2.0, 3, q));
        for (int k = 0; k < 4; k++) {
            CHECK_NEAR(q[3 * k], (k ? 0 : 10) - sqrt(0.5) * p[2 * k], 4e-15);
            CHECK_NEAR(q[3 * k + 1], (k ? 0 : 20) + sqrt(0.5) * p[2 * k], 8e-15);
            CHECK_NEAR(q[3 * k + 2], (k ? 0 : 30) + p[2 * k + 1], 8e-15);
        }
    }
    CHECK_STATUS(batten_chain_place(placed, &frame, &none), BATTEN_BAD_ARGUMENT);
    const batten_frame flat = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    CHECK_STATUS(batten_chain_place(chain, &flat, &none), BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
    batten_chain_unref(chain);
    batten_chain_unref(placed);
}

/* Does the mapped chain go through the mapped points, with the mapped derivatives? */
static void check_map(const batten_chain *chain, const batten_affine *map)
{
    batten_chain *mapped = NULL;
    CHECK_OK(batten_chain_transform(chain, map, &mapped));
    const int d = batten_chain_dimension(chain);
    const batten_interval domain = batten_chain_domain(chain);
    CHECK_NEAR(batten_chain_domain(mapped).b, domain.b, 0);
    for (int i = 0; i <= 40; i++) {
        const double u = domain.a + (domain.b - domain.a) * i / 40;
        double p[12], q[12];
        CHECK_OK(batten_chain_evaluate(chain, u, 3, p));
        CHECK_OK(batten_chain_evaluate(mapped, u, 3, q));
        for (int order = 0; order <= 3; order++)
            for (int r = 0; r < d; r++) {
                double wanted = order ? 0 : map->t[r];
                for (int c = 0; c < d; c++)
                    wanted += map->m[r][c] * p[order * d + c];
                CHECK_NEAR(q[order * d + r], wanted, 4e-13 * (1 + fabs(wanted)));
            }
    }
    batten_chain_unref(mapped);
}

TEST(chains_follow_rotations_mirrors_and_scales)
{
    test_random random = test_random_begin("chains_follow_rotations_mirrors_and_scales");
    batten_chain *plane = harbour_chain(NULL), *placed = NULL;
    const batten_frame frame = {{10, 20, 30}, {0, 3, 0}, {1, 1, 0}};
    CHECK_OK(batten_chain_place(plane, &frame, &placed));
    for (int i = 0; i < test_cases(20); i++) {
        const double angle = test_random_in(&random, -4, 4),
                     s = test_random_in(&random, 0.1, 9);
        const batten_vec3 z = {0, 0, 1}, any = {1, test_random_in(&random, -1, 1), 0.5};
        const batten_vec3 side = {cos(angle), sin(angle), 0};
        batten_affine flat = batten_affine_rotation((batten_vec3){1, 2, 0}, z, angle);
        flat = batten_affine_compose(flat, batten_affine_scaling(s, s, s));
        if (i % 2)
            flat =
                batten_affine_compose(flat, batten_affine_mirror((batten_vec3){3, 1, 0}, side));
        check_map(plane, &flat);
        batten_affine map = batten_affine_rotation((batten_vec3){1, 2, 3}, any, angle);
        map = batten_affine_compose(map, batten_affine_scaling(s, s, s));
        if (i % 2)
            map = batten_affine_compose(map, batten_affine_mirror((batten_vec3){3, 1, 0}, any));
        check_map(placed, &map);
        for (int d = 1; d <= 3; d++) {
            batten_chain *tense = tense_chain(&random, d, 4, 20);
            check_map(tense, d == 3 ? &map : &flat);
            batten_chain_unref(tense);
        }
    }
    batten_chain_unref(plane);
    batten_chain_unref(placed);
}

TEST(a_mirror_turns_the_curvature_of_a_chain_and_a_scale_divides_it)
{
    batten_chain *chain = harbour_chain(NULL), *mapped = NULL;
    const batten_affine map = batten_affine_compose(
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0}),
        batten_affine_scaling(4, 4, 4));
    CHECK_OK(batten_chain_transform(chain, &map, &mapped));
    CHECK_NEAR(batten_chain_span(mapped, 1)->curvature[0], -0.125, 0);
    CHECK_NEAR(batten_chain_span(mapped, 1)->length, 12, 0);
    CHECK_NEAR(batten_chain_span(mapped, 2)->curvature[0], 0.0625, 0);
    CHECK(batten_chain_is_arcs(mapped));
    batten_chain_unref(chain);
    batten_chain_unref(mapped);
}

TEST(chains_refuse_maps_that_change_shapes)
{
    test_random random = test_random_begin("chains_refuse_maps_that_change_shapes");
    batten_chain *chain = harbour_chain(NULL), *none = NULL;
    batten_affine map = batten_affine_scaling(1, 2, 1);
    CHECK_STATUS(batten_chain_transform(chain, &map, &none), BATTEN_BAD_ARGUMENT);
    map = batten_affine_identity();
    map.m[0][1] = 1e-3;
    CHECK_STATUS(batten_chain_transform(chain, &map, &none), BATTEN_BAD_ARGUMENT);
    map = batten_affine_scaling(0, 0, 0);
    CHECK_STATUS(batten_chain_transform(chain, &map, &none), BATTEN_BAD_ARGUMENT);
    map = batten_affine_rotation((batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0}, 1);
    CHECK_STATUS(batten_chain_transform(chain, &map, &none), BATTEN_BAD_ARGUMENT);
    map = batten_affine_scaling(1e308, 1e308, 1e308);
    CHECK_STATUS(batten_chain_transform(chain, &map, &none), BATTEN_NOT_FINITE);
    CHECK(none == NULL);
    batten_chain *tense = tense_chain(&random, 1, 2, 1);
    map = batten_affine_scaling(3, 1, 7); /* on a line there is but one scale */
    check_map(tense, &map);
    batten_chain_unref(tense);
    batten_chain_unref(chain);
}
