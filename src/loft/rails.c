/*
 * The lines along which a hull is cut into panels. Each is found in the table by its name, and
 * made fair as two functions of u, which runs linearly with x: the panels on both sides take the
 * same coefficients.
 */
#include "loft/rails.h"
#include "fair/fairness.h"
#include "loft/lines/line.h"
#include "model/offset_table.h"

#include <string.h>

void bat_hull_rails_free(bat_hull_rails *rails)
{
    bat_arena_free(&rails->of.arena);
    *rails = (bat_hull_rails){0};
}

/* ---- which lines ---- */

/* The lines as they are declared: the lower edge, the knuckles, the upper edge. */
static batten_status find_lines(const batten_loft_options *options, bat_hull_rails *r)
{
    const int last = r->count - 1;
    batten_status status = BATTEN_OK;
    r->line[0] = r->line[last] = -1;
    for (int k = 0; k < options->knuckle_count && status == BATTEN_OK; k++)
        status = bat_offset_table_find_line(r->of.table, options->knuckles[k], &r->line[k + 1]);
    for (int k = 1; k < r->count && status == BATTEN_OK; k++)
        for (int i = 0; i < k; i++)
            if (r->line[k] >= 0 && r->line[k] == r->line[i])
                return bat_fail(BATTEN_BAD_ARGUMENT, "the line '%.60s' is declared twice",
                                bat_hull_rail_name(r, k));
    return status;
}

/* ---- where they are ---- */

static batten_status place_at(bat_hull_rails *r, int rail, int k)
{
    const bat_hull_station *s = r->of.stations + k;
    int at = rail == 0 ? 0 : s->count - 1;
    if (r->line[rail] >= 0) {
        at = 0;
        while (at < s->count && s->points[at].line != r->line[rail])
            at++;
    }
    if (at == s->count)
        return bat_fail(BATTEN_NOT_FOUND,
                        "the line '%.60s' has no point at %s; a line that "
                        "bounds a panel has one at every station",
                        bat_hull_rail_name(r, rail),
                        batten_offset_table_label(r->of.table, k).text);
    r->at[rail * r->of.station_count + k] = at;
    return BATTEN_OK;
}

/* Knuckles may be declared in any order: the first station sorts them. */
static void sort_knuckles(bat_hull_rails *r)
{
    const int n = r->of.station_count;
    for (int k = 2; k + 1 < r->count; k++)
        for (int i = k; i > 1 && r->at[i * n] < r->at[(i - 1) * n]; i--) {
            const int line = r->line[i], at = r->at[i * n];
            r->line[i] = r->line[i - 1];
            r->at[i * n] = r->at[(i - 1) * n];
            r->line[i - 1] = line;
            r->at[(i - 1) * n] = at;
        }
}

/* A knuckle that is an edge of the hull, or lines in another order than at the first station. */
static batten_status refuse_order(const bat_hull_rails *r, int rail, int k)
{
    const int n = r->of.station_count;
    if (r->at[rail * n + k] == r->at[(rail - 1) * n + k])
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "the line '%.60s' is the %s edge of the hull at %s, less "
            "what lies below it on the centre plane; a knuckle has a panel on either "
            "side",
            bat_hull_rail_name(r, rail == 1 ? rail : rail - 1), rail == 1 ? "lower" : "upper",
            batten_offset_table_label(r->of.table, k).text);
    return bat_fail(
        BATTEN_BAD_ARGUMENT, "the line '%.60s' is not above the line '%.60s' at %s%s",
        bat_hull_rail_name(r, rail), bat_hull_rail_name(r, rail - 1),
        batten_offset_table_label(r->of.table, k).text, k > 0 ? ", as it is at the first" : "");
}

static batten_status place_lines(bat_hull_rails *r)
{
    batten_status status = BATTEN_OK;
    const int n = r->of.station_count;
    for (int rail = 0; rail < r->count && status == BATTEN_OK; rail++)
        status = place_at(r, rail, 0);
    sort_knuckles(r);
    for (int rail = 0; rail < r->count && status == BATTEN_OK; rail++)
        for (int k = 1; k < n && status == BATTEN_OK; k++)
            status = place_at(r, rail, k);
    for (int rail = 1; rail < r->count && status == BATTEN_OK; rail++)
        for (int k = 0; k < n; k++)
            if (r->at[rail * n + k] <= r->at[(rail - 1) * n + k])
                return refuse_order(r, rail, k);
    return status;
}

/* What lies beyond the edges does not belong to the hull. */
static void trim_stations(bat_hull_rails *r)
{
    const int n = r->of.station_count, last = r->count - 1;
    for (int k = 0; k < n; k++) {
        bat_hull_station *s = r->of.stations + k;
        const int first = r->at[k], count = r->at[last * n + k] - first + 1;
        r->of.trimmed += s->count - count;
        s->points += first;
        s->from += first;
        s->count = count;
        for (int rail = 0; rail < r->count; rail++)
            r->at[rail * n + k] -= first;
    }
    bat_hull_count(&r->of);
}

/* ---- their knots ---- */

/* At the stations of the sheer; few stations want knots halfway too, to bend between them. */
static batten_status set_knots(bat_hull_rails *r)
{
    enum { MANY = 14 };
    const int n = r->of.station_count, top = r->count - 1;
    r->inner = bat_arena_array(&r->of.arena, 2 * (size_t)n, sizeof *r->inner);
    if (!r->inner)
        return BATTEN_OUT_OF_MEMORY;
    for (int rail = 0; rail <= top; rail++)
        for (int k = 1; k < n; k++)
            if (!(bat_hull_rail_u(r, rail, k) > bat_hull_rail_u(r, rail, k - 1)))
                return bat_fail(BATTEN_NOT_INCREASING,
                                "the line '%.60s' does not run forward from %s to %s",
                                bat_hull_rail_name(r, rail),
                                batten_offset_table_label(r->of.table, k - 1).text,
                                batten_offset_table_label(r->of.table, k).text);
    for (int k = 1; k < n; k++) {
        if (n < MANY)
            r->inner[r->inner_count++] =
                (bat_hull_rail_u(r, top, k - 1) + bat_hull_rail_u(r, top, k)) / 2;
        if (k + 1 < n)
            r->inner[r->inner_count++] = bat_hull_rail_u(r, top, k);
    }
    return BATTEN_OK;
}

/* ---- fairing ---- */

static bool is_constant(int count, const double *values)
{
    int k = 1;
    while (k < count && values[k] == values[0])
        k++;
    return k == count;
}

/* Do all points of an end lie at one half-breadth, as on a stem? */
static bool is_stem(const bat_hull_station *s)
{
    int i = 1;
    while (i < s->count && s->points[i].y == s->points[0].y)
        i++;
    return i == s->count;
}

static void take_values(const bat_hull_rails *r, int rail, int axis, double *values)
{
    for (int k = 0; k < r->of.station_count; k++) {
        const batten_table_point *p = bat_hull_rail_point(r, rail, k);
        values[k] = axis == 0 ? p->y : p->z;
    }
}

/* One coordinate, y or z, of a rail, in the memory that its line has. */
static batten_status fair_coordinate(bat_hull_rails *r, const batten_loft_options *options,
                                     int rail, int axis)
{
    const int n = r->of.station_count;
    bat_hull_rail *made = r->rails + rail;
    bat_loft_line *line = r->lines + 2 * rail + axis;
    if (axis == 0) {
        line->one_side = r->of.least > -options->within; /* as of a patch */
        line->pinned[0] = is_stem(r->of.stations);
        line->pinned[1] = is_stem(r->of.stations + n - 1);
    }
    batten_status status =
        bat_required_within(1, n, line->t, line->values, line->within, &line->changes);
    made->needed[axis] = line->changes;
    if (status == BATTEN_OK)
        status = bat_hull_find_runs(r, options, rail, axis, line);
    if (status == BATTEN_OK)
        status = bat_loft_line_fair(line, made->yz[axis], &made->found[axis]);
    if (status == BATTEN_NOT_COMPATIBLE && line->run_count > 0)
        status = bat_hull_explain_runs(r, options, rail, axis, line);
    return status;
}

/* Both coordinates share the bound, unless one of them is the same at all stations. */
static void share_bound(bat_loft_line lines[2], double within)
{
    const bool constant = is_constant(lines[0].datum_count, lines[0].values) ||
                          is_constant(lines[1].datum_count, lines[1].values);
    lines[0].within = lines[1].within = within * (constant ? 1 : sqrt(0.5));
}

static batten_status take_line(bat_hull_rails *r, int rail, int axis, bat_loft_line *line)
{
    const size_t n = (size_t)r->of.station_count;
    bat_hull_rail *made = r->rails + rail;
    double *t = bat_arena_array(&r->of.arena, n, sizeof *t);
    double *values = bat_arena_array(&r->of.arena, n, sizeof *values);
    made->yz[axis] = bat_arena_array(&r->of.arena, (size_t)line->count, sizeof *made->yz[axis]);
    if (!t || !values || !made->yz[axis])
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < r->of.station_count; k++)
        t[k] = bat_hull_rail_u(r, rail, k);
    take_values(r, rail, axis, values);
    line->t = t;
    line->values = values;
    return BATTEN_OK;
}

static batten_status fair_rail(bat_hull_rails *r, const batten_loft_options *options, int rail,
                               const bat_loft_line *like)
{
    bat_hull_rail *made = r->rails + rail;
    bat_loft_line *lines = r->lines + 2 * rail;
    batten_status status = BATTEN_OK;
    made->x[0] = bat_hull_rail_point(r, rail, 0)->x;
    made->x[1] = bat_hull_rail_point(r, rail, r->of.station_count - 1)->x;
    for (int axis = 0; axis < 2 && status == BATTEN_OK; axis++) {
        lines[axis] = *like;
        lines[axis].length = fabs(made->x[1] - made->x[0]);
        status = take_line(r, rail, axis, lines + axis);
    }
    if (status == BATTEN_OK)
        share_bound(lines, options->within);
    for (int axis = 0; axis < 2 && status == BATTEN_OK; axis++)
        status = fair_coordinate(r, options, rail, axis);
    return status;
}

static batten_status fair_rails(bat_hull_rails *r, const batten_loft_options *options,
                                double height)
{
    const int count = r->inner_count + BAT_LOFT_SUPPORT;
    double *knots =
        bat_arena_array(&r->of.arena, (size_t)count + BAT_LOFT_SUPPORT, sizeof *knots);
    r->lines = bat_arena_array(&r->of.arena, (size_t)r->count, 2 * sizeof *r->lines);
    if (!knots || !r->lines)
        return BATTEN_OUT_OF_MEMORY;
    bat_loft_knots(r->inner_count, r->inner, knots);
    const bat_loft_line like = {
        .count = count, .knots = knots, .datum_count = r->of.station_count, .height = height};
    batten_status status = BATTEN_OK;
    for (int rail = 0; rail < r->count && status == BATTEN_OK; rail++)
        status = fair_rail(r, options, rail, &like);
    return status;
}

/* From the line below to that of a rail: at station k and, `part` of the way, towards the next;
 * of the points given, and of the lines. */
static double agreement(const bat_hull_rails *r, int rail, int k, double part)
{
    double given[2] = {0, 0}, faired[2] = {0, 0};
    for (int side = 0; side < 2; side++) {
        const int i = rail - 1 + side, next = part > 0 ? k + 1 : k;
        const double sign = side == 1 ? 1 : -1;
        const double u =
            (1 - part) * bat_hull_rail_u(r, i, k) + part * bat_hull_rail_u(r, i, next);
        const batten_table_point *a = bat_hull_rail_point(r, i, k),
                                 *b = bat_hull_rail_point(r, i, next);
        given[0] += sign * ((1 - part) * a->y + part * b->y);
        given[1] += sign * ((1 - part) * a->z + part * b->z);
        for (int x = 0; x < 2; x++)
            faired[x] += sign * bat_loft_line_at(r->lines, r->rails[i].yz[x], u, 0);
    }
    return given[0] * faired[0] + given[1] * faired[1];
}

static batten_status check_places(const bat_hull_rails *r, int rail, double within)
{
    /* Cubics in pieces of a station or half of one: between places eight to a station they hardly
     * turn back. */
    enum { PLACES = 8 };
    for (int k = 0; k < r->of.station_count; k++)
        for (int i = 0; i < (k + 1 < r->of.station_count ? PLACES : 1); i++) {
            const batten_table_point *a = bat_hull_rail_point(r, rail - 1, k),
                                     *b = bat_hull_rail_point(r, rail, k);
            if (!(agreement(r, rail, k, (double)i / PLACES) > 0))
                return bat_fail(
                    BATTEN_BAD_ARGUMENT,
                    "the lines '%.60s' and '%.60s' are %.3g apart at %s, and "
                    "within %g they change places there or before the next: lines may not meet, "
                    "and a smaller bound keeps near ones apart",
                    bat_hull_rail_name(r, rail - 1), bat_hull_rail_name(r, rail),
                    bat_hypot(b->y - a->y, b->z - a->z),
                    batten_offset_table_label(r->of.table, k).text, within);
        }
    return BATTEN_OK;
}

/* Neighbours that the bound lets change places make a panel that is turned over. */
static batten_status refuse_turned(const bat_hull_rails *r, double within)
{
    batten_status status = BATTEN_OK;
    for (int rail = 1; rail < r->count && status == BATTEN_OK; rail++)
        status = check_places(r, rail, within);
    return status;
}

/* ---- the whole ---- */

static batten_status take_stations(const batten_offset_table *table,
                                   const batten_loft_options *options, bat_hull_rails *r)
{
    const int stations = batten_offset_table_station_count(table);
    r->count = options->knuckle_count + 2;
    r->line = bat_arena_array(&r->of.arena, (size_t)r->count, sizeof *r->line);
    r->at = bat_arena_array(&r->of.arena, (size_t)r->count, (size_t)stations * sizeof *r->at);
    r->rails = bat_arena_array(&r->of.arena, (size_t)r->count, sizeof *r->rails);
    if (!r->line || !r->at || !r->rails)
        return BATTEN_OUT_OF_MEMORY;
    if (stations < BAT_HULL_FEWEST_STATIONS)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "a lofting with knuckles needs at least %d stations; the table has %d",
                        BAT_HULL_FEWEST_STATIONS, stations);
    r->of.table = table;
    const batten_status status = find_lines(options, r);
    return status == BATTEN_OK ? bat_hull_take_stations(table, &r->of) : status;
}

batten_status bat_hull_rails_make(const batten_offset_table *table,
                                  const batten_loft_options *options, bat_hull_rails *out)
{
    bat_hull_rails *r = out;
    *r = (bat_hull_rails){0};
    batten_status status = take_stations(table, options, r);
    if (status == BATTEN_OK)
        status = place_lines(r);
    if (status == BATTEN_OK)
        trim_stations(r);
    if (status == BATTEN_OK)
        status = set_knots(r);
    if (status == BATTEN_OK)
        status = bat_hull_check_bound(&r->of, options->within);
    /* of the breadth: as of a patch */
    const double height = options->height > 0 ? options->height : 1e-6 * 2 * r->of.breadth;
    if (status == BATTEN_OK)
        status = bat_hull_check_runs(r, options);
    if (status == BATTEN_OK)
        status = fair_rails(r, options, height);
    return status == BATTEN_OK ? refuse_turned(r, options->within) : status;
}
