/* The chain of the arcs that were found, and its report. */
#include "shape/arcs/arcs.h"

#include "support/test.h"

static const double pi = 3.14159265358979323846;

/* Parts of one arc each: chord, direction of the chord, half of the turn. */
typedef struct {
    double chord, direction, half;
} arc;

static batten_status chain_of(int count, const arc *arcs, const bat_arcs_chain_task *task,
                              batten_arcs_report *report, batten_chain **out)
{
    bat_arcs_list list = {0, 0, NULL};
    double at[2] = {0, 0};
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        bat_arcs_part part = {.from = i, .to = i + 1, .biarc = {.count = 1}};
        bat_arc_span(at, arcs[i].chord, arcs[i].direction, arcs[i].half, &part.biarc.arcs[0]);
        at[0] += arcs[i].chord * cos(arcs[i].direction);
        at[1] += arcs[i].chord * sin(arcs[i].direction);
        status = bat_arcs_list_add(&list, &part);
    }
    if (status == BATTEN_OK)
        status = bat_arcs_chain(&list, task, report, out);
    bat_arcs_list_end(&list);
    return status;
}

/* A line, two eighths of one circle of radius 1, a corner of half a radian and a smaller arc. */
static const arc mixed[] = {
    {2, 0, 0},
    {0.7653668647301796, 0.39269908169872414, 0.39269908169872414},
    {0.7653668647301796, 1.1780972450961724, 0.39269908169872414},
    {0.5, 1.5707963267948966 + 0.5 + 0.6, 0.6},
};

TEST(arcs_of_one_circle_are_joined_and_lines_radii_and_turns_are_reported)
{
    const batten_arcs_options options = batten_arcs_defaults();
    const bat_arcs_chain_task task = {&options, false, 3};
    batten_arcs_report report = {0};
    batten_chain *chain = NULL;
    CHECK_OK(chain_of(COUNT(mixed), mixed, &task, &report, &chain));
    CHECK_INT(batten_chain_span_count(chain), 3);
    CHECK_INT(report.arcs, 2);
    CHECK_INT(report.lines, 1);
    CHECK_NEAR(report.least_radius, 0.25 / sin(0.6), 1e-12);
    CHECK_NEAR(report.largest_turn, 0.5, 1e-12);
    CHECK_NEAR(batten_chain_span(chain, 1)->length, pi / 2, 1e-12);
    batten_chain_unref(chain);
}

/* Half circles and lines between: a track, closed where it begins. */
TEST(a_closed_chain_has_its_turn_at_the_seam_too)
{
    static const arc track[] = {{3, 0, 0},
                                {2, 1.5707963267948966, 1.5707963267948966},
                                {3, 3.14159265358979323846, 0},
                                {2, -1.5707963267948966, 1.5707963267948966}};
    static const arc drop[] = {{2, 1.5707963267948966, 1.5707963267948966},
                               {2, -1.5707963267948966, 0}};
    const batten_arcs_options options = batten_arcs_defaults();
    const bat_arcs_chain_task task = {&options, true, 3};
    batten_arcs_report report = {0};
    batten_chain *chain = NULL;
    CHECK_OK(chain_of(COUNT(track), track, &task, &report, &chain));
    CHECK(batten_chain_is_closed(chain) && report.arcs == 2 && report.lines == 2);
    CHECK_NEAR(report.largest_turn, 0, 1e-14);
    CHECK_NEAR(report.least_radius, 1, 1e-14);
    batten_chain_unref(chain);
    chain = NULL;
    CHECK_OK(chain_of(COUNT(drop), drop, &task, &report, &chain));
    CHECK_NEAR(report.largest_turn, pi / 2, 1e-14);
    batten_chain_unref(chain);
}

TEST(arcs_whose_height_is_rounding_are_lines)
{
    static const double halves[] = {1e-15, 1e-12};
    for (int i = 0; i < COUNT(halves); i++) {
        const arc flat[] = {{2, 0.3, halves[i]}};
        const batten_arcs_options options = batten_arcs_defaults();
        const bat_arcs_chain_task task = {&options, false, 3};
        batten_arcs_report report = {0};
        batten_chain *chain = NULL;
        CHECK_OK(chain_of(1, flat, &task, &report, &chain));
        CHECK(report.lines == !i && report.arcs == i);
        CHECK(i ? report.least_radius < 2e12 : report.least_radius == HUGE_VAL);
        CHECK_NEAR(batten_chain_span(chain, 0)->length, 2, 1e-14);
        CHECK_NEAR(batten_chain_span(chain, 0)->angle, 0.3, 1e-11);
        batten_chain_unref(chain);
    }
}

TEST(more_arcs_and_lines_than_allowed_are_refused_with_both_numbers)
{
    for (int most = 2; most <= 3; most++) {
        batten_arcs_options options = batten_arcs_defaults();
        const bat_arcs_chain_task task = {&options, false, 3};
        batten_arcs_report report = {0};
        batten_chain *chain = NULL;
        options.most = most;
        options.tolerance = 0.25;
        CHECK_STATUS(chain_of(COUNT(mixed), mixed, &task, &report, &chain),
                     most == 2 ? BATTEN_TOLERANCE_NOT_MET : BATTEN_OK);
        if (most == 2)
            CHECK_MESSAGE("3 arcs and lines are needed within 0.25; 2 are allowed");
        CHECK((chain != NULL) == (most == 3));
        batten_chain_unref(chain);
    }
}
