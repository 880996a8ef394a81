/* `batten draw`: a picture of what is in a file. */
#include "commands/single.h"
#include "formats.h"

#include <batten/picture.h>
#include <string.h>

static const option options[] = {
    {"output", 'o', OPTION_VALUE, "PICTURE", "the file to write: .svg, .pdf or .png"},
    {"lines-plan", 0, OPTION_FLAG, NULL, "a lines drawing of a hull"},
    FROM_FORMAT_OPTION,
    {"unit", 0, OPTION_VALUE, "UNIT", "the unit in which to work (that of the file, else m)"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no report, no remarks"},
};

static int run_draw(const arguments *given)
{
    const char *output = arguments_get(given, "output");
    batten_picture_format format;
    if (!output) {
        complain("batten draw: -o PICTURE is missing; see 'batten help draw'");
        return EXIT_USAGE;
    }
    if (strcmp(output, "-") != 0 && !batten_picture_format_from_name(output, &format)) {
        complain("batten draw: '%s' ends neither in .svg, .pdf nor .png", output);
        return EXIT_USAGE;
    }
    const single s = {
        .command = "draw",
        .output = output,
        .output_ending = "picture.svg",
        .output_operation = arguments_has(given, "lines-plan") ? "lines-plan" : "picture",
    };
    return single_run(&s, given);
}

const command command_draw = {
    .name = "draw",
    .usage = "IN -o PICTURE [--lines-plan]",
    .summary = "pictures: curves with combs, shaded surfaces, lines drawings",
    .manual =
        "What is drawn depends on what is in IN: points and curves as lines; surfaces, bodies and meshes\n"
        "shaded in a PNG and as lines elsewhere. --lines-plan draws a hull as naval architects do.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .feature = "picture",
    .run = run_draw,
};
