/* Where two pieces of curves cross: their boxes and cones, halves, and what neighbours share. */
#include "inspect/nearest/pair_crossings.h"
#include "support/test.h"

static bat_crossing_piece piece_of(int curve, int degree, const double (*points)[2],
                                   const double *weights, double a, double b)
{
    bat_crossing_piece p = {.curve = curve, .degree = degree, .a = a, .b = b};
    for (int i = 0; i <= degree; i++) {
        const double w = weights ? weights[i] : 1;
        p.rows[3 * i] = w * points[i][0];
        p.rows[3 * i + 1] = w * points[i][1];
        p.rows[3 * i + 2] = w;
    }
    bat_crossing_piece_measure(&p);
    return p;
}

/* Polygons with the cosine of the widest angle between a leg and the chord. */
static const struct {
    int degree;
    double points[4][2], low[2], high[2], cosine;
} polygons[] = {
    {3, {{0, 0}, {1, 1}, {3, 1}, {4, 0}}, {0, 0}, {4, 1}, 0.7071067811865476},
    {3, {{0, 0}, {0, 2}, {3, 2}, {3, 4}}, {0, 0}, {3, 4}, 0.6},
    {3, {{4, 0}, {3, -1}, {1, -1}, {0, 0}}, {0, -1}, {4, 0}, 0.7071067811865476},
    {1, {{1, 2}, {-3, 5}}, {-3, 2}, {1, 5}, 1},
    {2, {{0, 0}, {2, 0}, {1, 0}}, {0, 0}, {2, 0}, -1}, /* a leg runs back */
    {2, {{0, 0}, {2, 1}, {0, 0}}, {0, 0}, {2, 1}, -1}, /* no chord */
    {2, {{3, 4}, {3, 4}, {3, 4}}, {3, 4}, {3, 4}, 1},  /* a point */
    {2, {{0, 0}, {0, 0}, {1, 1}}, {0, 0}, {1, 1}, 1},  /* a leg without length */
    {2, {{0, 0}, {3e-200, 0}, {3e-200, 4e-200}}, {0, 0}, {3e-200, 4e-200}, 0.6},
};

TEST(a_piece_has_the_box_and_the_cone_of_its_polygon)
{
    static const double heavy[4] = {2, 0.5, 4, 1};
    for (int i = 0; i < 2 * COUNT(polygons); i++) {
        const bat_crossing_piece p = piece_of(0, polygons[i / 2].degree, polygons[i / 2].points,
                                              i % 2 ? heavy : NULL, 0, 1);
        for (int k = 0; k < 2; k++) {
            CHECK_BITS(p.low[k], polygons[i / 2].low[k]);
            CHECK_BITS(p.high[k], polygons[i / 2].high[k]);
        }
        CHECK_NEAR(p.cosine, polygons[i / 2].cosine, 1e-15);
    }
}

/* The quarter of a circle in rational form, cut in its middle. */
TEST(halves_of_a_piece_meet_in_its_middle)
{
    static const double points[3][2] = {{1, 0}, {1, 1}, {0, 1}},
                        weights[3] = {1, 0.7071067811865476, 1};
    const bat_crossing_piece whole = piece_of(3, 2, points, weights, 2, 4);
    bat_crossing_piece left, right;
    bat_crossing_piece_halve(&whole, &left, &right);
    CHECK(left.curve == 3 && right.curve == 3 && left.degree == 2 && right.degree == 2);
    CHECK(left.a == 2 && left.b == 3 && right.a == 3 && right.b == 4);
    const double h = 0.7071067811865476, t = 0.41421356237309503; /* tan(45 / 2 degrees) */
    const double expected[5][2] = {{1, 0}, {1, t}, {h, h}, {t, 1}, {0, 1}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(left.rows[3 * i + k] / left.rows[3 * i + 2], expected[i][k], 1e-15);
            CHECK_NEAR(right.rows[3 * i + k] / right.rows[3 * i + 2], expected[i + 2][k],
                       1e-15);
        }
    CHECK_NEAR(left.low[0], h, 1e-15);
    CHECK_NEAR(right.high[0], h, 1e-15);
    CHECK_NEAR(left.cosine, cos(0.39269908169872414), 1e-15); /* half of 45 degrees */
    CHECK_NEAR(right.cosine, left.cosine, 1e-15);
}

TEST(boxes_that_share_a_point_may_meet)
{
    static const struct {
        double low[2], high[2];
        bool meets;
    } rows[] = {
        {{1, 1}, {2, 2}, true},      {{2, 0}, {3, 1}, true},      {{-1, -1}, {0, 0}, true},
        {{2.1, 0}, {3, 1}, false},   {{-3, 0}, {-0.1, 1}, false}, {{0, 4.1}, {1, 5}, false},
        {{0, -2}, {1, -0.1}, false}, {{0, 4}, {1, 5}, true},      {{-9, -9}, {9, 9}, true}};
    const bat_crossing_piece p = {.low = {0, 0}, .high = {2, 4}};
    for (int i = 0; i < COUNT(rows); i++) {
        bat_crossing_piece q = {.curve = 1};
        memcpy(q.low, rows[i].low, sizeof q.low);
        memcpy(q.high, rows[i].high, sizeof q.high);
        CHECK_INT(bat_crossing_pieces_may_meet(&p, &q), rows[i].meets);
        CHECK_INT(bat_crossing_pieces_may_meet(&q, &p), rows[i].meets);
    }
}

/* ---- crossings ---- */

static batten_curve *bezier(int degree, const double (*points)[2], double a, double b)
{
    const double breaks[2] = {a, b};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){degree, 1, breaks}, &points[0][0],
                                      NULL, &curve));
    return curve;
}

static bat_crossings cross(int count, batten_curve *const *curves, bool closed,
                           const bat_crossing_piece *p, const bat_crossing_piece *q)
{
    bat_crossings found = {0};
    bat_crossing_search s = {.curves = (const batten_curve *const *)curves,
                             .curve_count = count,
                             .closed = closed,
                             .tiny = 1e-9};
    s.stack = test_array(2 * (2 * BAT_CROSSING_DEPTH + 4), sizeof *s.stack);
    CHECK_OK(bat_crossing_pieces(&s, p, q, &found));
    return found;
}

/* The parabola y = x^2 over -1 .. 1, u from 0 to 2, and lines y = height + rise x over -2 .. 2, v from 5 to 9. */
TEST(a_parabola_and_a_line_cross_where_their_equations_say)
{
    static const struct {
        double height, rise;
        int count;
        double x[2];
    } rows[] = {{0.25, 0, 2, {-0.5, 0.5}},
                {-0.1, 0, 0, {0}},
                {0.5, 0.5, 2, {-0.5, 1}},
                {0, 0.5, 2, {0, 0.5}},
                {1.5, 1, 1, {-0.8228756555322954}},
                {3, 0, 0, {0}},
                {-1, 0.25, 0, {0}}};
    static const double parabola[3][2] = {{-1, 1}, {0, -1}, {1, 1}};
    for (int i = 0; i < 2 * COUNT(rows); i++) {
        const double h = rows[i / 2].height, r = rows[i / 2].rise,
                     line[2][2] = {{-2, h - 2 * r}, {2, h + 2 * r}};
        const int swap = i % 2;
        batten_curve *curves[2];
        curves[swap] = bezier(2, parabola, 0, 2);
        curves[1 - swap] = bezier(1, line, 5, 9);
        const bat_crossing_piece p = piece_of(swap, 2, parabola, NULL, 0, 2),
                                 q = piece_of(1 - swap, 1, line, NULL, 5, 9);
        bat_crossings found = cross(2, curves, false, &p, &q);
        /* One in the middle of a piece is found with each of its halves. */
        int seen[2] = {0, 0};
        for (int k = 0; k < found.count; k++) {
            const bat_crossing *c = &found.at[k];
            CHECK(c->curve[0] == 0 && c->curve[1] == 1);
            double off = HUGE_VAL;
            for (int n = 0; n < rows[i / 2].count; n++) {
                const double own = fabs(c->u[swap] - 1 - rows[i / 2].x[n]);
                seen[n] += own < 1e-14;
                off = fmin(off, own);
            }
            CHECK(off < 1e-14);
            CHECK_NEAR(c->u[1 - swap] - 7, c->u[swap] - 1, 1e-14);
        }
        for (int n = 0; n < rows[i / 2].count; n++)
            CHECK(seen[n] > 0);
        bat_release(found.at);
        batten_curve_unref(curves[0]);
        batten_curve_unref(curves[1]);
    }
}

/* (s^2 - 3, s (s^2 - 3)) for s = 4 u - 2 crosses itself at s = +-sqrt 3; its halves share the point at u = 1/2. */
TEST(neighbours_cross_elsewhere_than_where_they_meet)
{
    static const double loop[4][2] = {{1, -2}, {-13.0 / 3, 10}, {-13.0 / 3, -10}, {1, 2}};
    batten_curve *curve = bezier(3, loop, 0, 1);
    const bat_crossing_piece whole = piece_of(0, 3, loop, NULL, 0, 1);
    bat_crossing_piece halves[2];
    bat_crossing_piece_halve(&whole, &halves[0], &halves[1]);
    for (int k = 0; k < 2; k++) {
        bat_crossings found = cross(1, &curve, false, &halves[k], &halves[1 - k]);
        CHECK_INT(found.count, 1);
        CHECK_NEAR(found.at[0].u[0], 0.5 - sqrt(3) / 4, 1e-13);
        CHECK_NEAR(found.at[0].u[1], 0.5 + sqrt(3) / 4, 1e-13);
        bat_release(found.at);
    }
    batten_curve_unref(curve);
}

/* Lines from corner to corner: the end of one is the start of the next, which is no crossing in a chain; that of the
 * last and the first is none in a closed one. */
TEST(ends_that_follow_each_other_are_no_crossings)
{
    static const double corners[4][2] = {{0, 0}, {4, 0}, {1, 3}, {0, 0}};
    batten_curve *curves[3];
    bat_crossing_piece pieces[3];
    for (int i = 0; i < 3; i++) {
        curves[i] = bezier(1, corners + i, i, i + 1);
        pieces[i] = piece_of(i, 1, corners + i, NULL, i, i + 1);
    }
    for (int i = 0; i < 12; i++) {
        const int a = i / 2 % 3, b = (a + 1) % 3;
        const bool closed = i >= 6, swap = i % 2;
        bat_crossings found =
            cross(3, curves, closed, &pieces[swap ? b : a], &pieces[swap ? a : b]);
        CHECK_INT(found.count, a == 2 && !closed);
        if (found.count) {
            CHECK_NEAR(found.at[0].u[0], 0, 1e-15);
            CHECK_NEAR(found.at[0].u[1], 3, 1e-15);
        }
        bat_release(found.at);
    }
    for (int i = 0; i < 3; i++)
        batten_curve_unref(curves[i]);
}
