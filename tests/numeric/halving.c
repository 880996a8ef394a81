/* Intervals that are halved until their pieces are good. */
#include "numeric/halving.h"
#include "support/test.h"

TEST(pieces_of_a_halved_interval_follow_one_another_and_are_the_largest_good_ones)
{
    /* A piece is good when it is no longer than its distance from 0, or 1/64. */
    bat_halving h = bat_halving_of(0, 1, 10);
    double end = 0;
    int count = 0;
    while (h.waiting > 0) {
        const double length = h.b - h.a;
        if (length > 1.0 / 64 && length > h.a) {
            CHECK(bat_halving_split(&h));
            continue;
        }
        CHECK_NEAR(h.a, end, 0);
        end = h.b;
        count++;
        bat_halving_accept(&h);
    }
    CHECK_NEAR(end, 1, 0);
    CHECK_INT(count, 7); /* 1/64, and 1/64, 1/32 ... 1/2 */
}

TEST(a_piece_is_halved_as_often_as_was_allowed_at_either_end)
{
    for (int right = 0; right < 2; right++) {
        bat_halving h = bat_halving_of(0, 1, 7);
        int splits = 0;
        for (; h.waiting > 0; bat_halving_accept(&h))
            while ((!right || h.b == 1) && bat_halving_split(&h))
                splits++;
        CHECK_INT(splits, right ? 7 : 127);
    }
}

TEST(an_interval_without_a_number_between_its_ends_is_not_halved)
{
    bat_halving h = bat_halving_of(1, nextafter(1, 2), 40);
    CHECK(!bat_halving_split(&h));
    CHECK_INT(h.waiting, 1);
}

/* The largest |w L| over [0, 1] with L = cos a + 2 sin a (t - 1/2), by its largest of n samples. */
static double excess(int m, int n, double a)
{
    double anywhere = 0, sampled = 0;
    for (int i = 0; i <= 800; i++) {
        const double t = i / 800.0;
        const double e = fabs(pow(4 * t * (1 - t), m) * (cos(a) + 2 * sin(a) * (t - 0.5)));
        anywhere = fmax(anywhere, e);
        if (i % (800 / (n + 1)) == 0)
            sampled = fmax(sampled, e);
    }
    return anywhere / sampled;
}

static double largest_excess(int m, int n)
{
    double worst = 0;
    for (int i = 0; i < 20000; i++)
        worst = fmax(worst, excess(m, n, i * (3.14159265358979 / 20000)));
    return worst;
}

TEST(an_error_with_a_linear_factor_exceeds_its_samples_by_the_factor_and_no_more)
{
    const double cubic = largest_excess(2, 3), quintic = largest_excess(3, 7);
    CHECK(cubic <= BAT_CUBIC_BETWEEN_3 && cubic > BAT_CUBIC_BETWEEN_3 - 1e-3);
    CHECK(quintic <= BAT_QUINTIC_BETWEEN_7 && quintic > BAT_QUINTIC_BETWEEN_7 - 1e-3);
}

TEST(hermites_cubic_of_a_quintic_is_nowhere_farther_off_than_the_bound)
{
    test_random random = test_random_begin("hermite bound");
    for (int c = 0; c < 200; c++) {
        double a[6], worst = 0, sampled = 0;
        for (int k = 0; k < 6; k++)
            a[k] = test_random_in(&random, -1, 1);
        double f[2] = {a[0], 0}, g[2] = {0, 0};
        for (int k = 0; k < 6; k++) {
            f[1] += a[k];
            g[0] = a[1];
            g[1] += k * a[k];
        }
        for (int i = 0; i <= 100; i++) {
            const double t = i / 100.0, s = 1 - t;
            double value = 0;
            for (int k = 5; k >= 0; k--)
                value = value * t + a[k];
            const double cubic = f[0] * s * s * (1 + 2 * t) + g[0] * s * s * t +
                                 f[1] * t * t * (1 + 2 * s) - g[1] * t * t * s;
            const double off = fabs(cubic - value);
            worst = fmax(worst, off);
            if (i % 25 == 0)
                sampled = fmax(sampled, off);
        }
        CHECK(worst <= BAT_CUBIC_BETWEEN_3 * sampled + 1e-14);
    }
}
