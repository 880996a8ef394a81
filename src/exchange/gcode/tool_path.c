/* The way of the tool of a G-code program as a model: what it cuts, how it travels and goes down. */
#include "exchange/gcode/gcode.h"
#include "exchange/shapes/path.h"
#include <batten/standard.h>

/* Moves of one kind in a row: items first .. end - 1. */
typedef struct {
    const bat_tool_move *moves;
    int count;
} stretch;

static const char *const layers[] = {"travel", "plunge", "cut"};

static stretch stretch_from(const bat_tool_moves *moves, int first)
{
    int end = first + 1;
    while (end < moves->count && moves->items[end].does == moves->items[first].does)
        end++;
    return (stretch){moves->items + first, end - first};
}

/* Cuts are level; their bulges are those of a path. */
static batten_status make_cut(stretch s, batten_curve **out)
{
    bat_path path = {.count = s.count + 1,
                     .vertices = bat_array((size_t)s.count + 1, sizeof *path.vertices),
                     .frame = {{0, 0, s.moves[0].to[2]}, {1, 0, 0}, {0, 0, 1}}};
    if (!path.vertices)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < s.count; i++)
        path.vertices[i] =
            (bat_vertex){s.moves[i].from[0], s.moves[i].from[1], s.moves[i].bulge};
    const double *end = s.moves[s.count - 1].to;
    path.vertices[s.count] = (bat_vertex){end[0], end[1], 0};
    const batten_status status = bat_path_curve(&path, out);
    bat_path_release(&path);
    return status;
}

static batten_status make_lines(stretch s, batten_curve **out)
{
    double *points = bat_array3((size_t)s.count + 1, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < 3; k++)
        points[k] = s.moves[0].from[k];
    for (int i = 0; i < s.count; i++)
        for (int k = 0; k < 3; k++)
            points[3 * (i + 1) + k] = s.moves[i].to[k];
    const batten_status status =
        batten_curve_polyline((batten_points){3, s.count + 1, points}, out);
    bat_release(points);
    return status;
}

static batten_status add_stretch(batten_model *model, stretch s)
{
    const bat_tool_does does = s.moves[0].does;
    batten_curve *curve = NULL;
    batten_status status = does == BAT_TOOL_CUTS ? make_cut(s, &curve) : make_lines(s, &curve);
    if (status == BATTEN_OK)
        status = batten_model_add(model, &(batten_object){.kind = BATTEN_OBJECT_CURVE,
                                                          .name = s.moves[s.count - 1].path,
                                                          .layer = layers[does],
                                                          .curve = curve});
    batten_curve_unref(curve);
    return status;
}

/* Without the way to the first path unless it is known where the tool was. */
static batten_status fill_model(const bat_tool_moves *moves, bool knows_start,
                                batten_model *model)
{
    int first = 0;
    while (!knows_start && first < moves->count && moves->items[first].does == BAT_TOOL_TRAVELS)
        first++;
    batten_status status = BATTEN_OK;
    while (first < moves->count && status == BATTEN_OK) {
        const stretch s = stretch_from(moves, first);
        status = add_stretch(model, s);
        first += s.count;
    }
    return status;
}

batten_status batten_gcode_tool_path(const batten_model *model,
                                     const batten_write_gcode_options *options,
                                     batten_notes *notes, batten_model **out)
{
    assert(model && out);
    batten_write_gcode_options chosen = batten_write_gcode_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_write_gcode_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    batten_text text = BATTEN_TEXT;
    bat_tool_moves moves = {NULL, 0, 0};
    batten_model *made = NULL;
    status = bat_write_gcode(model, &chosen, notes, &text, &moves);
    if (status == BATTEN_OK)
        status = batten_model_create(bat_gcode_unit_metres(model), &made);
    if (status == BATTEN_OK)
        status = fill_model(&moves, chosen.relative_moves, made);
    if (status == BATTEN_OK)
        *out = batten_model_ref(made);
    batten_model_unref(made);
    batten_text_free(&text);
    bat_release(moves.items);
    return status;
}
