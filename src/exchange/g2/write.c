/* Writes points, curves, surfaces and bodies as .g2 objects. */
#include "base/plural.h"
#include "exchange/g2/g2.h"
#include "exchange/shapes/prepare.h"

#include <batten/standard.h>
#include <stdio.h>

typedef struct {
    batten_text *text;
    batten_notes *notes;
    double tolerance;
    int loose;      /* faces of the object at work with a tolerance of their own ... */
    double loosest; /* ... and the largest of these */
    int changed;    /* coordinates of the object at work that cannot be kept bit for bit */
} writing;

static void put_number(writing *w, double value, const char *after)
{
    batten_text_number(w->text, value);
    batten_text_bytes(w->text, after, 1);
}

/* The header, with the colour. */
static void begin_object(writing *w, int class, bool has_colour, const double colour[3])
{
    batten_text_add(w->text, "%d 1 0 %d", class, has_colour ? 4 : 0);
    for (int k = 0; k < 3 && has_colour; k++)
        batten_text_add(w->text, " %d", (int)floor(255 * colour[k] + 0.5));
    batten_text_add(w->text, has_colour ? " 255\n" : "\n");
}

/*
 * The file has w x, of which a reader makes x by division; that rounds. Of the numbers near w x
 * the first that gives x back is taken, in an order that depends on x and w alone.
 */
static double weighted(double x, double w, bool *is_kept)
{
    const double middle = x * w;
    double low = middle, high = middle;
    *is_kept = true;
    for (int i = 0; i < 3; i++) {
        if (low / w == x)
            return low;
        if (high / w == x)
            return high;
        low = nextafter(low, -INFINITY);
        high = nextafter(high, INFINITY);
    }
    *is_kept = false;
    return middle;
}

/* When x cannot be kept, what is read instead of it is written as it will be the next time. */
static void put_weighted(writing *w, double x, double weight)
{
    bool is_kept = true;
    double value = weighted(x, weight, &is_kept);
    if (!is_kept) {
        w->changed++;
        value = weighted(value / weight, weight, &is_kept);
    }
    put_number(w, value, " ");
}

static void put_point(writing *w, int dimension, const double *point, const double *weight)
{
    for (int k = 0; k < dimension; k++)
        if (weight)
            put_weighted(w, point[k], *weight);
        else
            put_number(w, point[k], k + 1 < dimension ? " " : "\n");
    if (weight)
        put_number(w, *weight, "\n");
}

static void put_axis(writing *w, int degree, int count, const double *knots)
{
    batten_text_add(w->text, "%d %d\n", count, degree + 1);
    for (int i = 0; i < count + degree + 1; i++)
        put_number(w, knots[i], i < count + degree ? " " : "\n");
}

/* The body of a spline curve, in its own dimension. */
static void put_curve(writing *w, const batten_curve *curve)
{
    const int dimension = batten_curve_dimension(curve);
    const int count = batten_curve_point_count(curve);
    const double *points = batten_curve_points(curve), *weights = batten_curve_weights(curve);
    batten_text_add(w->text, "%d %d\n", dimension, weights ? 1 : 0);
    put_axis(w, batten_curve_degree(curve), count, batten_curve_knots(curve));
    for (int i = 0; i < count; i++)
        put_point(w, dimension, &points[(size_t)i * (size_t)dimension],
                  weights ? &weights[i] : NULL);
}

static void put_surface(writing *w, const batten_surface *surface)
{
    const int count_u = batten_surface_point_count(surface, BATTEN_U);
    const int count_v = batten_surface_point_count(surface, BATTEN_V);
    const double *points = batten_surface_points(surface);
    const double *weights = batten_surface_weights(surface);
    batten_text_add(w->text, "3 %d\n", weights ? 1 : 0);
    for (int d = 0; d < 2; d++)
        put_axis(w, batten_surface_degree(surface, (batten_direction)d),
                 batten_surface_point_count(surface, (batten_direction)d),
                 batten_surface_knots(surface, (batten_direction)d));
    for (int j = 0; j < count_v; j++)
        for (int i = 0; i < count_u; i++) {
            const size_t at = (size_t)i * (size_t)count_v + (size_t)j;
            put_point(w, 3, &points[3 * at], weights ? &weights[at] : NULL);
        }
}

static void note_changed(writing *w, const char *name)
{
    if (w->changed > 0)
        batten_notes_add(w->notes, "", 0, name,
                         "the format has points times weights; %d coordinate%s back changed "
                         "in the last place",
                         w->changed, bat_one_or_many(w->changed, " comes", "s come"));
    w->changed = 0;
}

/* ---- faces ---- */

/* The curve in space of a use, which runs as the loop does; NULL for a pole. */
static batten_status directed(const batten_curve *curve, bool reversed, batten_curve **out)
{
    if (reversed)
        return batten_curve_reverse(curve, out);
    *out = batten_curve_ref(curve);
    return BATTEN_OK;
}

/* A curve of a loop: that in the parameters when there is one, and that in space. A pole has
 * its point as a line of no length. */
static batten_status put_trim(writing *w, const batten_body_parts *parts,
                              const batten_body_use *use)
{
    const batten_body_edge *edge = &parts->edges[use->edge];
    const double *point = &parts->vertices[3 * (size_t)edge->vertices[0]];
    batten_curve *space = NULL, *parameters = NULL;
    batten_status status = BATTEN_OK;
    if (edge->curve)
        status = directed(edge->curve, use->reversed, &space);
    else
        status = batten_curve_line(3, point, point, &space);
    if (status == BATTEN_OK && use->parameters)
        status = directed(use->parameters, use->reversed, &parameters);
    if (status == BATTEN_OK) {
        batten_text_add(w->text, "0 %d %d\n", parameters ? BAT_G2_CURVE : 0, BAT_G2_CURVE);
        if (parameters)
            put_curve(w, parameters);
        put_curve(w, space);
    }
    batten_curve_unref(space);
    batten_curve_unref(parameters);
    return status;
}

/* The loop in the direction that is counter-clockwise in (u, v). */
static batten_status put_loop(writing *w, const batten_body_parts *parts,
                              const batten_body_loop *loop, double tolerance, bool turned)
{
    batten_status status = BATTEN_OK;
    batten_text_add(w->text, "%d ", loop->count);
    put_number(w, tolerance, "\n");
    for (int k = 0; status == BATTEN_OK && k < loop->count; k++) {
        batten_body_use use = parts->uses[loop->first + (turned ? loop->count - 1 - k : k)];
        use.reversed ^= turned;
        status = put_trim(w, parts, &use);
    }
    return status;
}

static batten_status put_face(writing *w, const batten_object *object,
                              const batten_body_parts *parts, const batten_body_face *face)
{
    const bool own = face->has_colour;
    const double *colour = own ? face->colour : object->colour;
    batten_surface *surface = NULL;
    const batten_object shown = {.name = object->name, .surface = face->surface};
    batten_status status = bat_prepare_surface(&shown, w->tolerance, w->notes, &surface);
    if (status != BATTEN_OK)
        return status;
    double tolerance = 0;
    status = bat_g2_loop_tolerance(parts, face, surface, &tolerance);
    w->loose += tolerance > parts->tolerance;
    w->loosest = bat_max(w->loosest, tolerance);
    begin_object(w, face->count ? BAT_G2_BOUNDED_SURFACE : BAT_G2_SURFACE,
                 own || object->has_colour, colour);
    if (face->count)
        batten_text_add(w->text, "%d\n", BAT_G2_SURFACE);
    put_surface(w, surface);
    if (face->count)
        batten_text_add(w->text, "%d\n", face->count);
    for (int k = 0; status == BATTEN_OK && k < face->count; k++)
        status = put_loop(w, parts, &parts->loops[face->first + k], tolerance, face->reversed);
    batten_surface_unref(surface);
    return status;
}

static batten_status put_body(writing *w, const batten_object *object)
{
    const batten_body_parts *parts = batten_body_view(object->body);
    bool turned = false;
    batten_status status = BATTEN_OK;
    w->loose = 0;
    w->loosest = 0;
    for (int i = 0; status == BATTEN_OK && i < parts->face_count; i++) {
        turned |= parts->faces[i].reversed;
        status = put_face(w, object, parts, &parts->faces[i]);
    }
    if (status == BATTEN_OK && parts->face_count > 1)
        batten_notes_add(w->notes, "", 0, object->name,
                         "%d face%s %s written one by one: the format has no shells",
                         parts->face_count, bat_plural(parts->face_count),
                         bat_one_or_many(parts->face_count, "is", "are"));
    if (status == BATTEN_OK && w->loose > 0)
        batten_notes_add(w->notes, "", 0, object->name,
                         "the edges of %d face%s are farther off %s than the tolerance %g: "
                         "their loops have tolerances up to %g",
                         w->loose, bat_plural(w->loose),
                         bat_one_or_many(w->loose, "it", "them"), parts->tolerance, w->loosest);
    if (status == BATTEN_OK && turned)
        batten_notes_add(w->notes, "", 0, object->name,
                         "the sides of reversed faces are lost: the format has none");
    return status;
}

/* ---- the whole ---- */

static batten_status keep_object(const batten_curve *curve, batten_curve **out)
{
    *out = batten_curve_ref(curve);
    return BATTEN_OK;
}

static batten_status put_object(writing *w, const batten_object *object)
{
    batten_curve *curve = NULL;
    batten_surface *surface = NULL;
    batten_status status = BATTEN_OK;
    if (object->kind == BATTEN_OBJECT_BODY) {
        status = put_body(w, object);
    } else if (object->kind == BATTEN_OBJECT_POINTS) {
        begin_object(w, BAT_G2_POINTS, object->has_colour, object->colour);
        batten_text_add(w->text, "%d\n", object->point_count);
        for (int i = 0; i < object->point_count; i++)
            put_point(w, 3, &object->points[3 * (size_t)i], NULL);
    } else if (object->kind == BATTEN_OBJECT_CURVE) {
        status = batten_curve_is_clamped(object->curve)
                     ? keep_object(object->curve, &curve)
                     : batten_curve_clamp(object->curve, &curve);
        if (status == BATTEN_OK) {
            begin_object(w, BAT_G2_CURVE, object->has_colour, object->colour);
            put_curve(w, curve);
        }
    } else {
        status = bat_prepare_surface(object, w->tolerance, w->notes, &surface);
        if (status == BATTEN_OK) {
            begin_object(w, BAT_G2_SURFACE, object->has_colour, object->colour);
            put_surface(w, surface);
        }
    }
    batten_curve_unref(curve);
    batten_surface_unref(surface);
    note_changed(w, object->name);
    return status;
}

batten_status bat_write_g2(const batten_model *model, const batten_write_options *options,
                           batten_notes *notes, batten_text *text)
{
    const double unit = batten_model_unit_metres(model);
    writing w = {.text = text,
                 .notes = notes,
                 .tolerance = options->tolerance > 0
                                  ? options->tolerance
                                  : BAT_WRITE_TOLERANCE / (unit > 0 ? unit : 0.001)};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        status = put_object(&w, batten_model_object(model, i));
    if (status == BATTEN_OK && unit > 0 && batten_unit_name(unit))
        batten_notes_remark(notes, "", 0, "", "the format has no unit; its numbers are in %s",
                            batten_unit_name(unit));
    return status;
}
