/* A hull in panels: each takes its part of every station and the two lines that bound it; hull.c
 * holds its edges there. */
#include "loft/panels.h"

#include <string.h>

void bat_hull_panels_free(bat_hull_panels *panels)
{
    for (int k = 0; k < panels->count && panels->at; k++)
        bat_hull_release(panels->at + k);
    bat_release(panels->at);
    bat_release(panels->reached);
    if (panels->has_rails)
        bat_hull_rails_free(&panels->rails);
    *panels = (bat_hull_panels){0};
}

/* ---- making ---- */

static bool lies_on_centre(const bat_hull_station *s)
{
    int i = 0;
    while (i < s->count && s->points[i].y == 0)
        i++;
    return i == s->count;
}

/* The part of the stations between two lines; the points stay those of the hull. */
static batten_status take_part(const bat_hull_rails *r, int panel, bat_hull_table *part)
{
    const int n = r->of.station_count;
    const int *low = r->at + panel * n, *high = low + n;
    batten_status status = BATTEN_OK;
    part->table = r->of.table;
    part->station_count = n;
    part->stations = bat_arena_array(&part->arena, (size_t)n, sizeof *part->stations);
    if (!part->stations)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < n && status == BATTEN_OK; k++) {
        const bat_hull_station *whole = r->of.stations + k;
        bat_hull_station *s = part->stations + k;
        *s = (bat_hull_station){.x = whole->x,
                                .count = high[k] - low[k] + 1,
                                .points = whole->points + low[k],
                                .from = whole->from + low[k]};
        s->is_stem = lies_on_centre(s);
        s->v = bat_arena_array(&part->arena, (size_t)s->count, sizeof *s->v);
        status = s->v ? bat_hull_measure_girth(r->of.table, k, s) : BATTEN_OUT_OF_MEMORY;
    }
    if (status != BATTEN_OK)
        return status;
    bat_hull_count(part);
    part->breadth = r->of.breadth;
    part->least = r->of.least;
    return bat_hull_refuse_knuckles(part);
}

static batten_status make_panel(const bat_hull_rails *r, int panel, double within,
                                bat_loft *out)
{
    bat_hull_table part = {0};
    const bat_hull_edges edges = {r->inner_count, r->inner, r->rails + panel,
                                  r->rails + panel + 1, panel + 2 == r->count};
    batten_status status = take_part(r, panel, &part);
    if (status == BATTEN_OK)
        status = bat_hull_patch(&part, within, &edges, out);
    bat_arena_free(&part.arena);
    return status;
}

static batten_status make_panels(const batten_offset_table *table,
                                 const batten_loft_options *options, const batten_job *job,
                                 bat_hull_panels *p)
{
    batten_status status = BATTEN_OK;
    p->has_rails = options->knuckle_count > 0 || options->straight_count > 0;
    p->count = options->knuckle_count + 1;
    p->at = bat_array((size_t)p->count, sizeof *p->at);
    p->reached = bat_array((size_t)p->count, sizeof *p->reached);
    if (!p->at || !p->reached)
        return BATTEN_OUT_OF_MEMORY;
    if (!p->has_rails)
        return bat_hull_smooth(table, options->within, job, p->at);
    status = bat_hull_rails_make(table, options, &p->rails);
    for (int k = 0; k < p->count && status == BATTEN_OK; k++)
        status = make_panel(&p->rails, k, options->within, p->at + k);
    if (status == BATTEN_OK)
        p->at[0].trimmed = p->rails.of.trimmed;
    return status;
}

batten_status bat_hull_panels_make(const batten_offset_table *table,
                                   const batten_loft_options *options, const batten_job *job,
                                   bat_hull_panels *out)
{
    *out = (bat_hull_panels){0};
    const batten_status status = make_panels(table, options, job, out);
    for (int k = 0; k < out->count && status == BATTEN_OK; k++) {
        out->at[k].job = job;
        if (options->height > 0)
            out->at[k].height = options->height;
    }
    return status;
}

/* ---- making fair ---- */

/* The points of a line are data of the edge that lies on it. */
static void add_rail(const bat_hull_rails *r, int rail, double within, bat_loft *panel)
{
    const int n = r->of.station_count;
    const double aft = r->rails[rail].x[0], fore = r->rails[rail].x[1];
    for (int k = 0; k < n; k++) {
        const batten_table_point *p = bat_hull_rail_point(r, rail, k);
        panel->data[panel->datum_count++] =
            (bat_loft_datum){.point = {p->x, p->y, p->z},
                             .within = within,
                             .in_station = true,
                             .on_u_edge = k == 0 || k + 1 == n,
                             .on_v_edge = true,
                             .u = (p->x - aft) / (fore - aft),
                             .v = rail + 1 == r->count,
                             .station = k,
                             .index = r->of.stations[k].from[r->at[rail * n + k]]};
    }
}

/* Each line belongs to the panel above it, and the last to the one below: measured once, on what
 * is delivered. */
static batten_status add_rails(const bat_hull_panels *p, int k, bat_loft_reached *reached)
{
    bat_loft *panel = p->at + k;
    const bat_hull_rails *r = &p->rails;
    const size_t most = (size_t)panel->datum_count + 2 * (size_t)r->of.station_count;
    bat_loft_datum *grown = bat_resize(panel->data, most, sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    panel->data = grown;
    add_rail(r, k, panel->within, panel);
    if (k + 1 == p->count)
        add_rail(r, k + 1, panel->within, panel);
    bat_loft_find_feet(&panel->patch, panel->datum_count, panel->data, &reached->moves);
    return BATTEN_OK;
}

static batten_status run_panel(bat_hull_panels *p, int k)
{
    bat_loft *panel = p->at + k;
    bat_loft_reached *reached = p->reached + k;
    batten_status status =
        panel->datum_count > 0 ? bat_loft_run(panel, reached) : bat_loft_judge(panel, reached);
    if (status == BATTEN_OK && p->has_rails)
        status = add_rails(p, k, reached);
    if (status == BATTEN_OK && reached->moves.largest_part > 1)
        status = bat_fail(BATTEN_NOT_COMPATIBLE, "panel %d exceeds the bound to %g of it",
                          k + 1, reached->moves.largest_part);
    return status;
}

batten_status bat_hull_panels_run(bat_hull_panels *panels)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < panels->count && status == BATTEN_OK; k++)
        status = run_panel(panels, k);
    return status;
}

batten_status bat_hull_panels_fit(bat_hull_panels *panels)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < panels->count && status == BATTEN_OK; k++) {
        if (panels->at[k].datum_count > 0)
            status = bat_loft_fits(panels->at + k);
        if (status == BATTEN_OK && panels->has_rails)
            status = add_rails(panels, k, panels->reached + k);
    }
    return status;
}
