#include "exchange/dxf/blocks.h"
#include "exchange/dxf/colours.h"
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/entities.h"
#include "exchange/dxf/insert.h"
#include "exchange/dxf/survey.h"
#include "exchange/reading/scan.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

enum { DEEPEST = 32, MOST_INSTANCES = 1000000, MOST_IN_ARRAYS = 100000 };

/* What a model that is being filled needs: the model of the file, or that of a block. */
typedef struct {
    bat_dxf_reading *r;
    bat_dxf_pairs pairs;
    batten_model *model;
    bat_dxf_polyline polyline;
    batten_object polyline_look; /* as its first entity says: those of its parts may be bare */
    bat_dxf_part polyline_part;
    char polyline_layer[BAT_DXF_NAME];
    bat_list faces; /* of double[9]: triangles of 3DFACEs that follow one another */
    batten_object face_look;
    bat_dxf_block *block;         /* that is being built, or NULL */
    bat_dxf_part part, face_part; /* what read_look found; of the face_look */
    char face_layer[BAT_DXF_NAME], face_name[64];
    int depth;
} filling;

batten_status bat_dxf_recognise(const bat_input *input, bool *is_dxf)
{
    size_t at = bat_begins(input, 0, "\xef\xbb\xbf") ? 3 : 0;
    bat_span line;
    int code = 1;
    *is_dxf = false;
    /* Comments, code 999, may stand first; then "0", "SECTION". */
    for (int i = 0; i < 1000 && bat_next_line(input, &at, &line); i++) {
        while (line.length > 0 && bat_is_blank(line.bytes[0])) {
            line.bytes++;
            line.length--;
        }
        if (i % 2 == 0) {
            if (!(line.length == 1 && line.bytes[0] == '0') &&
                !(line.length == 3 && memcmp(line.bytes, "999", 3) == 0))
                return BATTEN_OK;
            code = line.length == 1 ? 0 : 999;
        } else if (code == 0) {
            *is_dxf = line.length >= 7 && memcmp(line.bytes, "SECTION", 7) == 0;
            return BATTEN_OK;
        }
    }
    return BATTEN_OK;
}

/* ---- entities ---- */

/* A layer that the file does not describe, or that is plain. */
static void colour_of_layer(const bat_dxf_layer_entry *on, double colour[3])
{
    if (on && on->has_colour)
        memcpy(colour, on->colour, sizeof on->colour);
    else
        bat_dxf_colour(BAT_DXF_PLAIN, colour);
}

/* Layer, colour, and whether it is shown; bad numbers are as if they were not there. What lies
 * on layer 0 of a block has the layer of the INSERT. The plain colour is none, but in blocks,
 * where an object without one takes that of the INSERT, it is black. */
static void read_look(filling *f, char layer_name[BAT_DXF_NAME], batten_object *object)
{
    int colour = 256, full = -1, hidden = 0;
    bat_dxf_get_text(&f->pairs, 8, BAT_DXF_NAME, layer_name);
    f->part = (bat_dxf_part){.source = BAT_DXF_OWN};
    f->part.is_on_zero = f->block && strcmp(layer_name, "0") == 0;
    const bat_dxf_layer_entry *on =
        f->part.is_on_zero ? NULL : bat_dxf_find_layer(f->r, layer_name);
    if (on) /* which may be written with other capitals */
        memcpy(layer_name, on->is.name, sizeof on->is.name);
    (void)bat_dxf_get_integer(&f->pairs, 62, 256, &colour);
    (void)bat_dxf_get_integer(&f->pairs, 420, -1, &full);
    (void)bat_dxf_get_integer(&f->pairs, 60, 0, &hidden);
    object->layer = f->part.is_on_zero ? "" : layer_name;
    object->is_hidden = hidden == 1 || (on && on->is_hidden);
    object->has_colour = bat_dxf_colour(colour, object->colour);
    if (full >= 0) {
        bat_dxf_true_colour(full, object->colour);
        object->has_colour = true;
    } else if (colour == BAT_DXF_PLAIN && !f->block) {
        object->has_colour = false;
        return;
    }
    if (object->has_colour)
        return;
    if (colour == 256 && f->part.is_on_zero) {
        f->part.source = BAT_DXF_BY_ZERO;
    } else if (colour == 256 && (f->block || (on && on->has_colour))) {
        colour_of_layer(on, object->colour);
        object->has_colour = true;
    } else {
        f->part.source = BAT_DXF_BY_BLOCK;
    }
}

static batten_status add_object(filling *f, const batten_object *object,
                                const bat_dxf_part *part)
{
    const batten_status status = batten_model_add(f->model, object);
    return status == BATTEN_OK && f->block ? bat_dxf_add_part(f->r->input, f->block, part)
                                           : status;
}

static batten_status leave_out(filling *f, const char *kind, int line)
{
    f->r->input->left_out++;
    if (f->block)
        f->block->has_lost = true;
    batten_notes_add(f->r->input->notes, f->r->input->file, line, kind, "%s; left out",
                     batten_message());
    return bat_census_leave(f->r->input, &f->r->census, kind);
}

static batten_status add_curve(filling *f, const char *kind, batten_curve *curve)
{
    char layer_name[BAT_DXF_NAME], name[64];
    batten_object object = {.kind = BATTEN_OBJECT_CURVE, .curve = curve, .name = name};
    snprintf(name, sizeof name, "%s %d", kind, ++f->r->number);
    read_look(f, layer_name, &object);
    return add_object(f, &object, &f->part);
}

static batten_status add_point(filling *f)
{
    char layer_name[BAT_DXF_NAME], name[64];
    batten_vec3 p;
    batten_status status = bat_dxf_get_point(&f->pairs, 10, (batten_vec3){0, 0, 0}, &p);
    const double point[3] = {p.x, p.y, p.z};
    batten_object object = {
        .kind = BATTEN_OBJECT_POINTS, .name = name, .point_count = 1, .points = point};
    snprintf(name, sizeof name, "POINT %d", f->r->number + 1);
    if (status != BATTEN_OK)
        return status;
    f->r->number++;
    read_look(f, layer_name, &object);
    return add_object(f, &object, &f->part);
}

/* ---- faces ---- */

/* The triangles so far as one mesh; corners at the same point are one vertex. */
static batten_status flush_faces(filling *f)
{
    const size_t corners = f->faces.count * 3;
    batten_mesh *loose = NULL, *mesh = NULL;
    if (corners == 0)
        return BATTEN_OK;
    int *order = bat_array(corners, sizeof *order);
    if (!order)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < corners; i++)
        order[i] = (int)i;
    const batten_mesh_parts parts = {.vertex_count = (int)corners,
                                     .points = f->faces.items,
                                     .triangle_count = (int)f->faces.count,
                                     .corners = order};
    batten_status status = batten_mesh_create(&parts, &loose);
    if (status == BATTEN_OK)
        status = batten_mesh_weld(loose, &mesh);
    f->face_look.mesh = mesh;
    if (status == BATTEN_OK)
        status = add_object(f, &f->face_look, &f->face_part);
    batten_mesh_unref(loose);
    batten_mesh_unref(mesh);
    bat_release(order);
    f->faces.count = 0;
    return status;
}

static bool looks_same(const batten_object *a, const batten_object *b)
{
    return strcmp(a->layer, b->layer) == 0 && a->is_hidden == b->is_hidden &&
           a->has_colour == b->has_colour &&
           memcmp(a->colour, b->colour, sizeof a->colour) == 0;
}

/* Faces that follow one another on one layer, in one colour, are one mesh. */
static batten_status add_face(filling *f)
{
    char layer_name[BAT_DXF_NAME];
    double corners[4][3];
    int count = 0;
    batten_object look = {.kind = BATTEN_OBJECT_MESH};
    batten_status status = bat_dxf_read_face(&f->pairs, corners, &count);
    if (status != BATTEN_OK)
        return status;
    read_look(f, layer_name, &look);
    if (f->faces.count > 0 &&
        (!looks_same(&f->face_look, &look) || f->face_part.source != f->part.source))
        status = flush_faces(f);
    if (status == BATTEN_OK && f->faces.count == 0) {
        snprintf(f->face_name, sizeof f->face_name, "3DFACE %d", ++f->r->number);
        memcpy(f->face_layer, layer_name, sizeof layer_name);
        f->face_look = look;
        f->face_look.name = f->face_name;
        f->face_look.layer = f->part.is_on_zero ? "" : f->face_layer;
        f->face_part = f->part;
    }
    for (int i = 1; status == BATTEN_OK && i + 1 < count; i++) {
        double triangle[9];
        memcpy(triangle, corners[0], sizeof corners[0]);
        memcpy(triangle + 3, corners[i], sizeof corners[0]);
        memcpy(triangle + 6, corners[i + 1], sizeof corners[0]);
        status = bat_list_add(f->r->input, &f->faces, triangle);
    }
    if (status == BATTEN_OK && f->faces.count > INT_MAX / 4)
        status = bat_fail(BATTEN_TOO_LARGE, "more than %d faces", INT_MAX / 4);
    return status;
}

/* ---- blocks ---- */

static batten_status fill(filling *f, const char *end);

/* The model of a block, made the first time it is asked for. Blocks within blocks are followed
 * DEEPEST deep and no further. */
static batten_status build_block(bat_dxf_reading *r, bat_dxf_block *b, int depth)
{
    filling f = {.r = r, .depth = depth, .block = b, .faces = {.size = 9 * sizeof(double)}};
    if (b->model)
        return BATTEN_OK;
    if (b->is_at_work)
        return bat_fail(BATTEN_BAD_FORMAT, "block '%.60s' holds itself", b->is.name);
    if (depth > DEEPEST)
        return bat_fail(BATTEN_UNSUPPORTED, "block '%.60s' lies more than %d deep", b->is.name,
                        DEEPEST);
    b->is_at_work = true;
    f.polyline.vertices.size = 4 * sizeof(double);
    bat_dxf_pairs_begin(&f.pairs, r->input, b->is.at, b->line);
    batten_status status = batten_model_create(r->unit_metres, &f.model);
    if (status == BATTEN_OK)
        status = batten_model_set_name(f.model, b->is.name);
    if (status == BATTEN_OK)
        status = fill(&f, "ENDBLK");
    if (status == BATTEN_OK)
        b->model = batten_model_ref(f.model);
    b->is_at_work = false;
    batten_model_unref(f.model);
    bat_release(f.polyline.vertices.items);
    bat_release(f.polyline.faces.items);
    bat_release(f.faces.items);
    bat_dxf_pairs_end(&f.pairs);
    return status;
}

/* What an array adds is bounded on its own: few bytes of the file say much. */
static batten_status count_places(bat_dxf_reading *r, const bat_dxf_places *places)
{
    const int64_t count = (int64_t)places->columns * places->rows;
    if (count > 1 && count > MOST_IN_ARRAYS - r->in_arrays)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "it is an array of %d x %d, and all arrays may have %d places",
                        places->columns, places->rows, MOST_IN_ARRAYS);
    r->in_arrays += count > 1 ? (int)count : 0;
    if (count == 1 && ++r->instances > MOST_INSTANCES)
        return bat_fail(BATTEN_TOO_LARGE, "more than %d instances", MOST_INSTANCES);
    return BATTEN_OK;
}

static batten_status add_instances(filling *f, const bat_dxf_places *places,
                                   batten_object *object)
{
    batten_status status = BATTEN_OK;
    for (int row = 0; status == BATTEN_OK && row < places->rows; row++)
        for (int column = 0; status == BATTEN_OK && column < places->columns; column++) {
            object->place = bat_dxf_place_at(places, column, row);
            status = add_object(f, object, &f->part);
        }
    return status;
}

/* On layer 0 of a block it is not known yet what the layer will be. */
static batten_status place(filling *f, bat_dxf_block *b, const char *layer_name,
                           const bat_dxf_places *places, batten_object *object)
{
    const bat_dxf_layer_entry *on = bat_dxf_find_layer(f->r, layer_name);
    const double *own = object->has_colour ? object->colour : NULL;
    const bool is_plain = !own && !(on && on->has_colour) && !f->block && !b->is_bound;
    batten_model *model = NULL;
    batten_status status = BATTEN_OK;
    double colour[3];
    colour_of_layer(on, colour);
    if (f->part.is_on_zero || is_plain)
        model = batten_model_ref(b->model);
    else
        status = bat_dxf_place_block(f->r, b, colour, own, &model);
    object->definition = model;
    if (status == BATTEN_OK)
        status = add_instances(f, places, object);
    batten_model_unref(model);
    return status;
}

static batten_status add_insert(filling *f)
{
    char layer_name[BAT_DXF_NAME], name[BAT_DXF_NAME];
    bat_dxf_places places;
    bat_dxf_get_text(&f->pairs, 2, sizeof name, name);
    bat_dxf_block *b = bat_dxf_find_block(f->r, name);
    if (!b)
        return bat_fail(BATTEN_NOT_FOUND, "there is no block '%.60s'", name);
    batten_object object = {.kind = BATTEN_OBJECT_INSTANCE, .name = b->is.name};
    batten_status status = bat_dxf_read_places(&f->pairs, b, &places);
    if (status == BATTEN_OK)
        status = count_places(f->r, &places);
    if (status == BATTEN_OK)
        status = build_block(f->r, b, f->depth + 1);
    if (status == BATTEN_OK && b->has_lost && batten_model_count(b->model) == 0)
        status = bat_fail(BATTEN_BAD_FORMAT,
                          "block '%.60s' is empty, for what it holds is left out", b->is.name);
    if (status != BATTEN_OK)
        return status;
    read_look(f, layer_name, &object);
    f->part.block = b;
    return place(f, b, layer_name, &places, &object);
}

/* ---- one entity after another ---- */

static batten_status end_polyline(filling *f)
{
    batten_curve *curve = NULL;
    batten_mesh *mesh = NULL;
    batten_object object = f->polyline_look;
    char name[64];
    snprintf(name, sizeof name, "POLYLINE %d", f->r->number + 1);
    f->polyline.is_open = false;
    batten_status status = f->polyline.is_mesh
                               ? bat_dxf_polymesh(f->r->input, &f->polyline, name, &mesh)
                               : bat_dxf_polyline_curve(&f->pairs, &f->polyline, &curve);
    if (status == BATTEN_OK) {
        f->r->number++;
        object.kind = mesh ? BATTEN_OBJECT_MESH : BATTEN_OBJECT_CURVE;
        object.curve = curve;
        object.mesh = mesh;
        object.name = name;
        status = add_object(f, &object, &f->polyline_part);
    }
    batten_curve_unref(curve);
    batten_mesh_unref(mesh);
    if (status == BATTEN_OK)
        return bat_census_read(f->r->input, &f->r->census, "POLYLINE");
    return bat_input_ends(status) ? status : leave_out(f, "POLYLINE", f->polyline.line);
}

static batten_status begin_polyline(filling *f)
{
    const batten_status status = bat_dxf_polyline_begin(&f->pairs, &f->polyline);
    f->polyline_look = (batten_object){0};
    read_look(f, f->polyline_layer, &f->polyline_look);
    f->polyline_part = f->part;
    return status;
}

/* An entity that is no part of a polyline. */
static batten_status add_single(filling *f, bool *is_known)
{
    bool is_curve = false;
    int paper = 0;
    char kind[32];
    batten_curve *curve = NULL;
    *is_known = true;
    if (bat_dxf_get_integer(&f->pairs, 67, 0, &paper) == BATTEN_OK && paper == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "it is on paper, not in the model");
    if (bat_dxf_is(&f->pairs, "POINT"))
        return add_point(f);
    if (bat_dxf_is(&f->pairs, "3DFACE"))
        return add_face(f);
    if (bat_dxf_is(&f->pairs, "INSERT"))
        return add_insert(f);
    batten_status status = bat_dxf_read_curve(&f->pairs, &is_curve, &curve);
    *is_known = is_curve;
    if (status == BATTEN_OK && is_curve)
        status = add_curve(f, bat_dxf_kind(&f->pairs, kind), curve);
    batten_curve_unref(curve);
    return status;
}

static batten_status add_entity(filling *f)
{
    char kind[32];
    bool is_known = true;
    double thickness = 0;
    bat_input *input = f->r->input;
    if (f->polyline.is_open && bat_dxf_is(&f->pairs, "VERTEX")) {
        batten_status status = bat_dxf_polyline_vertex(&f->pairs, &f->polyline);
        if (status == BATTEN_BAD_FORMAT) {
            f->polyline.is_open = false;
            return leave_out(f, "POLYLINE", f->polyline.line);
        }
        return status;
    }
    batten_status status = f->polyline.is_open ? end_polyline(f) : BATTEN_OK;
    if (status != BATTEN_OK || bat_dxf_is(&f->pairs, "SEQEND") ||
        bat_dxf_is(&f->pairs, "VERTEX"))
        return status;
    const int line = bat_dxf_find(&f->pairs, 0)->line;
    if (!bat_dxf_is(&f->pairs, "3DFACE"))
        status = flush_faces(f);
    if (status != BATTEN_OK)
        return status;
    bat_dxf_kind(&f->pairs, kind);
    if (bat_dxf_is(&f->pairs, "POLYLINE"))
        status = begin_polyline(f);
    else
        status = add_single(f, &is_known);
    if (bat_input_ends(status))
        return status;
    if (status != BATTEN_OK)
        return leave_out(f, kind, line);
    if (!is_known) {
        input->left_out++;
        return bat_census_leave(input, &f->r->census, kind);
    }
    if (bat_dxf_get_real(&f->pairs, 39, 0, &thickness) == BATTEN_OK && thickness != 0)
        f->r->thick++;
    return f->polyline.is_open ? BATTEN_OK : bat_census_read(input, &f->r->census, kind);
}

/* All entities up to one of the kind `end`. */
static batten_status fill(filling *f, const char *end)
{
    bool more = true;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK) {
        status = bat_dxf_next(&f->pairs, &more);
        if (status != BATTEN_OK || !more || bat_dxf_is(&f->pairs, end) ||
            bat_dxf_is(&f->pairs, "ENDSEC") || bat_dxf_is(&f->pairs, "EOF"))
            break;
        status = bat_input_step(f->r->input, f->r->input->size / 2 + f->pairs.at / 2);
        if (status == BATTEN_OK)
            status = add_entity(f);
    }
    if (status == BATTEN_OK && f->polyline.is_open)
        status = end_polyline(f);
    return status == BATTEN_OK ? flush_faces(f) : status;
}

static batten_status read_entities(bat_dxf_reading *r, batten_model **out)
{
    filling f = {.r = r, .faces = {.size = 9 * sizeof(double)}};
    f.polyline.vertices.size = 4 * sizeof(double);
    bat_dxf_pairs_begin(&f.pairs, r->input, r->entities_at, r->entities_line);
    batten_status status = batten_model_create(r->unit_metres, &f.model);
    if (status == BATTEN_OK && r->entities_at > 0)
        status = fill(&f, "ENDSEC");
    if (status == BATTEN_OK)
        *out = batten_model_ref(f.model);
    batten_model_unref(f.model);
    bat_release(f.polyline.vertices.items);
    bat_release(f.polyline.faces.items);
    bat_release(f.faces.items);
    bat_dxf_pairs_end(&f.pairs);
    return status;
}

batten_status bat_read_dxf(bat_input *input, batten_model **out)
{
    bat_dxf_reading r = {.input = input,
                         .layers = {.size = sizeof(bat_dxf_layer_entry)},
                         .blocks = {.size = sizeof(bat_dxf_block)}};
    batten_model *model = NULL;
    bat_census_begin(&r.census);
    batten_status status = bat_dxf_survey(&r);
    if (status == BATTEN_OK)
        status = read_entities(&r, &model);
    if (status == BATTEN_OK && batten_model_count(model) == 0 && input->left_out > 0)
        status = bat_input_fail(input, BATTEN_UNSUPPORTED, 0,
                                "none of its %d entities could be read", input->left_out);
    if (status == BATTEN_OK) {
        bat_census_note(input, &r.census);
        if (r.thick)
            batten_notes_add(input->notes, input->file, 0, "",
                             "entities with a thickness: %d; they are read without it",
                             r.thick);
        *out = batten_model_ref(model);
    }
    batten_model_unref(model);
    bat_dxf_block *blocks = r.blocks.items;
    for (size_t i = 0; i < r.blocks.count; i++)
        bat_dxf_block_end(&blocks[i]);
    bat_release(r.layers.items);
    bat_release(r.blocks.items);
    bat_census_end(&r.census);
    return status;
}
