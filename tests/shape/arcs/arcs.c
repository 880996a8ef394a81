/* How far arcs are from points, and single arcs fitted to them. */
#include "shape/arcs/arcs.h"

#include "support/test.h"

static const double pi = 3.14159265358979323846;

/* ---- bands and options ---- */

TEST(a_band_lies_on_its_side_of_the_curve)
{
    static const struct {
        batten_arcs_side side;
        double low, high, middle;
    } rows[] = {{BATTEN_ARCS_LEFT, 0, 0.5, 0.25},
                {BATTEN_ARCS_RIGHT, -0.5, 0, -0.25},
                {BATTEN_ARCS_EITHER, -0.5, 0.5, 0}};
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_band band = bat_band_of(rows[i].side, 0.5);
        CHECK(band.low == rows[i].low && band.high == rows[i].high);
        CHECK(band.middle == rows[i].middle);
    }
}

TEST(the_share_of_a_band_is_1_where_its_border_is_reached)
{
    static const struct {
        bat_band band;
        double low, high, slack, share;
    } rows[] = {
        {{-1, 1, 0}, -0.5, 0.25, 0, 0.5}, {{-1, 1, 0}, -0.25, 0.75, 0, 0.75},
        {{0, 2, 1}, 0, 1, 0, 1},          {{0, 2, 1}, 1, 2.5, 0, 1.5},
        {{0, 2, 1}, 1, 2.5, 0.5, 1},      {{-2, 0, -1}, -1.5, -1.25, 0, 0.5},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_beside beside = {rows[i].low, rows[i].high, 0, 0};
        CHECK_NEAR(bat_band_share(&rows[i].band, &beside, rows[i].slack), rows[i].share, 1e-15);
    }
}

TEST(options_of_arcs_are_checked_with_their_numbers)
{
    static const struct {
        double tolerance, least_radius, corner;
        int most;
        const char *says;
    } rows[] = {
        {0, 0, 0, 0, "the tolerance is 0; it must be above 0"},
        {-1, 0, 0, 0, "the tolerance is -1; it must be above 0"},
        {INFINITY, 0, 0, 0, "the tolerance is inf; it must be above 0"},
        {1, -2, 0, 0, "the least radius is -2; it must be 0 or more"},
        {1, INFINITY, 0, 0, "the least radius is inf; it must be 0 or more"},
        {1, 0, -0.5, 0, "the angle of corners is -0.5; it must be 0 or more"},
        {1, 0, INFINITY, 0, "the angle of corners is inf; it must be 0 or more"},
        {1, 0, 0, -1, "-1 arcs at most; it must be 0 or more"},
        {1, 0, 0, 0, NULL},
        {1e-9, 3, 2, 7, NULL},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_arcs_options options = batten_arcs_defaults();
        options.tolerance = rows[i].tolerance;
        options.least_radius = rows[i].least_radius;
        options.corner = rows[i].corner;
        options.most = rows[i].most;
        CHECK_STATUS(bat_arcs_check(&options), rows[i].says ? BATTEN_BAD_ARGUMENT : BATTEN_OK);
        if (rows[i].says)
            CHECK_MESSAGE(rows[i].says);
    }
    const batten_arcs_options usual = batten_arcs_defaults();
    CHECK(usual.size == sizeof usual && usual.corner == 1e-6 && usual.spread &&
          usual.most == 0);
    char text[BAT_RADII_TEXT] = "x";
    CHECK_TEXT(bat_arcs_of_least_radius(0, text), "");
    CHECK_TEXT(bat_arcs_of_least_radius(2.5, text), " with radii of 2.5 and more");
}

/* ---- distances ---- */

/* The half circle of radius 2 about (0, 0) from (2, 0), to the left; then a line down from (-2, 0). */
static batten_biarc half_circle_and_line(void)
{
    batten_biarc made = {.count = 2, .place = 0.5};
    const double first[] = {2, 0}, second[] = {-2, 0};
    bat_arc_span(first, 4, pi, pi / 2, &made.arcs[0]);
    bat_arc_span(second, 3, -pi / 2, 0, &made.arcs[1]);
    return made;
}

/* Left of the circle is inside; so a point outside is passed on its left. */
static const struct {
    double point[2], beside;
} places[] = {
    {{0, 2}, 0},   {{0, 3}, 1},     {{0, 1}, -1},
    {{3, 4}, 3},   {{1.2, 1.6}, 0}, {{-1.5, 0.5}, -0.4188611699158102},
    {{-2, -1}, 0}, {{-3, -1}, 1},   {{-1, -2}, -1},
};

TEST(arcs_pass_to_the_left_of_a_point_by_its_distance)
{
    const batten_biarc biarc = half_circle_and_line();
    bat_arcs_probe probe;
    bat_arcs_probe_make(&biarc, &probe);
    CHECK_INT(probe.count, 2);
    for (int i = 0; i < COUNT(places); i++)
        CHECK_NEAR(bat_arcs_beside(&probe, places[i].point), places[i].beside, 1e-14);
    /* The other side of an arc to the right. */
    batten_biarc right = {.count = 1};
    const double start[] = {0, 0};
    bat_arc_span(start, 2, 0, -pi / 2, &right.arcs[0]);
    bat_arcs_probe_make(&right, &probe);
    CHECK_NEAR(bat_arcs_beside(&probe, (const double[]){1, 0.5}), 0.5, 1e-15);
    CHECK_NEAR(bat_arcs_beside(&probe, (const double[]){1, 3}), -2, 1e-15);
}

TEST(the_slope_has_the_sign_of_the_change_along_a_direction)
{
    const batten_biarc biarc = half_circle_and_line();
    bat_arcs_probe probe;
    bat_arcs_probe_make(&biarc, &probe);
    for (int i = 0; i < COUNT(places); i++)
        for (int k = 0; k < 8; k++) {
            const double angle = k * pi / 4 + 0.3, h = 1e-6;
            const double *p = places[i].point;
            const double row[] = {p[0], p[1], cos(angle), sin(angle)};
            const double more[] = {p[0] + h * row[2], p[1] + h * row[3]};
            const double less[] = {p[0] - h * row[2], p[1] - h * row[3]};
            const double change = bat_arcs_beside(&probe, more) - bat_arcs_beside(&probe, less);
            CHECK((bat_arcs_slope(&probe, row) > 0) == (change > 0));
        }
}

TEST(the_extremes_among_samples_have_their_places)
{
    const batten_biarc biarc = half_circle_and_line();
    double u[] = {0.5, 1.5, 2.5, 3.5};
    double rows[][4] = {{0, 2.25}, {0, 1.5}, {0, 3}, {-1.75, -1}};
    const bat_samples samples = {4, 4, u, rows};
    bat_arcs_probe probe;
    bat_arcs_probe_make(&biarc, &probe);
    bat_beside beside = bat_arcs_beside_samples(&probe, &samples);
    CHECK_NEAR(beside.low, -0.5, 1e-15);
    CHECK_NEAR(beside.high, 1, 1e-15);
    CHECK(beside.low_at == 1.5 && beside.high_at == 2.5);
    bat_beside_widen(&beside, 9, 0.25);
    CHECK(beside.low_at == 1.5 && beside.high_at == 2.5);
    bat_beside_widen(&beside, 8, -3);
    CHECK(beside.low == -3 && beside.low_at == 8);
    bat_beside_widen(&beside, 7, 4);
    CHECK(beside.high == 4 && beside.high_at == 7);
}

/* ---- one arc ---- */

/* `count` points of the circle of radius r about (0, 0) from angle a to b, and the nodes there. */
typedef struct {
    double u[64], rows[64][4];
    bat_samples samples;
    bat_node from, to;
    bat_band band;
    bat_arcs_stretch on;
} stretch;

static void begin_stretch(stretch *s, double r, double a, double b, int count)
{
    const double sense = b > a ? 1 : -1;
    *s = (stretch){.band = {-0.01, 0.01, 0}};
    for (int i = 0; i < count; i++) {
        const double angle = a + (b - a) * i / (count - 1);
        s->u[i] = i;
        s->rows[i][0] = r * cos(angle);
        s->rows[i][1] = r * sin(angle);
    }
    s->from = (bat_node){{r * cos(a), r * sin(a)}, {-sense * sin(a), sense * cos(a)}};
    s->to = (bat_node){{r * cos(b), r * sin(b)}, {-sense * sin(b), sense * cos(b)}};
    s->samples = (bat_samples){count, 64, s->u, s->rows};
    s->on = (bat_arcs_stretch){&s->from, &s->to, b - a, 0, &s->band, &s->samples};
}

TEST(points_of_a_circle_give_its_arc_however_far_it_turns)
{
    static const double turns[] = {0.1, 1, 2, 3, 4, 5, -0.1, -1, -3, -5};
    for (int i = 0; i < COUNT(turns); i++) {
        stretch s;
        batten_biarc made = {0};
        begin_stretch(&s, 5, 0.3, 0.3 + turns[i], 33);
        CHECK(bat_arcs_single(&s.on, &made));
        CHECK_INT(made.count, 1);
        CHECK_NEAR(made.arcs[0].curvature[0], turns[i] > 0 ? 0.2 : -0.2, 1e-6);
        CHECK_NEAR(made.arcs[0].length, 5 * fabs(turns[i]), 1e-4);
        CHECK_NEAR(made.turn[0], turns[i], 1e-5);
        CHECK(made.is_long == (fabs(turns[i]) > pi));
    }
}

/* The sagitta of an arc of chord 2 may be 0.1 to 0.2 where the points lie at (0, -0.15): the middle. */
TEST(a_single_arc_goes_through_the_middle_of_what_the_points_leave)
{
    static const struct {
        bat_band band;
        double sagitta;
    } rows[] = {
        {{-0.05, 0.05, 0}, 0.15}, {{0, 0.05, 0.025}, 0.125}, {{-0.05, 0, -0.025}, 0.175}};
    for (int i = 0; i < COUNT(rows); i++) {
        double u[] = {0, 1, 2}, at[][4] = {{-1, 0}, {0, -0.15}, {1, 0}};
        const bat_samples samples = {3, 3, u, at};
        const bat_node from = {{-1, 0}, {1, 0}}, to = {{1, 0}, {1, 0}};
        const bat_arcs_stretch on = {&from, &to, 0.6, 0, &rows[i].band, &samples};
        batten_biarc made = {0};
        CHECK(bat_arcs_single(&on, &made));
        const double half = 2 * atan(rows[i].sagitta);
        CHECK_NEAR(made.turn[0], 2 * half, 1e-3);
    }
}

TEST(arcs_below_the_least_radius_without_a_chord_or_of_a_full_turn_are_none)
{
    for (int i = 0; i < 6; i++) {
        stretch s;
        batten_biarc made = {0};
        begin_stretch(&s, 5, 0.3, 1.3, 17);
        s.on.least_radius = i == 0 ? 4.99 : i == 1 ? 5.01 : 0;
        if (i == 2)
            s.to = s.from;
        if (i == 3)
            s.on.turn = 2 * pi;
        if (i == 4)
            s.on.turn = 1.3 + pi; /* a loop more than the arc */
        if (i == 5)
            s.to.point[0] = INFINITY;
        CHECK_INT(bat_arcs_single(&s.on, &made), i == 0);
    }
}

/* ---- biarcs ---- */

TEST(nodes_of_a_circle_have_it_for_a_biarc_and_a_turn_of_its_own_is_refused)
{
    stretch s;
    batten_biarc made = {0};
    begin_stretch(&s, 5, 0.3, 1.3, 17);
    CHECK(bat_arcs_biarc(&s.on, &made));
    CHECK_INT(made.count, 1);
    CHECK_NEAR(made.arcs[0].curvature[0], 0.2, 1e-12);
    static const double off[] = {0.002, -0.002, 6.28318530717958648};
    for (int i = 0; i < COUNT(off); i++) {
        s.on.turn = 1 + off[i];
        CHECK(!bat_arcs_biarc(&s.on, &made));
    }
    s.on.turn = 1.0005;
    CHECK(bat_arcs_biarc(&s.on, &made));
    s.on.least_radius = 5.01;
    CHECK(!bat_arcs_biarc(&s.on, &made));
    s.on.least_radius = 4.99;
    CHECK(bat_arcs_biarc(&s.on, &made));
    s.to = s.from;
    CHECK(!bat_arcs_biarc(&s.on, &made));
}

/* The largest distance of the biarc whose joint is in the middle. */
static double off_by_half(const stretch *s)
{
    const double *a = s->from.point, *b = s->to.point, l = hypot(b[0] - a[0], b[1] - a[1]);
    const double unit[] = {(b[0] - a[0]) / l, (b[1] - a[1]) / l};
    const bat_arc_chord chord = {{a[0], a[1]}, atan2(unit[1], unit[0]), l};
    batten_biarc made;
    bat_arcs_probe probe;
    CHECK_OK(bat_biarc_make(&chord, bat_turn(unit, s->from.direction),
                            bat_turn(unit, s->to.direction), 0.5, &made));
    bat_arcs_probe_make(&made, &probe);
    const bat_beside beside = bat_arcs_beside_samples(&probe, &s->samples);
    return fmax(beside.high, -beside.low);
}

/* A parabola y = x^2 between -0.2 and 1: the joint moves until both arcs are as far off. */
TEST(both_arcs_of_a_biarc_take_about_as_much_of_the_band)
{
    stretch s;
    batten_biarc made = {0};
    double off[2] = {0, 0};
    begin_stretch(&s, 1, 0, 1, 61);
    for (int i = 0; i < 61; i++) {
        const double x = -0.2 + 1.2 * i / 60;
        s.rows[i][0] = x;
        s.rows[i][1] = x * x;
    }
    s.from = (bat_node){{-0.2, 0.04}, {1, -0.4}};
    s.to = (bat_node){{1, 1}, {1, 2}};
    s.on.turn = atan(2) + atan(0.4);
    CHECK(bat_arcs_biarc(&s.on, &made));
    CHECK_INT(made.count, 2);
    bat_arcs_probe probe;
    bat_arcs_probe_make(&made, &probe);
    for (int i = 0; i < 61; i++) {
        const double *p = s.rows[i];
        const bool second = (p[0] - probe.joint[0]) * probe.along[0] +
                                (p[1] - probe.joint[1]) * probe.along[1] >
                            0;
        off[second] = fmax(off[second], fabs(bat_arcs_beside(&probe, p)));
    }
    CHECK(off[0] > 0 && off[0] < 2 * off[1] && off[1] < 2 * off[0]);
    CHECK(fmax(off[0], off[1]) < 0.9 * off_by_half(&s));
}

TEST(a_line_between_nodes_is_an_arc_without_curvature)
{
    const bat_node a = {{1, 2}, {0, 0}}, b = {{4, -2}, {0, 0}};
    batten_biarc made;
    bat_arcs_line(&a, &b, &made);
    CHECK_INT(made.count, 1);
    CHECK(made.arcs[0].curvature[0] == 0 && made.arcs[0].length == 5);
    CHECK(made.arcs[0].start[0] == 1 && made.arcs[0].start[1] == 2 && made.place == 0.5);
    CHECK_NEAR(made.arcs[0].angle, atan2(-4, 3), 1e-15);
}

/* ---- spreading ---- */

/* A run that needs as many parts as thirds powers say: `reach` (tolerance / unit)^(1/3) of the whole each. */
typedef struct {
    double whole, smallest;
    int runs;
    double last_tolerance;
} cubic_law;

static batten_status run_law(void *task, double tolerance, int *count, double *last)
{
    cubic_law *law = task;
    const double parts = law->whole / cbrt(tolerance);
    law->runs++;
    law->last_tolerance = tolerance;
    if (tolerance < law->smallest)
        return BATTEN_TOLERANCE_NOT_MET;
    *count = (int)ceil(parts - 1e-12);
    *last = parts - (*count - 1);
    return BATTEN_OK;
}

TEST(spreading_finds_the_smallest_tolerance_with_as_many_parts)
{
    static const double wholes[] = {0.5, 1.2, 3.7, 9.05};
    for (int i = 0; i < COUNT(wholes); i++) {
        cubic_law law = {.whole = wholes[i]};
        const double count = ceil(wholes[i]), least = pow(wholes[i] / count, 3);
        CHECK_OK(bat_arcs_spread(run_law, &law, 1, true));
        CHECK(law.last_tolerance >= least * (1 - 1e-9) && law.last_tolerance <= 1.03 * least);
        CHECK(law.runs <= 14);
        law = (cubic_law){.whole = wholes[i]};
        CHECK_OK(bat_arcs_spread(run_law, &law, 1, false));
        CHECK(law.runs == 1 && law.last_tolerance == 1);
    }
    cubic_law stuck = {.whole = 3.2, .smallest = 0.99};
    CHECK_OK(bat_arcs_spread(run_law, &stuck, 1, true));
    CHECK(stuck.last_tolerance >= 0.99);
    stuck.smallest = 2;
    CHECK_STATUS(bat_arcs_spread(run_law, &stuck, 1, true), BATTEN_TOLERANCE_NOT_MET);
}
