#include "numeric/interval/interval.h"

#include "support/generate.h"
#include "support/test.h"

static bat_interval random_interval(test_random *random, double low, double high)
{
    const double a = test_random_in(random, low, high), b = test_random_in(random, low, high);
    return (bat_interval){bat_min(a, b), bat_max(a, b)};
}

static double within(test_random *random, bat_interval a)
{
    return bat_max(a.lo, bat_min(a.hi, test_random_in(random, a.lo, a.hi)));
}

static bool holds(bat_interval a, double x)
{
    return a.lo <= x && x <= a.hi;
}

TEST(results_of_operations_lie_in_the_intervals_of_the_operations)
{
    test_random random = test_random_begin("operations");
    for (int i = 0; i < 20000; i++) {
        const bat_interval a = random_interval(&random, -3, 3),
                           b = random_interval(&random, -3, 3);
        const double x = within(&random, a), y = within(&random, b);
        CHECK(holds(bat_interval_add(a, b), x + y));
        CHECK(holds(bat_interval_subtract(a, b), x - y));
        CHECK(holds(bat_interval_multiply(a, b), x * y));
        CHECK(holds(bat_interval_divide(a, b), x / y));
        CHECK(holds(bat_interval_power(a, 3), x * x * x));
        CHECK(holds(bat_interval_power(a, 4), x * x * x * x));
        CHECK(holds(bat_interval_sin(a), sin(x)) && holds(bat_interval_cos(a), cos(x)));
        CHECK(holds(bat_interval_of_rising(atan, a), atan(x)));
        const bat_interval c = {fabs(x), fabs(x) + 1};
        CHECK(holds(bat_interval_real_power(c, 0.3), pow(fabs(x) + 0.5, 0.3)));
        CHECK(holds(bat_interval_real_power(c, -1.7), pow(fabs(x) + 0.5, -1.7)));
    }
}

TEST(whole_numbers_and_zero_stay_exact)
{
    const bat_interval three = bat_interval_at(3), five = bat_interval_at(5);
    CHECK(bat_interval_width(bat_interval_multiply(three, five)) == 0);
    CHECK(bat_interval_width(bat_interval_add(three, five)) == 0);
    CHECK(bat_interval_width(bat_interval_power(three, 9)) == 0);
    const bat_interval none = bat_interval_multiply(bat_interval_at(0), BAT_EVERYTHING);
    CHECK(none.lo == 0 && none.hi == 0);
    const bat_interval third = bat_interval_divide(bat_interval_at(1), three);
    CHECK(third.lo < third.hi && bat_interval_width(third) < 4 * DBL_EPSILON);
}

TEST(even_powers_and_sines_are_tight_where_they_turn)
{
    const bat_interval a = {-2, 1};
    CHECK(bat_interval_power(a, 2).lo == 0 && bat_interval_power(a, 2).hi == 4);
    CHECK(bat_interval_power(a, 3).lo == -8 && bat_interval_power(a, 3).hi == 1);
    CHECK(bat_interval_sin((bat_interval){1, 2}).hi == 1);
    CHECK(bat_interval_sin((bat_interval){1, 1.5}).hi < 1);
    CHECK(bat_interval_sin((bat_interval){4, 5}).lo == -1);
    CHECK(bat_interval_cos((bat_interval){3, 4}).lo == -1);
    CHECK(bat_interval_cos((bat_interval){-1, 1}).hi == 1);
    CHECK(bat_interval_sin((bat_interval){0, 7}).lo == -1);
}

TEST(quotients_by_what_holds_zero_are_everything)
{
    const bat_interval q = bat_interval_divide(bat_interval_at(1), (bat_interval){-1, 2});
    CHECK(q.lo == -INFINITY && q.hi == INFINITY);
    CHECK(!bat_interval_is_finite(bat_interval_divide(bat_interval_at(0), BAT_EVERYTHING)));
}
