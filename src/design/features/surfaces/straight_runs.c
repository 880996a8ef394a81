/* Straight runs of the lines of a hull, as a design states them. */
#include "design/features/surfaces/straight_runs.h"

#include <stdio.h>
#include <string.h>

/* A text in parts, which lie in a copy of it. */
typedef struct {
    char *line, *from, *to;
    batten_loft_view view;
} clause;

/* Cut the text in front of its last `word`; what is behind, or NULL. */
static char *cut_at_last(char *text, const char *word)
{
    char *found = NULL;
    for (char *at = strstr(text, word); at; at = strstr(at + 1, word))
        found = at;
    if (!found)
        return NULL;
    *found = 0;
    return found + strlen(word);
}

/* Cut off a view at the end. */
static batten_loft_view cut_view(char *text)
{
    static const struct {
        const char *words;
        batten_loft_view view;
    } views[] = {{" in plan", BATTEN_LOFT_IN_PLAN}, {" in profile", BATTEN_LOFT_IN_PROFILE}};
    const size_t size = strlen(text);
    for (int k = 0; k < 2; k++) {
        const size_t end = strlen(views[k].words);
        if (size > end && strcmp(text + size - end, views[k].words) == 0) {
            text[size - end] = 0;
            return views[k].view;
        }
    }
    return BATTEN_LOFT_IN_SPACE;
}

static batten_status split_clause(const char *text, bat_arena *arena, clause *out)
{
    char *copy = bat_arena_array(arena, strlen(text) + 1, 1);
    if (!copy)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(copy, text, strlen(text) + 1);
    out->line = copy;
    out->view = cut_view(copy);
    out->to = cut_at_last(copy, " to ");
    out->from = out->to ? cut_at_last(copy, " from ") : NULL;
    if (!out->from || !*out->line || !*out->from || !*out->to)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%.80s' is not a straight run: it must read LINE from STATION to "
                        "STATION, and may end with 'in plan' or 'in profile'",
                        text);
    return BATTEN_OK;
}

/* The names of the first stations, for a message. */
static void list_stations(const batten_offset_table *table, size_t size, char *out)
{
    size_t used = 0;
    out[0] = 0;
    for (int k = 0; k < batten_offset_table_station_count(table) && used < size; k++)
        used += (size_t)snprintf(out + used, size - used, "%s'%.30s'", k ? ", " : "",
                                 batten_offset_table_station(table, k)->name);
}

static batten_status find_station(const batten_offset_table *table, const char *name, int *out)
{
    char names[200];
    for (int k = 0; k < batten_offset_table_station_count(table); k++)
        if (strcmp(batten_offset_table_station(table, k)->name, name) == 0) {
            *out = k;
            return BATTEN_OK;
        }
    list_stations(table, sizeof names, names);
    return bat_fail(BATTEN_NOT_FOUND, "the table has no station '%.60s'; its stations are %s",
                    name, names);
}

static batten_status take_straight_run(const char *text, const batten_offset_table *table,
                                       bat_arena *arena, batten_loft_straight *out)
{
    clause parts;
    int from = 0, to = 0;
    batten_status status = split_clause(text, arena, &parts);
    if (status == BATTEN_OK)
        status = find_station(table, parts.from, &from);
    if (status == BATTEN_OK)
        status = find_station(table, parts.to, &to);
    if (status == BATTEN_OK && from == to)
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "the straight run '%.80s' begins and ends at one station", text);
    if (status == BATTEN_OK)
        *out = (batten_loft_straight){.line = parts.line,
                                      .from = from < to ? from : to,
                                      .to = from < to ? to : from,
                                      .view = parts.view};
    return status;
}

batten_status bat_take_straight_runs(const bat_run *run, const batten_offset_table *table,
                                     bat_arena *arena, batten_loft_options *options)
{
    const bat_argument *given = bat_argument_of(run, "straight");
    batten_loft_straight *runs = bat_arena_array(arena, (size_t)given->count, sizeof *runs);
    if (!runs)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < given->count && status == BATTEN_OK; k++)
        status = take_straight_run(given->items[k].text, table, arena, runs + k);
    options->straight_count = given->count;
    options->straight = runs;
    return status;
}
