/* Intervals of real roots: which, how narrow, and what is known about them. */
#include "numeric/whole_polynomial.h"

#include "base/base.h"
#include "support/test.h"

enum { MOST = 5 };

static bat_effort effort;
static bat_wholes pool;

static bat_whole_poly polynomial(int degree, const int64_t *c)
{
    effort = (bat_effort){BATTEN_OK, UINT64_MAX};
    pool = (bat_wholes){&effort, NULL, NULL, 0};
    bat_whole_poly p = bat_poly_make(&pool, degree);
    for (int i = 0; i <= p.degree; i++)
        p.c[i] = bat_whole_of_int(&pool, c[i]);
    return bat_poly_trim(p);
}

static bool is_int(bat_whole a, int64_t value)
{
    return bat_whole_subtract(&pool, a, bat_whole_of_int(&pool, value)).sign == 0;
}

/* Powers from the constant up, and each root as its interval (c, c + 1) / 2^k of t or 1 / t, or its
 * point; `sign` is that of the polynomial right of its begin. */
static const struct {
    int degree;
    int64_t c[MOST + 1];
    int count;
    struct {
        bool inverse, exact;
        int c, k, sign;
    } roots[MOST];
} rows[] = {
    {0, {3}, 0, {{0}}},
    {1, {0, 1}, 1, {{false, true, 0, 0, 0}}},
    {1, {-1, 1}, 1, {{false, true, 1, 0, 0}}},
    {1, {1, 1}, 1, {{false, true, -1, 0, 0}}},
    {1, {-1, 2}, 1, {{false, false, 0, 0, -1}}},
    {1, {1, -2}, 1, {{false, false, 0, 0, 1}}},
    {1, {1, 2}, 1, {{false, false, -1, 0, -1}}},
    {1, {-3, 1}, 1, {{true, false, 0, 0, 1}}},
    {1, {3, 1}, 1, {{true, false, -1, 0, -1}}},
    /* t (2 t - 1), whose value at 0 is 0: its slope tells */
    {2, {0, -1, 2}, 2, {{false, true, 0, 0, 0}, {false, false, 0, 0, -1}}},
    /* (4 t - 1) (4 t - 3), and with the middle between */
    {2, {3, -16, 16}, 2, {{false, false, 0, 1, 1}, {false, false, 1, 1, -1}}},
    {3,
     {-3, 22, -48, 32},
     3,
     {{false, false, 0, 1, -1}, {false, true, 1, 1, 0}, {false, false, 1, 1, -1}}},
    /* (t - 3) (t - 5) (t + 2): 1 / t is -1 / 2, 1 / 3 and 1 / 5 */
    {3,
     {30, -1, -6, 1},
     3,
     {{true, false, -1, 0, -1}, {true, false, 1, 2, -1}, {true, false, 0, 2, 1}}},
    /* (t^2 + 1) (t^2 - 2) */
    {4, {-2, 0, -1, 0, 1}, 2, {{true, false, -1, 0, -1}, {true, false, 0, 0, 1}}},
};

TEST(roots_are_isolated_in_the_widest_halves_that_hold_one)
{
    for (int r = 0; r < COUNT(rows); r++) {
        bat_whole_root found[MOST];
        int count = -1;
        const bat_whole_poly p = polynomial(rows[r].degree, rows[r].c);
        bat_poly_isolate(&pool, p, found, &count);
        if (effort.status == BATTEN_OK) {
            CHECK_INT(count, rows[r].count);
            for (int i = 0; i < count; i++) {
                CHECK_INT(found[i].inverse, rows[r].roots[i].inverse);
                CHECK_INT(found[i].exact, rows[r].roots[i].exact);
                CHECK_INT(found[i].k, rows[r].roots[i].k);
                CHECK(is_int(found[i].c, rows[r].roots[i].c));
                CHECK_INT(found[i].sign, rows[r].roots[i].sign);
            }
        }
        bat_wholes_release(&pool);
    }
}

/* The square root of 2 as t, and of a half as 1 / t, in a ring of intervals of `bits` places. */
TEST(an_interval_is_narrowed_to_its_bits_and_holds_its_root)
{
    static const int bits[] = {1, 2, 3, 5, 30, 60, 61, 100, 200};
    static const int64_t square[2][3] = {{-1, 0, 2}, {-2, 0, 1}};
    for (int i = 0; i < 2 * COUNT(bits); i++) {
        bat_whole_root found[2];
        int count = 0;
        const bat_whole_poly p = polynomial(2, square[i % 2]);
        bat_poly_isolate(&pool, p, found, &count);
        for (int k = 0; k < count; k++) {
            bat_poly_refine(&pool, p, bits[i / 2], &found[k]);
            /* c^2 < 2^(2 k - 1) < (c + 1)^2 for the root above 0 */
            const bat_whole c = found[k].c, one = bat_whole_of_int(&pool, 1);
            const bat_whole half = bat_whole_shift(&pool, one, 2 * found[k].k - 1);
            const bat_whole end = bat_whole_add(&pool, c, one);
            const int low =
                bat_whole_subtract(&pool, bat_whole_multiply(&pool, c, c), half).sign;
            const int high =
                bat_whole_subtract(&pool, bat_whole_multiply(&pool, end, end), half).sign;
            if (effort.status != BATTEN_OK)
                break;
            CHECK(found[k].k >= bits[i / 2] && found[k].k < bits[i / 2] + 32);
            CHECK(!found[k].exact && found[k].inverse == (i % 2 == 1));
            CHECK_INT(low, k == 0 ? 1 : -1);
            CHECK_INT(high, k == 0 ? -1 : 1);
            const double value = bat_whole_root_value(&pool, &found[k]);
            if (effort.status == BATTEN_OK && bits[i / 2] > 60)
                CHECK_NEAR(value, (k == 0 ? -1 : 1) * sqrt(i % 2 ? 2 : 0.5), 2e-16);
        }
        bat_wholes_release(&pool);
    }
}

/* Of (t + 5) (t - 3 / 8 - 2^-40): a root that is met exactly is known as a point. */
TEST(a_root_that_is_a_binary_fraction_is_found_as_it_is)
{
    bat_whole_root found[2];
    int count = 0;
    const int64_t scale = (int64_t)1 << 40;
    const bat_whole_poly p = polynomial(
        2, (int64_t[]){-5 * (3 * scale / 8 + 1), 5 * scale - (3 * scale / 8 + 1), scale});
    bat_poly_isolate(&pool, p, found, &count);
    if (effort.status == BATTEN_OK) {
        CHECK_INT(count, 2);
        bat_poly_refine(&pool, p, 64, &found[1]);
        const double value = bat_whole_root_value(&pool, &found[1]);
        if (effort.status == BATTEN_OK) {
            CHECK(found[1].exact);
            CHECK_BITS(value, 0.375 + ldexp(1, -40));
        }
    }
    bat_wholes_release(&pool);
}

/* At the roots -sqrt 2, sqrt 2 of t^2 - 2: what vanishes at one, what is near, and constants. */
static const struct {
    int degree;
    int64_t c[4];
    int signs[2];
} others[] = {
    {0, {7}, {1, 1}},
    {0, {-7}, {-1, -1}},
    {1, {0, 1}, {-1, 1}},
    {1, {-7, 5}, {-1, 1}},         /* 1.4 */
    {1, {-17, 12}, {-1, -1}},      /* 1.41666.. */
    {1, {47321, -33461}, {1, -1}}, /* 1.414213562.., below it by 3e-10 */
    {2, {-2, 0, 1}, {0, 0}},
    {3, {-2, -2, 1, 1}, {0, 0}},
    {2, {-3, 0, 1}, {-1, -1}},
    {2, {-1, 0, 1}, {1, 1}},
    {2, {2, 0, -1}, {0, 0}},
    {3, {0, -2, 0, 1}, {0, 0}},
};

TEST(signs_at_roots_are_exact)
{
    for (int r = 0; r < COUNT(others); r++) {
        bat_whole_root found[2];
        int count = 0;
        const bat_whole_poly p = polynomial(2, (int64_t[]){-2, 0, 1});
        bat_whole_poly q = bat_poly_make(&pool, others[r].degree);
        for (int i = 0; i <= q.degree; i++)
            q.c[i] = bat_whole_of_int(&pool, others[r].c[i]);
        bat_poly_isolate(&pool, p, found, &count);
        for (int k = 0; k < count; k++) {
            const int sign = bat_poly_sign_at(&pool, q, p, &found[k]);
            if (effort.status == BATTEN_OK)
                CHECK_INT(sign, others[r].signs[k]);
        }
        bat_wholes_release(&pool);
    }
}

/* p(t + by) by its values, and the numbers of Bernstein of 1 - t, t^2 - t and 8 t^3. */
TEST(shifts_and_bernstein_coefficients_are_those_of_the_notes)
{
    static const int64_t c[4] = {5, -4, 3, 2};
    for (int by = -3; by <= 3; by++) {
        const bat_whole_poly p = polynomial(3, c);
        const bat_whole_poly shifted = bat_poly_shift(&pool, p, bat_whole_of_int(&pool, by));
        for (int t = -2; t <= 2 && effort.status == BATTEN_OK; t++) {
            const int64_t x = t + by, want = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
            const bat_whole value = bat_poly_value(
                &pool, shifted, 3, bat_whole_of_int(&pool, t), bat_whole_of_int(&pool, 1));
            if (effort.status == BATTEN_OK)
                CHECK(is_int(value, want));
        }
        bat_wholes_release(&pool);
    }
    static const struct {
        int degree;
        int64_t c[4];
        double b[4];
    } forms[] = {{1, {1, -1}, {1, 0}},
                 {1, {-3, 1}, {-1, -2.0 / 3}},
                 {2, {0, -1, 1}, {0, -1, 0}},
                 {2, {4, -6, 3}, {1, 0.25, 0.25}},
                 {3, {0, 0, 0, 8}, {0, 0, 0, 1}},
                 {3, {6, -3, 0, 0}, {1, 5.0 / 6, 4.0 / 6, 0.5}}};
    for (int i = 0; i < COUNT(forms); i++) {
        bat_whole_poly p = polynomial(forms[i].degree, forms[i].c);
        p.degree = forms[i].degree;
        double b[4];
        bat_poly_bernstein(&pool, p, b);
        for (int k = 0; k <= p.degree && effort.status == BATTEN_OK; k++)
            CHECK_NEAR(b[k], forms[i].b[k], 1e-15);
        bat_wholes_release(&pool);
    }
}
