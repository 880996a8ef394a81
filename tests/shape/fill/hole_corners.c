/* Ribbons that contradict each other in corners, and corners of more than 180 degrees. */
#include "shape/fill/loops.h"

/* Straight sides round the corners [n][3], each with one slope all along [n][3]. */
static void straight_hole(int n, const double corners[][3], const double slopes[][3], hole *h)
{
    memset(h, 0, sizeof *h);
    for (int i = 0; i < n; i++) {
        double points[2][3], slope[2][3];
        memcpy(points[0], corners[i], sizeof points[0]);
        memcpy(points[1], corners[(i + 1) % n], sizeof points[1]);
        memcpy(slope[0], slopes[i], sizeof slope[0]);
        memcpy(slope[1], slopes[i], sizeof slope[1]);
        hole_add(h, 1, points[0], 1, slope[0]);
    }
}

static const double square[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
/* All but the first lie in the plane of the square. */
static const double tilted[4][3] = {{0, 1, 1}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};

static batten_surface_fill_options form_of(int form)
{
    batten_surface_fill_options options = batten_surface_fill_defaults();
    options.form = (batten_fill_form)form;
    return options;
}

TEST(G7_every_form_keeps_its_sides_where_ribbons_contradict_each_other_and_says_by_how_much)
{
    hole h;
    straight_hole(4, square, tilted, &h);
    for (int form = BATTEN_FILL_SPLIT; form <= BATTEN_FILL_CHARROT_GREGORY; form++) {
        const batten_surface_fill_options options = form_of(form);
        CHECK_OK(batten_surface_fill(4, h.ribbons, &options, &h.report, h.patches));
        CHECK_NEAR(h.report.corner_angle * TESTS_DEGREES, 45, 1e-9); /* z = 0 and z = y */
        CHECK(h.report.corner == 0 || h.report.corner == 1);
        for (int i = 0; i < 4; i++)
            CHECK_NEAR(h.report.outer[i].gap, 0, 1e-12);
        CHECK(h.report.outer[0].angle * TESTS_DEGREES > 30);
        CHECK_NEAR(hole_inner(&h).angle, 0, 1e-7);
        /* sides that contradict nobody keep their planes */
        CHECK_NEAR(h.report.outer[2].angle, 0, 1e-6);
        hole_free_patches(&h);
    }
    hole_free(&h);
}

TEST(contradicting_ribbons_that_mirror_each_other_make_fills_that_do)
{
    hole h;
    straight_hole(4, square, tilted, &h);
    for (int form = BATTEN_FILL_SPLIT; form <= BATTEN_FILL_CHARROT_GREGORY; form++) {
        const batten_surface_fill_options options = form_of(form);
        CHECK_OK(batten_surface_fill(4, h.ribbons, &options, &h.report, h.patches));
        for (int pair = 0; pair < 4; pair += 2)
            for (int k = 0; k < 121; k++) {
                const double u = k / 11 / 10.0, v = k % 11 / 10.0;
                double p[3], q[3];
                CHECK_OK(batten_surface_evaluate(h.patches[pair], u, v, 0, p));
                CHECK_OK(batten_surface_evaluate(h.patches[pair + 1], v, u, 0, q));
                CHECK_NEAR(p[0], 1 - q[0], 1e-9);
                CHECK_NEAR(p[1], q[1], 1e-9);
                CHECK_NEAR(p[2], q[2], 1e-9);
            }
        hole_free_patches(&h);
    }
    hole_free(&h);
}

static const double bracket[6][3] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                     {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
static const double inwards[6][3] = {{0, 1, 0},  {-1, 0, 0}, {0, -1, 0},
                                     {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};

TEST(G7_re_entrant_corners_with_ribbons_are_refused_by_name)
{
    hole h;
    straight_hole(6, bracket, inwards, &h);
    for (int form = BATTEN_FILL_SPLIT; form <= BATTEN_FILL_CHARROT_GREGORY; form++) {
        const batten_surface_fill_options options = form_of(form);
        CHECK_STATUS(batten_surface_fill(6, h.ribbons, &options, NULL, h.patches),
                     BATTEN_NOT_COMPATIBLE);
        CHECK_MESSAGE("the corner between curves 3 and 4 is re-entrant");
    }
    h.ribbons[2].slope = NULL; /* one ribbon at the corner */
    CHECK_STATUS(batten_surface_fill(6, h.ribbons, NULL, NULL, h.patches),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the corner between curves 3 and 4 is re-entrant");
    hole_free(&h);
}

TEST(G7_ribbons_that_point_out_are_told_from_re_entrant_corners)
{
    double slopes[4][3];
    for (int which = 1; which <= 15; which++) { /* the ribbons that point out, as bits */
        hole h;
        memcpy(slopes, tilted, sizeof slopes);
        slopes[0][2] = 0;
        for (int i = 0; i < 4; i++)
            for (int c = 0; c < 2 && (which >> i & 1); c++)
                slopes[i][c] = -slopes[i][c];
        straight_hole(4, square, (const double(*)[3])slopes, &h);
        for (int form = BATTEN_FILL_SPLIT; form <= BATTEN_FILL_CHARROT_GREGORY; form++) {
            const batten_surface_fill_options options = form_of(form);
            CHECK_STATUS(batten_surface_fill(4, h.ribbons, &options, NULL, h.patches),
                         BATTEN_NOT_COMPATIBLE);
            CHECK_MESSAGE("points out of the hole");
        }
        for (int i = 0; i < 4; i++) /* alone among sides without */
            if (which != 1 << i)
                h.ribbons[i].slope = NULL;
        if (which == 1 || which == 2 || which == 4 || which == 8) {
            CHECK_STATUS(batten_surface_fill(4, h.ribbons, NULL, NULL, h.patches),
                         BATTEN_NOT_COMPATIBLE);
            CHECK_MESSAGE("points out of the hole");
        }
        hole_free(&h);
    }
}

TEST(G7_fills_that_leave_a_side_against_its_ribbon_are_folds)
{
    hole h;
    double slopes[4][3];
    memcpy(slopes, tilted, sizeof slopes);
    slopes[0][1] = -0.08; /* upright, and a little out of the hole */
    straight_hole(4, square, (const double(*)[3])slopes, &h);
    for (int form = BATTEN_FILL_SPLIT; form <= BATTEN_FILL_CHARROT_GREGORY; form++) {
        const batten_surface_fill_options options = form_of(form);
        CHECK_STATUS(batten_surface_fill(4, h.ribbons, &options, &h.report, h.patches),
                     BATTEN_TOLERANCE_NOT_MET);
        CHECK_MESSAGE("folds over");
        CHECK_NEAR(h.report.fold_at[1], 0, 0.3);
    }
    hole_free(&h);
}

TEST(one_ribbon_and_the_side_beside_it_contradict_each_other_too)
{
    hole h;
    straight_hole(4, square, tilted, &h);
    for (int i = 1; i < 4; i++)
        h.ribbons[i].slope = NULL;
    for (int form = BATTEN_FILL_SPLIT; form <= BATTEN_FILL_CHARROT_GREGORY; form++) {
        const batten_surface_fill_options options = form_of(form);
        CHECK_OK(batten_surface_fill(4, h.ribbons, &options, &h.report, h.patches));
        CHECK_NEAR(h.report.corner_angle * TESTS_DEGREES, 45, 1e-9);
        for (int i = 0; i < 4; i++)
            CHECK_NEAR(h.report.outer[i].gap, 0, 1e-12);
        hole_free_patches(&h);
    }
    hole_free(&h);
}
