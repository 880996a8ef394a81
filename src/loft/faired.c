/* The faired table: a copy of the given one whose points are read off the surfaces. */
#include "loft/faired.h"
#include "base/arena.h"
#include "numeric/vector.h"

typedef struct {
    const batten_offset_table *table;
    bat_arena arena;
    batten_table_line *lines;
    batten_table_station *stations;
    batten_table_point **points; /* [stations]: copies */
    double size, error;
} copy;

static batten_status copy_table(copy *c)
{
    const int lines = batten_offset_table_line_count(c->table),
              stations = batten_offset_table_station_count(c->table);
    c->lines = bat_arena_array(&c->arena, (size_t)lines, sizeof *c->lines);
    c->stations = bat_arena_array(&c->arena, (size_t)stations, sizeof *c->stations);
    c->points = bat_arena_array(&c->arena, (size_t)stations, sizeof *c->points);
    if (!c->lines || !c->stations || !c->points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < lines; i++)
        c->lines[i] = *batten_offset_table_line(c->table, i);
    for (int k = 0; k < stations; k++) {
        const batten_table_station *s = batten_offset_table_station(c->table, k);
        const size_t count = (size_t)s->point_count;
        c->points[k] = bat_arena_array(&c->arena, count, sizeof *c->points[k]);
        if (!c->points[k])
            return BATTEN_OUT_OF_MEMORY;
        memcpy(c->points[k], s->points, count * sizeof *c->points[k]);
        c->stations[k] = *s;
        c->stations[k].points = c->points[k];
    }
    return BATTEN_OK;
}

/* What is within rounding of its plane is written as on it. */
static double on_plane(const copy *c, double value, double plane)
{
    return fabs(value - plane) <= 1e-9 * c->size ? plane : value;
}

static void read_point(copy *c, const bat_loft *panel, const bat_loft_datum *d)
{
    batten_table_point *p = c->points[d->station] + d->index;
    const batten_table_line *line = p->line >= 0 ? c->lines + p->line : NULL;
    double to[3];
    const bool level =
        line && batten_offset_table_line(c->table, p->line)->is_waterline && p->z == line->z;
    const double off = bat_loft_read_off(&panel->patch, d, level ? line : NULL, to);
    p->x = on_plane(c, to[0], p->x);
    p->y = to[1];
    p->z = level ? on_plane(c, to[2], line->z) : to[2];
    if (level && p->z != line->z)
        c->lines[p->line].is_waterline = false;
    c->error = bat_max(c->error, off);
}

batten_status bat_loft_faired_table(const bat_hull_panels *panels,
                                    const batten_offset_table *table, batten_offset_table **out,
                                    double *error)
{
    const batten_box box = batten_offset_table_box(table);
    copy c = {.table = table, .size = bat_distance(3, &box.low.x, &box.high.x)};
    batten_status status = copy_table(&c);
    for (int p = 0; p < panels->count && status == BATTEN_OK; p++)
        for (int k = 0; k < panels->at[p].datum_count; k++)
            read_point(&c, panels->at + p, panels->at[p].data + k);
    if (status == BATTEN_OK)
        status = batten_offset_table_create(
            batten_offset_table_unit_metres(table), batten_offset_table_line_count(table),
            c.lines, batten_offset_table_station_count(table), c.stations, out);
    if (status == BATTEN_OK)
        *error = c.error;
    bat_arena_free(&c.arena);
    return status;
}
