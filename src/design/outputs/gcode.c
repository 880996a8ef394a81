/* The output 'g-code': a program for a machine that cuts. */
#include "design/feature.h"

#include <batten/exchange.h>

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
};

static batten_status run_gcode(bat_run *run)
{
    batten_write_gcode_options options = batten_write_gcode_defaults();
    batten_model *model = NULL;
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
    batten_status status = bat_merge(run, "g-code", BAT_ALL, &model);
    if (status == BATTEN_OK)
        status = batten_write_gcode(model, &options, run->notes, &run->data, &run->size);
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
         "line. Inches when the design is in inches, else millimetres.",
         "units: mm\n"
         "features:\n"
         "  frame: {polyline: [[0, 0], [80, 0], [80, 50], [0, 50], [0, 0]]}\n"
         "outputs:\n"
         "  frame.nc: {g-code: frame, depth: -2, feed: 600}\n",
         "", "batten_write_gcode", BAT_PARAMETERS(parameters), true,
         .also = "gcode, CNC, NC program, toolpath, router, G2 G3"},
    .run = run_gcode};
