#include "design/features/surfaces/fill.h"
#include "design/text/document.h"
#include "support/test.h"

#include <batten/model.h>

/* What is said of the edges of fills: of all the worst, and of each what exceeds its bound. */

#define DEGREE (3.14159265358979323846 / 180)

static const batten_fill_edge edges[] = {
    {.curve = 1, .gap = 0.5, .gap_at = {1, 2, 3}},
    {.curve = -1,
     .first = 0,
     .second = 2,
     .has_slope = true,
     .gap = 0.75,
     .angle = 2 * DEGREE,
     .gap_at = {4, 5, 6},
     .angle_at = {7, 8, 9}},
    {.curve = 0,
     .has_slope = true,
     .has_curvature = true,
     .gap = 0.25,
     .angle = 1 * DEGREE,
     .curvature = 0.125,
     .gap_at = {1.5, 0, 0},
     .angle_at = {10, 11, 12},
     .curvature_at = {13, 14, 15}},
    /* The larger angle and curvature of one that has nothing to be compared with. */
    {.curve = 1, .angle = 9, .curvature = 9},
};

static const batten_object left = {.name = "left"}, right = {.name = "right"};
static const batten_object *named[] = {&left, &right};
static const bat_objects curves = {2, named};

/* The notes of one test, and a run that adds to them. */
static batten_notes *notes;

static const bat_run *begin_run(void)
{
    static const bat_document document;
    static bat_run run;
    CHECK_OK(batten_notes_create(9, &notes));
    run = (bat_run){.name = "a", .notes = notes, .document = &document};
    return &run;
}

static void check_lines(int count, const char *const *lines)
{
    if (batten_notes_dropped(notes) == 0) { /* for lack of memory */
        CHECK_INT(batten_notes_count(notes), count);
        for (int i = 0; i < count; i++) {
            CHECK_TEXT(batten_notes_at(notes, i)->text, lines[i]);
            CHECK(batten_notes_at(notes, i)->is_remark);
        }
    }
    batten_notes_free(notes);
}

TEST(an_edge_has_the_name_of_its_curve_or_of_the_surfaces_beside_it)
{
    char name[160];
    bat_name_edge(&curves, &edges[0], name);
    CHECK_TEXT(name, "along 'right'");
    bat_name_edge(&curves, &edges[2], name);
    CHECK_TEXT(name, "along 'left'");
    bat_name_edge(&curves, &edges[1], name);
    CHECK_TEXT(name, "between surfaces 1 and 3");
}

TEST(the_worst_edges_are_those_with_the_largest_gap_angle_and_curvature)
{
    const bat_worst_edges none = {NULL, NULL, NULL};
    bat_worst_edges worst = bat_find_worst_edges(1, edges, none);
    CHECK(worst.gap == &edges[0] && !worst.angle && !worst.curvature);
    worst = bat_find_worst_edges(4, edges, none);
    CHECK(worst.gap == &edges[1] && worst.angle == &edges[1] && worst.curvature == &edges[2]);
    /* What is known already stays when it is worse, or as bad. */
    worst = bat_find_worst_edges(1, edges + 2, worst);
    CHECK(worst.gap == &edges[1] && worst.angle == &edges[1] && worst.curvature == &edges[2]);
    worst = bat_find_worst_edges(2, edges + 1, bat_find_worst_edges(1, edges + 2, none));
    CHECK(worst.gap == &edges[1] && worst.angle == &edges[1] && worst.curvature == &edges[2]);
    worst = bat_find_worst_edges(0, NULL, none);
    CHECK(!worst.gap && !worst.angle && !worst.curvature);
}

TEST(the_worst_edges_are_remarked_in_one_line_with_their_places)
{
    static const char *const all[] = {
        "gaps of up to 0.75 m (between surfaces 1 and 3); tangent planes differ by up to 2 degrees "
        "(between surfaces 1 and 3, at 7, 8, 9); curvatures across by up to 0.125 per m (along "
        "'left', at 13, 14, 15)"};
    static const char *const alone[] = {"gaps of up to 0.5 mm (along 'right')"};
    static const char *const one[] = {
        "gaps of up to 0.25 m (along 'left'); tangent planes differ by up to 1 degree (along "
        "'left', at 10, 11, 12); curvatures across by up to 0.125 per m (along 'left', at 13, 14, "
        "15)"};
    const bat_worst_edges none = {NULL, NULL, NULL};
    bat_worst_edges worst = bat_find_worst_edges(4, edges, none);
    bat_remark_worst_edges(begin_run(), &curves, "m", &worst);
    check_lines(1, all);
    worst = bat_find_worst_edges(1, edges, none);
    bat_remark_worst_edges(begin_run(), &curves, "mm", &worst);
    check_lines(1, alone);
    worst = bat_find_worst_edges(1, edges + 2, none);
    bat_remark_worst_edges(begin_run(), &curves, "m", &worst);
    check_lines(1, one);
}

TEST(what_exceeds_its_bound_is_remarked_and_what_meets_it_is_not)
{
    static const char *const lines[] = {
        "along 'left': a gap of 0.25 m at (1.5, 0, 0), more than 0.2",
        "along 'left': tangent planes differ by 1 degree at (10, 11, 12)",
        "along 'left': curvatures across differ by 0.125 per m at (13, 14, 15)"};
    static const char *const two[] = {
        "between surfaces 1 and 3: tangent planes differ by 2 degrees at (7, 8, 9)"};
    const bat_edge_bounds small = {"m", 0.2, 0.5 * DEGREE, 0.1},
                          equal = {"m", 0.25, 1 * DEGREE, 0.125},
                          wide = {"m", 0.75, 1.5 * DEGREE, 0};
    bat_remark_excess(begin_run(), &curves, &small, &edges[2]);
    check_lines(3, lines);
    bat_remark_excess(begin_run(), &curves, &equal, &edges[2]);
    check_lines(0, NULL);
    bat_remark_excess(begin_run(), &curves, &wide, &edges[1]);
    check_lines(1, two);
    /* Without a slope or curvature there is none to exceed a bound. */
    bat_remark_excess(begin_run(), &curves, &small, &edges[3]);
    check_lines(0, NULL);
}
