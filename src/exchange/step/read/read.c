/* Reading STEP: the whole of it. */
#include "base/plural.h"
#include "exchange/step/read/import.h"
#include "exchange/step/step.h"

#include <string.h>

/* ---- what the instances are for ---- */

typedef enum {
    NONE,
    STYLE,
    LAYER,
    HIDDEN,
    GROUP,
    GROUPING,
    ASSIGNMENT,
    DEFINITION,
    MAP,
    REPRESENTATION,
    RELATION,
    PLACED,
    OCCURRENCE,
    ROOT
} purpose;

static purpose purpose_of(const bat_step_record *record)
{
    static const struct {
        const char *word;
        purpose purpose;
    } words[] = {{"STYLED_ITEM", STYLE},
                 {"OVER_RIDING_STYLED_ITEM", STYLE},
                 {"PRESENTATION_LAYER_ASSIGNMENT", LAYER},
                 {"INVISIBILITY", HIDDEN},
                 {"GROUP_RELATIONSHIP", GROUPING},
                 {"APPLIED_GROUP_ASSIGNMENT", ASSIGNMENT},
                 {"SHAPE_DEFINITION_REPRESENTATION", DEFINITION},
                 {"REPRESENTATION_MAP", MAP},
                 {"SHAPE_REPRESENTATION_RELATIONSHIP", RELATION},
                 {"REPRESENTATION_RELATIONSHIP", RELATION},
                 {"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION", PLACED},
                 {"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", OCCURRENCE}};
    /* Items that are whole shapes; shells, faces and curves are mostly parts of them. */
    static const char *const roots[] = {
        "_BREP",           "BREP_WITH_VOIDS", "_SOLID",
        "SOLID_REPLICA",   "BOOLEAN_RESULT",  "SURFACE_MODEL",
        "WIREFRAME_MODEL", "GEOMETRIC_SET",   "GEOMETRIC_CURVE_SET"};
    if (bat_step_is_keyword(record, "GROUP"))
        return GROUP;
    /* Most of a file are points and such. */
    if (record->keyword_length < 11 || bat_step_is_keyword(record, "CARTESIAN_POINT"))
        return NONE;
    for (size_t k = 0; k < sizeof words / sizeof words[0]; k++)
        if (bat_step_is_keyword(record, words[k].word))
            return words[k].purpose;
    for (size_t k = 0; k < sizeof roots / sizeof roots[0]; k++)
        if (bat_step_keyword_ends(record, roots[k]))
            return ROOT;
    return bat_step_keyword_ends(record, "SHAPE_REPRESENTATION") ||
                   bat_step_keyword_ends(record, "WIREFRAME_REPRESENTATION") ||
                   bat_step_keyword_ends(record, "SHAPE_REPRESENTATION_WITH_PARAMETERS") ||
                   bat_step_is_keyword(
                       record, "TESSELLATED_SHAPE_REPRESENTATION_WITH_ACCURACY_PARAMETERS")
               ? REPRESENTATION
               : NONE;
}

static batten_status take_note(bat_step_import *import, const bat_step_instance *instance,
                               purpose of)
{
    bat_step_outline *outline = &import->outline;
    const uint32_t index = bat_step_index(&import->file, instance);
    switch (of) {
    case NONE:
        return BATTEN_OK;
    case STYLE:
        return bat_step_styles_add(&import->styles, instance);
    case LAYER:
        return bat_step_styles_add_layer(&import->styles, instance);
    case HIDDEN:
        return bat_step_styles_add_hidden(&import->styles, instance);
    case GROUP:
        return bat_step_groups_add(&import->groups, instance);
    case GROUPING:
        return bat_list_add(import->input, &import->groups.relations, &index);
    case ASSIGNMENT:
        return bat_list_add(import->input, &import->groups.assignments, &index);
    case DEFINITION:
        return bat_list_add(import->input, &outline->definitions, &index);
    case MAP:
        return bat_list_add(import->input, &outline->maps, &index);
    case REPRESENTATION:
        return bat_list_add(import->input, &outline->representations, &index);
    case RELATION:
        return bat_list_add(import->input, &outline->relations, &index);
    case PLACED:
        return bat_list_add(import->input, &outline->placed, &index);
    case OCCURRENCE:
        return bat_list_add(import->input, &outline->occurrences, &index);
    case ROOT:
        return bat_list_add(import->input, &outline->roots, &index);
    }
    return BATTEN_OK;
}

/* Go through all instances; of a complex one the part counts that says most. */
static batten_status sort_out(bat_step_import *import)
{
    const bat_step_instance *instances = import->file.instances.items;
    const bat_step_record *records = import->file.records.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < import->file.instances.count; k++) {
        purpose most = NONE;
        for (uint32_t i = 0; i < instances[k].record_count; i++) {
            const purpose of = purpose_of(&records[instances[k].first_record + i]);
            most = of > most ? of : most;
        }
        status = take_note(import, &instances[k], most);
    }
    bat_step_styles_sort(&import->styles);
    return status == BATTEN_OK ? bat_step_groups_resolve(&import->groups) : status;
}

/* ---- the header ---- */

static void note_schema(const bat_step_import *import)
{
    static const char *const known[] = {"CONFIG_CONTROL_DESIGN",
                                        "CONFIGURATION_CONTROL_3D_DESIGN",
                                        "AUTOMOTIVE_DESIGN",
                                        "AP203",
                                        "AP214",
                                        "AP242",
                                        "AP209",
                                        "AP238",
                                        "INTEGRATED_CNC_SCHEMA"};
    const char *schema = import->file.schema;
    const size_t length = strlen(schema);
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++)
        if (length >= strlen(known[k]) &&
            bat_step_same_word(schema, known[k], strlen(known[k])))
            return;
    batten_notes_add(import->input->notes, import->input->file, 0, "",
                     "unknown schema '%.100s'; the entities that are known are read", schema);
}

/* ---- the whole ---- */

static void give_colour(const void *context, const bat_step_instance *item,
                        batten_body_face *face)
{
    const bat_step_colours *look = bat_step_colours_of(context, item);
    if (!look || !look->has_fill)
        return;
    face->has_colour = true;
    memcpy(face->colour, look->fill, sizeof face->colour);
}

static batten_status read_all(bat_step_import *import, batten_model **out)
{
    bat_input *input = import->input;
    batten_model *model = NULL;
    note_schema(import);
    batten_status status = bat_input_array(input, import->file.instances.count + 1,
                                           sizeof *import->taken, &import->taken);
    if (status == BATTEN_OK)
        status = bat_step_topology_open(&import->file, &import->census, give_colour,
                                        &import->styles, &import->topology);
    if (status == BATTEN_OK)
        status = sort_out(import);
    if (status == BATTEN_OK)
        status = bat_step_read_products(import, &model);
    if (status != BATTEN_OK)
        return status;
    bat_census_note(input, &import->census);
    if (import->annotations)
        batten_notes_add(input->notes, input->file, 0, "",
                         "annotations of a drawing are not shapes and are not read: %d",
                         import->annotations);
    if (batten_model_count(model) == 0 && input->left_out > 0) {
        batten_model_unref(model);
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 0, "its %d entit%s could not be read",
                              input->left_out, bat_one_or_many(input->left_out, "y", "ies"));
    }
    *out = model;
    return BATTEN_OK;
}

batten_status bat_read_step(bat_input *input, batten_model **out)
{
    const bat_list indices = {.size = sizeof(uint32_t)};
    bat_step_import import = {
        .input = input,
        .outline = {indices, indices, indices, indices, indices, indices, indices}};
    batten_status status = bat_step_begin(input, &import.file);
    if (status != BATTEN_OK)
        return status;
    bat_census_begin(&import.census);
    bat_step_units_begin(&import.units);
    bat_step_styles_begin(&import.file, &import.styles);
    bat_step_groups_begin(&import.file, &import.groups);
    status = read_all(&import, out);
    bat_list *lists[] = {&import.outline.representations,
                         &import.outline.maps,
                         &import.outline.relations,
                         &import.outline.placed,
                         &import.outline.occurrences,
                         &import.outline.definitions,
                         &import.outline.roots,
                         &import.representations,
                         &import.placings};
    for (size_t k = 0; k < sizeof lists / sizeof lists[0]; k++)
        bat_release(lists[k]->items);
    bat_step_topology_close(&import.topology);
    bat_step_styles_end(&import.styles);
    bat_step_groups_end(&import.groups);
    bat_census_end(&import.census);
    bat_release(import.taken);
    bat_release(import.homes);
    bat_step_end(&import.file);
    return status;
}
