#include "numeric/whole.h"

#include "support/test.h"

__extension__ typedef __int128 wide;

enum { MANY = 2000 };

static bat_effort effort;
static bat_wholes pool;

static void begin(void)
{
    effort = (bat_effort){BATTEN_OK, UINT64_MAX};
    pool = (bat_wholes){&effort, NULL, NULL, 0};
}

static void end(void)
{
    bat_wholes_release(&pool);
}

/* -1, 0 or 1: a is below b, equal or above. */
static int order_of(bat_whole a, bat_whole b)
{
    return bat_whole_subtract(&pool, a, b).sign;
}

/* A number of about so many bits. */
static bat_whole some(test_random *random, int bits)
{
    bat_whole a = bat_whole_of_int(&pool, test_random_int(random, -1000, 1000));
    while (a.sign != 0 && bat_whole_bits(a) < bits)
        a = bat_whole_add(&pool, bat_whole_shift(&pool, a, 31),
                          bat_whole_of_int(&pool, (int64_t)(test_random_bits(random) >> 34)));
    return a;
}

TEST(sums_and_products_are_those_of_128_bits)
{
    test_random random = test_random_begin("wide");
    begin();
    for (int n = test_cases(MANY); n > 0; n--) {
        const int64_t a = (int64_t)(test_random_bits(&random) >> 2) - ((int64_t)1 << 61);
        const int64_t b = (int64_t)(test_random_bits(&random) >> 2) - ((int64_t)1 << 61);
        const bat_whole x = bat_whole_of_int(&pool, a), y = bat_whole_of_int(&pool, b);
        const wide product = (wide)a * b;
        const bat_whole high = bat_whole_of_int(&pool, (int64_t)(product >> 62));
        const bat_whole low =
            bat_whole_of_int(&pool, (int64_t)(product & (((wide)1 << 62) - 1)));
        const bat_whole back = bat_whole_add(&pool, bat_whole_shift(&pool, high, 62), low);
        if (effort.status != BATTEN_OK)
            break;
        CHECK_INT(order_of(bat_whole_multiply(&pool, x, y), back), 0);
        CHECK_INT(order_of(bat_whole_subtract(&pool, x, y), bat_whole_of_int(&pool, a - b)), 0);
        CHECK_INT(bat_whole_modulo(x, 2147483647u), (a % 2147483647 + 2147483647) % 2147483647);
        bat_wholes_empty(&pool);
    }
    end();
}

TEST(quotient_and_rest_give_the_number_back)
{
    test_random random = test_random_begin("quotient");
    begin();
    for (int n = test_cases(MANY); n > 0; n--) {
        const bat_whole a = some(&random, test_random_int(&random, 1, 700));
        const bat_whole b = some(&random, test_random_int(&random, 1, 400));
        if (b.sign == 0 || effort.status != BATTEN_OK)
            continue;
        bat_whole rest;
        const bat_whole q = bat_whole_divide(&pool, a, b, &rest);
        const bat_whole back = bat_whole_add(&pool, bat_whole_multiply(&pool, q, b), rest);
        if (effort.status != BATTEN_OK)
            break;
        CHECK_INT(order_of(back, a), 0);
        CHECK(bat_whole_bits(rest) <= bat_whole_bits(b));
        const bat_whole size = b.sign < 0 ? bat_whole_negated(b) : b;
        CHECK(order_of(rest.sign < 0 ? bat_whole_negated(rest) : rest, size) < 0);
        bat_wholes_empty(&pool);
    }
    end();
}

TEST(a_quotient_whose_first_guess_is_too_large_is_mended)
{
    /* the digits 2^32 - 1 everywhere make the guess of a digit wrong as often as can be */
    begin();
    const bat_whole one = bat_whole_of_int(&pool, 1);
    for (int bits = 64; bits <= 256; bits += 32) {
        const bat_whole power = bat_whole_shift(&pool, one, bits);
        const bat_whole b = bat_whole_subtract(&pool, power, one);
        const bat_whole a = bat_whole_subtract(&pool, bat_whole_multiply(&pool, b, power),
                                               bat_whole_of_int(&pool, 1));
        bat_whole rest;
        const bat_whole q = bat_whole_divide(&pool, a, b, &rest);
        const bat_whole back = bat_whole_add(&pool, bat_whole_multiply(&pool, q, b), rest);
        if (effort.status != BATTEN_OK)
            break;
        CHECK_INT(order_of(back, a), 0);
        CHECK_INT(order_of(q, b), 0);
    }
    end();
}

TEST(the_common_divisor_divides_and_is_greatest)
{
    test_random random = test_random_begin("gcd");
    begin();
    for (int n = test_cases(MANY / 4); n > 0; n--) {
        const bat_whole g = some(&random, 90), a = some(&random, 130), b = some(&random, 70);
        if (g.sign * a.sign * b.sign == 0)
            continue;
        const bat_whole prime = bat_whole_gcd(&pool, a, b);
        const bat_whole all = bat_whole_gcd(&pool, bat_whole_multiply(&pool, g, a),
                                            bat_whole_multiply(&pool, b, g));
        const bat_whole product = bat_whole_multiply(&pool, prime, g);
        if (effort.status != BATTEN_OK)
            break;
        CHECK_INT(order_of(all, product.sign < 0 ? bat_whole_negated(product) : product), 0);
        bat_wholes_empty(&pool);
    }
    end();
}

TEST(doubles_come_and_go_exactly)
{
    test_random random = test_random_begin("doubles");
    begin();
    for (int n = test_cases(MANY); n > 0; n--) {
        const int shift = test_random_int(&random, 60, 300);
        const double value =
            ldexp(test_random_in(&random, -1, 1), test_random_int(&random, 0, 90));
        int exponent;
        const bat_whole a = bat_whole_of_double(&pool, value, shift);
        if (effort.status != BATTEN_OK)
            break;
        const double part = bat_whole_frexp(a, &exponent);
        CHECK_BITS(ldexp(part, exponent - shift), value);
        const bat_whole three = bat_whole_times(&pool, a, 3);
        if (effort.status == BATTEN_OK && a.sign)
            CHECK_NEAR(bat_whole_ratio(a, three) * 3, 1, 4 * DBL_EPSILON);
        bat_wholes_empty(&pool);
    }
    end();
}

TEST(an_effort_ends_when_its_steps_are_used_up)
{
    begin();
    effort.steps = 1000;
    bat_whole a = bat_whole_of_int(&pool, 3);
    for (int k = 0; k < 40; k++)
        a = bat_whole_multiply(&pool, a, a);
    if (effort.status != BATTEN_OUT_OF_MEMORY)
        CHECK_INT(effort.status, BATTEN_INCOMPLETE);
    CHECK_INT(a.sign, 0);
    end();
}
