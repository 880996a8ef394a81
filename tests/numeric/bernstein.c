#include "numeric/bernstein.h"

#include "support/test.h"

/* Multiply by (t - r) in Bernstein form: r(1-t)*(-1)... the factor has the coefficients -r and
 * 1 - r. */
static void multiply(int degree, double *c, double r)
{
    double out[BAT_BERNSTEIN_DEGREE + 1] = {0};
    for (int i = 0; i <= degree + 1; i++) {
        const double up = (double)i / (degree + 1);
        out[i] =
            (i <= degree ? (1 - up) * c[i] * -r : 0) + (i > 0 ? up * c[i - 1] * (1 - r) : 0);
    }
    memcpy(c, out, sizeof out);
}

static void make(int count, const double *at, double *c)
{
    memset(c, 0, (BAT_BERNSTEIN_DEGREE + 1) * sizeof *c);
    c[0] = 1;
    for (int i = 0; i < count; i++)
        multiply(i, c, at[i]);
}

TEST(a_split_polynomial_has_the_same_values)
{
    test_random random = test_random_begin("split");
    for (int degree = 0; degree <= 100; degree += 1 + degree / 3) {
        double c[BAT_BERNSTEIN_DEGREE + 1], left[BAT_BERNSTEIN_DEGREE + 1],
            right[BAT_BERNSTEIN_DEGREE + 1];
        for (int i = 0; i <= degree; i++)
            c[i] = test_random_in(&random, -1, 1);
        const double t = test_random_unit(&random), s = test_random_unit(&random);
        bat_bernstein_split(degree, c, t, left, right);
        const double bound = 8 * (degree + 1) * DBL_EPSILON;
        CHECK_NEAR(bat_bernstein_value(degree, left, s), bat_bernstein_value(degree, c, t * s),
                   bound);
        CHECK_NEAR(bat_bernstein_value(degree, right, s),
                   bat_bernstein_value(degree, c, t + (1 - t) * s), bound);
        CHECK_BITS(left[degree], right[0]);
        bat_bernstein_split(degree, c, t, NULL, c);
        CHECK(memcmp(c, right, (size_t)(degree + 1) * 8) == 0);
    }
}

static void check_roots(int count, const double *at, int expected, const double *roots,
                        const int *orders, double tolerance)
{
    double c[BAT_BERNSTEIN_DEGREE + 1];
    bat_root found[BAT_BERNSTEIN_DEGREE];
    int found_count = 0;
    make(count, at, c);
    CHECK_OK(bat_bernstein_roots(count, c, 0, found, &found_count));
    CHECK_INT(found_count, expected);
    for (int i = 0; i < expected; i++) {
        CHECK_NEAR(found[i].t, roots[i], tolerance);
        CHECK_INT(found[i].multiplicity, orders[i]);
    }
}

TEST(roots_are_found_where_they_were_put)
{
    check_roots(3, (const double[]){0.2, 0.5, 0.9}, 3, (const double[]){0.2, 0.5, 0.9},
                (const int[]){1, 1, 1}, 1e-15);
    check_roots(2, (const double[]){0.5, 0.5}, 1, (const double[]){0.5}, (const int[]){2},
                1e-15);
    check_roots(2, (const double[]){0.3, 0.3}, 1, (const double[]){0.3}, (const int[]){2},
                1e-14);
    check_roots(3, (const double[]){0.7, 0.7, 0.7}, 1, (const double[]){0.7}, (const int[]){3},
                1e-10);
    check_roots(4, (const double[]){0, 0, 1, 0.25}, 3, (const double[]){0, 0.25, 1},
                (const int[]){2, 1, 1}, 1e-15);
    check_roots(3, (const double[]){1, 1, 1}, 1, (const double[]){1}, (const int[]){3}, 0);
    check_roots(3, (const double[]){-0.5, 1.5, 7}, 0, NULL, NULL, 0);
    check_roots(2, (const double[]){1e-9, 1 - 1e-9}, 2, (const double[]){1e-9, 1 - 1e-9},
                (const int[]){1, 1}, 1e-16);
    check_roots(3, (const double[]){0.4, 0.4, 0.8}, 2, (const double[]){0.4, 0.8},
                (const int[]){2, 1}, 1e-13);
    check_roots(0, NULL, 0, NULL, NULL, 0);
}

TEST(near_roots_are_told_apart)
{
    for (double gap = 1e-1; gap > 3e-7; gap /= 3)
        check_roots(2, (const double[]){0.5, 0.5 + gap}, 2, (const double[]){0.5, 0.5 + gap},
                    (const int[]){1, 1}, 1e-14 / gap);
}

TEST(random_simple_roots_are_all_found)
{
    test_random random = test_random_begin("roots");
    for (int i = test_cases(300); i > 0; i--) {
        double at[8], c[BAT_BERNSTEIN_DEGREE + 1];
        const int count = test_random_int(&random, 1, 8);
        for (int k = 0; k < count; k++)
            at[k] = (k + test_random_in(&random, 0.1, 0.9)) / count;
        make(count, at, c);
        bat_root found[8];
        int found_count = 0;
        CHECK_OK(bat_bernstein_roots(count, c, 0, found, &found_count));
        CHECK_INT(found_count, count);
        for (int k = 0; k < count; k++)
            CHECK_NEAR(found[k].t, at[k], 1e-9);
    }
}

/* A line, and a smoothed cosine, which has as many roots as its coefficients have changes of
 * sign. */
TEST(a_polynomial_of_degree_100_has_all_its_roots)
{
    double c[101];
    bat_root found[100];
    int count = 0;
    /* (2 t - 1)^100 - 2^-100 (..) is too flat; one sign change among 101 coefficients is not.
     */
    for (int i = 0; i <= 100; i++)
        c[i] = i - 30.5;
    CHECK_OK(bat_bernstein_roots(100, c, 0, found, &count));
    CHECK_INT(count, 1);
    CHECK_NEAR(found[0].t, 0.305, 1e-14);
    for (int i = 0; i <= 100; i++)
        c[i] = cos(i * 0.1);
    CHECK_OK(bat_bernstein_roots(100, c, 0, found, &count));
    CHECK_INT(count, 3);
    for (int i = 0; i < count; i++)
        CHECK_NEAR(bat_bernstein_value(100, c, found[i].t), 0, 1e-14);
}

TEST(what_only_touches_zero_counts_twice)
{
    const double c[3] = {1, -1 + 1e-17, 1};
    bat_root found[2];
    int count = 0;
    CHECK_OK(bat_bernstein_roots(2, c, 1e-12, found, &count));
    CHECK_INT(count, 1);
    CHECK_INT(found[0].multiplicity, 2);
    CHECK_NEAR(found[0].t, 0.5, 1e-12);
    const double lifted[3] = {1, -1 + 1e-11, 1};
    CHECK_OK(bat_bernstein_roots(2, lifted, 0, found, &count));
    CHECK_INT(count, 0);
}

TEST(zero_is_flagged)
{
    const double nothing[4] = {0}, little[2] = {1e-9, -1e-9};
    bat_root found[4];
    int count = 0;
    CHECK_OK(bat_bernstein_roots(3, nothing, 0, found, &count));
    CHECK_INT(count, -1);
    CHECK_OK(bat_bernstein_roots(1, little, 1e-8, found, &count));
    CHECK_INT(count, -1);
    CHECK_OK(bat_bernstein_roots(1, little, 0, found, &count));
    CHECK_INT(count, 1);
    CHECK_BITS(found[0].t, 0.5);
}
