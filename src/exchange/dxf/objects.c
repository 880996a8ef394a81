/* Objects of DXF entities: their looks, curves and points. */
#include "exchange/dxf/blocks.h"
#include "exchange/dxf/colours.h"
#include "exchange/dxf/filling.h"
#include "exchange/dxf/survey.h"
#include <stdio.h>
#include <string.h>

/* ---- entities ---- */

void bat_dxf_colour_of_layer(const bat_dxf_layer_entry *on, double colour[3])
{
    if (on && on->has_colour)
        memcpy(colour, on->colour, sizeof on->colour);
    else
        bat_dxf_colour(BAT_DXF_PLAIN, colour);
}

void bat_dxf_read_look(bat_dxf_filling *f, char layer_name[BAT_DXF_NAME], batten_object *object)
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
        bat_dxf_colour_of_layer(on, object->colour);
        object->has_colour = true;
    } else {
        f->part.source = BAT_DXF_BY_BLOCK;
    }
}

batten_status bat_dxf_add_object(bat_dxf_filling *f, const batten_object *object,
                                 const bat_dxf_part *part)
{
    const batten_status status = batten_model_add(f->model, object);
    return status == BATTEN_OK && f->block ? bat_dxf_add_part(f->r->input, f->block, part)
                                           : status;
}

batten_status bat_dxf_leave_out(bat_dxf_filling *f, const char *kind, int line)
{
    f->r->input->left_out++;
    if (f->block)
        f->block->has_lost = true;
    batten_notes_add(f->r->input->notes, f->r->input->file, line, kind, "%s; left out",
                     batten_message());
    return bat_census_leave(f->r->input, &f->r->census, kind);
}

batten_status bat_dxf_add_curve(bat_dxf_filling *f, const char *kind, batten_curve *curve)
{
    char layer_name[BAT_DXF_NAME], name[64];
    batten_object object = {.kind = BATTEN_OBJECT_CURVE, .curve = curve, .name = name};
    snprintf(name, sizeof name, "%s %d", kind, ++f->r->number);
    bat_dxf_read_look(f, layer_name, &object);
    return bat_dxf_add_object(f, &object, &f->part);
}

batten_status bat_dxf_add_point(bat_dxf_filling *f)
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
    bat_dxf_read_look(f, layer_name, &object);
    return bat_dxf_add_object(f, &object, &f->part);
}
