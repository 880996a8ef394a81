/* The output 'g-code': a program for a machine that cuts, or a picture of what it does. */
#include "design/feature.h"

#include <batten/exchange.h>
#include <batten/picture.h>

typedef enum { CENTRES_RELATIVE, CENTRES_ABSOLUTE } centres;

static const batten_parameter parameters[] = {
    {"g-code", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "curves of lines and arcs, cut in the order given here"},
    {"depth", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "height at which to cut; that of each path by default"},
    {"clearance", BATTEN_VALUE_LENGTH, false, false, "5 mm", NULL,
     "how far above the highest path the tool travels"},
    {"feed", BATTEN_VALUE_LENGTH, false, false, "1000 mm", NULL, "along the path, a minute"},
    {"plunge", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "downwards, a minute; a quarter of the feed by default"},
    {"centres", BATTEN_VALUE_WORD, false, false, "relative", "relative absolute",
     "I and J from the start of the arc (G91.1), or the centre itself (G90.1)"},
    {"moves", BATTEN_VALUE_WORD, false, false, "absolute", "absolute relative",
     "positions (G90), or steps from where the tool is (G91)"},
    {"decimals", BATTEN_VALUE_COUNT, false, false, NULL, NULL,
     "4 for millimetres, 5 for inches by default"},
    {"greatest-radius", BATTEN_VALUE_LENGTH, false, false, "10 m", NULL,
     "the largest radius the control accepts; larger arcs become lines within the last decimal"},
    {"view", BATTEN_VALUE_WORD, false, false, NULL, "top front side axonometric isometric",
     "of a picture: the direction from which it is seen; top by default"},
    {"title", BATTEN_VALUE_TEXT, false, false, NULL, NULL, "of a picture: above it"},
    {"width", BATTEN_VALUE_COUNT, false, false, NULL, NULL,
     "of a picture: pixels, or points of 1/72 inch; 1200 by default"},
    {"height", BATTEN_VALUE_COUNT, false, false, NULL, NULL,
     "of a picture; follows the shape by default"},
};

static batten_write_gcode_options program_of(const bat_run *run)
{
    batten_write_gcode_options options = batten_write_gcode_defaults();
    if (bat_has(run, "depth"))
        options.depth = bat_number(run, "depth");
    if (bat_has(run, "decimals"))
        options.decimals = bat_count(run, "decimals");
    options.clearance = bat_number(run, "clearance");
    options.feed = bat_number(run, "feed");
    options.greatest_radius = bat_number(run, "greatest-radius");
    options.plunge = bat_has(run, "plunge") ? bat_number(run, "plunge") : 0;
    options.absolute_centres = bat_word(run, "centres") == CENTRES_ABSOLUTE;
    options.relative_moves = bat_word(run, "moves") == 1;
    return options;
}

static batten_status draw_program(bat_run *run, const batten_model *model,
                                  const batten_write_gcode_options *program,
                                  batten_picture_format format)
{
    batten_draw_options options = batten_draw_defaults();
    batten_model *tool_path = NULL;
    options.format = format;
    options.notes = run->notes;
    if (bat_has(run, "view"))
        options.view = (batten_view)(BATTEN_VIEW_TOP + bat_word(run, "view"));
    if (bat_has(run, "title"))
        options.title = bat_text(run, "title");
    if (bat_has(run, "width"))
        options.width = bat_count(run, "width");
    if (bat_has(run, "height"))
        options.height = bat_count(run, "height");
    batten_status status = batten_gcode_tool_path(model, program, run->notes, &tool_path);
    if (status == BATTEN_OK)
        status = batten_draw_tool_path(tool_path, &options, &run->data, &run->size);
    batten_model_unref(tool_path);
    return status;
}

/* What only a picture has is refused for a program. */
static batten_status check_program(const bat_run *run)
{
    static const char *const words[] = {"view", "title", "width", "height"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (bat_has(run, words[i]))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "'%s' is for pictures of the tool's path, as .png, .svg and .pdf; "
                            "'%s' is a program",
                            words[i], run->name);
    return BATTEN_OK;
}

static batten_status run_gcode(bat_run *run)
{
    const batten_write_gcode_options program = program_of(run);
    batten_picture_format format;
    batten_model *model = NULL;
    const bool is_picture = batten_picture_format_from_name(run->name, &format);
    batten_status status = is_picture ? BATTEN_OK : check_program(run);
    if (status == BATTEN_OK)
        status = bat_merge(run, "g-code", BAT_ALL, &model);
    if (status == BATTEN_OK && is_picture)
        status = draw_program(run, model, &program, format);
    else if (status == BATTEN_OK)
        status = batten_write_gcode(model, &program, run->notes, &run->data, &run->size);
    batten_model_unref(model);
    return status;
}

const bat_feature bat_feature_gcode = {
    .shown =
        {"g-code", "A program for a machine that cuts",
         "G0 travels above, G1 goes down and along lines, G2 and G3 along arcs. A curve that\n"
         "consists exactly of lines and arcs is cut so: circles, polylines, and what 'fillet',\n"
         "'join' and 'offset' make of them. Any other curve must first be converted to arcs;\n"
         "'arcs' does that within a tolerance. An arc flatter than half the last decimal becomes a\n"
         "line. Inches when the design is in inches, else millimetres. A name that ends in .png,\n"
         ".svg or .pdf makes a picture of the tool's path instead: cuts solid, travel dashed.",
         "units: mm\n"
         "features:\n"
         "  frame: {polyline: [[0, 0], [80, 0], [80, 50], [0, 50], [0, 0]]}\n"
         "outputs:\n"
         "  frame.nc: {g-code: frame, depth: -2, feed: 600}\n"
         "  frame.svg: {g-code: frame, depth: -2}\n",
         "", "batten_write_gcode", BAT_PARAMETERS(parameters), true,
         .also = "gcode, CNC, NC program, toolpath, tool path, router, G2 G3"},
    .run = run_gcode};
