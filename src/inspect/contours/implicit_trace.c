/*
 * Curves f(x, y) = 0.
 *
 * Nodes of a grid where f is 0 or more are inside. An edge between an inside and an outside
 * node carries one point of the curve; the cells beside an edge link it to their other edges. A
 * cell with four such edges is read by the sign in its middle.
 */
#include "inspect/contours/implicit_singular.h"
#include "numeric/vector.h"
#include <batten/contours.h>

#include <string.h>

enum { DEPTH = 12, HALVINGS = 60, NEWTON = 20 };

/* ---- the grid ---- */

/* Edges to the right of nodes, then those above. */
static int edge(const bat_tracer *t, int i, int j, bool up)
{
    const int across = t->cells * (t->cells + 1);
    return up ? across + j * (t->cells + 1) + i : j * t->cells + i;
}

static int edge_count(const bat_tracer *t)
{
    return 2 * t->cells * (t->cells + 1);
}

static batten_status value_at(const bat_tracer *t, double x, double y, double *value,
                              double *gradient)
{
    *value = t->field(t->context, x, y, gradient);
    if (!isfinite(*value) || !isfinite(gradient[0]) || !isfinite(gradient[1]))
        return bat_fail(BATTEN_NOT_FINITE, "the field at (%g, %g) is %g", x, y, *value);
    return BATTEN_OK;
}

static batten_status fill_samples(bat_tracer *t)
{
    batten_status status = BATTEN_OK;
    for (int j = 0; j <= t->cells; j++)
        for (int i = 0; i <= t->cells && status == BATTEN_OK; i++) {
            const int n = bat_tracer_node(t, i, j);
            status = value_at(t, bat_tracer_at(t, 0, i), bat_tracer_at(t, 1, j), &t->values[n],
                              t->gradients + 2 * (size_t)n);
        }
    return status;
}

/* The change of sign between two nodes, by halving. */
static batten_status refine(const bat_tracer *t, const double *a, const double *b, double at_a,
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

static batten_status cross(bat_tracer *t, int i, int j, bool up)
{
    const int e = edge(t, i, j, up), n = bat_tracer_node(t, i, j),
              m = bat_tracer_node(t, i + !up, j + up);
    t->links[2 * e] = t->links[2 * e + 1] = -1;
    t->crossed[e] = (t->values[n] >= 0) != (t->values[m] >= 0);
    if (!t->crossed[e])
        return BATTEN_OK;
    const double a[2] = {bat_tracer_at(t, 0, i), bat_tracer_at(t, 1, j)};
    const double b[2] = {bat_tracer_at(t, 0, i + !up), bat_tracer_at(t, 1, j + up)};
    return refine(t, a, b, t->values[n], t->points + 2 * (size_t)e);
}

static void link_edges(bat_tracer *t, int a, int b)
{
    t->links[2 * a + (t->links[2 * a] >= 0)] = b;
    t->links[2 * b + (t->links[2 * b] >= 0)] = a;
}

static batten_status link_cell(bat_tracer *t, int i, int j)
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
    const batten_status status = value_at(t, bat_tracer_at(t, 0, i + 0.5),
                                          bat_tracer_at(t, 1, j + 0.5), &value, gradient);
    if (status != BATTEN_OK)
        return status;
    /* When the middle is as the lower left node, the other two corners are cut off. */
    const bool same = (value >= 0) == (t->values[bat_tracer_node(t, i, j)] >= 0);
    link_edges(t, found[0], same ? found[1] : found[3]);
    link_edges(t, found[2], same ? found[3] : found[1]);
    return BATTEN_OK;
}

static batten_status link_all(bat_tracer *t)
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
static bool correct(const bat_tracer *t, double most, double *place)
{
    const double start[2] = {place[0], place[1]};
    for (int k = 0; k < NEWTON; k++) {
        double gradient[2];
        const double value = t->field(t->context, place[0], place[1], gradient);
        const double square = bat_dot(2, gradient, gradient);
        const double step[2] = {value * gradient[0] / square, value * gradient[1] / square};
        place[0] -= step[0];
        place[1] -= step[1];
        if (!(bat_distance(2, start, place) <= most)) /* NaN too: without a gradient */
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
static batten_status add_point(const bat_tracer *t, line *l, const double *p)
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
static batten_status go_on(const bat_tracer *t, line *l, const double *b)
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
        const double chord = bat_hypot(to[0] - from[0], to[1] - from[1]);
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

static batten_status follow(bat_tracer *t, int first, batten_polyline *out)
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
static batten_status follow_all(bat_tracer *t, batten_polylines *out)
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

/* ---- all ---- */

static void tracer_end(bat_tracer *t)
{
    bat_release(t->used);
    bat_release(t->crossed);
    bat_release(t->links);
    bat_release(t->points);
    bat_release(t->gradients);
    bat_release(t->values);
}

static batten_status tracer_begin(bat_tracer *t)
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
    bat_tracer t = {.field = field,
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
        status = bat_tracer_find_singular(&t, &made);
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
