/* Counts the entities that were read and left out, and reports them. */
#include "exchange/reading/census.h"

#include <stdio.h>
#include <string.h>

enum { NAME = 80, MOST = 1000 };

typedef struct {
    char name[NAME];
    int read, left;
} row;

void bat_census_begin(bat_census *census)
{
    *census = (bat_census){.rows = {.size = sizeof(row)}};
}

void bat_census_end(bat_census *census)
{
    bat_release(census->rows.items);
    *census = (bat_census){.rows = {.size = sizeof(row)}};
}

/* Where the row of a name is or would be, in the order of the alphabet. */
static size_t place_of(const bat_census *census, const char *name, bool *is_there)
{
    const row *rows = census->rows.items;
    size_t low = 0, high = census->rows.count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (strcmp(rows[middle].name, name) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    *is_there = low < census->rows.count && strcmp(rows[low].name, name) == 0;
    return low;
}

/* The row of a name, new when need be. */
static batten_status find(bat_input *input, bat_census *census, const char *name, row **out)
{
    row wanted = {.read = 0};
    bool is_there = false;
    snprintf(wanted.name, sizeof wanted.name, "%s", name);
    size_t at = place_of(census, wanted.name, &is_there);
    if (!is_there && census->rows.count >= MOST) {
        snprintf(wanted.name, sizeof wanted.name, "and others");
        at = place_of(census, wanted.name, &is_there);
    }
    if (!is_there) {
        batten_status status = bat_list_add(input, &census->rows, &wanted);
        if (status != BATTEN_OK)
            return status;
        row *rows = census->rows.items;
        memmove(&rows[at + 1], &rows[at], (census->rows.count - 1 - at) * sizeof *rows);
        rows[at] = wanted;
    }
    *out = (row *)census->rows.items + at;
    return BATTEN_OK;
}

batten_status bat_census_read(bat_input *input, bat_census *census, const char *name)
{
    row *found = NULL;
    batten_status status = find(input, census, name, &found);
    if (status == BATTEN_OK)
        found->read++;
    return status;
}

batten_status bat_census_leave(bat_input *input, bat_census *census, const char *name)
{
    row *found = NULL;
    batten_status status = find(input, census, name, &found);
    if (status == BATTEN_OK)
        found->left++;
    return status;
}

void bat_census_note(const bat_input *input, const bat_census *census)
{
    const row *rows = census->rows.items;
    for (size_t k = 0; k < census->rows.count; k++)
        if (rows[k].left == 0)
            batten_notes_remark(input->notes, input->file, 0, rows[k].name, "%d read",
                                rows[k].read);
        else
            batten_notes_add(input->notes, input->file, 0, rows[k].name, "%d read, %d left out",
                             rows[k].read, rows[k].left);
}
