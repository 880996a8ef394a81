/* Writes curves as SVG paths. */
#include "exchange/shapes/path.h"
#include "exchange/svg/elliptical.h"
#include "exchange/svg/svg.h"
#include "numeric/vector.h"

#include <float.h>
#include <string.h>

/* SVG counts y downwards, and its numbers are millimetres here. */
typedef struct {
    batten_text *text;
    double scale, left, top, bottom, tolerance;
    double rounding; /* of coordinates: halving makes nothing nearer than that */
    int shapes;
    double off;   /* of the object: how far cubics are from it, where they are not it */
    bool upright; /* all curves stand upright on the sheet, which is said once */
} writing;

enum { DEPTH = 24 };

static void put_point(writing *w, char command, double x, double y)
{
    batten_text_add(w->text, "%c", command);
    batten_text_number(w->text, w->scale * (x - w->left));
    batten_text_add(w->text, " ");
    batten_text_number(w->text, w->scale * (w->top - y));
}

/* NULL for what stands for itself. */
static const char *entity_of(char c)
{
    return c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : NULL;
}

static void put_attribute(batten_text *text, const char *name, const char *value)
{
    batten_text_add(text, " %s=\"", name);
    for (; *value; value++) {
        const char *entity = entity_of(*value);
        if (entity)
            batten_text_add(text, "%s", entity);
        else
            batten_text_bytes(text, (unsigned char)*value < ' ' ? "_" : value, 1);
    }
    batten_text_add(text, "\"");
}

static void begin_shape(writing *w, const batten_object *object)
{
    char colour[8] = "#000000";
    static const char digits[] = "0123456789abcdef";
    for (int k = 0; object->has_colour && k < 3; k++) {
        const int part = (int)(object->colour[k] * 255 + 0.5);
        colour[1 + 2 * k] = digits[part / 16];
        colour[2 + 2 * k] = digits[part % 16];
    }
    batten_text_add(w->text, "<path fill=\"none\" stroke-width=\"0.1\" stroke=\"%s\"", colour);
    if (object->name[0])
        put_attribute(w->text, "id", object->name);
    if (object->layer[0])
        put_attribute(w->text, "class", object->layer);
    if (object->is_hidden)
        batten_text_add(w->text, " display=\"none\"");
    batten_text_add(w->text, " d=\"");
    w->shapes++;
}

static void end_shape(writing *w)
{
    batten_text_add(w->text, "\"/>\n");
}

/* ---- paths of lines and arcs ---- */

/* The plane of the path as it lies on the sheet; false when it stands upright on it. */
static bool lies_flat(const bat_path *path)
{
    return path->frame.x.z == 0 && path->frame.z.x == 0 && path->frame.z.y == 0;
}

static bat_vertex on_sheet(const bat_path *path, int i)
{
    const bat_vertex v = path->vertices[i % path->count];
    const batten_frame *f = &path->frame;
    const batten_vec3 y = bat_vec3_cross(f->z, f->x);
    return (bat_vertex){f->origin.x + v.x * f->x.x + v.y * y.x,
                        f->origin.y + v.x * f->x.y + v.y * y.y,
                        f->z.z < 0 ? -v.bulge : v.bulge};
}

static void put_arc(writing *w, const bat_svg_elliptical *arc, double x, double y)
{
    batten_text_add(w->text, "A");
    batten_text_number(w->text, w->scale * arc->rx);
    batten_text_add(w->text, " ");
    batten_text_number(w->text, w->scale * arc->ry);
    batten_text_add(w->text, " ");
    batten_text_number(w->text, arc->angle != 0 ? -arc->angle * 180 / BAT_PI : 0);
    batten_text_add(w->text, " 0 %d", arc->is_clockwise);
    put_point(w, ' ', x, y);
}

static void put_side(writing *w, const bat_vertex *from, const bat_vertex *to)
{
    if (from->bulge == 0) {
        put_point(w, 'L', to->x, to->y);
    } else {
        double cx, cy, radius;
        bat_path_centre(from, to->x, to->y, &cx, &cy, &radius);
        put_arc(w, &(bat_svg_elliptical){radius, radius, 0, from->bulge < 0}, to->x, to->y);
    }
}

static void put_path(writing *w, const bat_path *path)
{
    bat_vertex from = on_sheet(path, 0);
    const int moves = path->closed ? path->count : path->count - 1;
    put_point(w, 'M', from.x, from.y);
    for (int i = 1; i <= moves; i++) {
        const bat_vertex to = on_sheet(path, i);
        put_side(w, &from, &to);
        from = to;
    }
    if (path->closed)
        batten_text_add(w->text, "Z");
}

/* ---- other curves: elliptical arcs, or cubics within the tolerance ---- */

/* The cubic with the curve's points and tangents at a and b, on the sheet. */
static batten_status cubic(const batten_curve *curve, double a, double b, double points[4][2])
{
    double at[2][2 * 3];
    const int d = batten_curve_dimension(curve);
    batten_status status = batten_curve_evaluate(curve, a, 1, at[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, b, BATTEN_FROM_LEFT, 1, at[1]);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        points[0][k] = at[0][k];
        points[1][k] = at[0][k] + (b - a) / 3 * at[0][d + k];
        points[2][k] = at[1][k] - (b - a) / 3 * at[1][d + k];
        points[3][k] = at[1][k];
    }
    return status;
}

/* How far the cubic is from the curve at equal parameters, at three places between. */
static batten_status distance(const batten_curve *curve, double a, double b,
                              const double points[4][2], double *largest)
{
    *largest = 0;
    for (int i = 1; i <= 3; i++) {
        const double t = i / 4.0, s = 1 - t;
        double at[3], near[2];
        const batten_status status = batten_curve_evaluate(curve, a + t * (b - a), 0, at);
        if (status != BATTEN_OK)
            return status;
        for (int k = 0; k < 2; k++)
            near[k] = s * s * s * points[0][k] + 3 * s * s * t * points[1][k] +
                      3 * s * t * t * points[2][k] + t * t * t * points[3][k];
        *largest = bat_max(*largest, bat_distance(2, at, near));
    }
    return BATTEN_OK;
}

/* How far points of the curve are off where its parameter is rounded: no halving mends that. */
static double blur_of_parameter(double a, double b, const double points[4][2])
{
    const double speed =
        3 / (b - a) *
        bat_max(bat_distance(2, points[0], points[1]), bat_distance(2, points[2], points[3]));
    return DBL_EPSILON * bat_max(fabs(a), fabs(b)) * speed;
}

/* Of an exact span a cubic differs by rounding alone, and is not halved. */
static batten_status put_span(writing *w, const batten_curve *curve, double a, double b,
                              bool is_exact)
{
    double ends[DEPTH + 2] = {b};
    batten_status status = BATTEN_OK;
    for (int waiting = 1; waiting > 0 && status == BATTEN_OK;) {
        double points[4][2] = {{0}}, off = 0;
        b = ends[waiting - 1];
        status = cubic(curve, a, b, points);
        if (status == BATTEN_OK)
            status = distance(curve, a, b, (const double(*)[2])points, &off);
        const double rounding =
            bat_max(w->rounding, blur_of_parameter(a, b, (const double(*)[2])points));
        if (!is_exact && off > bat_max(w->tolerance, rounding) && waiting <= DEPTH) {
            ends[waiting++] = a + (b - a) / 2;
            continue;
        }
        if (!is_exact && off > bat_min(w->tolerance, w->rounding))
            w->off = bat_max(w->off, off);
        for (int k = 1; k < 4; k++)
            put_point(w, k == 1 ? 'C' : ' ', points[k][0], points[k][1]);
        a = b;
        waiting--;
    }
    return status;
}

/* A Bezier piece of degree 3 at most is a cubic when its weights are the same. */
static bool is_cubic(const double *weights, int degree)
{
    for (int i = 1; weights && i <= degree; i++)
        if (weights[i] != weights[0])
            return false;
    return degree <= 3;
}

/* Span i, of which `pieces` has the Bezier points. */
static batten_status put_piece(writing *w, const batten_curve *curve,
                               const batten_curve *pieces, int i, const double *breaks)
{
    const int d = batten_curve_dimension(curve), p = batten_curve_degree(curve);
    const double *points = batten_curve_points(pieces) + (size_t)(i * p) * (size_t)d;
    const double *weights = batten_curve_weights(pieces);
    bat_svg_elliptical arc;
    if (weights)
        weights += i * p;
    const bool is_exact = is_cubic(weights, p);
    if (!is_exact && weights &&
        bat_svg_is_elliptical(d, p, points, weights, w->rounding, &arc)) {
        put_arc(w, &arc, points[p * d], points[p * d + 1]);
        return BATTEN_OK;
    }
    return put_span(w, curve, breaks[i], breaks[i + 1], is_exact);
}

static batten_status put_curve(writing *w, const batten_curve *curve)
{
    const int count = batten_curve_spans(curve, NULL);
    double *breaks = bat_array((size_t)count, sizeof *breaks), start[3];
    batten_curve *pieces = NULL;
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, breaks);
    batten_status status = batten_curve_evaluate(curve, breaks[0], 0, start);
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(curve, &pieces);
    if (status == BATTEN_OK)
        put_point(w, 'M', start[0], start[1]);
    for (int i = 0; i + 1 < count && status == BATTEN_OK; i++)
        status = put_piece(w, curve, pieces, i, breaks);
    batten_curve_unref(pieces);
    bat_release(breaks);
    return status;
}

/* ---- the whole ---- */

static void note_off(const writing *w, const batten_object *object, batten_notes *notes)
{
    if (w->off > w->tolerance)
        batten_notes_add(notes, "", 0, object->name,
                         "approximated within %g, not within the tolerance %g", w->off,
                         w->tolerance);
    else if (w->off > 0)
        batten_notes_add(notes, "", 0, object->name, "approximated within %g", w->off);
}

static batten_status put_object(writing *w, const batten_object *object, batten_notes *notes)
{
    bool is_path = false;
    bat_path path = {0};
    if (batten_curve_dimension(object->curve) < 2) {
        batten_notes_add(notes, "", 0, object->name, "left out: this curve lies in no plane");
        return BATTEN_OK;
    }
    const batten_box box = batten_curve_box(object->curve);
    if (box.high.x == box.low.x && box.high.y == box.low.y) {
        batten_notes_add(notes, "", 0, object->name,
                         "left out: this curve is one point of the sheet");
        return BATTEN_OK;
    }
    if (box.high.z > box.low.z && !w->upright)
        batten_notes_add(notes, "", 0, object->name,
                         "it is drawn as seen along z; its extent from z = %g to %g is lost",
                         box.low.z, box.high.z);
    batten_status status = bat_path_of(object, &is_path, &path);
    if (status != BATTEN_OK)
        return status;
    begin_shape(w, object);
    w->off = 0;
    if (is_path && lies_flat(&path) && path.count > 1)
        put_path(w, &path);
    else
        status = put_curve(w, object->curve);
    end_shape(w);
    note_off(w, object, notes);
    bat_path_release(&path);
    return status;
}

/* Does every curve lie in a plane x = constant or y = constant, and does one reach up in it?
 * To the tolerance of the drawing. */
static bool are_upright(const batten_model *model, double within)
{
    bool reaches = false;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_box box = batten_curve_box(batten_model_object(model, i)->curve);
        if (box.high.x - box.low.x > within && box.high.y - box.low.y > within)
            return false;
        reaches |= box.high.z - box.low.z > within;
    }
    return reaches;
}

static void note_upright(batten_notes *notes)
{
    batten_notes_add(
        notes, "", 0, "",
        "all curves lie in planes x = constant or y = constant, which are straight "
        "strokes as seen along z; 'batten draw' with --view front or side shows "
        "their shapes, and the feature 'rotate' of a design turns them");
}

static void put_sheet(writing *w, double width, double height)
{
    batten_text_add(w->text, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
    batten_text_number(w->text, width);
    batten_text_add(w->text, "mm\" height=\"");
    batten_text_number(w->text, height);
    batten_text_add(w->text, "mm\" viewBox=\"0 0 ");
    batten_text_number(w->text, width);
    batten_text_add(w->text, " ");
    batten_text_number(w->text, height);
    batten_text_add(w->text, "\">\n");
}

static const double margin = 5; /* millimetres */

/* Scale, rounding and edges of a sheet around the box. */
static void settle_sheet(writing *w, double metres, batten_box box)
{
    w->scale = metres > 0 ? 1000 * metres : 1;
    w->rounding = 16 * DBL_EPSILON *
                  bat_max(bat_max(fabs(box.low.x), fabs(box.high.x)),
                          bat_max(fabs(box.low.y), fabs(box.high.y)));
    w->left = box.low.x - margin / w->scale;
    w->top = box.high.y + margin / w->scale;
    w->bottom = box.low.y - margin / w->scale;
}

static void begin_sheet(writing *w, const batten_model *model)
{
    const double metres = batten_model_unit_metres(model);
    batten_box box = {{0, 0, 0}, {0, 0, 0}};
    batten_model_box(model, &box);
    settle_sheet(w, metres, box);
    const double width = w->scale * (box.high.x - box.low.x) + 2 * margin;
    const double height = w->scale * (box.high.y - box.low.y) + 2 * margin;
    put_sheet(w, width, height);
}

batten_status bat_write_svg(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text)
{
    writing w = {.text = text};
    begin_sheet(&w, model);
    w.tolerance = options->tolerance > 0 ? options->tolerance : 1e-3 / w.scale;
    w.upright = are_upright(model, bat_max(w.rounding, w.tolerance));
    if (w.upright)
        note_upright(notes);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK; i++)
        status = put_object(&w, batten_model_object(model, i), notes);
    batten_text_add(text, "</svg>\n");
    if (batten_model_count(model) > 0)
        batten_notes_remark(notes, "", 0, "",
                            "the lower left corner of the sheet is x = %g, y = %g of the model",
                            w.left, w.bottom);
    if (status == BATTEN_OK && w.shapes == 0 && batten_model_count(model) > 0)
        status = bat_fail(BATTEN_UNSUPPORTED, "SVG files hold curves; the model has none");
    return status;
}
