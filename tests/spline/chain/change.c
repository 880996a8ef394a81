#include <batten/chain.h>

#include "base/base.h"

#include "support/test.h"

/* One of every plane kind, each begun where the one before ends. */
static batten_chain *mixed_chain(void)
{
    static const struct {
        batten_span_kind kind;
        double length, curvature[4];
    } rows[] = {{BATTEN_SPAN_ARC, 2, {0.4}},
                {BATTEN_SPAN_SPIRAL, 1.5, {0.4, -0.5, 0.3, 0.2}},
                {BATTEN_SPAN_ELASTICA, 2.5, {-0.3, 0.6}},
                {BATTEN_SPAN_GEOMETRIC, 1, {0.2, -0.7}},
                {BATTEN_SPAN_ARC, 1, {0}}};
    const double breaks[] = {-1, 1, 2, 5, 6, 6.5};
    batten_span spans[COUNT(rows)];
    double at[4] = {1, 2, cos(0.5), sin(0.5)};
    batten_chain *chain = NULL;
    for (int i = 0; i < COUNT(rows); i++) {
        spans[i] = (batten_span){.kind = rows[i].kind,
                                 .length = rows[i].length,
                                 .start = {at[0], at[1]},
                                 .angle = atan2(at[3], at[2])};
        memcpy(spans[i].curvature, rows[i].curvature, sizeof rows[i].curvature);
        if (rows[i].kind == BATTEN_SPAN_GEOMETRIC)
            spans[i].chord = spans[i].angle + 0.2;
        if (chain)
            batten_chain_unref(chain);
        chain = NULL;
        CHECK_OK(batten_chain_create(&(batten_chain_parts){2, i + 1, spans, NULL, false}, 1e-12,
                                     &chain));
        CHECK_OK(batten_chain_evaluate(chain, batten_chain_domain(chain).b, 1, at));
    }
    batten_chain_unref(chain);
    chain = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, COUNT(rows), spans, breaks, false},
                                 1e-12, &chain));
    return chain;
}

static batten_chain *placed_chain(void)
{
    const batten_frame frame = {{1, 0, -2}, {0.5, 1, 0.2}, {1, -0.3, 2}};
    batten_chain *flat = mixed_chain(), *placed = NULL;
    CHECK_OK(batten_chain_place(flat, &frame, &placed));
    batten_chain_unref(flat);
    return placed;
}

static batten_chain *tense_chain(void)
{
    batten_span spans[2] = {
        {.kind = BATTEN_SPAN_TENSION, .length = 1.5, .end = {1, 2, 0.5}, .tension = 3},
        {.kind = BATTEN_SPAN_TENSION, .length = 0.5, .start = {1, 2, 0.5}, .end = {2, 0, 1}}};
    for (int k = 0; k < 3; k++) {
        spans[0].bend[1][k] = spans[1].bend[0][k] = 2 * k - 1;
        spans[0].bend[0][k] = 3 - k;
    }
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){3, 2, spans, NULL, false}, 0, &chain));
    return chain;
}

/* `part` at sign * u is `whole` at u, with all derivatives. */
static void check_same(const batten_chain *whole, const batten_chain *part, double sign)
{
    const batten_interval domain = batten_chain_domain(part);
    const int d = batten_chain_dimension(whole);
    CHECK_INT(batten_chain_dimension(part), d);
    for (int i = 0; i <= 100; i++) {
        const double u = domain.a + (domain.b - domain.a) * (i / 100.0);
        for (int side = 0; side < 2; side++) {
            double p[12], q[12], power = 1;
            CHECK_OK(batten_chain_evaluate_side(part, u, (batten_side)side, 3, p));
            if ((i == 0 && side == BATTEN_FROM_LEFT) || (i == 100 && side == BATTEN_FROM_RIGHT))
                continue; /* at an end both sides are one */
            CHECK_OK(batten_chain_evaluate_side(
                whole, sign * u, sign < 0 ? (batten_side)!side : (batten_side)side, 3, q));
            for (int m = 0; m <= 3; m++, power *= sign)
                for (int k = 0; k < d; k++)
                    CHECK_NEAR(p[m * d + k], power * q[m * d + k], 4e-12);
        }
    }
}

TEST(a_part_of_a_chain_is_the_chain_there)
{
    batten_chain *(*const makers[])(void) = {mixed_chain, placed_chain, tense_chain};
    test_random random = test_random_begin("chain-part");
    for (int i = 0; i < COUNT(makers); i++) {
        batten_chain *chain = makers[i](), *part = NULL;
        const batten_interval domain = batten_chain_domain(chain);
        for (int n = test_cases(20); n > 0; n--) {
            const double u = test_random_in(&random, domain.a, domain.b);
            const double v = test_random_in(&random, domain.a, domain.b);
            CHECK_OK(batten_chain_subrange(chain, fmin(u, v), fmax(u, v), &part));
            CHECK(batten_chain_domain(part).a == fmin(u, v));
            CHECK(batten_chain_domain(part).b == fmax(u, v));
            check_same(chain, part, 1);
            batten_chain_unref(part);
        }
        CHECK_OK(batten_chain_subrange(chain, domain.a, domain.b, &part));
        CHECK(part == chain);
        batten_chain_unref(part);
        CHECK_STATUS(batten_chain_subrange(chain, domain.b, domain.a, &part),
                     BATTEN_OUT_OF_DOMAIN);
        CHECK_STATUS(batten_chain_subrange(chain, domain.a - 1, domain.b, &part),
                     BATTEN_OUT_OF_DOMAIN);
        CHECK_STATUS(batten_chain_subrange(chain, NAN, domain.b, &part), BATTEN_NOT_FINITE);
        batten_chain_unref(chain);
    }
}

TEST(a_chain_run_backwards_goes_the_same_way)
{
    batten_chain *(*const makers[])(void) = {mixed_chain, placed_chain, tense_chain};
    for (int i = 0; i < COUNT(makers); i++) {
        batten_chain *chain = makers[i](), *back = NULL, *again = NULL;
        CHECK_OK(batten_chain_reverse(chain, &back));
        check_same(chain, back, -1);
        CHECK_OK(batten_chain_reverse(back, &again));
        check_same(chain, again, 1);
        batten_chain_unref(again);
        batten_chain_unref(back);
        batten_chain_unref(chain);
    }
}

TEST(halves_of_a_chain_join_to_the_whole)
{
    batten_chain *(*const makers[])(void) = {mixed_chain, placed_chain, tense_chain};
    for (int i = 0; i < COUNT(makers); i++) {
        batten_chain *chain = makers[i](), *left = NULL, *right = NULL, *joined = NULL;
        const batten_interval domain = batten_chain_domain(chain);
        const double middle = domain.a + 0.4 * (domain.b - domain.a);
        CHECK_OK(batten_chain_subrange(chain, domain.a, middle, &left));
        CHECK_OK(batten_chain_subrange(chain, middle, domain.b, &right));
        CHECK_OK(batten_chain_join(left, right, 1e-12, &joined));
        check_same(chain, joined, 1);
        batten_chain_unref(joined);
        CHECK_STATUS(batten_chain_join(right, left, 1e-12, &joined), BATTEN_NOT_COMPATIBLE);
        CHECK_STATUS(batten_chain_join(left, right, -1, &joined), BATTEN_BAD_ARGUMENT);
        batten_chain_unref(right);
        batten_chain_unref(left);
        batten_chain_unref(chain);
    }
    batten_chain *flat = mixed_chain(), *space = placed_chain(), *joined = NULL;
    CHECK_STATUS(batten_chain_join(flat, space, 100, &joined), BATTEN_NOT_COMPATIBLE);
    batten_chain_unref(space);
    batten_chain_unref(flat);
}

TEST(a_part_of_a_closed_chain_is_open)
{
    const double pi = 3.14159265358979323846;
    const batten_span spans[2] = {{.kind = BATTEN_SPAN_ARC,
                                   .length = pi,
                                   .start = {1, 0},
                                   .angle = pi / 2,
                                   .curvature = {1}},
                                  {.kind = BATTEN_SPAN_ARC,
                                   .length = pi,
                                   .start = {-1, 0},
                                   .angle = -pi / 2,
                                   .curvature = {1}}};
    batten_chain *ring = NULL, *part = NULL, *back = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 2, spans, NULL, true}, 1e-12, &ring));
    CHECK_OK(batten_chain_subrange(ring, 1, 2 * pi, &part));
    CHECK(!batten_chain_is_closed(part));
    CHECK_INT(batten_chain_span_count(part), 2);
    check_same(ring, part, 1);
    CHECK_OK(batten_chain_reverse(ring, &back));
    CHECK(batten_chain_is_closed(back));
    CHECK(batten_chain_is_arcs(back));
    batten_chain_unref(back);
    CHECK_STATUS(batten_chain_join(ring, part, 1, &back), BATTEN_NOT_COMPATIBLE);
    batten_chain_unref(part);
    batten_chain_unref(ring);
}

TEST(chains_that_cannot_join_are_refused)
{
    batten_span span[2] = {{.kind = BATTEN_SPAN_ARC, .length = 1},
                           {.kind = BATTEN_SPAN_ARC, .length = 1, .start = {1, 0}}};
    batten_span ring[2] = {{.kind = BATTEN_SPAN_ARC, .length = BAT_PI, .curvature = {1}},
                           {.kind = BATTEN_SPAN_ARC,
                            .length = BAT_PI,
                            .curvature = {1},
                            .start = {0, 2},
                            .angle = BAT_PI}};
    const batten_frame low = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                       high = {{0, 0, 5}, {1, 0, 0}, {0, 0, 1}};
    batten_chain *first = NULL, *second = NULL, *closed = NULL, *joined = NULL;
    batten_chain *lower = NULL, *upper = NULL, *same = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, span, NULL, false}, 0, &first));
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 1, span + 1, NULL, false}, 0, &second));
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 2, ring, NULL, true}, 1e-12, &closed));
    CHECK_STATUS(batten_chain_join(first, second, -1, &joined), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_chain_join(first, second, INFINITY, &joined), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_chain_join(first, closed, 9, &joined), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_chain_join(closed, first, 9, &joined), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("a closed chain has no end to join");
    CHECK_STATUS(batten_chain_join(second, first, 0.5, &joined), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("are 2 apart, more than 0.5");
    CHECK_OK(batten_chain_place(first, &low, &lower));
    CHECK_OK(batten_chain_place(second, &high, &upper));
    CHECK_OK(batten_chain_place(second, &low, &same));
    CHECK_STATUS(batten_chain_join(lower, second, 9, &joined), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_chain_join(lower, upper, 9, &joined), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("do not lie in one plane");
    CHECK(!joined);
    CHECK_OK(batten_chain_join(lower, same, 0, &joined));
    CHECK_INT(batten_chain_span_count(joined), 2);
    CHECK_NEAR(batten_chain_domain(joined).b, 2, 0);
    batten_chain_unref(joined);
    batten_chain_unref(lower);
    batten_chain_unref(upper);
    batten_chain_unref(same);
    batten_chain_unref(first);
    batten_chain_unref(second);
    batten_chain_unref(closed);
}
