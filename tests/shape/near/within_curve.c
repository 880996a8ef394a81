#include <batten/approximate.h>
#include <batten/standard.h>

#include "support/generate.h"

/* The largest distance at equal parameters among many. */
static double sampled(const batten_curve *a, const batten_curve *b, int count)
{
    const int d = batten_curve_dimension(a);
    const batten_interval domain = batten_curve_domain(a);
    double largest = 0;
    for (int i = 0; i <= count; i++) {
        const double u = domain.a + (double)i / count * (domain.b - domain.a);
        double p[3], q[3], sum = 0;
        CHECK_OK(batten_curve_evaluate(a, u, 0, p));
        CHECK_OK(batten_curve_evaluate(b, u, 0, q));
        for (int k = 0; k < d; k++)
            sum += (p[k] - q[k]) * (p[k] - q[k]);
        largest = fmax(largest, sqrt(sum));
    }
    return largest;
}

TEST(the_bound_holds_at_ten_thousand_places_and_says_hardly_more)
{
    batten_curve *circle = NULL;
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    for (int p = 1; p <= 6; p++) {
        batten_curve *made = NULL;
        double error = -1;
        CHECK_OK(batten_curve_approximate(circle, p, 1e-3, &error, &made));
        CHECK_INT(batten_curve_degree(made), p);
        CHECK(!batten_curve_is_rational(made));
        CHECK(batten_curve_is_periodic(made));
        const double largest = sampled(circle, made, 10000);
        CHECK(error <= 1e-3 && largest <= error);
        CHECK(error <= 1.2 * largest);
        batten_curve_unref(made);
    }
    batten_curve_unref(circle);
}

TEST(random_curves_come_within_the_tolerance_whatever_their_form)
{
    test_random random = test_random_begin(__func__);
    const test_wish wish = {.tame = true, .most_points = 14};
    for (int i = 0; i < test_cases(30); i++) {
        batten_curve *curve = i % 5 ? test_curve(&random, &wish)
                                    : test_periodic_curve(&random, &wish),
                     *made = NULL;
        const double tolerance = 0.02 * test_curve_size(curve);
        const batten_interval domain = batten_curve_domain(curve);
        double error = -1;
        CHECK_OK(batten_curve_approximate(curve, 1 + i % 6, tolerance, &error, &made));
        CHECK(error <= tolerance);
        CHECK(sampled(curve, made, 500) <= error);
        CHECK(batten_curve_domain(made).a == domain.a &&
              batten_curve_domain(made).b == domain.b);
        batten_curve_unref(made);
        batten_curve_unref(curve);
    }
}

TEST(a_cubic_that_was_elevated_and_refined_comes_back)
{
    test_random random = test_random_begin(__func__);
    const test_wish cubic = {.tame = true,
                             .degree = 3,
                             .dimension = 2,
                             .most_points = 8,
                             .rational = TEST_NEVER,
                             .clamped = TEST_ALWAYS};
    for (int i = 0; i < test_cases(10); i++) {
        batten_curve *curve = test_curve(&random, &cubic), *raised = NULL, *made = NULL;
        double error = -1;
        CHECK_OK(batten_curve_elevate(curve, 3, &raised));
        CHECK_OK(batten_curve_approximate(raised, 3, 1e-3, &error, &made));
        CHECK(sampled(curve, made, 300) <= error);
        CHECK(batten_curve_point_count(made) <= 40);
        batten_curve_unref(made);
        CHECK_OK(batten_curve_approximate(raised, 6, 1e-9, &error, &made));
        CHECK(batten_curve_point_count(made) <= batten_curve_point_count(raised));
        batten_curve_unref(made);
        batten_curve_unref(raised);
        batten_curve_unref(curve);
    }
}

TEST(a_ring_stays_a_ring_and_loses_what_refining_added)
{
    const double points[] = {0, 0, 2, -1, 4, 0, 4, 2, 2, 3, 0, 2},
                 period[] = {0, 1, 2.5, 3, 4, 5, 6};
    batten_curve *ring = NULL, *refined = NULL, *made = NULL;
    double knots[30], error = -1;
    for (int i = 0; i < 30; i++)
        knots[i] = 6 * (i + 0.5) / 31;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){2, 6, points}, 3, NULL, period, &ring));
    CHECK_OK(batten_curve_refine(ring, 30, knots, &refined));
    CHECK_INT(batten_curve_point_count(refined), 6 + 30 + 3);
    CHECK_OK(batten_curve_approximate(refined, 3, 1e-6, &error, &made));
    CHECK(batten_curve_is_periodic(made));
    CHECK(batten_curve_point_count(made) <= 2 * 6 + 3);
    CHECK(error <= 1e-6 && sampled(ring, made, 1000) <= error);
    batten_curve_unref(made);
    batten_curve_unref(refined);
    batten_curve_unref(ring);
}

/* A polynomial of degree 7 over one span by cubics: the fourth power of the spans. */
TEST(a_sixteenth_of_the_tolerance_takes_twice_the_spans_of_cubics)
{
    const double points[] = {0, 0, 1, 3, 2, -2, 3, 4, 4, -3, 5, 2, 6, -1, 7, 1},
                 breaks[] = {0, 1};
    batten_curve *curve = NULL;
    double spans[4];
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){7, 1, breaks}, points, NULL, &curve));
    for (int i = 0; i < 4; i++) {
        batten_curve *made = NULL;
        CHECK_OK(batten_curve_approximate(curve, 3, 1e-4 / pow(16, i), NULL, &made));
        spans[i] = batten_curve_point_count(made) - 3;
        batten_curve_unref(made);
    }
    for (int i = 1; i < 4; i++)
        CHECK_NEAR(spans[i] / spans[i - 1], 2, 0.5);
    batten_curve_unref(curve);
}

TEST(corners_and_ends_stay)
{
    const double points[] = {0, 0, 1, 2, 2, 2, 3, 0, 4, 1, 5, 1, 6, 0}, breaks[] = {0, 1, 3},
                 weights[] = {1, 2, 1, 1, 1, 3, 1};
    batten_curve *curve = NULL, *made = NULL;
    CHECK_OK(
        batten_curve_from_bezier(2, (batten_pieces){3, 2, breaks}, points, weights, &curve));
    CHECK_OK(batten_curve_approximate(curve, 3, 1e-2, NULL, &made));
    for (int i = 0; i < 3; i++) {
        double at[2];
        CHECK_OK(batten_curve_evaluate(made, breaks[i], 0, at));
        CHECK_NEAR(at[0], points[6 * i], 1e-14);
        CHECK_NEAR(at[1], points[6 * i + 1], 1e-14);
    }
    double left[4], right[4];
    CHECK_OK(batten_curve_evaluate_side(made, 1, BATTEN_FROM_LEFT, 1, left));
    CHECK_OK(batten_curve_evaluate_side(made, 1, BATTEN_FROM_RIGHT, 1, right));
    CHECK(left[3] < 0 && right[3] > 0);
    batten_curve_unref(made);
    batten_curve_unref(curve);
}

/* A clothoid; an arc; two arcs that meet smoothly; an arc and a line that meet in a corner. */
TEST(chains_become_plain_splines_at_their_own_pace)
{
    const batten_span spans[4][2] = {
        {{.kind = BATTEN_SPAN_SPIRAL,
          .length = 5,
          .start = {1, 1},
          .angle = 0.3,
          .curvature = {0.2, 0.25}}},
        {{.kind = BATTEN_SPAN_ARC, .length = 4, .curvature = {0.5}}},
        {{.kind = BATTEN_SPAN_ARC, .length = 1, .curvature = {1}},
         {.kind = BATTEN_SPAN_ARC,
          .length = 2,
          .start = {sin(1), 1 - cos(1)},
          .angle = 1,
          .curvature = {-0.5}}},
        {{.kind = BATTEN_SPAN_ARC, .length = 1, .curvature = {1}},
         {.kind = BATTEN_SPAN_ARC, .length = 2, .start = {sin(1), 1 - cos(1)}, .angle = -1}}};
    for (int c = 0; c < 4; c++) {
        const batten_frame frame = {{3, 2, 1}, {0, 1, 0}, {1, 0, 0}};
        batten_chain *flat = NULL, *chain = NULL;
        batten_curve *made = NULL;
        double error = -1, largest = 0, left[6], right[6];
        CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1 + c / 2, spans[c], NULL, false},
                                     1e-12, &flat));
        CHECK_OK(batten_chain_place(flat, &frame, &chain));
        CHECK_OK(batten_chain_approximate(chain, 3, 1e-4, &error, &made));
        CHECK(error <= 1e-4);
        CHECK(!batten_curve_is_rational(made));
        const double end = batten_chain_domain(chain).b;
        for (int i = 0; i <= 1000; i++) {
            double p[3], q[3];
            CHECK_OK(batten_curve_evaluate(made, end * i / 1000, 0, p));
            CHECK_OK(batten_chain_evaluate(chain, end * i / 1000, 0, q));
            largest = fmax(largest, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
        }
        CHECK(largest <= error);
        if (c > 1) {
            CHECK_OK(batten_curve_evaluate_side(made, 1, BATTEN_FROM_LEFT, 1, left));
            CHECK_OK(batten_curve_evaluate_side(made, 1, BATTEN_FROM_RIGHT, 1, right));
            const double jump = hypot(left[4] - right[4], left[5] - right[5]);
            CHECK(c == 2 ? jump < 1e-9 : jump > 1);
        }
        batten_curve_unref(made);
        batten_chain_unref(chain);
        batten_chain_unref(flat);
    }
}

TEST(N1_N6_K9_what_cannot_be_approximated_is_refused)
{
    batten_curve *circle = NULL, *none = NULL;
    batten_chain *chain = NULL;
    const batten_span arc = {.kind = BATTEN_SPAN_ARC, .length = 1, .curvature = {1}};
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &arc, NULL, false}, 0, &chain));
    CHECK_STATUS(batten_curve_approximate(circle, 3, 0, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_approximate(circle, 3, NAN, NULL, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_approximate(circle, 0, 1, NULL, &none), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_approximate(circle, 26, 1, NULL, &none), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_approximate(circle, 3, 1e-16, NULL, &none),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("below the rounding");
    CHECK_STATUS(batten_chain_approximate(chain, 3, -1, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
    batten_chain_unref(chain);
    batten_curve_unref(circle);
}
