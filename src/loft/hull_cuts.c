/*
 * The cuts by which a hull is judged, and how many inflections its points require of each: of a
 * station, a waterline, the profile and the sheer those of the points within their bounds; of a
 * cut halfway the larger of its neighbours; of the others what the surface has.
 */
#include "base/list.h"
#include "base/sort.h"
#include "fair/fairness.h"
#include "loft/hull.h"

enum { BUTTOCKS = 12, DIAGONALS = 10, FEWEST_REQUIRED = 5, FEWEST_WATERLINES = 3 };

typedef struct {
    const batten_offset_table *table;
    int station_count;
    const bat_hull_station *stations;
    bat_loft *loft;
    int room;
    double *row; /* [2 * most points]: plane points of a cut */
    double low, high;
} cuts;

static batten_status add_cut(cuts *c, bat_loft_cut cut)
{
    return BAT_LIST_ADD(c->loft->cuts, c->loft->cut_count, c->room, cut);
}

/* What `count` points of the row require; of a few -1: not known. */
static batten_status required(const cuts *c, int count, int *needed)
{
    *needed = -1;
    if (count < FEWEST_REQUIRED)
        return BATTEN_OK;
    return bat_required_within(2, count, NULL, c->row, c->loft->within, needed);
}

/* ---- stations ---- */

static batten_status station_needs(const cuts *c, int k, int *needed)
{
    const bat_hull_station *s = c->stations + k;
    for (int i = 0; i < s->count; i++) {
        c->row[2 * i] = s->points[i].y;
        c->row[2 * i + 1] = s->points[i].z;
    }
    return required(c, s->count, needed);
}

static batten_status add_between(cuts *c, bat_loft_cut first, bat_loft_cut second)
{
    bat_loft_cut cut = first;
    cut.at = (first.at + second.at) / 2;
    cut.needed = -1;
    return add_cut(c, cut);
}

/* Of cuts first .. last, those that few points tell of need what the larger of their nearest
 * neighbours needs which more do; where no cut has points the surface is asked. */
static void ask_neighbours(cuts *c, int first)
{
    bat_loft_cut *at = c->loft->cuts;
    for (int k = first; k < c->loft->cut_count; k++)
        at[k].shaped = at[k].needed < 0; /* until all are known */
    for (int k = first; k < c->loft->cut_count; k++) {
        if (!at[k].shaped)
            continue;
        for (int i = k - 1; i >= first && at[k].needed < 0; i--)
            at[k].needed = at[i].shaped ? -1 : at[i].needed;
        for (int i = k + 1, asked = 0; i < c->loft->cut_count && !asked; i++)
            if ((asked = !at[i].shaped))
                at[k].needed = bat_max_int(at[k].needed, at[i].needed);
    }
    for (int k = first; k < c->loft->cut_count; k++)
        at[k].shaped = false;
}

static batten_status add_stations(cuts *c)
{
    const int first = c->loft->cut_count;
    bat_loft_cut before = {0};
    batten_status status = BATTEN_OK;
    for (int k = 0; k < c->station_count && status == BATTEN_OK; k++) {
        bat_loft_cut cut = {.kind = BAT_CUT_STATION, .m = {1}, .at = c->stations[k].x};
        if (c->stations[k].is_stem)
            continue;
        status = station_needs(c, k, &cut.needed);
        if (status == BATTEN_OK && before.m[0] == 1)
            status = add_between(c, before, cut);
        if (status == BATTEN_OK)
            status = add_cut(c, cut);
        before = cut;
    }
    ask_neighbours(c, first);
    return status;
}

/* ---- waterlines ---- */

static batten_status waterline_needs(const cuts *c, double z, int *needed)
{
    int count = 0;
    for (int k = 0; k < c->station_count; k++)
        for (int i = 0; i < c->stations[k].count; i++)
            if (c->stations[k].points[i].z == z) {
                c->row[2 * count] = c->stations[k].points[i].x;
                c->row[2 * count++ + 1] = c->stations[k].points[i].y;
                break;
            }
    return required(c, count, needed);
}

/* The heights of the table's waterlines, or even ones. */
static batten_status list_heights(const cuts *c, double **heights, int *count)
{
    const int lines = batten_offset_table_line_count(c->table), even = 9;
    double *z = bat_array((size_t)bat_max_int(lines, even), sizeof *z);
    *count = 0;
    if (!z)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < lines; k++)
        if (batten_offset_table_line(c->table, k)->is_waterline)
            z[(*count)++] = batten_offset_table_line(c->table, k)->z;
    if (*count < FEWEST_WATERLINES)
        for (*count = 0; *count < even; ++*count)
            z[*count] = c->low + (c->high - c->low) * (*count + 1) / (even + 1);
    bat_sort_doubles((size_t)*count, z);
    *heights = z;
    return BATTEN_OK;
}

static batten_status add_waterlines(cuts *c)
{
    const int first = c->loft->cut_count;
    double *heights = NULL;
    int count = 0;
    bat_loft_cut before = {0};
    batten_status status = list_heights(c, &heights, &count);
    for (int k = 0; k < count && status == BATTEN_OK; k++) {
        bat_loft_cut cut = {.kind = BAT_CUT_WATERLINE, .m = {0, 0, 1}, .at = heights[k]};
        status = waterline_needs(c, heights[k], &cut.needed);
        if (status == BATTEN_OK && k > 0)
            status = add_between(c, before, cut);
        if (status == BATTEN_OK)
            status = add_cut(c, cut);
        before = cut;
    }
    ask_neighbours(c, first);
    bat_release(heights);
    return status;
}

/* ---- buttocks, diagonals, edges ---- */

static batten_status add_buttocks(cuts *c)
{
    batten_status status = BATTEN_OK;
    for (int k = 1; k <= BUTTOCKS && status == BATTEN_OK; k++)
        status = add_cut(c, (bat_loft_cut){.kind = BAT_CUT_BUTTOCK,
                                           .m = {0, 1, 0},
                                           .at = c->loft->breadth * k / (BUTTOCKS + 1),
                                           .needed = -1});
    return status;
}

/* Planes through lines of the centre plane, falling outwards by an angle. */
static batten_status add_diagonals(cuts *c, double angle)
{
    const double top = c->high + c->loft->breadth * bat_tan(angle);
    batten_status status = BATTEN_OK;
    for (int k = 1; k <= DIAGONALS && status == BATTEN_OK; k++) {
        const double z = c->low + (top - c->low) * k / (DIAGONALS + 1);
        status = add_cut(c, (bat_loft_cut){.kind = BAT_CUT_DIAGONAL,
                                           .m = {0, bat_sin(angle), bat_cos(angle)},
                                           .at = z * bat_cos(angle),
                                           .needed = -1});
    }
    return status;
}

/* An edge from the side (axis 1) or from above (axis 2). */
static batten_status add_edge(cuts *c, bat_cut_kind kind, int axis)
{
    bat_loft_cut cut = {.kind = kind};
    cut.m[axis] = 1;
    for (int k = 0; k < c->station_count; k++) {
        const bat_hull_station *s = c->stations + k;
        const batten_table_point *p = s->points + (kind == BAT_CUT_SHEER ? s->count - 1 : 0);
        c->row[2 * k] = p->x;
        c->row[2 * k + 1] = axis == 1 ? p->z : p->y;
    }
    const batten_status status = required(c, c->station_count, &cut.needed);
    return status == BATTEN_OK ? add_cut(c, cut) : status;
}

static batten_status add_edges(cuts *c)
{
    batten_status status = add_edge(c, BAT_CUT_PROFILE, 1);
    if (status == BATTEN_OK)
        status = add_edge(c, BAT_CUT_SHEER, 1);
    if (status == BATTEN_OK)
        status = add_edge(c, BAT_CUT_SHEER, 2);
    return status;
}

/* An edge that is faired already, from the side and from above. */
static batten_status add_rail(cuts *c, bat_cut_kind kind, const bat_hull_rail *rail)
{
    batten_status status = BATTEN_OK;
    for (int axis = 1; axis <= 2 && status == BATTEN_OK; axis++) {
        bat_loft_cut cut = {.kind = kind, .needed = rail->needed[axis == 1]};
        cut.m[axis] = 1;
        status = add_cut(c, cut);
    }
    return status;
}

static batten_status add_rails(cuts *c, const bat_hull_edges *edges)
{
    batten_status status = add_rail(c, BAT_CUT_PROFILE, edges->low);
    return status == BATTEN_OK && edges->is_top ? add_rail(c, BAT_CUT_SHEER, edges->high)
                                                : status;
}

static batten_status add_sections(cuts *c)
{
    batten_status status = add_stations(c);
    if (status == BATTEN_OK)
        status = add_waterlines(c);
    if (status == BATTEN_OK)
        status = add_buttocks(c);
    if (status == BATTEN_OK)
        status = add_diagonals(c, BAT_PI / 6);
    if (status == BATTEN_OK)
        status = add_diagonals(c, BAT_PI / 4);
    return status;
}

/* The foot and the top of a graph are waterlines: seen from above. */
static batten_status add_levels(cuts *c)
{
    batten_status status = BATTEN_OK;
    for (int top = 0; top <= 1 && status == BATTEN_OK; top++) {
        bat_loft_cut cut = {.kind = top ? BAT_CUT_SHEER : BAT_CUT_PROFILE, .m = {0, 0, 1}};
        status = waterline_needs(c, top ? c->high : c->low, &cut.needed);
        if (status == BATTEN_OK)
            status = add_cut(c, cut);
    }
    return status;
}

batten_status bat_hull_cuts(const bat_hull_table *table, const bat_hull_edges *edges,
                            bat_loft *loft)
{
    const int count = table->station_count;
    cuts c = {table->table, count, table->stations, loft, 0, NULL, HUGE_VAL, -HUGE_VAL};
    const int most = bat_max_int(count, table->most_points);
    for (int k = 0; k < count; k++) {
        const bat_hull_station *s = table->stations + k;
        if (s->count == 0)
            continue;
        c.low = bat_min(c.low, s->points[0].z);
        c.high = bat_max(c.high, s->points[s->count - 1].z);
    }
    c.row = bat_array((size_t)most, 2 * sizeof *c.row);
    batten_status status = c.row ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && (!edges || loft->datum_count > 0))
        status = add_sections(&c);
    if (status == BATTEN_OK)
        status = edges ? add_rails(&c, edges) : loft->is_graph ? add_levels(&c) : add_edges(&c);
    bat_release(c.row);
    return status;
}
