/* `batten fit`: a curve or a surface from points, by any method of the table of features. */
#include "commands/method.h"
#include "commands/single.h"
#include "formats.h"

#include <batten/picture.h>
#include <string.h>

static const option options[] = {
    {"output", 'o', OPTION_VALUE, "OUT", "the file to write: .step, .igs, .svg, .png ..."},
    {"method", 0, OPTION_VALUE, "NAME",
     "the feature that makes the shape, with settings or without (interpolate)"},
    FROM_FORMAT_OPTION,
    {"unit", 0, OPTION_VALUE, "UNIT", "the unit in which to work (that of the file, else m)"},
    {"json", 0, OPTION_FLAG, NULL, "print the report as JSON"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no report, no remarks"},
};

static int run_fit(const arguments *given)
{
    const char *output = arguments_get(given, "output");
    const char *name = arguments_get(given, "method");
    method chosen = {.operation = "interpolate"};
    if (!output) {
        complain("batten fit: -o OUT is missing; see 'batten help fit'");
        return EXIT_USAGE;
    }
    if (name && !method_choose("fit", name, strlen(name), &chosen))
        return EXIT_USAGE;
    batten_picture_format picture;
    const single s = {
        .command = "fit",
        .operation = chosen.operation,
        .settings = chosen.settings,
        .choice = "method",
        .output = output,
        .output_ending = "fit.step",
        .output_operation =
            batten_picture_format_from_name(output, &picture) ? "picture" : NULL,
    };
    return single_run(&s, given);
}

const command command_fit = {
    .name = "fit",
    .usage = "POINTS -o OUT [--method NAME]",
    .summary = "a curve or a surface from points",
    .manual =
        "POINTS is a file of points, an aerofoil or a table of offsets. The parameters of the\n"
        "method are options; 'batten help NAME' describes them. They may also follow the name of\n"
        "the method, as in compare, and a parameter with the name of an option of this command\n"
        "must: --method fit-grid:method=smooth.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .feature = "interpolate",
    .run = run_fit,
};
