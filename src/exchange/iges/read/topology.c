/* Lists of vertices (502) and edges (504), each read once and shared by a body. */
#include "exchange/iges/read/topology.h"
#include "exchange/iges/read/curves.h"
#include "exchange/iges/read/references.h"

#include "body/elementary/elementary.h"

typedef struct {
    int curve, start_list, start, end_list, end;
} edge;

/* A list of vertices or of edges. Each knows its index in the body it was last put into. */
typedef struct {
    int count;
    double *points; /* of vertices: [count][3] */
    edge *edges;
    int *index, *body;
} table;

void bat_iges_start_tables(bat_iges_reading *reading)
{
    reading->tables = (bat_list){.size = sizeof(table)};
}

void bat_iges_end_tables(bat_iges_reading *reading)
{
    table *tables = reading->tables.items;
    for (size_t k = 0; k < reading->tables.count; k++) {
        bat_release(tables[k].points);
        bat_release(tables[k].edges);
        bat_release(tables[k].index);
        bat_release(tables[k].body);
    }
    bat_release(reading->tables.items);
}

void bat_iges_next_body(bat_iges_reading *reading)
{
    reading->body++;
    reading->body_miss = 0;
}

/* ---- reading lists ---- */

/* N, then x, y, z of each. */
static batten_status read_vertices(bat_iges_item *item, table *t)
{
    batten_status status = bat_iges_read_count(item, 1, 2, 3, &t->count);
    return status == BATTEN_OK ? bat_iges_real_array(item, 2, 3 * (size_t)t->count, &t->points)
                               : status;
}

/* N, then of each the curve, and the list and number of its first and its last vertex. */
static batten_status read_edges(bat_iges_item *item, table *t)
{
    batten_status status = bat_iges_read_count(item, 1, 2, 5, &t->count);
    if (status == BATTEN_OK)
        status = bat_input_array(item->reading->input, (size_t)t->count, sizeof *t->edges,
                                 &t->edges);
    for (size_t k = 0; status == BATTEN_OK && k < (size_t)t->count; k++) {
        edge *e = &t->edges[k];
        int *fields[] = {&e->curve, &e->start_list, &e->start, &e->end_list, &e->end};
        for (size_t i = 0; status == BATTEN_OK && i < 5; i++)
            status = bat_iges_integer(item->parameters, 2 + 5 * k + i, fields[i]);
    }
    return status;
}

static batten_status read_table(bat_iges_reading *reading, const bat_iges_entry *entry)
{
    bat_iges_item item;
    table t = {.count = 0};
    bat_input *input = reading->input;
    batten_status status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK && entry->transform)
        status = bat_fail(BATTEN_UNSUPPORTED, "the matrix of list D%d is not read", entry->id);
    if (status == BATTEN_OK)
        status = entry->type == 502 ? read_vertices(&item, &t) : read_edges(&item, &t);
    bat_iges_close(&item);
    if (status == BATTEN_OK)
        status = bat_input_array(input, (size_t)t.count, sizeof *t.index, &t.index);
    if (status == BATTEN_OK)
        status = bat_input_array(input, (size_t)t.count, sizeof *t.body, &t.body);
    if (status == BATTEN_OK)
        status = bat_list_add(input, &reading->tables, &t);
    if (status == BATTEN_OK) {
        bat_iges_shape_of(reading, entry)->table = (int)reading->tables.count;
        return bat_iges_count_read(reading, entry->type);
    }
    bat_release(t.points);
    bat_release(t.edges);
    bat_release(t.index);
    bat_release(t.body);
    return status;
}

/* Item `number` of a list; *at is its place in it. The table stays where it is until another is
 * read. */
static batten_status find_table(bat_iges_reading *reading, int id, int type, int number,
                                table **out, size_t *at)
{
    const bat_iges_entry *entry = NULL;
    batten_status status = bat_iges_find_type(reading, id, type, &entry);
    if (status == BATTEN_OK && bat_iges_shape_of(reading, entry)->table == 0)
        status = read_table(reading, entry);
    if (status != BATTEN_OK)
        return status;
    table *t = (table *)reading->tables.items + bat_iges_shape_of(reading, entry)->table - 1;
    if (number < 1 || number > t->count)
        return bat_fail(BATTEN_BAD_FORMAT, "it refers to number %d of list D%d, which has %d",
                        number, id, t->count);
    *out = t;
    *at = (size_t)(number - 1);
    return BATTEN_OK;
}

/* ---- in the body ---- */

static batten_status body_vertex(bat_iges_reading *reading, bat_builder *builder, int id,
                                 int number, int *index)
{
    table *t = NULL;
    size_t at = 0;
    batten_status status = find_table(reading, id, 502, number, &t, &at);
    if (status == BATTEN_OK && t->body[at] != reading->body) {
        status = bat_builder_vertex(builder, &t->points[3 * at], &t->index[at]);
        if (status == BATTEN_OK)
            t->body[at] = reading->body;
    }
    if (status == BATTEN_OK)
        *index = t->index[at];
    return status;
}

static double distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* The curve as it runs from p to q: kept when it does, turned when it runs from q to p, cut
 * when it goes farther. */
static batten_status fit_curve(bat_iges_reading *reading, const batten_curve *curve,
                               const double p[3], const double q[3], batten_curve **out)
{
    const batten_interval domain = batten_curve_domain(curve);
    const double size = bat_max(bat_iges_size_of_curve(curve), distance(p, q)),
                 tolerance = bat_iges_tolerance(reading, size);
    double a[3], b[3], miss = 0;
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, a);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, domain.b, 0, b);
    if (status != BATTEN_OK)
        return status;
    const double kept = bat_max(distance(a, p), distance(b, q)),
                 turned = bat_max(distance(a, q), distance(b, p));
    if (kept <= tolerance) {
        *out = batten_curve_ref(curve);
        return BATTEN_OK;
    }
    if (turned <= tolerance)
        return batten_curve_reverse(curve, out);
    status = bat_curve_part(curve, p, q, true, tolerance, out, &miss);
    if (status != BATTEN_OK || !(miss > tolerance))
        return status;
    if (miss > bat_max(100 * tolerance, 1e-3 * size)) {
        batten_curve_unref(*out);
        *out = NULL;
        return bat_fail(BATTEN_NOT_COMPATIBLE, "an edge misses its vertices by %g", miss);
    }
    reading->gaps++;
    reading->largest_gap = bat_max(reading->largest_gap, miss);
    return BATTEN_OK;
}

batten_status bat_iges_body_edge(bat_iges_reading *reading, bat_builder *builder, int id,
                                 int number, int *index)
{
    table *t = NULL;
    size_t at = 0;
    int start = 0, end = 0;
    const batten_curve *curve = NULL;
    batten_curve *fitted = NULL;
    batten_status status = find_table(reading, id, 504, number, &t, &at);
    if (status != BATTEN_OK)
        return status;
    if (t->body[at] == reading->body) {
        *index = t->index[at];
        return BATTEN_OK;
    }
    const edge e = t->edges[at];
    status = body_vertex(reading, builder, e.start_list, e.start, &start);
    if (status == BATTEN_OK)
        status = body_vertex(reading, builder, e.end_list, e.end, &end);
    if (status == BATTEN_OK)
        status = bat_iges_curve(reading, e.curve, &curve);
    if (status == BATTEN_OK)
        status = fit_curve(reading, curve, builder->parts.vertices + 3 * (size_t)start,
                           builder->parts.vertices + 3 * (size_t)end, &fitted);
    if (status == BATTEN_OK)
        status = bat_builder_edge(builder, fitted, start, end, index);
    batten_curve_unref(fitted);
    if (status != BATTEN_OK)
        return status;
    status = find_table(reading, id, 504, number, &t, &at); /* others may have been read */
    if (status == BATTEN_OK) {
        t->index[at] = *index;
        t->body[at] = reading->body;
    }
    return status;
}
