/* What a drawing says about the way of a tool: pens and legend of its layers, and where it goes down. */
#include "base/plural.h"
#include "picture/drawings/drawing.h"

#include <batten/measure.h>
#include <stdio.h>
#include <string.h>

/* In the order in which they are drawn in the legend. */
enum { LAYER_CUT, LAYER_PLUNGE, LAYER_TRAVEL, LAYER_NONE };

static const struct {
    const char *layer, *words;
    int colour; /* of the palette */
    double width;
    bat_dash dash;
} layers[BAT_TOOL_LAYERS] = {{"cut", "cut", 0, 1.8, BAT_SOLID},
                             {"plunge", "going down", 2, 1.2, BAT_DOTTED},
                             {"travel", "rapid travel", 1, 1, BAT_DASHED}};

/* A hundredth of the last decimal of a program: the legend has four digits. */
static const double length_precision = 1e-6;

static int layer_of(const batten_object *object)
{
    int i = 0;
    while (i < LAYER_NONE && strcmp(object->layer, layers[i].layer) != 0)
        i++;
    return object->kind == BATTEN_OBJECT_CURVE ? i : LAYER_NONE;
}

static bat_pen pen_of_layer(int i)
{
    return (bat_pen){bat_palette[layers[i].colour], layers[i].width, layers[i].dash};
}

bat_pen bat_tool_pen(const batten_object *object)
{
    return pen_of_layer(layer_of(object));
}

static batten_status add_length(const batten_object *object, int index, bat_tool *tool)
{
    const int layer = layer_of(object);
    double length = 0;
    if (layer == LAYER_NONE)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "object %d, '%s', is not a curve on a layer cut, plunge or travel",
                        index + 1, object->name);
    const batten_status status =
        batten_curve_length(object->curve, length_precision, NULL, &length);
    tool->count[layer]++;
    tool->length[layer] += length;
    return status;
}

batten_status bat_tool_measure(const batten_model *tool_path, bat_tool *out)
{
    bat_tool tool = {0};
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(tool_path) && status == BATTEN_OK; i++)
        status = add_length(batten_model_object(tool_path, i), i, &tool);
    if (status == BATTEN_OK && tool.count[LAYER_CUT] == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "no curve is on the layer cut: the tool cuts nothing");
    if (status == BATTEN_OK)
        *out = tool;
    return status;
}

void bat_tool_legend(const bat_tool *tool, const char *unit, bat_legend *legend)
{
    for (int i = 0; i < BAT_TOOL_LAYERS; i++) {
        char length[BATTEN_NUMBER_SIZE];
        bat_digits_text(tool->length[i], 4, length);
        if (tool->count[i] > 0)
            bat_legend_add(legend, BAT_SAMPLE_LINE, pen_of_layer(i), "%s: %s %s",
                           layers[i].words, length, unit);
    }
    bat_legend_add(legend, BAT_SAMPLE_DISC, (bat_pen){bat_ink, 1, BAT_SOLID},
                   "where it begins to cut, in order");
}

void bat_tool_draw_starts(bat_canvas *canvas, const bat_drawing *d)
{
    const double em = canvas->em;
    int cuts = 0;
    for (int i = 0; i < d->shape_count; i++) {
        double at[2];
        char number[BATTEN_NUMBER_SIZE];
        if (layer_of(d->shapes[i].object) != LAYER_CUT || d->shapes[i].lines.count == 0)
            continue;
        bat_drawing_to_sheet(d, d->shapes[i].lines.strokes[0].points, at);
        bat_canvas_disc(canvas, bat_ink, at[0], at[1], 0.2 * em);
        (void)snprintf(number, sizeof number, "%d", ++cuts);
        bat_canvas_name(canvas, (bat_lettering){bat_ink, 0.9 * em, true}, 1, at, number);
    }
}
