/* A design of one feature and one output, made from a command line and evaluated. */
#include "commands/single.h"
#include "formats.h"
#include "unit.h"
#include "values.h"

#include <batten/design.h>
#include <batten/text.h>
#include <string.h>

/* The given options that are parameters of the operation. */
static void add_parameters(batten_text *text, const single *s, const char *operation,
                           const arguments *given)
{
    const batten_feature *feature = batten_feature_find(operation);
    for (int k = 1; feature && k < feature->parameter_count; k++)
        if ((!s->choice || strcmp(s->choice, feature->parameters[k].name) != 0) &&
            (!s->is_plain || feature->parameters[k].required))
            values_add(text, given, &feature->parameters[k]);
}

static const char *output_name(const single *s)
{
    return strcmp(s->output, "-") == 0 ? s->output_ending : s->output;
}

/* The name of what is written. */
static void add_result(batten_text *text, const single *s, const arguments *given)
{
    if (s->operation)
        batten_text_add(text, "result");
    else
        input_name_add(text, given->files[0]);
}

static void add_operation(const single *s, const arguments *given, batten_text *text)
{
    batten_text_add(text, "  result: {%s: ", s->operation);
    input_name_add(text, given->files[0]);
    batten_text_add(text, "%s", s->settings ? s->settings : "");
    add_parameters(text, s, s->operation, given);
    batten_text_add(text, "}\n");
}

/* `unit`: NULL when neither the file nor the user states one. */
static batten_status compose(const single *s, const arguments *given, const char *unit,
                             batten_text *text)
{
    batten_text_add(text, "batten: 1\n");
    if (unit)
        batten_text_add(text, "units: %s\n", unit);
    batten_text_add(text, "features:\n");
    input_add(text, given->files[0]);
    if (s->operation)
        add_operation(s, given, text);
    batten_text_add(text, "outputs:\n  ");
    batten_text_json(text, output_name(s));
    if (s->output_operation) {
        batten_text_add(text, ": {%s: ", s->output_operation);
        add_result(text, s, given);
        add_parameters(text, s, s->output_operation, given);
        batten_text_add(text, "}\n");
    } else {
        batten_text_add(text, ": ");
        add_result(text, s, given);
        batten_text_add(text, "\n");
    }
    return text->failed ? batten_fail(BATTEN_OUT_OF_MEMORY, "no memory for the design")
                        : BATTEN_OK;
}

/* In the unit that is asked for, or in that of the model. */
static batten_status compose_for(const single *s, const arguments *given,
                                 const batten_model *model, batten_text *text)
{
    const char *unit = arguments_get(given, "unit");
    const double metres = batten_model_unit_metres(model);
    if (!unit && metres > 0) {
        unit = batten_unit_name(metres);
        unit = unit ? unit : "m";
    }
    return compose(s, given, unit, text);
}

static batten_status open_design(const single *s, const arguments *given,
                                 const batten_model *model, batten_notes *notes,
                                 batten_design **design)
{
    batten_text text = BATTEN_TEXT;
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    options.provided_file = given->files[0];
    options.provided = model;
    batten_status status = compose_for(s, given, model, &text);
    if (status == BATTEN_OK)
        status = batten_design_parse(text.bytes, text.length, &options, notes, design);
    batten_text_free(&text);
    return status;
}

static bool is_same_design(const single *one, const single *other, const arguments *given,
                           const batten_model *model)
{
    batten_text texts[2] = {BATTEN_TEXT, BATTEN_TEXT};
    const bool same = compose_for(one, given, model, &texts[0]) == BATTEN_OK &&
                      compose_for(other, given, model, &texts[1]) == BATTEN_OK &&
                      strcmp(texts[0].bytes, texts[1].bytes) == 0;
    batten_text_free(&texts[0]);
    batten_text_free(&texts[1]);
    return same;
}

static int report(const single *s, const arguments *given, const batten_design *design,
                  const batten_notes *notes)
{
    batten_text text = BATTEN_TEXT;
    const bool to_file = strcmp(s->output, "-") != 0;
    if (!to_file)
        return EXIT_DONE;
    if (arguments_has(given, "json"))
        results_json(&text, design, 1, &s->output, notes);
    else if (!arguments_has(given, "quiet"))
        results_text(&text, design, 1, &s->output);
    return output_print(&text);
}

/* The message of a failure, without "measure.txt (measure): ", when that is the name which was
 * made up for what is printed. */
static int failed(const single *s, batten_status status)
{
    const char *message = message_shown(), *name = s->output_ending;
    const size_t length = strlen(name);
    if (status != BATTEN_CANCELLED && strcmp(s->output, "-") == 0 &&
        strncmp(message, name, length) == 0 && strncmp(message + length, " (", 2) == 0) {
        const char *behind = strstr(message, "): ");
        job_end();
        complain("batten %s: %s", s->command, behind ? behind + 3 : message);
        return EXIT_FAILED;
    }
    return output_failed(s->command, status);
}

/* Does the same fail in the same way without the values that need not be given? Then the input is at fault, as far as can be told.
 * The message stays as it is. */
static bool fails_plain(const single *s, const arguments *given, const batten_model *model,
                        batten_status status)
{
    single plain = *s;
    batten_design *design = NULL;
    batten_text kept = BATTEN_TEXT;
    char *data = NULL;
    size_t size = 0;
    plain.is_plain = true;
    plain.settings = NULL;
    if (is_same_design(s, &plain, given, model))
        return true; /* nothing was given that might be at fault */
    batten_text_add(&kept, "%s", batten_message());
    batten_status again = open_design(&plain, given, model, NULL, &design);
    if (again == BATTEN_OK)
        again = batten_design_output(design, 0, job_get(), NULL, &data, &size);
    const bool same = !design || (again == status && !kept.failed &&
                                  strcmp(kept.bytes, batten_message()) == 0);
    if (!kept.failed)
        batten_fail(status, "%s", kept.bytes);
    batten_text_free(&kept);
    batten_release(data);
    batten_design_free(design);
    return same;
}

/* A value that an operation refuses is a mistake in the call, as one that is refused before. */
static bool is_usage(const single *s, const arguments *given, const batten_model *model,
                     batten_status status)
{
    const bool is_value = status == BATTEN_BAD_ARGUMENT || status == BATTEN_OUT_OF_DOMAIN ||
                          status == BATTEN_UNSUPPORTED || status == BATTEN_BAD_DEGREE;
    return is_value && !fails_plain(s, given, model, status);
}

static int apply_single(const single *s, const arguments *given, const batten_model *model,
                        batten_notes *notes)
{
    batten_design *design = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_status status = open_design(s, given, model, notes, &design);
    /* What cannot be a design was not a call: nothing has been evaluated yet. */
    const bool is_wrong = status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, job_get(), notes, &data, &size);
    int exit = status == BATTEN_OK ? output_save(s->output, data, size) : EXIT_FAILED;
    if (exit == EXIT_DONE)
        exit = report(s, given, design, notes);
    if (exit == EXIT_DONE && !batten_design_output_holds(design, 0))
        exit = EXIT_FAILED;
    if (exit == EXIT_DONE && !batten_design_output_is_whole(design, 0))
        exit = EXIT_PARTLY;
    if (!arguments_has(given, "json"))
        status == BATTEN_OK ? notes_show(notes) : failed_show(notes);
    if (status != BATTEN_OK) {
        const bool is_misused = is_wrong || is_usage(s, given, model, status);
        exit = failed(s, status);
        exit = is_misused ? EXIT_USAGE : exit;
    }
    batten_release(data);
    batten_design_free(design);
    return exit;
}

int single_run(const single *s, const arguments *given)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    batten_format format = BATTEN_FORMAT_AUTO;
    if (!formats_option(s->command, given, "from-format", &format) ||
        !unit_value_check(s->command, given, "within") ||
        output_is_input(s->command, given->files[0], s->output))
        return EXIT_USAGE;
    if (batten_notes_create(1000, &notes) != BATTEN_OK)
        return output_failed(s->command, BATTEN_OUT_OF_MEMORY);
    int exit = input_read(given->files[0], format, notes, &model);
    if (exit != EXIT_FAILED) {
        const int applied = apply_single(s, given, model, notes);
        exit = applied == EXIT_DONE ? exit : applied;
    }
    batten_model_unref(model);
    batten_notes_free(notes);
    return exit;
}
