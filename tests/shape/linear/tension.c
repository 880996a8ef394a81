#include <batten/curvature.h>
#include <batten/interpolate.h>

#include "support/faults.h"
#include "support/test.h"

/* ---- helpers ---- */

static batten_chain *through(int d, int n, const double *points,
                             const batten_chain_tension_options *o)
{
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_tension((batten_points){d, n, points}, o, NULL, &chain));
    return chain;
}

/* A function of given abscissae in the tension sigma, in no unit but theirs. */
static batten_chain_tension_options function(const double *x, int n, double sigma)
{
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given = x;
    o.tension = sigma * (x[n - 1] - x[0]) / (n - 1);
    return o;
}

static double value(const batten_chain *chain, double x, int order)
{
    double out[4];
    CHECK_OK(batten_chain_evaluate(chain, x, order, out));
    return out[order];
}

static void random_data(test_random *random, int d, int n, double *x, double *points)
{
    for (int i = 0; i < n; i++)
        x[i] = (i ? x[i - 1] : 0) + test_random_in(random, 0.3, 2);
    for (int i = 0; i < n * d; i++)
        points[i] = test_random_in(random, -2, 2);
}

/* Do point, first and second derivative go on over every break? */
static void check_smooth(const batten_chain *chain, double tolerance)
{
    const int d = batten_chain_dimension(chain), n = batten_chain_span_count(chain);
    const double *breaks = batten_chain_breaks(chain);
    for (int i = batten_chain_is_closed(chain) ? 0 : 1; i < n; i++) {
        double left[9], right[9];
        CHECK_OK(batten_chain_evaluate_side(chain, breaks[i], BATTEN_FROM_LEFT, 2, left));
        CHECK_OK(batten_chain_evaluate_side(chain, breaks[i], BATTEN_FROM_RIGHT, 2, right));
        for (int k = 0; k < 3 * d; k++)
            CHECK_NEAR(left[k], right[k], tolerance * (1 + fabs(right[k])));
    }
}

/* ---- the spline ---- */

TEST(a_spline_in_tension_goes_smoothly_through_its_points)
{
    test_random random = test_random_begin("a_spline_in_tension_goes_smoothly");
    for (int c = 0; c < test_cases(40); c++) {
        const int d = 1 + c % 3, n = test_random_int(&random, 3, 12);
        double x[13], points[36], tensions[12], parameters[12];
        random_data(&random, d, n, x, points);
        x[n] = x[n - 1] + 1;
        for (int i = 0; i < 12; i++)
            tensions[i] = pow(10, test_random_in(&random, -3, 3));
        batten_chain_tension_options o = batten_chain_tension_defaults();
        o.parameters = BATTEN_GIVEN;
        o.given = x;
        o.tensions = tensions;
        o.closed = c % 2;
        const batten_end_kind kinds[] = {BATTEN_END_NATURAL, BATTEN_END_CLAMPED,
                                         BATTEN_END_SECOND,  BATTEN_END_PARABOLIC,
                                         BATTEN_END_BESSEL,  BATTEN_END_DIRECTION};
        o.start = (batten_end){kinds[c % 6], {1, -0.5, 2}};
        o.end = (batten_end){kinds[c / 6 % 6], {-1, 3, 0.25}};
        batten_chain *chain = NULL;
        CHECK_OK(batten_chain_tension((batten_points){d, n, points}, &o, parameters, &chain));
        CHECK(memcmp(parameters, x, (size_t)n * sizeof *x) == 0);
        for (int i = 0; i < n; i++) {
            double p[3];
            CHECK_OK(batten_chain_evaluate(chain, x[i], 0, p));
            CHECK(memcmp(p, points + i * d, (size_t)d * sizeof *p) == 0);
        }
        check_smooth(chain, 1e-10);
        batten_chain_unref(chain);
    }
}

TEST(the_ends_of_a_spline_in_tension_are_as_asked)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4};
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.tension = 2;
    o.start = (batten_end){BATTEN_END_CLAMPED, {0.5, -1}};
    o.end = (batten_end){BATTEN_END_SECOND, {2, 3}};
    batten_chain *chain = through(2, 4, points, &o);
    const double end = batten_chain_domain(chain).b;
    double p[6];
    CHECK_OK(batten_chain_evaluate(chain, 0, 2, p));
    CHECK_NEAR(p[2], 0.5, 1e-14);
    CHECK_NEAR(p[3], -1, 1e-14);
    CHECK_OK(batten_chain_evaluate(chain, end, 2, p));
    CHECK_NEAR(p[4], 2, 1e-14);
    CHECK_NEAR(p[5], 3, 1e-14);
    batten_chain_unref(chain);
    o.start = (batten_end){BATTEN_END_DIRECTION, {0, 7}};
    o.end = (batten_end){.kind = BATTEN_END_PARABOLIC};
    chain = through(2, 4, points, &o);
    CHECK_OK(batten_chain_evaluate(chain, 0, 1, p));
    CHECK_NEAR(p[2], 0, 1e-14);
    CHECK_NEAR(p[3], 1, 1e-14); /* chord parameters */
    const batten_span *last = batten_chain_span(chain, 2);
    CHECK_NEAR(last->bend[0][1], last->bend[1][1], 1e-14);
    batten_chain_unref(chain);
    o.start.kind = BATTEN_END_NOT_A_KNOT;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 4, points}, &o, NULL, &chain),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("start");
}

TEST(without_tension_it_is_the_cubic_spline)
{
    test_random random = test_random_begin("without_tension_it_is_the_cubic_spline");
    const batten_end_kind kinds[] = {BATTEN_END_NATURAL, BATTEN_END_CLAMPED,
                                     BATTEN_END_SECOND,  BATTEN_END_PARABOLIC,
                                     BATTEN_END_BESSEL,  BATTEN_END_CIRCLE};
    for (int c = 0; c < 14; c++) {
        double x[10], points[20];
        random_data(&random, 2, 9, x, points);
        batten_chain_tension_options o = batten_chain_tension_defaults();
        batten_curve_interpolate_options cubic = batten_curve_interpolate_defaults();
        cubic.parameters = o.parameters;
        o.closed = cubic.closed = c >= 12;
        o.tension = c % 2 ? 1e-3 : 0;
        o.start = cubic.start = (batten_end){kinds[c % 6], {0.5, 1}};
        o.end = cubic.end = (batten_end){kinds[c / 2 % 6], {0.25, 1}};
        batten_chain *chain = through(2, 9, points, &o);
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){2, 9, points}, &cubic, NULL, &curve));
        const batten_interval domain = batten_chain_domain(chain);
        for (int i = 0; i <= 100; i++) {
            double p[6], q[6];
            const double u = domain.a + (domain.b - domain.a) * i / 100;
            CHECK_OK(batten_chain_evaluate(chain, u, 2, p));
            CHECK_OK(batten_curve_evaluate(curve, u, 2, q));
            for (int k = 0; k < 6; k++) /* the difference is of order tension^2 */
                CHECK_NEAR(p[k], q[k], (c % 2 ? 1e-6 : 1e-11) * (1 + fabs(q[k])));
        }
        batten_curve_unref(curve);
        batten_chain_unref(chain);
    }
}

TEST(with_much_tension_it_is_the_polygon)
{
    const double x[] = {0, 1, 2, 3, 4, 5}, y[] = {0, 2, -1, 0, 3, 0};
    const double tensions[] = {1e3, 1e6, 1e300};
    for (int i = 0; i < COUNT(tensions); i++) {
        const batten_chain_tension_options o = function(x, 6, tensions[i]);
        batten_chain *chain = through(1, 6, y, &o);
        for (int k = 0; k < 500; k++) {
            const int at = k / 100;
            const double s = k % 100 / 100.0;
            CHECK_NEAR(value(chain, at + s, 0), (1 - s) * y[at] + s * y[at + 1], 1e-2 * 4);
        }
        batten_chain_unref(chain);
    }
}

TEST(a_spline_in_tension_has_the_least_energy)
{
    /* Integral of s''^2 + sigma^2 s'^2, against the same with bumps that vanish at the data. */
    const double x[] = {0, 1, 2.5, 3, 4.2}, y[] = {0, 2, -1, 0, 3};
    batten_chain_tension_options o = function(x, 5, 1.7);
    batten_chain *chain = through(1, 5, y, &o);
    double own = 0, work = 0, bump = 0;
    const int steps = 40000;
    for (int i = 0; i < steps; i++) {
        const double u = 4.2 * (i + 0.5) / steps;
        double p[3], first = 0, second = 0;
        CHECK_OK(batten_chain_evaluate(chain, u, 2, p));
        for (int k = 0; k < 5; k++) {
            double without = 1;
            for (int j = 0; j < 5; j++)
                without *= j == k ? 1 : u - x[j];
            first += without;
            for (int j = 0; j < 5; j++) {
                double two = 1;
                for (int l = 0; l < 5; l++)
                    two *= l == k || l == j ? 1 : u - x[l];
                second += j == k ? 0 : two;
            }
        }
        own += p[2] * p[2] + 1.7 * 1.7 * p[1] * p[1];
        work += p[2] * second + 1.7 * 1.7 * p[1] * first;
        bump += second * second + 1.7 * 1.7 * first * first;
    }
    /* The first variation vanishes, and the second is positive. */
    CHECK_NEAR(work / sqrt(own * bump), 0, 1e-8);
    batten_chain_unref(chain);
}

TEST(g10_reversed_points_give_the_reversed_spline_in_tension)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4, 4, 6},
                 reversed[] = {4, 6, 4, 4, 3, 1, 1, 2, 0, 0};
    for (int rule = 0; rule < 3; rule++) {
        batten_chain_tension_options o = batten_chain_tension_defaults();
        o.tension = 1.5;
        o.rule = (batten_tension_rule)rule;
        batten_chain *a = through(2, 5, points, &o), *b = through(2, 5, reversed, &o);
        const double end = batten_chain_domain(a).b;
        for (int i = 0; i <= 50; i++) {
            double p[2], q[2];
            CHECK_OK(batten_chain_evaluate(a, end * i / 50, 0, p));
            CHECK_OK(batten_chain_evaluate(b, end * (50 - i) / 50, 0, q));
            CHECK_NEAR(p[0], q[0], 1e-13);
            CHECK_NEAR(p[1], q[1], 1e-13);
        }
        batten_chain_unref(a);
        batten_chain_unref(b);
    }
}

TEST(g2_few_points_give_the_least_spline_in_tension)
{
    const double points[] = {1, 2, 4, 6, 5, 5};
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.tension = 3;
    const batten_end_kind straight[] = {BATTEN_END_NATURAL, BATTEN_END_PARABOLIC,
                                        BATTEN_END_BESSEL, BATTEN_END_CIRCLE};
    for (int i = 0; i < 16; i++) {
        o.start.kind = straight[i % 4];
        o.end.kind = straight[i / 4];
        batten_chain *line = through(2, 2, points, &o);
        double p[4];
        CHECK_OK(batten_chain_evaluate(line, 2, 1, p));
        CHECK_NEAR(p[0], 1 + 3 * 0.4, 1e-14);
        CHECK_NEAR(p[1], 2 + 4 * 0.4, 1e-14);
        CHECK_NEAR(p[2], 0.6, 1e-14);
        batten_chain_unref(line);
    }
    batten_chain *none = NULL;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 1, points}, &o, NULL, &none),
                 BATTEN_TOO_FEW_POINTS);
    o.closed = true;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 2, points}, &o, NULL, &none),
                 BATTEN_TOO_FEW_POINTS);
    batten_chain *three = through(2, 3, points, &o);
    check_smooth(three, 1e-13);
    batten_chain_unref(three);
}

TEST(g1_coincident_points_are_named_by_splines_in_tension)
{
    const double points[] = {0, 0, 1, 2, 1, 2, 4, 4};
    batten_chain *none = NULL;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 4, points}, NULL, NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3 coincide");
    CHECK_MESSAGE("2");
    CHECK(none == NULL);
}

TEST(n1_splines_in_tension_refuse_what_is_not_finite)
{
    const double points[] = {0, 0, 1, NAN, 4, 4}, good[] = {0, 0, 1, 2, 4, 4}, x[] = {0, 2, 2},
                 tensions[] = {1, -1};
    batten_chain *none = NULL;
    batten_chain_tension_options o = batten_chain_tension_defaults();
    CHECK_STATUS(batten_chain_tension((batten_points){2, 3, points}, &o, NULL, &none),
                 BATTEN_NOT_FINITE);
    o.tension = NAN;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 3, good}, &o, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    o.tensions = tensions;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 3, good}, &o, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("span 2");
    o = batten_chain_tension_defaults();
    o.slack = 0;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 3, good}, &o, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    o = batten_chain_tension_defaults();
    o.start = (batten_end){BATTEN_END_CLAMPED, {1, INFINITY}};
    CHECK_STATUS(batten_chain_tension((batten_points){2, 3, good}, &o, NULL, &none),
                 BATTEN_NOT_FINITE);
    o = batten_chain_tension_defaults();
    o.parameters = BATTEN_GIVEN;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 3, good}, &o, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    o.given = x;
    CHECK_STATUS(batten_chain_tension((batten_points){2, 3, good}, &o, NULL, &none),
                 BATTEN_NOT_INCREASING);
    o = batten_chain_tension_defaults();
    o.tension = 1e308;
    const double far[] = {0, 0, 1, 0, 3000, 0};
    CHECK_STATUS(batten_chain_tension((batten_points){2, 3, far}, &o, NULL, &none),
                 BATTEN_OVERFLOW);
    CHECK(none == NULL);
}

TEST(n2_splines_in_tension_have_the_same_shape_in_any_unit)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4, 4, 6, 4, 9};
    const double sizes[] = {1e-9, 1e9, 1e-150, 1e150};
    for (int rule = 0; rule < 3; rule++)
        for (int s = 0; s < COUNT(sizes); s++) {
            double scaled[12];
            for (int i = 0; i < 12; i++)
                scaled[i] = points[i] * sizes[s];
            batten_chain_tension_options o = batten_chain_tension_defaults();
            o.tension = 1.5;
            o.rule = (batten_tension_rule)rule;
            batten_chain *a = through(2, 6, points, &o), *b = through(2, 6, scaled, &o);
            const double end = batten_chain_domain(a).b, far = batten_chain_domain(b).b;
            for (int i = 0; i <= 50; i++) {
                double p[2], q[2];
                CHECK_OK(batten_chain_evaluate(a, end * i / 50, 0, p));
                CHECK_OK(batten_chain_evaluate(b, far * i / 50, 0, q));
                CHECK_NEAR(p[0], q[0] / sizes[s], 1e-13);
                CHECK_NEAR(p[1], q[1] / sizes[s], 1e-13);
            }
            batten_chain_unref(a);
            batten_chain_unref(b);
        }
}

/* ---- the rules ---- */

TEST(the_example_of_convex_data_needs_five_rounds)
{
    const double x[] = {0, 1, 2, 3, 4, 5, 6}, y[] = {0, 0, 0, 0.2, 3, 10, 30};
    batten_chain_tension_options o = function(x, 7, 0);
    o.rule = BATTEN_TENSION_CONVEX;
    o.slack = 10; /* points in line count for nothing */
    batten_chain *chain = through(1, 7, y, &o);
    const double sigma[] = {0, 5.0625, 5.0625, 0, 0, 0};
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(batten_chain_span(chain, i)->tension, sigma[i], 0);
    batten_chain_unref(chain);
    o.slack = 0.01;
    chain = through(1, 7, y, &o);
    CHECK(fabs(value(chain, 1, 1)) <= 0.01 * 0.2);
    for (int i = 0; i <= 400; i++) /* convex beyond the points in line */
        CHECK(value(chain, 2 + i / 100.0, 2) >= -1e-12);
    batten_chain_unref(chain);
}

TEST(convex_data_give_convex_functions)
{
    test_random random = test_random_begin("convex_data_give_convex_functions");
    for (int c = 0; c < test_cases(60); c++) {
        const int n = test_random_int(&random, 3, 12);
        double x[12], y[12], slope = -3;
        for (int i = 0; i < n; i++) {
            x[i] = i ? x[i - 1] + pow(10, test_random_in(&random, -1, 1)) : 0;
            y[i] = i ? y[i - 1] + slope * (x[i] - x[i - 1]) : 1;
            slope += pow(10, test_random_in(&random, -2, 1));
        }
        batten_chain_tension_options o = function(x, n, 0);
        o.rule = BATTEN_TENSION_CONVEX;
        batten_chain *chain = through(1, n, y, &o);
        for (int i = 0; i < 1000; i++)
            CHECK(value(chain, x[n - 1] * i / 1000, 2) >= -1e-9);
        batten_chain_unref(chain);
    }
}

TEST(a_function_bends_back_only_where_its_data_do)
{
    test_random random = test_random_begin("a_function_bends_back_only_where_its_data_do");
    for (int c = 0; c < test_cases(60); c++) {
        const int n = test_random_int(&random, 3, 14);
        double x[14], y[14];
        random_data(&random, 1, n, x, y);
        batten_chain_tension_options o = function(x, n, 0);
        o.rule = BATTEN_TENSION_CONVEX;
        batten_chain *chain = through(1, n, y, &o);
        for (int i = 1; i + 1 < n; i++) {
            const double turn =
                (y[i + 1] - y[i]) / (x[i + 1] - x[i]) - (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
            CHECK(value(chain, x[i], 2) * turn >= 0);
        }
        batten_chain_unref(chain);
    }
}

/* How often the curvature of a plane chain changes its sign. */
static int inflections(const batten_chain *chain)
{
    const batten_interval domain = batten_chain_domain(chain);
    int count = 0, last = 0;
    for (int i = 0; i <= 6000; i++) {
        double p[6];
        CHECK_OK(
            batten_chain_evaluate(chain, domain.a + (domain.b - domain.a) * i / 6000, 2, p));
        const double bend = p[2] * p[5] - p[3] * p[4];
        const int sign = bend > 1e-9 ? 1 : bend < -1e-9 ? -1 : last;
        count += last && sign != last;
        last = sign;
    }
    return count;
}

TEST(a_plane_curve_has_no_more_inflections_than_its_polygon)
{
    test_random random = test_random_begin("no_more_inflections_than_its_polygon");
    int excess = 0;
    for (int c = 0; c < test_cases(60); c++) {
        const int n = test_random_int(&random, 4, 12);
        double x[12], points[24];
        random_data(&random, 2, n, x, points);
        int wanted = 0, last = 0;
        for (int i = 1; i + 1 < n; i++) {
            const double *p = points + 2 * i;
            const double turn = (p[0] - p[-2]) * (p[3] - p[1]) - (p[1] - p[-1]) * (p[2] - p[0]);
            const int sign = turn > 0 ? 1 : -1;
            wanted += last && sign != last;
            last = sign;
        }
        batten_chain_tension_options o = batten_chain_tension_defaults();
        batten_chain *plain = through(2, n, points, &o);
        o.rule = BATTEN_TENSION_CONVEX;
        batten_chain *chain = through(2, n, points, &o);
        CHECK_INT(inflections(chain), wanted);
        excess += inflections(plain) > wanted;
        batten_chain_unref(plain);
        batten_chain_unref(chain);
    }
    CHECK(excess > 0); /* so the rule had work to do */
}

TEST(a_closed_convex_polygon_gives_an_oval)
{
    const double points[] = {0, 0, 10, 0, 10.1, 0.1, 10, 8, 5, 8.05, 0, 8};
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.closed = true;
    batten_chain *plain = through(2, 6, points, &o);
    CHECK(inflections(plain) > 0);
    o.rule = BATTEN_TENSION_CONVEX;
    batten_chain *oval = through(2, 6, points, &o);
    CHECK_INT(inflections(oval), 0);
    check_smooth(oval, 1e-12);
    batten_chain_unref(plain);
    batten_chain_unref(oval);
}

TEST(turns_of_a_curve_in_space_are_kept_in_any_position)
{
    test_random random = test_random_begin("turns_of_a_curve_in_space");
    for (int c = 0; c < test_cases(10); c++) {
        double points[27], turned[27];
        for (int i = 0; i < 27; i++)
            points[i] = test_random_in(&random, -1, 1) + (i % 3 == 0 ? i / 9.0 : 0);
        const batten_affine map = batten_affine_rotation(
            (batten_vec3){1, 2, 3}, (batten_vec3){1, test_random_in(&random, -1, 1), 0.3}, 2);
        for (int i = 0; i < 9; i++) {
            const batten_vec3 p = batten_affine_apply(
                map, (batten_vec3){points[3 * i], points[3 * i + 1], points[3 * i + 2]});
            memcpy(turned + 3 * i, &p, sizeof p);
        }
        batten_chain_tension_options o = batten_chain_tension_defaults();
        o.rule = BATTEN_TENSION_CONVEX;
        batten_chain *a = through(3, 9, points, &o), *b = through(3, 9, turned, &o);
        for (int i = 0; i < 8; i++)
            CHECK_NEAR(batten_chain_span(a, i)->tension, batten_chain_span(b, i)->tension,
                       1e-12 * (1 + batten_chain_span(a, i)->tension));
        batten_chain_unref(a);
        batten_chain_unref(b);
    }
}

TEST(monotone_data_give_monotone_functions)
{
    test_random random = test_random_begin("monotone_data_give_monotone_functions");
    for (int c = 0; c < test_cases(60); c++) {
        const int n = test_random_int(&random, 3, 12);
        double x[12], y[12];
        for (int i = 0; i < n; i++) {
            x[i] = i ? x[i - 1] + pow(10, test_random_in(&random, -1, 1)) : 0;
            y[i] = i ? y[i - 1] + pow(10, test_random_in(&random, -3, 1)) : 1;
        }
        batten_chain_tension_options o = function(x, n, 0);
        o.rule = BATTEN_TENSION_MONOTONE;
        batten_chain *chain = through(1, n, y, &o);
        for (int i = 0; i <= 2000; i++)
            CHECK(value(chain, x[n - 1] * i / 2000, 1) >= -1e-10);
        batten_chain_unref(chain);
    }
}

TEST(a_function_turns_only_beside_points_where_its_data_turn)
{
    test_random random = test_random_begin("a_function_turns_only_beside_points");
    for (int c = 0; c < test_cases(40); c++) {
        const int n = 12;
        double x[12], y[12];
        random_data(&random, 1, n, x, y);
        batten_chain_tension_options o = function(x, n, 0);
        o.rule = BATTEN_TENSION_MONOTONE;
        batten_chain *chain = through(1, n, y, &o);
        int wanted = 0, found = 0, last = 0;
        for (int i = 1; i + 1 < n; i++)
            wanted += (y[i + 1] - y[i]) * (y[i] - y[i - 1]) < 0;
        for (int i = 0; i < 6000; i++) {
            const double slope = value(chain, x[0] + (x[n - 1] - x[0]) * i / 6000, 1);
            const int sign = slope > 1e-9 ? 1 : slope < -1e-9 ? -1 : last;
            found += last && sign != last;
            last = sign;
        }
        CHECK_INT(found, wanted);
        batten_chain_unref(chain);
    }
}

TEST(over_level_data_a_monotone_function_stays_nearly_level)
{
    const double x[] = {0, 1, 2, 3, 4, 5}, y[] = {0, 0, 0, 1, 1, 1};
    batten_chain_tension_options o = function(x, 6, 0);
    o.rule = BATTEN_TENSION_MONOTONE;
    batten_chain *chain = through(1, 6, y, &o);
    for (int i = 0; i <= 500; i++) {
        CHECK(value(chain, i / 100.0, 0) >= -0.01);
        CHECK(value(chain, i / 100.0, 0) <= 1.01);
    }
    CHECK(fabs(value(chain, 2, 1)) <= 0.01);
    batten_chain_unref(chain);
}

/* A long span between a steep and a level one: its end may fall a little, and the dip inside
 * must not be hidden by that. */
TEST(a_monotone_function_swings_nowhere_between_steep_and_level_data)
{
    const double x[] = {0, 172.2, 172.201, 1062, 1101}, y[] = {0, 0, 58, 59.5, 59.5};
    batten_chain_tension_options o = function(x, 5, 0);
    o.rule = BATTEN_TENSION_MONOTONE;
    batten_chain *chain = through(1, 5, y, &o);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i <= 400; i++) {
            const double at = value(chain, x[k] + (x[k + 1] - x[k]) * i / 400, 0);
            CHECK(at >= -0.01 && at <= 59.51);
        }
    batten_chain_unref(chain);
}

TEST(a_spline_in_tension_meets_a_hundred_thousand_points)
{
    enum { N = 100000 };
    if (test_cases(10) < 10)
        SKIP("a run with failing allocations");
    double *points = test_array(2 * N, sizeof *points);
    for (int i = 0; i < N; i++) {
        points[2 * i] = i;
        points[2 * i + 1] = sin(i * 0.7) + (i % 5 == 0);
    }
    for (int rule = 0; rule < 3; rule++) {
        batten_chain_tension_options o = batten_chain_tension_defaults();
        o.tension = 1;
        o.rule = (batten_tension_rule)rule;
        o.parameters = BATTEN_UNIFORM;
        batten_chain *chain = through(2, N, points, &o);
        for (int i = 0; i < N; i += 37) {
            double at[2];
            CHECK_OK(batten_chain_evaluate(chain, i, 0, at));
            CHECK_NEAR(at[0], points[2 * i], 1e-9);
            CHECK_NEAR(at[1], points[2 * i + 1], 1e-9);
        }
        batten_chain_unref(chain);
    }
}

TEST(splines_in_tension_report_every_lack_of_memory)
{
    static const double points[] = {0, 0, 1, 0.1, 2, 0.2, 3, 3, 4, 3.1, 5, 3.2};
    static const batten_tension_rule rules[] = {BATTEN_TENSION_GIVEN, BATTEN_TENSION_CONVEX,
                                                BATTEN_TENSION_MONOTONE};
    for (int k = 0; k < COUNT(rules); k++) {
        batten_chain_tension_options options = batten_chain_tension_defaults();
        double parameters[6];
        batten_chain *chain = NULL;
        options.rule = rules[k];
        CHECK_EACH_ALLOCATION(
            batten_chain_tension((batten_points){2, 6, points}, &options, parameters, &chain));
        batten_chain_unref(chain);
    }
}
