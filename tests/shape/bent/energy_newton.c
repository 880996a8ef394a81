/* Newton's method comes down to curves of least energy that are known. */
#include "shape/bent/energy.h"

#include "support/test.h"

enum { NODES = 4, MOST = NODES * 9 };

/* Few nodes with room for all that a search needs. */
typedef struct {
    bat_energy_curve curve;
    double x[MOST], step[NODES], frame[MOST];
    int unknown[MOST];
    batten_curve_minimum_energy_report report;
    bat_energy_end end;
} bench;

/* All numbers are unknown but those of the rows [count] of nodes * 3 + order that are given. */
static void number_unknowns(bench *b, int d, int nodes, bool closed, int count,
                            const int *given)
{
    int *unknown = b->unknown, next = 0;
    for (int i = 0; i < nodes * 3 * d; i++) {
        bool fixed = false;
        for (int k = 0; k < count; k++)
            fixed = fixed || i / d == given[k];
        unknown[i] = fixed ? -1 : next++;
    }
    b->curve = (bat_energy_curve){.d = d,
                                  .count = nodes,
                                  .spans = nodes - !closed,
                                  .closed = closed,
                                  .x = b->x,
                                  .step = b->step,
                                  .unknown = unknown,
                                  .frame = b->frame,
                                  .unknown_count = next,
                                  .band = next ? next - 1 : 0};
}

/* From (0, 0) to (2, 0), with a bump in the middle. */
static void begin_bump(bench *b, double bump)
{
    static const int given[] = {0, 1, 6, 7};
    *b = (bench){.step = {1, 1}};
    number_unknowns(b, 2, 3, false, COUNT(given), given);
    for (int i = 0; i < 3; i++) {
        b->x[6 * i] = i;
        b->x[6 * i + 1] = i == 1 ? bump : 0;
        b->x[6 * i + 2] = 1;
    }
}

/* Nodes of a circle of radius 1, moved by a little. */
static void begin_circle(bench *b, double off)
{
    *b = (bench){.step = {1.57, 1.57, 1.57, 1.57}};
    number_unknowns(b, 2, NODES, true, 0, NULL);
    for (int i = 0; i < NODES; i++) {
        const double t = 1.5707963267948966 * i;
        const double at[] = {cos(t), sin(t), -sin(t), cos(t), -cos(t), -sin(t)};
        memcpy(b->x + 6 * i, at, sizeof at);
        b->x[6 * i] += i % 2 ? off : -off;
        b->x[6 * i + 3] += i == 1 ? off : 0;
    }
}

static batten_status minimise(const bat_energy_task *task, bench *b)
{
    return bat_energy_minimise(task, &b->curve, &b->report, &b->end);
}

/* Along the line nothing changes the energy: those unknowns are held, and the line is found. */
TEST(a_bump_between_fixed_ends_becomes_the_line)
{
    static const batten_energy kinds[] = {BATTEN_ENERGY_BENDING, BATTEN_ENERGY_VARIATION};
    for (int i = 0; i < 4; i++) {
        bench b;
        const bat_energy_task task = {
            .kind = kinds[i % 2], .max_steps = 100, .longest = 100, .tension = i < 2 ? 0 : 0.5};
        begin_bump(&b, 0.1);
        CHECK_OK(minimise(&task, &b));
        CHECK_INT(b.end, BAT_ENERGY_LEAST);
        CHECK(b.report.steps > 0 && b.report.steps < 60);
        CHECK(b.report.before > 0.05 && b.report.remaining < 1e-8);
        CHECK_NEAR(b.report.length, 2, 1e-8);
        CHECK_NEAR(b.report.after, 2 * task.tension, 1e-8);
        for (int k = 0; k < 3; k++)
            for (int order = 0; order < 3; order++)
                CHECK_NEAR(b.x[6 * k + 2 * order + 1], 0, 1e-4);
    }
}

/* The product of bending and length of a closed curve is least, 4 pi^2, for the circle; variation there is none. */
TEST(a_closed_curve_of_least_bending_by_length_is_the_circle)
{
    bench b;
    bat_energy_task task = {.kind = BATTEN_ENERGY_BENDING,
                            .scale_invariant = true,
                            .max_steps = 100,
                            .longest = 1000};
    begin_circle(&b, 0.1);
    CHECK_OK(minimise(&task, &b));
    CHECK_INT(b.end, BAT_ENERGY_LEAST);
    CHECK(b.report.before > 39.7 && b.report.steps < 80);
    CHECK_NEAR(b.report.after, 39.47841760435743, 5e-3);
    CHECK(b.report.after >= 39.478 && b.report.after <= b.report.before);
    task.kind = BATTEN_ENERGY_VARIATION;
    begin_circle(&b, 0.1);
    CHECK_OK(minimise(&task, &b));
    CHECK(b.report.after < 0.1 && b.report.after < 1e-3 * b.report.before);
}

/* Without conditions bending falls by growing: the radius that is reached is where bending and tension balance,
 * 2 pi (1 / r + tension r): r = 1 / sqrt(tension). */
TEST(under_a_tension_a_circle_has_the_radius_where_both_balance)
{
    static const double tensions[] = {0.25, 1, 4};
    for (int i = 0; i < COUNT(tensions); i++) {
        bench b;
        const bat_energy_task task = {.kind = BATTEN_ENERGY_BENDING,
                                      .tension = tensions[i],
                                      .max_steps = 200,
                                      .longest = 1000};
        begin_circle(&b, 0.05);
        CHECK_OK(minimise(&task, &b));
        CHECK_INT(b.end, BAT_ENERGY_LEAST);
        CHECK_NEAR(b.report.length, 6.283185307179586 / sqrt(tensions[i]), 0.02);
        CHECK_NEAR(b.report.after, 12.566370614359172 * sqrt(tensions[i]), 0.02);
    }
}

TEST(searches_end_after_their_steps_beyond_the_longest_and_where_nothing_is_unknown)
{
    bench b;
    bat_energy_task task = {.kind = BATTEN_ENERGY_BENDING, .max_steps = 1, .longest = 1000};
    begin_circle(&b, 0.1);
    CHECK_OK(minimise(&task, &b));
    CHECK(b.end == BAT_ENERGY_UNDERWAY && b.report.steps == 1 &&
          b.report.after < b.report.before);
    CHECK(b.report.remaining > 0);
    task.max_steps = 0;
    begin_circle(&b, 0.1);
    CHECK_OK(minimise(&task, &b));
    CHECK(b.end == BAT_ENERGY_UNDERWAY && b.report.steps == 0 &&
          b.report.after == b.report.before);
    task.max_steps = 100;
    task.longest = 8;
    begin_circle(&b, 0.1);
    CHECK_OK(minimise(&task, &b));
    CHECK(b.end == BAT_ENERGY_GROWING && b.report.length > 8 && b.report.steps < 100);
    begin_bump(&b, 0.1);
    for (int i = 0; i < 18; i++)
        b.unknown[i] = -1;
    b.curve.unknown_count = b.curve.band = 0;
    CHECK_OK(minimise(&task, &b));
    CHECK(b.end == BAT_ENERGY_LEAST && b.report.steps == 0 &&
          b.report.after == b.report.before);
}
