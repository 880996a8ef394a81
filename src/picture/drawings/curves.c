/* A drawing of curves: their combs, polygons and points, with axes and a legend. */
#include "picture/drawings/drawing.h"
#include "picture/sheet/axes.h"
#include "picture/sheet/flat.h"
#include "picture/sheet/size.h"

#include <string.h>

/* ---- drawing ---- */

static void draw_stroke(bat_canvas *canvas, const bat_drawing *d, bat_pen pen,
                        const bat_stroke *stroke)
{
    for (size_t i = 0; i < stroke->count; i++)
        bat_drawing_to_sheet(d, stroke->points + 3 * i, d->xy + 2 * i);
    bat_canvas_line(canvas, pen, stroke->count, d->xy);
}

static bat_colour lighter(bat_colour colour, double by)
{
    return (bat_colour){colour.red + by * (1 - colour.red),
                        colour.green + by * (1 - colour.green),
                        colour.blue + by * (1 - colour.blue)};
}

static void draw_comb(bat_canvas *canvas, const bat_drawing *d, const bat_shape *s)
{
    if (d->comb_scale <= 0 || s->tooth_count == 0)
        return;
    const bat_pen tooth = {lighter(s->colour, 0.62), 0.7, BAT_SOLID};
    /* All tips make the outline; of the teeth those stand that leave room between them. */
    const double apart = 0.4 * canvas->em;
    double last[4] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < s->tooth_count; i++) {
        const batten_vec3 foot = s->teeth[i].foot;
        double tip[3], from[2], *to = d->xy + 2 * i;
        bat_drawing_comb_tip(&s->teeth[i], d->comb_scale, tip);
        bat_drawing_to_sheet(d, (double[3]){foot.x, foot.y, foot.z}, from);
        bat_drawing_to_sheet(d, tip, to);
        const bool stands = bat_hypot(from[0] - last[0], from[1] - last[1]) >= apart ||
                            bat_hypot(to[0] - last[2], to[1] - last[3]) >= apart;
        if (!stands && i + 1 < s->tooth_count)
            continue;
        bat_canvas_segment(canvas, tooth, from[0], from[1], to[0], to[1]);
        memcpy(last, (double[4]){from[0], from[1], to[0], to[1]}, sizeof last);
    }
    bat_canvas_line(canvas, (bat_pen){lighter(s->colour, 0.35), 1, BAT_SOLID},
                    (size_t)s->tooth_count, d->xy);
}

static void draw_polygon(bat_canvas *canvas, const bat_drawing *d, const bat_shape *s)
{
    const int count = bat_drawing_control_count(s->object);
    for (int i = 0; i < count; i++) {
        double point[3];
        bat_drawing_control_point(s->object, i, point);
        bat_drawing_to_sheet(d, point, d->xy + 2 * i);
    }
    bat_canvas_line(canvas, (bat_pen){bat_grey, 0.7, BAT_DASHED}, (size_t)count, d->xy);
    double radius = 0; /* a vertex that repeats is a larger dot */
    for (int i = 0; i < count; i++) {
        const double *at = d->xy + 2 * i;
        const bool repeats = i > 0 && at[0] == at[-2] && at[1] == at[-1];
        radius = repeats ? radius + 0.12 * canvas->em : 0.2 * canvas->em;
        bat_canvas_disc(canvas, bat_grey, at[0], at[1], radius);
    }
}

static bat_pen point_pen(const bat_shape *s)
{
    return (bat_pen){s->object->kind == BATTEN_OBJECT_POINTS ? s->colour : bat_ink, 1,
                     BAT_SOLID};
}

/* Do crosses with such arms run together: more than a quarter of them into the next one? */
static bool is_crowded(const bat_drawing *d, const bat_shape *s, double arm)
{
    const int count = s->object->point_count;
    int close = 0;
    for (int i = 1; i < count; i++) {
        double from[2], to[2];
        bat_drawing_to_sheet(d, s->object->points + 3 * (size_t)(i - 1), from);
        bat_drawing_to_sheet(d, s->object->points + 3 * (size_t)i, to);
        close += bat_hypot(to[0] - from[0], to[1] - from[1]) < 2 * arm;
    }
    return 4 * close > count;
}

/* Crosses, or dots where crosses would bury the curve. */
static void draw_points(bat_canvas *canvas, const bat_drawing *d, const bat_shape *s)
{
    const double arm = BAT_CROSS * canvas->em;
    const bool crowded = is_crowded(d, s, arm);
    const bat_pen pen = point_pen(s);
    for (int i = 0; i < s->object->point_count; i++) {
        double xy[2];
        bat_drawing_to_sheet(d, s->object->points + 3 * (size_t)i, xy);
        if (crowded)
            bat_canvas_disc(canvas, pen.colour, xy[0], xy[1], BAT_DOT * canvas->em);
        else
            bat_canvas_cross(canvas, pen, xy[0], xy[1], arm);
    }
}

/* The edges of a surface are drawn stronger than the lines inside. */
static double line_width(const bat_drawing *d, const bat_shape *s, size_t line)
{
    if (s->object->kind == BATTEN_OBJECT_TRIANGLES)
        return line < 3 * (size_t)batten_triangles_count(s->object->triangles) ? 1.4 : 0.6;
    if (s->object->kind != BATTEN_OBJECT_SURFACE)
        return s->object->kind == BATTEN_OBJECT_CURVE ? 1.8 : 1;
    const size_t in_row = line % ((size_t)d->options->isolines + 1);
    return in_row == 0 || in_row == (size_t)d->options->isolines ? 1.4 : 0.6;
}

static void draw_lines(bat_canvas *canvas, const bat_drawing *d, const bat_shape *s)
{
    for (size_t i = 0; i < s->lines.count; i++) {
        const bat_pen pen = d->tool ? bat_tool_pen(s->object)
                                    : (bat_pen){s->colour, line_width(d, s, i), BAT_SOLID};
        draw_stroke(canvas, d, pen, &s->lines.strokes[i]);
    }
}

static void draw_name(bat_canvas *canvas, const bat_drawing *d, const bat_shape *s)
{
    if (s->lines.count == 0)
        return;
    const bat_stroke *line = &s->lines.strokes[0];
    double end[2];
    bat_drawing_to_sheet(d, line->points + 3 * (line->count - 1), end);
    bat_canvas_name(canvas, (bat_lettering){s->colour, 0.8 * canvas->em, true}, 1, end,
                    s->object->name);
}

void bat_drawing_draw(bat_canvas *canvas, const bat_drawing *d)
{
    for (int i = 0; i < d->shape_count; i++)
        draw_comb(canvas, d, &d->shapes[i]);
    for (int i = 0; i < d->shape_count; i++)
        if (bat_drawing_shows_polygon(d, d->shapes[i].object))
            draw_polygon(canvas, d, &d->shapes[i]);
    for (int i = 0; i < d->shape_count; i++)
        draw_lines(canvas, d, &d->shapes[i]);
    for (int i = 0; i < d->shape_count; i++)
        if (bat_drawing_shows_points(d, d->shapes[i].object))
            draw_points(canvas, d, &d->shapes[i]);
    if (d->tool)
        bat_tool_draw_starts(canvas, d);
    for (int i = 0; !d->tool && d->shape_count > BAT_COLOURED && i < d->shape_count; i++)
        draw_name(canvas, d, &d->shapes[i]);
}

/* ---- what stands around ---- */

static const char *unit_of(const bat_drawing *d)
{
    const char *unit = batten_unit_name(batten_model_unit_metres(d->model));
    return unit ? unit : "units";
}

static bat_sample mark_of(const bat_drawing *d, const bat_shape *s, double em)
{
    return is_crowded(d, s, BAT_CROSS * em) ? BAT_SAMPLE_DOT : BAT_SAMPLE_CROSS;
}

static void add_name(const bat_drawing *d, const bat_shape *s, double em, bat_legend *legend)
{
    const bool is_points = s->object->kind == BATTEN_OBJECT_POINTS;
    const bat_sample sample = is_points ? mark_of(d, s, em) : BAT_SAMPLE_LINE;
    const bat_pen pen = {s->colour, is_points ? 1 : 1.8, BAT_SOLID};
    const char *name = s->object->name;
    char number[BATTEN_NUMBER_SIZE];
    bat_digits_text(s->sharpest, 3, number);
    if (d->comb_scale > 0 && s->tooth_count > 0)
        bat_legend_add(legend, sample, pen, "%.48s%smax |\u03ba| %s 1/%s", name,
                       *name ? ": " : "", number, unit_of(d));
    else if (*name)
        bat_legend_add(legend, sample, pen, "%.64s", name);
}

static void fill_legend(const bat_drawing *d, double em, bat_legend *legend)
{
    bool polygon = false, data = false, comb = false;
    bat_sample mark = BAT_SAMPLE_DOT;
    for (int i = 0; i < d->shape_count; i++) {
        const bat_shape *s = &d->shapes[i];
        polygon |= bat_drawing_shows_polygon(d, s->object);
        if (bat_drawing_shows_points(d, s->object) && s->object->kind == BATTEN_OBJECT_CURVE) {
            data = true;
            if (mark_of(d, s, em) == BAT_SAMPLE_CROSS)
                mark = BAT_SAMPLE_CROSS;
        }
        comb |= s->tooth_count > 0 && d->comb_scale > 0;
        if (d->shape_count <= BAT_COLOURED && !d->tool)
            add_name(d, s, em, legend);
    }
    if (d->tool)
        bat_tool_legend(d->tool, unit_of(d), legend);
    char length[BATTEN_NUMBER_SIZE];
    bat_digits_text(d->comb_scale, 3, length);
    if (polygon)
        bat_legend_add(legend, BAT_SAMPLE_POLYGON, (bat_pen){bat_grey, 0.7, BAT_DASHED},
                       "control polygon");
    if (data)
        bat_legend_add(legend, mark, (bat_pen){bat_ink, 1, BAT_SOLID}, "data points");
    if (comb)
        bat_legend_add(legend, BAT_SAMPLE_LINE,
                       (bat_pen){lighter(bat_palette[0], 0.35), 1, BAT_SOLID},
                       "curvature comb: 1/%s is %s %s long", unit_of(d), length, unit_of(d));
}

/* The plot takes what title, legend and numbers leave; returns the height of the picture, which
 * follows it unless one was asked for. */
static int place_plot(bat_canvas *canvas, bat_drawing *d, double legend)
{
    const double em = canvas->em, top = *d->options->title ? 3 * em : em;
    const double range[2] = {d->high[0] - d->low[0], d->high[1] - d->low[1]};
    const bool grid = d->kind != BATTEN_VIEW_AXONOMETRIC;
    const double bottom = legend + em + (grid ? 2.4 * em : 0);
    double left = em;
    int height = 0;
    for (int pass = 0; pass < 2; pass++) {
        /* The numbers depend a little on the scale, and the scale on the room they leave. */
        if (grid)
            left = (pass == 0 ? 4 * em : bat_plot_numbers_width(canvas, &d->plot)) + 2.4 * em;
        const double wide = bat_max(canvas->width - left - em, em);
        height = bat_size_height(d->options, wide, range, top + bottom);
        const bat_rectangle frame = {left, top, wide, bat_max(height - top - bottom, em)};
        d->plot = bat_plot_fit(frame, d->low, d->high);
    }
    return height;
}

/* The plot on a sheet whose height is not known before: a small one measures the letters. */
static batten_status lay_out(bat_drawing *d, double em, bat_legend *legend, int *height)
{
    const batten_draw_options *o = d->options;
    bat_canvas canvas;
    const batten_status status =
        bat_canvas_begin(BATTEN_PICTURE_PNG, o->width, BAT_LEAST_SIZE, em, "", &canvas);
    if (status != BATTEN_OK)
        return status;
    fill_legend(d, em, legend);
    *height = place_plot(&canvas, d, bat_legend_height(&canvas, legend, canvas.width - 4 * em));
    legend->count = 0; /* again, for only now it is known how close the points stand */
    fill_legend(d, em, legend);
    bat_canvas_end(&canvas);
    return BATTEN_OK;
}

static batten_status draw_picture(bat_drawing *d, char **data, size_t *size)
{
    const batten_draw_options *o = d->options;
    bat_canvas canvas;
    bat_legend legend = {0};
    int tall = 0;
    const double em = bat_size_em(o);
    batten_status status = lay_out(d, em, &legend, &tall);
    if (status == BATTEN_OK)
        status = bat_canvas_begin(o->format, o->width, tall, em, o->title, &canvas);
    if (status != BATTEN_OK)
        return status;

    const double width = canvas.width - 4 * em;
    const double height = bat_legend_height(&canvas, &legend, width);
    bat_canvas_bold(&canvas, bat_ink, 1.25 * em, BAT_MIDDLE, 0.5 * canvas.width, 1.6 * em,
                    o->title);
    bat_axes_draw(&canvas, &d->plot, &d->view, d->kind, unit_of(d));
    bat_canvas_clip(&canvas, d->plot.frame);
    bat_drawing_draw(&canvas, d);
    bat_canvas_unclip(&canvas);
    bat_legend_draw(&canvas, &legend, 2 * em, canvas.height - height - 0.5 * em, width);
    return bat_canvas_finish(&canvas, data, size);
}

static batten_status check_options(const batten_draw_options *o)
{
    if (o->isolines < 1 || o->isolines > 1000)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d isolines are asked for; from 1 to 1000 are drawn", o->isolines);
    if (!isfinite(o->azimuth) || !isfinite(o->elevation) || !isfinite(o->comb_scale))
        return bat_fail(BATTEN_NOT_FINITE,
                        "azimuth %g, elevation %g and comb scale %g must be finite", o->azimuth,
                        o->elevation, o->comb_scale);
    return BATTEN_OK;
}

batten_status bat_drawing_prepare(bat_drawing *d)
{
    batten_status status = check_options(d->options);
    if (status == BATTEN_OK)
        status = bat_drawing_gather(d);
    if (status == BATTEN_OK)
        status = bat_drawing_choose_view(d);
    if (status == BATTEN_OK)
        status = bat_drawing_make_room(d);
    return status;
}

void bat_drawing_free(bat_drawing *d)
{
    for (int i = 0; d->shapes && i < d->shape_count; i++) {
        bat_strokes_free(&d->shapes[i].lines);
        bat_release(d->shapes[i].teeth);
    }
    bat_release(d->shapes);
    bat_release(d->xy);
}

/* The way of `tool`, when it is not NULL. */
static batten_status draw_model(const batten_model *model, const batten_draw_options *options,
                                const bat_tool *tool, char **data, size_t *size)
{
    bat_drawing d = {.options = options, .tool = tool};
    batten_model *flat = NULL;
    batten_status status = bat_size_check(options);
    if (status == BATTEN_OK)
        status = bat_picture_model(model, options, NULL, &flat);
    d.model = flat;
    if (status == BATTEN_OK)
        status = bat_drawing_prepare(&d);
    if (status == BATTEN_OK)
        status = draw_picture(&d, data, size);
    bat_drawing_free(&d);
    batten_model_unref(flat);
    return status;
}

batten_status batten_draw(const batten_model *model, const batten_draw_options *options,
                          char **data, size_t *size)
{
    batten_draw_options chosen = batten_draw_defaults();
    const batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &chosen);
    return status == BATTEN_OK ? draw_model(model, &chosen, NULL, data, size) : status;
}

batten_status batten_draw_tool_path(const batten_model *tool_path,
                                    const batten_draw_options *options, char **data,
                                    size_t *size)
{
    batten_draw_options chosen = batten_draw_defaults();
    bat_tool tool = {0};
    batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &chosen);
    if (status == BATTEN_OK)
        status = bat_tool_measure(tool_path, &tool);
    if (status != BATTEN_OK)
        return status;
    if (chosen.view == BATTEN_VIEW_AUTO)
        chosen.view = BATTEN_VIEW_TOP;
    return draw_model(tool_path, &chosen, &tool, data, size);
}
