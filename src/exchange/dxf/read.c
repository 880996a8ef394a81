/* A DXF file: one entity after another, and blocks as definitions with their instances. */
#include "base/plural.h"
#include "exchange/dxf/blocks.h"
#include "exchange/dxf/colours.h"
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/filling.h"
#include "exchange/dxf/insert.h"
#include "exchange/dxf/survey.h"
#include "exchange/reading/scan.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

enum { DEEPEST = 32, MOST_INSTANCES = 1000000, MOST_IN_ARRAYS = 100000 };

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

/* ---- blocks ---- */

static batten_status fill(bat_dxf_filling *f, const char *end);

/* The model of a block, made the first time it is asked for. Blocks within blocks are followed
 * DEEPEST deep and no further. */
static batten_status build_block(bat_dxf_reading *r, bat_dxf_block *b, int depth)
{
    bat_dxf_filling f = {
        .r = r, .depth = depth, .block = b, .faces = {.size = 9 * sizeof(double)}};
    if (b->model)
        return BATTEN_OK;
    if (b->is_at_work)
        return bat_fail(BATTEN_BAD_FORMAT, "block '%.60s' contains itself", b->is.name);
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
                        "it is an array of %d x %d, and arrays may have at most %d places in "
                        "all",
                        places->columns, places->rows, MOST_IN_ARRAYS);
    r->in_arrays += count > 1 ? (int)count : 0;
    if (count == 1 && ++r->instances > MOST_INSTANCES)
        return bat_fail(BATTEN_TOO_LARGE, "more than %d instances", MOST_INSTANCES);
    return BATTEN_OK;
}

static batten_status add_instances(bat_dxf_filling *f, const bat_dxf_places *places,
                                   batten_object *object)
{
    batten_status status = BATTEN_OK;
    for (int row = 0; status == BATTEN_OK && row < places->rows; row++)
        for (int column = 0; status == BATTEN_OK && column < places->columns; column++) {
            object->place = bat_dxf_place_at(places, column, row);
            status = bat_dxf_add_object(f, object, &f->part);
        }
    return status;
}

/* On layer 0 of a block it is not known yet what the layer will be. */
static batten_status place_block(bat_dxf_filling *f, bat_dxf_block *b, const char *layer_name,
                                 const bat_dxf_places *places, batten_object *object)
{
    const bat_dxf_layer_entry *on = bat_dxf_find_layer(f->r, layer_name);
    const double *own = object->has_colour ? object->colour : NULL;
    const bool is_plain = !own && !(on && on->has_colour) && !f->block && !b->is_bound;
    batten_model *model = NULL;
    batten_status status = BATTEN_OK;
    double colour[3];
    bat_dxf_colour_of_layer(on, colour);
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

static batten_status add_insert(bat_dxf_filling *f)
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
                          "block '%.60s' is empty: its contents are left out", b->is.name);
    if (status != BATTEN_OK)
        return status;
    bat_dxf_read_look(f, layer_name, &object);
    f->part.block = b;
    return place_block(f, b, layer_name, &places, &object);
}

/* ---- one entity after another ---- */

static batten_status end_polyline(bat_dxf_filling *f)
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
        status = bat_dxf_add_object(f, &object, &f->polyline_part);
    }
    batten_curve_unref(curve);
    batten_mesh_unref(mesh);
    if (status == BATTEN_OK)
        return bat_census_read(f->r->input, &f->r->census, "POLYLINE");
    return bat_input_ends(status) ? status : bat_dxf_leave_out(f, "POLYLINE", f->polyline.line);
}

static batten_status begin_polyline(bat_dxf_filling *f)
{
    const batten_status status = bat_dxf_polyline_begin(&f->pairs, &f->polyline);
    f->polyline_look = (batten_object){0};
    bat_dxf_read_look(f, f->polyline_layer, &f->polyline_look);
    f->polyline_part = f->part;
    return status;
}

/* An entity that is no part of a polyline. */
static batten_status add_single(bat_dxf_filling *f, bool *is_known)
{
    bool is_curve = false;
    int paper = 0;
    char kind[32];
    batten_curve *curve = NULL;
    *is_known = true;
    if (bat_dxf_get_integer(&f->pairs, 67, 0, &paper) == BATTEN_OK && paper == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "it is on paper, not in the model");
    if (bat_dxf_is(&f->pairs, "POINT"))
        return bat_dxf_add_point(f);
    if (bat_dxf_is(&f->pairs, "3DFACE"))
        return bat_dxf_add_face(f);
    if (bat_dxf_is(&f->pairs, "INSERT"))
        return add_insert(f);
    batten_status status = bat_dxf_read_curve(&f->pairs, &is_curve, &curve);
    *is_known = is_curve;
    if (status == BATTEN_OK && is_curve)
        status = bat_dxf_add_curve(f, bat_dxf_kind(&f->pairs, kind), curve);
    batten_curve_unref(curve);
    return status;
}

static batten_status add_entity(bat_dxf_filling *f)
{
    char kind[32];
    bool is_known = true;
    double thickness = 0;
    bat_input *input = f->r->input;
    if (f->polyline.is_open && bat_dxf_is(&f->pairs, "VERTEX")) {
        batten_status status = bat_dxf_polyline_vertex(&f->pairs, &f->polyline);
        if (status == BATTEN_BAD_FORMAT) {
            f->polyline.is_open = false;
            return bat_dxf_leave_out(f, "POLYLINE", f->polyline.line);
        }
        return status;
    }
    batten_status status = f->polyline.is_open ? end_polyline(f) : BATTEN_OK;
    if (status != BATTEN_OK || bat_dxf_is(&f->pairs, "SEQEND") ||
        bat_dxf_is(&f->pairs, "VERTEX"))
        return status;
    const int line = bat_dxf_find(&f->pairs, 0)->line;
    if (!bat_dxf_is(&f->pairs, "3DFACE"))
        status = bat_dxf_flush_faces(f);
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
        return bat_dxf_leave_out(f, kind, line);
    if (!is_known) {
        input->left_out++;
        return bat_census_leave(input, &f->r->census, kind);
    }
    if (bat_dxf_get_real(&f->pairs, 39, 0, &thickness) == BATTEN_OK && thickness != 0)
        f->r->thick++;
    return f->polyline.is_open ? BATTEN_OK : bat_census_read(input, &f->r->census, kind);
}

/* All entities up to one of the kind `end`. */
static batten_status fill(bat_dxf_filling *f, const char *end)
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
    return status == BATTEN_OK ? bat_dxf_flush_faces(f) : status;
}

static batten_status read_entities(bat_dxf_reading *r, batten_model **out)
{
    bat_dxf_filling f = {.r = r, .faces = {.size = 9 * sizeof(double)}};
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
        status =
            bat_input_fail(input, BATTEN_UNSUPPORTED, 0, "its %d entit%s could not be read",
                           input->left_out, bat_one_or_many(input->left_out, "y", "ies"));
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
