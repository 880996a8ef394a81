/* `batten convert`: write what is in one file into another format, and count what was lost. */
#include "commands/tally.h"
#include "formats.h"
#include "unit.h"

#include <batten/exchange.h>
#include <batten/text.h>
#include <limits.h>
#include <math.h>
#include <string.h>

static const option options[] = {
    {"output", 'o', OPTION_VALUE, "OUT",
     "the file to write, instead of the second word; - is the standard output"},
    {"unit", 0, OPTION_VALUE, "UNIT",
     "the unit of the result: m, mm, in, ft ... (that of the input)"},
    {"from-unit", 0, OPTION_VALUE, "UNIT", "the unit of the input where the file does not say"},
    {"tolerance", 0, OPTION_VALUE, "T",
     "for what the format cannot say exactly, as 0.1mm; a number alone is in the result's unit"},
    {"title", 0, OPTION_VALUE, "NAME",
     "STEP and IGES: of the product (that of the input, else the name of its file)"},
    FROM_FORMAT_OPTION,
    {"format", 0, OPTION_VALUE, "FORMAT", "what OUT is to be, where its ending does not tell"},
    {"schema", 0, OPTION_VALUE, "NAME", "STEP: ap214, ap203 or ap242 (ap214)"},
    {"no-pcurves", 0, OPTION_FLAG, NULL, "STEP: faces without curves in (u, v)"},
    {"solids", 0, OPTION_FLAG, NULL, "IGES: solids and shells, not faces one by one"},
    {"chord", 0, OPTION_VALUE, "D",
     "where shapes become meshes: how far triangles may be from them, as 0.1mm; a number alone "
     "is in the result's unit (--tolerance, else 1/1000 of their size)"},
    {"angle", 0, OPTION_VALUE, "A",
     "where shapes become meshes: degrees between the normals at the ends of an edge (20)"},
    {"text", 0, OPTION_FLAG, NULL, "STL and PLY: the form that can be read"},
    {"eighths", 0, OPTION_FLAG, NULL,
     "tables of offsets in feet, inches and eighths; plain numbers there are inches"},
    {"json", 0, OPTION_FLAG, NULL, "print the report as JSON"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no report, no remarks"},
};

/* A unit given by option, or 0 when none is; false when it is unknown. */
static bool unit_option(const arguments *given, const char *name, double *metres)
{
    const char *text = arguments_get(given, name);
    *metres = text ? batten_unit_metres(text) : 0;
    if (!text || *metres > 0)
        return true;
    complain(
        "batten convert: --%s: unknown unit of length '%s'; known are m, mm, cm, km, in, ft, "
        "yd and others",
        name, text);
    return false;
}

static batten_status to_unit(double metres, batten_model **model)
{
    batten_model *changed = NULL;
    batten_status status = batten_model_to_unit(*model, metres, &changed);
    if (status == BATTEN_OK) {
        batten_model_unref(*model);
        *model = changed;
    }
    return status;
}

/* Numbers without a unit are in `from`, or else, with a note, in `to` already. */
static batten_status change_unit(double from, double to, batten_notes *notes,
                                 batten_model **model)
{
    batten_status status = BATTEN_OK;
    if (batten_model_unit_metres(*model) == 0 && from > 0)
        status = to_unit(from, model);
    else if (batten_model_unit_metres(*model) == 0 && to > 0)
        batten_notes_add(notes, "", 0, "",
                         "the file gives no unit; its numbers are taken to be in %s "
                         "already (--from-unit says otherwise)",
                         batten_unit_name(to));
    if (status == BATTEN_OK && to > 0 && to != batten_model_unit_metres(*model))
        status = to_unit(to, model);
    return status;
}

/* What became of the objects. */
typedef struct {
    const char *output;
    batten_format format;
    char from_unit[UNIT_SIZE], unit[UNIT_SIZE]; /* "": not stated */
    tally read, written, left_out;              /* left_out: its bodies are not told apart */
    tally read_all, written_all;                /* with what instances place */
    bool is_read_placed, is_written_placed;     /* there are instances, and it is known */
    int approximated, meshed; /* shapes; one may be placed by several instances */
    int faces;                /* left out of meshes */
    bool is_partly;           /* something could not be meshed */
} outcome;

/* "4 instances (in all 18 solids)" */
static void text_tally(batten_text *text, tally t, const tally *placed)
{
    tally_text(text, t);
    if (!placed)
        return;
    batten_text_add(text, " (in all ");
    tally_text(text, *placed);
    batten_text_add(text, ")");
}

static void text_report(batten_text *text, const outcome *o)
{
    batten_text_add(text, "read ");
    text_tally(text, o->read, o->is_read_placed ? &o->read_all : NULL);
    batten_text_add(text,
                    "; unit %s\nwrote %s: ", o->from_unit[0] ? o->from_unit : "not stated",
                    o->output);
    text_tally(text, o->written, o->is_written_placed ? &o->written_all : NULL);
    if (o->unit[0] && strcmp(o->unit, o->from_unit) != 0)
        batten_text_add(text, "; unit %s", o->unit);
    if (o->approximated)
        batten_text_add(text, "; %d shape%s approximated", o->approximated,
                        o->approximated == 1 ? "" : "s");
    if (o->faces)
        batten_text_add(text, "; %d face%s left out", o->faces, o->faces == 1 ? "" : "s");
    if (tally_sum(o->left_out)) {
        batten_text_add(text, "; left out: ");
        tally_text(text, o->left_out);
    }
    batten_text_add(text, "\n");
}

static void json_report(batten_text *text, const outcome *o, const char *input,
                        const batten_notes *notes)
{
    batten_text_add(text, "{\"from\": ");
    batten_text_json(text, input);
    batten_text_add(text, ", \"to\": ");
    batten_text_json(text, o->output);
    batten_text_add(text, ", \"format\": \"%s\", \"objects\": %lld, \"unit\": \"%s\",\n  ",
                    batten_format_name(o->format), tally_sum(o->read), o->unit);
    batten_text_add(text, "\"read\": ");
    tally_json(text, o->read, o->is_read_placed ? &o->read_all : NULL);
    batten_text_add(text, ", \"written\": ");
    tally_json(text, o->written, o->is_written_placed ? &o->written_all : NULL);
    batten_text_add(text, ", \"left_out\": ");
    tally_json(text, o->left_out, NULL);
    batten_text_add(text, ", \"approximated\": %d, \"faces_left_out\": %d,\n  \"messages\": ",
                    o->approximated, o->faces);
    notes_json(text, notes);
    batten_text_add(text, "}\n");
}

static int report(const arguments *given, const outcome *o, const batten_notes *notes)
{
    batten_text text = BATTEN_TEXT;
    if (arguments_has(given, "json"))
        json_report(&text, o, given->files[0], notes);
    else if (!arguments_has(given, "quiet"))
        text_report(&text, o);
    if (!arguments_has(given, "json"))
        notes_show(notes);
    if (strcmp(o->output, "-") != 0)
        return output_print(&text);
    batten_text_free(&text); /* what is written stands alone on the standard output */
    return EXIT_DONE;
}

/* Write into the file, or to the standard output. */
static batten_status put_model(const batten_model *model, const batten_write_options *chosen,
                               batten_notes *said, const char *output)
{
    char *data = NULL;
    size_t size = 0;
    if (strcmp(output, "-") != 0)
        return batten_write_file(model, output, chosen, said);
    batten_status status = batten_write_memory(model, chosen, said, &data, &size);
    if (status == BATTEN_OK) {
        job_end();
        status = output_stream(data, size);
    }
    batten_release(data);
    return status;
}

static void take_changes(tally_changes behind, outcome *o)
{
    o->left_out = behind.left_out;
    o->approximated = behind.approximated;
    o->meshed = behind.meshed;
    o->faces = behind.faces;
    o->is_partly = behind.is_failed || behind.faces > 0;
}

/* What is lost within definitions is lost at every place. */
static batten_status count_written(const batten_model *prepared,
                                   const batten_write_options *chosen, tally lost, outcome *o)
{
    const bool by_faces =
        (o->format == BATTEN_FORMAT_IGES && !chosen->solids) || o->format == BATTEN_FORMAT_G2;
    const tally_bodies bodies = by_faces ? TALLY_FACES : TALLY_BODIES;
    o->written = tally_without(tally_of(prepared, bodies), lost);
    if (tally_sum(lost) != 0)
        return BATTEN_OK;
    o->is_written_placed = o->written.count[BATTEN_OBJECT_INSTANCE] > 0;
    return tally_placed(prepared, bodies, &o->written_all);
}

/* Prepare and write the model; the notes on its objects say what became of them. */
static batten_status write_prepared(const batten_model *model,
                                    const batten_write_options *chosen, batten_notes *said,
                                    outcome *o)
{
    batten_model *prepared = NULL;
    batten_status status = batten_write_prepare(model, chosen, said, &prepared);
    if (status != BATTEN_OK)
        return status;
    const int second = batten_notes_count(said);
    status = put_model(prepared, chosen, said, o->output);
    const tally_changes behind = tally_notes(said, 0);
    take_changes(behind, o);
    const tally lost = tally_notes(said, second).left_out;
    if (status == BATTEN_OK)
        status = count_written(prepared, chosen, lost, o);
    batten_model_unref(prepared);
    return status;
}

static bool has_shapes(const batten_model *model)
{
    const tally all = tally_of(model, TALLY_BODIES);
    return all.count[BATTEN_OBJECT_SURFACE] || all.count[BATTEN_OBJECT_TRIANGLES] ||
           all.count[BATTEN_OBJECT_BODY] || all.count[BATTEN_OBJECT_INSTANCE];
}

/* Options for meshes that nothing became are not passed over in silence. */
static void note_idle_options(const batten_model *model, const arguments *given,
                              const outcome *o, batten_notes *notes)
{
    const bool chord = arguments_has(given, "chord"), angle = arguments_has(given, "angle");
    batten_format_facts facts;
    if (o->meshed > 0 || (!chord && !angle) || !batten_format_about(o->format, &facts))
        return;
    batten_text why = BATTEN_TEXT;
    if (has_shapes(model))
        batten_text_add(&why,
                        "nothing becomes triangles in %s files; .stl, .ply, .glb and .3mf take "
                        "triangles, other formats of meshes those that the feature 'mesh' of a "
                        "design makes",
                        facts.title);
    else
        batten_text_add(&why, "there is no shape in the file to make triangles of");
    batten_notes_add(notes, "", 0, "", "%s no effect: %s",
                     chord && angle ? "--chord and --angle have"
                     : chord        ? "--chord has"
                                    : "--angle has",
                     why.bytes ? why.bytes : "");
    batten_text_free(&why);
}

/* Points do not become curves by themselves where a drawing could hold curves. */
static void note_points(const batten_model *model, const outcome *o, batten_notes *notes)
{
    const tally all = tally_of(model, TALLY_BODIES);
    const bool is_drawing = o->format == BATTEN_FORMAT_DXF || o->format == BATTEN_FORMAT_STEP ||
                            o->format == BATTEN_FORMAT_IGES;
    if (is_drawing && tally_sum(all) > 0 && tally_sum(all) == all.count[BATTEN_OBJECT_POINTS])
        batten_notes_remark(notes, "", 0, "",
                            "points are written as points; 'batten fit' makes curves and "
                            "surfaces of them");
}

static void copy_notes(const batten_notes *from, batten_notes *to)
{
    for (int i = 0; i < batten_notes_count(from); i++) {
        const batten_note *note = batten_notes_at(from, i);
        (note->is_remark ? batten_notes_remark : batten_notes_add)(
            to, note->file, note->line, note->entity, "%s", note->text);
    }
}

/* Tolerance and chord in the unit of the result. What one asks of all shapes holds for meshes
 * too. */
static batten_status set_lengths(const batten_model *model, const arguments *given,
                                 batten_write_options *write, batten_mesh_options *mesh)
{
    const double metres = batten_model_unit_metres(model);
    batten_status status = unit_length_in(given, "tolerance", metres, &write->tolerance);
    if (status == BATTEN_OK)
        status = unit_length_in(given, "chord", metres, &mesh->chord);
    if (status == BATTEN_OK && !arguments_has(given, "chord"))
        mesh->chord = write->tolerance;
    return status;
}

static batten_status write_model(const batten_model *model, const arguments *given,
                                 const batten_write_options *write, batten_notes *notes,
                                 outcome *o)
{
    batten_write_options chosen = *write;
    batten_mesh_options mesh = *write->mesh;
    batten_notes *said = NULL; /* all notes, since they are counted */
    chosen.mesh = &mesh;
    batten_write_choose(o->output, model, &chosen);
    o->format = chosen.format;
    o->read = tally_of(model, TALLY_BODIES);
    o->is_read_placed = o->read.count[BATTEN_OBJECT_INSTANCE] > 0;
    unit_words(batten_model_unit_metres(model), o->unit);
    batten_status status = set_lengths(model, given, &chosen, &mesh);
    if (status == BATTEN_OK)
        status = tally_placed(model, TALLY_BODIES, &o->read_all);
    if (status == BATTEN_OK)
        status = batten_notes_create(INT_MAX, &said);
    if (status != BATTEN_OK)
        return status;
    status = write_prepared(model, &chosen, said, o);
    if (status == BATTEN_OK)
        note_idle_options(model, given, o, said);
    if (status == BATTEN_OK)
        note_points(model, o, said);
    copy_notes(said, notes);
    batten_notes_free(said);
    return status;
}

/* OUT, as second word or by -o; NULL with a complaint when it is given twice or not at all. */
static const char *output_of(const arguments *given)
{
    const char *chosen = arguments_get(given, "output");
    const char *second = given->file_count > 1 ? given->files[1] : NULL;
    if (chosen && second)
        complain("batten convert: both -o %s and '%s' say what to write", chosen, second);
    else if (!chosen && !second)
        complain("batten convert: another file is missing; see 'batten help convert'");
    return chosen && second ? NULL : chosen ? chosen : second;
}

static bool schema_option(const arguments *given, batten_step_schema *schema)
{
    static const char *const names[] = {"ap214", "ap203", "ap242"};
    int index = (int)*schema;
    if (!arguments_word(given, "schema", 3, names, &index)) {
        complain("batten convert: --schema is ap214, ap203 or ap242, not '%s'",
                 arguments_get(given, "schema"));
        return false;
    }
    *schema = (batten_step_schema)index;
    return true;
}

static bool write_options(const arguments *given, batten_write_options *write,
                          batten_mesh_options *mesh)
{
    double degrees = 0;
    if (!unit_length_check("convert", given, "tolerance") ||
        !unit_length_check("convert", given, "chord") ||
        !arguments_number("convert", given, "angle", &degrees) ||
        !schema_option(given, &write->schema) ||
        !formats_option("convert", given, "format", &write->format))
        return false;
    if (arguments_has(given, "angle") && !(degrees > 0 && degrees <= 180)) {
        complain("batten convert: --angle is %g; it must be above 0 and at most 180 degrees",
                 degrees);
        return false;
    }
    if (arguments_has(given, "angle"))
        mesh->angle = degrees * (3.14159265358979323846 / 180);
    write->mesh = mesh;
    write->no_parameter_curves = arguments_has(given, "no-pcurves");
    write->solids = arguments_has(given, "solids");
    write->as_text = arguments_has(given, "text");
    write->eighths = arguments_has(given, "eighths");
    return true;
}

/* How long a name is without its ending and the object in it. */
static size_t stem_length(const char *name)
{
    const char *hash = strchr(name, '#');
    const size_t length = hash ? (size_t)(hash - name) : strlen(name);
    for (size_t i = length; i-- > 1;)
        if (name[i] == '.')
            return i;
    return length;
}

/* The name of a file without its folders, its ending and the object in it. */
static batten_status stem_of(const char *argument, batten_text *name)
{
    const char *slash = strrchr(argument, '/'), *begin = slash ? slash + 1 : argument;
    if (strcmp(argument, "-") != 0)
        batten_text_bytes(name, begin, stem_length(begin));
    return name->failed ? BATTEN_OUT_OF_MEMORY : BATTEN_OK;
}

/* What is asked for, what the model is called, or its file. */
static batten_status give_name(const arguments *given, batten_model *model)
{
    batten_text name = BATTEN_TEXT;
    const char *title = arguments_get(given, "title");
    batten_status status = BATTEN_OK;
    if (!title && !batten_model_name(model)[0])
        status = stem_of(given->files[0], &name);
    if (status == BATTEN_OK && (title || name.length))
        status = batten_model_set_name(model, title ? title : name.bytes);
    batten_text_free(&name);
    return status;
}

/* Feet, inches and eighths are read back in inches: so names made of numbers are in inches too.
 */
static batten_status to_inches(const batten_write_options *write, const outcome *o,
                               batten_model **model)
{
    batten_write_options chosen = *write;
    batten_write_choose(o->output, *model, &chosen);
    const bool is_loft = chosen.eighths && chosen.format == BATTEN_FORMAT_OFFSET_TABLE;
    return is_loft && batten_model_unit_metres(*model) > 0 ? to_unit(0.0254, model) : BATTEN_OK;
}

/* What makes shapes of a table that the format does not hold. */
static void point_to_fit(const batten_model *model, batten_status status)
{
    if (status != BATTEN_OUT_OF_MEMORY &&
        tally_of(model, TALLY_BODIES).count[BATTEN_OBJECT_OFFSET_TABLE])
        complain("'batten fit' and designs ('batten help build') make curves and surfaces of a "
                 "table of offsets; .csv keeps the table, .xyz its points");
}

static int convert(const arguments *given, batten_format format, const double units[2],
                   const batten_write_options *write, outcome *o)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    if (batten_notes_create(1000, &notes) != BATTEN_OK)
        return output_failed("convert", BATTEN_OUT_OF_MEMORY);
    int exit = input_read(given->files[0], format, notes, &model);
    if (exit != EXIT_FAILED) {
        unit_words(batten_model_unit_metres(model), o->from_unit);
        batten_status status = change_unit(units[0], units[1], notes, &model);
        if (status == BATTEN_OK)
            status = give_name(given, model);
        if (status == BATTEN_OK)
            status = to_inches(write, o, &model);
        if (status == BATTEN_OK)
            status = write_model(model, given, write, notes, o);
        if (status == BATTEN_OK) {
            const int reported = report(given, o, notes);
            exit = reported != EXIT_DONE ? reported : o->is_partly ? EXIT_PARTLY : exit;
        } else {
            failed_show(notes);
            exit = output_failed("convert", status);
            point_to_fit(model, status);
        }
    }
    batten_model_unref(model);
    batten_notes_free(notes);
    return exit;
}

static int run_convert(const arguments *given)
{
    double units[2] = {0, 0};
    batten_write_options write = batten_write_defaults();
    batten_mesh_options mesh = batten_mesh_defaults();
    batten_format format = BATTEN_FORMAT_AUTO;
    if (!unit_option(given, "from-unit", &units[0]) || !unit_option(given, "unit", &units[1]) ||
        !formats_option("convert", given, "from-format", &format) ||
        !write_options(given, &write, &mesh))
        return EXIT_USAGE;
    outcome o = {.output = output_of(given)};
    if (!o.output)
        return EXIT_USAGE;
    if (write.format == BATTEN_FORMAT_AUTO &&
        batten_format_from_name(o.output) == BATTEN_FORMAT_AUTO) {
        strcmp(o.output, "-") == 0
            ? complain(
                  "batten convert: '-' is the standard output; --format says what to write there")
            : complain(
                  "batten convert: the ending of '%s' names no format that can be written; "
                  "--format may",
                  o.output);
        return EXIT_USAGE;
    }
    if (strcmp(o.output, "-") == 0 && arguments_has(given, "json")) {
        complain("batten convert: '-' and --json would both write to the standard output");
        return EXIT_USAGE;
    }
    if (output_is_input("convert", given->files[0], o.output))
        return EXIT_USAGE;
    return convert(given, format, units, &write, &o);
}

const command command_convert = {
    .name = "convert",
    .usage = "IN OUT [--unit UNIT] or IN -o OUT",
    .summary = "write what is in one file into another format",
    .manual =
        "IN is STEP, IGES, G2, DXF, SVG, OBJ, STL, PLY, OFF, PCD, a table of offsets, points or\n"
        "an aerofoil, recognised by its content; file#name means one object in it, as named by\n"
        "'batten info'. OUT ends in .step, .igs, .g2; for meshes, which shapes become within\n"
        "--chord and --angle, in .stl, .ply, .glb or .3mf, and for bodies in .obj, which keeps\n"
        "surfaces; for curves also in .dxf or .svg (true scale, as seen along z) or .nc (G-code);\n"
        "for points and tables in .csv or .xyz, for an aerofoil in .dat. Points stay points in\n"
        ".step, .igs and .dxf: 'batten fit' makes curves of them. 'batten help formats' says what\n"
        "each format keeps. What was read and written is counted; what had to be approximated or\n"
        "left out is reported. OUT cannot be IN itself. The exit status is 3 when only a part of\n"
        "IN could be read, or meshed.",
    .least_files = 1,
    .most_files = 2,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .run = run_convert,
};
