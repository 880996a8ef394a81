/* The output 'cubic-plane': a map of what a cubic can be, with a mark for each span of
 * your curves. */
#include "design/feature.h"
#include <batten/picture.h>

static const batten_parameter parameters[] = {
    {"cubic-plane", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "curves; each span of degree 3 becomes a mark"},
    {"from", BATTEN_VALUE_NUMBER, false, false, "-2", NULL, "where both axes begin"},
    {"to", BATTEN_VALUE_NUMBER, false, false, "3.6", NULL, "where both axes end"},
    {"glyphs", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "small curves show what lies in each region"},
    {"title", BATTEN_VALUE_TEXT, false, false, NULL, NULL, "above the picture"},
    {"width", BATTEN_VALUE_COUNT, false, false, "1100", NULL, "pixels, or points of 1/72 inch"},
    {"height", BATTEN_VALUE_COUNT, false, false, "1200", NULL,
     "pixels, or points of 1/72 inch"},
};

static batten_status run_cubic_plane(bat_run *run)
{
    batten_draw_options options = batten_draw_defaults();
    batten_draw_cubic_plane_options plane = batten_draw_cubic_plane_defaults();
    batten_model *model = NULL;
    options.width = bat_count(run, "width");
    options.height = bat_count(run, "height");
    if (bat_has(run, "title"))
        options.title = bat_text(run, "title");
    plane.low = bat_number(run, "from");
    plane.high = bat_number(run, "to");
    plane.glyphs = bat_yes(run, "glyphs");
    if (!batten_picture_format_from_name(run->name, &options.format))
        return bat_fail(BATTEN_UNSUPPORTED, "'%s' must end in .png, .svg or .pdf", run->name);
    batten_status status = bat_merge(run, "cubic-plane", BAT_CURVES, &model);
    if (status == BATTEN_OK)
        status = batten_draw_cubic_plane(model, &plane, &options, &run->data, &run->size);
    batten_model_unref(model);
    return status;
}

const bat_feature bat_feature_cubic_plane = {
    .shown =
        {"cubic-plane",
         "A map of what a cubic can be, with a mark for each span of your curves",
         "The end points of a cubic span and its two end tangents are kept, their lengths lambda\n"
         "and mu are the axes, 1 being the distance to the point T where the tangents meet. The\n"
         "map shows where the span has inflections, a cusp or a loop. In R, the square from 0 to\n"
         "1, it has none of them: a curve that was meant to be simple has all its marks there, or\n"
         "in the S-shaped regions where its data turn the other way. The nearer a mark is to the\n"
         "edge of its region, the less it takes to change the span. Straight spans, spans in space\n"
         "and spans whose end tangents are parallel have no place on the map; the legend counts\n"
         "them. See 'classify' for the numbers, 'corrected' for what to do.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm]]}\n"
         "  sheer: {interpolate: ducks}\n"
         "outputs:\n"
         "  plane.svg: {cubic-plane: sheer}\n",
         "[SL section III.3] [SL section III.4] [SL section III.5] [Liu81]",
         "batten_draw_cubic_plane", BAT_PARAMETERS(parameters), true,
         .also = "lambda mu plane, characteristic diagram, region R"},
    .run = run_cubic_plane};
