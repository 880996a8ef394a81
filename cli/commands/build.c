/* `batten build`: evaluate a design and write its outputs, each by way of a temporary file. */
#include "commands/results.h"
#include "system.h"

#include <batten/design.h>
#include <batten/text.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const option options[] = {
    {"output", 'o', OPTION_VALUE, "DIR",
     "where the outputs go (beside the design); made when it is missing"},
    {"set", 0, OPTION_MANY, "NAME=VALUE",
     "set a parameter of the design, or a value by its path"},
    {"only", 0, OPTION_VALUE, "FEATURE",
     "evaluate this feature and what it needs; make no outputs"},
    {"allow-outside", 0, OPTION_FLAG, NULL, "paths in the design may leave its folder"},
    {"json", 0, OPTION_FLAG, NULL, "print the report as JSON"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no report, no remarks"},
};

/* Is there a parameter of that name? A misspelt one would be added, and change nothing. */
static batten_status check_parameter(const batten_design *design, const char *name)
{
    const int count = batten_design_parameter_count(design);
    const char **names = batten_array((size_t)count, sizeof *names);
    if (!names)
        return BATTEN_OUT_OF_MEMORY;
    bool found = false;
    for (int i = 0; i < count; i++) {
        names[i] = batten_design_parameter_name(design, i);
        found |= strcmp(names[i], name) == 0;
    }
    const char *near = nearest_name(name, count, names);
    batten_release(names);
    return found
               ? BATTEN_OK
               : batten_fail(BATTEN_NOT_FOUND, "--set: the design has no parameter '%s'%s%s%s",
                             name, near ? "; did you mean '" : "", near ? near : "",
                             near ? "'?" : "");
}

/* --set name=value: a parameter when the name is a bare word, else a path. */
static batten_status set_value(batten_design *design, const char *assignment,
                               batten_notes *notes)
{
    const char *equals = strchr(assignment, '=');
    if (!equals || equals == assignment)
        return batten_fail(BATTEN_BAD_ARGUMENT, "--set wants NAME=VALUE, not '%s'", assignment);
    const size_t length = (size_t)(equals - assignment);
    const bool is_path = memchr(assignment, '.', length) != NULL;
    batten_text path = BATTEN_TEXT;
    batten_text_add(&path, "%s%.*s", is_path ? "" : "parameters.", (int)length, assignment);
    batten_status status = path.failed ? BATTEN_OUT_OF_MEMORY : BATTEN_OK;
    if (status == BATTEN_OK && strncmp(path.bytes, "parameters.", 11) == 0)
        status = check_parameter(design, path.bytes + 11);
    if (status == BATTEN_OK)
        status = batten_design_set(design, path.bytes, equals + 1, notes);
    batten_text_free(&path);
    return status;
}

static batten_status set_values(batten_design *design, const arguments *given,
                                batten_notes *notes)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < given->given_count; i++)
        if (strcmp(given->options[given->given[i].option].name, "set") == 0)
            status = set_value(design, given->given[i].value, notes);
    return status;
}

/* The folder of the outputs, with its final slash; yours to release. */
static char *output_folder(const arguments *given)
{
    const char *chosen = arguments_get(given, "output");
    const char *design = given->files[0];
    const char *slash = strrchr(design, '/');
    batten_text path = BATTEN_TEXT;
    if (chosen)
        batten_text_add(&path, "%s/", chosen);
    else
        batten_text_add(&path, "%.*s", slash ? (int)(slash - design) + 1 : 0, design);
    char *made = NULL;
    return batten_text_take(&path, &made, NULL) == BATTEN_OK ? made : NULL;
}

static batten_status make_folder(const char *folder)
{
    const int error = system_make_folder(folder);
    if (error == 0)
        return BATTEN_OK;
    if (error == EEXIST || error == ENOTDIR)
        return batten_fail(BATTEN_FILE_ERROR,
                           "'%s' should be the folder of the outputs, but is a file", folder);
    return batten_fail(BATTEN_FILE_ERROR, "cannot make the folder '%s': %s", folder,
                       strerror(error));
}

/* What is asked for must be there before the work, which may be long. */
static batten_status prepare_folder(const arguments *given)
{
    const char *chosen = arguments_get(given, "output");
    return chosen ? make_folder(chosen) : BATTEN_OK;
}

/* Would an output overwrite the design, or a file that it reads? */
static bool overwrites_input(const batten_design *design, const char *input, const char *folder)
{
    bool found = false;
    for (int i = 0; !found && i < batten_design_output_count(design); i++) {
        batten_text path = BATTEN_TEXT;
        batten_text_add(&path, "%s%s", folder, batten_design_output_name(design, i));
        found = !path.failed && output_is_input("build", input, path.bytes);
        batten_text_free(&path);
    }
    return found;
}

/* What cannot be read is reported when it is read. */
static bool overwrites_file(const batten_design *design, int i, const char *folder)
{
    bool found = false;
    char *input = NULL;
    if (batten_design_file_path(design, i, &input) == BATTEN_OK)
        found = overwrites_input(design, input, folder);
    batten_release(input);
    return found;
}

static bool overwrites_inputs(const batten_design *design, const arguments *given)
{
    char *folder = output_folder(given);
    bool found = folder && overwrites_input(design, given->files[0], folder);
    for (int i = 0; folder && !found && i < batten_design_file_count(design); i++)
        found = overwrites_file(design, i, folder);
    batten_release(folder);
    return found;
}

static batten_status make_output(batten_design *design, int index, const char *folder,
                                 batten_notes *notes)
{
    char *data = NULL;
    size_t size = 0;
    batten_status status = batten_design_output(design, index, job_get(), notes, &data, &size);
    batten_text path = BATTEN_TEXT;
    batten_text_add(&path, "%s%s", folder, batten_design_output_name(design, index));
    if (status == BATTEN_OK) {
        status = path.failed ? BATTEN_OUT_OF_MEMORY
                             : batten_design_check_path(design, folder, path.bytes);
        if (status == BATTEN_OK)
            status = batten_save_file(path.bytes, data, size);
        if (status != BATTEN_OK)
            batten_notes_add(notes, "", 0, "", "%s", batten_message());
    }
    batten_text_free(&path);
    batten_release(data);
    return status;
}

static bool is_failure(batten_status status)
{
    return status != BATTEN_OK && status != BATTEN_PARTLY_READ;
}

/* Does a failure end all the work, and not only that of one output? */
static bool ends_all(batten_status status)
{
    return status == BATTEN_CANCELLED || status == BATTEN_OUT_OF_MEMORY;
}

/* Make every output that can be made; `names` receives them. What failed is in the notes, and
 * the first failure is returned. */
static batten_status make_outputs(batten_design *design, const arguments *given,
                                  batten_notes *notes, const char **names, int *made)
{
    char *folder = output_folder(given);
    batten_status status = folder ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; !ends_all(status) && i < batten_design_output_count(design); i++) {
        const batten_status one = make_output(design, i, folder, notes);
        if (one == BATTEN_OK)
            names[(*made)++] = batten_design_output_name(design, i);
        else if (status == BATTEN_OK || ends_all(one))
            status = one;
    }
    batten_release(folder);
    return status;
}

/* Did every check of the design find its bound kept? */
static bool bounds_hold(const batten_design *design)
{
    for (int i = 0; i < batten_design_output_count(design); i++)
        if (!batten_design_output_holds(design, i))
            return false;
    return true;
}

/* Was a file read in part, or does an output say less than there is? */
static bool is_partial(const batten_design *design)
{
    for (int i = 0; i < batten_design_output_count(design); i++)
        if (!batten_design_output_is_whole(design, i))
            return true;
    for (int i = 0; i < batten_design_result_count(design); i++)
        if (batten_design_result_at(design, i)->status == BATTEN_PARTLY_READ)
            return true;
    return false;
}

static int report(const arguments *given, const batten_design *design, const char *const *names,
                  int made, const batten_notes *notes)
{
    batten_text text = BATTEN_TEXT;
    if (arguments_has(given, "json"))
        results_json(&text, design, made, names, notes);
    else if (!arguments_has(given, "quiet"))
        results_text(&text, design, made, names);
    return output_print(&text);
}

/* Evaluate all features and make the outputs; the first failure. */
static batten_status make_all(batten_design *design, const arguments *given,
                              batten_notes *notes, const char **names, int *made)
{
    const batten_status features = batten_design_evaluate(design, NULL, job_get(), notes);
    if (ends_all(features))
        return features;
    const batten_status outputs = make_outputs(design, given, notes, names, made);
    return ends_all(outputs) || !is_failure(features) ? outputs : features;
}

/* Say what failed: one thing that ended the work, or in all notes what was not made. */
static int say_failure(const batten_design *design, batten_status status, bool in_notes,
                       int made)
{
    if (!in_notes)
        return output_failed("build", status);
    complain("batten build: failed; %d of %d outputs were made", made,
             batten_design_output_count(design));
    return EXIT_FAILED;
}

static int exit_of(const batten_design *design, bool failed)
{
    if (failed || !bounds_hold(design))
        return EXIT_FAILED;
    return is_partial(design) ? EXIT_PARTLY : EXIT_DONE;
}

static int build(batten_design *design, const arguments *given, batten_notes *notes)
{
    const int output_count = batten_design_output_count(design);
    const char **names = batten_array((size_t)output_count, sizeof *names);
    const char *only = arguments_get(given, "only");
    int made = 0;
    batten_status status = names ? set_values(design, given, notes) : BATTEN_OUT_OF_MEMORY;
    /* Nothing is made yet: what cannot be set was not a call. */
    bool is_misused = status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && !only && overwrites_inputs(design, given)) {
        batten_release(names);
        return EXIT_USAGE;
    }
    if (status == BATTEN_OK && !only)
        status = prepare_folder(given);
    const bool all = status == BATTEN_OK && !only;
    if (all)
        status = make_all(design, given, notes, names, &made);
    else if (status == BATTEN_OK)
        status = batten_design_evaluate(design, only, job_get(), notes);
    /* There is no such feature, where none was evaluated. */
    is_misused |= status == BATTEN_NOT_FOUND && batten_design_result_count(design) == 0;

    const bool failed = is_failure(status), in_notes = all && !ends_all(status);
    int exit = exit_of(design, failed);
    if (!arguments_has(given, "json"))
        failed && !in_notes ? failed_show(notes) : notes_show(notes);
    const int reported = report(given, design, names, made, notes);
    if (failed)
        exit = say_failure(design, status, in_notes, made);
    if (is_misused)
        exit = EXIT_USAGE;
    batten_release(names);
    return reported == EXIT_DONE ? exit : reported;
}

static int run_build(const arguments *given)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    if (batten_notes_create(1000, &notes) != BATTEN_OK)
        return output_failed("build", BATTEN_OUT_OF_MEMORY);
    const batten_status status = batten_design_open(
        given->files[0], arguments_has(given, "allow-outside"), notes, &design);
    int exit;
    if (status == BATTEN_OK) {
        exit = build(design, given, notes);
    } else {
        failed_show(notes);
        exit = output_failed("build", status);
    }
    batten_design_free(design);
    batten_notes_free(notes);
    return exit;
}

const command command_build = {
    .name = "build",
    .usage = "DESIGN [-o DIR] [--set NAME=VALUE] [--only FEATURE]",
    .summary = "make everything that a design file describes: the main job",
    .manual =
        "Evaluates the features of DESIGN and writes its outputs, each to a temporary file that\n"
        "is then renamed. What cannot be made is reported, and the exit status is 1; everything\n"
        "else is still made. The report gives for each feature the time it took, the distance of\n"
        "its result from the data, and how far fairing moved any point. No output may be DESIGN\n"
        "itself or a file that it reads. 'batten help design' describes design files.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .run = run_build,
};
