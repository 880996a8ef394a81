#include "shape/bent/two_angle.h"
#include "support/test.h"

static const bat_span_family *const arcs = &bat_family_arcs;

TEST(arcs_linearise_to_three_and_one)
{
    bat_end_curvatures k;
    CHECK_OK(arcs->curvatures(0, 0, 2, 0, &k));
    CHECK(k.k0 == 0 && k.k1 == 0);
    CHECK_NEAR(k.k0_alpha, -1.5, 1e-15);
    CHECK_NEAR(k.k0_beta, -0.5, 1e-15);
    CHECK_NEAR(k.k1_alpha, 0.5, 1e-15);
    CHECK_NEAR(k.k1_beta, 1.5, 1e-15);
}

TEST(derivatives_of_the_curvatures_of_arcs_are_their_differences)
{
    test_random random = test_random_begin("family arcs");
    const double h = 1e-5;
    for (int i = 0; i < 100; i++) {
        const double a = test_random_in(&random, -2, 2), b = test_random_in(&random, -2, 2);
        bat_end_curvatures k, p, m;
        CHECK_OK(arcs->curvatures(a, b, 1.7, 0, &k));
        CHECK_OK(arcs->curvatures(a + h, b, 1.7, 0, &p));
        CHECK_OK(arcs->curvatures(a - h, b, 1.7, 0, &m));
        CHECK_NEAR(k.k0_alpha, (p.k0 - m.k0) / (2 * h), 1e-9);
        CHECK_NEAR(k.k1_alpha, (p.k1 - m.k1) / (2 * h), 1e-9);
        CHECK_OK(arcs->curvatures(a, b + h, 1.7, 0, &p));
        CHECK_OK(arcs->curvatures(a, b - h, 1.7, 0, &m));
        CHECK_NEAR(k.k0_beta, (p.k0 - m.k0) / (2 * h), 1e-9);
        CHECK_NEAR(k.k1_beta, (p.k1 - m.k1) / (2 * h), 1e-9);
    }
}

TEST(spans_of_arcs_have_the_curvatures_and_ends_of_their_family)
{
    test_random random = test_random_begin("family arcs spans");
    for (int i = 0; i < 100; i++) {
        const double a = test_random_in(&random, -2, 2), b = test_random_in(&random, -2, 2);
        bat_end_curvatures k;
        batten_span spans[BAT_FAMILY_SPANS];
        batten_chain *chain = NULL;
        int count = 0;
        double at[4];
        CHECK_OK(arcs->curvatures(a, b, 1.7, 0, &k));
        CHECK_OK(arcs->spans(a, b, 1.7, 0, spans, &count));
        CHECK_NEAR(spans[0].curvature[0], k.k0, 1e-13);
        CHECK_NEAR(spans[count - 1].curvature[0], k.k1, 1e-13);
        CHECK_OK(batten_chain_create(&(batten_chain_parts){2, count, spans, NULL, false}, 1e-12,
                                     &chain));
        CHECK_OK(batten_chain_evaluate(chain, batten_chain_domain(chain).b, 1, at));
        CHECK_NEAR(at[0], 1.7, 1e-12);
        CHECK_NEAR(at[1], 0, 1e-12);
        CHECK_NEAR(at[2], cos(b), 1e-12);
        CHECK_NEAR(at[3], sin(b), 1e-12);
        batten_chain_unref(chain);
    }
}
