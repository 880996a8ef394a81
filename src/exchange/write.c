/* Writes a model to memory or to a file: chooses the format, prepares the model, calls its
 * writer. */
#include "base/plural.h"
#include "exchange/csv/separated.h"
#include "exchange/formats.h"
#include "exchange/losses.h"
#include "exchange/meshes/kept_mesh.h"
#include "model/as_meshes.h"
#include "model/inherited_colours.h"
#include "model/rebuild.h"

#include <string.h>

batten_write_options batten_write_defaults(void)
{
    return (batten_write_options){.size = sizeof(batten_write_options),
                                  .format = BATTEN_FORMAT_AUTO,
                                  .name = "",
                                  .tolerance = 0,
                                  .date = NULL,
                                  .mesh = NULL};
}

/* "points, curves and surfaces" */
static void name_kinds(unsigned kinds, batten_text *text)
{
    static const char *const names[] = {"points",    "curves", "surfaces", "tables of offsets",
                                        "triangles", "bodies", "meshes",   "instances"};
    bool first = true;
    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (!(kinds & (1u << i)))
            continue;
        const bool last = kinds >> (i + 1) == 0;
        batten_text_add(text, "%s%s", first ? "" : last ? " and " : ", ", names[i]);
        first = false;
    }
}

static bool has_kind(const batten_model *model, batten_object_kind kind)
{
    for (int i = 0; i < batten_model_count(model); i++)
        if (batten_model_object(model, i)->kind == kind)
            return true;
    return false;
}

/* One schema of STEP has meshes; a note says so to whoever did not choose it. */
static const char *mesh_hint(const bat_format_row *row)
{
    return row->format == BATTEN_FORMAT_STEP
               ? "; those of schema ap242 (--schema ap242) hold meshes"
               : "";
}

/* A file would hold nothing of a model that is not empty. */
static batten_status nothing(const bat_format_row *row, const batten_model *model)
{
    const int count = batten_model_count(model);
    const bool held = row->holds & BAT_HOLDS(MESH) || !has_kind(model, BATTEN_OBJECT_MESH);
    batten_text kinds = BATTEN_TEXT;
    name_kinds(row->holds & ~BAT_HOLDS(INSTANCE), &kinds);
    const batten_status status =
        kinds.failed
            ? BATTEN_OUT_OF_MEMORY
            : bat_fail(
                  BATTEN_UNSUPPORTED,
                  "%s files hold %s, and none of the %d object%s ('%.60s' first) is of that "
                  "kind%s",
                  row->title, kinds.bytes, count, bat_plural(count),
                  batten_model_object(model, 0)->name, held ? "" : mesh_hint(row));
    batten_text_free(&kinds);
    return status;
}

typedef struct {
    const bat_format_row *row;
    unsigned holds;
    const char *kinds; /* that it holds, in words */
    batten_notes *notes;
    int hidden; /* objects that were so, and are no more */
} selection;

/* What the instance places, since its place cannot be said. */
static batten_status add_copies(const selection *s, batten_model *held,
                                const batten_object *object)
{
    batten_model *one = NULL, *flat = NULL;
    batten_notes_add(s->notes, "", 0, object->name,
                     "the place scales, shears or mirrors as %s cannot; written as copies, not "
                     "as an instance",
                     s->row->title);
    batten_status status = batten_model_create(batten_model_unit_metres(held), &one);
    if (status == BATTEN_OK)
        status = batten_model_add(one, object);
    if (status == BATTEN_OK)
        status = batten_model_flat(one, &flat);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(flat); i++)
        status = batten_model_add(held, batten_model_object(flat, i));
    batten_model_unref(one);
    batten_model_unref(flat);
    return status;
}

/* Formats without points show a mesh by its triangles alone. */
static bool has_nothing_to_show(const selection *s, const batten_object *object)
{
    return object->mesh && !(s->holds & BAT_HOLDS(POINTS)) &&
           batten_mesh_view(object->mesh)->triangle_count == 0;
}

static void leave_out(const selection *s, const batten_object *object)
{
    batten_notes_add(s->notes, "", 0, object->name, "left out: %s files hold %s, not this %s%s",
                     s->row->title, s->kinds, batten_object_kind_name(object->kind),
                     object->kind == BATTEN_OBJECT_MESH ? mesh_hint(s->row) : "");
}

static batten_status add_mesh(const selection *s, batten_model *held,
                              const batten_object *object)
{
    batten_object shown = *object;
    batten_mesh *mesh = NULL;
    batten_status status = bat_mesh_kept(s->row, object, s->notes, &mesh);
    shown.mesh = mesh;
    if (status == BATTEN_OK)
        status = batten_model_add(held, &shown);
    batten_mesh_unref(mesh);
    return status;
}

/* An instance of what has lost all that it held says nothing either. */
static batten_status add_held(void *context, const batten_model *from, int index,
                              batten_model *held, const batten_object *object)
{
    selection *s = context;
    (void)from;
    (void)index;
    batten_object shown = *object;
    if (!(s->holds & (1u << object->kind))) {
        leave_out(s, object);
        return BATTEN_OK;
    }
    if (has_nothing_to_show(s, object)) {
        batten_notes_add(s->notes, "", 0, object->name, "left out: this mesh has no triangles");
        return BATTEN_OK;
    }
    if (object->definition && batten_model_count(object->definition) == 0) {
        batten_notes_add(s->notes, "", 0, object->name,
                         "left out: this instance places nothing that %s files hold",
                         s->row->title);
        return BATTEN_OK;
    }
    if (object->is_hidden && !(s->row->says & BAT_SAYS_HIDDEN)) {
        shown.is_hidden = false;
        s->hidden++;
    }
    if (object->kind == BATTEN_OBJECT_INSTANCE && s->row->can_place &&
        !s->row->can_place(&object->place))
        return add_copies(s, held, &shown);
    return object->mesh ? add_mesh(s, held, &shown) : batten_model_add(held, &shown);
}

/* The objects of the kinds that the format holds, with a note for each other one; what is
 * placed among them. Nothing is lost where a format cannot hide: it is shown, with a note. */
static batten_status select_held(const bat_format_row *row, const batten_model *model,
                                 batten_notes *notes, batten_model **out)
{
    batten_text kinds = BATTEN_TEXT;
    name_kinds(row->holds & ~BAT_HOLDS(INSTANCE), &kinds);
    selection s = {row, row->holds ? row->holds : ~0u, kinds.bytes ? kinds.bytes : "", notes,
                   0};
    const batten_status status =
        kinds.failed
            ? BATTEN_OUT_OF_MEMORY
            : bat_model_change(model, batten_model_unit_metres(model), 1, add_held, &s, out);
    if (status == BATTEN_OK && s.hidden)
        batten_notes_add(notes, "", 0, "",
                         "hidden objects: %d; %s files cannot hide, they are written like "
                         "the others",
                         s.hidden, row->title);
    batten_text_free(&kinds);
    return status;
}

/* Instances where the format has them, and triangles as patches. A format of rows of numbers
 * chooses for itself what it holds. */
static batten_status prepare(const bat_format_row *row, const batten_model *model,
                             batten_notes *notes, batten_model **out)
{
    batten_model *flat = NULL, *patches = NULL;
    batten_status status = BATTEN_OK;
    if (row->holds & BAT_HOLDS(INSTANCE))
        flat = batten_model_ref(model);
    else
        status = batten_model_flat(model, &flat);
    if (status == BATTEN_OK && (row->holds & BAT_HOLDS(SURFACE)))
        status = batten_model_with_patches(flat, BATTEN_PATCHES_REGULAR, &patches);
    else if (status == BATTEN_OK)
        patches = batten_model_ref(flat);
    if (status == BATTEN_OK)
        status = select_held(row, patches, notes, out);
    batten_model_unref(flat);
    batten_model_unref(patches);
    return status;
}

/* For formats of meshes the shapes that they do not hold become meshes. Bezier triangles become
 * patches where surfaces are held. */
static batten_status mesh_what_is_not_held(const bat_format_row *row, const batten_model *model,
                                           const batten_write_options *options,
                                           batten_notes *notes, batten_model **out)
{
    unsigned kinds = row->holds & BAT_HOLDS(MESH) ? BAT_SHAPES & ~row->holds : 0;
    if (row->holds & BAT_HOLDS(SURFACE))
        kinds &= ~BAT_HOLDS(TRIANGLES);
    if (kinds)
        return bat_model_meshed(model, kinds, options->mesh, NULL, notes, out);
    *out = batten_model_ref(model);
    return BATTEN_OK;
}

/* Where instances have no colour, what they place takes it; before faces become triangles,
 * since some may have colours of their own. */
static batten_status paint(const bat_format_row *row, const batten_model *model,
                           batten_notes *notes, batten_model **out)
{
    if ((row->holds & BAT_HOLDS(INSTANCE)) && !row->paints)
        return bat_model_painted(model, notes, out);
    *out = batten_model_ref(model);
    return BATTEN_OK;
}

static batten_status find_writer(const batten_write_options *options,
                                 const bat_format_row **row)
{
    *row = options ? bat_format_of(options->format) : NULL;
    if (!*row || options->format == BATTEN_FORMAT_AUTO)
        return bat_fail(BATTEN_BAD_ARGUMENT, "no format to write is given");
    if (!(*row)->write)
        return bat_fail(BATTEN_UNSUPPORTED, "%s files cannot be written", (*row)->title);
    return BATTEN_OK;
}

batten_status batten_write_prepare(const batten_model *model,
                                   const batten_write_options *options, batten_notes *notes,
                                   batten_model **out)
{
    batten_write_options chosen = batten_write_defaults();
    batten_mesh_options mesh = batten_mesh_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_write_options, options, &chosen);
    if (status == BATTEN_OK)
        status = BAT_TAKE_OPTIONS(batten_mesh_options, chosen.mesh, &mesh);
    chosen.mesh = &mesh;
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    const bat_format_row *found = NULL;
    batten_model *painted = NULL, *meshed = NULL, *prepared = NULL;
    status = find_writer(options, &found);
    if (status != BATTEN_OK)
        return status;
    bat_format_row row = *found;
    if (row.format == BATTEN_FORMAT_STEP && options->schema != BATTEN_STEP_AP242)
        row.holds &= ~BAT_HOLDS(MESH);
    status = paint(&row, model, notes, &painted);
    if (status == BATTEN_OK)
        status = mesh_what_is_not_held(&row, painted, options, notes, &meshed);
    if (status == BATTEN_OK)
        status = prepare(&row, meshed, notes, &prepared);
    batten_model_unref(painted);
    batten_model_unref(meshed);
    if (status == BATTEN_OK && row.holds && batten_model_count(model) > 0 &&
        batten_model_count(prepared) == 0)
        status = nothing(&row, model);
    if (status == BATTEN_OK)
        *out = prepared;
    else
        batten_model_unref(prepared);
    return status;
}

/* Only the text of STL has names. */
static batten_status note_losses(const bat_format_row *row, const batten_write_options *options,
                                 const batten_model *prepared, batten_notes *notes)
{
    bat_format_row chosen = *row;
    if (row->format == BATTEN_FORMAT_STL && options->as_text)
        chosen.says |= BAT_SAYS_NAMES;
    return bat_note_losses(prepared, &chosen, notes);
}

static batten_status write_as(const batten_model *model, const batten_write_options *options,
                              batten_notes *notes, batten_text *text)
{
    const bat_format_row *row = NULL;
    batten_model *prepared = NULL;
    batten_status status = find_writer(options, &row);
    if (status == BATTEN_OK)
        status = batten_write_prepare(model, options, notes, &prepared);
    if (status == BATTEN_OK && batten_model_count(prepared) == 0)
        status =
            bat_fail(BATTEN_UNSUPPORTED,
                     "the model has no objects; an empty %s file is not written", row->title);
    if (status == BATTEN_OK)
        status = note_losses(row, options, prepared, notes);
    if (status == BATTEN_OK)
        status = row->write(prepared, options, notes, text);
    batten_model_unref(prepared);
    return status;
}

batten_status batten_write_memory(const batten_model *model,
                                  const batten_write_options *options, batten_notes *notes,
                                  char **data, size_t *size)
{
    batten_write_options chosen = batten_write_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_write_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    batten_text text = BATTEN_TEXT;
    if (!chosen.name || !chosen.name[0])
        chosen.name = batten_model_name(model)[0] ? batten_model_name(model) : "batten";
    if (!(chosen.tolerance >= 0 && isfinite(chosen.tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", chosen.tolerance);
    status = write_as(model, &chosen, notes, &text);
    if (status == BATTEN_OK)
        status = batten_text_take(&text, data, size);
    batten_text_free(&text);
    return status;
}

static bool ends(const char *path, const char *ending)
{
    const size_t length = strlen(path), tail = strlen(ending);
    return length >= tail && bat_same_word(path + length - tail, ending);
}

bool batten_write_choose(const char *path, const batten_model *model,
                         batten_write_options *options)
{
    const size_t size = options->size;
    batten_write_options chosen = batten_write_defaults();
    if (BAT_TAKE_OPTIONS(batten_write_options, options, &chosen) != BATTEN_OK)
        return false;
    if (chosen.format == BATTEN_FORMAT_AUTO) {
        chosen.format = batten_format_from_name(path);
        if (chosen.format == BATTEN_FORMAT_OFFSET_TABLE &&
            !has_kind(model, BATTEN_OBJECT_OFFSET_TABLE))
            chosen.format = BATTEN_FORMAT_POINTS;
    }
    chosen.commas |= ends(path, ".csv");
    memcpy(options, &chosen, size);
    options->size = size;
    return chosen.format != BATTEN_FORMAT_AUTO;
}

batten_status batten_write_file(const batten_model *model, const char *path,
                                const batten_write_options *options, batten_notes *notes)
{
    batten_write_options chosen = batten_write_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_write_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    char *data = NULL;
    size_t size = 0;
    if (!batten_write_choose(path, model, &chosen))
        return bat_fail(BATTEN_UNSUPPORTED,
                        "the ending of '%s' names no format that can be written", path);
    status = batten_write_memory(model, &chosen, notes, &data, &size);
    if (status == BATTEN_OK)
        status = batten_save_file(path, data, size);
    batten_release(data);
    return status;
}
