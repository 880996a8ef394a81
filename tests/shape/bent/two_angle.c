#include "shape/bent/two_angle.h"
#include "support/test.h"

/* Rounding of the directions alone makes jumps of curvature when spans are short and the points
 * uneven: no step of Newton takes these away, and the spline is none the worse. */
TEST(short_uneven_spans_do_not_keep_the_driver_from_its_end)
{
    static const batten_span_family chosen[] = {
        BATTEN_FAMILY_LOCAL_CUBIC, BATTEN_FAMILY_EULER_SPIRAL, BATTEN_FAMILY_ELASTICA};
    enum { POINTS = 20000 };
    double *points = test_array(2 * POINTS, sizeof *points);
    test_random random = test_random_begin("uneven");
    for (int i = 0; i < POINTS; i++) {
        const double a = 6 * (i + 0.3 * test_random_in(&random, -1, 1)) / POINTS;
        points[2 * i] = 10 * cos(a) + 0.2 * sin(9 * a);
        points[2 * i + 1] = 10 * sin(a);
    }
    for (int k = 0; k < COUNT(chosen); k++) {
        batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
        batten_chain_nonlinear_report report;
        batten_chain *chain = NULL;
        options.family = chosen[k];
        CHECK_OK(batten_chain_nonlinear((batten_points){2, POINTS, points}, &options, NULL,
                                        NULL, &report, &chain));
        CHECK(report.error <= 1e-10 * report.curvature);
        batten_chain_unref(chain);
    }
}

/* ---- what every family promises ---- */

static const bat_span_family *const families[] = {
    &bat_family_local_cubic,  &bat_family_local_tension, &bat_family_geometric,
    &bat_family_euler_spiral, &bat_family_arcs,          &bat_family_elastica,
    &bat_family_hobby};

/* Two angles of tangents within `most`, and half of the limit of the family. */
static void random_angles(test_random *random, const bat_span_family *family, double most,
                          double *alpha, double *beta)
{
    const double limit = fmin(most, family->limit / 2);
    *alpha = test_random_in(random, -limit, limit);
    *beta = test_random_in(random, -limit, limit);
}

TEST(derivatives_of_end_curvatures_are_their_differences_in_every_family)
{
    test_random random = test_random_begin("families");
    const double h = 1e-4;
    for (int f = 0; f < COUNT(families); f++)
        for (int i = 0; i < 40; i++) {
            const bat_span_family *family = families[f];
            const double tension = i % 4 ? test_random_in(&random, 0, 12) : 0;
            double a, b;
            random_angles(&random, family, 1, &a, &b);
            bat_end_curvatures k, p, m;
            CHECK_OK(family->curvatures(a, b, 1.7, tension, &k));
            const double size = 1e-6 * (1 + tension * tension);
            CHECK_OK(family->curvatures(a + h, b, 1.7, tension, &p));
            CHECK_OK(family->curvatures(a - h, b, 1.7, tension, &m));
            CHECK_NEAR(k.k0_alpha, (p.k0 - m.k0) / (2 * h), size);
            CHECK_NEAR(k.k1_alpha, (p.k1 - m.k1) / (2 * h), size);
            CHECK_OK(family->curvatures(a, b + h, 1.7, tension, &p));
            CHECK_OK(family->curvatures(a, b - h, 1.7, tension, &m));
            CHECK_NEAR(k.k0_beta, (p.k0 - m.k0) / (2 * h), size);
            CHECK_NEAR(k.k1_beta, (p.k1 - m.k1) / (2 * h), size);
        }
}

static double curvature_of(const double jet[6])
{
    return (jet[2] * jet[5] - jet[3] * jet[4]) / pow(hypot(jet[2], jet[3]), 3);
}

TEST(spans_of_every_family_have_its_end_curvatures_and_directions)
{
    test_random random = test_random_begin("family spans");
    for (int f = 0; f < COUNT(families); f++)
        for (int i = 0; i < 40; i++) {
            const bat_span_family *family = families[f];
            const double tension = i % 4 ? test_random_in(&random, 0, 12) : 0, l = 2.3;
            double a, b;
            random_angles(&random, family, 1, &a, &b);
            bat_end_curvatures k;
            batten_span spans[BAT_FAMILY_SPANS];
            batten_chain *chain = NULL;
            int count = 0;
            double first[6], last[6];
            memset(spans, 0, sizeof spans);
            CHECK_OK(family->curvatures(a, b, l, tension, &k));
            CHECK_OK(family->spans(a, b, l, tension, spans, &count));
            CHECK_OK(batten_chain_create(&(batten_chain_parts){2, count, spans, NULL, false},
                                         1e-10, &chain));
            const batten_interval domain = batten_chain_domain(chain);
            CHECK_OK(batten_chain_evaluate(chain, domain.a, 2, first));
            CHECK_OK(batten_chain_evaluate(chain, domain.b, 2, last));
            CHECK_NEAR(hypot(first[0], first[1]), 0, 1e-11);
            CHECK_NEAR(hypot(last[0] - l, last[1]), 0, 1e-11);
            CHECK_NEAR(atan2(first[3], first[2]), a, 1e-10);
            CHECK_NEAR(atan2(last[3], last[2]), b, 1e-10);
            /* Curvatures of the local families are second derivatives over the chord, and
             * Hobby's are his mock curvatures. */
            const bool true_curvature =
                family == &bat_family_geometric || family == &bat_family_euler_spiral ||
                family == &bat_family_arcs || family == &bat_family_elastica;
            if (true_curvature) {
                CHECK_NEAR(curvature_of(first), k.k0, 1e-9);
                CHECK_NEAR(curvature_of(last), k.k1, 1e-9);
            }
            batten_chain_unref(chain);
        }
}

TEST(a_mirrored_or_reversed_span_has_the_curvatures_of_its_image)
{
    test_random random = test_random_begin("family images");
    for (int f = 0; f < COUNT(families); f++)
        for (int i = 0; i < 40; i++) {
            const bat_span_family *family = families[f];
            double a, b;
            random_angles(&random, family, 1.2, &a, &b);
            bat_end_curvatures k, mirrored, reversed, scaled;
            CHECK_OK(family->curvatures(a, b, 2, 3, &k));
            CHECK_OK(family->curvatures(-a, -b, 2, 3, &mirrored));
            CHECK_OK(family->curvatures(-b, -a, 2, 3, &reversed));
            CHECK_OK(family->curvatures(a, b, 20, 3, &scaled));
            const double size = 1e-9 * (1 + fabs(k.k0) + fabs(k.k1));
            CHECK_NEAR(mirrored.k0, -k.k0, size);
            CHECK_NEAR(mirrored.k1, -k.k1, size);
            CHECK_NEAR(reversed.k0, k.k1, size);
            CHECK_NEAR(reversed.k1, k.k0, size);
            CHECK_NEAR(scaled.k0 * 10, k.k0, size);
            CHECK_NEAR(scaled.k1 * 10, k.k1, size);
        }
}

TEST(the_least_tension_makes_one_end_straight_and_less_makes_an_inflection)
{
    test_random random = test_random_begin("least tension");
    for (int i = 0; i < 200; i++) {
        const double a = test_random_in(&random, 0.02, 1),
                     b = -a * test_random_in(&random, 0.02, 1);
        const double z = bat_local_tension_for(a, b), turned = bat_local_tension_for(-b, -a);
        CHECK_NEAR(turned, z, 1e-9 * (1 + z));
        CHECK_NEAR(bat_local_tension_for(-a, -b), z, 1e-12 * (1 + z));
        bat_end_curvatures at, below;
        CHECK_OK(bat_family_local_tension.curvatures(a, b, 1, z, &at));
        if (tan(a) <= 2 * tan(-b)) {
            CHECK(z == 0);
        } else {
            /* Both ends bend alike, the one at the smaller angle hardly. */
            CHECK(fabs(at.k1) <= 1e-6 * fabs(at.k0));
            CHECK_OK(bat_family_local_tension.curvatures(a, b, 1, 0.9 * z, &below));
            CHECK(below.k0 * below.k1 < 0);
        }
    }
    CHECK_NEAR(bat_local_tension_for(0.5, -1e-9), BAT_MOST_TENSION, 0);
}
