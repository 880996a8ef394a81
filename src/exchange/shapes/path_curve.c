/* Paths of lines and arcs as curves. */
#include "base/plural.h"
#include "exchange/shapes/path.h"
#include "numeric/vector.h"

#include <batten/standard.h>

typedef struct {
    const bat_path *path;
    batten_vec3 y;   /* of the frame; x and z are its own */
    int count;       /* pieces so far */
    double *points;  /* [2 count + 1][3] */
    double *weights; /* [2 count + 1] */
    double *breaks;  /* [count + 1] */
} tracing;

static batten_vec3 point_at(const tracing *t, double x, double y)
{
    const batten_frame *f = &t->path->frame;
    return bat_vec3_along(bat_vec3_along(f->origin, x, f->x), y, t->y);
}

static void put_point(tracing *t, int at, batten_vec3 p, double weight)
{
    t->points[3 * at] = p.x;
    t->points[3 * at + 1] = p.y;
    t->points[3 * at + 2] = p.z;
    t->weights[at] = weight;
}

/* From the last point on: by the middle control point to the end. */
static void add_piece(tracing *t, const double middle[2], double weight, const double end[2],
                      double length)
{
    put_point(t, 2 * t->count + 1, point_at(t, middle[0], middle[1]), weight);
    put_point(t, 2 * t->count + 2, point_at(t, end[0], end[1]), 1);
    t->breaks[t->count + 1] = t->breaks[t->count] + length;
    t->count++;
}

/* An arc from vertex a to vertex b in pieces of equal angle. */
static void add_arc(tracing *t, const bat_vertex *a, const bat_vertex *b, int pieces)
{
    double cx, cy, radius;
    bat_path_centre(a, b->x, b->y, &cx, &cy, &radius);
    const double sweep = 4 * bat_atan(a->bulge), step = sweep / pieces;
    const double start = bat_atan2(a->y - cy, a->x - cx);
    for (int i = 0; i < pieces; i++) {
        const double angle = start + (i + 0.5) * step, far = radius / bat_cos(step / 2);
        const double middle[2] = {cx + far * bat_cos(angle), cy + far * bat_sin(angle)};
        const double to = start + (i + 1) * step;
        const double end[2] = {i + 1 == pieces ? b->x : cx + radius * bat_cos(to),
                               i + 1 == pieces ? b->y : cy + radius * bat_sin(to)};
        add_piece(t, middle, bat_cos(step / 2), end, fabs(step) * radius);
    }
}

static int pieces_of(const bat_vertex *v)
{
    /* A quarter turn that rounding made a little more is still one piece. */
    return v->bulge == 0 ? 1 : 1 + (int)(4 * fabs(bat_atan(v->bulge)) / (BAT_PI / 2) - 1e-9);
}

static void add_line(tracing *t, const bat_vertex *a, const bat_vertex *b)
{
    const double middle[2] = {a->x + (b->x - a->x) / 2, a->y + (b->y - a->y) / 2};
    const double end[2] = {b->x, b->y};
    add_piece(t, middle, 1, end, bat_hypot(b->x - a->x, b->y - a->y));
}

static void add_side(tracing *t, const bat_vertex *a, const bat_vertex *b)
{
    if (a->bulge != 0)
        add_arc(t, a, b, pieces_of(a));
    else
        add_line(t, a, b);
}

static void trace(tracing *t)
{
    const bat_path *path = t->path;
    const int sides = path->closed ? path->count : path->count - 1;
    put_point(t, 0, point_at(t, path->vertices[0].x, path->vertices[0].y), 1);
    for (int i = 0; i < sides; i++)
        add_side(t, &path->vertices[i], &path->vertices[(i + 1) % path->count]);
}

/* Without arcs the middle points say nothing. */
static batten_status make_polyline(const tracing *t, batten_curve **out)
{
    double *ends = bat_array3((size_t)t->count + 1, 3, sizeof *ends);
    if (!ends)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i <= t->count; i++)
        for (int k = 0; k < 3; k++)
            ends[3 * i + k] = t->points[6 * i + k];
    const batten_status status =
        batten_curve_polyline((batten_points){3, t->count + 1, ends}, out);
    bat_release(ends);
    return status;
}

batten_status bat_path_curve(const bat_path *path, batten_curve **out)
{
    const int sides = path->closed ? path->count : path->count - 1;
    size_t pieces = 0;
    bool has_arcs = false;
    if (sides < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "a path of %d point%s", path->count,
                        bat_plural(path->count));
    for (int i = 0; i < sides; i++) {
        const bat_vertex *a = &path->vertices[i], *b = &path->vertices[(i + 1) % path->count];
        if (a->x == b->x && a->y == b->y)
            return bat_fail(BATTEN_COINCIDENT, "points %d and %d of a path are one", i + 1,
                            (i + 1) % path->count + 1);
        pieces += (size_t)pieces_of(a);
        has_arcs |= a->bulge != 0;
    }
    tracing t = {.path = path,
                 .y = bat_vec3_cross(path->frame.z, path->frame.x),
                 .points = bat_array3(2 * pieces + 1, 3, sizeof(double)),
                 .weights = bat_array(2 * pieces + 1, sizeof(double)),
                 .breaks = bat_array(pieces + 1, sizeof(double))};
    batten_status status = t.points && t.weights && t.breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        trace(&t);
    if (status == BATTEN_OK && has_arcs)
        status = batten_curve_from_bezier(3, (batten_pieces){2, t.count, t.breaks}, t.points,
                                          t.weights, out);
    else if (status == BATTEN_OK)
        status = make_polyline(&t, out);
    bat_release(t.points);
    bat_release(t.weights);
    bat_release(t.breaks);
    return status;
}
