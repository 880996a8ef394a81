/* Straight runs of the lines of a hull: from the stations between which they are declared to the
 * coefficients that lie on one straight line. */
#include "loft/rails.h"

#include <string.h>

enum { P = BAT_LOFT_DEGREE };

const char *bat_hull_rail_name(const bat_hull_rails *r, int rail)
{
    const int line = r->line[rail];
    return line >= 0   ? batten_offset_table_line(r->of.table, line)->name
           : rail == 0 ? "profile"
                       : "sheer";
}

/* ---- on which rail ---- */

/* Do the points of the rail along the run lie on the line of the table with this name? */
static bool carries(const bat_hull_rails *r, int rail, const batten_loft_straight *run)
{
    bool is_on = true;
    for (int k = run->from; k <= run->to && is_on; k++) {
        const int line = bat_hull_rail_point(r, rail, k)->line;
        is_on = line >= 0 &&
                strcmp(batten_offset_table_line(r->of.table, line)->name, run->line) == 0;
    }
    return is_on;
}

/* By the line of the table on which its points lie, else by what messages call it; -1 for none. */
static int rail_of(const bat_hull_rails *r, const batten_loft_straight *run)
{
    for (int rail = 0; rail < r->count; rail++)
        if (carries(r, rail, run))
            return rail;
    for (int rail = 0; rail < r->count; rail++)
        if (strcmp(bat_hull_rail_name(r, rail), run->line) == 0)
            return rail;
    return -1;
}

static batten_status check_run(const bat_hull_rails *r, const batten_loft_straight *run)
{
    const int stations = r->of.station_count;
    if (!run->line)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a straight run has no line");
    if (run->from < 0 || run->to >= stations || run->from >= run->to)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "the straight run of the line '%.60s' is from station %d to station %d; "
            "they must be two of 1 to %d, the first before the second",
            run->line, run->from + 1, run->to + 1, stations);
    if (rail_of(r, run) < 0)
        return bat_fail(BATTEN_NOT_FOUND,
                        "the line '%.60s' bounds no panel from %s to %s: straight runs are on "
                        "'profile', on 'sheer' and on lines declared as knuckles",
                        run->line, batten_offset_table_label(r->of.table, run->from).text,
                        batten_offset_table_label(r->of.table, run->to).text);
    return BATTEN_OK;
}

batten_status bat_hull_check_runs(const bat_hull_rails *r, const batten_loft_options *options)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < options->straight_count && status == BATTEN_OK; k++)
        status = check_run(r, options->straight + k);
    return status;
}

/* ---- its coefficients ---- */

/* Those of the spans from u to u: the run begins and ends at knots, which are at the stations of
 * the sheer; on a line whose ends are elsewhere it reaches out to the next. */
static bat_straight_run run_between(const bat_loft_line *line, double from, double to)
{
    const double same = 1e-9; /* of the length: stations are farther apart */
    int first = P, last = line->count;
    while (line->knots[first + 1] <= from + same)
        first++;
    while (line->knots[last - 1] >= to - same)
        last--;
    return (bat_straight_run){first - P, last - 1};
}

/* In order along the line. */
static void insert_run(bat_straight_run run, bat_loft_line *line, bat_straight_run *runs)
{
    int k = line->run_count++;
    for (; k > 0 && runs[k - 1].first > run.first; k--)
        runs[k] = runs[k - 1];
    runs[k] = run;
}

static bool is_straight_in(const batten_loft_straight *run, int axis)
{
    return run->view == BATTEN_LOFT_IN_SPACE ||
           run->view == (axis == 0 ? BATTEN_LOFT_IN_PLAN : BATTEN_LOFT_IN_PROFILE);
}

bool bat_hull_run_of(const bat_hull_rails *r, const batten_loft_straight *run, int rail,
                     int axis, const bat_loft_line *line, bat_straight_run *out)
{
    const bool is_there = is_straight_in(run, axis) && rail_of(r, run) == rail;
    if (is_there)
        *out = run_between(line, bat_hull_rail_u(r, rail, run->from),
                           bat_hull_rail_u(r, rail, run->to));
    return is_there;
}

batten_status bat_hull_find_runs(bat_hull_rails *r, const batten_loft_options *options,
                                 int rail, int axis, bat_loft_line *line)
{
    bat_straight_run *runs =
        bat_arena_array(&r->of.arena, (size_t)options->straight_count, sizeof *runs);
    if (!runs)
        return BATTEN_OUT_OF_MEMORY;
    line->runs = runs;
    for (int k = 0; k < options->straight_count; k++) {
        bat_straight_run run;
        if (bat_hull_run_of(r, options->straight + k, rail, axis, line, &run))
            insert_run(run, line, runs);
    }
    for (int k = 1; k < line->run_count; k++)
        if (runs[k].first < runs[k - 1].last)
            return bat_fail(
                BATTEN_BAD_ARGUMENT,
                "two straight runs of the line '%.60s' are so near that a smooth line "
                "is straight from the one to the other: declare them as one",
                bat_hull_rail_name(r, rail));
    return BATTEN_OK;
}
