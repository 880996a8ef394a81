/* The stations of a hull as its lofting takes them from the table: from the profile to the sheer. */
#include "base/plural.h"
#include "loft/hull.h"
#include "numeric/vector.h"

enum { FEWEST_POINTS = 3 };

/* Points on the centre plane, from the foot up. */
static int count_zeros(const batten_table_station *given, bool downwards)
{
    const int n = given->point_count;
    int zeros = 0;
    while (zeros < n && given->points[downwards ? n - 1 - zeros : zeros].y == 0)
        zeros++;
    return zeros;
}

/* From the profile up: of points on the centre plane at the foot only the highest
 * belongs to the hull, what is below is keel or air; but a station all of whose points lie there is a
 * stem. */
static batten_status take_station(bat_hull_table *h, int k)
{
    const batten_table_station *given = batten_offset_table_station(h->table, k);
    bat_hull_station *s = h->stations + k;
    const int n = given->point_count;
    *s = (bat_hull_station){.x = given->x};
    s->points = bat_arena_array(&h->arena, (size_t)n, sizeof *s->points);
    s->v = bat_arena_array(&h->arena, (size_t)n, sizeof *s->v);
    s->from = bat_arena_array(&h->arena, (size_t)n, sizeof *s->from);
    if (!s->points || !s->v || !s->from)
        return BATTEN_OUT_OF_MEMORY;
    const bool downwards = given->points[0].z > given->points[n - 1].z;
    const int zeros = count_zeros(given, downwards);
    s->is_stem = zeros == n;
    const int first = s->is_stem ? 0 : bat_max_int(0, zeros - 1);
    h->trimmed += first;
    for (int i = first; i < n; i++) {
        s->from[s->count] = downwards ? n - 1 - i : i;
        s->points[s->count++] = given->points[downwards ? n - 1 - i : i];
    }
    if (s->count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "%s has %d point%s of the hull; a lofting needs at "
                        "least 2 at each station",
                        batten_offset_table_label(h->table, k).text, s->count,
                        bat_plural(s->count));
    return BATTEN_OK;
}

batten_status bat_hull_measure_girth(const batten_offset_table *table, int k,
                                     bat_hull_station *s)
{
    for (int i = 1; i < s->count; i++) {
        const batten_table_point *a = s->points + i - 1, *b = s->points + i;
        const double chord = bat_hypot(b->y - a->y, b->z - a->z);
        if (!(chord > 0))
            return bat_fail(BATTEN_COINCIDENT, "%s: points %d and %d coincide",
                            batten_offset_table_label(table, k).text, s->from[i - 1] + 1,
                            s->from[i] + 1);
        s->v[i] = s->v[i - 1] + chord;
    }
    for (int i = 1; i < s->count; i++)
        s->v[i] = i + 1 < s->count ? s->v[i] / s->v[s->count - 1] : 1;
    return BATTEN_OK;
}

static double turn_at(const bat_hull_station *s, int i)
{
    const batten_table_point *p = s->points + i;
    const double ay = p[0].y - p[-1].y, az = p[0].z - p[-1].z;
    const double by = p[1].y - p[0].y, bz = p[1].z - p[0].z;
    return fabs(bat_atan2(ay * bz - az * by, ay * by + az * bz));
}

/* The point at which a station turns by more than both its neighbours together and by more than
 * `least_turn`: a chine; 0 when no point does. */
static int find_knuckle(const bat_hull_station *s)
{
    const double least_turn = 25 * BAT_PI / 180; /* the corner angle of fairing */
    for (int i = 1; i + 1 < s->count; i++) {
        const double before = i > 1 ? turn_at(s, i - 1) : 0;
        const double after = i + 2 < s->count ? turn_at(s, i + 1) : 0;
        if (turn_at(s, i) > least_turn + before + after)
            return i;
    }
    return 0;
}

/* A chine runs through half of the stations at least: one station with a sharp bilge has no chine. */
batten_status bat_hull_refuse_knuckles(const bat_hull_table *h)
{
    int found = 0, first = 0, stations = 0;
    for (int k = 0; k < h->station_count; k++) {
        stations += h->stations[k].count > 2;
        if (find_knuckle(h->stations + k) && found++ == 0)
            first = k;
    }
    const bat_hull_station *s = h->stations + first;
    const int at = find_knuckle(s);
    if (found == 0 || 2 * found < stations)
        return BATTEN_OK;
    const int line = s->points[at].line;
    const char *name = line >= 0 ? batten_offset_table_line(h->table, line)->name : "";
    return bat_fail(BATTEN_UNSUPPORTED,
                    "%d of %d stations have a knuckle: %s turns by %.3g degrees "
                    "at point %d%s%.60s%s; what is smooth has none: %s",
                    found, stations, batten_offset_table_label(h->table, first).text,
                    turn_at(s, at) * 180 / BAT_PI, s->from[at] + 1,
                    *name ? ", on the line '" : "", name, *name ? "'" : "",
                    *name ? "declare this line as a knuckle"
                          : "give its points a line, and declare it as a knuckle");
}

/* ---- the table ---- */

batten_status bat_hull_take_stations(const batten_offset_table *table, bat_hull_table *out)
{
    bat_hull_table *h = out;
    batten_status status = BATTEN_OK;
    h->table = table;
    h->least = HUGE_VAL;
    h->station_count = batten_offset_table_station_count(table);
    h->stations = bat_arena_array(&h->arena, (size_t)h->station_count, sizeof *h->stations);
    if (!h->stations)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < h->station_count && status == BATTEN_OK; k++)
        status = take_station(h, k);
    return status;
}

void bat_hull_count(bat_hull_table *h)
{
    h->breadth = 0;
    h->least = HUGE_VAL;
    h->most_points = 0;
    for (int k = 0; k < h->station_count; k++) {
        const bat_hull_station *s = h->stations + k;
        h->most_points = bat_max_int(h->most_points, s->count);
        for (int i = 0; i < s->count; i++) {
            h->breadth = bat_max(h->breadth, s->points[i].y);
            h->least = bat_min(h->least, s->points[i].y);
        }
    }
}

batten_status bat_hull_take_table(const batten_offset_table *table, bat_hull_table *out)
{
    int sections = 0;
    batten_status status = bat_hull_take_stations(table, out);
    for (int k = 0; k < out->station_count && status == BATTEN_OK; k++) {
        status = bat_hull_measure_girth(table, k, out->stations + k);
        sections += out->stations[k].count >= FEWEST_POINTS;
    }
    if (status != BATTEN_OK)
        return status;
    if (sections < BAT_HULL_FEWEST_STATIONS)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "a lofting needs at least %d stations of %d points; the table has %d",
                        BAT_HULL_FEWEST_STATIONS, FEWEST_POINTS, sections);
    bat_hull_count(out);
    return bat_hull_refuse_knuckles(out);
}

batten_status bat_hull_check_bound(const bat_hull_table *h, double within)
{
    const batten_box box = batten_offset_table_box(h->table);
    const double size = bat_distance(3, &box.low.x, &box.high.x);
    if (!(h->breadth > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "no half-breadth of the table is above 0");
    /* Below a billionth of the size the programs' numbers have no digits left; above the
     * half-breadth there is no hull left. */
    const double least_within = 1e-9 * size;
    if (!(within >= least_within) || !(within <= h->breadth))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the bound of the lofting is %g; it must be from %.3g, a billionth of "
                        "the size of the table, to %g, its largest half-breadth",
                        within, least_within, h->breadth);
    return BATTEN_OK;
}
