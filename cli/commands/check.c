/* `batten check`: the report of a shape, or the checks that a design asks for. */
#include "commands/single.h"
#include "formats.h"

#include <batten/design.h>
#include <string.h>
#include <strings.h>

/* The first options are for files of shapes alone. */
enum { OF_FILES = 3 };
static const option options[] = {
    {"within", 0, OPTION_VALUE, "TOL",
     "how far data points may lie from the shape, and edges of bodies from faces, as 2 mm"},
    FROM_FORMAT_OPTION,
    {"unit", 0, OPTION_VALUE, "UNIT", "the unit in which to work (that of the file, else m)"},
    {"allow-outside", 0, OPTION_FLAG, NULL, "paths in the design may leave its folder"},
    {"json", 0, OPTION_FLAG, NULL, "print JSON"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no remarks"},
};

static bool ends_in(const char *name, const char *ending)
{
    const size_t length = strlen(name), tail = strlen(ending);
    return length >= tail && strcasecmp(name + length - tail, ending) == 0;
}

/* Print one check of a design; EXIT_FAILED when its bound is not met. */
static int print_check(batten_design *design, int index, batten_notes *notes)
{
    char *data = NULL;
    size_t size = 0;
    const batten_status status =
        batten_design_output(design, index, job_get(), notes, &data, &size);
    if (status != BATTEN_OK)
        return output_failed("check", status);
    int exit = output_save("-", data, size);
    if (exit == EXIT_DONE && !batten_design_output_holds(design, index))
        exit = EXIT_FAILED;
    batten_release(data);
    return exit;
}

/* The checks that the design itself asks for; with --json those that go to .json files. */
static int check_design(batten_design *design, bool json, batten_notes *notes)
{
    int exit = EXIT_DONE, found = 0;
    for (int i = 0; i < batten_design_output_count(design); i++) {
        if (strcmp(batten_design_output_operation(design, i), "check") != 0 ||
            ends_in(batten_design_output_name(design, i), ".json") != json)
            continue;
        const int printed = print_check(design, i, notes);
        exit = exit == EXIT_DONE ? printed : exit;
        found++;
    }
    if (found)
        return exit;
    complain("batten check: the design has no output such as 'report.%s: {check: FEATURE}'",
             json ? "json" : "txt");
    return EXIT_FAILED;
}

/* Those of the operation, and the first of the command's own, are for files of shapes. */
static bool has_idle_option(const arguments *given)
{
    for (int i = 0; i < given->given_count; i++) {
        const int at = given->given[i].option;
        if (at >= OF_FILES && at < (int)(sizeof options / sizeof options[0]))
            continue;
        complain("batten check: --%s is for files of shapes; '%s' is a design, which says so "
                 "itself",
                 given->options[at].name, given->files[0]);
        return true;
    }
    return false;
}

static int run_design(const arguments *given)
{
    if (has_idle_option(given))
        return EXIT_USAGE;
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    if (batten_notes_create(1000, &notes) != BATTEN_OK)
        return output_failed("check", BATTEN_OUT_OF_MEMORY);
    const batten_status status = batten_design_open(
        given->files[0], arguments_has(given, "allow-outside"), notes, &design);
    int exit = EXIT_FAILED;
    if (status == BATTEN_OK)
        exit = check_design(design, arguments_has(given, "json"), notes);
    exit == EXIT_FAILED ? failed_show(notes) : notes_show(notes);
    if (status != BATTEN_OK)
        exit = output_failed("check", status);
    batten_design_free(design);
    batten_notes_free(notes);
    return exit;
}

static int run_check(const arguments *given)
{
    if (ends_in(given->files[0], ".yaml") || ends_in(given->files[0], ".yml"))
        return run_design(given);
    const single s = {
        .command = "check",
        .output = "-",
        .output_ending = arguments_has(given, "json") ? "check.json" : "check.txt",
        .output_operation = "check",
    };
    return single_run(&s, given);
}

const command command_check = {
    .name = "check",
    .usage = "IN [--within TOL] [--angle ANGLE] [--curvature PART] [--json]",
    .summary = "how fair a shape is, and how far from its data; status 1 when a bound fails",
    .manual =
        "IN is a file of curves, surfaces, bodies or meshes, or a design (.yaml), whose own\n"
        "checks are then made. For bodies gaps, loose edges, faces turned against each other and\n"
        "shells turned inside out are reported; for meshes edges at the rim, triangles turned\n"
        "against each other and edges of more than two triangles. With --within the exit status\n"
        "is 1 when there are any, for bodies when they exceed it.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .feature = "check",
    .run = run_check,
};
