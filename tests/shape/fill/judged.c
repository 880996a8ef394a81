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

static const struct {
    double tolerance, angle;
    const char *message;
} refused[] = {
    {-1, 0.1, "the tolerance of a fill is 0 or more, not -1"},
    {INFINITY, 0.1, "the tolerance of a fill is 0 or more, not inf"},
    {NAN, 0.1, "the tolerance of a fill is 0 or more, not nan"},
    {0, 0, "the angle of a fill is above 0, not 0"},
    {0, INFINITY, "the angle of a fill is above 0, not inf"},
};

/* Three sides of a plane triangle. */
static void add_triangle(hole *h)
{
    static const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    memset(h, 0, sizeof *h);
    for (int i = 0; i < 3; i++)
        hole_add(h, 1, corners[i], 0, NULL);
}

TEST(bounds_of_fills_and_sheets_are_checked_with_their_numbers)
{
    hole h;
    batten_fill_sheet sheet = {0};
    add_triangle(&h);
    for (int i = 0; i < COUNT(refused); i++) {
        batten_surface_fill_options options = batten_surface_fill_defaults();
        batten_fill_sheet_options over = batten_fill_sheet_defaults();
        options.tolerance = over.tolerance = refused[i].tolerance;
        options.angle = over.angle = refused[i].angle;
        CHECK_STATUS(batten_surface_fill(3, h.ribbons, &options, NULL, h.patches),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(refused[i].message);
        CHECK_STATUS(batten_surface_fill_sheet(3, h.ribbons, &over, NULL, &sheet),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(refused[i].message);
    }
    CHECK(!h.patches[0]);
    hole_free(&h);
}

TEST(what_a_sheet_goes_through_lies_in_space)
{
    static const double flat[4] = {0.1, 0.1, 0.2, 0.1}, knots[4] = {0, 0, 1, 1};
    hole h;
    batten_fill_sheet sheet = {0};
    batten_curve *inner[2] = {NULL, NULL};
    batten_fill_sheet_options options = batten_fill_sheet_defaults();
    add_triangle(&h);
    options.most_curvature = -0.5;
    CHECK_STATUS(batten_surface_fill_sheet(3, h.ribbons, &options, NULL, &sheet),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the difference of curvatures of a fill is 0 or more, not -0.5");
    options.most_curvature = 0;
    options.points = (batten_points){2, 2, flat};
    CHECK_STATUS(batten_surface_fill_sheet(3, h.ribbons, &options, NULL, &sheet),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("points inside a fill have dimension 3, these have 2");
    options.points = (batten_points){0};
    CHECK_OK(batten_curve_create((batten_points){2, 2, flat}, 1, NULL, knots, &inner[1]));
    CHECK_OK(batten_curve_to_dimension(inner[1], 3, &inner[0]));
    options.curves = (batten_curve_row){2, (const batten_curve *const *)inner};
    CHECK_STATUS(batten_surface_fill_sheet(3, h.ribbons, &options, NULL, &sheet),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("inner curve 2 has dimension 2: what a fill goes through lies in space");
    batten_curve_unref(inner[0]);
    batten_curve_unref(inner[1]);
    hole_free(&h);
}

TEST(holes_of_one_point_and_without_area_are_refused)
{
    static const double nothing[2][3] = {{1, 2, 3}, {1, 2, 3}};
    static const double there[2][3] = {{0, 0, 0}, {1, 0, 0}},
                        back[2][3] = {{1, 0, 0}, {0, 0, 0}};
    hole h;
    batten_fill_sheet sheet = {0};
    memset(&h, 0, sizeof h);
    for (int i = 0; i < 3; i++)
        hole_add(&h, 1, nothing[0], 0, NULL);
    CHECK_STATUS(batten_surface_fill(3, h.ribbons, NULL, NULL, h.patches), BATTEN_COINCIDENT);
    CHECK_MESSAGE("all sides of the hole are one point");
    CHECK_STATUS(batten_surface_fill_sheet(3, h.ribbons, NULL, NULL, &sheet),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("curve 1 has no length");
    hole_free(&h);
    memset(&h, 0, sizeof h);
    hole_add(&h, 1, there[0], 0, NULL);
    hole_add(&h, 1, back[0], 0, NULL);
    CHECK_STATUS(batten_surface_fill_sheet(2, h.ribbons, NULL, NULL, &sheet),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the sides go around no area: a sheet needs a hole that can be seen from one "
                  "side");
    hole_free(&h);
}
