/* The corrections of a table: which points the surfaces left, how far, and why. */
#include "base/arena.h"
#include "base/sort.h"
#include "loft/report.h"
#include "numeric/vector.h"

#include <stdlib.h>

/* What moved by less than this part of its bound did not move but for rounding. */
static const double least_move = 1e-9;
/* Of the bound: points that lie farther hold the surface. */
static const double holding = 0.98;
/* In medians of all distances: a point that alone lies farther may be wrong. */
static const double standing_out = 5;

/* A line has its share of the bound in y and in z. */
bool bat_loft_holds(const bat_hull_panels *panels, const bat_loft *panel,
                    const bat_loft_datum *d)
{
    bat_loft_place place;
    if (!panels->has_rails || !d->on_v_edge)
        return d->move > holding * d->within;
    bat_loft_place_at(&panel->patch, d->u, d->v, &place);
    const double y = place.s[0][0][1] - d->point[1], z = place.s[0][0][2] - d->point[2];
    return bat_max(fabs(y), fabs(z)) > holding * sqrt(0.5) * d->within;
}

/* Where the surface is from each point. */
typedef struct {
    const batten_offset_table *table;
    bat_arena arena;
    int *first;      /* [stations]: number of its first point */
    double (*to)[3]; /* [points] */
    bool *known;     /* [points]: it belongs to a panel */
    double median;   /* of the distances */
} offs;

static batten_status take_room(offs *o, int *count)
{
    const int stations = batten_offset_table_station_count(o->table);
    *count = 0;
    o->first = bat_arena_array(&o->arena, (size_t)stations, sizeof *o->first);
    if (!o->first)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < stations; k++) {
        o->first[k] = *count;
        *count += batten_offset_table_station(o->table, k)->point_count;
    }
    o->to = bat_arena_array(&o->arena, (size_t)*count, sizeof *o->to);
    o->known = bat_arena_array(&o->arena, (size_t)*count, sizeof *o->known);
    return o->to && o->known ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status measure_offs(const bat_hull_panels *panels, offs *o)
{
    int count, found = 0;
    batten_status status = take_room(o, &count);
    double *distances = bat_arena_array(&o->arena, (size_t)count, sizeof *distances);
    if (status != BATTEN_OK || !distances)
        return BATTEN_OUT_OF_MEMORY;
    for (int p = 0; p < panels->count; p++)
        for (int k = 0; k < panels->at[p].datum_count; k++) {
            const bat_loft_datum *d = panels->at[p].data + k;
            const int at = o->first[d->station] + d->index;
            bat_loft_place place;
            bat_loft_place_at(&panels->at[p].patch, d->u, d->v, &place);
            for (int c = 0; c < 3; c++)
                o->to[at][c] = place.s[0][0][c] - d->point[c];
            o->known[at] = true;
            distances[found++] = d->move;
        }
    bat_sort_doubles((size_t)found, distances);
    o->median = distances[found / 2];
    return BATTEN_OK;
}

/* ---- why ---- */

/* The point of a station on a line, or -1. */
static int find_on_line(const offs *o, int station, int line)
{
    if (line < 0 || station < 0 || station >= batten_offset_table_station_count(o->table))
        return -1;
    const batten_table_station *s = batten_offset_table_station(o->table, station);
    for (int i = 0; i < s->point_count; i++)
        if (s->points[i].line == line)
            return i;
    return -1;
}

/* Does the surface lie to the other side of the neighbour? */
static bool differs(const offs *o, const double *own, int station, int index, int *asked)
{
    const int at = o->first[station] + index;
    if (!o->known[at])
        return true;
    ++*asked;
    return bat_dot(3, own, o->to[at]) < 0;
}

/* A point that alone is far off: its neighbours on the station and on its line are off to the other
 * side. */
static bool stands_out(const offs *o, const bat_loft_datum *d)
{
    enum { FEWEST_ASKED = 3 };
    const batten_table_station *s = batten_offset_table_station(o->table, d->station);
    const double *own = o->to[o->first[d->station] + d->index];
    int asked = 0;
    bool alone = d->move > standing_out * o->median;
    for (int side = -1; side <= 1 && alone; side += 2) {
        const int beside = d->index + side;
        const int along = find_on_line(o, d->station + side, s->points[d->index].line);
        if (beside >= 0 && beside < s->point_count)
            alone = differs(o, own, d->station, beside, &asked);
        if (alone && along >= 0)
            alone = differs(o, own, d->station + side, along, &asked);
    }
    return alone && asked >= FEWEST_ASKED;
}

/* ---- the list ---- */

static int farthest_first(const void *a, const void *b)
{
    const batten_loft_correction *p = a, *q = b;
    if (p->distance != q->distance)
        return p->distance < q->distance ? 1 : -1;
    return p->station != q->station ? p->station - q->station : p->index - q->index;
}

static void add_correction(const bat_hull_panels *panels, int panel, const bat_loft_datum *d,
                           const offs *o, batten_loft_report *report)
{
    const batten_table_point *to =
        batten_offset_table_station(report->faired, d->station)->points + d->index;
    if (d->move <= least_move * d->within)
        return;
    report->corrections[report->correction_count++] = (batten_loft_correction){
        .station = d->station,
        .index = d->index,
        .from = {d->point[0], d->point[1], d->point[2]},
        .to = {to->x, to->y, to->z},
        .distance = d->move,
        .reason = stands_out(o, d)                                ? BATTEN_LOFT_SUSPECT
                  : bat_loft_holds(panels, panels->at + panel, d) ? BATTEN_LOFT_BOUND
                                                                  : BATTEN_LOFT_NOISE};
}

batten_status bat_loft_correct(const bat_hull_panels *panels, const batten_offset_table *table,
                               batten_loft_report *report)
{
    offs o = {.table = table};
    batten_status status = measure_offs(panels, &o);
    int count = 0;
    for (int p = 0; p < panels->count; p++)
        count += panels->at[p].datum_count;
    report->corrections = bat_array((size_t)count, sizeof *report->corrections);
    if (!report->corrections)
        status = BATTEN_OUT_OF_MEMORY;
    for (int p = 0; p < panels->count && status == BATTEN_OK; p++)
        for (int k = 0; k < panels->at[p].datum_count; k++)
            add_correction(panels, p, panels->at[p].data + k, &o, report);
    if (status == BATTEN_OK) {
        qsort(report->corrections, (size_t)report->correction_count,
              sizeof *report->corrections, farthest_first);
    } else {
        bat_release(report->corrections);
        report->corrections = NULL;
    }
    bat_arena_free(&o.arena);
    return status;
}
