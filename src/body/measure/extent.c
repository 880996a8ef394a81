/*
 * The box of a face: its edges, and the places inside that are farther out. What is inside is
 * told by polygons that follow the loops in the parameters; all is scaled there to 1.
 */
#include "body/measure/extent.h"
#include "base/list.h"
#include "numeric/box.h"
#include <batten/measure.h>

#include <string.h>

/* So near polygons follow a curve, as a share of its extent; and the least, of the domain. */
static const double SHARE = 1e-4, LEAST = 1e-9;

/* ---- edges ---- */

static bool holds(batten_box outer, batten_box inner, double room)
{
    return inner.low.x >= outer.low.x - room && inner.high.x <= outer.high.x + room &&
           inner.low.y >= outer.low.y - room && inner.high.y <= outer.high.y + room &&
           inner.low.z >= outer.low.z - room && inner.high.z <= outer.high.z + room;
}

batten_status bat_edges_extent(const batten_body_parts *parts, bat_extent *extent)
{
    for (int i = 0; i < parts->edge_count; i++) {
        const batten_curve *curve = parts->edges[i].curve;
        batten_box box;
        if (!curve || holds(extent->reached, batten_curve_box(curve), 0))
            continue;
        const batten_status status = batten_curve_bounds(curve, &box);
        if (status == BATTEN_OUT_OF_MEMORY)
            return status;
        if (status == BATTEN_OK)
            bat_box_join(&extent->reached, box);
        bat_box_join(&extent->within, status == BATTEN_OK ? box : batten_curve_box(curve));
    }
    return BATTEN_OK;
}

/* ---- loops as polygons ---- */

typedef struct {
    double from[2], to[2]; /* scaled */
    double sag;            /* the loop is no farther from it */
} side;

typedef struct {
    batten_interval domain[2];
    size_t count, room;
    side *sides; /* [count] */
} polygons;

static batten_status add_side(polygons *p, const double from[2], const double to[2], double sag)
{
    if (BAT_LIST_GROW(p->sides, p->count, p->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    p->sides[p->count++] = (side){{from[0], from[1]}, {to[0], to[1]}, sag};
    return BATTEN_OK;
}

/* A curve that nearly follows a parameter line does so by its smaller extent. */
static double sag_of(const batten_curve *scaled)
{
    const batten_box box = batten_curve_box(scaled);
    return bat_max(LEAST, SHARE * bat_min(box.high.x - box.low.x, box.high.y - box.low.y));
}

static batten_status add_use(polygons *p, const batten_curve *parameters)
{
    const batten_interval u = p->domain[0], v = p->domain[1];
    const double su = 1 / (u.b - u.a), sv = 1 / (v.b - v.a);
    const batten_affine map = {.m = {{su, 0, 0}, {0, sv, 0}, {0, 0, 1}},
                               .t = {-u.a * su, -v.a * sv, 0}};
    batten_curve *scaled = NULL;
    batten_parameters at = {0, NULL};
    double last[3] = {0}, next[3];
    batten_status status = batten_curve_transform(parameters, &map, &scaled);
    const double sag = status == BATTEN_OK ? sag_of(scaled) : 0;
    if (status == BATTEN_OK)
        status = batten_curve_divide_chord(scaled, sag, &at);
    for (int i = 0; status == BATTEN_OK && i < at.count; i++) {
        status = batten_curve_evaluate(scaled, at.at[i], 0, next);
        if (status == BATTEN_OK && i > 0)
            status = add_side(p, last, next, sag);
        memcpy(last, next, sizeof last);
    }
    bat_release(at.at);
    batten_curve_unref(scaled);
    return status;
}

static batten_status add_loops(const batten_body_parts *parts, const batten_body_face *face,
                               polygons *p)
{
    batten_status status = BATTEN_OK;
    for (int l = face->first; l < face->first + face->count; l++)
        for (int i = 0; status == BATTEN_OK && i < parts->loops[l].count; i++)
            status = add_use(p, parts->uses[parts->loops[l].first + i].parameters);
    return status;
}

/* May the curve along a side come into a rectangle? No when their boxes are apart, or all
 * corners are on one side of the line. */
static bool may_enter(const side *s, const batten_interval r[2])
{
    for (int k = 0; k < 2; k++)
        if (bat_max(s->from[k], s->to[k]) < r[k].a - s->sag ||
            bat_min(s->from[k], s->to[k]) > r[k].b + s->sag)
            return false;
    const double dx = s->to[0] - s->from[0], dy = s->to[1] - s->from[1];
    const double off =
        dx * ((r[1].a + r[1].b) / 2 - s->from[1]) - dy * ((r[0].a + r[0].b) / 2 - s->from[0]);
    const double reach = fabs(dx) * (r[1].b - r[1].a) / 2 + fabs(dy) * (r[0].b - r[0].a) / 2;
    return fabs(off) <= reach + s->sag * bat_hypot(dx, dy);
}

/* An odd number of sides is met on the way out. */
static bool is_inside(const polygons *p, const double at[2])
{
    bool inside = false;
    for (size_t i = 0; i < p->count; i++) {
        const double *a = p->sides[i].from, *b = p->sides[i].to;
        if ((a[1] <= at[1]) != (b[1] <= at[1]))
            inside ^= a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > at[0];
    }
    return inside;
}

static bat_share share_of(const void *context, const batten_interval uv[2])
{
    const polygons *p = context;
    batten_interval scaled[2];
    double middle[2];
    for (int k = 0; k < 2; k++) {
        const batten_interval d = p->domain[k];
        scaled[k] =
            (batten_interval){(uv[k].a - d.a) / (d.b - d.a), (uv[k].b - d.a) / (d.b - d.a)};
        middle[k] = (scaled[k].a + scaled[k].b) / 2;
    }
    for (size_t i = 0; i < p->count; i++)
        if (may_enter(&p->sides[i], scaled))
            return BAT_A_PART;
    return is_inside(p, middle) ? BAT_ALL : BAT_NOTHING;
}

/* ---- faces ---- */

batten_status bat_face_extent(const batten_body_parts *parts, int face, double tolerance,
                              bat_extent *extent)
{
    const batten_body_face *of = &parts->faces[face];
    if (holds(extent->reached, batten_surface_box(of->surface), tolerance)) {
        bat_box_join(&extent->within, extent->reached);
        return BATTEN_OK;
    }
    polygons p = {.domain = {batten_surface_domain(of->surface, BATTEN_U),
                             batten_surface_domain(of->surface, BATTEN_V)}};
    bat_extent joined = *extent;
    batten_status status = add_loops(parts, of, &p);
    if (status == BATTEN_OK)
        status =
            bat_surface_extent(of->surface, &(bat_region){share_of, &p}, tolerance, &joined);
    bat_release(p.sides);
    if (status == BATTEN_OUT_OF_MEMORY)
        return status;
    *extent = joined;
    if (status != BATTEN_OK)
        bat_box_join(&extent->within, batten_surface_box(of->surface));
    return BATTEN_OK;
}
