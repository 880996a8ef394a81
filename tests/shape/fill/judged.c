/* Fills that are not good enough to be given. */
#include "shape/fill/loops.h"

enum { SIDES = 5 };

/* Straight sides with flat strips around that twist against each other at the corners: along
 * a strip its other side is given. With curvature, that of the ruled strips: none across. */
static void add_twisted_strips(hole *h, batten_curve *bends[SIDES])
{
    static const double corners[SIDES][3] = {{1.2, 0, 0.3},
                                             {0.309, 0.951, 0},
                                             {-0.89, 0.647, 0.4},
                                             {-0.971, -0.705, 0.1},
                                             {0.309, -0.951, -0.1}};
    static const double out[SIDES][2][3] = {
        {{1.7346, 0.5706, 0.54}, {1.0284, 1.1334, -0.24}},
        {{-0.2256, 1.5216, -0.18}, {-0.8414, 1.4582, 0.58}},
        {{-1.6094, 0.4646, 0.64}, {-1.739, -0.5574, 0.22}},
        {{-1.0196, -1.5162, -0.08}, {-0.2256, -1.5216, -0.34}},
        {{1.077, -1.0986, -0.22}, {1.7346, -0.5706, 0.48}}};
    const double none[2][3] = {{0}}, ends[2] = {0, 1};
    memset(h, 0, sizeof *h);
    for (int i = 0; i < SIDES; i++) {
        double side[2][3], slope[2][3];
        for (int e = 0; e < 2; e++)
            for (int c = 0; c < 3; c++) {
                side[e][c] = corners[(i + e) % SIDES][c];
                slope[e][c] = side[e][c] - out[i][e][c];
            }
        hole_add(h, 1, side[0], 1, slope[0]);
        CHECK_OK(
            batten_curve_from_bezier(3, (batten_pieces){1, 1, ends}, none[0], NULL, &bends[i]));
        h->ribbons[i].curvature = bends[i];
    }
}

TEST(G7_curvatures_around_that_contradict_each_other_are_refused_with_numbers)
{
    hole h;
    batten_curve *bends[SIDES] = {NULL};
    batten_surface_fill_options options = batten_surface_fill_defaults();
    add_twisted_strips(&h, bends);
    CHECK_OK(batten_surface_fill(SIDES, h.ribbons, &options, &h.report, h.patches));
    CHECK(!h.report.folded);
    hole_free_patches(&h);
    options.curvature = true;
    CHECK_STATUS(batten_surface_fill(SIDES, h.ribbons, &options, &h.report, h.patches),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("with curvature taken over");
    CHECK_MESSAGE("continuity G1 does better");
    for (int i = 0; i < BATTEN_FILL_SIDES; i++)
        CHECK(h.patches[i] == NULL);
    /* The report says what was found; the strips bend by 0.87 at most, the loop's size is
     * 1.0855: half of its extent in x. */
    CHECK_INT(h.report.count, SIDES);
    CHECK_NEAR(h.report.rim_curvature, 0.866, 0.002);
    CHECK_NEAR(h.report.most_curvature, 1 / 1.0855, 1e-9);
    double largest = 0;
    for (int i = 0; i < SIDES; i++)
        largest = fmax(largest, h.report.inner[i].curvature);
    CHECK(largest > h.report.most_curvature);
    /* to fold is no excuse */
    options.may_fold = true;
    CHECK_STATUS(batten_surface_fill(SIDES, h.ribbons, &options, &h.report, h.patches),
                 BATTEN_TOLERANCE_NOT_MET);
    for (int i = 0; i < SIDES; i++)
        batten_curve_unref(bends[i]);
    hole_free(&h);
}

TEST(G7_a_fill_that_folds_over_is_refused_unless_it_may)
{
    /* A flat hole that goes in so far that its middle is outside. */
    static const double corners[4][3] = {{-4, -3, 0}, {0, 3, 0}, {4, -3, 0}, {0, 4, 0}};
    hole h = {0};
    batten_surface_fill_options options = batten_surface_fill_defaults();
    for (int i = 0; i < 4; i++) {
        double side[2][3];
        memcpy(side[0], corners[i], sizeof side[0]);
        memcpy(side[1], corners[(i + 1) % 4], sizeof side[1]);
        hole_add(&h, 1, side[0], 1, NULL);
    }
    CHECK_STATUS(batten_surface_fill(4, h.ribbons, &options, &h.report, h.patches),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("the fill folds over near (");
    CHECK(h.report.folded && h.patches[0] == NULL);
    CHECK(fabs(h.report.fold_at[0]) <= 4 && fabs(h.report.fold_at[1]) <= 4);
    options.may_fold = true;
    CHECK_OK(batten_surface_fill(4, h.ribbons, &options, &h.report, h.patches));
    CHECK(h.report.folded && h.patches[3] != NULL);
    hole_free(&h);
}
