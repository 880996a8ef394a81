/*
 * Curves f(x, y) = 0.
 *
 * Nodes of a grid where f is 0 or more are inside. An edge between an inside and an outside
 * node carries one point of the curve; the cells beside an edge link it to their other edges. A
 * cell with four such edges is read by the sign in its middle.
 */
#include "numeric/vector.h"
#include <batten/contours.h>

#include <float.h>
#include <string.h>

enum { DEPTH = 12, HALVINGS = 60, NEWTON = 20 };

typedef struct {
    batten_field field;
    const void *context;
    int cells;
    double low[2], step[2];
    double tolerance;
    double *values, *gradients; /* of the nodes: [cells + 1][cells + 1], and [2] */
    double *points;             /* [edges][2] */
    int *links;                 /* [edges][2] neighbours, -1 for none */
    bool *crossed, *used;       /* [edges] */
} tracer;

/* ---- the grid ---- */

static int node(const tracer *t, int i, int j)
{
    return j * (t->cells + 1) + i;
}

/* Edges to the right of nodes, then those above. */
static int edge(const tracer *t, int i, int j, bool up)
{
    const int across = t->cells * (t->cells + 1);
    return up ? across + j * (t->cells + 1) + i : j * t->cells + i;
}

static int edge_count(const tracer *t)
{
    return 2 * t->cells * (t->cells + 1);
}

static double at(const tracer *t, int axis, double k)
{
    return t->low[axis] + k * t->step[axis];
}

static batten_status value_at(const tracer *t, double x, double y, double *value,
                              double *gradient)
{
    *value = t->field(t->context, x, y, gradient);
    if (!isfinite(*value) || !isfinite(gradient[0]) || !isfinite(gradient[1]))
        return bat_fail(BATTEN_NOT_FINITE, "the field at (%g, %g) is %g", x, y, *value);
    return BATTEN_OK;
}

static batten_status fill_samples(tracer *t)
{
    batten_status status = BATTEN_OK;
    for (int j = 0; j <= t->cells; j++)
        for (int i = 0; i <= t->cells && status == BATTEN_OK; i++) {
            const int n = node(t, i, j);
            status = value_at(t, at(t, 0, i), at(t, 1, j), &t->values[n],
                              t->gradients + 2 * (size_t)n);
        }
    return status;
}

/* The change of sign between two nodes, by halving. */
static batten_status refine(const tracer *t, const double *a, const double *b, double at_a,
                            double *out)
{
    double low = 0, high = 1, gradient[2], value;
    for (int k = 0; k < HALVINGS; k++) {
        const double s = low + (high - low) / 2;
        const batten_status status =
            value_at(t, a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), &value, gradient);
        if (status != BATTEN_OK)
            return status;
        if ((value >= 0) == (at_a >= 0))
            low = s;
        else
            high = s;
    }
    out[0] = a[0] + low * (b[0] - a[0]);
    out[1] = a[1] + low * (b[1] - a[1]);
    return BATTEN_OK;
}

static batten_status cross(tracer *t, int i, int j, bool up)
{
    const int e = edge(t, i, j, up), n = node(t, i, j), m = node(t, i + !up, j + up);
    t->links[2 * e] = t->links[2 * e + 1] = -1;
    t->crossed[e] = (t->values[n] >= 0) != (t->values[m] >= 0);
    if (!t->crossed[e])
        return BATTEN_OK;
    const double a[2] = {at(t, 0, i), at(t, 1, j)};
    const double b[2] = {at(t, 0, i + !up), at(t, 1, j + up)};
    return refine(t, a, b, t->values[n], t->points + 2 * (size_t)e);
}

static void link_edges(tracer *t, int a, int b)
{
    t->links[2 * a + (t->links[2 * a] >= 0)] = b;
    t->links[2 * b + (t->links[2 * b] >= 0)] = a;
}

static batten_status link_cell(tracer *t, int i, int j)
{
    const int around[4] = {edge(t, i, j, false), edge(t, i + 1, j, true),
                           edge(t, i, j + 1, false), edge(t, i, j, true)};
    int found[4], count = 0;
    for (int k = 0; k < 4; k++)
        if (t->crossed[around[k]])
            found[count++] = around[k];
    if (count == 2)
        link_edges(t, found[0], found[1]);
    if (count < 4)
        return BATTEN_OK;
    double value, gradient[2];
    const batten_status status =
        value_at(t, at(t, 0, i + 0.5), at(t, 1, j + 0.5), &value, gradient);
    if (status != BATTEN_OK)
        return status;
    /* When the middle is as the lower left node, the other two corners are cut off. */
    const bool same = (value >= 0) == (t->values[node(t, i, j)] >= 0);
    link_edges(t, found[0], same ? found[1] : found[3]);
    link_edges(t, found[2], same ? found[3] : found[1]);
    return BATTEN_OK;
}

static batten_status link_all(tracer *t)
{
    batten_status status = BATTEN_OK;
    for (int j = 0; j <= t->cells; j++)
        for (int i = 0; i <= t->cells && status == BATTEN_OK; i++) {
            if (i < t->cells)
                status = cross(t, i, j, false);
            if (status == BATTEN_OK && j < t->cells)
                status = cross(t, i, j, true);
        }
    for (int j = 0; j < t->cells; j++)
        for (int i = 0; i < t->cells && status == BATTEN_OK; i++)
            status = link_cell(t, i, j);
    return status;
}

/* ---- points between ---- */

/* From a place to the curve, no farther than `most`; false when it does not get there. */
static bool correct(const tracer *t, double most, double *place)
{
    const double start[2] = {place[0], place[1]};
    for (int k = 0; k < NEWTON; k++) {
        double gradient[2];
        const double value = t->field(t->context, place[0], place[1], gradient);
        const double square = bat_dot(2, gradient, gradient);
        if (!(square > 0) || !isfinite(value) || !isfinite(square))
            return false;
        const double step[2] = {value * gradient[0] / square, value * gradient[1] / square};
        place[0] -= step[0];
        place[1] -= step[1];
        if (!(bat_distance(2, start, place) <= most))
            return false;
        if (bat_norm(2, step) <= 1e-3 * t->tolerance)
            return true;
    }
    return false;
}

typedef struct {
    int count, room;
    double *points; /* [count][3] */
} line;

/* Where the curve passes a node, edges that meet there carry the same point to rounding. */
static batten_status add_point(const tracer *t, line *l, const double *p)
{
    const double apart = 1e-9 * bat_min(t->step[0], t->step[1]);
    if (l->count > 0 && bat_distance(2, l->points + 3 * (size_t)(l->count - 1), p) <= apart)
        return BATTEN_OK;
    if (l->count == l->room) {
        const int room = bat_max_int(64, 2 * l->room);
        double *grown = bat_resize(l->points, (size_t)room, 3 * sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        l->points = grown;
        l->room = room;
    }
    double *to = l->points + 3 * (size_t)l->count++;
    to[0] = p[0];
    to[1] = p[1];
    to[2] = 0;
    return BATTEN_OK;
}

/* From the last point to b: halves as long as the point of the curve over the middle of a chord
 * is farther from it than the tolerance. A point that would go nearer to an end than a tenth of
 * the chord belongs to another branch. */
static batten_status go_on(const tracer *t, line *l, const double *b)
{
    double ends[DEPTH + 2][2];
    int depth[DEPTH + 2] = {0}, waiting = 1;
    batten_status status = BATTEN_OK;
    memcpy(ends[0], b, sizeof ends[0]);
    while (status == BATTEN_OK && waiting > 0) {
        const int top = waiting - 1;
        const double *from = l->points + 3 * (size_t)(l->count - 1), *to = ends[top];
        const double middle[2] = {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
        double place[2] = {middle[0], middle[1]};
        const double chord = hypot(to[0] - from[0], to[1] - from[1]);
        const bool bent = depth[top] < DEPTH && chord > t->tolerance &&
                          correct(t, 0.4 * chord, place) &&
                          bat_distance(2, place, middle) > t->tolerance / 2;
        if (bent) {
            memcpy(ends[waiting], place, sizeof place);
            depth[waiting++] = ++depth[top];
        } else {
            status = add_point(t, l, to);
            waiting--;
        }
    }
    return status;
}

/* ---- lines ---- */

static batten_status follow(tracer *t, int first, batten_polyline *out)
{
    line l = {0};
    int here = first, before = -1;
    bool closed = false;
    batten_status status = add_point(t, &l, t->points + 2 * (size_t)first);
    t->used[first] = true;
    while (status == BATTEN_OK) {
        const int *next = t->links + 2 * (size_t)here;
        const int to = next[0] >= 0 && next[0] != before ? next[0] : next[1];
        if (to < 0 || to == before)
            break;
        closed = to == first;
        if (!closed && t->used[to])
            break;
        status = go_on(t, &l, t->points + 2 * (size_t)to);
        t->used[to] = true;
        before = here;
        here = to;
        if (closed)
            break;
    }
    if (status == BATTEN_OK)
        *out = (batten_polyline){l.count, closed, l.points, NULL};
    else
        bat_release(l.points);
    return status;
}

/* Lines that begin at the rim of the window, then those that close. */
static batten_status follow_all(tracer *t, batten_polylines *out)
{
    int room = 0;
    batten_status status = BATTEN_OK;
    for (int pass = 0; pass < 2; pass++)
        for (int e = 0; e < edge_count(t) && status == BATTEN_OK; e++) {
            const bool begins = t->links[2 * (size_t)e + 1] < 0;
            if (!t->crossed[e] || t->used[e] || (!begins && pass == 0))
                continue;
            if (out->count == room) {
                room = bat_max_int(8, 2 * room);
                batten_polyline *grown = bat_resize(out->lines, (size_t)room, sizeof *grown);
                if (!grown)
                    return BATTEN_OUT_OF_MEMORY;
                out->lines = grown;
            }
            status = follow(t, e, &out->lines[out->count]);
            out->count += status == BATTEN_OK;
        }
    return status;
}

/* ---- singular points ---- */

/* The second derivatives by differences of the gradient: xx, xy, yy. */
static void hessian(const tracer *t, const double *p, double *h)
{
    const double d[2] = {1e-4 * t->step[0], 1e-4 * t->step[1]};
    double g[4][2];
    for (int k = 0; k < 4; k++) {
        const double side = k % 2 ? -1 : 1;
        t->field(t->context, p[0] + (k < 2 ? side * d[0] : 0), p[1] + (k < 2 ? 0 : side * d[1]),
                 g[k]);
    }
    h[0] = (g[0][0] - g[1][0]) / (2 * d[0]);
    h[1] = ((g[0][1] - g[1][1]) / (2 * d[0]) + (g[2][0] - g[3][0]) / (2 * d[1])) / 2;
    h[2] = (g[2][1] - g[3][1]) / (2 * d[1]);
}

/* May the field and its gradient vanish in a cell? By what they can change across it, seen from
 * the corners and, once it is near the curve, from the middle. */
static bool may_be_singular(const tracer *t, int i, int j)
{
    const int corners[4] = {node(t, i, j), node(t, i + 1, j), node(t, i, j + 1),
                            node(t, i + 1, j + 1)};
    double least = HUGE_VAL, change = 0, g[2], h[3];
    for (int k = 0; k < 4; k++) {
        const double *gradient = t->gradients + 2 * (size_t)corners[k];
        least = bat_min(least, fabs(t->values[corners[k]]));
        change =
            bat_max(change, fabs(gradient[0]) * t->step[0] + fabs(gradient[1]) * t->step[1]);
    }
    if (least > 2 * change)
        return false;
    const double p[2] = {at(t, 0, i + 0.5), at(t, 1, j + 0.5)};
    t->field(t->context, p[0], p[1], g);
    hessian(t, p, h);
    return fabs(g[0]) <= fabs(h[0]) * t->step[0] + fabs(h[1]) * t->step[1] &&
           fabs(g[1]) <= fabs(h[1]) * t->step[0] + fabs(h[2]) * t->step[1];
}

/* Newton for gradient = 0 from the middle of a cell; it must end near the cell, with f = 0 as
 * far as second derivatives over the rounding of the place allow. */
static bool find_singular(const tracer *t, double x, double y, batten_singular_point *out)
{
    double p[2] = {x, y}, g[2], h[3], value = 0;
    for (int k = 0; k < NEWTON; k++) {
        value = t->field(t->context, p[0], p[1], g);
        hessian(t, p, h);
        /* damped a little, so that it settles where the Hessian is singular too: at cusps */
        const double most = bat_largest(3, h), shift = 1e-9 * most;
        const double a = h[0] * h[0] + h[1] * h[1] + shift * shift;
        const double b = h[0] * h[1] + h[1] * h[2];
        const double c = h[1] * h[1] + h[2] * h[2] + shift * shift;
        const double r[2] = {h[0] * g[0] + h[1] * g[1], h[1] * g[0] + h[2] * g[1]};
        const double det = a * c - b * b;
        if (!(det > 0))
            return false;
        p[0] -= (c * r[0] - b * r[1]) / det;
        p[1] -= (a * r[1] - b * r[0]) / det;
        if (!(fabs(p[0] - x) <= t->step[0] && fabs(p[1] - y) <= t->step[1]))
            return false;
    }
    value = t->field(t->context, p[0], p[1], g);
    const double reach = bat_norm(2, t->step), most = bat_largest(3, h);
    /* In units of the Hessian over a cell: Newton leaves its square in the value and itself in
     * the gradient, and differences keep about five digits of the latter. */
    if (!(fabs(value) <= 1e-9 * most * reach * reach && bat_norm(2, g) <= 1e-5 * most * reach))
        return false;
    const double det = h[0] * h[2] - h[1] * h[1], lost = 1e-4 * most * most;
    *out = (batten_singular_point){p[0], p[1],
                                   det < -lost  ? BATTEN_SINGULAR_CROSSING
                                   : det > lost ? BATTEN_SINGULAR_ISOLATED
                                                : BATTEN_SINGULAR_CUSP};
    return true;
}

static batten_status add_singular(const tracer *t, batten_trace *out, int *room,
                                  const batten_singular_point *found)
{
    for (int i = 0; i < out->singular_count; i++)
        if (fabs(out->singular[i].x - found->x) <= 1e-3 * t->step[0] &&
            fabs(out->singular[i].y - found->y) <= 1e-3 * t->step[1])
            return BATTEN_OK;
    if (out->singular_count == *room) {
        *room = bat_max_int(4, 2 * *room);
        batten_singular_point *grown = bat_resize(out->singular, (size_t)*room, sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        out->singular = grown;
    }
    out->singular[out->singular_count++] = *found;
    return BATTEN_OK;
}

static batten_status find_all_singular(const tracer *t, batten_trace *out)
{
    int room = 0;
    batten_status status = BATTEN_OK;
    for (int j = 0; j < t->cells; j++)
        for (int i = 0; i < t->cells && status == BATTEN_OK; i++) {
            batten_singular_point found;
            if (may_be_singular(t, i, j) &&
                find_singular(t, at(t, 0, i + 0.5), at(t, 1, j + 0.5), &found))
                status = add_singular(t, out, &room, &found);
        }
    return status;
}

/* ---- all ---- */

static void tracer_end(tracer *t)
{
    bat_release(t->used);
    bat_release(t->crossed);
    bat_release(t->links);
    bat_release(t->points);
    bat_release(t->gradients);
    bat_release(t->values);
}

static batten_status tracer_begin(tracer *t)
{
    const size_t nodes = (size_t)(t->cells + 1) * (size_t)(t->cells + 1);
    const size_t edges = (size_t)edge_count(t);
    t->values = bat_array(nodes, sizeof *t->values);
    t->gradients = bat_array(nodes, 2 * sizeof *t->gradients);
    t->points = bat_array(edges, 2 * sizeof *t->points);
    t->links = bat_array(edges, 2 * sizeof *t->links);
    t->crossed = bat_array(edges, sizeof *t->crossed);
    t->used = bat_array(edges, sizeof *t->used);
    return t->values && t->gradients && t->points && t->links && t->crossed && t->used
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

static batten_status check_window(batten_box w, int cells, double tolerance)
{
    const bool window = w.low.x < w.high.x && w.low.y < w.high.y &&
                        isfinite(w.high.x - w.low.x) && isfinite(w.high.y - w.low.y);
    if (!window)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the window from (%g, %g) to (%g, %g) has no inside", w.low.x, w.low.y,
                        w.high.x, w.high.y);
    if (cells < 2 || cells > 2000)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a grid of %d cells is outside 2 to 2000", cells);
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    return BATTEN_OK;
}

batten_status batten_trace_field(batten_field field, const void *context, batten_box w,
                                 int cells, double tolerance, batten_trace *out)
{
    batten_trace made = {{0, NULL}, 0, NULL};
    batten_status status = check_window(w, cells, tolerance);
    if (status != BATTEN_OK)
        return status;
    tracer t = {.field = field,
                .context = context,
                .cells = cells,
                .low = {w.low.x, w.low.y},
                .step = {(w.high.x - w.low.x) / cells, (w.high.y - w.low.y) / cells},
                .tolerance = tolerance};
    status = tracer_begin(&t);
    if (status == BATTEN_OK)
        status = fill_samples(&t);
    if (status == BATTEN_OK)
        status = link_all(&t);
    if (status == BATTEN_OK)
        status = follow_all(&t, &made.lines);
    if (status == BATTEN_OK)
        status = find_all_singular(&t, &made);
    tracer_end(&t);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_trace_release(&made);
    return status;
}

static double implicit_field(const void *context, double x, double y, double *gradient)
{
    return batten_implicit_value(context, x, y, gradient);
}

batten_status batten_implicit_trace(const batten_implicit *implicit, batten_box window,
                                    int cells, double tolerance, batten_trace *out)
{
    return batten_trace_field(implicit_field, implicit, window, cells, tolerance, out);
}

void batten_trace_release(batten_trace *trace)
{
    batten_polylines_release(&trace->lines);
    bat_release(trace->singular);
    *trace = (batten_trace){{0, NULL}, 0, NULL};
}
