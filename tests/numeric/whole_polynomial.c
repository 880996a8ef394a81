#include "numeric/whole_polynomial.h"

#include "base/base.h"
#include "numeric/bernstein.h"
#include "support/test.h"

static bat_effort effort;
static bat_wholes pool;

static void begin(void)
{
    effort = (bat_effort){BATTEN_OK, UINT64_MAX};
    pool = (bat_wholes){&effort, NULL, NULL, 0};
}

static bat_whole_poly of_ints(int degree, const int64_t *c)
{
    bat_whole_poly p = bat_poly_make(&pool, degree);
    for (int i = 0; i <= p.degree; i++)
        p.c[i] = bat_whole_of_int(&pool, c[i]);
    return bat_poly_trim(p);
}

/* The product of q t - p, over roots p / q. */
static bat_whole_poly with_roots(int count, int (*roots)[2])
{
    bat_whole_poly p = bat_poly_constant(&pool, 1);
    for (int i = 0; i < count; i++)
        p = bat_poly_multiply(&pool, p, of_ints(1, (int64_t[]){-roots[i][0], roots[i][1]}));
    return p;
}

/* Every root of p once. */
static bat_whole_poly radical_of(bat_whole_poly p)
{
    const bat_whole_poly whole = bat_poly_primitive(&pool, p);
    return bat_poly_quotient(&pool, whole,
                             bat_poly_gcd(&pool, whole, bat_poly_derivative(&pool, whole)));
}

static bool equal(bat_whole_poly p, bat_whole_poly q)
{
    for (int i = 0; i <= p.degree && p.degree == q.degree; i++)
        if (bat_whole_subtract(&pool, p.c[i], q.c[i]).sign != 0)
            return false;
    return p.degree == q.degree;
}

#define ALIVE (effort.status == BATTEN_OK)

TEST(every_real_root_is_found_in_order)
{
    int roots[][2] = {{-100000, 1}, {-7, 2}, {-1, 1},      {-1, 3}, {0, 1},    {1, 100000},
                      {1, 3},       {1, 1},  {1001, 1000}, {7, 2},  {12345, 1}};
    bat_whole_root found[13];
    int count = 0;
    begin();
    /* two more that are not real: 1 + t + t^2 */
    const bat_whole_poly p = bat_poly_multiply(&pool, with_roots(COUNT(roots), roots),
                                               of_ints(2, (int64_t[]){1, 1, 1}));
    bat_poly_isolate(&pool, p, found, &count);
    if (ALIVE)
        CHECK_INT(count, COUNT(roots));
    for (int i = 0; i < count && ALIVE; i++) {
        bat_poly_refine(&pool, p, 70, &found[i]);
        const double t = bat_whole_root_value(&pool, &found[i]);
        if (ALIVE)
            CHECK_NEAR(t * roots[i][1], roots[i][0],
                       2 * DBL_EPSILON * bat_max(1, fabs((double)roots[i][0])));
    }
    bat_wholes_release(&pool);
}

TEST(roots_of_random_products_come_back)
{
    test_random random = test_random_begin("products");
    for (int n = test_cases(200); n > 0; n--) {
        enum { DEGREE = 9 };
        int roots[DEGREE][2], count = 0, apart = 0;
        bat_whole_root found[DEGREE];
        begin();
        for (int i = 0; i < DEGREE; i++) {
            roots[i][0] = test_random_int(&random, -40, 40);
            roots[i][1] = test_random_int(&random, 1, 30);
        }
        const bat_whole_poly p = with_roots(DEGREE, roots), radical = radical_of(p);
        for (int i = 0; i < DEGREE; i++) {
            bool again = false;
            for (int j = 0; j < i; j++)
                again |= roots[i][0] * roots[j][1] == roots[j][0] * roots[i][1];
            apart += !again;
        }
        if (ALIVE)
            bat_poly_isolate(&pool, radical, found, &count);
        if (ALIVE) {
            CHECK_INT(radical.degree, apart);
            CHECK_INT(count, apart);
        }
        for (int i = 0; i < DEGREE && ALIVE; i++) { /* each vanishes at one of them */
            const bat_whole_poly linear = of_ints(1, (int64_t[]){-roots[i][0], roots[i][1]});
            int hits = 0, before = 1;
            for (int k = 0; k < count; k++) {
                const int sign = bat_poly_sign_at(&pool, linear, radical, &found[k]);
                hits += sign == 0;
                before = sign;
            }
            if (ALIVE) {
                CHECK_INT(hits, 1);
                CHECK(before >= 0); /* the last root is the largest */
            }
        }
        bat_wholes_release(&pool);
    }
}

TEST(multiplicities_are_told_apart)
{
    int one[1][2] = {{1, 3}}, two[1][2] = {{-2, 1}}, three[2][2] = {{5, 7}, {0, 1}};
    bat_whole_poly parts[12], p;
    begin();
    p = bat_poly_multiply(&pool, with_roots(1, one), of_ints(2, (int64_t[]){3, 0, 1}));
    const bat_whole_poly simple = p, twice = with_roots(1, two), thrice = with_roots(2, three);
    for (int k = 0; k < 2; k++)
        p = bat_poly_multiply(&pool, p, twice);
    for (int k = 0; k < 3; k++)
        p = bat_poly_multiply(&pool, p, thrice);
    const int highest = bat_poly_squarefree(&pool, bat_poly_primitive(&pool, p), parts);
    if (ALIVE) {
        CHECK_INT(highest, 3);
        CHECK(equal(parts[1], simple));
        CHECK(equal(parts[2], twice));
        CHECK(equal(parts[3], thrice));
    }
    bat_wholes_release(&pool);
}

TEST(common_divisors_are_found)
{
    test_random random = test_random_begin("common");
    for (int n = test_cases(300); n > 0; n--) {
        int64_t c[3][6];
        begin();
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 6; i++)
                c[k][i] = test_random_int(&random, -30, 30);
        const int degree = test_random_int(&random, 0, 5);
        const bat_whole_poly g = bat_poly_primitive(&pool, of_ints(degree, c[0]));
        const bat_whole_poly a = of_ints(5, c[1]), b = of_ints(4, c[2]);
        const bat_whole_poly rest = bat_poly_gcd(&pool, a, b);
        const bat_whole_poly common =
            bat_poly_gcd(&pool, bat_poly_multiply(&pool, a, g), bat_poly_multiply(&pool, b, g));
        const bat_whole_poly expected = bat_poly_multiply(&pool, g, rest);
        if (ALIVE && g.degree >= 0 && a.degree >= 0 && b.degree >= 0)
            CHECK(equal(common, expected));
        bat_wholes_release(&pool);
    }
}

TEST(near_roots_are_told_apart_and_signs_there_are_exact)
{
    /* (2^60 t - 2^59) (2^60 t - 2^59 - 1): half, and half and 2^-60 */
    bat_whole_root found[2];
    int count = 0;
    begin();
    const int64_t half = (int64_t)1 << 59;
    const bat_whole_poly low = of_ints(1, (int64_t[]){-half, 2 * half});
    const bat_whole_poly high = of_ints(1, (int64_t[]){-half - 1, 2 * half});
    const bat_whole_poly p = bat_poly_multiply(&pool, low, high);
    bat_poly_isolate(&pool, p, found, &count);
    int signs[2][2] = {{0}};
    for (int k = 0; k < count; k++) {
        signs[k][0] = bat_poly_sign_at(&pool, low, p, &found[k]);
        signs[k][1] = bat_poly_sign_at(&pool, high, p, &found[k]);
    }
    if (ALIVE) {
        CHECK_INT(count, 2);
        CHECK(signs[0][0] == 0 && signs[0][1] == -1);
        CHECK(signs[1][0] == 1 && signs[1][1] == 0);
    }
    bat_wholes_release(&pool);
}

TEST(polynomials_without_real_roots_have_no_intervals)
{
    bat_whole_root found[4];
    int count = 7;
    begin();
    bat_poly_isolate(&pool, of_ints(4, (int64_t[]){1, 0, 3, 0, 1}), found, &count);
    if (ALIVE)
        CHECK_INT(count, 0);
    bat_poly_isolate(&pool, of_ints(0, (int64_t[]){5}), found, &count);
    if (ALIVE)
        CHECK_INT(count, 0);
    bat_wholes_release(&pool);
}

TEST(the_coefficients_of_bernstein_have_the_values_of_the_polynomial)
{
    test_random random = test_random_begin(__func__);
    for (int n = test_cases(50); n > 0; n--) {
        begin();
        int64_t c[7];
        double b[7], largest = 0;
        const int degree = test_random_int(&random, 1, 6);
        for (int i = 0; i <= degree; i++)
            c[i] = test_random_int(&random, -9, 9);
        c[degree] = 5;
        bat_poly_bernstein(&pool, of_ints(degree, c), b);
        for (int k = 0; k <= degree && ALIVE; k++)
            largest = bat_max(largest, fabs(b[k]));
        if (ALIVE)
            CHECK_NEAR(largest, 1, 0); /* they are scaled to that */
        const double at[3] = {0, 0.25, 1};
        double value[3], sum[3] = {0};
        for (int i = 0; i < 3 && ALIVE; i++) {
            value[i] = bat_bernstein_value(degree, b, at[i]);
            for (int k = degree; k >= 0; k--)
                sum[i] = sum[i] * at[i] + (double)c[k];
        }
        for (int i = 0; i < 3 && ALIVE; i++) /* of one factor */
            CHECK_NEAR(value[i] * sum[1], value[1] * sum[i],
                       1e-14 * (fabs(sum[1]) + fabs(sum[i])));
        if (ALIVE)
            CHECK(value[1] * sum[1] >= 0);
        bat_wholes_release(&pool);
    }
}

TEST(sums_shorten_where_leading_coefficients_cancel)
{
    begin();
    const bat_whole_poly p = of_ints(3, (int64_t[]){1, 2, 0, 4}),
                         q = of_ints(1, (int64_t[]){0, 1}),
                         r = of_ints(3, (int64_t[]){0, 0, 0, 2});
    const bat_whole_poly sum = bat_poly_combine(&pool, 1, p, -2, r),
                         longer = bat_poly_combine(&pool, 3, q, 1, p),
                         none = bat_poly_combine(&pool, 1, p, -1, p);
    if (ALIVE) {
        CHECK(equal(sum, of_ints(1, (int64_t[]){1, 2})));
        CHECK(equal(longer, of_ints(3, (int64_t[]){1, 5, 0, 4})));
        CHECK_INT(none.degree, -1);
        bat_whole_root root = {false, true, bat_whole_of_int(&pool, 1), 0, 0};
        CHECK_INT(bat_poly_sign_at(&pool, none, p, &root), 0);
        /* 2^3 p(1/2) = 8 + 8 + 4 with the degree 3, and twice that with the degree 4 */
        const bat_whole one = bat_whole_of_int(&pool, 1), two = bat_whole_of_int(&pool, 2);
        const bat_whole least = bat_poly_value(&pool, p, 3, one, two),
                        more = bat_poly_value(&pool, p, 4, one, two);
        CHECK_INT(bat_whole_subtract(&pool, least, bat_whole_of_int(&pool, 20)).sign, 0);
        CHECK_INT(bat_whole_subtract(&pool, more, bat_whole_of_int(&pool, 40)).sign, 0);
    }
    bat_wholes_release(&pool);
}

TEST(roots_nearer_than_the_depth_of_the_search_are_reported_as_not_told_apart)
{
    /* (2^201 t - 1) (2^202 t - 1): both in (0, 2^-200) */
    bat_whole_root found[2];
    int count = 0;
    begin();
    bat_whole_poly p = bat_poly_make(&pool, 2);
    if (p.degree == 2) {
        p.c[0] = bat_whole_of_int(&pool, 1);
        p.c[1] = bat_whole_shift(&pool, bat_whole_of_int(&pool, -3), 201);
        p.c[2] = bat_whole_shift(&pool, bat_whole_of_int(&pool, 1), 403);
    }
    if (ALIVE) {
        bat_poly_isolate(&pool, p, found, &count);
        CHECK(effort.status == BATTEN_INCOMPLETE || effort.status == BATTEN_OUT_OF_MEMORY);
    }
    bat_wholes_release(&pool);
}

/* Two polynomials of degree 24 without a common root, the second led by this coefficient; what their
 * divisor takes of the effort. */
static uint64_t effort_of_coprime(int64_t lead)
{
    enum { DEGREE = 24 };
    int64_t c[2][DEGREE + 1];
    begin();
    for (int i = 0; i <= DEGREE; i++) {
        c[0][i] = (i * i * 37 + 11) % 101 - 50;
        c[1][i] = (i * i * 53 + 29) % 103 - 50;
    }
    c[1][DEGREE] = lead;
    const bat_whole_poly p = of_ints(DEGREE, c[0]), q = of_ints(DEGREE, c[1]);
    const uint64_t before = effort.steps;
    const bat_whole_poly common = bat_poly_gcd(&pool, p, q);
    const uint64_t spent = before - effort.steps;
    if (ALIVE)
        CHECK(equal(common, of_ints(0, (int64_t[]){1})));
    bat_wholes_release(&pool);
    return spent;
}

/* Their images modulo a prime tell, also where the first primes divide a leading coefficient. */
TEST(coprime_polynomials_are_told_without_dividing_them)
{
    static const int64_t leads[] = {7, 2147483647, 2147483647LL * 2147483629};
    for (int i = 0; i < COUNT(leads); i++)
        CHECK(effort_of_coprime(leads[i]) < 10000);
}
