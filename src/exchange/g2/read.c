/* Reads a .g2 file: one object after another, each under its header. */
#include "base/plural.h"
#include "exchange/g2/g2.h"

#include <batten/standard.h>
#include <batten/text.h>
#include <stdio.h>
#include <string.h>

/* ---- objects ---- */

typedef struct {
    bat_words words;
    bat_input *input;
    batten_model *model;
    bat_census census;
    batten_object look; /* name and colour of the object at work */
    char name[64];
    bool is_bad; /* it was left out */
} reading;

/* Four whole numbers 0..255 behind the header. */
static batten_status read_colour(reading *r, int count)
{
    int parts[4];
    batten_status status = BATTEN_OK;
    r->look.has_colour = count == 4;
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = bat_words_integer(&r->words, "a part of the colour", 0, 255, &parts[k]);
    for (int k = 0; status == BATTEN_OK && k < 3 && count == 4; k++)
        r->look.colour[k] = parts[k] / 255.0;
    return status;
}

static batten_status add_curve(reading *r, int class)
{
    batten_curve *curve = NULL;
    batten_object object = r->look;
    batten_status status = bat_g2_read_curve(&r->words, class, true, &curve);
    object.kind = BATTEN_OBJECT_CURVE;
    object.curve = curve;
    if (status == BATTEN_OK)
        status = batten_model_add(r->model, &object);
    batten_curve_unref(curve);
    return status;
}

static batten_status add_surface(reading *r, int class)
{
    bat_g2_ground ground;
    batten_object object = r->look;
    batten_status status = bat_g2_read_surface(&r->words, class, true, &ground);
    object.kind = BATTEN_OBJECT_SURFACE;
    object.surface = ground.surface;
    if (status == BATTEN_OK)
        status = batten_model_add(r->model, &object);
    batten_surface_unref(ground.surface);
    return status;
}

static batten_status add_face(reading *r)
{
    batten_body *body = NULL;
    batten_object object = r->look;
    batten_body_face look = {.name = r->look.name, .has_colour = r->look.has_colour};
    memcpy(look.colour, r->look.colour, sizeof look.colour);
    batten_status status = bat_g2_read_face(&r->words, &look, &body);
    object.kind = BATTEN_OBJECT_BODY;
    object.body = body;
    if (status == BATTEN_OK)
        status = batten_model_add(r->model, &object);
    batten_body_unref(body);
    return status;
}

/* How many words stand before the next header. */
static size_t words_left(const reading *r)
{
    bat_words words = r->words;
    size_t count = 0;
    while (bat_words_next(&words) && !bat_g2_is_header(words))
        count++;
    return count;
}

/* Rows of x y z; of t x y z in files for smoothing, where t is the parameter. */
static batten_status take_rows(reading *r, size_t count, size_t width, const double *rows,
                               batten_object *object)
{
    double *points = NULL, *parameters = NULL;
    batten_status status = bat_input_array(r->input, count, 3 * sizeof *points, &points);
    if (status == BATTEN_OK && width == 4)
        status = bat_input_array(r->input, count, sizeof *parameters, &parameters);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++) {
        memcpy(&points[3 * i], &rows[width * i + width - 3], 3 * sizeof *points);
        if (parameters)
            parameters[i] = rows[width * i];
    }
    object->points = points;
    object->parameters = parameters;
    if (status == BATTEN_OK)
        status = batten_model_add(r->model, object);
    bat_release(points);
    bat_release(parameters);
    return status;
}

static batten_status add_points(reading *r)
{
    int count = 0;
    double *rows = NULL;
    batten_object object = r->look;
    batten_status status = bat_words_integer(&r->words, "the number of points", 0,
                                             bat_g2_most_points(r->input), &count);
    const size_t width = status == BATTEN_OK && words_left(r) == 4 * (size_t)count ? 4 : 3;
    if (status == BATTEN_OK)
        status = bat_words_reals(&r->words, "coordinates", width * (size_t)count, &rows);
    object.kind = BATTEN_OBJECT_POINTS;
    object.point_count = count;
    if (status == BATTEN_OK)
        status = take_rows(r, (size_t)count, width, rows, &object);
    bat_release(rows);
    return status;
}

/* Each segment is a curve. */
static batten_status add_segments(reading *r)
{
    int count = 0;
    batten_status status =
        bat_words_integer(&r->words, "the number of segments", 0, 100000000, &count);
    if (status == BATTEN_OK)
        status = bat_words_check(&r->words, "segments", (size_t)count, 6);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        double ends[6];
        batten_curve *line = NULL;
        batten_object object = r->look;
        for (int k = 0; status == BATTEN_OK && k < 6; k++)
            status = bat_words_real(&r->words, "a coordinate", &ends[k]);
        if (status == BATTEN_OK)
            status = batten_curve_line(3, ends, ends + 3, &line);
        object.kind = BATTEN_OBJECT_CURVE;
        object.curve = line;
        if (status == BATTEN_OK)
            status = batten_model_add(r->model, &object);
        batten_curve_unref(line);
    }
    return status;
}

/* Points, then triangles "3 a b c" with indices from 0. */
static batten_status add_mesh(reading *r)
{
    int count[2] = {0, 0}, *corners = NULL, three = 0;
    double *points = NULL;
    batten_mesh *mesh = NULL;
    batten_object object = r->look;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_words_integer(&r->words, "the number of points or triangles", 0, 100000000,
                                   &count[k]);
    if (status == BATTEN_OK)
        status = bat_words_reals(&r->words, "coordinates", 3 * (size_t)count[0], &points);
    if (status == BATTEN_OK)
        status = bat_words_check(&r->words, "triangles", (size_t)count[1], 4);
    if (status == BATTEN_OK)
        status = bat_input_array(r->input, 3 * (size_t)count[1], sizeof *corners, &corners);
    for (int i = 0; status == BATTEN_OK && i < 4 * count[1]; i++)
        status = bat_words_integer(&r->words,
                                   i % 4 ? "a corner" : "the number of corners of a triangle",
                                   i % 4 ? 0 : 3, i % 4 ? count[0] - 1 : 3,
                                   i % 4 ? &corners[3 * (i / 4) + i % 4 - 1] : &three);
    const batten_mesh_parts parts = {.vertex_count = count[0],
                                     .points = points,
                                     .triangle_count = count[1],
                                     .corners = corners};
    if (status == BATTEN_OK)
        status = batten_mesh_create(&parts, &mesh);
    object.kind = BATTEN_OBJECT_MESH;
    object.mesh = mesh;
    if (status == BATTEN_OK)
        status = batten_model_add(r->model, &object);
    batten_mesh_unref(mesh);
    bat_release(points);
    bat_release(corners);
    return status;
}

static batten_status read_body(reading *r, int class)
{
    switch (class) {
    case BAT_G2_CURVE:
    case BAT_G2_LINE:
    case BAT_G2_CIRCLE:
    case BAT_G2_ELLIPSE:
        return add_curve(r, class);
    case BAT_G2_SURFACE:
    case BAT_G2_PLANE:
    case BAT_G2_CYLINDER:
    case BAT_G2_SPHERE:
    case BAT_G2_CONE:
    case BAT_G2_TORUS:
    case BAT_G2_REVOLUTION:
        return add_surface(r, class);
    case BAT_G2_BOUNDED_SURFACE:
        return add_face(r);
    case BAT_G2_MESH:
        return add_mesh(r);
    case BAT_G2_POINTS:
        return add_points(r);
    case BAT_G2_LINES:
        return add_segments(r);
    default:
        return bat_input_fail(r->input, BATTEN_UNSUPPORTED, r->words.line,
                              "objects of this class are not read");
    }
}

/* The object whose header begins with the last word. */
static batten_status read_object(reading *r, int number)
{
    int head[4] = {0, 0, 0, 0};
    const int line = r->words.line;
    double class = 0;
    batten_status status =
        batten_number_read(r->words.word.bytes, r->words.word.length, &class, NULL);
    head[0] = (int)class;
    for (int k = 1; status == BATTEN_OK && k < 4; k++)
        status = bat_words_integer(&r->words, "a number of the header", 0, 1000, &head[k]);
    snprintf(r->name, sizeof r->name, "%s %d", bat_g2_class_name(head[0]), number);
    r->look = (batten_object){.name = r->name};
    r->is_bad = false;
    if (status == BATTEN_OK)
        status = read_colour(r, head[3]);
    if (status == BATTEN_OK)
        status = read_body(r, head[0]);
    if (bat_input_ends(status))
        return status;
    if (status == BATTEN_OK)
        return bat_census_read(r->input, &r->census, bat_g2_class_name(head[0]));
    r->input->left_out++;
    r->is_bad = true;
    int place = 0;
    const char *reason = bat_input_reason(r->input, &place);
    batten_notes_add(r->input->notes, r->input->file, place ? place : line, r->name,
                     "%s; left out", reason);
    return bat_census_leave(r->input, &r->census, bat_g2_class_name(head[0]));
}

/* Go to the next header, past what a bad object leaves over. */
static bool next_header(reading *r)
{
    int skipped = 0, line = 0;
    while (bat_words_next(&r->words)) {
        const bool found = bat_g2_is_header(r->words);
        if (!found && skipped++ == 0)
            line = r->words.line;
        if (found && skipped == 0)
            return true;
        if (found)
            break;
    }
    if (skipped > 0 && !r->is_bad) {
        r->input->left_out++;
        batten_notes_add(r->input->notes, r->input->file, line, r->name,
                         "words after its end that belong to no object: %d; left out", skipped);
    }
    return r->words.word.length > 0;
}

static batten_status read_all(reading *r)
{
    int number = 0, place = 0;
    batten_status status = batten_model_create(0, &r->model);
    bool more = status == BATTEN_OK && bat_words_next(&r->words);
    while (status == BATTEN_OK && more) {
        status = bat_input_step(r->input, (size_t)(r->words.scan.at - r->input->data));
        if (status == BATTEN_OK && bat_g2_is_header(r->words))
            status = bat_input_limit(r->input, r->words.line, (size_t)number + 1,
                                     r->input->limits.entities, "objects");
        else if (status == BATTEN_OK && number == 0)
            status = bat_input_fail(r->input, BATTEN_BAD_FORMAT, r->words.line,
                                    "expected the header of an object here");
        if (status == BATTEN_OK && bat_g2_is_header(r->words))
            status = read_object(r, ++number);
        if (status == BATTEN_OK)
            more = next_header(r);
    }
    if (status == BATTEN_OK && batten_model_count(r->model) == 0 && r->input->left_out > 0) {
        const char *reason = bat_input_reason(r->input, &place);
        return bat_input_fail(r->input, BATTEN_UNSUPPORTED, place,
                              "its %d object%s could not be read: %.300s", number,
                              bat_plural(number), reason);
    }
    return status;
}

batten_status bat_read_g2(bat_input *input, batten_model **out)
{
    reading r = {.input = input};
    bat_words_begin(&r.words, input);
    bat_census_begin(&r.census);
    batten_status status = read_all(&r);
    if (status == BATTEN_OK) {
        bat_census_note(input, &r.census);
        *out = batten_model_ref(r.model);
    }
    batten_model_unref(r.model);
    bat_census_end(&r.census);
    return status;
}
