/* `batten hydrostatics`: how the hull in a file floats. */
#include "commands/single.h"
#include "formats.h"

#include <stddef.h>

static const option options[] = {
    {"output", 'o', OPTION_VALUE, "FILE",
     "the report to write: .txt, .csv or .json (else text is printed)"},
    FROM_FORMAT_OPTION,
    {"unit", 0, OPTION_VALUE, "UNIT", "the unit in which to work (that of the file, else m)"},
    {"json", 0, OPTION_FLAG, NULL, "print JSON"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no remarks"},
};

static int run_hydrostatics(const arguments *given)
{
    const char *output = arguments_get(given, "output");
    const single s = {
        .command = "hydrostatics",
        .output = output ? output : "-",
        .output_ending =
            arguments_has(given, "json") ? "hydrostatics.json" : "hydrostatics.txt",
        .output_operation = "hydrostatics",
    };
    return single_run(&s, given);
}

const command command_hydrostatics = {
    .name = "hydrostatics",
    .usage = "IN [--draughts LIST] [--mass T --gravity X,Y,Z] [-o FILE] [--json]",
    .summary = "displacement, centres, metacentres, coefficients and righting arms of a hull",
    .manual =
        "IN is a file of surfaces, as IGES, STEP or G2: one half of a hull or both, x along the\n"
        "ship and z up from the baseline. Edges off the centre plane that no other surface shares\n"
        "are closed by straight lines across to their images, and named. A table of offsets is\n"
        "lofted first: see 'batten help loft'.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .feature = "hydrostatics",
    .run = run_hydrostatics,
};
