#include "support/faults.h"
#include "support/test.h"
#include <batten/continuity.h>
#include <batten/standard.h>

static void random_curve(test_random *random, int dimension, bool rational, batten_curve **out)
{
    double points[24], weights[8];
    const int degree = test_random_int(random, 3, 4), count = degree + 3;
    const double knots[13] = {0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1};
    const double more[13] = {0, 0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1, 1};
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < dimension; k++)
            points[i * dimension + k] = (k == 0 ? i : 0) + test_random_in(random, -0.4, 0.4);
        weights[i] = test_random_in(random, 0.5, 2);
    }
    CHECK_OK(batten_curve_create((batten_points){dimension, count, points}, degree,
                                 rational ? weights : NULL, degree == 3 ? knots : more, out));
}

TEST(curves_join_as_asked_whichever_moves)
{
    test_random random = test_random_begin("match");
    for (int n = test_cases(60); n > 0; n--) {
        batten_curve *a = NULL, *b = NULL, *far = NULL;
        const int dimension = test_random_int(&random, 2, 3);
        random_curve(&random, dimension, n % 2 == 0, &a);
        random_curve(&random, dimension, n % 3 == 0, &far);
        const batten_affine map = batten_affine_translation(6, 0.1, 0);
        CHECK_OK(batten_curve_transform(far, &map, &b));
        const int kind = test_random_int(&random, 0, 1);
        const int order = test_random_int(&random, 0, kind ? 3 : 2);
        const int mover = test_random_int(&random, 0, 2);
        batten_curve *made[2] = {NULL, NULL};
        double moved = -1;
        CHECK_EACH_ALLOCATION(batten_curves_match(
            a, b, (batten_match){(batten_match_kind)kind, order, (batten_match_mover)mover},
            &moved, &made[0], &made[1]));
        batten_continuity c;
        CHECK_OK(batten_curves_continuity(made[0], BATTEN_CURVE_END, made[1],
                                          BATTEN_CURVE_START, NULL, &c));
        CHECK((kind ? c.parametric : c.geometric) >= order);
        CHECK(c.gap <= 1e-12);
        CHECK(moved > 0);
        /* what need not move has the same bits */
        const batten_curve *given[2] = {a, b};
        for (int k = 0; k < 2; k++) {
            const int count = batten_curve_point_count(made[k]) * dimension;
            const double *p = batten_curve_points(made[k]), *q = batten_curve_points(given[k]);
            const int touched = mover == (k ? 1 : 0) ? 0 : (order + 1) * dimension;
            for (int i = 0; i < count - touched; i++) {
                const int at = k ? count - 1 - i : i;
                CHECK_BITS(p[at], q[at]);
            }
            batten_curve_unref(made[k]);
        }
        batten_curve_unref(far);
        batten_curve_unref(b);
        batten_curve_unref(a);
    }
}

TEST(least_moves_of_both_curves_meet_halfway)
{
    /* Two lines of length 1 with a gap of 1: C0 moves both ends by half of it. */
    const double p[8] = {0, 0, 1, 0, 1, 1, 2, 1};
    batten_curve *a = NULL, *b = NULL, *c = NULL, *d = NULL;
    double moved;
    CHECK_OK(batten_curve_line(2, p, p + 2, &a));
    CHECK_OK(batten_curve_line(2, p + 4, p + 6, &b));
    CHECK_EACH_ALLOCATION(batten_curves_match(
        a, b, (batten_match){BATTEN_MATCH_PARAMETRIC, 0, BATTEN_MATCH_MOVES_BOTH}, &moved, &c,
        &d));
    CHECK_NEAR(moved, 0.5, 1e-15);
    CHECK_NEAR(batten_curve_points(c)[3], 0.5, 1e-15);
    CHECK_NEAR(batten_curve_points(d)[1], 0.5, 1e-15);
    batten_curve_unref(d);
    batten_curve_unref(c);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(what_cannot_join_is_refused)
{
    const double p[9] = {0, 0, 0, 1, 0, 0, 0, 0, 0};
    batten_curve *line = NULL, *plane = NULL, *point = NULL, *a = NULL, *b = NULL;
    CHECK_OK(batten_curve_line(3, p, p + 3, &line));
    CHECK_OK(batten_curve_line(2, p, p + 3, &plane));
    CHECK_OK(batten_curve_line(3, p, p, &point));
    CHECK_STATUS(
        batten_curves_match(line, plane,
                            (batten_match){BATTEN_MATCH_GEOMETRIC, 0, BATTEN_MATCH_MOVES_BOTH},
                            NULL, &a, &b),
        BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(
        batten_curves_match(line, line,
                            (batten_match){BATTEN_MATCH_GEOMETRIC, 2, BATTEN_MATCH_MOVES_BOTH},
                            NULL, &a, &b),
        BATTEN_BAD_DEGREE);
    CHECK_STATUS(
        batten_curves_match(line, line,
                            (batten_match){BATTEN_MATCH_GEOMETRIC, 3, BATTEN_MATCH_MOVES_BOTH},
                            NULL, &a, &b),
        BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curves_match(
                     line, point,
                     (batten_match){BATTEN_MATCH_GEOMETRIC, 1, BATTEN_MATCH_MOVES_SECOND}, NULL,
                     &a, &b),
                 BATTEN_SINGULAR_HERE);
    CHECK(a == NULL && b == NULL);
    batten_curve_unref(point);
    batten_curve_unref(plane);
    batten_curve_unref(line);
}

/* A segment and a parabola whose ends are matched; where the two points at the moved end come to lie,
 * and the longest way of one. */
static const struct {
    batten_match_mover mover;
    double first[4], second[4]; /* last two points of the first, first two of the second */
    double made[2][4], moved;
} tangents[] = {
    /* legs keep their length along the common tangent ... */
    {BATTEN_MATCH_MOVES_SECOND, {0, 0, 1, 0}, {1, 1, 4, 5}, {{0, 0, 1, 0}, {1, 0, 4, 0}}, 5},
    {BATTEN_MATCH_MOVES_FIRST, {-2, 3, 0, 0}, {1, 1, 4, 1}, {{-2, 1, 1, 1}, {1, 1, 4, 1}}, 2},
    /* ... and all of it where they point back */
    {BATTEN_MATCH_MOVES_SECOND,
     {0, 0, 1, 0},
     {1, 0, -2, 4},
     {{0, 0, 1, 0}, {1, 0, 6, 0}},
     8.9442719099991588},
    {BATTEN_MATCH_MOVES_FIRST,
     {4, 5, 1, 1},
     {1, 1, 2, 1},
     {{-4, 1, 1, 1}, {1, 1, 2, 1}},
     8.9442719099991588},
    {BATTEN_MATCH_MOVES_BOTH, {0, 0, 2, 0}, {2, 2, 2, 5}, {{0, 0, 0, 0}, {0, 0, 0, 0}}, -1},
};

TEST(geometric_matching_turns_the_legs_at_the_joint_and_keeps_their_length)
{
    for (int i = 0; i < COUNT(tangents); i++) {
        static const double knots[6] = {0, 0, 0, 1, 1, 1};
        const double *f = tangents[i].first, *s = tangents[i].second;
        const double p[2][6] = {{-9, 7, f[0], f[1], f[2], f[3]},
                                {s[0], s[1], s[2], s[3], 9, 8}};
        batten_curve *given[2] = {NULL, NULL}, *made[2] = {NULL, NULL};
        double moved = 0;
        for (int k = 0; k < 2; k++)
            CHECK_OK(
                batten_curve_create((batten_points){2, 3, p[k]}, 2, NULL, knots, &given[k]));
        CHECK_OK(batten_curves_match(
            given[0], given[1], (batten_match){BATTEN_MATCH_GEOMETRIC, 1, tangents[i].mover},
            &moved, &made[0], &made[1]));
        const double *a = batten_curve_points(made[0]) + 2, *b = batten_curve_points(made[1]);
        for (int k = 0; k < 4 && tangents[i].moved >= 0; k++) {
            CHECK_NEAR(a[k], tangents[i].made[0][k], 1e-14);
            CHECK_NEAR(b[k], tangents[i].made[1][k], 1e-14);
        }
        if (tangents[i].moved >= 0) {
            CHECK_NEAR(moved, tangents[i].moved, 1e-14);
        } else { /* both: halfway, along the bisector of right angles, as far as legs reach */
            const double h = sqrt(0.5);
            CHECK(a[2] == 2 && a[3] == 1 && b[0] == 2 && b[1] == 1);
            CHECK_NEAR(2 - a[0], h * h * 3, 1e-14);
            CHECK_NEAR(1 - a[1], h * h * 3, 1e-14);
            CHECK_NEAR(b[2] - 2, h * h * 4, 1e-14);
            CHECK_NEAR(b[3] - 1, h * h * 4, 1e-14);
        }
        for (int k = 0; k < 2; k++) {
            batten_curve_unref(given[k]);
            batten_curve_unref(made[k]);
        }
    }
}
