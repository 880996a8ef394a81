/* Edges as polylines: sampled once, near to the curve and to all faces that share it. */
#include "mesh/faces/lattice.h"
#include "numeric/vector.h"

#include <float.h>
#include <limits.h>
#include <string.h>

static batten_status grow_line(bat_polyline *line, int count)
{
    if (count <= line->room)
        return BATTEN_OK;
    const int room = bat_max_int(8, bat_max_int(count, 2 * line->room));
    double *ts = bat_resize(line->t, (size_t)room, sizeof *ts);
    if (!ts)
        return BATTEN_OUT_OF_MEMORY;
    line->t = ts;
    int *vertices = bat_resize(line->vertex, (size_t)room, sizeof *vertices);
    if (!vertices)
        return BATTEN_OUT_OF_MEMORY;
    line->vertex = vertices;
    line->room = room;
    return BATTEN_OK;
}

static batten_status add_sample(bat_polyline *line, double t, int vertex)
{
    const batten_status status = grow_line(line, line->count + 1);
    if (status != BATTEN_OK)
        return status;
    line->t[line->count] = t;
    line->vertex[line->count++] = vertex;
    return BATTEN_OK;
}

/* ---- is a piece of an edge near enough to its chord? ---- */

typedef struct {
    double a, b;
    double ends[2][3];
} piece;

static double distance(const double *a, const double *b)
{
    return bat_hypot(bat_hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* Near enough counts as 1. The curve leaves its chord by the square of a piece's length, and
 * turns with the length. */
static batten_status judge_curve(const bat_meshing *m, const batten_curve *curve,
                                 const piece *p, double *excess)
{
    static const double places[5] = {0, 0.27, 0.5, 0.73, 1};
    double d[5][6];
    for (int i = 0; i < 5; i++) {
        const double t = p->a + places[i] * (p->b - p->a);
        const batten_side side = i < 4 ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT;
        const batten_status status = batten_curve_evaluate_side(curve, t, side, 1, d[i]);
        if (status != BATTEN_OK)
            return status;
    }
    double miss = 0, turn = 0;
    for (int i = 1; i < 4; i++)
        miss = bat_max(miss, bat_distance_to_segment(d[i], p->ends[0], p->ends[1]));
    for (int i = 0; i < 4; i++)
        turn += bat_angle(d[i] + 3, d[i + 1] + 3);
    *excess = bat_max(sqrt(miss / (0.8 * m->chord)), turn / m->angle);
    *excess = bat_max(*excess, distance(p->ends[0], p->ends[1]) / m->longest);
    return BATTEN_OK;
}

/* At an end the piece is looked at from within: there may be a crease. */
static batten_side side_of(const double ends[2][2], int direction, bool at_end)
{
    const bool rises = ends[1][direction] >= ends[0][direction];
    return rises == at_end ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
}

/* The same for the straight line in (u, v) that the triangles of a face will have there. How
 * far the edge misses the face anyway leaves less room within the chord. */
static batten_status judge_use(const bat_meshing *m, int use, const piece *p, double *excess)
{
    const batten_curve *curve = m->parts->uses[use].parameters;
    const bat_sheet *sheet = &m->sheets[m->use_face[use]];
    double ends[2][2], d[5][9], n[2][3];
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = batten_curve_evaluate(curve, k ? p->b : p->a, 0, ends[k]);
    for (int i = 0; status == BATTEN_OK && i < 5; i++) {
        double uv[2];
        for (int k = 0; k < 2; k++)
            uv[k] = ends[0][k] + i / 4.0 * (ends[1][k] - ends[0][k]);
        bat_sheet_wrap(sheet, uv);
        const batten_side side[2] = {side_of((const double(*)[2])ends, 0, i == 4),
                                     side_of((const double(*)[2])ends, 1, i == 4)};
        status = batten_surface_evaluate_side(sheet->surface, uv[0], uv[1],
                                              (batten_sides){side[0], side[1]}, 1, d[i]);
        if (status == BATTEN_OK)
            status = bat_sheet_steady(sheet, uv, side, d[i]);
    }
    if (status != BATTEN_OK)
        return status;
    double miss = 0;
    for (int i = 1; i < 4; i++)
        miss = bat_max(miss, bat_distance_to_segment(d[i], p->ends[0], p->ends[1]));
    const double off = bat_max(distance(d[0], p->ends[0]), distance(d[4], p->ends[1]));
    const double room = bat_meshing_limit(m, 0.8 * m->chord, off) - off;
    *excess = bat_max(*excess, sqrt(bat_max(miss - off, 0) / room));
    if (!bat_sheet_normal(d[0], n[0]) || !bat_sheet_normal(d[4], n[1]))
        return BATTEN_OK;
    /* Along a straight edge the surface may twist: a triangle as wide as long is off by an
     * eighth of length times angle. */
    const double turn = bat_angle(n[0], n[1]);
    const double twist = turn * distance(p->ends[0], p->ends[1]) / 8;
    *excess = bat_max(*excess, bat_max(turn / m->angle, sqrt(twist / (0.8 * m->chord))));
    return BATTEN_OK;
}

static batten_status judge(const bat_meshing *m, int edge, const piece *p, double *excess)
{
    batten_status status = judge_curve(m, m->parts->edges[edge].curve, p, excess);
    for (int i = m->edge_first[edge]; status == BATTEN_OK && i < m->edge_first[edge + 1]; i++)
        status = judge_use(m, m->edge_uses[i], p, excess);
    return status;
}

/* ---- dividing ---- */

enum { MOST_PARTS = 32 };

/* Pieces that wait, the first of the edge on top. */
typedef struct {
    int count, room;
    piece *pieces;
} waiting;

static batten_status push_parts(waiting *w, const batten_curve *curve, const piece *p,
                                int parts)
{
    if (w->count + parts > w->room) {
        const int room = bat_max_int(64, 2 * (w->count + parts));
        piece *pieces = bat_resize(w->pieces, (size_t)room, sizeof *pieces);
        if (!pieces)
            return BATTEN_OUT_OF_MEMORY;
        w->pieces = pieces;
        w->room = room;
    }
    piece *made = &w->pieces[w->count];
    for (int i = parts - 1; i >= 0; i--, made++) { /* the last of the edge first */
        *made = *p;
        if (i > 0) {
            made->a = p->a + (double)i / parts * (p->b - p->a);
            const batten_status status =
                batten_curve_evaluate(curve, made->a, 0, made->ends[0]);
            if (status != BATTEN_OK)
                return status;
        }
        if (i < parts - 1) {
            made->b = made[-1].a;
            memcpy(made->ends[1], made[-1].ends[0], sizeof made->ends[1]);
        }
    }
    w->count += parts;
    return BATTEN_OK;
}

/* A closed edge goes round; with fewer than three sides its polygon has no inside. */
static int least_parts(const bat_meshing *m, int edge, int spans)
{
    const batten_body_edge *e = &m->parts->edges[edge];
    const int least = e->vertices[0] == e->vertices[1] ? 4 : 1;
    return (least + spans - 1) / spans;
}

/* The roundoff of a point of the piece. */
static double roundoff(const piece *p)
{
    double largest = 0;
    for (int k = 0; k < 6; k++)
        largest = bat_max(largest, fabs(p->ends[k / 3][k % 3]));
    return 64 * DBL_EPSILON * largest;
}

static bool is_short(const bat_meshing *m, const piece *p, batten_interval domain)
{
    /* Halved more than twenty times, an edge turns about where no chord will follow it. */
    return p->b - p->a < 1e-7 * (domain.b - domain.a) ||
           (distance(p->ends[0], p->ends[1]) < bat_max(0.25 * m->chord, roundoff(p)) &&
            p->b - p->a < 0.05 * (domain.b - domain.a));
}

/* The sample at the end of a piece. Where the curve stands still there is none, for two
 * vertices at one point make triangles without area. */
static batten_status end_piece(bat_meshing *m, int edge, const piece *p, bool is_last)
{
    bat_polyline *line = &m->edges[edge];
    const bool stands = distance(p->ends[0], p->ends[1]) <= roundoff(p);
    int vertex = m->same[m->parts->edges[edge].vertices[1]];
    batten_status status = BATTEN_OK;
    if (stands && !is_last)
        return BATTEN_OK;
    if (stands && line->count > 1)
        line->count--;
    if (!is_last)
        status = bat_meshing_point(m, p->ends[1], &vertex);
    return status == BATTEN_OK ? add_sample(line, p->b, vertex) : status;
}

static batten_status divide(bat_meshing *m, int edge, waiting *w)
{
    const batten_curve *curve = m->parts->edges[edge].curve;
    const batten_interval domain = batten_curve_domain(curve);
    bat_polyline *line = &m->edges[edge];
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && w->count) {
        const piece p = w->pieces[--w->count];
        double excess = 0;
        if (!is_short(m, &p, domain))
            status = judge(m, edge, &p, &excess);
        if (status == BATTEN_OK && excess > 1.0000001) {
            const int parts = (int)bat_min(ceil(excess), MOST_PARTS);
            status = push_parts(w, curve, &p, bat_max_int(2, parts));
            continue;
        }
        if (status == BATTEN_OK)
            status = end_piece(m, edge, &p, p.b >= domain.b);
        if (status == BATTEN_OK && line->count + m->point_count > (double)m->most + 1000)
            status = bat_fail(BATTEN_TOO_LARGE, "the edges need more points than %d triangles",
                              m->most);
    }
    return status;
}

static batten_status sample(bat_meshing *m, int edge, waiting *w)
{
    const batten_body_edge *e = &m->parts->edges[edge];
    const int count = batten_curve_spans(e->curve, NULL);
    double *breaks = bat_array((size_t)count, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(e->curve, breaks);
    const int parts = least_parts(m, edge, count - 1);
    batten_status status = add_sample(&m->edges[edge], breaks[0], m->same[e->vertices[0]]);
    for (int i = 0; status == BATTEN_OK && i + 1 < count; i++) {
        piece p = {.a = breaks[i], .b = breaks[i + 1]};
        for (int k = 0; status == BATTEN_OK && k < 2; k++) {
            status = batten_curve_evaluate(e->curve, k ? p.b : p.a, 0, p.ends[k]);
            const bool is_end = k ? i + 2 == count : i == 0;
            if (is_end)
                memcpy(p.ends[k], &m->parts->vertices[3 * (size_t)e->vertices[k]],
                       sizeof p.ends[k]);
        }
        w->count = 0;
        if (status == BATTEN_OK)
            status = push_parts(w, e->curve, &p, parts);
        if (status == BATTEN_OK)
            status = divide(m, edge, w);
        if (status == BATTEN_OK)
            status = bat_work_step(&m->work, 1, (double)edge / m->parts->edge_count / 10,
                                   "samples of edges");
    }
    bat_release(breaks);
    return status;
}

batten_status bat_meshing_edges(bat_meshing *m)
{
    waiting w = {0};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < m->parts->edge_count; i++)
        if (m->parts->edges[i].curve && m->edge_first[i] < m->edge_first[i + 1])
            status = sample(m, i, &w);
    bat_release(w.pieces);
    return status;
}

/* A sample that comes behind number `segment`. */
typedef struct {
    int segment, vertex;
    double t;
} middle;

static batten_status make_middles(bat_meshing *m, int count, const int (*splits)[2],
                                  middle *middles, int *made)
{
    const bat_polyline *line = &m->edges[splits[0][0]];
    const batten_curve *curve = m->parts->edges[splits[0][0]].curve;
    batten_status status = BATTEN_OK;
    *made = 0;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const int segment = splits[i][1];
        const double a = line->t[segment], b = line->t[segment + 1];
        middle *next = &middles[*made];
        double point[3];
        /* Thirty halvings: a border that still crosses itself lies on itself. */
        if (!(b - a > 1e-9 * (line->t[line->count - 1] - line->t[0])))
            continue;
        *next = (middle){.segment = segment, .t = a + (b - a) / 2};
        status = batten_curve_evaluate(curve, next->t, 0, point);
        if (status == BATTEN_OK)
            status = bat_meshing_point(m, point, &next->vertex);
        *made += 1;
    }
    return status;
}

/* Each sample moves once, however many come before it. */
static void merge(bat_polyline *line, int count, const middle *middles)
{
    int from = line->count;
    line->count += count;
    for (int i = 0; i < count; i++) {
        const int first = middles[i].segment + 1, shift = count - i;
        const size_t behind = (size_t)(from - first);
        memmove(line->t + first + shift, line->t + first, behind * sizeof *line->t);
        memmove(line->vertex + first + shift, line->vertex + first,
                behind * sizeof *line->vertex);
        line->t[first + shift - 1] = middles[i].t;
        line->vertex[first + shift - 1] = middles[i].vertex;
        from = first;
    }
}

batten_status bat_meshing_split(bat_meshing *m, int count, const int (*splits)[2], int *made)
{
    bat_polyline *line = &m->edges[splits[0][0]];
    middle *middles = bat_array((size_t)count, sizeof *middles);
    if (!middles)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = make_middles(m, count, splits, middles, made);
    if (status == BATTEN_OK)
        status = grow_line(line, line->count + *made);
    if (status == BATTEN_OK)
        merge(line, *made, middles);
    bat_release(middles);
    return status;
}
