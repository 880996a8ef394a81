#include "numeric/exact.h"

#include "support/test.h"

__extension__ typedef __int128 wide;

static int sign_of(wide value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

TEST(products_of_whole_numbers_have_the_sign_of_128_bits)
{
    test_random random = test_random_begin("exact");
    for (int n = test_cases(2000); n > 0; n--) {
        /* a b - c d with factors of 60 bits, nearly equal products */
        const int64_t a = (int64_t)(test_random_bits(&random) >> 4);
        const int64_t b = (int64_t)(test_random_bits(&random) >> 4);
        const int64_t c = a + test_random_int(&random, -1, 1);
        const int64_t d = b + test_random_int(&random, -1, 1);
        bat_exact part[4], sum = {.count = 0};
        const int64_t value[4] = {a, b, c, d};
        for (int k = 0; k < 4; k++) {
            const double high = (double)(value[k] >> 30) * 0x1p30;
            part[k] = bat_exact_difference(high, -(double)(value[k] - (int64_t)high));
        }
        bat_exact_add_product(&sum, 1, &part[0], &part[1]);
        bat_exact_add_product(&sum, -1, &part[2], &part[3]);
        CHECK_INT(bat_exact_sign(&sum), sign_of((wide)a * b - (wide)c * d));
    }
}

TEST(what_cancels_leaves_nothing)
{
    test_random random = test_random_begin("cancel");
    for (int n = test_cases(200); n > 0; n--) {
        double a[20];
        bat_exact sum = {.count = 0};
        for (int k = 0; k < 20; k++) {
            a[k] = ldexp(test_random_in(&random, -1, 1), test_random_int(&random, -400, 400));
            const bat_exact term = bat_exact_difference(a[k], 0);
            bat_exact_add(&sum, 3, &term);
        }
        for (int k = 19; k >= 0; k--) {
            const bat_exact term = bat_exact_difference(0, a[k]);
            CHECK(bat_exact_sign(&sum) != 0);
            bat_exact_add(&sum, 3, &term);
        }
        CHECK_INT(bat_exact_sign(&sum), 0);
    }
}

TEST(parts_never_run_out)
{
    bat_exact sum = {.count = 0};
    for (int k = -1000; k <= 1000; k += 7) {
        const bat_exact term = bat_exact_difference(ldexp(1, k), 0);
        bat_exact_add(&sum, k % 2 ? 1 : -1, &term);
        CHECK(sum.count < BAT_EXACT_PARTS);
    }
    CHECK(bat_exact_sign(&sum) != 0);
}

/* The sum of the parts, each of which is a whole number below 2^107. */
static wide whole_sum(const bat_exact *a)
{
    wide sum = 0;
    for (int i = 0; i < a->count; i++)
        sum += (wide)a->part[i];
    return sum;
}

TEST(a_product_of_doubles_has_all_its_106_bits)
{
    test_random random = test_random_begin("products");
    for (int n = test_cases(100000); n > 0; n--) {
        const int64_t a =
            (int64_t)(test_random_bits(&random) >> test_random_int(&random, 11, 40));
        const int64_t b =
            -(int64_t)(test_random_bits(&random) >> test_random_int(&random, 11, 40));
        const bat_exact factor = bat_exact_difference((double)a, 0);
        bat_exact product = {.count = 0};
        bat_exact_add(&product, (double)b, &factor);
        CHECK(whole_sum(&product) == (wide)a * b);
    }
}

TEST(a_product_has_the_same_parts_at_every_size)
{
    test_random random = test_random_begin("sizes");
    for (int n = test_cases(10000); n > 0; n--) {
        const double a = test_random_in(&random, 1, 2), b = test_random_in(&random, 1, 2);
        /* All of the product stays within the doubles: 2^-1074 to 2^1023. */
        const int up_a = test_random_int(&random, -1000, 1022), least = -965 - up_a,
                  most = 1021 - up_a;
        const int up_b =
            test_random_int(&random, least > -1000 ? least : -1000, most < 1022 ? most : 1022);
        const bat_exact plain = bat_exact_difference(a, 0),
                        large = bat_exact_difference(ldexp(a, up_a), 0);
        bat_exact product = {.count = 0}, moved = {.count = 0};
        bat_exact_add(&product, b, &plain);
        bat_exact_add(&moved, ldexp(b, up_b), &large);
        CHECK_INT(moved.count, product.count);
        for (int i = 0; i < product.count; i++)
            CHECK_BITS(moved.part[i], ldexp(product.part[i], up_a + up_b));
    }
}
