/* Fills that turn back over themselves without a crease. */
#include "shape/fill/fill.h"

#include "shape/fill/loops.h"

/* Straight sides round the corners of an L. @param rise  of every second corner */
static batten_status fill_l(double rise, batten_surface_fill_report *report)
{
    static const double ell[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    hole h;
    memset(&h, 0, sizeof h);
    for (int i = 0; i < 6; i++) {
        double points[2][3];
        for (int k = 0; k < 2; k++) {
            const int at = (i + k) % 6;
            points[k][0] = ell[at][0];
            points[k][1] = ell[at][1];
            points[k][2] = at % 2 ? rise : 0;
        }
        hole_add(&h, 1, points[0], 0, NULL);
    }
    const batten_status status = batten_surface_fill(6, h.ribbons, NULL, report, h.patches);
    hole_free(&h);
    return status;
}

TEST(surfaces_that_curl_over_a_re_entrant_corner_are_a_fold_flat_or_not)
{
    static const double rises[] = {0, 0.001, 0.1, 0.4};
    for (int i = 0; i < COUNT(rises); i++) {
        batten_surface_fill_report report;
        CHECK_STATUS(fill_l(rises[i], &report), BATTEN_TOLERANCE_NOT_MET);
        CHECK_MESSAGE("the fill folds over near");
        CHECK(report.folded);
    }
}

/* ---- plane patches ---- */

typedef struct {
    bat_fill_loop loop;
    batten_surface *patches[4];
} bench;

static batten_curve *line(const double from[3], const double to[3])
{
    static const double knots[] = {0, 0, 2, 2};
    const double points[] = {from[0], from[1], from[2], to[0], to[1], to[2]};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &curve));
    return curve;
}

/* Four corners round a hole; quad i is the square of side 1 from corner i on, seen from above unless it is the
 * one that is turned over. */
static void begin_bench(bench *b, double (*corners)[3], int turned)
{
    static const double knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    *b = (bench){.loop = {.count = 4}};
    for (int i = 0; i < 4; i++) {
        const double *p = corners[i];
        const double over[] = {p[0],     p[1], 0, p[0],     p[1] + 1, 0,
                               p[0] + 1, p[1], 0, p[0] + 1, p[1] + 1, 0};
        const double under[] = {p[0], p[1],     0, p[0] + 1, p[1],     0,
                                p[0], p[1] + 1, 0, p[0] + 1, p[1] + 1, 0};
        b->loop.sides[i].curve = line(p, corners[(i + 1) % 4]);
        CHECK_OK(batten_surface_create(3, &axis, &axis, i == turned ? under : over, NULL,
                                       &b->patches[i]));
    }
}

static void end_bench(bench *b)
{
    for (int i = 0; i < 4; i++) {
        batten_curve_unref(b->loop.sides[i].curve);
        batten_curve_unref(b->loop.sides[i].slope);
        batten_surface_unref(b->patches[i]);
    }
}

TEST(a_patch_that_is_turned_over_is_found_with_its_place)
{
    static double square[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (int turned = -1; turned < 4; turned++) {
        bench b;
        bool found = true;
        double at[3] = {7, 7, 7};
        begin_bench(&b, square, turned);
        CHECK_OK(bat_fill_find_overlap(&b.loop, b.patches, &found, at));
        CHECK(found == (turned >= 0));
        for (int c = 0; c < 3; c++)
            CHECK(at[c] == (turned < 0 ? 7 : square[turned][c]));
        end_bench(&b);
    }
}

TEST(holes_that_cross_themselves_or_go_round_nothing_have_no_side_to_be_seen_from)
{
    static double shapes[][4][3] = {
        {{0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}, {2, 3, 0}}, /* a bow, of uneven areas */
        {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {1, 0, 0}},
        {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {0.5, 0.5, 0}},
    };
    for (int i = 0; i < COUNT(shapes); i++) {
        bench b;
        bool found = true;
        double at[3];
        begin_bench(&b, shapes[i], 2);
        CHECK_OK(bat_fill_find_overlap(&b.loop, b.patches, &found, at));
        CHECK(found == (i == 2)); /* the last one is a hole like others */
        end_bench(&b);
    }
}

/* A ribbon whose plane has the cosine c to the hole's: below 0.3 it may bulge out. */
TEST(ribbons_that_stand_steep_leave_it_open_whether_a_fill_turns_over)
{
    static double square[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    static const struct {
        double cosine;
        bool found;
    } rows[] = {{0.31, true}, {0.29, false}, {1, true}, {-0.9, false}};
    for (int i = 0; i < COUNT(rows); i++)
        for (int end = 0; end < 2; end++) {
            const double c = rows[i].cosine, s = sqrt(1 - c * c), flat[] = {0, 1, 0},
                         steep[] = {0, c, s};
            bench b;
            bool found = false;
            double at[3];
            begin_bench(&b, square, 3);
            b.loop.sides[0].slope = line(end ? flat : steep, end ? steep : flat);
            CHECK_OK(bat_fill_find_overlap(&b.loop, b.patches, &found, at));
            CHECK(found == rows[i].found);
            end_bench(&b);
        }
}
