/* The plane of a hole and its sides in it. */
#include "shape/fill/sheet.h"

#include "shape/fill/loops.h"
#include "support/faults.h"

/* A rectangle of 4 x 2 about (3, 2, 2) in the plane y = 2, seen against y: the second side has two
 * spans and begins 0.02 beside the first one, the third runs against the loop. */
static void add_rectangle(hole *h, batten_curve **bend)
{
    static const double sides[4][2][3] = {{{1, 2, 1}, {5, 2, 1}},
                                          {{5, 2, 1.02}, {5, 2, 3}},
                                          {{1, 2, 3}, {5, 2, 3}},
                                          {{1, 2, 3}, {1, 2, 1}}};
    static const double slope[2][3] = {{0, 0, 3}, {0, 1, 3}},
                        second[2][3] = {{0, 0, 5}, {0, 1, 5}};
    static const double bent[3][3] = {{5, 2, 1.02}, {5, 2, 2}, {5, 2, 3}};
    static const double knots[5] = {2, 2, 4, 6, 6}, ends[2] = {0, 1};
    memset(h, 0, sizeof *h);
    for (int i = 0; i < 4; i++)
        hole_add(h, 1, sides[i][0], 1, i == 0 ? slope[0] : NULL);
    batten_curve_unref(h->curves[1]);
    h->curves[1] = NULL;
    CHECK_OK(
        batten_curve_create((batten_points){3, 3, bent[0]}, 1, NULL, knots, &h->curves[1]));
    h->ribbons[1].curve = h->curves[1];
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){1, 1, ends}, second[0], NULL, bend));
    h->ribbons[0].curvature = *bend;
}

static batten_status make_outline(const hole *h, double *gap, bat_sheet_outline *out)
{
    *gap = 0;
    const batten_status status = bat_sheet_outline_make(h->count, h->ribbons, 0.03, gap, out);
    if (status != BATTEN_OK)
        bat_sheet_outline_free(out);
    return status;
}

TEST(the_frame_of_a_hole_has_its_centre_its_normal_and_its_longest_side)
{
    static const double axes[3][3] = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, centre[3] = {3, 2, 2};
    hole h;
    batten_curve *bend = NULL;
    bat_sheet_outline outline = {0};
    double gap;
    add_rectangle(&h, &bend);
    CHECK_OK(make_outline(&h, &gap, &outline));
    CHECK_NEAR(gap, 0.02, 1e-15);
    CHECK_NEAR(outline.size, 2, 0);
    for (int r = 0; r < 3; r++) {
        CHECK_NEAR(outline.centre[r], centre[r], 0);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(outline.axes[r][c], axes[r][c], 1e-15);
    }
    const batten_affine to = bat_sheet_to_frame(&outline),
                        from = bat_sheet_from_frame(&outline);
    const batten_vec3 p = batten_affine_apply(to, (batten_vec3){4, 5, 7}),
                      q = batten_affine_apply(from, p);
    CHECK(fabs(p.x - 0.5) < 1e-15 && fabs(p.y - 2.5) < 1e-15 && fabs(p.z + 1.5) < 1e-15);
    CHECK(fabs(q.x - 4) < 1e-14 && fabs(q.y - 5) < 1e-14 && fabs(q.z - 7) < 1e-14);
    CHECK_NEAR(outline.low[0], -1, 1e-15);
    CHECK_NEAR(outline.low[1], -0.5, 1e-15);
    CHECK_NEAR(outline.high[0], 1, 1e-15);
    CHECK_NEAR(outline.high[1], 0.5, 1e-15);
    bat_sheet_outline_free(&outline);
    CHECK(outline.count == 0 && !outline.ring && !outline.plane[0]);
    batten_curve_unref(bend);
    hole_free(&h);
}

TEST(sides_stay_as_they_run_meet_halfway_and_are_followed_round_the_loop)
{
    /* every 24 places of the ring: the ends of all spans */
    static const double ring[5][2] = {{-1, -0.5}, {1, -0.495}, {1, 0}, {1, 0.5}, {-1, 0.5}};
    hole h;
    batten_curve *bend = NULL;
    bat_sheet_outline outline = {0};
    double gap, value[3];
    add_rectangle(&h, &bend);
    CHECK_OK(make_outline(&h, &gap, &outline));
    CHECK_INT(outline.count, 4);
    CHECK_INT(outline.ring_count, 120);
    for (int k = 0; k < 120; k++) {
        const double *a = ring[k / 24], *b = ring[(k / 24 + 1) % 5], part = k % 24 / 24.0;
        for (int c = 0; c < 2; c++)
            CHECK_NEAR(outline.ring[2 * k + c], (1 - part) * a[c] + part * b[c], 1e-14);
    }
    for (int i = 0; i < 4; i++) {
        const batten_interval domain = batten_curve_domain(outline.plane[i]);
        const double *start = ring[i == 0 ? 0 : i == 1 ? 1 : 4];
        CHECK_INT(outline.sides[i].given, i);
        CHECK_INT(outline.reversed[i], i == 2);
        CHECK_INT(batten_curve_dimension(outline.plane[i]), 2);
        CHECK_OK(batten_curve_evaluate(outline.plane[i], domain.a, 0, value));
        CHECK_NEAR(value[0], start[0], 1e-15);
        CHECK_NEAR(value[1], start[1], 1e-15);
        CHECK((outline.sides[i].slope != NULL) == (i == 0));
        CHECK((outline.sides[i].bend != NULL) == (i == 0));
    }
    /* (0, 1, 3) and (0, 1, 5) in the frame */
    CHECK_OK(batten_curve_evaluate(outline.sides[0].slope, 1, 0, value));
    CHECK(fabs(value[0]) < 1e-15 && fabs(value[1] - 1.5) < 1e-15 &&
          fabs(value[2] + 0.5) < 1e-15);
    CHECK_OK(batten_curve_evaluate(outline.sides[0].bend, 1, 0, value));
    CHECK(fabs(value[0]) < 1e-15 && fabs(value[1] - 2.5) < 1e-15 &&
          fabs(value[2] + 0.5) < 1e-15);
    bat_sheet_outline_free(&outline);
    batten_curve_unref(bend);
    hole_free(&h);
}

TEST(a_place_is_inside_where_the_ring_goes_round_it)
{
    double ring[6][2] = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    const bat_sheet_outline ell = {.ring = ring[0], .ring_count = 6};
    static const struct {
        double at[2];
        bool inside;
    } rows[] = {{{0.5, 0.5}, true},  {{3.9, 0.9}, true},  {{0.9, 2.9}, true},
                {{3.9, 1.1}, false}, {{1.1, 1.1}, false}, {{1.1, 2.9}, false},
                {{-0.1, 2}, false},  {{2, -0.1}, false},  {{4.1, 0.5}, false},
                {{0.5, 3.1}, false}, {{0.1, 0.1}, true},  {{-1, 0.5}, false}};
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_INT(bat_sheet_is_inside(&ell, rows[i].at), rows[i].inside);
    /* A slanted side: to the left of it at its height alone. */
    double slanted[3][2] = {{0, 0}, {4, 0}, {0, 2}};
    const bat_sheet_outline triangle = {.ring = slanted[0], .ring_count = 3};
    CHECK(bat_sheet_is_inside(&triangle, (double[2]){1.9, 1}));
    CHECK(!bat_sheet_is_inside(&triangle, (double[2]){2.1, 1}));
    CHECK(bat_sheet_is_inside(&triangle, (double[2]){0.9, 1.5}));
    CHECK(!bat_sheet_is_inside(&triangle, (double[2]){1.1, 1.5}));
}

static batten_status make_once(const hole *h)
{
    bat_sheet_outline outline = {0};
    double gap;
    const batten_status status = make_outline(h, &gap, &outline);
    if (status == BATTEN_OK) {
        CHECK_INT(outline.ring_count, 120);
        bat_sheet_outline_free(&outline);
    }
    return status;
}

TEST(an_outline_reports_every_lack_of_memory)
{
    hole h;
    batten_curve *bend = NULL;
    add_rectangle(&h, &bend);
    CHECK_ALL_ALLOCATIONS(make_once(&h));
    batten_curve_unref(bend);
    hole_free(&h);
}
