/* What every reader promises of any bytes: what it reads can be written, and reads back the
 * same. */
#include "promise.h"
#include "exchange/recognise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void demand(int holds, const char *what)
{
    if (holds)
        return;
    fprintf(stderr, "broken promise: %s; last message: %s\n", what, batten_message());
    abort();
}

static void demand_same(const double *a, const double *b, size_t count, const char *what)
{
    demand((a == NULL) == (b == NULL), what);
    demand(!a || count == 0 || memcmp(a, b, count * sizeof *a) == 0, what);
}

/* Equal weights say nothing, and STEP does without them. */
static int say_nothing(const double *weights, size_t count)
{
    for (size_t i = 1; weights && i < count; i++)
        if (weights[i] != weights[0])
            return 0;
    return weights != NULL;
}

static void same_weights(const double *a, const double *b, size_t count, const char *what)
{
    if (b || !say_nothing(a, count))
        demand_same(a, b, count, what);
}

static void same_curve(const batten_curve *a, const batten_curve *b, bool weighs)
{
    const size_t n = (size_t)batten_curve_point_count(a);
    demand(batten_curve_degree(a) == batten_curve_degree(b), "a curve keeps its degree");
    demand(batten_curve_point_count(b) == (int)n, "a curve keeps its count of points");
    const size_t dimension = (size_t)batten_curve_dimension(a);
    demand(batten_curve_dimension(b) == (int)dimension, "a curve keeps its dimension");
    if (!weighs || !batten_curve_is_rational(a))
        demand_same(batten_curve_points(a), batten_curve_points(b), dimension * n,
                    "points of a curve");
    same_weights(batten_curve_weights(a), batten_curve_weights(b), n, "weights of a curve");
    demand_same(batten_curve_knots(a), batten_curve_knots(b),
                (size_t)batten_curve_knot_count(a), "knots of a curve");
}

static void same_surface(const batten_surface *a, const batten_surface *b, bool weighs)
{
    size_t n = 1;
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        const int count = batten_surface_point_count(a, direction);
        demand(batten_surface_degree(a, direction) == batten_surface_degree(b, direction) &&
                   batten_surface_point_count(b, direction) == count,
               "a surface keeps its degree and counts");
        demand_same(batten_surface_knots(a, direction), batten_surface_knots(b, direction),
                    (size_t)batten_surface_knot_count(a, direction), "knots of a surface");
        n *= (size_t)count;
    }
    if (!weighs || !batten_surface_is_rational(a))
        demand_same(batten_surface_points(a), batten_surface_points(b), 3 * n,
                    "points of a surface");
    same_weights(batten_surface_weights(a), batten_surface_weights(b), n,
                 "weights of a surface");
}

static void same_offsets(const batten_offset_table *a, const batten_offset_table *b)
{
    const int count = batten_offset_table_station_count(a);
    demand(batten_offset_table_station_count(b) == count, "a table keeps its stations");
    for (int i = 0; i < count; i++) {
        const batten_table_station *s = batten_offset_table_station(a, i),
                                   *t = batten_offset_table_station(b, i);
        demand(s->point_count == t->point_count && s->x == t->x &&
                   strcmp(s->name, t->name) == 0,
               "a station keeps its place, name and count of points");
        for (int k = 0; k < s->point_count; k++) {
            const batten_table_point *p = &s->points[k], *q = &t->points[k];
            demand_same(&p->x, &q->x, 1, "x of an offset");
            demand_same(&p->y, &q->y, 1, "y of an offset");
            demand_same(&p->z, &q->z, 1, "z of an offset");
            demand((p->line < 0) == (q->line < 0), "a point keeps its line");
        }
    }
}

/* Colours are bytes in some formats: those that differ by less than one are the same. */
static void same_mesh(const batten_mesh_parts *a, const batten_mesh_parts *b)
{
    const size_t n = (size_t)a->vertex_count, m = (size_t)a->triangle_count;
    demand(a->vertex_count == b->vertex_count && a->triangle_count == b->triangle_count,
           "a mesh keeps its counts");
    demand_same(a->points, b->points, 3 * n, "points of a mesh");
    demand(m == 0 || memcmp(a->corners, b->corners, 3 * m * sizeof(int)) == 0,
           "corners of triangles");
    demand_same(a->normals, b->normals, 9 * m, "normals of a mesh");
    demand((a->colours == NULL) == (b->colours == NULL), "a mesh keeps its colours");
    for (size_t i = 0; a->colours && i < 3 * n; i++)
        demand(fabs(a->colours[i] - b->colours[i]) < 1 / 255.0, "colours of a mesh");
    demand(a->attribute_count == b->attribute_count, "a mesh keeps its attributes");
    for (int k = 0; k < a->attribute_count; k++)
        demand_same(a->attributes[k].values, b->attributes[k].values, n, "attributes");
}

/* A curve or a surface that is not clamped is written clamped: another form of the same shape.
 */
static int is_clamped(const batten_object *object)
{
    if (object->curve)
        return batten_curve_is_clamped(object->curve);
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        const double *knots = batten_surface_knots(object->surface, direction);
        const int p = batten_surface_degree(object->surface, direction);
        const int n = batten_surface_point_count(object->surface, direction);
        if (knots[0] != knots[p] || knots[n] != knots[n + p])
            return 0;
    }
    return 1;
}

/* STEP leaves out surfaces whose borders are points within its accuracy of a micrometre. */
static int is_tiny(const batten_model *model, const batten_surface *surface)
{
    const batten_box box = batten_surface_box(surface);
    const double metres = batten_model_unit_metres(model);
    return !(hypot(hypot(box.high.x - box.low.x, box.high.y - box.low.y),
                   box.high.z - box.low.z) > 1e-5 / (metres > 0 ? metres : 0.001));
}

/* Bodies, meshes and instances come back in other parts from formats that have less: then only
 * the bytes of the second writing tell. */
static int has_only_shapes(const batten_model *model, batten_format format)
{
    const int has_meshes = format == BATTEN_FORMAT_STL || format == BATTEN_FORMAT_PLY ||
                           format == BATTEN_FORMAT_OBJ;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        const batten_object_kind kind = object->kind;
        if (kind > BATTEN_OBJECT_TRIANGLES && !(kind == BATTEN_OBJECT_MESH && has_meshes))
            return 0;
        if (format == BATTEN_FORMAT_STEP && object->surface && is_tiny(model, object->surface))
            return 0;
    }
    return 1;
}

/* A format without the unit of a model has it in another, where places are rounded. */
static int has_unit_of(const batten_model *back, const batten_model *model)
{
    const double metres = batten_model_unit_metres(model);
    return !(metres > 0) || fabs(batten_model_unit_metres(back) - metres) <= 1e-12 * metres;
}

/* @param weighs  the format has products of points and weights, of which points come back
 * rounded */
static void same_object(const batten_object *p, const batten_object *q, bool weighs)
{
    demand(p->kind == q->kind && p->point_count == q->point_count, "an object keeps its kind");
    demand_same(p->points, q->points, 3 * (size_t)p->point_count, "points");
    if (p->curve && is_clamped(p))
        same_curve(p->curve, q->curve, weighs);
    if (p->surface && is_clamped(p))
        same_surface(p->surface, q->surface, weighs);
    if (p->mesh)
        same_mesh(batten_mesh_view(p->mesh), batten_mesh_view(q->mesh));
    if (p->offset_table)
        same_offsets(p->offset_table, q->offset_table);
}

/* STEP has the surfaces of a model before its curves and points, each in their order. */
static void same_model(const batten_model *a, const batten_model *b, batten_format format)
{
    const int passes = format == BATTEN_FORMAT_STEP ? 2 : 1, count = batten_model_count(a);
    int k = 0;
    demand(batten_model_count(b) == count, "a model keeps its objects");
    for (int pass = 0; pass < passes; pass++)
        for (int i = 0; i < count; i++) {
            const batten_object *object = batten_model_object(a, i);
            if (passes == 1 || (object->kind == BATTEN_OBJECT_SURFACE) == (pass == 0))
                same_object(object, batten_model_object(b, k++), format == BATTEN_FORMAT_G2);
        }
}

/* No file has more points than bytes; what is made of fewer, offsets, ends there too, which
 * else takes most of the time. */
static batten_status read_as(const char *data, size_t size, batten_format format, size_t most,
                             batten_notes *notes, batten_model **out)
{
    batten_limits limits = batten_limits_defaults();
    batten_read_options options = batten_read_defaults();
    limits.points = size + 1;
    limits.entities = most;
    options.limits = &limits;
    options.format = format;
    return batten_read_memory(data, size, &options, NULL, notes, out);
}

static batten_status write_as(const batten_model *model, batten_format format, int as_text,
                              char **data, size_t *size)
{
    batten_write_options options = batten_write_defaults();
    options.format = format;
    options.as_text = as_text != 0;
    return batten_write_memory(model, &options, NULL, data, size);
}

/* Or instances, which may be of bodies. */
static int has_bodies(const batten_model *model)
{
    for (int i = 0; model && i < batten_model_count(model); i++)
        if (batten_model_object(model, i)->kind == BATTEN_OBJECT_BODY ||
            batten_model_object(model, i)->kind == BATTEN_OBJECT_INSTANCE)
            return 1;
    return 0;
}

/* Is everything where numbers still tell places apart that are 1e-6 away from one another?
 * Beyond it, borders that differ may become one, and faces are bodies or surfaces as rounding
 * has it. */
static int is_near(const batten_model *model)
{
    batten_box box;
    if (!batten_model_box(model, &box))
        return 1;
    const double reach[6] = {box.low.x,  box.low.y,  box.low.z,
                             box.high.x, box.high.y, box.high.z};
    for (int k = 0; k < 6; k++)
        if (!(fabs(reach[k]) <= 1e9))
            return 0;
    return 1;
}

/* Does a curve end farther from its vertex than the tolerance? */
static int has_gaps(const batten_body *body)
{
    const batten_body_parts *parts = batten_body_view(body);
    for (int i = 0; i < parts->edge_count; i++)
        for (int k = 0; parts->edges[i].curve && k < 2; k++) {
            const batten_curve *curve = parts->edges[i].curve;
            const batten_interval domain = batten_curve_domain(curve);
            const double *vertex = &parts->vertices[3 * (size_t)parts->edges[i].vertices[k]];
            double end[3];
            if (batten_curve_evaluate_side(curve, k ? domain.b : domain.a,
                                           k ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 0,
                                           end) != BATTEN_OK ||
                !(hypot(hypot(end[0] - vertex[0], end[1] - vertex[1]), end[2] - vertex[2]) <=
                  2 * parts->tolerance))
                return 1;
        }
    return 0;
}

/* An accuracy that no reader believes of a shape of this size: it takes a better one, and finds
 * gaps. */
static int is_coarse(const batten_body *body)
{
    const batten_box box = batten_body_box(body);
    return !(hypot(hypot(box.high.x - box.low.x, box.high.y - box.low.y),
                   box.high.z - box.low.z) > 200 * batten_body_view(body)->tolerance);
}

/* Loops that cross, edges of no length or of three faces. */
static int has_faults(const batten_body *body)
{
    batten_body_faults faults;
    return batten_body_check(body, batten_body_view(body)->tolerance, NULL, NULL, &faults) !=
               BATTEN_OK ||
           faults.crossing_loops || faults.tiny_edges || faults.crowded_edges;
}

/* Faces whose edges are farther off than the tolerance, or off their vertices, or cross: what
 * is made of them again and again comes out near the same, not the same. */
static int has_loose_faces(const batten_model *model)
{
    batten_model *flat = NULL;
    int loose = batten_model_flat(model, &flat) != BATTEN_OK;
    for (int i = 0; !loose && i < batten_model_count(flat); i++) {
        const batten_body *body = batten_model_object(flat, i)->body;
        batten_body_trace_report report = {0};
        batten_body *traced = NULL;
        if (!body)
            continue;
        loose = is_coarse(body) || has_gaps(body) ||
                batten_body_trace(body, batten_body_view(body)->tolerance, NULL, NULL, &report,
                                  &traced) != BATTEN_OK ||
                report.loose || report.failed || has_faults(traced);
        batten_body_unref(traced);
    }
    batten_model_unref(flat);
    return loose;
}

/* Specks beside much larger shapes are below what readers take for the accuracy. */
static int has_tiny(const batten_model *model)
{
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->surface && is_tiny(model, object->surface))
            return 1;
    }
    return 0;
}

/* Faces that are written as they are may be left out when they are read again. */
static int may_fall_out(const batten_model *model, batten_format format)
{
    if (format == BATTEN_FORMAT_STEP)
        return !is_near(model) || has_tiny(model) || has_loose_faces(model);
    return has_bodies(model);
}

/* What was written must read; its second writing is handed back. Where faces fall out, NULL.
 * @param writing  which it is; the second and later ones have the parts of faces that were
 * divided, and no more of the points of the model to the bit */
static char *write_again(const batten_model *model, int writing, const char *first,
                         size_t first_size, batten_format format, int as_text, size_t *size)
{
    enum { MOST = 1000000 }; /* more than what was read at first can be written as */
    batten_model *back = NULL;
    char *second = NULL;
    const batten_status reading = read_as(first, first_size, format, MOST, NULL, &back);
    if (reading != BATTEN_OK && may_fall_out(model, format)) {
        batten_model_unref(back);
        return NULL;
    }
    demand(reading == BATTEN_OK, "what was written reads back");
    /* The bytes of STL are floats, and of one object: only what they hold comes back. */
    if (writing == 1 && has_only_shapes(model, format) && has_only_shapes(back, format) &&
        (format != BATTEN_FORMAT_STL || as_text) && has_unit_of(back, model))
        same_model(model, back, format);
    demand(write_as(back, format, as_text, &second, size) == BATTEN_OK, "it is written again");
    batten_model_unref(back);
    return second;
}

/* The same of what is read from text that was written. */
static int reads_loose(const char *text, size_t size, batten_format format)
{
    batten_model *back = NULL;
    const batten_status reading = read_as(text, size, format, 1000000, NULL, &back);
    const int loose = reading != BATTEN_OK || has_loose_faces(back);
    batten_model_unref(back);
    return loose;
}

/* What was written must read, and write the same. STEP gives what has no name that of its
 * product, and faces that are bad get curves in their parameters that are made again within
 * the accuracy of the file: their bytes stay from the second writing on, or from one of the
 * next when an edge bounds a face more than twice. */
static void check_written(const batten_model *model, const char *first, size_t first_size,
                          batten_format format, int as_text)
{
    enum { MOST = 5 };
    const int writings = format == BATTEN_FORMAT_STEP || has_bodies(model) ? MOST : 2;
    size_t size = 0;
    char *text = write_again(model, 1, first, first_size, format, as_text, &size);
    int same = text && size == first_size && memcmp(text, first, size) == 0;
    for (int k = 2; k < writings && text && !same; k++) {
        size_t next_size = 0;
        char *next = write_again(model, k, text, size, format, as_text, &next_size);
        same = next && size == next_size && memcmp(text, next, size) == 0;
        batten_release(text);
        text = next;
        size = next_size;
    }
    demand(!text || same ||
               (writings > 2 &&
                (!is_near(model) || has_loose_faces(model) || reads_loose(text, size, format))),
           "the writings come to the same bytes");
    batten_release(text);
}

/* What the content and the name tell alone: one of the formats, or a refusal. */
static void check_recognition(const char *data, size_t size)
{
    bat_input input;
    batten_format format = BATTEN_FORMAT_AUTO;
    batten_read_options options = batten_read_defaults();
    options.file_name = "fuzz." FUZZ_NAME;
    if (bat_input_begin(data, size, &options, NULL, NULL, &input) == BATTEN_OK)
        demand((bat_recognise(&input, &format) == BATTEN_OK) == (format != BATTEN_FORMAT_AUTO),
               "a format comes with success alone");
}

/* The quick targets write one of so many inputs: most of the time of the others goes there. */
#ifndef FUZZ_WRITTEN_OF
#define FUZZ_WRITTEN_OF 1
#endif

static int is_to_be_written(const uint8_t *data, size_t size)
{
    uint32_t sum = 0;
    for (size_t i = 0; FUZZ_WRITTEN_OF > 1 && i < size; i++)
        sum = 31 * sum + data[i];
    return (sum >> 16) % FUZZ_WRITTEN_OF == 0;
}

void fuzz_promise(const uint8_t *data, size_t size, batten_format read, batten_format written)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    const int has_two = written == BATTEN_FORMAT_STL || written == BATTEN_FORMAT_PLY;
    const int forms = !is_to_be_written(data, size) ? 0 : has_two ? 2 : 1;
    check_recognition((const char *)data, size);
    if (batten_notes_create(20, &notes) != BATTEN_OK)
        return;
    const batten_status status = read_as((const char *)data, size, read, 10000, notes, &model);
    demand((status == BATTEN_OK || status == BATTEN_PARTLY_READ) == (model != NULL),
           "a model comes with success alone");
    for (int as_text = 0; model && batten_model_count(model) > 0 && as_text < forms;
         as_text++) {
        char *first = NULL;
        size_t first_size = 0;
        if (write_as(model, written, as_text, &first, &first_size) == BATTEN_OK)
            check_written(model, first, first_size, written, as_text);
        batten_release(first);
    }
    batten_model_unref(model);
    batten_notes_free(notes);
}

static double extent(const batten_box *box)
{
    return box->high.x - box->low.x + box->high.y - box->low.y;
}

/* Are all curves where numbers tell their points apart, and longer than rounding? They are
 * moved to the sheet, which costs those that are specks on it their last places. */
static bool is_sizable(const batten_model *model)
{
    batten_box sheet;
    if (!is_near(model) || !batten_model_box(model, &sheet))
        return false;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        batten_box box;
        if (object->kind != BATTEN_OBJECT_CURVE)
            continue;
        box = batten_curve_box(object->curve);
        if (!(extent(&box) > fmax(1e-3, 1e-6 * extent(&sheet))))
            return false;
    }
    return true;
}

void fuzz_reads_back(const uint8_t *data, size_t size, batten_format format)
{
    batten_model *model = NULL, *back = NULL;
    char *written = NULL;
    size_t length = 0;
    if (is_to_be_written(data, size))
        (void)read_as((const char *)data, size, format, 10000, NULL, &model);
    if (model && is_sizable(model) &&
        write_as(model, format, 0, &written, &length) == BATTEN_OK)
        demand(read_as(written, length, format, 1000000, NULL, &back) == BATTEN_OK,
               "what was written reads back whole");
    batten_release(written);
    batten_model_unref(model);
    batten_model_unref(back);
}
