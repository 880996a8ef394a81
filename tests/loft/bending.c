#include "loft/bending.h"

#include "support/test.h"

#include <math.h>

enum { NU = 6, NV = 5, COORDINATES = 3 * NU * NV };

static const double inner[] = {0.3, 0.6};

/* A curved patch: y = x^2 - z^2 / 2 + x z and waves. */
static void make_patch(test_random *random, bat_loft_patch *out)
{
    double u[NU + 4], v[NV + 4];
    bat_loft_knots(2, inner, u);
    bat_loft_knots(1, inner, v);
    CHECK_OK(bat_loft_patch_make(NU, u, NV, v, out));
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++) {
            double *p = out->points + 3 * (i * NV + j);
            p[0] = i + test_random_in(random, -0.1, 0.1);
            p[2] = j + test_random_in(random, -0.1, 0.1);
            p[1] = 0.2 * (p[0] * p[0] - p[2] * p[2] / 2 + p[0] * p[2]) +
                   test_random_in(random, -0.2, 0.2);
        }
}

/* n . (a^2 S_uu + 2 a b S_uv + b^2 S_vv) at a place, the direction as it was measured; of an edge
 * what it bends by. */
static double bending_along(const bat_loft_patch *patch, const bat_loft_place *was,
                            const bat_loft_cut *cut, const bat_loft_measure *measure)
{
    bat_loft_place at;
    bat_loft_measure other;
    double n[3], sum = 0;
    bat_loft_place_at(patch, was->u, was->v, &at);
    if (bat_cut_is_edge(cut))
        return bat_loft_bending(&at, cut, &other);
    bat_loft_normal(&at, n);
    for (int c = 0; c < 3; c++)
        sum += n[c] *
               (measure->weight[2][0] * at.s[2][0][c] + measure->weight[1][1] * at.s[1][1][c] +
                measure->weight[0][2] * at.s[0][2][c]);
    return sum;
}

/* What the measure says of a move of coordinate c of the control point a, b of the place. */
static double entry(const bat_loft_place *at, const bat_loft_measure *measure, int a, int b,
                    int c)
{
    double sum = 0;
    for (int du = 0; du <= 2; du++)
        for (int dv = 0; dv <= 2 - du; dv++)
            sum += measure->weight[du][dv] * at->along_u[du][a] * at->along_v[dv][b];
    return sum * measure->vector[c];
}

TEST(the_variation_of_bending_is_that_of_differences)
{
    static const bat_loft_cut cuts[] = {
        {BAT_CUT_STATION, {1, 0, 0}, 0, 0, 0, false, false},
        {BAT_CUT_WATERLINE, {0, 0, 1}, 0, 0, 0, false, false},
        {BAT_CUT_DIAGONAL, {0, 0.6, 0.8}, 0, 0, 0, false, false},
        {BAT_CUT_PROFILE, {0, 1, 0}, 0, 0, 0, false, false},
        {BAT_CUT_SHEER, {0, 0, 1}, 0, 0, 0, false, false}};
    static const double height[] = {0.4, 0.7, 0.2, 0, 1}; /* v of each */
    test_random random = test_random_begin("bending");
    const double h = 1e-5;
    for (int t = 0; t < test_cases(60); t++) {
        const bat_loft_cut *cut = cuts + t % 5;
        const int a = t % 4, b = t / 4 % 4, c = t % 3;
        bat_loft_patch patch;
        bat_loft_place at;
        bat_loft_measure measure;
        make_patch(&random, &patch);
        bat_loft_place_at(&patch, test_random_in(&random, 0.1, 0.9), height[t % 5], &at);
        CHECK(fabs(bat_loft_bending(&at, cut, &measure)) > 0);
        double *moved = patch.points + 3 * ((at.i + a) * NV + at.j + b) + c;
        const double middle = *moved;
        *moved = middle + h;
        const double high = bending_along(&patch, &at, cut, &measure);
        *moved = middle - h;
        const double low = bending_along(&patch, &at, cut, &measure);
        CHECK_NEAR((high - low) / (2 * h), entry(&at, &measure, a, b, c), 1e-5);
        bat_loft_patch_free(&patch);
    }
}

/* The value is the curvature of the cut in the normal: of a hundredth of the size it is the hundredfold. */
TEST(a_cut_of_a_patch_of_a_hundredth_of_the_size_bends_a_hundred_times_as_much)
{
    static const bat_loft_cut station = {BAT_CUT_STATION, {1, 0, 0}, 0, 0, 0, false, false};
    test_random random = test_random_begin("small bending");
    double bend[2];
    bat_loft_patch patch;
    bat_loft_place at;
    bat_loft_measure measure;
    make_patch(&random, &patch);
    for (int small = 0; small < 2; small++) {
        for (int k = 0; small && k < COORDINATES; k++)
            patch.points[k] *= 0.01;
        bat_loft_place_at(&patch, 0.4, 0.4, &at);
        bend[small] = bat_loft_bending(&at, &station, &measure);
    }
    CHECK(fabs(bend[0]) > 0);
    CHECK_NEAR(bend[1], 100 * bend[0], 1e-9 * fabs(bend[1]));
    bat_loft_patch_free(&patch);
}
