#include "fair/sign_pattern.h"

#include "support/test.h"

#include <math.h>

/* The least sum of wrong curvature over all patterns with so many changes. */
static double least_wrong(int count, const double *curvature, int changes)
{
    double least = HUGE_VAL;
    for (int bits = 0; bits < 1 << count; bits++) {
        int turns = 0;
        double wrong = 0;
        for (int i = 0; i < count; i++) {
            const int sign = bits >> i & 1 ? 1 : -1;
            turns += i > 0 && (bits >> i & 1) != (bits >> (i - 1) & 1);
            wrong += fmax(-sign * curvature[i], 0);
        }
        if (turns <= changes)
            least = fmin(least, wrong);
    }
    return least;
}

TEST(patterns_of_signs_leave_the_least_wrong_curvature)
{
    test_random random = test_random_begin("pattern");
    for (int t = 0; t < test_cases(100); t++) {
        const int count = 1 + t % 10, changes = t % 4;
        double curvature[10], wrong = 0;
        int signs[10], turns = 0;
        for (int i = 0; i < count; i++)
            curvature[i] = test_random_in(&random, -1, 1);
        CHECK_OK(bat_sign_pattern(count, curvature, changes, signs));
        for (int i = 0; i < count; i++) {
            turns += i > 0 && signs[i] != signs[i - 1];
            wrong += fmax(-signs[i] * curvature[i], 0);
        }
        CHECK(turns <= changes);
        CHECK_NEAR(wrong, least_wrong(count, curvature, changes), 1e-12);
    }
}
