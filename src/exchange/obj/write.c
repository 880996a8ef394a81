/* Writes points, curves, surfaces and meshes as OBJ. */
#include "exchange/meshes/facets.h"
#include "exchange/obj/obj.h"
#include "exchange/shapes/prepare.h"

#include <string.h>

typedef struct {
    batten_notes *notes;
    batten_text *text;
    long long vertices, normals; /* written so far */
    int in_line;                 /* numbers since the line began */
    double tolerance;
} writing;

static void put_words(writing *w, const char *words)
{
    batten_text_bytes(w->text, words, strlen(words));
}

static void put_number(writing *w, double value)
{
    put_words(w, " ");
    batten_text_number(w->text, value);
}

/* Long statements go on after a backslash. */
static void put_item(writing *w, double value)
{
    if (++w->in_line > 12) {
        put_words(w, " \\\n");
        w->in_line = 1;
    }
    put_number(w, value);
}

static void end_statement(writing *w)
{
    put_words(w, "\n");
    w->in_line = 0;
}

static void put_numbers(writing *w, int count, const double *values)
{
    for (int k = 0; k < count; k++)
        put_number(w, values[k]);
}

static void put_point(writing *w, const double *point, const double *weight,
                      const double *colour)
{
    put_words(w, "v");
    put_numbers(w, 3, point);
    if (weight)
        put_number(w, *weight);
    if (colour)
        put_numbers(w, 3, colour);
    put_words(w, "\n");
    w->vertices++;
}

/* ---- names ---- */

/* A word that begins with # would begin a comment. */
static char clean_character(char c, char before)
{
    if ((unsigned char)c < ' ')
        return ' ';
    return c == '#' && before == ' ' ? '_' : c;
}

static void put_name(writing *w, const char *statement, const char *name, const char *otherwise)
{
    const bat_span core = bat_name_core(name, otherwise);
    char before = ' ';
    batten_text_add(w->text, "%s ", statement);
    for (size_t i = 0; i < core.length; i++) {
        const char c = clean_character(core.bytes[i], before);
        batten_text_bytes(w->text, &c, 1);
        before = c;
    }
    put_words(w, "\n");
}

static void put_names(writing *w, const batten_object *object, const char *otherwise)
{
    if (object->group[0])
        put_name(w, "o", object->group, otherwise);
    put_name(w, object->group[0] ? "g" : "o", object->name, otherwise);
}

/* ---- meshes ---- */

/* The normals of corners, equal ones at a vertex once. */
static batten_status put_normals(writing *w, const batten_mesh_parts *p, bat_corners *corners)
{
    batten_status status = bat_number_corners(p, corners);
    for (int i = 0; i < corners->count; i++) {
        const double *n = p->normals + 3 * (size_t)corners->source[i];
        put_words(w, "vn");
        for (int k = 0; k < 3; k++)
            put_number(w, n[k]);
        put_words(w, "\n");
    }
    return status;
}

static void put_index(writing *w, long long index)
{
    batten_text_number(w->text, (double)index);
}

static void put_corner(writing *w, const batten_mesh_parts *p, long long first,
                       const bat_corners *corners, size_t i)
{
    put_index(w, first + p->corners[i]);
    if (p->normals) {
        put_words(w, "//");
        put_index(w, w->normals + 1 + corners->index[i]);
    }
}

static void put_vertices(writing *w, const batten_object *object, const batten_mesh_parts *p)
{
    for (size_t i = 0; i < (size_t)p->vertex_count; i++)
        put_point(w, p->points + 3 * i, NULL,
                  p->colours           ? p->colours + 3 * i
                  : object->has_colour ? object->colour
                                       : NULL);
}

static batten_status put_mesh(writing *w, const batten_object *object)
{
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    const long long first = w->vertices + 1;
    bat_corners corners = {0, NULL, NULL};
    put_names(w, object, "mesh");
    put_vertices(w, object, p);
    const batten_status status = p->normals ? put_normals(w, p, &corners) : BATTEN_OK;
    if (status != BATTEN_OK)
        return status;
    for (size_t i = 0; i < 3 * (size_t)p->triangle_count; i++) {
        put_words(w, i % 3 == 0 ? "f " : " ");
        put_corner(w, p, first, &corners, i);
        if (i % 3 == 2)
            put_words(w, "\n");
    }
    w->normals += corners.count;
    bat_corners_end(&corners);
    return BATTEN_OK;
}

/* ---- points and curves ---- */

/* Statements of at most 12 numbers. */
static void put_point_numbers(writing *w, long long first, int count)
{
    for (int i = 0; i < count; i++) {
        if (i % 12 == 0)
            put_words(w, i ? "\np" : "p");
        put_number(w, (double)(first + i));
    }
    put_words(w, count ? "\n" : "");
}

static void put_points(writing *w, const batten_object *object)
{
    const long long first = w->vertices + 1;
    put_names(w, object, "points");
    for (size_t i = 0; i < (size_t)object->point_count; i++)
        put_point(w, object->points + 3 * i, NULL, NULL);
    put_point_numbers(w, first, object->point_count);
}

/* The knots that the statement "l" means, to the bit: -0 is another. */
static bool is_line(const batten_curve *curve)
{
    const double *knots = batten_curve_knots(curve);
    const int n = batten_curve_point_count(curve);
    if (batten_curve_degree(curve) != 1 || batten_curve_weights(curve))
        return false;
    for (int i = 0; i < n; i++)
        if (knots[i + 1] != i || signbit(knots[i + 1]))
            return false;
    return knots[0] == 0 && !signbit(knots[0]) && knots[n + 1] == n - 1;
}

static void put_parameters(writing *w, const char *statement, int count, const double *knots)
{
    put_words(w, statement);
    for (int i = 0; i < count; i++)
        put_item(w, knots[i]);
    end_statement(w);
}

static void put_curve_type(writing *w, const batten_curve *curve)
{
    const batten_interval domain = batten_curve_domain(curve);
    put_words(w,
              batten_curve_weights(curve) ? "cstype rat bspline\ndeg" : "cstype bspline\ndeg");
    put_item(w, batten_curve_degree(curve));
    end_statement(w);
    put_words(w, "curv");
    put_item(w, domain.a);
    put_item(w, domain.b);
}

static void put_curve(writing *w, const batten_object *object, const batten_curve *curve)
{
    const int p = batten_curve_degree(curve), n = batten_curve_point_count(curve);
    const double *weights = batten_curve_weights(curve);
    const long long first = w->vertices + 1;
    put_names(w, object, is_line(curve) ? "line" : "curve");
    for (int i = 0; i < n; i++)
        put_point(w, batten_curve_points(curve) + 3 * i, weights ? weights + i : NULL, NULL);
    if (!is_line(curve))
        put_curve_type(w, curve);
    else
        put_words(w, "l");
    for (int i = 0; i < n; i++)
        put_item(w, (double)(first + i));
    end_statement(w);
    if (is_line(curve))
        return;
    put_parameters(w, "parm u", n + p + 1, batten_curve_knots(curve));
    put_words(w, "end\n");
}

/* ---- surfaces ---- */

static void put_surface_type(writing *w, const batten_surface *surface)
{
    for (int k = 0; k < 2; k++)
        put_item(w, batten_surface_degree(surface, k ? BATTEN_V : BATTEN_U));
    end_statement(w);
    put_words(w, "surf");
    for (int k = 0; k < 2; k++) {
        const batten_interval d = batten_surface_domain(surface, k ? BATTEN_V : BATTEN_U);
        put_item(w, d.a);
        put_item(w, d.b);
    }
}

static void put_surface_knots(writing *w, const batten_surface *surface)
{
    static const char *const parameters[] = {"parm u", "parm v"};
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        put_parameters(w, parameters[k], batten_surface_knot_count(surface, direction),
                       batten_surface_knots(surface, direction));
    }
}

static void put_surface(writing *w, const batten_object *object, const batten_surface *surface)
{
    const double *weights = batten_surface_weights(surface);
    const long long first = w->vertices + 1;
    int n[2];
    for (int k = 0; k < 2; k++)
        n[k] = batten_surface_point_count(surface, k ? BATTEN_V : BATTEN_U);
    put_names(w, object, "surface");
    for (size_t i = 0; i < (size_t)n[0] * (size_t)n[1]; i++)
        put_point(w, batten_surface_points(surface) + 3 * i, weights ? weights + i : NULL,
                  NULL);
    put_words(w, weights ? "cstype rat bspline\ndeg" : "cstype bspline\ndeg");
    put_surface_type(w, surface);
    for (int j = 0; j < n[1]; j++)
        for (int i = 0; i < n[0]; i++)
            put_item(w, (double)(first + (long long)i * n[1] + j));
    end_statement(w);
    put_surface_knots(w, surface);
    put_words(w, "end\n");
}

static batten_status put_object(writing *w, const batten_object *object)
{
    batten_curve *curve = NULL;
    batten_surface *surface = NULL;
    batten_status status = BATTEN_OK;
    if (object->kind == BATTEN_OBJECT_MESH)
        return put_mesh(w, object);
    if (object->kind == BATTEN_OBJECT_POINTS)
        put_points(w, object);
    else if (object->kind == BATTEN_OBJECT_CURVE) {
        status = bat_prepare_curve(object, &curve);
        if (status == BATTEN_OK)
            put_curve(w, object, curve);
    } else {
        status = bat_prepare_surface(object, w->tolerance, w->notes, &surface);
        if (status == BATTEN_OK)
            put_surface(w, object, surface);
    }
    batten_curve_unref(curve);
    batten_surface_unref(surface);
    return status;
}

batten_status bat_write_obj(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text)
{
    const double unit = batten_model_unit_metres(model);
    writing w = {.notes = notes, .text = text};
    batten_status status = BATTEN_OK;
    w.tolerance = options->tolerance > 0 ? options->tolerance
                                         : BAT_WRITE_TOLERANCE / (unit > 0 ? unit : 1);
    bat_remark_unit(model, "OBJ", notes);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        status = put_object(&w, batten_model_object(model, i));
    return status;
}
