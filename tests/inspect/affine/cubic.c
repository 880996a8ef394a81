#include "inspect/affine/cubic.h"

#include "inspect/shapes.h"

static batten_cubic_class segment_class(const double *points)
{
    batten_cubic cubic;
    CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
    return cubic.segment;
}

static void random_points(test_random *random, double *points)
{
    for (int k = 0; k < 8; k++)
        points[k] = test_random_in(random, -1, 1);
}

/* ---- the example of the lecture notes ---- */

/* x = 4 t^3 + 10 t^2 - 30 t + 2, y = -30 t^2 - 10 t + 10 */
static void lecture_cubic(double a, double b, double *points)
{
    const double powers[4][2] = {{2, 10}, {-30, -10}, {10, -30}, {4, 0}};
    batten_curve *curve = NULL;
    const double breaks[2] = {a, b};
    double shifted[4][2] = {{0}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j <= i; j++)
            for (int k = 0; k < 2; k++) {
                const double choose =
                    (const double[4][4]){{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}}[i][j];
                shifted[j][k] += powers[i][k] * choose * pow(a, i - j);
            }
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 1, breaks}, &shifted[0][0], 1e-9,
                                     &curve));
    memcpy(points, batten_curve_points(curve), 8 * sizeof *points);
    batten_curve_unref(curve);
}

TEST(the_lecture_cubic_has_its_invariants_and_its_loop)
{
    double points[8];
    batten_cubic cubic;
    const double middle = -1.0 / 6, half = sqrt(33) / 2;
    lecture_cubic(0, 1, points);
    CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
    CHECK_INT(cubic.whole, BATTEN_CUBIC_LOOP);
    CHECK_INT(cubic.segment, BATTEN_CUBIC_PLAIN);
    CHECK_NEAR(cubic.p, 1440, 1e-10);
    CHECK_NEAR(cubic.q, -240, 1e-10);
    CHECK_NEAR(cubic.r, 2000, 1e-10);
    CHECK_NEAR(cubic.invariant, -2.75, 1e-13);
    CHECK_NEAR(cubic.crossing[0], middle - half, 1e-13);
    CHECK_NEAR(cubic.crossing[1], middle + half, 1e-13);
    CHECK_NEAR(cubic.crossing[1], 2.7056146566, 1e-10);
    CHECK_NEAR(cubic.crossing[0], -3.0389479899, 1e-10);
    CHECK_NEAR(cubic.double_point.x, 1978.0 / 27, 1e-11);
    CHECK_NEAR(cubic.double_point.y, -710.0 / 3, 1e-11);
}

TEST(a_segment_of_the_lecture_cubic_tells_its_parameters)
{
    double points[8];
    batten_curve *curve = NULL;
    batten_cubics spans = {0, NULL};
    const double breaks[2] = {-5, 5};
    lecture_cubic(-5, 5, points);
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, points, NULL, &curve));
    CHECK_OK(batten_curve_classify(curve, 1e-12, &spans));
    CHECK_INT(spans.count, 1);
    CHECK_INT(spans.at[0].segment, BATTEN_CUBIC_LOOP);
    CHECK_NEAR(spans.at[0].crossing[0], -1.0 / 6 - sqrt(33) / 2, 1e-12);
    CHECK_NEAR(spans.at[0].crossing[1], -1.0 / 6 + sqrt(33) / 2, 1e-12);
    batten_cubics_release(&spans);
    batten_curve_unref(curve);
}

/* ---- each class ---- */

TEST(each_class_has_its_example)
{
    static const struct {
        double points[8];
        batten_cubic_class whole, segment;
    } rows[] = {
        {{0, 0, 0, 1, 1, 1, 1, 0}, BATTEN_CUBIC_LOOP, BATTEN_CUBIC_PLAIN},
        {{0, 0, 1, 1, 2, -1, 3, 0}, BATTEN_CUBIC_EXPLICIT, BATTEN_CUBIC_ONE_INFLECTION},
        {{0, 0, 1, 1, 0, 1, 1, 0}, BATTEN_CUBIC_CUSP, BATTEN_CUBIC_CUSP},
        {{0, 0, 3, 1, -2, 1, 1, 0}, BATTEN_CUBIC_LOOP, BATTEN_CUBIC_LOOP},
        {{0, 0, 0, 3, 9, 6, 9, 9}, BATTEN_CUBIC_EXPLICIT, BATTEN_CUBIC_ONE_INFLECTION},
        {{0, 0, 0, 5, -1, 4, 4, 4}, BATTEN_CUBIC_TWO_INFLECTIONS, BATTEN_CUBIC_TWO_INFLECTIONS},
        {{0, 0, 1, 0, 2, 1, 3, 3}, BATTEN_CUBIC_PARABOLA, BATTEN_CUBIC_PLAIN},
        {{0, 0, 1, 1, 2, 2, 3, 3}, BATTEN_CUBIC_LINE, BATTEN_CUBIC_LINE},
        {{0, 0, 3, 3, -1, -1, 3, 3}, BATTEN_CUBIC_RETRACED_LINE, BATTEN_CUBIC_RETRACED_LINE},
        {{0, 0, 1, 0, 3, 0, 6, 0}, BATTEN_CUBIC_RETRACED_LINE, BATTEN_CUBIC_LINE},
        {{2, 5, 2, 5, 2, 5, 2, 5}, BATTEN_CUBIC_POINT, BATTEN_CUBIC_POINT},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_cubic cubic;
        CHECK_OK(batten_cubic_classify(2, rows[i].points, 0, &cubic));
        CHECK_TEXT(batten_cubic_class_name(cubic.whole),
                   batten_cubic_class_name(rows[i].whole));
        CHECK_TEXT(batten_cubic_class_name(cubic.segment),
                   batten_cubic_class_name(rows[i].segment));
    }
    CHECK_TEXT(batten_cubic_class_text(BATTEN_CUBIC_LOOP), "a loop");
    CHECK_TEXT(batten_cubic_class_text((batten_cubic_class)99), "unknown");
    CHECK_TEXT(batten_cubic_class_name((batten_cubic_class)-1), "unknown");
}

TEST(parameters_are_where_it_happens)
{
    test_random random = test_random_begin("parameters");
    for (int n = test_cases(500); n > 0; n--) {
        double points[8], at[3][2], other[2];
        batten_curve *curve = NULL;
        batten_cubic cubic;
        random_points(&random, points);
        CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
        CHECK_OK(shape_bezier(2, 3, points, &curve));
        for (int k = 0; k < cubic.inflection_count; k++) {
            const double t = cubic.inflections[k];
            if (t < 0 || t > 1)
                continue;
            CHECK_OK(batten_curve_evaluate(curve, t, 2, &at[0][0]));
            CHECK_NEAR(at[1][0] * at[2][1] - at[1][1] * at[2][0], 0, 1e-12);
        }
        if (cubic.segment == BATTEN_CUBIC_LOOP) {
            CHECK_OK(batten_curve_evaluate(curve, cubic.crossing[0], 0, at[0]));
            CHECK_OK(batten_curve_evaluate(curve, cubic.crossing[1], 0, other));
            CHECK_NEAR(at[0][0], other[0], 1e-13);
            CHECK_NEAR(at[0][1], other[1], 1e-13);
            CHECK_NEAR(at[0][0], cubic.double_point.x, 1e-13);
        }
        batten_curve_unref(curve);
    }
}

/* ---- exactly on boundaries ---- */

TEST(cusps_of_whole_numbers_are_cusps)
{
    /* P' = (t - s) (a + b t) (both coordinates), s = k / m: edges in whole numbers */
    test_random random = test_random_begin("cusps");
    for (int n = test_cases(2000); n > 0; n--) {
        const int m = test_random_int(&random, 2, 40), k = test_random_int(&random, 1, m - 1);
        double points[8] = {test_random_int(&random, -9, 9), test_random_int(&random, -9, 9)};
        double linear[2][2];
        batten_cubic cubic;
        for (int j = 0; j < 2; j++) {
            linear[j][0] = test_random_int(&random, -20, 20);
            linear[j][1] = test_random_int(&random, -20, 20);
            /* Bezier form of 2 (m t - k) (a (1-t) + b t): -2 k a, (m - k) a - k b, 2 (m - k) b
             */
            const double a = linear[j][0], b = linear[j][1];
            points[2 + j] = points[j] - 2 * k * a;
            points[4 + j] = points[2 + j] + (m - k) * a - k * b;
            points[6 + j] = points[4 + j] + 2 * (m - k) * b;
        }
        if (linear[0][0] * linear[1][1] == linear[0][1] * linear[1][0])
            continue;
        CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
        CHECK_INT(cubic.segment, BATTEN_CUBIC_CUSP);
        CHECK_INT(cubic.whole, BATTEN_CUBIC_CUSP);
        CHECK_NEAR(cubic.cusp, (double)k / m, 1e-14);
        CHECK(cubic.margin == 0);
        CHECK_NEAR(cubic.invariant, 0, 0);
    }
}

__extension__ typedef __int128 wide;

/* All forms in whole numbers. */
static void whole_signs(const int *p, int *signs)
{
    wide e[3][2], v[BAT_FORM_COUNT];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            e[i][k] = (wide)p[2 * i + 2 + k] - p[2 * i + k];
    const wide a = e[0][0] * e[1][1] - e[0][1] * e[1][0];
    const wide b = e[0][0] * e[2][1] - e[0][1] * e[2][0];
    const wide c = e[1][0] * e[2][1] - e[1][1] * e[2][0];
    v[BAT_FORM_A] = a;
    v[BAT_FORM_B] = b;
    v[BAT_FORM_C] = c;
    v[BAT_FORM_LEAD] = a - b + c;
    v[BAT_FORM_FIRST] = 2 * a - b;
    v[BAT_FORM_LAST] = 2 * c - b;
    v[BAT_FORM_D] = b * b - 4 * a * c;
    v[BAT_FORM_RETURN] = a * a - a * b + b * b - 3 * a * c;
    v[BAT_FORM_LEAVE] = c * c - c * b + b * b - 3 * a * c;
    for (int k = 0; k < BAT_FORM_COUNT; k++)
        signs[k] = v[k] > 0 ? 1 : v[k] < 0 ? -1 : 0;
}

TEST(signs_are_those_of_whole_numbers_of_128_bits)
{
    test_random random = test_random_begin("whole numbers");
    const int reaches[] = {2, 5, 100, 100000, 100000000};
    for (int n = test_cases(4000); n > 0; n--) {
        const int reach = reaches[n % COUNT(reaches)];
        int p[8], signs[BAT_FORM_COUNT];
        double points[8];
        batten_cubic cubic;
        for (int k = 0; k < 8; k++)
            p[k] = test_random_int(&random, -reach, reach);
        if (n % 3 == 0) { /* the last point such that D or A - B + C is near 0 */
            p[6] = p[0] - 3 * p[2] + 3 * p[4] + test_random_int(&random, -1, 1);
            p[7] = p[1] - 3 * p[3] + 3 * p[5] + test_random_int(&random, -1, 1);
        }
        for (int k = 0; k < 8; k++)
            points[k] = ldexp(p[k], -300);
        whole_signs(p, signs);
        CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
        if (signs[BAT_FORM_A] == 0 && signs[BAT_FORM_B] == 0 && signs[BAT_FORM_C] == 0) {
            CHECK(cubic.segment >= BATTEN_CUBIC_LINE);
            continue;
        }
        CHECK_INT(cubic.segment, bat_cubic_segment_class(signs));
        CHECK_INT(cubic.whole, bat_cubic_whole_class(signs));
    }
}

TEST(cubics_one_bit_from_a_cusp_are_told_apart)
{
    double points[8] = {0, 0, 1, 1, 0, 1, 1, 0};
    CHECK_INT(segment_class(points), BATTEN_CUBIC_CUSP);
    points[4] = 0x1p-70;
    CHECK_INT(segment_class(points), BATTEN_CUBIC_TWO_INFLECTIONS);
    points[4] = -0x1p-70;
    CHECK_INT(segment_class(points), BATTEN_CUBIC_LOOP);
    batten_cubic cubic;
    CHECK_OK(batten_cubic_classify(2, points, 1e-12, &cubic));
    CHECK_INT(cubic.segment, BATTEN_CUBIC_CUSP);
}

/* ---- in space ---- */

TEST(a_tilted_cubic_is_what_it_is_in_its_plane)
{
    test_random random = test_random_begin("tilted");
    for (int n = test_cases(300); n > 0; n--) {
        double flat[8], space[12];
        batten_cubic plane, tilted;
        for (int k = 0; k < 8; k++)
            flat[k] = test_random_int(&random, -6, 6);
        for (int i = 0; i < 4; i++) { /* u = (1, 2, 2), v = (-2, 0, 3) */
            space[3 * i] = flat[2 * i] - 2 * flat[2 * i + 1];
            space[3 * i + 1] = 2 * flat[2 * i];
            space[3 * i + 2] = 2 * flat[2 * i] + 3 * flat[2 * i + 1];
        }
        CHECK_OK(batten_cubic_classify(2, flat, 0, &plane));
        CHECK_OK(batten_cubic_classify(3, space, 0, &tilted));
        CHECK_INT(tilted.segment, plane.segment);
        CHECK_INT(tilted.whole, plane.whole);
        CHECK_NEAR(tilted.margin, plane.margin, 1e-14);
        space[5] += 0x1p-40;
        CHECK_OK(batten_cubic_classify(3, space, 0, &tilted));
        space[5] -= 0x1p-40;
    }
}

TEST(a_twisted_cubic_is_a_space_cubic)
{
    const double twisted[12] = {0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 3, 1e-9};
    const double upright[12] = {0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3};
    batten_cubic cubic;
    CHECK_OK(batten_cubic_classify(3, twisted, 0, &cubic));
    CHECK_INT(cubic.segment, BATTEN_CUBIC_SPACE);
    CHECK(cubic.margin > 0 && cubic.margin < 1e-9);
    CHECK_OK(batten_cubic_classify(3, twisted, 1e-6, &cubic));
    CHECK_INT(cubic.whole, BATTEN_CUBIC_PARABOLA);
    CHECK_OK(batten_cubic_classify(3, upright, 0, &cubic));
    CHECK_INT(cubic.segment, BATTEN_CUBIC_LINE);
}

/* ---- against a search ---- */

static void evaluate(const double *p, double t, double *x, double *bend)
{
    double d[2], e[2];
    const double s = 1 - t;
    for (int k = 0; k < 2; k++) {
        const double a = p[k], b = p[2 + k], c = p[4 + k], f = p[6 + k];
        x[k] = s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * f;
        d[k] = s * s * (b - a) + 2 * s * t * (c - b) + t * t * (f - c);
        e[k] = s * (c - 2 * b + a) + t * (f - 2 * c + b);
    }
    *bend = d[0] * e[1] - d[1] * e[0];
}

static double side(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

enum { STEPS = 64 };

static bool polygon_crosses(double x[STEPS + 1][2])
{
    for (int i = 0; i < STEPS; i++)
        for (int j = i + 2; j < STEPS; j++)
            if (side(x[i], x[i + 1], x[j]) * side(x[i], x[i + 1], x[j + 1]) < 0 &&
                side(x[j], x[j + 1], x[i]) * side(x[j], x[j + 1], x[i + 1]) < 0)
                return true;
    return false;
}

/* Count sign changes of P' x P'', and look for a crossing of the polygon through samples. */
static batten_cubic_class searched_class(const double *points)
{
    double x[STEPS + 1][2], bend, before = 0;
    int changes = 0;
    for (int i = 0; i <= 4 * STEPS; i++) {
        double at[2];
        evaluate(points, i / (4.0 * STEPS), at, &bend);
        if (i % 4 == 0)
            memcpy(x[i / 4], at, sizeof at);
        changes += before * bend < 0;
        before = bend;
    }
    if (changes > 0)
        return changes == 1 ? BATTEN_CUBIC_ONE_INFLECTION : BATTEN_CUBIC_TWO_INFLECTIONS;
    return polygon_crosses(x) ? BATTEN_CUBIC_LOOP : BATTEN_CUBIC_PLAIN;
}

TEST(a_search_finds_the_same_class)
{
    test_random random = test_random_begin("search");
    int seen[BATTEN_CUBIC_CLASS_COUNT] = {0}, compared = 0, cases = test_cases(4000);
    for (int n = 0; n < cases; n++) {
        double points[8];
        batten_cubic cubic;
        random_points(&random, points);
        CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
        /* A loop or a pair of inflections is then wider than two steps of the search. */
        if (cubic.margin < 0.02)
            continue;
        compared++;
        seen[cubic.segment]++;
        CHECK_TEXT(batten_cubic_class_name(cubic.segment),
                   batten_cubic_class_name(searched_class(points)));
    }
    CHECK(cases < 1000 || (compared > cases * 3 / 4 && seen[BATTEN_CUBIC_LOOP] > 10 &&
                           seen[BATTEN_CUBIC_TWO_INFLECTIONS] > 10));
}

/* ---- laws ---- */

TEST(the_invariant_follows_its_law)
{
    /* under t_old = c t_new + f and affine maps, I_old = c^2 I_new; classes stay */
    test_random random = test_random_begin("law");
    for (int n = test_cases(300); n > 0; n--) {
        double points[8], mapped[8], m[6];
        const double c = test_random_in(&random, 0.1, 0.6);
        batten_curve *curve = NULL, *part = NULL, *rest = NULL;
        batten_cubic old, new;
        random_points(&random, points);
        for (int k = 0; k < 6; k++)
            m[k] = test_random_in(&random, -2, 2);
        if (fabs(m[0] * m[3] - m[1] * m[2]) < 0.1)
            continue;
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 2; k++)
                mapped[2 * i + k] =
                    m[2 * k] * points[2 * i] + m[2 * k + 1] * points[2 * i + 1] + m[4 + k];
        CHECK_OK(shape_bezier(2, 3, mapped, &curve));
        CHECK_OK(batten_curve_split(curve, c, &part, &rest));
        CHECK_OK(batten_cubic_classify(2, points, 0, &old));
        CHECK_OK(batten_cubic_classify(2, batten_curve_points(rest), 0, &new));
        if (old.whole_margin > 1e-6) {
            CHECK_INT(new.whole, old.whole);
            CHECK_NEAR(new.invariant / (fabs(old.invariant) / ((1 - c) * (1 - c))),
                       old.invariant < 0 ? -1 : 1, 1e-8);
        }
        batten_curve_unref(part);
        batten_curve_unref(rest);
        batten_curve_unref(curve);
    }
}

TEST(g10_a_reversed_cubic_has_its_parameters_reversed)
{
    test_random random = test_random_begin("reversed");
    for (int n = test_cases(500); n > 0; n--) {
        double points[8], back[8];
        batten_cubic there, here;
        random_points(&random, points);
        for (int i = 0; i < 4; i++)
            memcpy(back + 2 * i, points + 6 - 2 * i, 2 * sizeof *back);
        CHECK_OK(batten_cubic_classify(2, points, 0, &there));
        CHECK_OK(batten_cubic_classify(2, back, 0, &here));
        CHECK_INT(here.segment, there.segment);
        CHECK_INT(here.whole, there.whole);
        CHECK_NEAR(here.margin, there.margin, 1e-14);
        CHECK_NEAR(here.lambda, there.mu, 1e-9 * fabs(there.mu));
        if (there.segment == BATTEN_CUBIC_LOOP)
            CHECK_NEAR(here.crossing[0], 1 - there.crossing[1], 1e-12);
    }
}

/* ---- bad input ---- */

TEST(n1_cubics_that_are_not_finite_are_refused)
{
    double points[16] = {0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, NAN, 1, 0};
    batten_cubic cubic[2];
    CHECK_STATUS(batten_cubic_classify(2, points + 8, 0, cubic), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 3");
    CHECK_STATUS(batten_cubics_classify(2, 2, points, 0, NULL, cubic), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 3 of cubic 2");
}

TEST(n2_cubics_of_any_size_are_classified)
{
    const double sizes[] = {1e-300, 5e-324, 1e-9, 1e9, 1e140};
    const double points[8] = {0, 0, 3, 1, -2, 1, 1, 0};
    for (int i = 0; i < COUNT(sizes); i++) {
        double scaled[8];
        batten_cubic cubic;
        for (int k = 0; k < 8; k++)
            scaled[k] = points[k] * sizes[i];
        CHECK_OK(batten_cubic_classify(2, scaled, 0, &cubic));
        CHECK_INT(cubic.segment, BATTEN_CUBIC_LOOP);
    }
    const double huge[8] = {0, 0, 3e300, 1e300, -2e300, 1e300, 1e300, 0};
    batten_cubic cubic;
    CHECK_STATUS(batten_cubic_classify(2, huge, 0, &cubic), BATTEN_OVERFLOW);
}

TEST(n6_tolerances_and_dimensions_outside_their_range_are_refused)
{
    const double points[8] = {0, 0, 1, 1, 0, 1, 1, 0};
    batten_cubic cubic;
    CHECK_STATUS(batten_cubic_classify(2, points, -1, &cubic), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_cubic_classify(2, points, 1, &cubic), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_cubic_classify(2, points, NAN, &cubic), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_cubic_classify(1, points, 0, &cubic), BATTEN_BAD_ARGUMENT);
}

TEST(curves_of_other_kinds_are_refused)
{
    const double points[10] = {0, 0, 1, 2, 2, 0, 3, 3, 4, 0}, weights[4] = {1, 2, 1, 1};
    const double breaks[2] = {0, 1};
    batten_curve *quartic = NULL, *rational = NULL, *conic = NULL;
    batten_cubics spans = {0, NULL};
    CHECK_OK(shape_bezier(2, 4, points, &quartic));
    CHECK_OK(
        batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, points, weights, &rational));
    CHECK_OK(shape_bezier(2, 2, points, &conic));
    CHECK_STATUS(batten_curve_classify(quartic, 0, &spans), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("degree 4");
    CHECK_STATUS(batten_curve_classify(rational, 0, &spans), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("rational");
    CHECK_OK(batten_curve_classify(conic, 1e-12, &spans));
    CHECK_INT(spans.at[0].whole, BATTEN_CUBIC_PARABOLA);
    batten_cubics_release(&spans);
    batten_curve_unref(quartic);
    batten_curve_unref(rational);
    batten_curve_unref(conic);
}

TEST(batches_have_the_same_bits_on_any_number_of_threads)
{
    enum { MANY = 10000 };
    test_random random = test_random_begin("batch");
    double *points = test_array(MANY, 8 * sizeof *points);
    batten_cubic *one = test_array(MANY, sizeof *one), *three = test_array(MANY, sizeof *three);
    batten_job job = BATTEN_JOB;
    job.thread_count = 3;
    for (int i = 0; i < MANY; i++)
        random_points(&random, points + 8 * i);
    CHECK_OK(batten_cubics_classify(MANY, 2, points, 1e-12, NULL, one));
    CHECK_OK(batten_cubics_classify(MANY, 2, points, 1e-12, &job, three));
    for (int i = 0; i < MANY; i++) {
        CHECK_INT(one[i].segment, three[i].segment);
        CHECK_BITS(one[i].margin, three[i].margin);
        CHECK_BITS(one[i].p, three[i].p);
    }
}

/* (5 t^2 - 3 t, 5 t^3 - 3 t^2) is at the origin with t = 0 and 0.6. When it begins there it
 * returns through its first point, and A^2 - A B + B^2 - 3 A C vanishes; so backwards. */
TEST(a_loop_may_close_at_an_end)
{
    const double points[8] = {0, 0, -1, 0, -1 / 3.0, -1, 2, 2};
    const double ends[] = {0, 1}, powers[] = {0, 0, -3, 0, 5, -3, 0, 5};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 1, ends}, powers, 0, &curve));
    for (int i = 0; i < 8; i++)
        CHECK_NEAR(batten_curve_points(curve)[i], points[i], 1e-15);
    batten_curve_unref(curve);
    for (int back = 0; back < 2; back++) {
        double p[8];
        batten_cubic cubic;
        for (int i = 0; i < 4; i++)
            memcpy(p + 2 * (size_t)i, points + 2 * (size_t)(back ? 3 - i : i), 2 * sizeof *p);
        CHECK_OK(batten_cubic_classify(2, p, 0, &cubic));
        const double a = back ? cubic.c : cubic.a, b = cubic.b, c = back ? cubic.a : cubic.c;
        CHECK_NEAR(a * a - a * b + b * b - 3 * a * c, 0, 1e-13);
        CHECK_INT(cubic.whole, BATTEN_CUBIC_LOOP);
        CHECK_NEAR(cubic.crossing[0], back ? 0.4 : 0, 1e-14);
        CHECK_NEAR(cubic.crossing[1], back ? 1 : 0.6, 1e-14);
    }
}
