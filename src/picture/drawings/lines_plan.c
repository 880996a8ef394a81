/* The lines plan: body plan, profile and half-breadth plan on one sheet. */
#include "picture/drawings/hull.h"
#include "picture/sheet/sheet.h"

#include <stdio.h>
#include <string.h>

/*
 * Three views of one hull at one scale: profile (x, z), half-breadth plan (x, y) below it, and
 * body plan (y, z) beside the profile or at the bottom, whichever lets the drawing be larger.
 * The bow is at the larger x, to the right.
 */
typedef enum { PROFILE, BREADTH, BODY, VIEWS } which_view;

/* The coordinates that a view shows to the right and up, and the family of planes it shows as
 * curves. */
static const struct {
    int right, up;
    bat_family curves;
    const char *title;
} views[VIEWS] = {[PROFILE] = {0, 2, BAT_BUTTOCKS, "Profile"},
                  [BREADTH] = {0, 1, BAT_WATERLINES, "Half-breadth plan"},
                  [BODY] = {1, 2, BAT_STATIONS, "Body plan"}};

static const bat_colour line_colours[BAT_FAMILIES] = {[BAT_STATIONS] = {0.13, 0.15, 0.18},
                                                      [BAT_BUTTOCKS] = {0.07, 0.45, 0.27},
                                                      [BAT_WATERLINES] = {0.10, 0.36, 0.68}};
static const bat_colour design_colour = {0.80, 0.18, 0.12};

typedef struct {
    const batten_model *model;
    const batten_draw_lines_plan_options *plan;
    const batten_draw_options *options;
    bat_hull hull;
    double middle; /* x between after-body and fore-body */
    double ratio;  /* the scale is 1 : ratio */
    double scale;  /* points per unit */
    bat_plot plots[VIEWS];
    bat_rectangle strip; /* the foot of the sheet: legend, scale bar, title block */
} sheet;

static bat_pen curve_pen(bat_family family, bool is_design)
{
    return is_design ? (bat_pen){design_colour, 1.5, BAT_SOLID}
                     : (bat_pen){line_colours[family], 0.9, BAT_SOLID};
}

static const bat_pen edge_pen = {{0.13, 0.15, 0.18}, 1.6, BAT_SOLID};
static const bat_pen cross_pen = {{0.75, 0.30, 0.05}, 0.8, BAT_SOLID};
static const bat_pen grid_pen = {{0.72, 0.75, 0.78}, 0.5, BAT_SOLID};
static const bat_pen centre_pen = {{0.42, 0.45, 0.49}, 0.8, BAT_CHAIN};

/* ---- layout ---- */

/* Room around a view, in em: for the numbers at both sides, the title above, the numbers
 * below. */
static const double beside = 5, above = 3, below = 2.6;
static const double strip_height = 13, border = 2;

/* The size of a view in model units. */
static void view_size(const bat_hull *hull, which_view view, double size[2])
{
    for (int k = 0; k < 2; k++) {
        const int axis = k == 0 ? views[view].right : views[view].up;
        size[k] = hull->high[axis] - hull->low[axis];
    }
    if (view == BODY)
        size[0] *= 2;
}

/* How large the three views can be in `room`, in two columns or stacked. */
static double largest_scale(const bat_hull *hull, bat_rectangle room, double em, bool stacked)
{
    double profile[2], breadth[2], body[2];
    view_size(hull, PROFILE, profile);
    view_size(hull, BREADTH, breadth);
    view_size(hull, BODY, body);
    const double columns = stacked ? 1 : 2, rows = stacked ? 3 : 2;
    const double wide = stacked ? bat_max(profile[0], body[0]) : profile[0] + body[0];
    const double high = profile[1] + breadth[1] + (stacked ? body[1] : 0);
    return bat_min((room.width - columns * 2 * beside * em) / wide,
                   (room.height - rows * (above + below) * em) / high);
}

/* The next usual drawing scale that is not larger: 1, 1.5, 2 ... 7.5 times a power of ten. */
static double usual_ratio(double least)
{
    static const double factors[] = {1, 1.5, 2, 2.5, 3, 4, 5, 7.5};
    const double power = pow(10, floor(log10(least)));
    for (size_t i = 0; i < sizeof factors / sizeof factors[0]; i++)
        if (factors[i] * power >= least * (1 - 1e-9))
            return factors[i] * power;
    return 10 * power;
}

static void place_view(sheet *s, which_view view, double left, double top)
{
    double size[2];
    view_size(&s->hull, view, size);
    s->plots[view] =
        (bat_plot){.frame = {left, top, size[0] * s->scale, size[1] * s->scale},
                   .scale = s->scale,
                   .x0 = view == BODY ? -s->hull.high[1] : s->hull.low[views[view].right],
                   .y0 = s->hull.low[views[view].up]};
}

static void place_views(sheet *s, bat_rectangle room, double em, bool stacked)
{
    double profile[2], breadth[2], body[2];
    view_size(&s->hull, PROFILE, profile);
    view_size(&s->hull, BREADTH, breadth);
    view_size(&s->hull, BODY, body);
    const double columns = stacked ? 1 : 2, rows = stacked ? 3 : 2;
    const double wide = stacked ? bat_max(profile[0], body[0]) : profile[0] + body[0];
    const double high = profile[1] + breadth[1] + (stacked ? body[1] : 0);
    /* What is left over is shared evenly. */
    const double gap_x =
        (room.width - wide * s->scale - columns * 2 * beside * em) / (columns + 1);
    const double gap_y =
        (room.height - high * s->scale - rows * (above + below) * em) / (rows + 1);

    const double centre = room.x + 0.5 * room.width;
    const double left =
        stacked ? centre - 0.5 * profile[0] * s->scale : room.x + gap_x + beside * em;
    double top = room.y + gap_y + above * em;
    place_view(s, PROFILE, left, top);
    if (!stacked)
        place_view(s, BODY, left + profile[0] * s->scale + 2 * beside * em + gap_x, top);
    top += profile[1] * s->scale + (above + below) * em + gap_y;
    place_view(s, BREADTH, left, top);
    top += breadth[1] * s->scale + (above + below) * em + gap_y;
    if (stacked)
        place_view(s, BODY, centre - 0.5 * body[0] * s->scale, top);
}

static batten_status lay_out(sheet *s, const bat_canvas *canvas)
{
    const double em = canvas->em, edge = border * em;
    const bat_rectangle inside = {edge, edge, canvas->width - 2 * edge,
                                  canvas->height - 2 * edge};
    bat_rectangle room = inside;
    room.height -= strip_height * em;
    s->strip =
        (bat_rectangle){inside.x, inside.y + room.height, inside.width, strip_height * em};

    const double beside_it = largest_scale(&s->hull, room, em, false);
    const double stacked = largest_scale(&s->hull, room, em, true);
    const double largest = bat_max(beside_it, stacked);
    const double metres = batten_model_unit_metres(s->model);
    const double points = 72 / 0.0254 * (metres > 0 ? metres : 1); /* per unit at 1 : 1 */
    if (!(largest > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a sheet of %g x %g has no room for three views",
                        canvas->width, canvas->height);
    s->ratio = usual_ratio(points / largest);
    s->scale = points / s->ratio;
    if (!isfinite(s->ratio) || !(s->scale > 0))
        return bat_fail(BATTEN_OVERFLOW, "a hull of length %g is too large to draw",
                        s->hull.high[0] - s->hull.low[0]);
    place_views(s, room, em, stacked > beside_it);
    return BATTEN_OK;
}

/* ---- grid ---- */

/* "0.5" for a height or breadth, the number of a station. */
static void name_of(const sheet *s, bat_family family, int i, char text[static 48])
{
    const bat_cuts *cuts = &s->hull.families[family];
    char number[BATTEN_NUMBER_SIZE];
    if (family == BAT_STATIONS) {
        snprintf(text, 48, "%d", i);
        return;
    }
    const double range = s->hull.high[family] - s->hull.low[family];
    bat_number_text(cuts->cuts[i].at, 3 - (int)floor(log10(range)), number);
    snprintf(text, 48, "%s %s",
             cuts->cuts[i].is_design    ? "DWL"
             : family == BAT_WATERLINES ? "WL"
                                        : "B",
             number);
}

static bat_pen straight_pen(const sheet *s, bat_family family, int i)
{
    if (!s->hull.families[family].cuts[i].is_design)
        return grid_pen;
    return (bat_pen){design_colour, 0.9, BAT_CHAIN};
}

static bat_colour name_colour(const sheet *s, bat_family family, int i)
{
    return s->hull.families[family].cuts[i].is_design ? design_colour : line_colours[family];
}

/* Those planes of a family that a view sees as level lines, named at both ends: the design
 * waterline, or all others. */
static void draw_level(bat_canvas *canvas, const sheet *s, which_view view, bat_family family,
                       bool design)
{
    const bat_plot *plot = &s->plots[view];
    const double em = canvas->em, left = plot->frame.x - 0.8 * em;
    const double right = plot->frame.x + plot->frame.width + 0.8 * em;
    for (int i = 0; i < s->hull.families[family].count; i++) {
        if (s->hull.families[family].cuts[i].is_design != design)
            continue;
        const double y = bat_plot_y(plot, s->hull.families[family].cuts[i].at);
        char text[48];
        name_of(s, family, i, text);
        bat_canvas_segment(canvas, straight_pen(s, family, i), left, y, right, y);
        bat_canvas_label(canvas, name_colour(s, family, i), 0.8 * em, BAT_RIGHT,
                         left - 0.3 * em, y, text);
        bat_canvas_label(canvas, name_colour(s, family, i), 0.8 * em, BAT_LEFT,
                         right + 0.3 * em, y, text);
    }
}

/* The same for upright lines, named below; `sign` is -1 for the left half of the body plan. */
static void draw_upright(bat_canvas *canvas, const sheet *s, which_view view, bat_family family,
                         double sign)
{
    const bat_plot *plot = &s->plots[view];
    const double em = canvas->em, top = plot->frame.y - 0.8 * em;
    const double bottom = plot->frame.y + plot->frame.height + 0.8 * em;
    for (int i = 0; i < s->hull.families[family].count; i++) {
        const double x = bat_plot_x(plot, sign * s->hull.families[family].cuts[i].at);
        char text[48];
        name_of(s, family, i, text);
        bat_canvas_segment(canvas, grid_pen, x, top, x, bottom);
        bat_canvas_label(canvas, name_colour(s, family, i), 0.8 * em, BAT_MIDDLE, x,
                         bottom + 0.7 * em, text);
    }
}

static void draw_grids(bat_canvas *canvas, const sheet *s)
{
    /* Where names meet, that of the design waterline is the one to stay. */
    for (int design = 1; design >= 0; design--) {
        draw_level(canvas, s, PROFILE, BAT_WATERLINES, design);
        draw_level(canvas, s, BREADTH, BAT_BUTTOCKS, design);
        draw_level(canvas, s, BODY, BAT_WATERLINES, design);
    }
    draw_upright(canvas, s, PROFILE, BAT_STATIONS, 1);
    draw_upright(canvas, s, BREADTH, BAT_STATIONS, 1);
    draw_upright(canvas, s, BODY, BAT_BUTTOCKS, 1);
    draw_upright(canvas, s, BODY, BAT_BUTTOCKS, -1);

    const double em = canvas->em;
    const bat_plot *breadth = &s->plots[BREADTH], *body = &s->plots[BODY];
    const double y = bat_plot_y(breadth, 0), x = bat_plot_x(body, 0);
    bat_canvas_segment(canvas, centre_pen, breadth->frame.x - 2 * em, y,
                       breadth->frame.x + breadth->frame.width + 2 * em, y);
    bat_canvas_segment(canvas, centre_pen, x, body->frame.y - 1.2 * em, x,
                       body->frame.y + body->frame.height + 1.2 * em);
    bat_canvas_label(canvas, bat_grey, 0.8 * em, BAT_MIDDLE, x,
                     body->frame.y + body->frame.height + 1.5 * em, "CL");
    bat_canvas_label(canvas, bat_grey, 0.8 * em, BAT_RIGHT, breadth->frame.x - 2.2 * em, y,
                     "CL");
}

/* ---- curves ---- */

static batten_status draw_line(bat_canvas *canvas, const sheet *s, which_view view, bat_pen pen,
                               double sign, const bat_stroke *stroke)
{
    double *xy = bat_array3(stroke->count, 2, sizeof *xy);
    if (!xy)
        return BATTEN_OUT_OF_MEMORY;
    const bat_plot *plot = &s->plots[view];
    for (size_t i = 0; i < stroke->count; i++) {
        xy[2 * i] = bat_plot_x(plot, sign * stroke->points[3 * i + (size_t)views[view].right]);
        xy[2 * i + 1] = bat_plot_y(plot, stroke->points[3 * i + (size_t)views[view].up]);
    }
    bat_canvas_line(canvas, pen, stroke->count, xy);
    bat_release(xy);
    return BATTEN_OK;
}

static batten_status draw_lines(bat_canvas *canvas, const sheet *s, which_view view,
                                bat_pen pen, double sign, const bat_strokes *lines)
{
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < lines->count && status == BATTEN_OK; i++)
        status = draw_line(canvas, s, view, pen, sign, &lines->strokes[i]);
    return status;
}

/* The body plan shows the after-body on the left and the fore-body on the right; the section
 * amidships is both. */
static bool is_drawn(const sheet *s, which_view view, double sign, double at)
{
    const double same = 1e-6 * (s->hull.high[0] - s->hull.low[0]);
    return view != BODY || sign * (at - s->middle) >= -same;
}

static batten_status draw_curves(bat_canvas *canvas, const sheet *s, which_view view,
                                 double sign)
{
    const bat_family family = views[view].curves;
    const bat_cuts *cuts = &s->hull.families[family];
    batten_status status = BATTEN_OK;
    for (int i = 0; i < cuts->count && status == BATTEN_OK; i++)
        if (is_drawn(s, view, sign, cuts->cuts[i].at))
            status = draw_lines(canvas, s, view, curve_pen(family, cuts->cuts[i].is_design),
                                sign, &cuts->cuts[i].lines);
    return status;
}

/* Edges of the body plan are parted amidships as the stations are. */
static batten_status draw_edges(bat_canvas *canvas, const sheet *s, which_view view,
                                double sign)
{
    if (view != BODY)
        return draw_lines(canvas, s, view, edge_pen, 1, &s->hull.edges);
    bat_strokes part = {0, 0, NULL};
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < s->hull.edges.count && status == BATTEN_OK; i++)
        status = bat_strokes_add_part(&part, &s->hull.edges.strokes[i], 0, sign, s->middle);
    if (status == BATTEN_OK)
        status = draw_lines(canvas, s, view, edge_pen, sign, &part);
    bat_strokes_free(&part);
    return status;
}

/* Name a curve at its far end, or where there is room along it. */
static void name_curve(bat_canvas *canvas, const sheet *s, which_view view, double sign,
                       bat_family family, int i)
{
    const bat_strokes *lines = &s->hull.families[family].cuts[i].lines;
    const bat_plot *plot = &s->plots[view];
    char text[48];
    name_of(s, family, i, text);
    for (size_t k = 0; k < lines->count; k++) {
        const bat_stroke *line = &lines->strokes[k];
        const size_t up = (size_t)views[view].up, last = 3 * (line->count - 1);
        const bool rises = line->points[last + up] > line->points[up];
        /* A curve of the half-breadth plan ends on an edge at both ends; it is named on its
         * way. */
        for (int tenth = view == BREADTH ? 9 : 10; tenth >= 1; tenth--) {
            const size_t along = (line->count - 1) * (size_t)tenth / 10;
            const double *p = line->points + 3 * (rises ? along : line->count - 1 - along);
            const double x = bat_plot_x(plot, sign * p[views[view].right]);
            const double y = bat_plot_y(plot, p[up]) - (tenth == 10 ? 0.7 * canvas->em : 0);
            if (bat_canvas_label(canvas, name_colour(s, family, i), 0.75 * canvas->em,
                                 BAT_MIDDLE, x, y, text))
                return;
        }
    }
}

static void name_curves(bat_canvas *canvas, const sheet *s, which_view view, double sign)
{
    const bat_cuts *cuts = &s->hull.families[views[view].curves];
    for (int i = 0; i < cuts->count; i++)
        if (is_drawn(s, view, sign, cuts->cuts[i].at))
            name_curve(canvas, s, view, sign, views[view].curves, i);
}

/* ---- given points ---- */

static void draw_given_point(bat_canvas *canvas, const sheet *s, const double point[3])
{
    const double p[3] = {point[0], fabs(point[1]), point[2]};
    for (int view = 0; view < VIEWS; view++) {
        const double sign = view == BODY && p[0] < s->middle ? -1 : 1;
        const bat_plot *plot = &s->plots[view];
        const double x = bat_plot_x(plot, sign * p[views[view].right]);
        const double y = bat_plot_y(plot, p[views[view].up]);
        /* What lies off the hull by more than the grid's overhang would run into other
         * views. */
        const double room = canvas->em;
        if (x > plot->frame.x - room && x < plot->frame.x + plot->frame.width + room &&
            y > plot->frame.y - room && y < plot->frame.y + plot->frame.height + room)
            bat_canvas_cross(canvas, cross_pen, x, y, 0.2 * canvas->em);
    }
}

static void draw_table(bat_canvas *canvas, const sheet *s, const batten_offset_table *table)
{
    for (int i = 0; i < batten_offset_table_station_count(table); i++) {
        const batten_table_station *station = batten_offset_table_station(table, i);
        for (int k = 0; k < station->point_count; k++) {
            const batten_table_point *p = &station->points[k];
            draw_given_point(canvas, s, (double[3]){p->x, p->y, p->z});
        }
    }
}

static void draw_given(bat_canvas *canvas, const sheet *s)
{
    const batten_model *data = s->plan->data;
    for (int i = 0; data && i < batten_model_count(data); i++) {
        const batten_object *object = batten_model_object(data, i);
        if (object->kind == BATTEN_OBJECT_OFFSET_TABLE)
            draw_table(canvas, s, object->offset_table);
        for (int k = 0; k < object->point_count; k++)
            draw_given_point(canvas, s, object->points + 3 * (size_t)k);
    }
}

/* ---- views ---- */

static batten_status draw_view(bat_canvas *canvas, const sheet *s, which_view view)
{
    batten_status status = BATTEN_OK;
    for (double sign = view == BODY ? -1 : 1; sign <= 1 && status == BATTEN_OK; sign += 2) {
        status = draw_curves(canvas, s, view, sign);
        if (status == BATTEN_OK)
            status = draw_edges(canvas, s, view, sign);
        if (status == BATTEN_OK)
            name_curves(canvas, s, view, sign);
    }
    return status;
}

static void title_views(bat_canvas *canvas, const sheet *s)
{
    const double em = canvas->em;
    for (int view = 0; view < VIEWS; view++) {
        const bat_rectangle f = s->plots[view].frame;
        const double x = view == BODY ? f.x + 0.5 * f.width : f.x;
        bat_canvas_bold(canvas, bat_ink, 0.95 * em, view == BODY ? BAT_MIDDLE : BAT_LEFT, x,
                        f.y - 2.2 * em, views[view].title);
    }
}

/* ---- foot of the sheet ---- */

static const char *unit_of(const sheet *s)
{
    const char *unit = batten_unit_name(batten_model_unit_metres(s->model));
    return unit ? unit : "units";
}

/* "every 2.5 m", or how many there are when they stand where they were given. */
static void spacing_text(const sheet *s, bat_family family, char text[static 48])
{
    const bat_cuts *cuts = &s->hull.families[family];
    char number[BATTEN_NUMBER_SIZE];
    bat_digits_text(cuts->spacing, 4, number);
    if (cuts->spacing > 0)
        snprintf(text, 48, "every %s %s", number, unit_of(s));
    else
        snprintf(text, 48, "%d", cuts->count);
}

static void length_text(const sheet *s, double length, char text[static 48])
{
    char number[BATTEN_NUMBER_SIZE];
    bat_digits_text(length, 4, number);
    snprintf(text, 48, "%s %s", number, unit_of(s));
}

static void scale_text(const sheet *s, char text[static 48])
{
    char number[BATTEN_NUMBER_SIZE];
    bat_digits_text(s->ratio >= 1 ? s->ratio : 1 / s->ratio, 3, number);
    snprintf(text, 48, s->ratio >= 1 ? "1:%s" : "%s:1", number);
}

/* A name and its value in the title block, in one of two columns. */
static void write_pair(bat_canvas *canvas, bat_rectangle block, int row, int column,
                       const char *name, const char *value)
{
    static const double names_at[] = {0.03, 0.50}, values_at[] = {0.18, 0.69};
    const double em = canvas->em, y = block.y + (4.6 + 1.7 * row) * em;
    bat_canvas_text(canvas, bat_grey, 0.85 * em, BAT_LEFT,
                    block.x + names_at[column] * block.width, y, name);
    bat_canvas_text(canvas, bat_ink, 0.85 * em, BAT_LEFT,
                    block.x + values_at[column] * block.width, y, value);
}

static void write_figures(bat_canvas *canvas, const sheet *s, bat_rectangle block)
{
    const bat_hull *hull = &s->hull;
    char text[48];
    length_text(s, hull->high[0] - hull->low[0], text);
    write_pair(canvas, block, 0, 0, "Length", text);
    length_text(s, 2 * hull->high[1], text);
    write_pair(canvas, block, 1, 0, "Beam", text);
    length_text(s, hull->high[2] - hull->low[2], text);
    write_pair(canvas, block, 2, 0, "Depth", text);
    scale_text(s, text);
    write_pair(canvas, block, 3, 0, "Scale", text);
    spacing_text(s, BAT_STATIONS, text);
    write_pair(canvas, block, 0, 1, "Stations", text);
    spacing_text(s, BAT_WATERLINES, text);
    write_pair(canvas, block, 1, 1, "Waterlines", text);
    spacing_text(s, BAT_BUTTOCKS, text);
    write_pair(canvas, block, 2, 1, "Buttocks", text);
    write_pair(canvas, block, 3, 1, "Unit", unit_of(s));
}

/* As large as fits, up to `size`. */
static void write_title(bat_canvas *canvas, bat_rectangle block, const char *title)
{
    const double widest = 0.94 * block.width;
    double size = 1.35 * canvas->em;
    /* Bold letters are up to a fifth wider. */
    const double width = 1.2 * bat_canvas_text_width(canvas, size, title);
    if (width > widest)
        size = bat_max(0.5 * canvas->em, size * widest / width);
    bat_canvas_bold(canvas, bat_ink, size, BAT_LEFT, block.x + 0.03 * block.width,
                    block.y + 1.7 * canvas->em, title);
}

static void draw_title_block(bat_canvas *canvas, const sheet *s, bat_rectangle block)
{
    const double em = canvas->em, line = block.y + 3.2 * em;
    const bat_pen pen = {bat_ink, 0.9, BAT_SOLID};
    bat_canvas_box(canvas, (bat_colour){1, 1, 1}, block);
    bat_canvas_frame(canvas, pen, block);
    bat_canvas_segment(canvas, pen, block.x, line, block.x + block.width, line);
    write_title(canvas, block, *s->options->title ? s->options->title : "Lines plan");
    write_figures(canvas, s, block);
}

static void fill_legend(const sheet *s, bat_legend *legend)
{
    static const char *const plurals[] = {"stations", "buttocks", "waterlines"};
    bat_legend_add(legend, BAT_SAMPLE_LINE, edge_pen, "edges: sheer, keel, stem, stern");
    for (int f = 0; f < BAT_FAMILIES; f++)
        bat_legend_add(legend, BAT_SAMPLE_LINE, curve_pen((bat_family)f, false), "%s",
                       plurals[f]);
    if (!isnan(s->plan->design_waterline))
        bat_legend_add(legend, BAT_SAMPLE_LINE, curve_pen(BAT_WATERLINES, true),
                       "design waterline");
    if (s->plan->data && batten_model_count(s->plan->data) > 0)
        bat_legend_add(legend, BAT_SAMPLE_CROSS, cross_pen, "given points");
}

static void draw_legend(bat_canvas *canvas, const sheet *s, double x, double y, double width)
{
    bat_legend legend = {0};
    fill_legend(s, &legend);
    bat_legend_draw(canvas, &legend, x, y, width);
}

static void draw_foot(bat_canvas *canvas, const sheet *s)
{
    const double em = canvas->em;
    const double wide = bat_min(46 * em, 0.55 * s->strip.width);
    const bat_rectangle block = {s->strip.x + s->strip.width - wide, s->strip.y + 2 * em, wide,
                                 s->strip.height - 2 * em};
    draw_title_block(canvas, s, block);

    const double x = s->strip.x + 2.5 * em, room = block.x - x - 2.5 * em;
    draw_legend(canvas, s, x, block.y + em, room);
    bat_scale_bar(canvas, x, s->strip.y + s->strip.height - 3 * em, bat_min(room, 40 * em),
                  s->scale, unit_of(s));
    bat_canvas_frame(canvas, (bat_pen){bat_ink, 1.2, BAT_SOLID},
                     (bat_rectangle){border * em, border * em, canvas->width - 2 * border * em,
                                     canvas->height - 2 * border * em});
}

static batten_status draw_sheet(bat_canvas *canvas, sheet *s)
{
    batten_status status = lay_out(s, canvas);
    if (status != BATTEN_OK)
        return status;
    title_views(canvas, s);
    draw_grids(canvas, s);
    for (int view = 0; view < VIEWS && status == BATTEN_OK; view++)
        status = draw_view(canvas, s, (which_view)view);
    draw_given(canvas, s);
    draw_foot(canvas, s);
    return status;
}

batten_status batten_draw_lines_plan(const batten_model *model,
                                     const batten_draw_lines_plan_options *plan,
                                     const batten_draw_options *options, batten_notes *notes,
                                     char **data, size_t *size)
{
    batten_draw_options picture = batten_draw_defaults();
    batten_draw_lines_plan_options chosen = batten_draw_lines_plan_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &picture);
    if (status == BATTEN_OK)
        status = BAT_TAKE_OPTIONS(batten_draw_lines_plan_options, plan, &chosen);
    options = &picture;
    if (status != BATTEN_OK)
        return status;
    plan = &chosen;
    bat_canvas canvas;
    const double em = bat_max(4, 0.0102 * bat_min_int(options->width, options->height));
    status = bat_canvas_begin(options->format, options->width, options->height, em,
                              *options->title ? options->title : "Lines plan", &canvas);
    if (status != BATTEN_OK)
        return status;
    sheet s = {.model = model, .plan = plan, .options = options};
    status = bat_hull_cut(model, plan, notes, &s.hull);
    if (status == BATTEN_OK) {
        s.middle = 0.5 * (s.hull.low[0] + s.hull.high[0]);
        status = draw_sheet(&canvas, &s);
        bat_hull_free(&s.hull);
    }
    if (status == BATTEN_OK)
        return bat_canvas_finish(&canvas, data, size);
    bat_canvas_end(&canvas);
    return status;
}
