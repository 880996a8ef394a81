#include <batten/approximate.h>

#include "shape/published.h"

/* The distance from a segment. */
static double away(int d, const double *a, const double *b, const double *q)
{
    double length2 = 0, s = 0, sum = 0;
    for (int k = 0; k < d; k++) {
        length2 += (b[k] - a[k]) * (b[k] - a[k]);
        s += (b[k] - a[k]) * (q[k] - a[k]);
    }
    s = length2 > 0 ? fmax(0, fmin(1, s / length2)) : 0;
    for (int k = 0; k < d; k++)
        sum += pow(q[k] - a[k] - s * (b[k] - a[k]), 2);
    return sqrt(sum);
}

/* Every point that went is within the tolerance of its own chord; how many stay. */
static int check_thin(int d, int n, const double *q, double tolerance, bool closed)
{
    int *kept = test_array((size_t)n, sizeof *kept), count = -1;
    batten_points_thin_report report;
    double largest = 0;
    CHECK_OK(
        batten_points_thin((batten_points){d, n, q}, tolerance, closed, &report, kept, &count));
    CHECK(count >= 1);
    CHECK(closed || (kept[0] == 0 && kept[count - 1] == n - 1));
    for (int j = 0; j < count - !closed; j++) {
        const int to = j + 1 < count ? kept[j + 1] : kept[0] + n;
        CHECK(to > kept[j]);
        for (int i = kept[j] + 1; i < to; i++)
            largest =
                fmax(largest, away(d, q + d * kept[j], q + d * (to % n), q + d * (i % n)));
    }
    CHECK(largest <= tolerance * (1 + 1e-12) + 1e-12);
    CHECK_NEAR(report.error, largest, 1e-13);
    CHECK(report.rms <= report.error);
    return count;
}

TEST(random_rows_keep_the_bound_in_plane_and_space_open_and_closed)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(100); c++) {
        const int d = 2 + c % 2, n = 1 + test_random_int(&random, 0, 200);
        double q[3 * 201];
        for (int i = 0; i < n * d; i++)
            q[i] = (i >= d ? q[i - d] : 0) + test_random_in(&random, -1, 1);
        int before = n;
        for (double tolerance = 0.001; tolerance < 10; tolerance *= 4) {
            const int count = check_thin(d, n, q, tolerance, c % 4 > 1);
            CHECK(count <= before); /* what a wider bound keeps, a narrower one keeps */
            before = count;
        }
    }
}

TEST(a_polygon_sampled_gives_its_corners_back)
{
    static const double corners[5][2] = {{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 3}};
    for (int closed = 0; closed < 2; closed++) {
        double q[2 * 200];
        int n = 0, kept[200], count = -1;
        for (int e = 0; e < 4 + closed; e++)
            for (int i = 0; i < 20; i++, n++)
                for (int k = 0; k < 2; k++)
                    q[2 * n + k] =
                        corners[e][k] + i / 20.0 * (corners[(e + 1) % 5][k] - corners[e][k]);
        if (!closed) {
            memcpy(q + 2 * n, corners[4], sizeof corners[4]);
            n++;
        }
        CHECK_OK(batten_points_thin((batten_points){2, n, q}, 0, closed, NULL, kept, &count));
        CHECK_INT(count, 5);
        for (int e = 0; e < 5; e++)
            CHECK_INT(kept[e], 20 * e);
    }
}

TEST(G10_a_reversed_row_keeps_as_close_a_bound)
{
    double q[2 * 300], back[2 * 300];
    for (int i = 0; i < 300; i++) {
        q[2 * i] = i / 50.0;
        q[2 * i + 1] = sin(i / 50.0);
    }
    for (int i = 0; i < 300; i++)
        memcpy(back + 2 * i, q + 2 * (299 - i), 2 * sizeof *q);
    const int forth = check_thin(2, 300, q, 1e-3, false);
    CHECK_INT(check_thin(2, 300, back, 1e-3, false), forth);
    /* The chord of an arc of radius r over length l is off by l^2 / 8 r at most. */
    CHECK(forth <= 2 + 6 / sqrt(8 * 1e-3));
}

TEST(S3_rows_that_split_badly_end_as_soon_as_others)
{
    /* Each point is farthest from the chord of all after it: splitting alone would look at 1.25e9
     * points. */
    const int n = 50000;
    double *q = test_array((size_t)n, 2 * sizeof *q);
    for (int i = 0; i < n; i++) {
        q[2 * i] = (i % 2 ? 1 : -1) * (double)(n - i);
        q[2 * i + 1] = 0;
    }
    const int count = check_thin(2, n, q, 0.5, false);
    CHECK(count >= n - 2);
}

TEST(few_and_coincident_points)
{
    const double q[] = {1, 2, 1, 2, 1, 2, 3, 4};
    int kept[4], count = -1;
    batten_points_thin_report report;
    for (int closed = 0; closed < 2; closed++) {
        CHECK_OK(
            batten_points_thin((batten_points){2, 1, q}, 0, closed, &report, kept, &count));
        CHECK_INT(count, 1);
        CHECK_OK(
            batten_points_thin((batten_points){2, 2, q}, 0, closed, &report, kept, &count));
        CHECK_INT(count, 2);
        CHECK_OK(
            batten_points_thin((batten_points){2, 3, q}, 0, closed, &report, kept, &count));
        CHECK_INT(count, 2);
        CHECK_OK(
            batten_points_thin((batten_points){2, 4, q}, 0, closed, &report, kept, &count));
        CHECK_INT(count, 2);
        CHECK_NEAR(report.error, 0, 0);
    }
}

TEST(N1_N6_bad_points_and_tolerances_are_refused)
{
    const double q[] = {0, 0, 1, NAN, 2, 2}, large[] = {0, 0, 1e300, 1};
    int kept[3], count = -1;
    CHECK_STATUS(batten_points_thin((batten_points){2, 3, q}, 1, false, NULL, kept, &count),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 2");
    CHECK_STATUS(batten_points_thin((batten_points){2, 1, q}, -1, false, NULL, kept, &count),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_points_thin((batten_points){2, 1, q}, NAN, false, NULL, kept, &count),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_points_thin((batten_points){1, 1, q}, 1, false, NULL, kept, &count),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_points_thin((batten_points){2, 0, q}, 1, false, NULL, kept, &count),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_points_thin((batten_points){2, 2, large}, 1, false, NULL, kept, &count),
                 BATTEN_OVERFLOW);
    CHECK_INT(count, -1);
    CHECK_OK(batten_points_thin((batten_points){2, 1, q}, HUGE_VAL, false, NULL, kept, &count));
}

TEST(published_contours_thin_to_a_fraction)
{
    double *table = test_array(4 * 5000, sizeof *table), *q = test_array(3 * 5000, sizeof *q);
    const int n = published_table("contours/heart_contours.csv", 4, 5000, table);
    int all = 0, kept = 0;
    for (int i = 0; i < n;) {
        int m = 0;
        for (const double contour = table[4 * i]; i < n && table[4 * i] == contour; i++, m++)
            memcpy(q + 3 * m, table + 4 * i + 1, 3 * sizeof *q);
        all += m;
        kept += check_thin(3, m, q, 1, true);
    }
    CHECK_INT(all, 4732);
    CHECK(kept <= all / 2);
}
