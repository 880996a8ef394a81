/* Items of representations that have faces: solids, sheets, shells, faces. */
#include "body/measure/box.h"
#include "exchange/step/read/import.h"
#include "numeric/vector.h"

#include <string.h>

/* The first that argument k refers to, be it a reference or a list of them. */
static const bat_step_instance *first_of(const bat_step_file *file,
                                         const bat_step_record *record, int k)
{
    const bat_step_instance *first = NULL;
    const bat_step_value value = bat_step_value_at(file, bat_step_argument(file, record, k));
    int count = 0;
    size_t at = 0;
    if (value.kind == BAT_STEP_REFERENCE)
        return bat_step_get_reference(file, record, k, &first) == BATTEN_OK ? first : NULL;
    if (value.kind != BAT_STEP_LIST ||
        bat_step_get_list(file, record, k, &count, &at) != BATTEN_OK || count == 0 ||
        bat_step_item_reference(file, record, &at, &first) != BATTEN_OK)
        return NULL;
    return first;
}

/* Of what is hardly larger than the tolerance all vertices may be one: nothing of its shape is
 * left. */
enum { SMALLEST = 10 };

static double size_of(const batten_box *box)
{
    return bat_vec3_norm(bat_vec3_subtract(box->high, box->low));
}

static batten_status check_size(const bat_step_target *target, const bat_step_instance *item,
                                const batten_body *body)
{
    const double tolerance = batten_body_view(body)->tolerance;
    batten_box box = bat_body_edge_box(body);
    if (size_of(&box) > SMALLEST * tolerance)
        return BATTEN_OK;
    const batten_status status = bat_body_find_box(body, &box); /* large faces, small holes */
    const double size = size_of(&box);
    if (status != BATTEN_OK || size > SMALLEST * tolerance)
        return status;
    return bat_step_fail(&target->import->file, item, BATTEN_BAD_FORMAT,
                         "it is %g large, the accuracy is only %g", size, tolerance);
}

/* A body is on one layer: on that of its faces when all have the same. One that only some have
 * is noted. */
static void take_layer(const bat_step_target *target, const bat_step_instance *item,
                       batten_object *object)
{
    const bat_step_file *file = &target->import->file;
    const bat_step_instance *instances = file->instances.items;
    const bat_list *faces = &target->import->topology.faces;
    const char *layer = NULL;
    size_t count = 0;
    char shown[BAT_SHOWN_SIZE];
    for (size_t k = 0; k < faces->count; k++) {
        const char *own = bat_step_layer_of(&target->import->styles,
                                            &instances[((const uint32_t *)faces->items)[k]]);
        if (own && object->layer && strcmp(own, object->layer) == 0)
            continue;
        if (own && !layer)
            layer = own;
        count += own && strcmp(own, layer) == 0;
    }
    if (!object->layer && count == faces->count)
        object->layer = layer;
    else if (layer)
        bat_step_warn(file, item,
                      "%zu of its %zu faces are on the layer '%s'; a body is on one layer, and "
                      "that is left out",
                      count, faces->count, bat_shown(layer, strlen(layer), shown));
}

/* What was read since the body was begun, as an object. A sheet that is one whole B-spline
 * surface is that surface. */
static batten_status finish_body(const bat_step_target *target, const bat_step_instance *item,
                                 const bat_step_instance *shell, bool is_solid)
{
    bat_step_import *import = target->import;
    bat_step_topology *topology = &import->topology;
    const bat_step_record *inner = shell ? bat_step_first(&import->file, shell) : NULL;
    const bat_step_instance *face = inner ? first_of(&import->file, inner, 1) : NULL;
    const bat_step_instance *from[] = {item, shell, NULL};
    batten_object object = {.kind = BATTEN_OBJECT_BODY};
    batten_body *body = NULL;
    char name[BAT_STEP_NAME];
    const bool whole = topology->left_out == 0;
    batten_status status = bat_step_body_end(topology, is_solid && whole, &body);
    if (status == BATTEN_OK && !body)
        status = bat_step_fail(&import->file, item, BATTEN_BAD_FORMAT,
                               "none of its faces can be read");
    else if (status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY)
        status = bat_step_fail(&import->file, item, status, "%.300s", batten_message());
    else if (status == BATTEN_OK)
        status = check_size(target, item, body);
    if (status != BATTEN_OK) {
        batten_body_unref(body);
        return bat_step_leave_item(target, item, status);
    }
    if (is_solid && !whole)
        bat_step_warn(&import->file, item,
                      "%d of its faces are left out; what is left is not a solid",
                      topology->left_out);
    const batten_body_face *patch =
        !is_solid && topology->has_spline ? bat_step_whole_patch(body) : NULL;
    object.body = patch ? NULL : body;
    object.surface = patch ? patch->surface : NULL;
    if (patch) {
        object.kind = BATTEN_OBJECT_SURFACE;
        from[2] = face ? face : item;
    }
    bat_step_dress(target, 3, from, &object, name);
    take_layer(target, item, &object);
    status = bat_step_add_object(target, item, &object);
    batten_body_unref(body);
    return status;
}

/* All shells of a list; one that is bad is left out, the others stay. */
static batten_status read_shells(const bat_step_target *target, const bat_step_record *record,
                                 int k)
{
    bat_step_import *import = target->import;
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_get_list(&import->file, record, k, &count, &at);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const bat_step_instance *shell = NULL;
        status = bat_step_item_reference(&import->file, record, &at, &shell);
        if (status != BATTEN_OK)
            return status;
        status = bat_step_body_shell(&import->topology, shell, false);
        if (status != BATTEN_OK) {
            import->topology.left_out++;
            status = bat_step_leave_item(target, shell, status);
        }
    }
    return status;
}

/* In a complex instance the name stands in another part, so that arguments begin one sooner. */
static int own_argument(const bat_step_instance *item)
{
    return item->record_count > 1 ? 0 : 1;
}

static batten_status read_solid(const bat_step_target *target, const bat_step_instance *item)
{
    bat_step_import *import = target->import;
    const bat_step_file *file = &import->file;
    const bat_step_record *voids = bat_step_as(file, item, "BREP_WITH_VOIDS");
    const bat_step_record *solid = bat_step_as(file, item, "MANIFOLD_SOLID_BREP");
    const bat_step_instance *shell = NULL;
    const int at = own_argument(item);
    if (!solid)
        solid = bat_step_first(file, item);
    bat_step_body_begin(&import->topology, &target->scale);
    batten_status status = bat_step_get_reference(file, solid, at, &shell);
    if (status == BATTEN_OK)
        status = bat_step_body_shell(&import->topology, shell, false);
    if (status == BATTEN_OK && voids)
        status = read_shells(target, voids, item->record_count > 1 ? 0 : 2);
    return status == BATTEN_OK ? finish_body(target, item, shell, true)
                               : bat_step_give_up(target, item, status);
}

static batten_status read_sheet(const bat_step_target *target, const bat_step_instance *item)
{
    bat_step_import *import = target->import;
    const bat_step_record *record = bat_step_first(&import->file, item);
    bat_step_body_begin(&import->topology, &target->scale);
    batten_status status = read_shells(target, record, 1);
    return status == BATTEN_OK
               ? finish_body(target, item, first_of(&import->file, record, 1), false)
               : bat_step_give_up(target, item, status);
}

static batten_status read_bare_shell(const bat_step_target *target,
                                     const bat_step_instance *item)
{
    bat_step_body_begin(&target->import->topology, &target->scale);
    batten_status status = bat_step_body_shell(&target->import->topology, item, false);
    return status == BATTEN_OK ? finish_body(target, item, NULL, false)
                               : bat_step_give_up(target, item, status);
}

static batten_status read_bare_face(const bat_step_target *target,
                                    const bat_step_instance *item)
{
    bat_step_body_begin(&target->import->topology, &target->scale);
    batten_status status = bat_step_body_face(&target->import->topology, item);
    return status == BATTEN_OK ? finish_body(target, item, NULL, false)
                               : bat_step_give_up(target, item, status);
}

static batten_status read_bounded(const bat_step_target *target, const bat_step_instance *item)
{
    bat_step_body_begin(&target->import->topology, &target->scale);
    batten_status status = bat_step_body_bounded(&target->import->topology, item);
    return status == BATTEN_OK ? finish_body(target, item, NULL, false)
                               : bat_step_give_up(target, item, status);
}

/* ---- kinds ---- */

typedef batten_status reader(const bat_step_target *target, const bat_step_instance *item);

static reader *reader_of(const bat_step_file *file, const bat_step_instance *item)
{
    static const struct {
        const char *keyword;
        reader *read;
    } readers[] = {{"MANIFOLD_SOLID_BREP", read_solid},
                   {"BREP_WITH_VOIDS", read_solid},
                   {"FACETED_BREP", read_solid},
                   {"SHELL_BASED_SURFACE_MODEL", read_sheet},
                   {"FACE_BASED_SURFACE_MODEL", read_sheet},
                   {"OPEN_SHELL", read_bare_shell},
                   {"CLOSED_SHELL", read_bare_shell},
                   {"ORIENTED_OPEN_SHELL", read_bare_shell},
                   {"ORIENTED_CLOSED_SHELL", read_bare_shell},
                   {"CONNECTED_FACE_SET", read_bare_shell},
                   {"ADVANCED_FACE", read_bare_face},
                   {"FACE_SURFACE", read_bare_face},
                   {"ORIENTED_FACE", read_bare_face},
                   {"CURVE_BOUNDED_SURFACE", read_bounded}};
    for (size_t k = 0; k < sizeof readers / sizeof readers[0]; k++)
        if (bat_step_as(file, item, readers[k].keyword))
            return readers[k].read;
    return NULL;
}

bool bat_step_is_body(const bat_step_file *file, const bat_step_instance *item)
{
    return reader_of(file, item) != NULL;
}

batten_status bat_step_read_body(const bat_step_target *target, const bat_step_instance *item)
{
    return reader_of(&target->import->file, item)(target, item);
}
