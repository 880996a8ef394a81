/*
 * The patch of a lofting: one half of a hull, or a panel between two lines that are faired already.
 *
 * Along a station v is the girth from the lower edge to the upper, in parts of the whole; u runs
 * with x from the aft end to the forward one.
 */
#include "loft/hull.h"
#include "base/arena.h"
#include "numeric/vector.h"
#include "spline/spline.h"

/* Fewer knots than these do not bend with the points between two stations. */
enum { FEWEST_INNER_V = 7 };

typedef struct {
    const bat_hull_table *of;
    double within;
    const bat_hull_edges *edges; /* of a panel */
    bat_arena arena;
} hull;

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
    const double aft = end_x(h->of->stations, v),
                 fore = end_x(h->of->stations + h->of->station_count - 1, v);
    return bat_min(bat_max((x - aft) / (fore - aft), 0), 1);
}

/* Knots at the stations. */
static batten_status knots_at_stations(const hull *h, double *inner)
{
    for (int k = 0; k < h->of->station_count - 2; k++) {
        inner[k] = u_of(h, h->of->stations[k + 1].x, 1);
        if (!(inner[k] > (k > 0 ? inner[k - 1] : 0)) || !(inner[k] < 1))
            return bat_fail(BATTEN_NOT_INCREASING,
                            "%s does not lie between the one before it and the "
                            "end of the hull at the sheer, which runs from x = %g to %g",
                            batten_offset_table_label(h->of->table, k + 1).text,
                            end_x(h->of->stations, 1),
                            end_x(h->of->stations + h->of->station_count - 1, 1));
    }
    return BATTEN_OK;
}

/* Knots at the stations along u, or those of the edges; along v as many as the richest station has
 * points, and none across a panel that is ruled. */
static batten_status make_patch(hull *h, bat_loft *loft)
{
    const int inner_u = h->edges ? h->edges->inner_count : h->of->station_count - 2;
    const int points = h->of->most_points - 2;
    const int inner_v = h->edges && points == 0 ? 0 : bat_max_int(FEWEST_INNER_V, points);
    const int most = bat_max_int(inner_u, inner_v);
    double *inner = bat_arena_array(&h->arena, (size_t)most, sizeof *inner);
    double *u = bat_arena_array(&h->arena, (size_t)inner_u + 8, sizeof *u);
    double *v = bat_arena_array(&h->arena, (size_t)inner_v + 8, sizeof *v);
    if (!inner || !u || !v)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = h->edges ? BATTEN_OK : knots_at_stations(h, inner);
    if (status != BATTEN_OK)
        return status;
    bat_loft_knots(inner_u, h->edges ? h->edges->inner : inner, u);
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
    const double y = h->of->stations[0].points[0].y;
    for (int k = 1; k < h->of->station_count; k++)
        if (h->of->stations[k].points[0].y != y)
            return NAN;
    return y;
}

/* The one height of all points of an edge, which is then a waterline; NAN when they differ. */
static double level(const hull *h, bool top)
{
    double z = NAN;
    for (int k = 0; k < h->of->station_count; k++) {
        const bat_hull_station *s = h->of->stations + k;
        const double own = s->points[top ? s->count - 1 : 0].z;
        if (k > 0 && own != z)
            return NAN;
        z = own;
    }
    return z;
}

static void hold(bat_loft *loft, int i, int j, int c, double value)
{
    const size_t at = 3 * ((size_t)i * (size_t)loft->patch.nv + (size_t)j) + (size_t)c;
    loft->patch.points[at] = value;
    loft->held[at] = true;
}

/* The point of a rail with this index. */
static void rail_point(const bat_hull_rail *rail, int i, double u, double out[3])
{
    out[0] = (1 - u) * rail->x[0] + u * rail->x[1];
    out[1] = rail->yz[0][i];
    out[2] = rail->yz[1][i];
}

/* Both edges are held; what is between them begins as straight. */
static void hold_edges(const hull *h, int i, double u, bat_loft *loft)
{
    double low[3], high[3];
    const int last = loft->patch.nv - 1;
    rail_point(h->edges->low, i, u, low);
    rail_point(h->edges->high, i, u, high);
    for (int j = 0; j <= last; j++) {
        const double v = bat_greville(BAT_LOFT_DEGREE, loft->patch.v_knots, j);
        double *p = loft->patch.points + 3 * ((size_t)i * (size_t)loft->patch.nv + (size_t)j);
        for (int c = 0; c < 3; c++) {
            p[c] = j == 0 ? low[c] : j == last ? high[c] : (1 - v) * low[c] + v * high[c];
            if (j == 0 || j == last)
                hold(loft, i, j, c, p[c]);
        }
    }
}

/* y of the profile, and z of edges that are waterlines. */
static void hold_rims(const hull *h, bat_loft *loft)
{
    const double half_siding = siding(h), low = level(h, false), high = level(h, true);
    for (int i = 0; i < loft->patch.nu; i++) {
        if (!isnan(half_siding))
            hold(loft, i, 0, 1, half_siding);
        if (!isnan(low))
            hold(loft, i, 0, 2, low);
        if (!isnan(high))
            hold(loft, i, loft->patch.nv - 1, 2, high);
    }
}

/* What is known exactly: x where the ends are plane, so that stations are lines of the patch;
 * what is held of the edges; y of a stem. */
static batten_status hold_what_is_known(const hull *h, bat_loft *loft)
{
    const bat_hull_station *aft = h->of->stations,
                           *fore = h->of->stations + h->of->station_count - 1;
    const bool plane_aft = lies_on(aft, aft->x), plane_fore = lies_on(fore, fore->x);
    loft->held = bat_array3((size_t)loft->patch.nu, (size_t)loft->patch.nv, 3);
    if (!loft->held)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < loft->patch.nu; i++) {
        const double u = bat_greville(BAT_LOFT_DEGREE, loft->patch.u_knots, i);
        for (int j = 0; j < loft->patch.nv; j++) {
            if ((plane_aft && plane_fore) || (i == 0 && plane_aft) ||
                (i == loft->patch.nu - 1 && plane_fore))
                hold(loft, i, j, 0, (1 - u) * aft->x + u * fore->x);
            if (i == 0 && aft->is_stem)
                hold(loft, i, j, 1, 0);
            if (i == loft->patch.nu - 1 && fore->is_stem)
                hold(loft, i, j, 1, 0);
        }
        if (h->edges)
            hold_edges(h, i, u, loft);
    }
    if (!h->edges)
        hold_rims(h, loft);
    return BATTEN_OK;
}

/* ---- the points ---- */

static batten_status place_data(const hull *h, bat_loft *loft)
{
    int count = 0;
    for (int k = 0; k < h->of->station_count; k++)
        count += h->of->stations[k].count;
    loft->data = bat_array((size_t)count, sizeof *loft->data);
    if (!loft->data)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < h->of->station_count; k++)
        for (int i = 0; i < h->of->stations[k].count; i++) {
            const bat_hull_station *s = h->of->stations + k;
            const batten_table_point *p = s->points + i;
            if (h->edges && (i == 0 || i + 1 == s->count))
                continue; /* the edges are faired already */
            loft->data[loft->datum_count++] =
                (bat_loft_datum){.point = {p->x, p->y, p->z},
                                 .within = h->within,
                                 .in_station = true,
                                 .on_u_edge = k == 0 || k + 1 == h->of->station_count,
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
    bat_release(loft->limits);
    bat_release(loft->cuts);
    *loft = (bat_loft){0};
}

static void set_scales(const hull *h, bat_loft *loft)
{
    loft->within = h->within;
    loft->trimmed = h->of->trimmed;
    loft->breadth = h->of->breadth;
    loft->one_side =
        h->of->least > -h->within;           /* a point may be beyond by less than its bound */
    loft->height = 1e-6 * 2 * loft->breadth; /* of the breadth */
}

batten_status bat_hull_patch(const bat_hull_table *table, double within,
                             const bat_hull_edges *edges, bat_loft *out)
{
    hull h = {.of = table, .within = within, .edges = edges};
    bat_loft loft = {0};
    batten_status status = bat_hull_check_bound(table, within);
    if (status == BATTEN_OK)
        status = make_patch(&h, &loft);
    if (status == BATTEN_OK)
        status = hold_what_is_known(&h, &loft);
    if (status == BATTEN_OK)
        status = place_data(&h, &loft);
    set_scales(&h, &loft);
    if (status == BATTEN_OK)
        status = bat_hull_cuts(table, edges, &loft);
    if (status == BATTEN_OK)
        *out = loft;
    else
        bat_hull_release(&loft);
    bat_arena_free(&h.arena);
    return status;
}

batten_status bat_hull_make(const batten_offset_table *table, double within, bat_loft *out)
{
    bat_hull_table taken = {0};
    batten_status status = bat_hull_take_table(table, &taken);
    if (status == BATTEN_OK)
        status = bat_hull_patch(&taken, within, NULL, out);
    bat_arena_free(&taken.arena);
    return status;
}
