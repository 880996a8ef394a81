/* Pieces of implicit curves linked to branches, through their singular points. */
#include "shape/equation/branches.h"

#include "base/list.h"
#include "systems.h"

/* All that a trace has before its branches become curves. */
typedef struct {
    test_system s;
    bat_cells cells;
    bat_clusters clusters;
    bat_branches branches;
    batten_equation_curves made;
} linked;

static batten_status link(const bat_cell *whole, double tolerance, linked *all)
{
    bat_cell_list list = {NULL, 0, 0};
    all->cells = (bat_cells){.system = &all->s.system, .whole = *whole, .most = 100000};
    all->clusters = (bat_clusters){NULL, 0, NULL};
    all->branches = (bat_branches){0};
    all->made = (batten_equation_curves){0};
    batten_status status = BAT_LIST_ADD(list.items, list.count, list.room, *whole);
    if (status == BATTEN_OK)
        status = bat_cells_divide(&all->cells, &list, tolerance / 64);
    if (status == BATTEN_OK)
        status = bat_clusters_gather(&all->cells, &all->clusters);
    if (status == BATTEN_OK)
        status = bat_branches_link(&all->branches, &all->cells, &all->clusters, tolerance,
                                   &all->made);
    return status;
}

static void end_link(linked *all)
{
    bat_branches_release(&all->branches);
    bat_clusters_release(&all->clusters);
    bat_cells_release(&all->cells);
    batten_equation_curves_release(&all->made);
}

/* The second time, where memory failed. */
static void link_branches(const char *const text[2], const bat_cell *whole, double tolerance,
                          linked *all)
{
    begin_test_system(&all->s, text[0], text[1]);
    batten_status status = link(whole, tolerance, all);
    if (status == BATTEN_OUT_OF_MEMORY) {
        end_link(all);
        status = link(whole, tolerance, all);
    }
    CHECK_OK(status);
}

static void check_tangents(const bat_system *s, const bat_segment *segment)
{
    double along[3] = {0, 0, 0};
    for (int k = 0; k < s->dimension; k++) {
        along[0] += segment->leave[k] * segment->leave[k];
        along[1] += segment->arrive[k] * segment->arrive[k];
        along[2] += segment->leave[k] * (segment->to[k] - segment->from[k]);
    }
    CHECK_NEAR(along[0], 1, 1e-14);
    CHECK_NEAR(along[1], 1, 1e-14);
    CHECK(along[2] > 0);
}

/* Neighbours have one point and, unless one is a line, one tangent to the bit. */
static void check_branch(const bat_system *s, const bat_segments *branch, bool closed)
{
    for (int i = 0; i < branch->count; i++) {
        const bat_segment *segment = &branch->items[i];
        const bat_segment *before = &branch->items[i ? i - 1 : branch->count - 1];
        if (!segment->is_line)
            check_tangents(s, segment);
        for (int k = 0; k < s->dimension && (i > 0 || closed); k++) {
            CHECK(segment->from[k] == before->to[k]);
            if (!segment->is_line && !before->is_line)
                CHECK(segment->leave[k] == before->arrive[k]);
        }
    }
}

typedef struct {
    const char *text[2];
    int open, closed, loose, lines; /* lines: of all branches */
    int points, ends;               /* the branches at the only point */
    batten_equation_point_kind kind;
} row;

static const row rows[] = {
    {{"x^2 + y^2 - 1/2"}, 0, 1, 0, 0, 0, 0, BATTEN_EQUATION_NODE},
    {{"x*y - 1/8"}, 2, 0, 0, 0, 0, 0, BATTEN_EQUATION_NODE},
    {{"(x^2 + y^2 - 1/2)*(x - 0.9)"}, 1, 1, 0, 0, 0, 0, BATTEN_EQUATION_NODE},
    {{"(x - 0.3)*(y + 0.2)"}, 2, 0, 0, 0, 1, 4, BATTEN_EQUATION_NODE},
    {{"x*y*(x - y)"}, 3, 0, 0, 0, 1, 6, BATTEN_EQUATION_NODE},
    {{"y^2 - x^3"}, 1, 0, 0, 2, 1, 2, BATTEN_EQUATION_SINGULAR},
    {{"x^2 + y^2"}, 0, 0, 0, 0, 1, 0, BATTEN_EQUATION_ISOLATED},
    {{"x^2 + y^2 + z^2 - 1/2", "z - x*y"}, 0, 1, 0, 0, 0, 0, BATTEN_EQUATION_NODE},
    {{"x*y", "z - x/2"}, 2, 0, 0, 0, 1, 4, BATTEN_EQUATION_NODE},
};

TEST(pieces_make_branches_with_common_points_and_tangents_and_open_ones_come_first)
{
    const bat_cell whole = {{{-1, 1.01}, {-1.02, 1}, {-1, 1}}};
    for (int i = 0; i < COUNT(rows); i++) {
        linked all;
        bat_segments branch = {NULL, 0, 0};
        int open = 0, closed = 0, lines = 0;
        link_branches(rows[i].text, &whole, 1e-3, &all);
        CHECK_OK(bat_branches_next(&all.branches, &branch));
        while (branch.count > 0) {
            const bool loops = bat_segments_extent(&all.s.system, &branch) == (double)INFINITY;
            check_branch(&all.s.system, &branch, loops);
            for (int k = 0; k < branch.count; k++)
                lines += branch.items[k].is_line;
            CHECK(loops || closed == 0);
            open += !loops;
            closed += loops;
            CHECK_OK(bat_branches_next(&all.branches, &branch));
        }
        CHECK_INT(open, rows[i].open);
        CHECK_INT(closed, rows[i].closed);
        CHECK_INT(lines, rows[i].lines);
        CHECK_INT(all.branches.loose, rows[i].loose);
        CHECK_INT(all.made.point_count, rows[i].points);
        if (rows[i].points) {
            CHECK_INT(all.made.points[0].branches, rows[i].ends);
            CHECK_INT(all.made.points[0].kind, rows[i].kind);
        }
        bat_release(branch.items);
        end_link(&all);
        end_test_system(&all.s);
    }
}
