#include "commands/single.h"
#include "formats.h"

static const option options[] = {
    FROM_FORMAT_OPTION,
    {"unit", 0, OPTION_VALUE, "UNIT", "the unit in which to work (that of the file, else m)"},
    {"json", 0, OPTION_FLAG, NULL, "print JSON"},
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no remarks"},
};

static int run(const arguments *given)
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
    .usage = "IN [--from-format FORMAT] [--within TOL] [--json]",
    .summary =
        "lengths, areas, moments and special places of curves; areas and volumes of shapes",
    .manual =
        "IN is a file of curves, surfaces, bodies or meshes, as batten info takes it; of points and\n"
        "tables of offsets number and box are told. The first line says the unit of all lengths. Exit\n"
        "status 3 when only a part of it could be read, or faces could not be measured: the area is short\n"
        "by these.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .feature = "measure",
    .run = run,
};
