#include "exchange/iges/iges.h"
#include "exchange/prepare.h"
#include "exchange/real.h"

#include <batten/units.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The sections as they grow; the directory and the parameters have records of 80 columns. */
typedef struct {
    batten_notes *notes;
    batten_text global, directory, data;
    char line[96]; /* the record of the G or P section that is being filled */
    size_t used;
    int global_count, directory_count, data_count;
    double colours[64][3]; /* those written last, in percent, and the ids of their entities */
    int colour_ids[64];
    int colour_count;
    double largest; /* coordinate written so far */
} writing;

#define GLOBAL_COLUMNS 72
#define DATA_COLUMNS 64

/* ---- records ---- */

/* End the record being filled: for a parameter record `id` is its entity, 0 for a global one.
 */
static void end_record(writing *w, int id)
{
    if (id)
        batten_text_add(&w->data, "%-64.*s%8dP%7d\n", (int)w->used, w->line, id,
                        ++w->data_count);
    else
        batten_text_add(&w->global, "%-72.*sG%7d\n", (int)w->used, w->line, ++w->global_count);
    w->used = 0;
}

static void put_bytes(writing *w, int id, const char *bytes, size_t length)
{
    const size_t columns = id ? DATA_COLUMNS : GLOBAL_COLUMNS;
    for (size_t i = 0; i < length; i++) {
        if (w->used == columns)
            end_record(w, id);
        w->line[w->used++] = bytes[i];
    }
}

/* Put a token that must stand in one record. */
static void put_whole(writing *w, int id, const char *token)
{
    const size_t length = strlen(token), columns = id ? DATA_COLUMNS : GLOBAL_COLUMNS;
    if (w->used + length > columns)
        end_record(w, id);
    put_bytes(w, id, token, length);
}

static void put_integer(writing *w, int id, long value, char after)
{
    char token[32];
    snprintf(token, sizeof token, "%ld%c", value, after);
    put_whole(w, id, token);
}

static void put_real(writing *w, int id, double value, char after)
{
    char token[BAT_REAL_SIZE + 1];
    bat_real_write(value, token);
    const size_t length = strlen(token);
    token[length] = after;
    token[length + 1] = '\0';
    put_whole(w, id, token);
}

/* nH and the characters; line ends, which no record can hold, become blanks. */
static void put_string(writing *w, int id, const char *text, char after)
{
    char head[32];
    const size_t length = strlen(text);
    if (length > 0) {
        snprintf(head, sizeof head, "%zuH", length);
        put_whole(w, id, head);
    }
    for (size_t i = 0; i < length; i++) {
        const char c = text[i] == '\n' || text[i] == '\r' || text[i] == '\t' ? ' ' : text[i];
        put_bytes(w, id, &c, 1);
    }
    put_bytes(w, id, &after, 1);
}

/* ---- the directory ---- */

typedef struct {
    int type, form, level, colour;
    const char *status; /* 8 digits */
} entry;

static int next_id(const writing *w)
{
    return w->directory_count + 1;
}

/* Write the entry whose parameters begin at record `first` of the P section and end now. */
static void put_entry(writing *w, const entry *e, int first)
{
    const int id = next_id(w);
    if (w->used)
        end_record(w, id);
    batten_text_add(&w->directory, "%8d%8d%8d%8d%8d%8d%8d%8d%sD%7d\n", e->type, first, 0, 0,
                    e->level, 0, 0, 0, e->status, id);
    batten_text_add(&w->directory, "%8d%8d%8d%8d%8d%8s%8s%8s%8dD%7d\n", e->type, 0, e->colour,
                    w->data_count - first + 1, e->form, "", "", "", 0, id + 1);
    w->directory_count += 2;
}

/* A colour in percent with 6 decimals, so that reading and writing again gives the same text.
 */
static double percent(double part)
{
    return nearbyint(part * 1e8) / 1e6;
}

/* The colour field: minus the id of an entity 314, which is written unless it just was. */
static int put_colour(writing *w, const batten_object *object)
{
    if (!object->has_colour)
        return 0;
    const double rgb[3] = {percent(object->colour[0]), percent(object->colour[1]),
                           percent(object->colour[2])};
    for (int k = 0; k < w->colour_count && k < 64; k++)
        if (memcmp(w->colours[k], rgb, sizeof rgb) == 0)
            return -w->colour_ids[k];
    const int id = next_id(w), first = w->data_count + 1;
    put_integer(w, id, 314, ',');
    for (int k = 0; k < 3; k++)
        put_real(w, id, rgb[k], k < 2 ? ',' : ';');
    put_entry(w, &(entry){.type = 314, .status = "00000200"}, first);
    memcpy(w->colours[w->colour_count % 64], rgb, sizeof rgb);
    w->colour_ids[w->colour_count % 64] = id;
    w->colour_count++;
    return -id;
}

/* The id of a property with the name; 0 for an empty one. */
static int put_name(writing *w, const char *name)
{
    if (!name[0])
        return 0;
    const int id = next_id(w), first = w->data_count + 1;
    put_integer(w, id, 406, ',');
    put_integer(w, id, 1, ',');
    put_string(w, id, name, ';');
    put_entry(w, &(entry){.type = 406, .form = 15, .status = "00010300"}, first);
    return id;
}

/* The end of an entity's parameters: no associativity, and its name. */
static void put_properties(writing *w, int id, int name)
{
    put_integer(w, id, 0, ',');
    put_integer(w, id, name ? 1 : 0, name ? ',' : ';');
    if (name)
        put_integer(w, id, name, ';');
}

/* A layer is a level when it is a number, as IGES knows no other. */
static int level_of(writing *w, const batten_object *object)
{
    char *end = NULL;
    const char *layer = object->layer;
    if (!layer[0])
        return 0;
    const bool number = strspn(layer, "0123456789") == strlen(layer) && strlen(layer) <= 7;
    const long level = number ? strtol(layer, &end, 10) : 0;
    if (level <= 0)
        batten_notes_add(w->notes, "", 0, object->name,
                         "layer '%.60s' is no level from 1 to 9999999; left out", layer);
    return (int)level;
}

/* ---- shapes ---- */

/* Do all points [count][3] have the same z? */
static bool is_level(const double *points, size_t count)
{
    for (size_t i = 1; i < count; i++)
        if (points[3 * i + 2] != points[2])
            return false;
    return true;
}

static void put_coordinate(writing *w, int id, double value)
{
    w->largest = bat_max(w->largest, fabs(value));
    put_real(w, id, value, ',');
}

/* Missing weights are written as ones, and the entity calls itself polynomial. */
static void put_weights(writing *w, int id, const double *weights, size_t i)
{
    put_real(w, id, weights ? weights[i] : 1, ',');
}

static bool is_segment(const batten_curve *curve)
{
    const double *knots = batten_curve_knots(curve);
    return batten_curve_degree(curve) == 1 && batten_curve_point_count(curve) == 2 &&
           !batten_curve_is_rational(curve) && knots[0] == 0 && knots[1] == 0 &&
           knots[2] == 1 && knots[3] == 1;
}

static void put_segment(writing *w, int id, const batten_curve *curve)
{
    const double *points = batten_curve_points(curve);
    put_integer(w, id, 110, ',');
    for (int k = 0; k < 6; k++)
        put_coordinate(w, id, points[k]);
}

static void put_spline(writing *w, int id, const batten_curve *curve)
{
    const double *points = batten_curve_points(curve), *weights = batten_curve_weights(curve);
    const double *knots = batten_curve_knots(curve);
    const int n = batten_curve_point_count(curve), p = batten_curve_degree(curve);
    const batten_interval domain = batten_curve_domain(curve);
    const bool level = is_level(points, (size_t)n);
    put_integer(w, id, 126, ',');
    put_integer(w, id, n - 1, ',');
    put_integer(w, id, p, ',');
    put_integer(w, id, level, ',');
    put_integer(w, id, memcmp(points, &points[3 * ((size_t)n - 1)], 3 * sizeof *points) == 0,
                ',');
    put_integer(w, id, weights == NULL, ',');
    put_integer(w, id, 0, ',');
    for (int i = 0; i < n + p + 1; i++)
        put_real(w, id, knots[i], ',');
    for (int i = 0; i < n; i++)
        put_weights(w, id, weights, (size_t)i);
    for (int i = 0; i < 3 * n; i++)
        put_coordinate(w, id, points[i]);
    put_real(w, id, domain.a, ',');
    put_real(w, id, domain.b, ',');
    put_real(w, id, 0, ',');
    put_real(w, id, 0, ',');
    put_real(w, id, level, ',');
}

static void put_knots(writing *w, int id, const batten_surface *surface,
                      batten_direction direction)
{
    const double *knots = batten_surface_knots(surface, direction);
    for (int i = 0; i < batten_surface_knot_count(surface, direction); i++)
        put_real(w, id, knots[i], ',');
}

static void put_domain(writing *w, int id, const batten_surface *surface,
                       batten_direction direction)
{
    const batten_interval domain = batten_surface_domain(surface, direction);
    put_real(w, id, domain.a, ',');
    put_real(w, id, domain.b, ',');
}

static void put_surface(writing *w, int id, const batten_surface *surface)
{
    const double *points = batten_surface_points(surface);
    const double *weights = batten_surface_weights(surface);
    const int count_u = batten_surface_point_count(surface, BATTEN_U);
    const int count_v = batten_surface_point_count(surface, BATTEN_V);
    const int head[] = {128,
                        count_u - 1,
                        count_v - 1,
                        batten_surface_degree(surface, BATTEN_U),
                        batten_surface_degree(surface, BATTEN_V),
                        batten_surface_is_closed(surface, BATTEN_U, 0),
                        batten_surface_is_closed(surface, BATTEN_V, 0),
                        weights == NULL,
                        0,
                        0};
    for (size_t k = 0; k < sizeof head / sizeof head[0]; k++)
        put_integer(w, id, head[k], ',');
    put_knots(w, id, surface, BATTEN_U);
    put_knots(w, id, surface, BATTEN_V);
    for (int j = 0; j < count_v; j++)
        for (int i = 0; i < count_u; i++)
            put_weights(w, id, weights, (size_t)i * (size_t)count_v + (size_t)j);
    for (int j = 0; j < count_v; j++)
        for (int i = 0; i < count_u; i++)
            for (int k = 0; k < 3; k++)
                put_coordinate(
                    w, id, points[3 * ((size_t)i * (size_t)count_v + (size_t)j) + (size_t)k]);
    put_domain(w, id, surface, BATTEN_U);
    put_domain(w, id, surface, BATTEN_V);
}

/* ---- objects ---- */

/* Sequence numbers have 7 columns; this keeps every record below them. */
static batten_status check_room(const writing *w)
{
    if (w->data_count <= 9000000 && w->directory_count <= 9000000)
        return BATTEN_OK;
    return bat_fail(BATTEN_TOO_LARGE, "IGES has room for 9999999 records in a section");
}

static batten_status write_curve(writing *w, const batten_object *object)
{
    batten_curve *curve = NULL;
    batten_status status = bat_prepare_curve(object, &curve);
    if (status != BATTEN_OK)
        return status;
    const bool segment = is_segment(curve);
    const int colour = put_colour(w, object), name = put_name(w, object->name);
    const int id = next_id(w), first = w->data_count + 1;
    if (segment)
        put_segment(w, id, curve);
    else
        put_spline(w, id, curve);
    put_properties(w, id, name);
    put_entry(w,
              &(entry){.type = segment ? 110 : 126,
                       .level = level_of(w, object),
                       .colour = colour,
                       .status = "00000000"},
              first);
    batten_curve_unref(curve);
    return BATTEN_OK;
}

static batten_status write_surface(writing *w, const batten_object *object, double tolerance)
{
    batten_surface *surface = NULL;
    batten_status status = bat_prepare_surface(object, tolerance, w->notes, &surface);
    if (status != BATTEN_OK)
        return status;
    const int colour = put_colour(w, object), name = put_name(w, object->name);
    const int id = next_id(w), first = w->data_count + 1;
    put_surface(w, id, surface);
    put_properties(w, id, name);
    put_entry(
        w,
        &(entry){
            .type = 128, .level = level_of(w, object), .colour = colour, .status = "00000000"},
        first);
    batten_surface_unref(surface);
    return BATTEN_OK;
}

static batten_status write_object(writing *w, const batten_object *object, double tolerance)
{
    batten_status status = check_room(w);
    if (status != BATTEN_OK)
        return status;
    if (object->kind == BATTEN_OBJECT_CURVE)
        return write_curve(w, object);
    return write_surface(w, object, tolerance);
}

/* ---- the global section ---- */

/* "2026-11-21T10:25:00" as "20261121.102500"; another form gives the neutral date. */
static void write_date(const char *date, char out[16])
{
    static const char shape[] = "dddd-dd-ddTdd:dd:dd";
    memcpy(out, "20000101.000000", 16);
    for (size_t i = 0; date && shape[i]; i++)
        if (shape[i] == 'd' ? date[i] < '0' || date[i] > '9' : date[i] != shape[i])
            return;
    if (!date || date[sizeof shape - 1])
        return;
    size_t k = 0;
    for (size_t i = 0; shape[i]; i++) {
        if (shape[i] == 'd')
            out[k++] = date[i];
        if (shape[i] == 'T')
            out[k++] = '.';
    }
}

static void put_unit(writing *w, double metres)
{
    static const char *const names[] = {"IN", "MM",  "",   "FT", "MI", "M",
                                        "KM", "MIL", "UM", "CM", "UIN"};
    const int flag = bat_iges_flag_of_unit(metres);
    put_integer(w, 0, flag, ',');
    put_string(w, 0, names[flag - 1], ',');
}

static void write_global(writing *w, const batten_write_options *options, double unit,
                         double tolerance)
{
    char date[16];
    write_date(options->date, date);
    put_string(w, 0, ",", ',');
    put_string(w, 0, ";", ',');
    put_string(w, 0, options->name, ',');
    put_string(w, 0, options->name, ',');
    put_string(w, 0, "Batten", ',');
    put_string(w, 0, batten_version(), ',');
    static const int sizes[] = {32, 38, 6, 308, 17};
    for (int k = 0; k < 5; k++)
        put_integer(w, 0, sizes[k], ',');
    put_string(w, 0, options->name, ',');
    put_real(w, 0, 1, ',');
    put_unit(w, unit);
    put_integer(w, 0, 1, ',');
    put_real(w, 0, 0, ',');
    put_string(w, 0, date, ',');
    put_real(w, 0, tolerance, ',');
    put_real(w, 0, w->largest, ',');
    put_string(w, 0, "", ',');
    put_string(w, 0, "", ',');
    put_integer(w, 0, 11, ',');
    put_integer(w, 0, 0, ',');
    put_string(w, 0, date, ';');
    end_record(w, 0);
}

static void join(const writing *w, batten_text *text)
{
    batten_text_add(text, "%-72sS%7d\n", "Written by Batten", 1);
    batten_text_bytes(text, w->global.bytes, w->global.length);
    batten_text_bytes(text, w->directory.bytes, w->directory.length);
    batten_text_bytes(text, w->data.bytes, w->data.length);
    batten_text_add(text, "S%7dG%7dD%7dP%7d%40sT%7d\n", 1, w->global_count, w->directory_count,
                    w->data_count, "", 1);
}

/* A unit that IGES can say, into which the model is brought. */
static batten_status choose_unit(const batten_model *model, batten_notes *notes,
                                 batten_model **out)
{
    const double unit = batten_model_unit_metres(model);
    if (unit > 0 && bat_iges_flag_of_unit(unit) != 3) {
        *out = batten_model_ref(model);
        return BATTEN_OK;
    }
    batten_notes_add(notes, "", 0, "",
                     unit > 0 ? "IGES has no name for the unit; written in mm"
                              : "the model has no unit; written as mm");
    return batten_model_to_unit(model, 0.001, out);
}

batten_status bat_write_iges(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text)
{
    batten_model *scaled = NULL;
    batten_status status = choose_unit(model, notes, &scaled);
    if (status != BATTEN_OK)
        return status;
    writing w = {.notes = notes, .global = BATTEN_TEXT, .data = BATTEN_TEXT};
    const double unit = batten_model_unit_metres(scaled);
    const double tolerance = options->tolerance > 0 ? options->tolerance : 1e-6 / unit;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(scaled); i++)
        status = write_object(&w, batten_model_object(scaled, i), tolerance);
    if (status == BATTEN_OK) {
        write_global(&w, options, unit, tolerance);
        join(&w, text);
        text->failed |= w.global.failed || w.directory.failed || w.data.failed;
    }
    batten_text_free(&w.global);
    batten_text_free(&w.directory);
    batten_text_free(&w.data);
    batten_model_unref(scaled);
    return status;
}
