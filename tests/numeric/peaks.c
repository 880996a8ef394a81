#include "numeric/peaks.h"
#include "support/test.h"

#include <math.h>

typedef struct {
    double at[2], width;
    int looks;
} humps;

/* Two humps of different heights at different places, and a line that is largest at the end. */
static batten_status look_at_humps(void *context, double t, double *values)
{
    humps *h = context;
    const double x = (t - h->at[0]) / h->width, y = (t - h->at[1]) / h->width;
    h->looks++;
    values[0] = fmax(0, 2 - x * x);
    values[1] = fmax(1 - y * y, 3 - 40 * fabs(t - 0.25));
    values[2] = t;
    return BATTEN_OK;
}

TEST(peaks_between_samples_are_found_to_a_millionth_of_the_step)
{
    /* Midway between samples of 33, beside the ends, and on a sample. */
    static const double places[] = {0.5 + 1.0 / 64, 1e-9, 0.999, 0.5, 0.77};
    for (int i = 0; i < COUNT(places); i++) {
        humps h = {{places[i], 0.9}, 0.05, 0};
        double largest[3];
        CHECK_OK(bat_find_peaks(look_at_humps, &h, 33, 3, largest));
        CHECK_NEAR(largest[0], 2, 1e-11);
        CHECK_NEAR(largest[1], 3, 1e-5); /* a corner */
        CHECK_NEAR(largest[2], 1, 0);
        CHECK(h.looks < 200);
    }
}

static batten_status look_at_flat(void *context, double t, double *values)
{
    int *looks = context;
    ++*looks;
    values[0] = 5;
    values[1] = t == 0.5 ? HUGE_VAL : 1;
    values[2] = t == 1 ? NAN : t;
    return BATTEN_OK;
}

TEST(what_is_level_costs_no_more_and_what_has_no_bound_or_no_meaning_stays_so)
{
    int looks = 0;
    double largest[3];
    CHECK_OK(bat_find_peaks(look_at_flat, &looks, 3, 3, largest));
    CHECK(largest[0] == 5);
    CHECK(isinf(largest[1]));
    CHECK(isnan(largest[2]));
    CHECK_INT(looks, 3);
}

static batten_status fail_beyond(void *context, double t, double *values)
{
    const double *most = context;
    values[0] = t;
    return t > *most ? BATTEN_SINGULAR_HERE : BATTEN_OK;
}

TEST(a_look_that_fails_ends_the_search)
{
    const double most[] = {-1, 0.4, 0.99};
    for (int i = 0; i < COUNT(most); i++) {
        double bound = most[i], largest[1];
        CHECK_STATUS(bat_find_peaks(fail_beyond, &bound, 5, 1, largest), BATTEN_SINGULAR_HERE);
    }
}
