#include <batten/invariants.h>
#include <batten/standard.h>

#include "inspect/shapes.h"
#include "support/generate.h"
#include "support/test.h"

static batten_affine random_map(test_random *random, int d)
{
    batten_affine map = batten_affine_identity();
    for (int i = 0; i < d; i++) {
        for (int j = 0; j < d; j++)
            map.m[i][j] = test_random_in(random, -1, 1) + (i == j ? 1.5 : 0);
        map.t[i] = test_random_in(random, -5, 5);
    }
    if (test_random_bits(random) % 2)
        for (int j = 0; j < d; j++)
            map.m[0][j] = -map.m[0][j];
    return map;
}

static batten_curve *random_bezier(test_random *random, int d, int degree)
{
    double points[3 * (BATTEN_MAX_DEGREE + 1)];
    batten_curve *curve = NULL;
    for (int i = 0; i < d * (degree + 1); i++)
        points[i] = test_random_in(random, -1, 1);
    CHECK_OK(shape_bezier(d, degree, points, &curve));
    return curve;
}

/* map(from(c v + f)) = to(v) at some v of `to`. */
static double match_error(const batten_curve *from, const batten_curve *to,
                          const batten_affine_match *m)
{
    const int d = batten_curve_dimension(to);
    const batten_interval x = batten_curve_domain(from), y = batten_curve_domain(to);
    double worst = 0;
    for (int i = 0; i <= 20; i++) {
        const double v = y.a + (y.b - y.a) * i / 20, u = m->c * v + m->f;
        double p[3] = {0}, q[3] = {0};
        if (u < x.a || u > x.b)
            continue;
        CHECK_OK(batten_curve_evaluate(from, u, 0, p));
        CHECK_OK(batten_curve_evaluate(to, v, 0, q));
        const batten_vec3 image =
            batten_affine_apply(m->map, (batten_vec3){p[0], p[1], d > 2 ? p[2] : 0});
        worst = fmax(worst, hypot(hypot(image.x - q[0], image.y - q[1]), image.z - q[2]));
    }
    return worst;
}

TEST(spec_7_an_image_with_t_to_1_minus_2_t_is_recovered)
{
    test_random random = test_random_begin("recovered");
    for (int n = test_cases(60); n > 0; n--) {
        const int d = n % 3 ? 2 : 3, degree = d + 1 + n % 4;
        batten_curve *whole = random_bezier(&random, d, degree), *from = NULL, *part = NULL,
                     *turned = NULL, *to = NULL;
        const batten_affine map = random_map(&random, d);
        batten_affine_match m;
        /* `to` is a part backwards, the whole with t = 1 - 2 v or from 0.1 to 0.6 with t = 0.6
         * - 0.5 v; `from` is the part from 0.3 to 0.9 */
        const bool all = n % 2;
        CHECK_OK(batten_curve_subrange(whole, 0.3, 0.9, &from));
        CHECK_OK(batten_curve_subrange(whole, all ? 0 : 0.1, all ? 1 : 0.6, &part));
        CHECK_OK(batten_curve_reverse(part, &turned));
        batten_curve_unref(part);
        CHECK_OK(batten_curve_set_domain(turned, 0, all ? 0.5 : 1, &part));
        CHECK_OK(batten_curve_transform(part, &map, &to));
        CHECK_OK(batten_curve_affine_match(from, to, 1e-9, &m));
        CHECK(m.found && m.is_whole);
        CHECK(m.error < 1e-9);
        if (degree > 3) { /* a cubic is its own image, run backwards */
            CHECK_NEAR(m.c, all ? -2 : -0.5, 1e-9);
            CHECK_NEAR(m.f, all ? 1 : 0.6, 1e-9);
        }
        CHECK(match_error(from, to, &m) < 1e-9);
        batten_curve_unref(whole);
        batten_curve_unref(from);
        batten_curve_unref(part);
        batten_curve_unref(turned);
        batten_curve_unref(to);
    }
}

TEST(splines_are_matched_end_to_end_both_ways)
{
    test_random random = test_random_begin("splines");
    const test_wish wish = {.rational = TEST_NEVER, .clamped = TEST_ALWAYS, .tame = true};
    for (int n = test_cases(60); n > 0; n--) {
        test_wish w = wish;
        w.dimension = 2 + n % 2;
        w.degree = 2 + n % 3;
        batten_curve *from = test_curve(&random, &w), *turned = NULL, *to = NULL;
        const batten_affine map = random_map(&random, w.dimension);
        batten_affine_match m;
        if (n % 4 < 2)
            CHECK_OK(batten_curve_reverse(from, &turned));
        else
            turned = batten_curve_ref(from);
        CHECK_OK(batten_curve_transform(turned, &map, &to));
        const double size = test_curve_size(to);
        CHECK_OK(batten_curve_affine_match(from, to, 1e-9 * size, &m));
        CHECK(m.found);
        CHECK(match_error(from, to, &m) <= 1e-9 * size);
        for (int i = 0; i < w.dimension && batten_curve_spans(from, NULL) > 3; i++)
            for (int j = 0; j < w.dimension; j++)
                CHECK_NEAR(m.map.m[i][j], map.m[i][j], 1e-5);
        batten_curve_unref(from);
        batten_curve_unref(turned);
        batten_curve_unref(to);
    }
}

TEST(spec_7_other_curves_are_no_images)
{
    test_random random = test_random_begin("others");
    for (int n = test_cases(60); n > 0; n--) {
        const int d = n % 3 ? 2 : 3, degree = d + 2 + n % 3;
        batten_curve *from = random_bezier(&random, d, degree);
        batten_curve *to = random_bezier(&random, d, degree);
        batten_affine_match m;
        CHECK_OK(batten_curve_affine_match(from, to, 1e-9, &m));
        CHECK(!m.found && m.error > 1e-6);
        batten_curve_unref(from);
        batten_curve_unref(to);
    }
}

TEST(all_parabolas_and_all_lines_are_images_of_each_other)
{
    const double first[6] = {0, 0, 1, 2, 3, 0}, second[6] = {7, 1, -3, 2, 1, 1};
    batten_curve *a = NULL, *b = NULL, *line = NULL, *space = NULL;
    batten_affine_match m;
    CHECK_OK(shape_bezier(2, 2, first, &a));
    CHECK_OK(shape_bezier(2, 2, second, &b));
    CHECK_OK(shape_bezier(2, 1, first, &line));
    CHECK_OK(shape_bezier(3, 1, (const double[]){0, 1, 2, 5, 5, 5}, &space));
    CHECK_OK(batten_curve_affine_match(a, b, 1e-12, &m));
    CHECK(m.found && !m.is_whole && m.c == 1);
    CHECK_OK(batten_curve_affine_match(line, space, 1e-12, &m));
    CHECK(m.found);
    CHECK(fabs(m.map.m[2][0]) + fabs(m.map.m[2][1]) > 0.1);
    CHECK_OK(batten_curve_affine_match(a, line, 1e-12, &m));
    CHECK(!m.found && isinf(m.error));
    batten_curve_unref(a);
    batten_curve_unref(b);
    batten_curve_unref(line);
    batten_curve_unref(space);
}

TEST(a_point_is_the_image_of_a_point)
{
    batten_curve *a = NULL, *b = NULL;
    batten_affine_match m;
    CHECK_OK(shape_bezier(2, 1, (const double[]){1, 2, 1, 2}, &a));
    CHECK_OK(shape_bezier(2, 2, (const double[]){5, 2, 5, 2, 5, 2}, &b));
    CHECK_OK(batten_curve_affine_match(a, b, 0, &m));
    CHECK(m.found && m.error == 0);
    batten_curve_unref(a);
    batten_curve_unref(b);
}

TEST(curves_that_cannot_be_compared_are_refused)
{
    batten_curve *line = NULL, *arc = NULL, *function = NULL;
    batten_affine_match m;
    CHECK_OK(shape_bezier(2, 1, (const double[]){1, 2, 3, 4}, &line));
    CHECK_OK(shape_bezier(1, 1, (const double[]){1, 2}, &function));
    CHECK_OK(batten_curve_arc(1, 1, &arc));
    CHECK_STATUS(batten_curve_affine_match(line, arc, 0, &m), BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_curve_affine_match(function, line, 0, &m), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_affine_match(line, line, -1, &m), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_affine_match(line, line, NAN, &m), BATTEN_BAD_ARGUMENT);
    batten_curve_unref(line);
    batten_curve_unref(arc);
    batten_curve_unref(function);
}
