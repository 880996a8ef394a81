/*
 * The lofting of a hull from its table of offsets: one half of it as one patch.
 *
 * Along a station v is the girth from the profile to the sheer, in parts of the whole; u runs
 * with x from the aft end to the forward one.
 */
#include "loft/hull.h"
#include "base/arena.h"
#include "base/plural.h"
#include "numeric/vector.h"

/* Fewer knots than these do not bend with the points between two stations. */
enum { FEWEST_INNER_V = 7, FEWEST_STATIONS = 3, FEWEST_POINTS = 3 };

/* ---- the table ---- */

typedef struct {
    const batten_offset_table *table;
    double within;
    bat_arena arena;
    int station_count, most_points, trimmed;
    bat_hull_station *stations;
} hull;

/* Points on the centre plane, from the foot up. */
static int count_zeros(const batten_table_station *given, bool downwards)
{
    const int n = given->point_count;
    int zeros = 0;
    while (zeros < n && given->points[downwards ? n - 1 - zeros : zeros].y == 0)
        zeros++;
    return zeros;
}

/* From the profile up: of points on the centre plane at the foot only the highest belongs to
 * the hull, what is below is keel or air; but a station all of whose points lie there is a stem. */
static batten_status take_station(hull *h, int k)
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
                        "station %d (x = %g) has %d point%s of the hull; a lofting needs at "
                        "least 2 at each station",
                        k + 1, s->x, s->count, bat_plural(s->count));
    return BATTEN_OK;
}

static batten_status measure_girth(const hull *h, int k)
{
    bat_hull_station *s = h->stations + k;
    for (int i = 1; i < s->count; i++) {
        const batten_table_point *a = s->points + i - 1, *b = s->points + i;
        const double chord = bat_hypot(b->y - a->y, b->z - a->z);
        if (!(chord > 0))
            return bat_fail(BATTEN_COINCIDENT, "station %d (x = %g): points %d and %d coincide",
                            k + 1, s->x, s->from[i - 1] + 1, s->from[i] + 1);
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

/* A chine runs through half of the stations at least: a single sharp bilge is none. */
static batten_status refuse_knuckles(const hull *h)
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
    return bat_fail(
        BATTEN_UNSUPPORTED,
        "%d of %d stations have a knuckle: station %d (x = %g) turns by %.3g degrees "
        "at point %d; a lofting makes one smooth surface: loft the parts above and "
        "below the knuckle one by one",
        found, stations, first + 1, s->x, turn_at(s, at) * 180 / BAT_PI, s->from[at] + 1);
}

static batten_status take_table(hull *h)
{
    int sections = 0;
    batten_status status = BATTEN_OK;
    h->station_count = batten_offset_table_station_count(h->table);
    h->stations = bat_arena_array(&h->arena, (size_t)h->station_count, sizeof *h->stations);
    if (!h->stations)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < h->station_count && status == BATTEN_OK; k++) {
        status = take_station(h, k);
        if (status == BATTEN_OK)
            status = measure_girth(h, k);
        h->most_points = bat_max_int(h->most_points, h->stations[k].count);
        sections += h->stations[k].count >= FEWEST_POINTS;
    }
    if (status == BATTEN_OK && sections < FEWEST_STATIONS)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "a lofting needs at least %d stations of %d points; the table has %d",
                        FEWEST_STATIONS, FEWEST_POINTS, sections);
    return status == BATTEN_OK ? refuse_knuckles(h) : status;
}

/* ---- the patch ---- */

/* x of an end of the hull at v: that of its points, straight between them. */
static double end_x(const bat_hull_station *end, double v)
{
    int i = 1;
    while (i + 1 < end->count && end->v[i] < v)
        i++;
    const double share = (v - end->v[i - 1]) / (end->v[i] - end->v[i - 1]);
    return (1 - share) * end->points[i - 1].x + share * end->points[i].x;
}

static double u_of(const hull *h, double x, double v)
{
    const double aft = end_x(h->stations, v),
                 fore = end_x(h->stations + h->station_count - 1, v);
    return bat_min(bat_max((x - aft) / (fore - aft), 0), 1);
}

/* Knots at the stations along u; along v as many as the richest station has points. */
static batten_status make_patch(hull *h, bat_loft *loft)
{
    const int inner_u = h->station_count - 2;
    const int inner_v = bat_max_int(FEWEST_INNER_V, h->most_points - 2);
    const int most = bat_max_int(inner_u, inner_v);
    double *inner = bat_arena_array(&h->arena, (size_t)most, sizeof *inner);
    double *u = bat_arena_array(&h->arena, (size_t)inner_u + 8, sizeof *u);
    double *v = bat_arena_array(&h->arena, (size_t)inner_v + 8, sizeof *v);
    if (!inner || !u || !v)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < inner_u; k++) {
        inner[k] = u_of(h, h->stations[k + 1].x, 1);
        if (!(inner[k] > (k > 0 ? inner[k - 1] : 0)) || !(inner[k] < 1))
            return bat_fail(
                BATTEN_NOT_INCREASING,
                "station %d (x = %g) does not lie between the one before it and the "
                "end of the hull at the sheer, which runs from x = %g to %g",
                k + 2, h->stations[k + 1].x, end_x(h->stations, 1),
                end_x(h->stations + h->station_count - 1, 1));
    }
    bat_loft_knots(inner_u, inner, u);
    for (int k = 0; k < inner_v; k++)
        inner[k] = (k + 1.) / (inner_v + 1);
    bat_loft_knots(inner_v, inner, v);
    return bat_loft_patch_make(inner_u + BAT_LOFT_SUPPORT, u, inner_v + BAT_LOFT_SUPPORT, v,
                               &loft->patch);
}

static bool lies_on(const bat_hull_station *end, double x)
{
    for (int i = 0; i < end->count; i++)
        if (end->points[i].x != x)
            return false;
    return true;
}

/* The half siding of the profile: the one half-breadth of all lowest points; NAN when they
 * differ. */
static double siding(const hull *h)
{
    const double y = h->stations[0].points[0].y;
    for (int k = 1; k < h->station_count; k++)
        if (h->stations[k].points[0].y != y)
            return NAN;
    return y;
}

static void hold(bat_loft *loft, int i, int j, int c, double value)
{
    const size_t at = 3 * ((size_t)i * (size_t)loft->patch.nv + (size_t)j) + (size_t)c;
    loft->patch.points[at] = value;
    loft->held[at] = true;
}

/* What is known exactly: x where the ends are plane, so that stations are lines of the patch;
 * y of the profile and of a stem. */
static batten_status hold_what_is_known(const hull *h, bat_loft *loft)
{
    const bat_hull_station *aft = h->stations, *fore = h->stations + h->station_count - 1;
    const bool plane_aft = lies_on(aft, aft->x), plane_fore = lies_on(fore, fore->x);
    const double half_siding = siding(h);
    loft->held = bat_array3((size_t)loft->patch.nu, (size_t)loft->patch.nv, 3);
    if (!loft->held)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < loft->patch.nu; i++) {
        const double *t = loft->patch.u_knots + i + 1;
        const double u = i == 0 ? 0 : i == loft->patch.nu - 1 ? 1 : (t[0] + t[1] + t[2]) / 3;
        for (int j = 0; j < loft->patch.nv; j++) {
            if ((plane_aft && plane_fore) || (i == 0 && plane_aft) ||
                (i == loft->patch.nu - 1 && plane_fore))
                hold(loft, i, j, 0, (1 - u) * aft->x + u * fore->x);
            if (i == 0 && aft->is_stem)
                hold(loft, i, j, 1, 0);
            if (i == loft->patch.nu - 1 && fore->is_stem)
                hold(loft, i, j, 1, 0);
        }
        if (!isnan(half_siding))
            hold(loft, i, 0, 1, half_siding);
    }
    return BATTEN_OK;
}

/* ---- the points ---- */

static batten_status place_data(const hull *h, bat_loft *loft)
{
    int count = 0;
    for (int k = 0; k < h->station_count; k++)
        count += h->stations[k].count;
    loft->data = bat_array((size_t)count, sizeof *loft->data);
    if (!loft->data)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < h->station_count; k++)
        for (int i = 0; i < h->stations[k].count; i++) {
            const bat_hull_station *s = h->stations + k;
            const batten_table_point *p = s->points + i;
            loft->data[loft->datum_count++] =
                (bat_loft_datum){.point = {p->x, p->y, p->z},
                                 .within = h->within,
                                 .in_station = true,
                                 .on_u_edge = k == 0 || k + 1 == h->station_count,
                                 .on_v_edge = i == 0 || i + 1 == s->count,
                                 .u = u_of(h, p->x, s->v[i]),
                                 .v = s->v[i],
                                 .station = k,
                                 .index = s->from[i]};
        }
    return BATTEN_OK;
}

/* ---- the whole ---- */

void bat_hull_release(bat_loft *loft)
{
    bat_loft_patch_free(&loft->patch);
    bat_release(loft->held);
    bat_release(loft->data);
    bat_release(loft->cuts);
    *loft = (bat_loft){0};
}

static batten_status set_scales(const hull *h, bat_loft *loft)
{
    const batten_box box = batten_offset_table_box(h->table);
    const double size = bat_distance(3, &box.low.x, &box.high.x);
    double least = HUGE_VAL;
    loft->within = h->within;
    loft->trimmed = h->trimmed;
    for (int k = 0; k < h->station_count; k++)
        for (int i = 0; i < h->stations[k].count; i++) {
            loft->breadth = bat_max(loft->breadth, h->stations[k].points[i].y);
            least = bat_min(least, h->stations[k].points[i].y);
        }
    loft->one_side = least > -h->within;     /* a point may be beyond by less than its bound */
    loft->height = 1e-6 * 2 * loft->breadth; /* of the breadth */
    if (!(loft->breadth > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "no half-breadth of the table is above 0");
    /* Below a billionth of the size the programs' numbers have no digits left; above the
     * half-breadth there is no hull left. */
    const double least_within = 1e-9 * size;
    if (!(h->within >= least_within) || !(h->within <= loft->breadth))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the bound of the lofting is %g; it must be from %.3g, a billionth of "
                        "the size of the table, to %g, its largest half-breadth",
                        h->within, least_within, loft->breadth);
    return BATTEN_OK;
}

batten_status bat_hull_make(const batten_offset_table *table, double within, bat_loft *out)
{
    hull h = {.table = table, .within = within};
    bat_loft loft = {0};
    batten_status status = take_table(&h);
    if (status == BATTEN_OK)
        status = make_patch(&h, &loft);
    if (status == BATTEN_OK)
        status = hold_what_is_known(&h, &loft);
    if (status == BATTEN_OK)
        status = place_data(&h, &loft);
    if (status == BATTEN_OK)
        status = set_scales(&h, &loft);
    if (status == BATTEN_OK)
        status = bat_hull_cuts(table, h.station_count, h.stations, &loft);
    if (status == BATTEN_OK)
        *out = loft;
    else
        bat_hull_release(&loft);
    bat_arena_free(&h.arena);
    return status;
}
