/* `batten fair`: move points within a bound until their curves are fair. */
#include "commands/single.h"
#include "formats.h"

#include <batten/picture.h>

static const option options[] = {
    {"output", 'o', OPTION_VALUE, "OUT",
     "the file to write: a table (.csv), .step, .igs, a picture"},
    {"within", 0, OPTION_VALUE, "TOL", "no point moves farther than this, as 2 mm; required"},
    FROM_FORMAT_OPTION,
    {"unit", 0, OPTION_VALUE, "UNIT", "the unit in which to work (that of the file, else m)"},
    {"json", 0, OPTION_FLAG, NULL, "print the report as JSON"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no report, no remarks"},
};

static int run_fair(const arguments *given)
{
    const char *output = arguments_get(given, "output");
    if (!output || !arguments_has(given, "within")) {
        complain("batten fair: %s is missing; see 'batten help fair'",
                 output ? "--within TOL" : "-o OUT");
        return EXIT_USAGE;
    }
    batten_picture_format picture;
    const single s = {
        .command = "fair",
        .operation = "fair",
        .output = output,
        .output_ending = "fair.csv",
        .output_operation =
            batten_picture_format_from_name(output, &picture) ? "picture" : NULL,
    };
    return single_run(&s, given);
}

const command command_fair = {
    .name = "fair",
    .usage = "IN -o OUT --within TOL",
    .summary = "fair a curve or a table of offsets, moving no point farther than allowed",
    .manual =
        "IN is a table of offsets, or points, through which a curve is interpolated. Curves of\n"
        "IGES files do not state the points they pass through; they are made fair by their control\n"
        "points, with --method farin-sapidis or eck-hadenfeld. The report says how far points were\n"
        "moved and how many excess inflections there were before and after.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .feature = "fair",
    .run = run_fair,
};
