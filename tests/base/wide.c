/* Two words against the 128 bits of the compiler. */
#define BAT_WIDE_BY_WORDS
#include "base/wide.h"

#include "support/test.h"

__extension__ typedef unsigned __int128 native;

static native native_of(bat_wide a)
{
    return (native)bat_wide_high(a) << 64 | bat_wide_low(a);
}

/* Words of all sizes, among them those whose halves carry. */
static uint64_t random_word(test_random *random)
{
    const uint64_t bits = test_random_bits(random) >> test_random_int(random, 0, 63);
    const int kind = test_random_int(random, 0, 5);
    return kind == 0 ? UINT64_MAX : kind == 1 ? ~bits : bits;
}

TEST(two_words_compute_as_128_bits_do)
{
    test_random random = test_random_begin("wide");
    for (int n = test_cases(20000); n > 0; n--) {
        const uint64_t a = random_word(&random), b = random_word(&random);
        const bat_wide x = bat_wide_of(a, b), y = bat_wide_of(random_word(&random), a);
        const native nx = native_of(x), ny = native_of(y);
        CHECK(native_of(bat_wide_product(a, b)) == (native)a * b);
        CHECK(native_of(bat_wide_add(x, y)) == nx + ny);
        CHECK(native_of(bat_wide_subtract(x, y)) == nx - ny);
        CHECK_INT(bat_wide_compare(x, y), (nx > ny) - (nx < ny));
        CHECK_INT(bat_wide_compare(x, x), 0);
    }
}

TEST(two_words_shift_by_0_to_127)
{
    test_random random = test_random_begin("shift");
    for (int n = 0; n < 128; n++) {
        const bat_wide x = bat_wide_of(random_word(&random), random_word(&random));
        const native whole = native_of(x), one = 1;
        CHECK(native_of(bat_wide_left(x, n)) == whole << n);
        CHECK(native_of(bat_wide_right(x, n)) == whole >> n);
        CHECK(native_of(bat_wide_rest(x, n)) == (whole & ((one << n) - 1)));
    }
}

TEST(only_zero_is_zero)
{
    CHECK(bat_wide_is_zero(bat_wide_of(0, 0)));
    CHECK(!bat_wide_is_zero(bat_wide_of(1, 0)));
    CHECK(!bat_wide_is_zero(bat_wide_of(0, 1)));
}
