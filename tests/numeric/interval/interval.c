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

/* What a function of one interval is, against its values at many places, the ends among them: so
 * much wider may it be. */
static void check_tight(bat_interval made, double (*f)(double), bat_interval a, double spare)
{
    enum { PLACES = 2000 };
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int k = 0; k <= PLACES; k++) {
        const double value = f(fmin(a.lo + (a.hi - a.lo) * k / PLACES, a.hi));
        low = fmin(low, value);
        high = fmax(high, value);
    }
    CHECK(made.lo <= low && high <= made.hi);
    CHECK_NEAR(made.lo, low, spare);
    CHECK_NEAR(made.hi, high, spare);
}

static double cube(double x)
{
    return x * x * x;
}

static double fourth(double x)
{
    return cube(x) * x;
}

TEST(functions_of_an_interval_are_no_wider_than_their_values)
{
    static const bat_interval rows[] = {
        {0, 0}, {0, 0.5}, {-0.5, 0},  {0, 3},     {-3, 0},   {-1, 1}, {1, 2},
        {4, 5}, {2, 8},   {-9, 0.25}, {0.5, 6.5}, {-2, 0.1}, {-1, 2}, {1e-3, 2e-3}};
    for (int i = 0; i < COUNT(rows); i++) {
        /* chords of 2000 places miss a turn by (width / 2000)^2 of the second derivative */
        const bat_interval a = rows[i];
        check_tight(bat_interval_sin(a), sin, a, 2e-5);
        check_tight(bat_interval_cos(a), cos, a, 2e-5);
        check_tight(bat_interval_of_rising(atan, a), atan, a, 1e-14);
        check_tight(bat_interval_power(a, 3), cube, a, 1e-12);
        check_tight(bat_interval_power(a, 4), fourth, a, 1e-9);
    }
    for (int side = 0; side < 2; side++) { /* infinite, or a whole turn: all values */
        const bat_interval whole = side ? (bat_interval){-1, HUGE_VAL} : (bat_interval){1, 7.3};
        CHECK(bat_interval_sin(whole).lo == -1 && bat_interval_sin(whole).hi == 1);
        CHECK(bat_interval_cos(whole).lo == -1 && bat_interval_cos(whole).hi == 1);
    }
}

TEST(real_powers_rise_fall_and_begin_at_zero)
{
    const bat_interval zero = bat_interval_real_power((bat_interval){0, 0}, 0.5);
    CHECK(zero.lo == 0 && zero.hi == 0);
    const bat_interval root = bat_interval_real_power((bat_interval){0, 4}, 0.5);
    CHECK(root.lo == 0 && root.hi >= 2);
    CHECK_NEAR(root.hi, 2, 1e-14);
    const bat_interval inverse = bat_interval_real_power((bat_interval){0.25, 4}, -0.5);
    CHECK(inverse.lo <= 0.5 && inverse.hi >= 2);
    CHECK_NEAR(inverse.lo, 0.5, 1e-14);
    CHECK_NEAR(inverse.hi, 2, 1e-14);
    CHECK(bat_interval_power((bat_interval){-2, 3}, 0).lo == 1);
    CHECK(bat_interval_power((bat_interval){-2, 3}, 0).hi == 1);
}
