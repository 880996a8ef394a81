#include "shape/curve_change/extend.h"
#include "support/faults.h"
#include "support/test.h"
#include <batten/extend.h>
#include <batten/measure.h>
#include <batten/standard.h>

#define PI 3.14159265358979323846

static void random_curve(test_random *random, int dimension, bool rational, batten_curve **out)
{
    double points[21], weights[7];
    const double knots[11] = {2, 2, 2, 2, 2.5, 3, 3.75, 4, 4, 4, 4};
    for (int i = 0; i < 7; i++) {
        for (int k = 0; k < dimension; k++)
            points[i * dimension + k] = (k == 0 ? i : 0) + test_random_in(random, -0.4, 0.4);
        weights[i] = test_random_in(random, 0.8, 1.25);
    }
    CHECK_OK(batten_curve_create((batten_points){dimension, 7, points}, 3,
                                 rational ? weights : NULL, knots, out));
}

/* How far the curves are apart on the domain of the first. */
static double apart(const batten_curve *a, const batten_curve *b)
{
    const batten_interval domain = batten_curve_domain(a);
    double worst = 0;
    for (int i = 0; i <= 200; i++) {
        const double u = domain.a + (domain.b - domain.a) * (i / 200.0);
        double p[3] = {0}, q[3] = {0};
        CHECK_OK(batten_curve_evaluate(a, u, 0, p));
        CHECK_OK(batten_curve_evaluate(b, u, 0, q));
        for (int k = 0; k < batten_curve_dimension(a); k++)
            worst = fmax(worst, fabs(p[k] - q[k]));
    }
    return worst;
}

TEST(an_extended_curve_contains_the_old_one_and_joins_as_promised)
{
    static const int smooth[] = {1, 2, 3, 3};
    test_random random = test_random_begin("extend");
    for (int n = test_cases(48); n > 0; n--) {
        const int dimension = n % 3 ? 2 : 3;
        const batten_extension way = (batten_extension)(n % 4);
        const batten_curve_end end = n % 8 < 4 ? BATTEN_CURVE_END : BATTEN_CURVE_START;
        batten_curve *given = NULL, *made = NULL, *tail = NULL;
        batten_curve_extend_report report;
        double length, error;
        random_curve(&random, dimension, n % 5 == 0, &given);
        CHECK_EACH_ALLOCATION(batten_curve_extend(given, end, (batten_lengthening){way, 1e-8},
                                                  0.4, &report, &made));
        CHECK(apart(given, made) <= 1e-13);
        const batten_interval was = batten_curve_domain(given), is = batten_curve_domain(made);
        if (end == BATTEN_CURVE_END) {
            CHECK(is.a == was.a && is.b > was.b);
            CHECK_OK(batten_curve_subrange(made, was.b, is.b, &tail));
        } else {
            CHECK(is.b == was.b && is.a < was.a);
            CHECK_OK(batten_curve_subrange(made, is.a, was.a, &tail));
        }
        CHECK_OK(batten_curve_length(tail, 1e-12, &error, &length));
        CHECK_NEAR(length, 0.4, way == BATTEN_EXTEND_SPIRAL ? 1e-6 : 2e-8);
        CHECK_NEAR(report.length, 0.4, 2e-8);
        CHECK(report.error <= 1e-8);
        CHECK(report.join.geometric >=
              (dimension == 3 && way == BATTEN_EXTEND_SPIRAL ? 2 : smooth[way]));
        CHECK(report.join.parametric >= 1);
        batten_curve_unref(tail);
        batten_curve_unref(made);
        batten_curve_unref(given);
    }
}

TEST(an_arc_goes_on_along_its_circle)
{
    batten_curve *arc = NULL, *made = NULL;
    CHECK_OK(batten_curve_arc(3, 1, &arc));
    static const double lengths[] = {0.3, 4, 3 * 5.28};
    for (int i = 0; i < COUNT(lengths); i++) {
        batten_curve_extend_report report;
        CHECK_EACH_ALLOCATION(batten_curve_extend(arc, BATTEN_CURVE_END,
                                                  (batten_lengthening){BATTEN_EXTEND_ARC, 1e-9},
                                                  lengths[i], &report, &made));
        const batten_interval domain = batten_curve_domain(made);
        for (int k = 0; k <= 100; k++) {
            double p[2];
            CHECK_OK(
                batten_curve_evaluate(made, domain.a + (domain.b - domain.a) * k / 100, 0, p));
            CHECK_NEAR(hypot(p[0], p[1]), 3, 2e-14);
        }
        double end[2];
        CHECK_OK(batten_curve_evaluate(made, domain.b, 0, end));
        CHECK_NEAR(end[0], 3 * cos(1 + lengths[i] / 3), 1e-13);
        CHECK_NEAR(end[1], 3 * sin(1 + lengths[i] / 3), 1e-13);
        CHECK(report.error == 0);
        batten_curve_unref(made);
    }
    CHECK_STATUS(batten_curve_extend(arc, BATTEN_CURVE_END,
                                     (batten_lengthening){BATTEN_EXTEND_ARC, 1e-9}, 6.3 * 3,
                                     NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    batten_curve_unref(arc);
}

TEST(a_clothoid_goes_on_as_a_clothoid)
{
    /* Curvature 0 + 0.5 s: the extension of the first two units is the same spiral to s = 3. */
    batten_span span = {.kind = BATTEN_SPAN_SPIRAL, .length = 2, .curvature = {0, 0.5}};
    batten_chain *half = NULL, *whole = NULL;
    batten_curve *curve = NULL, *made = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &half));
    span.length = 3;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &whole));
    CHECK_OK(batten_chain_to_curve(half, 1e-12, NULL, &curve));
    CHECK_OK(batten_curve_extend(curve, BATTEN_CURVE_END,
                                 (batten_lengthening){BATTEN_EXTEND_SPIRAL, 1e-12}, 1, NULL,
                                 &made));
    for (int i = 0; i <= 100; i++) {
        double p[2], q[2];
        CHECK_OK(batten_curve_evaluate(made, 0.03 * i, 0, p));
        CHECK_OK(batten_chain_evaluate(whole, 0.03 * i, 0, q));
        CHECK(hypot(p[0] - q[0], p[1] - q[1]) < 1e-6); /* the quintic has the rate to 1e-5 */
    }
    batten_curve_unref(made);
    batten_curve_unref(curve);
    batten_chain_unref(whole);
    batten_chain_unref(half);
}

TEST(a_natural_extension_is_the_same_polynomial)
{
    const double power[] = {1, 0, 2, -1, 0, 0.5, -0.25, 1}, breaks[] = {0, 1};
    batten_curve *curve = NULL, *made = NULL;
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 1, breaks}, power, 0, &curve));
    for (int side = 0; side < 2; side++) {
        CHECK_EACH_ALLOCATION(batten_curve_extend_to(
            curve, side ? BATTEN_CURVE_END : BATTEN_CURVE_START,
            (batten_lengthening){BATTEN_EXTEND_NATURAL, 1e-9}, side ? 3 : -2, NULL, &made));
        const batten_interval domain = batten_curve_domain(made);
        CHECK(domain.a == (side ? 0 : -2) && domain.b == (side ? 3 : 1));
        for (int i = 0; i <= 50; i++) {
            const double u = domain.a + (domain.b - domain.a) * (i / 50.0);
            double p[2];
            CHECK_OK(batten_curve_evaluate(made, u, 0, p));
            CHECK_NEAR(p[0], 1 + u * (2 - 0.25 * u * u), 1e-13);
            CHECK_NEAR(p[1], u * (-1 + u * (0.5 + u)), 1e-13);
        }
        CHECK_INT(batten_curve_point_count(made), 4);
        batten_curve_unref(made);
    }
    batten_curve_unref(curve);
}

TEST(a_rational_arc_goes_on_naturally_until_its_weight_vanishes)
{
    /* A quarter as one piece: t runs to infinity towards three quarters of the circle. */
    batten_curve *arc = NULL, *made = NULL;
    CHECK_OK(batten_curve_arc(1, PI / 2, &arc));
    CHECK_OK(batten_curve_extend(arc, BATTEN_CURVE_END,
                                 (batten_lengthening){BATTEN_EXTEND_NATURAL, 1e-12}, 1, NULL,
                                 &made));
    double end[2];
    CHECK_OK(batten_curve_evaluate(made, batten_curve_domain(made).b, 0, end));
    CHECK_NEAR(end[0], cos(PI / 2 + 1), 1e-11);
    CHECK_NEAR(end[1], sin(PI / 2 + 1), 1e-11);
    batten_curve_unref(made);
    CHECK_STATUS(batten_curve_extend(arc, BATTEN_CURVE_END,
                                     (batten_lengthening){BATTEN_EXTEND_NATURAL, 1e-12}, 4,
                                     NULL, &made),
                 BATTEN_BAD_WEIGHT);
    batten_curve_unref(arc);
}

TEST(G2_a_straight_curve_goes_on_straight_whichever_way)
{
    const double points[] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}, breaks[] = {0, 1};
    batten_curve *curve = NULL, *made = NULL;
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){3, 1, breaks}, points, NULL, &curve));
    for (int way = 0; way < 4; way++) {
        double end[3];
        CHECK_OK(batten_curve_extend(curve, BATTEN_CURVE_END,
                                     (batten_lengthening){(batten_extension)way, 1e-12},
                                     sqrt(3), NULL, &made));
        CHECK_OK(batten_curve_evaluate(made, batten_curve_domain(made).b, 0, end));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(end[k], 4, 1e-11);
        batten_curve_unref(made);
    }
    batten_curve_unref(curve);
}

TEST(N1_N6_G4_what_cannot_be_extended_is_refused)
{
    const double points[] = {0, 0, 1, 1, 2, 0, 2, 0}, breaks[] = {0, 1}, more[] = {0, 1, 2, 3};
    batten_curve *curve = NULL, *ring = NULL, *function = NULL, *out = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, points, NULL, &curve));
    CHECK_OK(batten_curve_create_periodic((batten_points){2, 3, points}, 2, NULL, more, &ring));
    CHECK_OK(
        batten_curve_from_bezier(1, (batten_pieces){3, 1, breaks}, points, NULL, &function));
    const batten_curve_end end = BATTEN_CURVE_END;
    CHECK_STATUS(batten_curve_extend(curve, end, (batten_lengthening){BATTEN_EXTEND_LINE, 1e-9},
                                     1, NULL, &out),
                 BATTEN_SINGULAR_HERE);
    CHECK_OK(batten_curve_extend(curve, end, (batten_lengthening){BATTEN_EXTEND_NATURAL, 1e-9},
                                 1, NULL, &out));
    batten_curve_unref(out);
    const batten_curve_end start = BATTEN_CURVE_START;
    CHECK_STATUS(batten_curve_extend(curve, start,
                                     (batten_lengthening){BATTEN_EXTEND_LINE, 1e-9}, NAN, NULL,
                                     &out),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_extend(curve, start,
                                     (batten_lengthening){BATTEN_EXTEND_LINE, 1e-9}, 0, NULL,
                                     &out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_extend(curve, start, (batten_lengthening){BATTEN_EXTEND_LINE, 0},
                                     1, NULL, &out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_extend_to(curve, start,
                                        (batten_lengthening){BATTEN_EXTEND_LINE, 1}, 0.5, NULL,
                                        &out),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_extend(ring, end, (batten_lengthening){BATTEN_EXTEND_LINE, 1e-9},
                                     1, NULL, &out),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curve_extend(function, end,
                                     (batten_lengthening){BATTEN_EXTEND_LINE, 1e-9}, 1, NULL,
                                     &out),
                 BATTEN_UNSUPPORTED);
    batten_curve_unref(function);
    batten_curve_unref(ring);
    batten_curve_unref(curve);
}

/* What continues a tip at (0, 0, 0) along x that bends towards y: a line, an arc or a spiral by its
 * degree. What departs from something simpler by less than rounding is that. */
static const struct {
    batten_extension kind;
    double curvature, rate, length;
    int degree;
} pieces[] = {
    {BATTEN_EXTEND_LINE, 1, 1, 1, 1},
    {BATTEN_EXTEND_ARC, 1, 1, 1, 2},
    {BATTEN_EXTEND_ARC, 0, 1, 1, 1},
    {BATTEN_EXTEND_SPIRAL, 1, 1, 1, 5},
    {BATTEN_EXTEND_SPIRAL, 1, 0, 1, 2},
    {BATTEN_EXTEND_SPIRAL, 0, 0, 1, 1},
    {BATTEN_EXTEND_SPIRAL, 0, -1, 1, 5},
    {BATTEN_EXTEND_SPIRAL, 0, 1, 1e-9, 1},
    {BATTEN_EXTEND_SPIRAL, 0, 2e-16, 1, 1},
    {BATTEN_EXTEND_SPIRAL, 0, 2.5e-16, 1, 5},
    {BATTEN_EXTEND_SPIRAL, 0, -2.5e-16, 1, 5},
    {BATTEN_EXTEND_SPIRAL, 0, 1e-17, 4, 1},
    {BATTEN_EXTEND_SPIRAL, 0, 2e-17, 4, 5},
    {BATTEN_EXTEND_ARC, 1e-16, 0, 2, 1},
    {BATTEN_EXTEND_ARC, 1.2e-16, 0, 2, 2},
    {BATTEN_EXTEND_SPIRAL, 2e-16, 1e-17, 1, 1},
    {BATTEN_EXTEND_SPIRAL, 2e-16, 3e-17, 1, 5},
};

TEST(a_piece_is_as_simple_as_rounding_allows)
{
    for (int i = 0; i < COUNT(pieces); i++) {
        const bat_tip tip = {.dimension = 2,
                             .u = 3,
                             .t = {1, 0, 0},
                             .n = {0, 1, 0},
                             .speed = 2,
                             .curvature = pieces[i].curvature,
                             .rate = pieces[i].rate};
        batten_curve *piece = NULL;
        double error = -1, end[2];
        CHECK_OK(bat_tip_piece(&tip, (batten_lengthening){pieces[i].kind, 1e-6},
                               pieces[i].length, &error, &piece));
        CHECK_INT(batten_curve_degree(piece), pieces[i].degree);
        CHECK(pieces[i].degree == 5 ? error >= 0 && error <= 1e-6 : error == 0);
        CHECK(batten_curve_domain(piece).a == 3);
        if (pieces[i].degree == 1) {
            CHECK_NEAR(batten_curve_domain(piece).b, 3 + pieces[i].length / 2, 1e-15);
            CHECK_OK(batten_curve_evaluate(piece, batten_curve_domain(piece).b, 0, end));
            CHECK(end[0] == pieces[i].length && end[1] == 0);
        }
        batten_curve_unref(piece);
    }
}

/* A circle of radius 1 / 2 from (1, 2): sines of the angle and twice the squares of its half. */
TEST(an_arc_piece_has_the_speed_of_its_tip_and_as_many_quarters_as_it_takes)
{
    static const struct {
        double turns; /* of a quarter */
        int points;
    } rows[] = {{0.5, 3}, {1, 3}, {1.01, 5}, {2, 5}, {3.5, 9}, {4, 9}};
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_tip tip = {2, 3, {1, 2, 0}, {1, 0, 0}, {0, 1, 0}, 5, 2, 0};
        const double angle = rows[i].turns * (PI / 2);
        batten_curve *piece = NULL;
        double error = -1, at[4], end[2];
        CHECK_OK(bat_tip_piece(&tip, (batten_lengthening){BATTEN_EXTEND_ARC, 1e-6}, angle / 2,
                               &error, &piece));
        CHECK_INT(batten_curve_point_count(piece), rows[i].points);
        CHECK_OK(batten_curve_evaluate(piece, 3, 1, at));
        CHECK_OK(batten_curve_evaluate(piece, batten_curve_domain(piece).b, 0, end));
        CHECK(at[0] == 1 && at[1] == 2);
        CHECK_NEAR(at[2], 5, 1e-14);
        CHECK_NEAR(at[3], 0, 1e-14);
        CHECK_NEAR(end[0], 1 + sin(angle) / 2, 1e-15);
        CHECK_NEAR(end[1], 2 + (1 - cos(angle)) / 2, 1e-15);
        batten_curve_unref(piece);
    }
    const bat_tip tip = {2, 3, {1, 2, 0}, {1, 0, 0}, {0, 1, 0}, 5, 2, 0};
    batten_curve *none = NULL;
    double error;
    CHECK_STATUS(
        bat_tip_piece(&tip, (batten_lengthening){BATTEN_EXTEND_ARC, 1e-6}, 3.25, &error, &none),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE(
        "an arc of the length 3.25 goes around the circle of radius 0.5 more than once");
    CHECK(!none);
}
