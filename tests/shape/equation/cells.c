/* Boxes divided into cells that are free of the curve, have its pieces, or are undecided. */
#include "shape/equation/cells.h"

#include "base/list.h"
#include "systems.h"

/* Divide [-1, 1] in each coordinate. */
static batten_status divide_with(test_system *s, const batten_job *job, double least,
                                 size_t most, bat_cells *cells)
{
    const bat_cell whole = {{{-1, 1}, {-1, 1}, {-1, 1}}};
    bat_cell_list list = {NULL, 0, 0};
    *cells =
        (bat_cells){.system = &s->system, .whole = whole, .most = most, .work = {.job = job}};
    batten_status status = BAT_LIST_ADD(list.items, list.count, list.room, whole);
    if (status == BATTEN_OK)
        status = bat_cells_divide(cells, &list, least);
    if (status != BATTEN_OK)
        bat_cells_release(cells);
    return status;
}

static batten_status divide(test_system *s, double least, size_t most, bat_cells *cells)
{
    return divide_with(s, NULL, least, most, cells);
}

/* Graphs in the whole box: one piece, with ends in the order of the axis along which it runs most. */
static const struct {
    const char *first, *second;
    int graph;
    double ends[2][3];
    int axes[2], sides[2];
} graphs[] = {
    {"x - 0.5", NULL, 1, {{0.5, -1}, {0.5, 1}}, {1, 1}, {-1, 1}},
    {"y + 0.25*x", NULL, 0, {{-1, 0.25}, {1, -0.25}}, {0, 0}, {-1, 1}},
    {"y - x - 1.25", NULL, 0, {{-1, 0.25}, {-0.25, 1}}, {0, 1}, {-1, 1}},
    {"2*y + x - 2.5", NULL, 0, {{0.5, 1}, {1, 0.75}}, {1, 0}, {1, 1}},
    {"x - z/2", "y + z/4", 2, {{-0.5, 0.25, -1}, {0.5, -0.25, 1}}, {2, 2}, {-1, 1}},
    {"z - x/2", "y + x/4", 0, {{-1, 0.25, -0.5}, {1, -0.25, 0.5}}, {0, 0}, {-1, 1}},
    {"x - y/2", "z - y - 0.5", 1, {{-0.5, -1, -0.5}, {0.25, 0.5, 1}}, {1, 2}, {-1, 1}},
};

TEST(a_graph_over_the_whole_box_is_one_piece_between_its_sides)
{
    for (int i = 0; i < COUNT(graphs); i++) {
        test_system s;
        bat_cells cells;
        begin_test_system(&s, graphs[i].first, graphs[i].second);
        CHECK_OK(divide(&s, 0.01, 1000, &cells));
        CHECK(cells.examined == 1 && cells.count == 1 && cells.undecided.count == 0);
        CHECK_INT(cells.pieces[0].graph, graphs[i].graph);
        for (int e = 0; e < 2; e++) {
            const bat_cell_end *end = &cells.pieces[0].end[e];
            CHECK_INT(end->axis, graphs[i].axes[e]);
            CHECK_INT(end->side, graphs[i].sides[e]);
            CHECK(end->at == graphs[i].sides[e]);
            CHECK(end->radius >= 0 && end->radius < 1e-14);
            for (int k = 0; k < s.system.dimension; k++)
                CHECK_NEAR(end->point[k], graphs[i].ends[e][k], 1e-14);
        }
        bat_cells_release(&cells);
        CHECK(!cells.pieces && !cells.undecided.items);
        end_test_system(&s);
    }
}

TEST(
    a_box_that_the_curve_misses_is_examined_once_and_a_circle_has_pieces_in_order_along_their_axes)
{
    test_system s;
    bat_cells cells;
    begin_test_system(&s, "x + y - 3", NULL);
    CHECK_OK(divide(&s, 0.01, 1000, &cells));
    CHECK(cells.examined == 1 && cells.count == 0 && cells.undecided.count == 0);
    bat_cells_release(&cells);
    end_test_system(&s);
    begin_test_system(&s, "x^2 + y^2 - 0.5", NULL);
    CHECK_OK(divide(&s, 1e-5, 1000, &cells));
    CHECK(cells.count > 1 && cells.undecided.count == 0);
    for (size_t i = 0; i < cells.count; i++)
        for (int e = 0; e < 2; e++) {
            const bat_cell_piece *piece = &cells.pieces[i];
            const double *p = piece->end[e].point;
            CHECK_NEAR(hypot(p[0], p[1]), 0.7071067811865476, 1e-13);
            CHECK(piece->end[0].point[piece->graph] < piece->end[1].point[piece->graph]);
        }
    bat_cells_release(&cells);
    end_test_system(&s);
}

/* Squares are never understood. */
TEST(boxes_that_are_too_many_are_undecided_and_cuts_are_near_the_middle)
{
    for (int space = 0; space < 2; space++)
        for (size_t most = 0; most < 2; most++) {
            test_system s;
            bat_cells cells;
            begin_test_system(&s, "(x - y)^2", space ? "(y - z)^2" : NULL);
            CHECK_OK(divide(&s, 0.01, most, &cells));
            CHECK(cells.examined == 1 + 2 * most && cells.undecided.count == 1 + most);
            const bat_cell *low = cells.undecided.items, *high = low + most;
            for (int k = most ? 1 : 0; k < s.system.dimension; k++)
                CHECK(low->at[k].lo == -1 && low->at[k].hi == 1 && high->at[k].lo == -1 &&
                      high->at[k].hi == 1);
            CHECK(low->at[0].lo == -1 && high->at[0].hi == 1);
            if (most)
                CHECK(low->at[0].hi == high->at[0].lo && fabs(low->at[0].hi) < 0.08);
            bat_cells_release(&cells);
            end_test_system(&s);
        }
}

/* The lines cross: what holds the node stays undecided. */
TEST(cells_about_a_node_are_cut_until_no_side_is_as_long_as_the_least)
{
    for (int space = 0; space < 2; space++) {
        test_system s;
        bat_cells cells;
        begin_test_system(&s, "x*y", space ? "z - x - y" : NULL);
        CHECK_OK(divide(&s, 0.125, 100000, &cells));
        CHECK(cells.undecided.count > 0);
        for (size_t i = 0; i < cells.undecided.count; i++)
            for (int k = 0; k < s.system.dimension; k++) {
                const bat_interval at = cells.undecided.items[i].at[k];
                CHECK(bat_interval_width(at) < 0.125 &&
                      bat_interval_width(at) > 0.125 * 0.46 * 0.46);
                CHECK(at.lo < 1 && at.hi > -1);
            }
        bat_cells_release(&cells);
        end_test_system(&s);
    }
}

TEST(a_job_ends_the_division_after_its_work)
{
    test_system s;
    bat_cells cells;
    batten_job job = BATTEN_JOB;
    job.work_limit = 5;
    begin_test_system(&s, "x*y", NULL);
    CHECK_STATUS(divide_with(&s, &job, 1e-6, 1000, &cells), BATTEN_INCOMPLETE);
    CHECK(cells.examined <= 7 && !cells.pieces && !cells.undecided.items);
    end_test_system(&s);
}
