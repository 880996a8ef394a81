#include "command.h"

#include <string.h>

static const option options[] = {
    {"output", 'o', OPTION_VALUE, "OUT", "the file to write, instead of the second word"},
    {"unit", 0, OPTION_VALUE, "UNIT",
     "the unit of the result: m, mm, in, ft ... (that of the input)"},
    {"from-unit", 0, OPTION_VALUE, "UNIT", "the unit of the input where the file does not say"},
    {"tolerance", 0, OPTION_VALUE, "T",
     "for what the format cannot say exactly, in the result's unit"},
    {"eighths", 0, OPTION_FLAG, NULL, "tables of offsets in feet, inches and eighths"},
    {"json", 0, OPTION_FLAG, NULL, "print the report as JSON"},
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no report, no remarks"},
};

/* A unit given by option, or 0 when none is; false when it is unknown. */
static bool unit_option(const arguments *given, const char *name, double *metres)
{
    const char *text = arguments_get(given, name);
    *metres = text ? batten_unit_metres(text) : 0;
    if (!text || *metres > 0)
        return true;
    complain("batten convert: --%s: '%s' is no unit of length; known are m, mm, cm, km, in, ft "
             "and others",
             name, text);
    return false;
}

/* The same numbers under another unit. */
static batten_status state_unit(double metres, batten_model **model)
{
    batten_model *stated = NULL;
    batten_status status = batten_model_create(metres, &stated);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(*model); i++)
        status = batten_model_add(stated, batten_model_object(*model, i));
    if (status != BATTEN_OK) {
        batten_model_unref(stated);
        return status;
    }
    batten_model_unref(*model);
    *model = stated;
    return BATTEN_OK;
}

static batten_status change_unit(double from, double to, batten_model **model)
{
    batten_status status = BATTEN_OK;
    if (batten_model_unit_metres(*model) == 0 && from == 0)
        from = to > 0 ? to : 1;
    if (from > 0 && batten_model_unit_metres(*model) == 0)
        status = state_unit(from, model);
    if (status == BATTEN_OK && to > 0 && to != batten_model_unit_metres(*model)) {
        batten_model *changed = NULL;
        status = batten_model_to_unit(*model, to, &changed);
        if (status == BATTEN_OK) {
            batten_model_unref(*model);
            *model = changed;
        }
    }
    return status;
}

static int report(const arguments *given, const char *output, const batten_model *model,
                  const batten_notes *notes)
{
    batten_text text = BATTEN_TEXT;
    const char *unit = batten_unit_name(batten_model_unit_metres(model));
    if (!arguments_has(given, "json")) {
        notes_show(notes);
        if (!arguments_has(given, "quiet"))
            batten_text_add(&text, "wrote %s\n", output);
        return output_print(&text);
    }
    batten_text_add(&text, "{\"from\": ");
    batten_text_json(&text, given->files[0]);
    batten_text_add(&text, ", \"to\": ");
    batten_text_json(&text, output);
    batten_text_add(&text, ", \"objects\": %d, \"unit\": \"%s\",\n  \"messages\": ",
                    batten_model_count(model), unit ? unit : "");
    notes_json(&text, notes);
    batten_text_add(&text, "}\n");
    return output_print(&text);
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

static int run(const arguments *given)
{
    double from = 0, to = 0;
    batten_write_options write = batten_write_defaults();
    if (!unit_option(given, "from-unit", &from) || !unit_option(given, "unit", &to) ||
        !arguments_number("convert", given, "tolerance", &write.tolerance))
        return EXIT_USAGE;
    write.eighths = arguments_has(given, "eighths");
    const char *output = output_of(given);
    if (!output)
        return EXIT_USAGE;
    if (batten_format_of_name(output) == BATTEN_FORMAT_AUTO) {
        complain("batten convert: the ending of '%s' names no format that can be written",
                 output);
        return EXIT_USAGE;
    }
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    if (batten_notes_create(1000, &notes) != BATTEN_OK)
        return output_failed("convert", BATTEN_OUT_OF_MEMORY);
    int exit = input_read(given->files[0], notes, &model);
    if (exit != EXIT_FAILED) {
        batten_status status = change_unit(from, to, &model);
        if (status == BATTEN_OK)
            status = batten_write_file(model, output, &write, notes);
        if (status == BATTEN_OK) {
            const int reported = report(given, output, model, notes);
            exit = reported == EXIT_DONE ? exit : reported;
        } else {
            failed_show(notes);
            exit = output_failed("convert", status);
        }
    }
    batten_model_unref(model);
    batten_notes_free(notes);
    return exit;
}

const command command_convert = {
    .name = "convert",
    .usage = "IN OUT [--unit UNIT] or IN -o OUT",
    .summary = "write what is in one file into another format",
    .manual = "OUT ends in .step or .igs; for curves also in .dxf or .svg (true scale) or .nc "
              "(G-code), for points\n"
              "and tables in .csv, .xyz or .dat. What had to be approximated or left out is "
              "reported; "
              "exit status 3\n"
              "when only a part of IN could be read.",
    .least_files = 1,
    .most_files = 2,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .run = run,
};
