/* From triangle to triangle, from crossing to crossing. */
#include "base/list.h"
#include "inspect/contours/lines.h"

#include "numeric/vector.h"

#include <string.h>

/* Where a level crosses an edge. */
typedef struct {
    int node[2]; /* of the edge, the smaller first */
    int level;
    double at;       /* on the edge, from the first node: 0 .. 1 */
    int link[2];     /* neighbours in the chain, or -1 */
    int triangle[2]; /* through which they are reached */
    bool done;
} crossing;

typedef struct {
    bat_net *net;
    bat_pair_values edges, known; /* (node, node) to edge; (edge, level) to crossing */
    int count, capacity;
    crossing *crossings;
} tracer;

/* ---- finding crossings ---- */

static int corner_of(const bat_triangle *t, int node)
{
    return t->node[0] == node ? 0 : t->node[1] == node ? 1 : 2;
}

static void place_crossing(const bat_triangle *t, const crossing *c, double uv[2])
{
    const double *a = t->uv[corner_of(t, c->node[0])], *b = t->uv[corner_of(t, c->node[1])];
    for (int k = 0; k < 2; k++)
        uv[k] = c->at >= 1 ? b[k] : a[k] + c->at * (b[k] - a[k]);
}

static bat_line_part part_between(const tracer *tr, int triangle, const crossing *a,
                                  const crossing *b)
{
    bat_line_part part = {
        .net = tr->net, .triangle = &tr->net->triangles[triangle], .level = a->level};
    place_crossing(part.triangle, a, part.from);
    place_crossing(part.triangle, b, part.to);
    return part;
}

/* The Illinois form of false position: the ends keep their signs, so that a jump of the field
 * is found too. */
static batten_status locate(const bat_net *net, const bat_triangle *t, crossing *c)
{
    const double level = net->levels[c->level];
    double a = 0, b = 1, fa = net->values[c->node[0]] - level,
           fb = net->values[c->node[1]] - level;
    c->at = fa == 0 ? 0 : 1;
    if (fa == 0 || fb == 0)
        return BATTEN_OK;
    int side = 0;
    /* On an edge from 0 to 1: secants, then halves, down to rounding. */
    for (int i = 0; i < 80 && b - a > 1e-15; i++) {
        double uv[2], value;
        const double secant = (fb * a - fa * b) / (fb - fa);
        c->at = i < 40 && secant > a && secant < b ? secant : 0.5 * (a + b);
        place_crossing(t, c, uv);
        const batten_status status = bat_net_field(net, t->piece, uv, &value, NULL, NULL);
        if (status != BATTEN_OK)
            return status;
        const double f = value - level;
        if (isnan(f) || fabs(f) <= 0.01 * net->roundoff)
            break;
        if ((f > 0) == (fa > 0)) {
            a = c->at, fa = f;
            fb *= side == 1 ? 0.5 : 1;
            side = 1;
        } else {
            b = c->at, fb = f;
            fa *= side == 2 ? 0.5 : 1;
            side = 2;
        }
    }
    return BATTEN_OK;
}

static batten_status add_crossing(tracer *tr, const bat_triangle *t, int first, int second,
                                  int level, int *out)
{
    if (BAT_LIST_GROW(tr->crossings, tr->count, tr->capacity, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    crossing *c = &tr->crossings[tr->count];
    *c = (crossing){{first, second}, level, 0, {-1, -1}, {-1, -1}, false};
    *out = tr->count++;
    return locate(tr->net, t, c);
}

/* The crossing of an edge that still has a free link; where more than two triangles share an
 * edge, another one. */
static batten_status crossing_on(tracer *tr, const bat_triangle *t, int a, int b, int level,
                                 int *out)
{
    const int first = bat_min_int(a, b), second = bat_max_int(a, b);
    int *edge = bat_pair_values_at(&tr->edges, first, second, tr->edges.pairs.count);
    int *known = edge ? bat_pair_values_at(&tr->known, *edge, level, -1) : NULL;
    if (!known)
        return BATTEN_OUT_OF_MEMORY;
    if (*known >= 0 && tr->crossings[*known].link[1] < 0) {
        *out = *known;
        return BATTEN_OK;
    }
    const batten_status status = add_crossing(tr, t, first, second, level, known);
    *out = *known;
    return status;
}

static void link_to(crossing *c, int other, int triangle)
{
    const int place = c->link[0] < 0 ? 0 : 1;
    c->link[place] = other;
    c->triangle[place] = triangle;
}

static batten_status cross_triangle(tracer *tr, int index, int level)
{
    const bat_triangle *t = &tr->net->triangles[index];
    const double height = tr->net->levels[level];
    int found[2], count = 0;
    for (int k = 0; k < 3; k++) {
        const int a = t->node[k], b = t->node[(k + 1) % 3];
        if ((tr->net->values[a] >= height) == (tr->net->values[b] >= height))
            continue;
        const batten_status status = crossing_on(tr, t, a, b, level, &found[count++]);
        if (status != BATTEN_OK)
            return status;
    }
    link_to(&tr->crossings[found[0]], found[1], index);
    link_to(&tr->crossings[found[1]], found[0], index);
    return BATTEN_OK;
}

static batten_status find_crossings(tracer *tr)
{
    const bat_net *net = tr->net;
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < net->triangle_count && status == BATTEN_OK; i++) {
        if (i % 1024 == 0)
            status = bat_work_step(&tr->net->work, 1024, 0.3, "contours");
        const int *node = net->triangles[i].node;
        const double a = net->values[node[0]], b = net->values[node[1]],
                     c = net->values[node[2]];
        if (status != BATTEN_OK || isnan(a) || isnan(b) || isnan(c))
            continue;
        const int low = bat_net_levels_below(net, bat_min(a, bat_min(b, c)));
        const int high = bat_net_levels_below(net, bat_max(a, bat_max(b, c)));
        for (int level = low; level < high && status == BATTEN_OK; level++)
            status = cross_triangle(tr, (int)i, level);
    }
    return status;
}

/* ---- chains ---- */

/* Is it at a node where the field stands still? There lines are cut, to be joined straight. */
static bool is_cut(const tracer *tr, const crossing *c)
{
    return (c->at <= 0 && tr->net->critical[c->node[0]]) ||
           (c->at >= 1 && tr->net->critical[c->node[1]]);
}

static batten_status add_point(tracer *tr, const crossing *c, int triangle, bat_lines *lines,
                               bat_line *line)
{
    const bat_triangle *t = &tr->net->triangles[triangle];
    double uv[2], derivatives[9], value;
    place_crossing(t, c, uv);
    const batten_status status =
        bat_net_field(tr->net, t->piece, uv, &value, NULL, derivatives);
    if (status != BATTEN_OK)
        return status;
    const double *last = line->count ? line->points + 3 * (line->count - 1) : NULL;
    const bool has_arm = lines->has_arm;
    lines->has_arm = false;
    if (last && bat_distance(3, last, derivatives) <= lines->near)
        return BATTEN_OK;
    const batten_status added = bat_line_add(line, derivatives, uv);
    if (added == BATTEN_OK && has_arm)
        bat_line_set_arm(line, 0, lines->arm);
    return added;
}

/* Keep a line unless it is a point. */
static batten_status keep_line(bat_lines *lines, bat_line *line)
{
    if (line->count < 2) {
        bat_line_free(line);
        return BATTEN_OK;
    }
    if (BAT_LIST_GROW(lines->lines, lines->count, lines->capacity, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    lines->lines[lines->count++] = *line;
    *line = (bat_line){.level = line->level, .smooth = line->smooth};
    return BATTEN_OK;
}

/* Follow the chain from a crossing, along its link 0 or 1, until it ends, closes, or is cut.
 * Both ends of what is found stand in the line, also where it closes. */
static batten_status follow(tracer *tr, int begin, int way, bat_lines *lines, bat_line *line)
{
    int here = begin;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK) {
        crossing *c = &tr->crossings[here];
        const int next = c->link[way], triangle = c->triangle[way];
        c->done = true;
        if (next < 0)
            break;
        crossing *d = &tr->crossings[next];
        const bat_line_part part = part_between(tr, triangle, c, d);
        if (line->count == 0)
            status = add_point(tr, c, triangle, lines, line);
        if (status == BATTEN_OK)
            status = bat_line_refine(&part, lines, line);
        if (status == BATTEN_OK)
            status = add_point(tr, d, triangle, lines, line);
        if (status == BATTEN_OK && is_cut(tr, d))
            status = keep_line(lines, line);
        /* Away from where it came; through the same triangle twice goes no line. */
        way = d->triangle[0] == triangle ? 1 : 0;
        if (next == begin || d->done)
            break;
        here = next;
    }
    return status;
}

static batten_status trace_from(tracer *tr, int begin, int way, bat_lines *lines)
{
    bat_line line = {.level = tr->crossings[begin].level, .smooth = lines->smooth};
    batten_status status = follow(tr, begin, way, lines, &line);
    if (status == BATTEN_OK)
        status = keep_line(lines, &line);
    bat_line_free(&line);
    return status;
}

/* Lines with ends, then loops; loops with a cut from there. */
static batten_status trace_all(tracer *tr, bat_lines *lines)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < tr->count && status == BATTEN_OK; i++)
        if (!tr->crossings[i].done && tr->crossings[i].link[1] < 0)
            status = trace_from(tr, i, 0, lines);
    for (int i = 0; i < tr->count && status == BATTEN_OK; i++)
        if (!tr->crossings[i].done && is_cut(tr, &tr->crossings[i]))
            status = trace_from(tr, i, 0, lines);
    for (int i = 0; i < tr->count && status == BATTEN_OK; i++)
        if (!tr->crossings[i].done)
            status = trace_from(tr, i, 0, lines);
    return status;
}

/* ---- too many ---- */

/* Refused before the work when chords within the tolerance would be too many. No chord is
 * farther off than the shape is wide, so that most contours need not be looked at twice. */
static batten_status check_count(tracer *tr, const bat_lines *lines)
{
    const double most = BAT_MOST_CHORDS;
    double total = 0;
    if (lines->smooth ||
        tr->count * (1 + sqrt(tr->net->pieces->size / lines->tolerance)) <= most)
        return BATTEN_OK;
    for (int i = 0; i < tr->count; i++) {
        const crossing *c = &tr->crossings[i];
        batten_status status =
            i % 1024 == 0 ? bat_work_step(&tr->net->work, 1024, 0.4, "contours") : BATTEN_OK;
        for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
            double chords = 0;
            if (c->link[k] <= i)
                continue;
            const bat_line_part part =
                part_between(tr, c->triangle[k], c, &tr->crossings[c->link[k]]);
            status = bat_line_predict(&part, lines, &chords);
            total += chords;
        }
        if (status != BATTEN_OK)
            return status;
    }
    return total <= most
               ? BATTEN_OK
               : bat_fail(BATTEN_TOO_LARGE,
                          "chords within %g of the contours have about %.3g points; the limit "
                          "is %d",
                          lines->tolerance, total, (int)BAT_MOST_CHORDS);
}

batten_status bat_lines_trace(bat_net *net, bat_lines *lines)
{
    tracer tr = {.net = net};
    batten_status status = find_crossings(&tr);
    if (status == BATTEN_OK)
        status = check_count(&tr, lines);
    if (status == BATTEN_OK)
        status = trace_all(&tr, lines);
    bat_pair_values_free(&tr.edges);
    bat_pair_values_free(&tr.known);
    bat_release(tr.crossings);
    return status;
}
