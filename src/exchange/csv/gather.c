/* A table of offsets from points in any order: lines, stations, and the table of them. */
#include "exchange/csv/gather_lines.h"
#include <batten/text.h>
#include <stdlib.h>
#include <string.h>

void bat_gather_begin(bat_gathering *gathering, bat_input *input)
{
    *gathering = (bat_gathering){.input = input,
                                 .points = {.size = sizeof(bat_gathered)},
                                 .names = {.size = sizeof(char *)}};
}

void bat_gather_end(bat_gathering *gathering)
{
    char *const *names = gathering->names.items;
    for (size_t i = 0; i < gathering->names.count; i++)
        bat_release(names[i]);
    bat_release(gathering->names.items);
    bat_release(gathering->points.items);
}

batten_status bat_gather_name(bat_gathering *gathering, const char *text, const char **name)
{
    const size_t size = strlen(text) + 1;
    char *kept = NULL;
    batten_status status = bat_input_array(gathering->input, size, 1, &kept);
    if (status != BATTEN_OK)
        return status;
    memcpy(kept, text, size);
    status = bat_list_add(gathering->input, &gathering->names, &kept);
    if (status == BATTEN_OK)
        *name = kept;
    else
        bat_release(kept);
    return status;
}

batten_status bat_gather_point(bat_gathering *gathering, const bat_gathered *point)
{
    batten_status status =
        bat_input_limit(gathering->input, point->row, gathering->points.count + 1,
                        gathering->input->limits.points, "points in the table");
    return status == BATTEN_OK ? bat_list_add(gathering->input, &gathering->points, point)
                               : status;
}

/* ---- stations ---- */

static int by_station(const void *a, const void *b)
{
    const bat_gather_sorted *p = a, *q = b;
    int order = bat_gather_compare(p->point.station, q->point.station);
    if (order == 0)
        order = bat_gather_compare(p->rank, q->rank);
    if (order == 0)
        order = (p->line > q->line) - (p->line < q->line);
    return order ? order : bat_gather_compare_order(p->order, q->order);
}

/* Two neighbours of one station and one line: only a waterline may come twice, and not twice to
 * the same point. */
static batten_status check_twice(const bat_gather_table *t, const bat_gather_sorted *p,
                                 const bat_gather_sorted *q)
{
    if (p->point.station != q->point.station || p->line != q->line)
        return BATTEN_OK;
    const bool same =
        p->point.y == q->point.y && p->point.z == q->point.z && p->point.x == q->point.x;
    if (!same && (p->line < 0 || t->lines[p->line].is_waterline))
        return BATTEN_OK;
    return bat_input_fail(
        t->from->input, BATTEN_BAD_FORMAT, q->point.row,
        "station x = %g has a second point on %s%s%s, at height %g; the first "
        "is in line %d",
        q->point.station, q->point.line ? "line '" : "the same place",
        q->point.line ? q->point.line : "", q->point.line ? "'" : "", q->point.z, p->point.row);
}

/* Two columns or rows of the table that say the same x. */
static batten_status check_source(const bat_gather_table *t, size_t begin, size_t i)
{
    const bat_gathered *first = &t->points[begin].point, *point = &t->points[i].point;
    if (point->source == first->source)
        return BATTEN_OK;
    return bat_input_fail(
        t->from->input, BATTEN_BAD_FORMAT, bat_max_int(first->row, point->row),
        "station x = %g appears twice in the table, as numbers %d and %d", point->station,
        bat_min_int(first->source, point->source), bat_max_int(first->source, point->source));
}

/* The name among the points begin .. end - 1 of one station, or NULL. */
static batten_status name_of_station(const bat_gather_table *t, size_t begin, size_t end,
                                     const char **name)
{
    const bat_gather_sorted *first = NULL;
    for (size_t i = begin; i < end; i++) {
        const bat_gather_sorted *p = &t->points[i];
        if (first && p->point.station_name &&
            strcmp(first->point.station_name, p->point.station_name) != 0)
            return bat_input_fail(
                t->from->input, BATTEN_BAD_FORMAT, bat_max_int(first->point.row, p->point.row),
                "station '%.40s' stands at x = %g, where '%.40s' of line %d is",
                p->point.station_name, p->point.station, first->point.station_name,
                bat_min_int(first->point.row, p->point.row));
        if (!first && p->point.station_name)
            first = p;
    }
    *name = first ? first->point.station_name : NULL;
    return BATTEN_OK;
}

static batten_status make_station(bat_gather_table *t, size_t begin, size_t end)
{
    const char *name = NULL;
    batten_status status = name_of_station(t, begin, end, &name);
    for (size_t i = begin; status == BATTEN_OK && i < end; i++) {
        const bat_gather_sorted *p = &t->points[i];
        status = check_source(t, begin, i);
        if (status == BATTEN_OK && i > begin)
            status = check_twice(t, p - 1, p);
        t->offset_points[i] = (batten_table_point){p->point.x, p->point.y, p->point.z, p->line};
    }
    if (status != BATTEN_OK)
        return status;
    char *text = t->station_texts[t->station_count];
    const double x = t->points[begin].point.station + 0.0; /* never -0 */
    batten_number_write(x, text);
    t->stations[t->station_count++] =
        (batten_table_station){.name = name ? name : text,
                               .x = x,
                               .point_count = (int)(end - begin),
                               .points = &t->offset_points[begin]};
    return BATTEN_OK;
}

/* Where the station that begins at `begin` ends. */
static size_t end_of_station(const bat_gather_table *t, size_t begin)
{
    size_t end = begin + 1;
    while (end < t->count && t->points[end].point.station == t->points[begin].point.station)
        end++;
    return end;
}

/* The rank is then the place in the file. */
static void rank_by_order(bat_gather_table *t)
{
    for (size_t i = 0; i < t->count; i++)
        t->points[i].rank = (double)t->points[i].order;
    qsort(t->points, t->count, sizeof *t->points, by_station);
}

/* Sort by stations. As listed: points of one line together while those that come twice are
 * sought. */
static batten_status sort_stations(bat_gather_table *t)
{
    batten_status status = BATTEN_OK;
    qsort(t->points, t->count, sizeof *t->points, by_station);
    if (!t->from->as_listed)
        return BATTEN_OK;
    for (size_t i = 1; status == BATTEN_OK && i < t->count; i++)
        status = check_twice(t, &t->points[i - 1], &t->points[i]);
    rank_by_order(t);
    return status;
}

static batten_status make_stations(bat_gather_table *t)
{
    bat_input *input = t->from->input;
    size_t count = 0;
    batten_status status = sort_stations(t);
    if (status != BATTEN_OK)
        return status;
    for (size_t begin = 0; begin < t->count; begin = end_of_station(t, begin))
        count++;
    status = bat_input_array(input, count, sizeof *t->stations, &t->stations);
    if (status == BATTEN_OK)
        status = bat_input_array(input, count, sizeof *t->station_texts, &t->station_texts);
    for (size_t begin = 0, end; status == BATTEN_OK && begin < t->count; begin = end) {
        end = end_of_station(t, begin);
        status = make_station(t, begin, end);
    }
    return status;
}

/* ---- the whole ---- */

/* Those of a station together, as they came. */
static int by_station_alone(const void *a, const void *b)
{
    const bat_gather_sorted *p = a, *q = b;
    const int order = bat_gather_compare(p->point.station, q->point.station);
    return order ? order : bat_gather_compare_order(p->order, q->order);
}

/* Say which stations have no points, and whether the stations come in the order of x. */
static void note_stations(const bat_gather_table *t)
{
    const bat_input *input = t->from->input;
    bool sorted = true;
    size_t last = 0;
    for (size_t begin = 0, end; begin < t->count; begin = end) {
        const bat_gather_sorted *first = &t->points[begin];
        bool any = false;
        end = end_of_station(t, begin);
        for (size_t i = begin; i < end; i++)
            any |= !t->points[i].point.is_absent;
        if (!any)
            batten_notes_add(input->notes, input->file, first->point.row, "",
                             "station x = %g has no points; left out", first->point.station);
        sorted &= first->order >= last;
        last = first->order;
    }
    if (!sorted)
        batten_notes_add(input->notes, input->file, 0, "",
                         "the stations do not come in the order of x; sorted");
}

static void drop_absent(bat_gather_table *t)
{
    size_t kept = 0;
    qsort(t->points, t->count, sizeof *t->points, by_station_alone);
    note_stations(t);
    for (size_t i = 0; i < t->count; i++)
        if (!t->points[i].point.is_absent)
            t->points[kept++] = t->points[i];
    t->count = kept;
}

static void release(bat_gather_table *t)
{
    bat_release(t->station_texts);
    bat_release(t->line_texts);
    bat_release(t->stations);
    bat_release(t->offset_points);
    bat_release(t->offset_lines);
    bat_release(t->lines);
    bat_release(t->points);
}

static batten_status make_model(double unit_metres, const batten_offset_table *offsets,
                                batten_model **out)
{
    const batten_object object = {
        .name = "offsets", .kind = BATTEN_OBJECT_OFFSET_TABLE, .offset_table = offsets};
    batten_model *model = NULL;
    batten_status status = batten_model_create(unit_metres, &model);
    if (status == BATTEN_OK)
        status = batten_model_add(model, &object);
    return bat_input_hand_over(status, model, out);
}

/* The points that are there, ready for sorting. */
static batten_status take_points(bat_gather_table *t)
{
    const bat_gathered *points = t->from->points.items;
    bat_input *input = t->from->input;
    t->count = t->from->points.count;
    batten_status status = bat_input_array(input, t->count, sizeof *t->points, &t->points);
    if (status != BATTEN_OK)
        return status;
    for (size_t i = 0; i < t->count; i++)
        t->points[i] = (bat_gather_sorted){points[i], i, -1, points[i].z};
    drop_absent(t);
    if (t->count == 0)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "there is no point in the table");
    return bat_input_array(input, t->count, sizeof *t->offset_points, &t->offset_points);
}

/* *row is the first of them. */
static int count_negative(const bat_gathering *gathering, int *row)
{
    const bat_gathered *points = gathering->points.items;
    int count = 0;
    for (size_t i = 0; i < gathering->points.count; i++) {
        if (points[i].is_absent || !(points[i].y < 0))
            continue;
        *row = count == 0 ? points[i].row : *row;
        count++;
    }
    return count;
}

/* A half-breadth is a distance from the centre plane. */
static void note_negative(const bat_gathering *gathering)
{
    int row = 0;
    const int count = count_negative(gathering, &row);
    if (count > 0)
        batten_notes_add(gathering->input->notes, gathering->input->file, row, "",
                         "%d half-breadth%s below 0, here the first; %s kept as %s", count,
                         count == 1 ? " is" : "s are", count == 1 ? "it is" : "they are",
                         count == 1 ? "it is" : "they are");
}

batten_status bat_gather_finish(bat_gathering *gathering, batten_model **out)
{
    bat_gather_table t = {.from = gathering};
    batten_offset_table *offsets = NULL;
    batten_status status = take_points(&t);
    if (status == BATTEN_OK)
        status = bat_gather_find_lines(&t);
    if (status == BATTEN_OK) {
        bat_gather_make_lines(&t);
        status = make_stations(&t);
    }
    if (status == BATTEN_OK)
        status =
            batten_offset_table_create(gathering->unit_metres, (int)t.line_count,
                                       t.offset_lines, t.station_count, t.stations, &offsets);
    if (status == BATTEN_OK)
        note_negative(gathering);
    if (status == BATTEN_OK)
        status = make_model(gathering->unit_metres, offsets, out);
    batten_offset_table_unref(offsets);
    release(&t);
    return status;
}
