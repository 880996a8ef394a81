/* The lines of a table of offsets, in the order in which its stations meet them. */
#include "exchange/csv/gather_lines.h"
#include <stdlib.h>
#include <string.h>

/* ---- lines ---- */

int bat_gather_compare(double a, double b)
{
    return (a > b) - (a < b);
}

int bat_gather_compare_order(size_t a, size_t b)
{
    return (a > b) - (a < b);
}

/* Points of one line together: by name, or where they have none by height. */
static int by_line(const void *a, const void *b)
{
    const bat_gather_sorted *p = a, *q = b;
    const bool named = p->point.line && q->point.line;
    int order = (q->point.line != NULL) - (p->point.line != NULL);
    if (order == 0 && named)
        order = strcmp(p->point.line, q->point.line);
    return order ? order : bat_gather_compare(p->point.z, q->point.z);
}

static bool same_line(const bat_gathered *a, const bat_gathered *b)
{
    if (a->line && b->line)
        return strcmp(a->line, b->line) == 0;
    return !a->line && !b->line && a->z == b->z;
}

static double mean_height(const bat_gather_sorted *points, size_t begin, size_t end)
{
    double sum = 0;
    for (size_t i = begin; i < end; i++)
        sum += points[i].point.z / (double)(end - begin);
    return sum;
}

static bat_gather_line measure_line(const bat_gather_sorted *points, size_t begin, size_t end)
{
    const double low = points[begin].point.z;
    const bool level = low == points[end - 1].point.z;
    return (bat_gather_line){.name = points[begin].point.line,
                             .is_waterline = level,
                             .z = level ? low + 0.0 : 0, /* never -0 */
                             .rank = level ? low : mean_height(points, begin, end),
                             .members = begin,
                             .count = end - begin};
}

static int by_rank(const void *a, const void *b)
{
    const bat_gather_line *p = a, *q = b;
    const int order = bat_gather_compare(p->rank, q->rank);
    return order ? order : strcmp(p->name ? p->name : "", q->name ? q->name : "");
}

/* Where the line that begins at `begin` ends. */
static size_t end_of_line(const bat_gather_table *t, size_t begin)
{
    size_t end = begin + 1;
    while (end < t->count && same_line(&t->points[begin].point, &t->points[end].point))
        end++;
    return end;
}

batten_status bat_gather_find_lines(bat_gather_table *t)
{
    bat_input *input = t->from->input;
    size_t count = 0;
    qsort(t->points, t->count, sizeof *t->points, by_line);
    for (size_t begin = 0; begin < t->count; begin = end_of_line(t, begin))
        count += t->points[begin].point.line || t->from->by_height;
    batten_status status = bat_input_array(input, count, sizeof *t->lines, &t->lines);
    if (status == BATTEN_OK)
        status = bat_input_array(input, count, sizeof *t->offset_lines, &t->offset_lines);
    if (status == BATTEN_OK)
        status = bat_input_array(input, count, sizeof *t->line_texts, &t->line_texts);
    if (status != BATTEN_OK)
        return status;

    for (size_t begin = 0, end; begin < t->count; begin = end) {
        end = end_of_line(t, begin);
        if (t->points[begin].point.line || t->from->by_height)
            t->lines[t->line_count++] = measure_line(t->points, begin, end);
    }
    qsort(t->lines, t->line_count, sizeof *t->lines, by_rank);
    for (size_t k = 0; k < t->line_count; k++)
        for (size_t i = 0; i < t->lines[k].count; i++) {
            t->points[t->lines[k].members + i].line = (int)k;
            t->points[t->lines[k].members + i].rank = t->lines[k].rank;
        }
    return BATTEN_OK;
}

void bat_gather_make_lines(bat_gather_table *t)
{
    for (size_t k = 0; k < t->line_count; k++) {
        const bat_gather_line *line = &t->lines[k];
        memcpy(t->line_texts[k], "z=", 2);
        batten_number_write(line->z, t->line_texts[k] + 2);
        t->offset_lines[k] =
            (batten_table_line){.name = line->name ? line->name : t->line_texts[k],
                                .is_waterline = line->is_waterline,
                                .z = line->z};
    }
}
