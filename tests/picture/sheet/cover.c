#include "picture/sheet/cover.h"

#include "support/test.h"

static const double sheet[4] = {0, 0, 200, 100};

/* The distance of a segment from a box, by its points. */
static double distance(const double a[2], const double b[2], const double box[4])
{
    double least = HUGE_VAL;
    for (int i = 0; i <= 2000; i++) {
        const double t = i / 2000.0, x = a[0] + t * (b[0] - a[0]), y = a[1] + t * (b[1] - a[1]);
        const double off_x = fmax(0, fmax(box[0] - x, x - box[2]));
        const double off_y = fmax(0, fmax(box[1] - y, y - box[3]));
        least = fmin(least, hypot(off_x, off_y));
    }
    return least;
}

TEST(a_box_is_free_where_no_segment_is_near)
{
    test_random random = test_random_begin("cover");
    for (int i = 0; i < test_cases(300); i++) {
        bat_cover cover;
        CHECK_OK(bat_cover_make(200, 100, 2, &cover));
        double a[2], b[2], box[4];
        for (int k = 0; k < 2; k++) {
            a[k] = test_random_in(&random, -50, 250), b[k] = test_random_in(&random, -50, 250);
            box[k] = test_random_in(&random, 5, 70),
            box[k + 2] = box[k] + test_random_in(&random, 1, 25);
        }
        bat_cover_segment(&cover, a, b, 0.5, sheet);
        const double far = distance(a, b, box);
        if (far < 0.5)
            CHECK(!bat_cover_is_free(&cover, box));
        if (far > 0.5 + 2.6 * 1.5)
            CHECK(bat_cover_is_free(&cover, box));
        bat_cover_free(&cover);
    }
}

TEST(what_is_not_finite_or_far_away_covers_nothing)
{
    bat_cover cover;
    CHECK_OK(bat_cover_make(200, 100, 2, &cover));
    const double far[2] = {1e300, 1e300}, farther[2] = {2e300, 1e300}, lost[2] = {NAN, 0};
    bat_cover_segment(&cover, far, farther, 1, sheet);
    bat_cover_segment(&cover, far, lost, 1, sheet);
    CHECK(bat_cover_is_free(&cover, sheet));
    bat_cover_free(&cover);
}
