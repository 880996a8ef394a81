/* `batten measure`: its options; the work is that of the output, src/design/outputs/measure.c. */
#include "commands/single.h"
#include "formats.h"

static const option options[] = {
    FROM_FORMAT_OPTION,
    {"unit", 0, OPTION_VALUE, "UNIT", "the unit in which to work (that of the file, else m)"},
    {"json", 0, OPTION_FLAG, NULL, "print JSON"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no remarks"},
};

static int run_measure(const arguments *given)
{
    const single s = {
        .command = "measure",
        .output = "-",
        .output_ending = arguments_has(given, "json") ? "measure.json" : "measure.txt",
        .output_operation = "measure",
    };
    return single_run(&s, given);
}

const command command_measure = {
    .name = "measure",
    .usage = "IN [--from-format FORMAT] [--within TOL] [--all] [--json]",
    .summary =
        "lengths, areas, moments, special places of curves; areas and volumes of shapes",
    .manual =
        "IN is a file of curves, surfaces, bodies or meshes, as for batten info; for points and\n"
        "tables of offsets their number and box are reported. The first line states the unit of\n"
        "all lengths. The exit status is 3 when only a part of IN could be read, or when faces\n"
        "could not be measured and are missing from the area.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .feature = "measure",
    .run = run_measure,
};
