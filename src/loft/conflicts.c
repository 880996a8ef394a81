/*
 * A straight run that the bound forbids, said in words: which run of which line, in which view, the least bound
 * with which it can be, and the one point without which the bound would do.
 */
#include "loft/lines/line.h"
#include "loft/rails.h"

#include <batten/text.h>

/* Thirty doublings reach any size of a hull; five halvings by ratio leave the last known to a fiftieth. */
enum { DOUBLINGS = 30, HALVINGS = 5 };

/* A datum with so many times the bound has none. */
static const double no_bound = 1e9;

typedef struct {
    bat_hull_rails *rails;
    int rail;
    const batten_loft_straight *declared;
    bat_loft_line line; /* with this run alone */
    bat_straight_run run;
    double *f; /* coefficients, for trials */
} conflict;

static batten_status fits(const conflict *c, double within, const double *rooms)
{
    bat_loft_line line = c->line;
    int found;
    line.within = within;
    line.rooms = rooms;
    const batten_status status = bat_loft_line_fair(&line, c->f, &found);
    /* next to no room between the bounds */
    return status == BATTEN_INCOMPLETE ? BATTEN_NOT_COMPATIBLE : status;
}

/* The least bound of the line with which the run can be; 0: none was found. */
static batten_status find_least(const conflict *c, double *least)
{
    double low = c->line.within, high = low;
    batten_status status = BATTEN_NOT_COMPATIBLE;
    for (int k = 0; k < DOUBLINGS && status == BATTEN_NOT_COMPATIBLE; k++) {
        low = high;
        high = 2 * low;
        status = fits(c, high, NULL);
    }
    *least = status == BATTEN_OK ? high : 0;
    for (int k = 0; k < HALVINGS && status == BATTEN_OK; k++) {
        const double middle = sqrt(low * *least);
        status = fits(c, middle, NULL);
        if (status == BATTEN_OK)
            *least = middle;
        else
            low = middle;
        if (status == BATTEN_NOT_COMPATIBLE)
            status = BATTEN_OK;
    }
    return status == BATTEN_NOT_COMPATIBLE ? BATTEN_OK : status;
}

/* The one station of the run without whose point the bound would do; -1: none, or more than one
 * would. */
static batten_status find_culprit(const conflict *c, int *out)
{
    const int n = c->line.datum_count;
    double *rooms = bat_arena_array(&c->rails->of.arena, (size_t)n, sizeof *rooms);
    batten_status status = rooms ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int count = 0;
    for (int k = 0; k < n && rooms; k++)
        rooms[k] = 1;
    for (int k = c->declared->from; k <= c->declared->to && status == BATTEN_OK; k++) {
        rooms[k] = no_bound;
        status = fits(c, c->line.within, rooms);
        if (status == BATTEN_OK && count++ == 0)
            *out = k;
        else if (status == BATTEN_NOT_COMPATIBLE)
            status = BATTEN_OK;
        rooms[k] = 1;
    }
    if (count != 1)
        *out = -1;
    return status;
}

static const char *view_of(const batten_loft_straight *run)
{
    return run->view == BATTEN_LOFT_IN_PLAN      ? " in plan"
           : run->view == BATTEN_LOFT_IN_PROFILE ? " in profile"
                                                 : "";
}

static batten_status refuse_run(const conflict *c, double bound, double least, int culprit)
{
    const batten_offset_table *table = c->rails->of.table;
    char would[80] = "", but[160] = "", said[24];
    bat_loft_say_bound(least, sizeof said, said);
    if (least > 0)
        batten_text_print(would, sizeof would, "; within %s it can", said);
    if (culprit >= 0)
        batten_text_print(but, sizeof but, "; only its point at %s forbids it: is that right?",
                          batten_offset_table_label(table, culprit).text);
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "the line '%.60s' cannot be straight from %s to %s%s within %g of its "
                    "points%s%s",
                    bat_hull_rail_name(c->rails, c->rail),
                    batten_offset_table_label(table, c->declared->from).text,
                    batten_offset_table_label(table, c->declared->to).text,
                    view_of(c->declared), bound, would, but);
}

/* Is it this run that the bound forbids? NOT_COMPATIBLE, with the words, when it is. */
static batten_status examine(conflict *c, const batten_loft_options *options)
{
    const double part = c->line.within / options->within;
    double least = 0;
    int culprit = -1;
    batten_status status = fits(c, c->line.within, NULL);
    if (status != BATTEN_NOT_COMPATIBLE)
        return status;
    status = find_least(c, &least);
    if (status == BATTEN_OK)
        status = find_culprit(c, &culprit);
    if (status != BATTEN_OK)
        return status;
    c->rails->enough = least / part;
    c->rails->is_explained = true;
    return refuse_run(c, options->within, least / part, culprit);
}

batten_status bat_hull_explain_runs(bat_hull_rails *rails, const batten_loft_options *options,
                                    int rail, int axis, const bat_loft_line *line)
{
    conflict c = {.rails = rails, .rail = rail, .line = *line};
    c.f = bat_arena_array(&rails->of.arena, (size_t)line->count, sizeof *c.f);
    if (!c.f)
        return BATTEN_OUT_OF_MEMORY;
    c.line.run_count = 0;
    batten_status status = fits(&c, line->within, NULL); /* else it is not for the runs */
    for (int k = 0; k < options->straight_count && status == BATTEN_OK; k++) {
        c.declared = options->straight + k;
        if (!bat_hull_run_of(rails, c.declared, rail, axis, line, &c.run))
            continue;
        c.line.runs = &c.run;
        c.line.run_count = 1;
        status = examine(&c, options);
    }
    return status == BATTEN_OK ? BATTEN_NOT_COMPATIBLE : status;
}
