/* A net made: triangles of all pieces, halved until the field is linear along their edges. */
#include "inspect/contours/net.h"

#include "numeric/vector.h"

#include <stdlib.h>
#include <string.h>

/* A triangulation is refined this often where it needs it. */
enum { ROUNDS = 6 };

/* ---- the field ---- */

/* The field at a corner of a triangle, or a little inside where the surface is singular. */
static batten_status corner_value(const bat_net *net, const bat_triangle *t, int corner,
                                  double *value)
{
    batten_status status = bat_net_field(net, t->piece, t->uv[corner], value, NULL, NULL);
    if (status != BATTEN_OK || !isnan(*value))
        return status;
    /* Of the way to the middle a millionth; a tenth for curvature, which loses digits there. */
    const double step = net->order == 3 ? 0.1 : 1e-6;
    double inside[2];
    for (int k = 0; k < 2; k++) {
        const double middle = (t->uv[0][k] + t->uv[1][k] + t->uv[2][k]) / 3;
        inside[k] = t->uv[corner][k] + step * (middle - t->uv[corner][k]);
    }
    return bat_net_field(net, t->piece, inside, value, NULL, NULL);
}

/* ---- nodes and triangles ---- */

/* The value of node `corner` of a triangle, measured when it has none yet. */
static batten_status measure_node(bat_net *net, const bat_triangle *t, int corner)
{
    const int node = t->node[corner];
    if (net->owner[node] >= 0 || !isnan(net->values[node]))
        return BATTEN_OK;
    net->owner[node] = t->piece;
    return corner_value(net, t, corner, &net->values[node]);
}

static batten_status add_measured(bat_net *net, const bat_triangle *t)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 3 && status == BATTEN_OK; k++)
        status = measure_node(net, t, k);
    return status == BATTEN_OK ? bat_net_add_triangle(net, t) : status;
}

/* A rectangle falls into four triangles around its middle. */
static batten_status add_rectangle(bat_net *net, int piece, const int *nodes, const double *uv)
{
    int middle;
    batten_status status = bat_net_add_node(net, (double)NAN, &middle);
    for (int k = 0; k < 4 && status == BATTEN_OK; k++) {
        const int next = (k + 1) % 4;
        const bat_triangle t = {{nodes[k], nodes[next], middle},
                                piece,
                                {{uv[2 * k], uv[2 * k + 1]},
                                 {uv[2 * next], uv[2 * next + 1]},
                                 {0.5 * (uv[0] + uv[4]), 0.5 * (uv[1] + uv[5])}}};
        status = add_measured(net, &t);
    }
    return status;
}

static batten_status add_pieces(bat_net *net)
{
    const bat_pieces *p = net->pieces;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < p->node_count && status == BATTEN_OK; i++) {
        int node;
        status = bat_net_add_node(net, (double)NAN, &node);
    }
    for (int i = 0; i < p->piece_count && status == BATTEN_OK; i++) {
        const int *nodes = p->nodes + (size_t)i * (size_t)p->corner_count;
        const double *uv = p->uv + 2 * (size_t)i * (size_t)p->corner_count;
        const bat_triangle t = {{nodes[0], nodes[1], nodes[2]},
                                i,
                                {{uv[0], uv[1]}, {uv[2], uv[3]}, {uv[4], uv[5]}}};
        status =
            p->corner_count == 3 ? add_measured(net, &t) : add_rectangle(net, i, nodes, uv);
    }
    return status;
}

/* ---- refining ---- */

/* A value within rounding of a level is that level. */
static double snapped(const bat_net *net, double value)
{
    const int above = bat_net_levels_below(net, value);
    if (above < net->level_count && net->levels[above] - value <= net->roundoff)
        return net->levels[above];
    if (above > 0 && value - net->levels[above - 1] <= net->roundoff)
        return net->levels[above - 1];
    return value;
}

/* The field at a corner as the piece of the triangle has it: on a line where the field jumps
 * the value of the node may be that of the piece beside it. */
static batten_status end_value(const bat_net *net, const bat_triangle *t, int corner,
                               double *value)
{
    const int node = t->node[corner];
    *value = net->values[node];
    if (net->owner[node] == t->piece || net->owner[node] < 0 || isnan(*value))
        return BATTEN_OK;
    const batten_status status = corner_value(net, t, corner, value);
    *value = snapped(net, *value);
    return status;
}

static bool has_critical(const bat_net *net, const bat_triangle *t)
{
    return net->critical[t->node[0]] || net->critical[t->node[1]] || net->critical[t->node[2]];
}

/* Edges shorter than this part of the shape are left as they are: no picture shows more, and
 * near a pole a curvature has less and less digits. */
static double shortest_edge(const bat_net *net)
{
    return (net->order == 3 ? 2e-3 : 1e-6) * net->pieces->size;
}

/* Must the edge from corner a to corner b be halved? Yes while the field along it is far from
 * linear, and where it crosses levels that its ends do not tell. Beside a saddle lines leave it
 * close together: there it is looked at closely. */
static batten_status judge(const bat_net *net, const bat_triangle *t, int a, int b, bool *halve)
{
    const int parts = has_critical(net, t) ? 64 : 4;
    double from, to, bend = 0, ends[2][9];
    int crossed = 0;
    *halve = false;
    batten_status status = end_value(net, t, a, &from);
    if (status == BATTEN_OK)
        status = end_value(net, t, b, &to);
    if (status != BATTEN_OK || isnan(from) || isnan(to))
        return status;
    double last = from;
    for (int k = 1; k <= parts; k++) {
        const double at = (double)k / parts;
        const double uv[2] = {t->uv[a][0] + at * (t->uv[b][0] - t->uv[a][0]),
                              t->uv[a][1] + at * (t->uv[b][1] - t->uv[a][1])};
        double value = to;
        if (k < parts)
            status = bat_net_field(net, t->piece, uv, &value, NULL, ends[k > 1]);
        if (status != BATTEN_OK)
            return status;
        if (isnan(value))
            return BATTEN_OK;
        value = snapped(net, value);
        bend = bat_max(bend, fabs(value - from - at * (to - from)));
        crossed += abs(bat_net_levels_below(net, value) - bat_net_levels_below(net, last));
        last = value;
    }
    const int told = abs(bat_net_levels_below(net, to) - bat_net_levels_below(net, from));
    /* What changes by no more than roundings has no levels between. */
    if (bend + fabs(to - from) <= 4 * net->roundoff)
        return BATTEN_OK;
    /* The first and the last probe are half an edge apart, or nearly a whole one. */
    if (bat_distance(3, ends[0], ends[1]) < 0.5 * shortest_edge(net))
        return BATTEN_OK;
    *halve = crossed != told ||
             bend > bat_max(0.1 * (net->greatest - net->least), 100 * net->roundoff);
    return BATTEN_OK;
}

enum { WHOLE = -1 };

/* The node in the middle of an edge of a triangle, or WHOLE; the first triangle at the edge
 * decides. */
static batten_status middle_of(bat_net *net, bat_pair_values *edges, const bat_triangle *t,
                               int a, bool always, int *out)
{
    enum { UNKNOWN = -2 };
    const int b = (a + 1) % 3;
    const int first = bat_min_int(t->node[a], t->node[b]);
    const int second = bat_max_int(t->node[a], t->node[b]);
    int *known = bat_pair_values_at(edges, first, second, UNKNOWN);
    if (!known)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    if (*known == UNKNOWN) {
        bool halve = always;
        const bool forwards = t->node[a] < t->node[b];
        if (!always)
            status = judge(net, t, forwards ? a : b, forwards ? b : a, &halve);
        *known = WHOLE;
        if (status == BATTEN_OK && halve)
            status = bat_net_add_node(net, (double)NAN, known);
    }
    *out = *known;
    return status;
}

/* Part of a triangle; corners 3, 4, 5 are the middles of the edges that begin at 0, 1, 2. */
static batten_status add_part(bat_net *net, const bat_triangle *whole, const int middle[3],
                              int a, int b, int c)
{
    const int corners[3] = {a, b, c};
    bat_triangle part = {.piece = whole->piece};
    for (int k = 0; k < 3; k++) {
        const int at = corners[k], from = at % 3, to = (at + 1) % 3;
        part.node[k] = at < 3 ? whole->node[at] : middle[from];
        for (int i = 0; i < 2; i++)
            part.uv[k][i] =
                at < 3 ? whole->uv[at][i] : 0.5 * (whole->uv[from][i] + whole->uv[to][i]);
    }
    return add_measured(net, &part);
}

static batten_status split_triangle(bat_net *net, const bat_triangle *t, const int middle[3])
{
    /* The parts for each set of halved edges; rows end at the first (0, 0, 0). */
    static const unsigned char parts[8][4][3] = {{{0, 1, 2}},
                                                 {{0, 3, 2}, {3, 1, 2}},
                                                 {{1, 4, 0}, {4, 2, 0}},
                                                 {{3, 1, 4}, {0, 3, 4}, {0, 4, 2}},
                                                 {{2, 5, 1}, {5, 0, 1}},
                                                 {{5, 0, 3}, {2, 5, 3}, {2, 3, 1}},
                                                 {{4, 2, 5}, {1, 4, 5}, {1, 5, 0}},
                                                 {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
    int set = 0;
    for (int k = 0; k < 3; k++)
        set |= (middle[k] != WHOLE) << k;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < 4 && status == BATTEN_OK; i++) {
        const unsigned char *p = parts[set][i];
        if (p[0] + p[1] + p[2] > 0)
            status = add_part(net, t, middle, p[0], p[1], p[2]);
    }
    return status;
}

static void find_range(bat_net *net)
{
    net->least = HUGE_VAL;
    net->greatest = -HUGE_VAL;
    double largest = 0;
    for (size_t i = 0; i < net->node_count; i++) {
        const double value = net->values[i];
        if (isnan(value))
            continue;
        net->least = bat_min(net->least, value);
        net->greatest = bat_max(net->greatest, value);
        largest = bat_max(largest, fabs(value));
    }
    /* A value that is a level but for so much is that level: some hundred roundings, and many
     * more where second derivatives are divided by small first ones, as near a pole. */
    const double roundings = net->order == 3 ? 1e-10 : 1e-14;
    net->roundoff = bat_max(1e-12 * (net->greatest - net->least), roundings * largest);
    net->roundoff = bat_max(net->roundoff, bat_field_roundoff(net->field, net->pieces->size));
}

/* Triangles at critical nodes decide first. */
static batten_status decide_first(bat_net *net, const bat_net *old, bat_pair_values *edges)
{
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < old->triangle_count; i++)
        for (int k = 0; k < 3 && status == BATTEN_OK; k++) {
            int middle;
            if (has_critical(net, &old->triangles[i]))
                status = middle_of(net, edges, &old->triangles[i], k, false, &middle);
        }
    return status;
}

/* One round over all triangles. */
static batten_status refine(bat_net *net, bool always, bool *changed)
{
    bat_net old = *net;
    bat_pair_values edges = {0};
    net->triangles = NULL;
    net->triangle_count = net->triangle_capacity = 0;
    const size_t nodes = net->node_count;
    batten_status status = always ? BATTEN_OK : decide_first(net, &old, &edges);
    for (size_t i = 0; i < old.triangle_count && status == BATTEN_OK; i++) {
        const bat_triangle *t = &old.triangles[i];
        int middle[3];
        for (int k = 0; k < 3 && status == BATTEN_OK; k++)
            status = middle_of(net, &edges, t, k, always, &middle[k]);
        if (status == BATTEN_OK)
            status = split_triangle(net, t, middle);
        if (status == BATTEN_OK && i % 1024 == 0)
            status = bat_work_step(&net->work, 1024, 0, "contours");
    }
    bat_pair_values_free(&edges);
    bat_release(old.triangles);
    *changed = net->node_count > nodes;
    return status;
}

static void snap_all(bat_net *net)
{
    for (size_t i = 0; i < net->node_count; i++)
        net->values[i] = snapped(net, net->values[i]);
}

/* How often all triangles are quartered before anything is asked: few pieces are long. */
static int first_rounds(int pieces)
{
    return pieces <= 4 ? 4 : pieces <= 100 ? 3 : pieces <= 1000 ? 2 : pieces <= 5000 ? 1 : 0;
}

/* Rounds until nothing changes; the first `always` of them everywhere. */
static batten_status refine_all(bat_net *net, int always)
{
    batten_status status = BATTEN_OK;
    bool changed = true;
    for (int i = 0; i < always + ROUNDS && status == BATTEN_OK && changed; i++) {
        find_range(net);
        snap_all(net);
        status = refine(net, i < always, &changed);
    }
    find_range(net);
    snap_all(net);
    return status;
}

batten_status bat_net_build(bat_net *net)
{
    batten_status status = add_pieces(net);
    if (status == BATTEN_OK)
        status = refine_all(net, first_rounds(net->pieces->piece_count));
    if (status == BATTEN_OK)
        status = bat_net_find_criticals(net);
    /* Again, for around a new node that is a saddle the field changes sides four times. */
    if (status == BATTEN_OK && net->critical_count > 0)
        status = refine_all(net, 0);
    return status;
}
