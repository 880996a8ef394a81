/* Several drawings on one sheet, at one scale. */
#include "picture/drawings/drawing.h"
#include "picture/sheet/size.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_PANELS = 64 };

typedef struct {
    int count;
    const batten_panel *panels;
    const batten_draw_options *options;
    bat_drawing *drawings; /* [count] */
    int columns, rows, lines;
    double low[2], high[2]; /* what every panel shows */
} sheet;

/* ---- one scale for all ---- */

static int compare_numbers(const void *a, const void *b)
{
    const double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

/* The middle of the scales that the panels would choose: a wild curve does not flatten the
 * combs of the others, nor a straight one stretch them. */
static double common_comb(const sheet *s)
{
    double scales[MAX_PANELS];
    int count = 0;
    for (int i = 0; i < s->count; i++)
        if (s->drawings[i].comb_scale > 0)
            scales[count++] = s->drawings[i].comb_scale;
    qsort(scales, (size_t)count, sizeof *scales, compare_numbers);
    return count ? scales[count / 2] : 0;
}

/* The extent of the data points of a drawing, as it sees them; false when it has none. */
static bool data_extent(const bat_drawing *d, double low[2], double high[2])
{
    bool any = false;
    for (int i = 0; i < d->shape_count; i++)
        for (int k = 0; k < d->shapes[i].object->point_count; k++) {
            double seen[3];
            bat_view_project(&d->view, d->shapes[i].object->points + 3 * k, seen);
            for (int axis = 0; axis < 2; axis++) {
                low[axis] = any ? bat_min(low[axis], seen[axis]) : seen[axis];
                high[axis] = any ? bat_max(high[axis], seen[axis]) : seen[axis];
            }
            any = true;
        }
    return any;
}

/* All curves, as far as they stay near the data of the first. */
static void find_curve_range(sheet *s)
{
    double low[2] = {0, 0}, high[2] = {0, 0};
    const bool any = data_extent(&s->drawings[0], low, high);
    const double room = bat_max(high[0] - low[0], high[1] - low[1]) / 2;
    for (int axis = 0; axis < 2; axis++) {
        s->low[axis] = HUGE_VAL;
        s->high[axis] = -HUGE_VAL;
        for (int i = 0; i < s->count; i++) {
            s->low[axis] = bat_min(s->low[axis], s->drawings[i].low[axis]);
            s->high[axis] = bat_max(s->high[axis], s->drawings[i].high[axis]);
        }
        if (any) {
            s->low[axis] = bat_max(s->low[axis], low[axis] - room);
            s->high[axis] = bat_min(s->high[axis], high[axis] + room);
        }
    }
}

/* And their combs, but for one in five: the longest teeth of wild curves are cut off, and do
 * not make the others small. */
static void add_comb_range(sheet *s)
{
    const int wild = s->count / 5;
    double low[MAX_PANELS], high[MAX_PANELS];
    for (int axis = 0; axis < 2; axis++) {
        for (int i = 0; i < s->count; i++) {
            low[i] = s->drawings[i].low[axis];
            high[i] = s->drawings[i].high[axis];
        }
        qsort(low, (size_t)s->count, sizeof *low, compare_numbers);
        qsort(high, (size_t)s->count, sizeof *high, compare_numbers);
        s->low[axis] = bat_min(s->low[axis], low[wild]);
        s->high[axis] = bat_max(s->high[axis], high[s->count - 1 - wild]);
    }
}

/* Every drawing with combs of this scale. */
static batten_status find_ranges(sheet *s, double comb_scale)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < s->count && status == BATTEN_OK; i++) {
        s->drawings[i].comb_scale = comb_scale;
        status = bat_drawing_find_range(&s->drawings[i]);
    }
    return status;
}

static batten_status prepare(sheet *s)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < s->count && status == BATTEN_OK; i++) {
        s->drawings[i].model = s->panels[i].model;
        s->drawings[i].options = s->options;
        status = bat_drawing_prepare(&s->drawings[i]);
        s->lines = bat_max_int(s->lines, s->panels[i].line_count);
    }
    const double scale = common_comb(s);
    if (status == BATTEN_OK)
        status = find_ranges(s, 0);
    if (status == BATTEN_OK) {
        find_curve_range(s);
        status = find_ranges(s, scale);
    }
    if (status == BATTEN_OK)
        add_comb_range(s);
    return status;
}

/* ---- rows and columns ---- */

/* As many columns as make the panels the shape of what they show. */
static void choose_columns(sheet *s, double width, double height, double below)
{
    const double shape = (s->high[0] - s->low[0]) / (s->high[1] - s->low[1]);
    double best = 0;
    for (int columns = 1; columns <= s->count; columns++) {
        const int rows = (s->count + columns - 1) / columns;
        const double room = bat_max(height / rows - below, 1), across = width / columns;
        const double scale = bat_min(across, room * (shape > 0 && isfinite(shape) ? shape : 1));
        if (scale > best) {
            best = scale;
            s->columns = columns;
            s->rows = rows;
        }
    }
}

/* The size at which a text is no wider than its panel. */
static double fitting(bat_canvas *canvas, double size, double width, const char *text)
{
    const double wide = bat_canvas_text_width(canvas, size, text);
    return wide > width ? size * width / wide : size;
}

static void draw_panel(bat_canvas *canvas, sheet *s, int i, bat_rectangle at)
{
    static const bat_pen border = {{0.8, 0.8, 0.8}, 0.7, BAT_SOLID};
    const double em = canvas->em;
    const batten_panel *panel = &s->panels[i];
    const bat_rectangle frame = {at.x + 0.5 * em, at.y + 1.8 * em, bat_max(at.width - em, em),
                                 bat_max(at.height - (2.2 + 1.3 * s->lines) * em, em)};
    s->drawings[i].plot = bat_plot_fit(frame, s->low, s->high);
    bat_canvas_bold(canvas, bat_ink, fitting(canvas, em, 0.9 * frame.width, panel->title),
                    BAT_LEFT, frame.x, at.y + em, panel->title);
    bat_canvas_clip(canvas, frame);
    bat_drawing_draw(canvas, &s->drawings[i]);
    bat_canvas_unclip(canvas);
    bat_canvas_frame(canvas, border, frame);
    for (int k = 0; k < panel->line_count; k++)
        bat_canvas_text(
            canvas, bat_grey, fitting(canvas, 0.85 * em, frame.width, panel->lines[k]),
            BAT_LEFT, frame.x, frame.y + frame.height + (0.9 + 1.2 * k) * em, panel->lines[k]);
}

static batten_status draw(sheet *s, char **data, size_t *size)
{
    const batten_draw_options *o = s->options;
    bat_canvas canvas;
    const double em =
        bat_max(5, 0.82 * bat_size_em(o)); /* several panels want smaller letters */
    const double top = *o->title ? 3 * em : em, width = o->width - 2 * em;
    const double below = (2.2 + 1.3 * s->lines) * em;
    choose_columns(s, width, (o->height ? o->height : 2.0 / 3 * o->width) - top - em, below);
    const double range[2] = {s->columns * (s->high[0] - s->low[0]),
                             s->rows * (s->high[1] - s->low[1])};
    const int tall =
        bat_size_height(o, width - s->columns * em, range, top + em + s->rows * below);
    const batten_status status =
        bat_canvas_begin(o->format, o->width, tall, em, o->title, &canvas);
    if (status != BATTEN_OK)
        return status;
    const double height = canvas.height - top - em;
    bat_canvas_bold(&canvas, bat_ink, 1.25 * em, BAT_MIDDLE, 0.5 * canvas.width, 1.6 * em,
                    o->title);
    for (int i = 0; i < s->count; i++)
        draw_panel(&canvas, s, i,
                   (bat_rectangle){em + width / s->columns * (i % s->columns),
                                   top + height / s->rows * (i / s->columns),
                                   width / s->columns, height / s->rows});
    return bat_canvas_finish(&canvas, data, size);
}

batten_status batten_draw_panels(int count, const batten_panel *panels,
                                 const batten_draw_options *options, char **data, size_t *size)
{
    assert(panels && options && data && size);
    batten_draw_options chosen = batten_draw_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    if (count < 1 || count > MAX_PANELS)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d panels; there may be 1 to %d", count,
                        MAX_PANELS);
    sheet s = {.count = count, .panels = panels, .options = options};
    s.drawings = bat_array((size_t)count, sizeof *s.drawings);
    if (!s.drawings)
        return BATTEN_OUT_OF_MEMORY;
    status = prepare(&s);
    if (status == BATTEN_OK)
        status = draw(&s, data, size);
    for (int i = 0; i < count; i++)
        bat_drawing_free(&s.drawings[i]);
    bat_release(s.drawings);
    return status;
}
