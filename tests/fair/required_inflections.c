#include "fair/fairness.h"
#include "support/test.h"

enum { MOST = 400 };

static int required(int width, int count, const double *t, const double *points, double within)
{
    double bounds[MOST];
    int found = -1;
    for (int i = 0; i < count; i++)
        bounds[i] = within;
    CHECK_OK(
        bat_required_inflections(width, count, t, points, within > 0 ? bounds : NULL, &found));
    return found;
}

TEST(exact_data_require_the_sign_changes_of_their_second_differences)
{
    test_random random = test_random_begin("sign changes");
    for (int n = test_cases(100); n > 0; n--) {
        double t[50], y[50], last = 0;
        const int count = test_random_int(&random, 1, 50);
        int changes = 0;
        for (int i = 0; i < count; i++) {
            t[i] = i + 0.5 * test_random_unit(&random);
            y[i] = test_random_in(&random, -1, 1);
        }
        for (int i = 1; i + 1 < count; i++) {
            const double c =
                (y[i + 1] - y[i]) / (t[i + 1] - t[i]) - (y[i] - y[i - 1]) / (t[i] - t[i - 1]);
            changes += c * last < 0;
            last = c;
        }
        CHECK_INT(required(1, count, t, y, 0), changes);
    }
}

TEST(noise_below_the_bound_requires_nothing_and_a_wave_above_it_does)
{
    test_random random = test_random_begin("noise");
    double t[MOST], y[MOST], points[2 * MOST];
    for (int waves = 0; waves < 4; waves++) {
        for (int i = 0; i < MOST; i++) {
            t[i] = i / (double)MOST;
            /* waves half-periods: waves - 1 inflections inside; a parabola for none */
            y[i] = waves == 0 ? t[i] * t[i] : sin(3.14159265 * waves * t[i]);
            y[i] += 0.001 * test_random_in(&random, -1, 1);
            points[2 * i] = 5 * t[i] + 0.1 * y[i];
            points[2 * i + 1] = 0.3 * y[i]; /* slopes below 45 degrees */
        }
        const int inflections = waves > 1 ? waves - 1 : 0;
        CHECK_INT(required(1, MOST, t, y, 0.0011), inflections);
        CHECK_INT(required(2, MOST, t, points, 0.0011), inflections);
        CHECK(required(1, MOST, t, y, 0) > 50);
    }
}

TEST(a_curve_that_only_turns_left_requires_none_however_far_it_turns)
{
    double points[2 * 60], spiral[2 * 60];
    for (int i = 0; i < 60; i++) {
        const double angle = 0.3 * i; /* nearly three turns */
        points[2 * i] = (1 + i) * cos(angle);
        points[2 * i + 1] = (1 + i) * sin(angle);
        spiral[2 * i] = points[2 * i];
        spiral[2 * i + 1] = -points[2 * i + 1];
    }
    CHECK_INT(required(2, 60, NULL, points, 0), 0);
    CHECK_INT(required(2, 60, NULL, spiral, 0), 0);
    CHECK_INT(required(2, 60, NULL, points, 0.01), 0);
}

TEST(an_s_in_the_plane_requires_one_and_space_none)
{
    const double s[] = {0, 0, 1, 0.5, 2, 0.2, 3, -0.2, 4, -0.5, 5, 0};
    CHECK_INT(required(2, 6, NULL, s, 0), 1);
    CHECK_INT(required(2, 6, NULL, s, 1), 0);
    CHECK_INT(required(3, 4, NULL, s, 0), 0);
    CHECK_INT(required(2, 3, NULL, s, 0), 0);
}
