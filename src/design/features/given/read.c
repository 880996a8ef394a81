/* The feature 'read': what is in a file: points, curves, surfaces, bodies, meshes, tables
 * of offsets. */
#include "design/shared/formats.h"
#include "design/text/document.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"read", BATTEN_VALUE_FILE, false, true, NULL, NULL, "the file"},
    {"format", BATTEN_VALUE_WORD, false, false, "auto", BAT_FORMAT_WORDS,
     "what is in it; by its content by default"},
    {"unit", BATTEN_VALUE_TEXT, false, false, NULL, NULL, "the unit of a file that names none"},
    {"scale", BATTEN_VALUE_NUMBER, false, false, "1", NULL,
     "all numbers are multiplied by this"},
    {"upside-down", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "offsets: heights were measured downwards"},
    {"reverse", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "offsets: x was measured the other way"},
    {"x", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "offsets: keep these stations"},
    {"y", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "offsets: keep these half-breadths"},
    {"z", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "offsets: keep these heights"},
    {"trim-centre", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "offsets: of the points on the centre line keep only the highest of each station"},
    {"lines", BATTEN_VALUE_TEXT, true, false, NULL, NULL,
     "offsets: keep the points on these lines"},
};

static void take_range(const bat_run *run, const char *parameter, batten_interval *range)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    if (given->count)
        *range = (batten_interval){given->items[0].number[0], given->items[0].number[1]};
}

/* The names of the lines to keep, to be released; NULL for all. */
static batten_status take_lines(const bat_run *run, const char ***out, int *count)
{
    const bat_argument *given = bat_argument_of(run, "lines");
    const char **names = bat_array((size_t)given->count, sizeof *names);
    if (!names)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < given->count; k++)
        names[k] = given->items[k].text;
    *count = given->count;
    *out = names;
    return BATTEN_OK;
}

static batten_status add_offsets(bat_run *run, const batten_object *object, double factor)
{
    batten_offset_table_selection selection = batten_offset_table_everything();
    batten_object made = *object;
    batten_offset_table *offsets = NULL;
    selection.scale = factor;
    selection.unit_metres = bat_unit_metres(run);
    selection.upside_down = bat_yes(run, "upside-down");
    selection.reverse = bat_yes(run, "reverse");
    selection.trim_centre = bat_yes(run, "trim-centre");
    take_range(run, "x", &selection.x);
    take_range(run, "y", &selection.y);
    take_range(run, "z", &selection.z);
    const char **names = NULL;
    batten_status status = take_lines(run, &names, &selection.line_count);
    selection.lines = names;
    if (status == BATTEN_OK)
        status = batten_offset_table_select(object->offset_table, &selection, &offsets);
    bat_release(names);
    made.offset_table = offsets;
    if (status == BATTEN_OK)
        status = bat_add(run, &made);
    batten_offset_table_unref(offsets);
    return status;
}

/* How many design units one unit of the file is, with the scale. */
static batten_status find_factor(const bat_run *run, const batten_model *model, double *factor)
{
    const char *given = bat_text(run, "unit");
    const double named = given ? batten_unit_metres(given) : 0;
    const double own = batten_model_unit_metres(model);
    if (given && named <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'unit' is '%s', which is not a known unit of length", given);
    if (given && own > 0 && own != named)
        bat_note(run, "the file says that its unit is %g m; 'unit: %s' is used", own, given);
    if (bat_number(run, "scale") <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'scale' must be above 0, not %g",
                        bat_number(run, "scale"));
    const double metres = named > 0 ? named : own > 0 ? own : bat_unit_metres(run);
    *factor = bat_number(run, "scale") * (metres / bat_unit_metres(run));
    return BATTEN_OK;
}

static batten_status add_object(bat_run *run, const batten_object *object, double factor)
{
    const batten_affine map = batten_affine_scaling(factor, factor, factor);
    if (object->kind == BATTEN_OBJECT_OFFSET_TABLE)
        return add_offsets(run, object, factor);
    return factor == 1 ? bat_add(run, object) : bat_transform_object(run, &map, object);
}

static batten_status read_file(bat_run *run, const char *path, batten_model **out)
{
    batten_read_options options = batten_read_defaults();
    options.format = (batten_format)bat_word(run, "format");
    options.limits = &run->document->limits;
    options.file_name = bat_text(run, "read");
    return batten_read_file(path, &options, run->job, run->notes, out);
}

/* The model that was handed over in place of the file, or the file. */
static batten_status take_model(bat_run *run, batten_model **out)
{
    const bat_document *document = run->document;
    if (document->provided && strcmp(document->provided_file, bat_text(run, "read")) == 0) {
        *out = batten_model_ref(document->provided);
        return BATTEN_OK;
    }
    char *path = NULL;
    batten_status status = bat_path_beside(document, bat_text(run, "read"), &path);
    if (status == BATTEN_OK)
        status = read_file(run, path, out);
    bat_release(path);
    return status;
}

/* Features work on shapes where they are: what instances place is put there. */
static batten_status find_model(bat_run *run, bool *partly, batten_model **out)
{
    batten_model *model = NULL;
    batten_status status = take_model(run, &model);
    *partly = status == BATTEN_PARTLY_READ;
    if (status == BATTEN_OK || *partly)
        status = batten_model_flat(model, out);
    batten_model_unref(model);
    return status;
}

static batten_status run_read(bat_run *run)
{
    batten_model *model = NULL;
    double factor = 1;
    bool partly = false;
    batten_status status = find_model(run, &partly, &model);
    if (status == BATTEN_OK)
        status = find_factor(run, model, &factor);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        status = add_object(run, batten_model_object(model, i), factor);
    batten_model_unref(model);
    return status == BATTEN_OK && partly ? BATTEN_PARTLY_READ : status;
}

const bat_feature bat_feature_read = {
    .shown =
        {"read",
         "What is in a file: points, curves, surfaces, bodies, meshes, tables of offsets",
         "The path is relative to the design and stays below its folder. Lengths become those of\n"
         "the design; a file that names no unit is taken to be in that of the design. Objects\n"
         "placed by instances are put where the instance has them, and are named\n"
         "'instance/object'. Tables of offsets can be turned, cut and trimmed. 'batten help\n"
         "formats' lists the formats; those that are only written are refused.",
         "features:\n"
         "  offsets: {read: offsets.csv, z: [0, 2 m], trim-centre: yes}\n",
         "", "batten_read_file", BAT_PARAMETERS(parameters), false,
         .also =
             "import, load, open file, STEP, IGES, DXF, OBJ, STL, PLY, G2, SVG, aerofoil, airfoil, point cloud, table of offsets"},
    .run = run_read};
