#include "shape/local/curvature_ends.h"

#include "support/test.h"

static double cross(const double *u, const double *v)
{
    return u[0] * v[1] - u[1] * v[0];
}

/* The signed curvature at the start of the cubic with these legs. */
static double start_curvature(const double *t0, const double *t1, const double *chord, double x,
                              double y)
{
    const double leg[2] = {chord[0] - y * t1[0], chord[1] - y * t1[1]};
    return 2.0 / 3 * cross(t0, leg) / (x * x);
}

static void check_solution(const double *t0, const double *t1, const double *chord, double k0,
                           double k1, bat_legs legs)
{
    const double l = hypot(chord[0], chord[1]), x = legs.start, y = legs.end;
    const double back[2] = {-chord[0], -chord[1]}, b0[2] = {-t1[0], -t1[1]},
                 b1[2] = {-t0[0], -t0[1]};
    CHECK(x > 0 && y > 0);
    const double noise = 1e-12 * (1 + y / l);
    CHECK_NEAR((start_curvature(t0, t1, chord, x, y) - k0) * x * x / l, 0,
               noise * (1 + fabs(k0) * x * x / l));
    CHECK_NEAR((-start_curvature(b0, b1, back, y, x) - k1) * y * y / l, 0,
               1e-12 * (1 + x / l) * (1 + fabs(k1) * y * y / l));
}

TEST(the_quarter_circle_has_legs_05485837704)
{
    const double t0[] = {0, 1}, t1[] = {-1, 0}, chord[] = {-1, 1};
    bat_legs legs[BAT_DBHS_SOLUTIONS];
    const int count = bat_dbhs(t0, t1, chord, 1, 1, legs);
    CHECK(count >= 1);
    CHECK_NEAR(legs[0].start, 0.5485837704, 5e-11);
    CHECK_NEAR(legs[0].end, 0.5485837704, 5e-11);
}

TEST(straight_spans_have_legs_of_a_third)
{
    const double t[] = {0.6, 0.8}, chord[] = {3, 4};
    bat_legs legs[BAT_DBHS_SOLUTIONS];
    CHECK_INT(bat_dbhs(t, t, chord, 0, 0, legs), 1);
    CHECK_NEAR(legs[0].start, 5.0 / 3, 1e-15);
    CHECK_NEAR(legs[0].end, 5.0 / 3, 1e-15);
    CHECK_INT(bat_dbhs(t, t, chord, 1, 0, legs), 0);
}

/* Every cubic has its own legs among the solutions, up to three with any. */
TEST(the_legs_of_any_cubic_are_found_again)
{
    test_random random = test_random_begin("legs");
    int several = 0, most = 0;
    for (int c = 0; c < test_cases(20000); c++) {
        const double a = test_random_in(&random, -3, 3), b = test_random_in(&random, -3, 3);
        const double x = test_random_in(&random, 0.02, 2), y = test_random_in(&random, 0.02, 2);
        const double near = c % 4 == 0 ? a + test_random_in(&random, -1e-4, 1e-4) : b;
        const double t0[] = {cos(a), sin(a)}, t1[] = {cos(near), sin(near)}, chord[] = {1, 0};
        const double back[] = {-1, 0}, b0[] = {-t1[0], -t1[1]}, b1[] = {-t0[0], -t0[1]};
        const double k0 = start_curvature(t0, t1, chord, x, y),
                     k1 = -start_curvature(b0, b1, back, y, x);
        bat_legs legs[BAT_DBHS_SOLUTIONS];
        const int count = bat_dbhs(t0, t1, chord, k0, k1, legs);
        double off = HUGE_VAL, last = 0;
        for (int i = 0; i < count; i++) {
            check_solution(t0, t1, chord, k0, k1, legs[i]);
            off = fmin(off, hypot(legs[i].start - x, legs[i].end - y));
            const double third = hypot(legs[i].start - 1.0 / 3, legs[i].end - 1.0 / 3);
            CHECK(third >= last);
            last = third;
        }
        /* Where the two parabolas touch, a root is good to half the digits. */
        const double det = fabs(9 * k0 * x * k1 * y - cross(t0, t1) * cross(t0, t1));
        if (det > 1e-6 && off > 1e-6)
            printf("x %.17g y %.17g a %.17g b %.17g off %g of %d\n", x, y, a, near, off, count);
        CHECK(det <= 1e-6 || off <= 1e-6);
        several += count > 1;
        most = count > most ? count : most;
    }
    CHECK(several > 0 || test_cases(20000) < 100);
    CHECK(most <= 3);
}

TEST(three_solutions_exist_and_are_all_found)
{
    /* A grid of starts, refined by Newton, finds no more than the solver. */
    test_random random = test_random_begin("three");
    int threes = 0;
    for (int c = 0; c < test_cases(3000); c++) {
        const double a = test_random_in(&random, 0.1, 1.5),
                     b = -test_random_in(&random, 0.1, 1.5);
        const double t0[] = {cos(a), sin(a)}, t1[] = {cos(b), sin(b)}, chord[] = {1, 0};
        const double k0 = -test_random_in(&random, 0, 6), k1 = -test_random_in(&random, 0, 6);
        bat_legs legs[BAT_DBHS_SOLUTIONS];
        const int count = bat_dbhs(t0, t1, chord, k0, k1, legs);
        int signs = 0;
        double before = 0;
        /* Along the first parabola, sign changes of the second equation. */
        for (int i = 1; i <= 4000; i++) {
            const double x = i * 0.0005,
                         y = (cross(t0, chord) - 1.5 * k0 * x * x) / cross(t0, t1);
            const double g = cross(t0, t1) * x - cross(chord, t1) + 1.5 * k1 * y * y;
            signs += y > 0 && before * g < 0;
            before = y > 0 ? g : 0;
        }
        CHECK(count >= signs);
        threes += count == 3;
        for (int i = 0; i < count; i++)
            check_solution(t0, t1, chord, k0, k1, legs[i]);
    }
    CHECK(threes > 0 || test_cases(3000) < 100);
}
