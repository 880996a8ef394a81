/* Single arcs of a row of tangent ones. */
#include "shape/arcs/smooth_step.h"

#include "support/test.h"

#include <stdlib.h>

enum { ROWS = 97 };

/* A search along the x axis, over u in [2, 5], with rows at even places of 0 .. 9.6. */
typedef struct {
    bat_arcs_smooth task;
    bat_arc_search search;
    bat_smooth_row rows[ROWS];
} bench;

static void begin_bench(bench *b)
{
    *b = (bench){.task = {.from = 2, .to = 5}};
    b->search = (bat_arc_search){.task = &b->task,
                                 .half = 0.01,
                                 .shrink = 1,
                                 .excess = 20,
                                 .least_bend = -2,
                                 .most_bend = 3,
                                 .count = ROWS - 1,
                                 .rows = b->rows};
    for (int i = 0; i < ROWS; i++)
        b->rows[i] = (bat_smooth_row){.u = 2 + i / 32.0,
                                      .point = {0.1 * i, 0},
                                      .direction = {1, 0},
                                      .node = {0.1 * i, 0},
                                      .angle = 0.01 * i,
                                      .reach = 1};
}

TEST(rows_of_a_closed_curve_go_on_beyond_the_last_with_all_turns_added)
{
    bench b;
    begin_bench(&b);
    const bat_smooth_row last = bat_smooth_row_at(&b.search, 96),
                         next = bat_smooth_row_at(&b.search, 97),
                         far = bat_smooth_row_at(&b.search, 100);
    CHECK(last.u == 5 && last.angle == b.rows[96].angle);
    CHECK(next.u == b.rows[1].u + 3 && next.point[0] == b.rows[1].point[0]);
    CHECK_NEAR(next.angle, 0.97, 1e-15);
    CHECK(far.u == b.rows[4].u + 3 && far.node[0] == b.rows[4].node[0]);
    CHECK_NEAR(far.angle, 1, 1e-15);
}

TEST(bends_are_allowed_up_to_the_least_and_the_most)
{
    static const struct {
        double bend;
        bool may;
    } rows[] = {{-2, true}, {-2.001, false}, {0, true}, {3, true}, {3.001, false}};
    bench b;
    begin_bench(&b);
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_INT(bat_smooth_may_bend(&b.search, rows[i].bend), rows[i].may);
}

TEST(an_arc_bends_alike_while_its_lean_changes_by_no_more_than_its_excess)
{
    bench b;
    begin_bench(&b);
    bat_smooth_row to = b.rows[1];
    to.reach = 2;
    /* 4 |change| <= 20 half l */
    CHECK(bat_smooth_bends_alike(&b.search, 0.1, &to, 0.1 + 0.0999, 2));
    CHECK(!bat_smooth_bends_alike(&b.search, 0.1, &to, 0.1 + 0.1001, 2));
    CHECK(bat_smooth_bends_alike(&b.search, 0.1, &to, 0.1 - 0.0999, 2));
    CHECK(!bat_smooth_bends_alike(&b.search, 0.1, &to, 0.1 - 0.1001, 2));
}

TEST(states_are_numbered_in_the_order_in_which_they_come)
{
    bench b;
    begin_bench(&b);
    for (int i = 0; i < 3; i++) {
        int index = -1;
        const bat_arc_state state = {i, 7, 0.5};
        CHECK_OK(bat_smooth_add(&b.search, &state, &index));
        CHECK_INT(index, i);
    }
    CHECK(b.search.state_count == 3 && b.search.states[2].place == 2 &&
          b.search.states[2].parent == 7);
    bat_release(b.search.states);
}

/* From (0, 0) with the angle 0.2 to a chord of angle 0.5: the arc turns by 0.6 and arrives at 0.8. */
TEST(an_arc_aims_at_a_node_and_arrives_with_the_lean_of_twice_its_chord)
{
    bench b;
    double lean = 9;
    int range = -9;
    begin_bench(&b);
    b.rows[0].angle = 0.15;
    bat_smooth_leg leg = bat_smooth_leg_of(&b.rows[0], 0.05);
    CHECK_NEAR(leg.angle, 0.2, 1e-15);
    CHECK_NEAR(leg.direction[0], cos(0.2), 1e-15);
    CHECK_NEAR(leg.direction[1], sin(0.2), 1e-15);
    CHECK(leg.from == &b.rows[0] && leg.lean == 0.05);
    bat_smooth_row to = {.node = {2 * cos(0.5), 2 * sin(0.5)}, .angle = 0.742, .reach = 1};
    CHECK(bat_smooth_aim(&b.search, &leg, &to, &lean, &range));
    CHECK_NEAR(leg.half, 0.3, 1e-15);
    CHECK_NEAR(leg.length, 2, 1e-15);
    CHECK_NEAR(lean, 0.058, 1e-15);
    CHECK_INT(range, 44); /* 0.058 / 0.005 + 32.5 */
    batten_biarc arc;
    CHECK(bat_smooth_arc(&b.search, &leg, &arc));
    CHECK(arc.count == 1 && arc.arcs[0].start[0] == 0 && arc.arcs[0].start[1] == 0);
    CHECK_NEAR(arc.arcs[0].angle, 0.2, 1e-15);
    CHECK_NEAR(arc.arcs[0].curvature[0], sin(0.3), 1e-15);
    CHECK_NEAR(arc.arcs[0].length * arc.arcs[0].curvature[0], 0.6, 1e-15);
    CHECK_NEAR(arc.turn[0], 0.6, 1e-15);
    b.task.least_radius = 1 / sin(0.3) + 1e-6;
    CHECK(!bat_smooth_arc(&b.search, &leg, &arc));
    b.task.least_radius = 1 / sin(0.3) - 1e-6;
    CHECK(bat_smooth_arc(&b.search, &leg, &arc));
    b.search.most_bend = 0.29;
    CHECK(!bat_smooth_arc(&b.search, &leg, &arc));
}

TEST(nodes_behind_without_a_chord_or_with_too_much_lean_are_not_aimed_at)
{
    static const struct {
        double angle, length, arrives; /* of the chord; with which the curve arrives */
        double excess;
        bool aims;
    } rows[] = {
        {1.57, 1, 3.14, 1e9, true},      {1.58, 1, 3.16, 1e9, false},
        {-1.57, 1, -3.14, 1e9, true},    {0, 0, 0, 1e9, false},
        {0.1, 1, 0.2 - 0.16, 1e9, true}, {0.1, 1, 0.2 - 0.163, 1e9, false},
        {0.1, 1, 0.2 + 0.16, 1e9, true}, {0.1, 1, 0.2 + 0.163, 1e9, false},
        {0.1, 1, 0.2 - 0.1, 9, false},   {0.1, 1, 0.2 - 0.08, 9, true},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bench b;
        double lean;
        int range;
        begin_bench(&b);
        b.rows[0].angle = 0;
        b.search.excess = rows[i].excess;
        bat_smooth_leg leg = bat_smooth_leg_of(&b.rows[0], 0);
        const bat_smooth_row to = {
            .node = {rows[i].length * cos(rows[i].angle), rows[i].length * sin(rows[i].angle)},
            .angle = rows[i].arrives,
            .reach = 1};
        CHECK_INT(bat_smooth_aim(&b.search, &leg, &to, &lean, &range), rows[i].aims);
    }
}

/* A line that passes 0.3 half bands above the rows, one of which is moved. */
TEST(an_arc_fits_while_every_row_between_its_ends_is_in_the_band)
{
    for (int moved = -1; moved < ROWS; moved += 7)
        for (int side = -1; side <= 1; side += 2) {
            bench b;
            batten_biarc line = {.count = 1};
            begin_bench(&b);
            const double start[] = {0, 0.003};
            bat_arc_span(start, 9.6, 0, 0, &line.arcs[0]);
            CHECK(bat_smooth_fits(&b.search, &line, 0, 96));
            if (moved < 0)
                continue;
            /* The line is `d` to the left of a row at -d. */
            b.rows[moved].point[1] = 0.003 + side * 0.0099;
            CHECK(bat_smooth_fits(&b.search, &line, 0, 96));
            /* Neighbours tell the search where to look closely. */
            for (int i = moved - 4; i <= moved + 4; i++)
                if (i >= 0 && i < ROWS)
                    b.rows[i].point[1] = 0.003 + side * 0.009;
            b.rows[moved].point[1] = 0.003 + side * 0.0101;
            CHECK_INT(bat_smooth_fits(&b.search, &line, 0, 96), moved == 0 || moved == 96);
            b.task.slack = 0.0002;
            CHECK(bat_smooth_fits(&b.search, &line, 0, 96));
        }
}

TEST(samples_take_their_share_of_the_band_but_next_to_ends_that_are_held)
{
    static const struct {
        bool held;
        int place;
        bool fits;
    } rows[] = {{false, 12, false}, {true, 12, true}, {true, 24, true}, {true, 40, false},
                {true, 60, false},  {true, 72, true}, {true, 90, true}, {false, 90, false}};
    for (int i = 0; i < COUNT(rows); i++) {
        bench b;
        batten_biarc line = {.count = 1};
        begin_bench(&b);
        const double start[] = {0, 0};
        bat_arc_span(start, 9.6, 0, 0, &line.arcs[0]);
        b.search.shrink = 0.9;
        b.search.held = rows[i].held;
        for (int k = rows[i].place - 3; k <= rows[i].place + 3; k++)
            b.rows[k].point[1] = -0.0089;
        b.rows[rows[i].place].point[1] = -0.0095;
        CHECK_INT(bat_smooth_fits(&b.search, &line, 0, 96), rows[i].fits);
    }
}

TEST(arcs_lead_from_a_held_end_towards_the_middle_of_the_band)
{
    static const struct {
        bool held;
        double middle, lean;
        bool leaves, arrives;
    } rows[] = {{false, 1, -0.1, true, true},  {true, 1, 0.1, true, false},
                {true, 1, -0.1, false, true},  {true, -1, 0.1, false, true},
                {true, -1, -0.1, true, false}, {true, 0, 0.1, true, true},
                {true, 1, 0, true, true}};
    bench b;
    begin_bench(&b);
    for (int i = 0; i < COUNT(rows); i++) {
        b.search.held = rows[i].held;
        b.search.middle = rows[i].middle;
        CHECK_INT(bat_smooth_leads_in(&b.search, rows[i].lean, false), rows[i].leaves);
        CHECK_INT(bat_smooth_leads_in(&b.search, rows[i].lean, true), rows[i].arrives);
    }
}

/* The rows at both ends are those of the neighbours. */
TEST(every_row_between_the_ends_of_a_short_arc_is_looked_at_and_no_other)
{
    for (int to = 12; to <= 40; to++)
        for (int moved = 8; moved <= to + 2; moved++) {
            bench b;
            batten_biarc line = {.count = 1};
            begin_bench(&b);
            const double start[] = {0, 0};
            bat_arc_span(start, 9.6, 0, 0, &line.arcs[0]);
            /* Neighbours lead to it. */
            for (int i = moved - 4; i <= moved + 4; i++)
                b.rows[i].point[1] = 0.0095 - 0.0005 * abs(i - moved);
            b.rows[moved].point[1] = 0.011;
            CHECK_INT(bat_smooth_fits(&b.search, &line, 10, to), moved <= 10 || moved >= to);
        }
}
