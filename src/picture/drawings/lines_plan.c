/* The lines plan: body plan, profile and half-breadth plan on one sheet. */
#include "picture/drawings/lines_plan.h"

#include "picture/sheet/size.h"
#include <stdio.h>

static const bat_pen grid_pen = {{0.72, 0.75, 0.78}, 0.5, BAT_SOLID};
static const bat_pen centre_pen = {{0.42, 0.45, 0.49}, 0.8, BAT_CHAIN};

/* ---- grid ---- */

/* Rows of names below a view. */
enum { NAME_ROWS = 2 };

static bat_pen straight_pen(const bat_lines_sheet *s, bat_family family, int i)
{
    if (!s->hull.families[family].cuts[i].is_design)
        return grid_pen;
    return (bat_pen){bat_lines_design_colour, 0.9, BAT_CHAIN};
}

static bat_colour name_colour(const bat_lines_sheet *s, bat_family family, int i)
{
    return s->hull.families[family].cuts[i].is_design ? bat_lines_design_colour
                                                      : bat_lines_colours[family];
}

/* Those planes of a family that a view sees as level lines, named at both ends: the design
 * waterline, or all others. */
static void draw_level(bat_canvas *canvas, const bat_lines_sheet *s, bat_lines_view view,
                       bat_family family, bool design)
{
    const bat_plot *plot = &s->plots[view];
    const double em = canvas->em, left = plot->frame.x - 0.8 * em;
    const double right = plot->frame.x + plot->frame.width + 0.8 * em;
    for (int i = 0; i < s->hull.families[family].count; i++) {
        if (s->hull.families[family].cuts[i].is_design != design)
            continue;
        const double y = bat_plot_y(plot, s->hull.families[family].cuts[i].at);
        char text[48];
        bat_lines_name(s, family, i, text);
        bat_canvas_segment(canvas, straight_pen(s, family, i), left, y, right, y);
        bat_canvas_label(canvas, name_colour(s, family, i), 0.8 * em, BAT_RIGHT,
                         left - 0.3 * em, y, text);
        bat_canvas_label(canvas, name_colour(s, family, i), 0.8 * em, BAT_LEFT,
                         right + 0.3 * em, y, text);
    }
}

/* The same for upright lines, named below, in a second row where the first has no room; `sign` is -1 for the left
 * half of the body plan. */
static void draw_upright(bat_canvas *canvas, const bat_lines_sheet *s, bat_lines_view view,
                         bat_family family, double sign)
{
    const bat_plot *plot = &s->plots[view];
    const double em = canvas->em, top = plot->frame.y - 0.8 * em;
    const double bottom = plot->frame.y + plot->frame.height + 0.8 * em;
    for (int i = 0; i < s->hull.families[family].count; i++) {
        const double x = bat_plot_x(plot, sign * s->hull.families[family].cuts[i].at);
        char text[48];
        bat_lines_name(s, family, i, text);
        bat_canvas_segment(canvas, grid_pen, x, top, x, bottom);
        for (int row = 0; row < NAME_ROWS; row++)
            if (bat_canvas_label(canvas, name_colour(s, family, i), 0.8 * em, BAT_MIDDLE, x,
                                 bottom + (0.7 + 0.85 * row) * em, text))
                break;
    }
}

static void draw_grids(bat_canvas *canvas, const bat_lines_sheet *s)
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
                       body->frame.y + body->frame.height + 0.8 * em);
    bat_canvas_label(canvas, bat_grey, 0.8 * em, BAT_MIDDLE, x,
                     body->frame.y + body->frame.height + 1.5 * em, "CL");
    bat_canvas_label(canvas, bat_grey, 0.8 * em, BAT_RIGHT, breadth->frame.x - 2.5 * em, y,
                     "CL");
}

/* ---- curves ---- */

static batten_status draw_line(bat_canvas *canvas, const bat_lines_sheet *s,
                               bat_lines_view view, bat_pen pen, double sign,
                               const bat_stroke *stroke)
{
    double *xy = bat_array3(stroke->count, 2, sizeof *xy);
    if (!xy)
        return BATTEN_OUT_OF_MEMORY;
    const bat_plot *plot = &s->plots[view];
    for (size_t i = 0; i < stroke->count; i++) {
        xy[2 * i] = bat_plot_x(
            plot, sign * stroke->points[3 * i + (size_t)bat_lines_views[view].right]);
        xy[2 * i + 1] =
            bat_plot_y(plot, stroke->points[3 * i + (size_t)bat_lines_views[view].up]);
    }
    bat_canvas_line(canvas, pen, stroke->count, xy);
    bat_release(xy);
    return BATTEN_OK;
}

static batten_status draw_lines(bat_canvas *canvas, const bat_lines_sheet *s,
                                bat_lines_view view, bat_pen pen, double sign,
                                const bat_strokes *lines)
{
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < lines->count && status == BATTEN_OK; i++)
        status = draw_line(canvas, s, view, pen, sign, &lines->strokes[i]);
    return status;
}

/* The body plan shows the after-body on the left and the fore-body on the right; the section
 * amidships is both. */
static bool is_drawn(const bat_lines_sheet *s, bat_lines_view view, double sign, double at)
{
    const double same = 1e-6 * (s->hull.high[0] - s->hull.low[0]);
    return view != BODY || sign * (at - s->middle) >= -same;
}

static batten_status draw_curves(bat_canvas *canvas, const bat_lines_sheet *s,
                                 bat_lines_view view, double sign)
{
    const bat_family family = bat_lines_views[view].curves;
    const bat_cuts *cuts = &s->hull.families[family];
    batten_status status = BATTEN_OK;
    for (int i = 0; i < cuts->count && status == BATTEN_OK; i++)
        if (is_drawn(s, view, sign, cuts->cuts[i].at))
            status = draw_lines(canvas, s, view,
                                bat_lines_curve_pen(family, cuts->cuts[i].is_design), sign,
                                &cuts->cuts[i].lines);
    return status;
}

/* Edges of the body plan are parted amidships as the stations are. */
static batten_status draw_edges(bat_canvas *canvas, const bat_lines_sheet *s,
                                bat_lines_view view, double sign)
{
    if (view != BODY)
        return draw_lines(canvas, s, view, bat_lines_edge_pen, 1, &s->hull.edges);
    bat_strokes part = {0, 0, NULL};
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < s->hull.edges.count && status == BATTEN_OK; i++)
        status = bat_strokes_add_part(&part, &s->hull.edges.strokes[i], 0, sign, s->middle);
    if (status == BATTEN_OK)
        status = draw_lines(canvas, s, view, bat_lines_edge_pen, sign, &part);
    bat_strokes_free(&part);
    return status;
}

/* Name a curve at its far end, or along it where there is more room. */
static void name_curve(bat_canvas *canvas, const bat_lines_sheet *s, bat_lines_view view,
                       double sign, bat_family family, int i)
{
    const bat_strokes *lines = &s->hull.families[family].cuts[i].lines;
    const bat_plot *plot = &s->plots[view];
    char text[48];
    bat_lines_name(s, family, i, text);
    for (size_t k = 0; k < lines->count; k++) {
        const bat_stroke *line = &lines->strokes[k];
        const size_t up = (size_t)bat_lines_views[view].up, last = 3 * (line->count - 1);
        const bool rises = line->points[last + up] > line->points[up];
        double at[BAT_NAME_PLACES][2];
        for (int n = 0; n < BAT_NAME_PLACES; n++) {
            const size_t along =
                (line->count - 1) * (size_t)(BAT_NAME_PLACES - n) / BAT_NAME_PLACES;
            const double *p = line->points + 3 * (rises ? along : line->count - 1 - along);
            at[n][0] = bat_plot_x(plot, sign * p[bat_lines_views[view].right]);
            at[n][1] = bat_plot_y(plot, p[up]);
        }
        bat_canvas_name(canvas,
                        (bat_lettering){name_colour(s, family, i), 0.75 * canvas->em, true},
                        BAT_NAME_PLACES, at[0], text);
        return;
    }
}

static void name_curves(bat_canvas *canvas, const bat_lines_sheet *s, bat_lines_view view,
                        double sign)
{
    const bat_cuts *cuts = &s->hull.families[bat_lines_views[view].curves];
    for (int i = 0; i < cuts->count; i++)
        if (is_drawn(s, view, sign, cuts->cuts[i].at))
            name_curve(canvas, s, view, sign, bat_lines_views[view].curves, i);
}

/* ---- given points ---- */

static void draw_given_point(bat_canvas *canvas, const bat_lines_sheet *s,
                             const double point[3])
{
    const double p[3] = {point[0], fabs(point[1]), point[2]};
    for (int view = 0; view < VIEWS; view++) {
        const double sign = view == BODY && p[0] < s->middle ? -1 : 1;
        const bat_plot *plot = &s->plots[view];
        const double x = bat_plot_x(plot, sign * p[bat_lines_views[view].right]);
        const double y = bat_plot_y(plot, p[bat_lines_views[view].up]);
        /* What lies off the hull by more than the grid's overhang would run into other
         * views. */
        const double room = canvas->em;
        if (x > plot->frame.x - room && x < plot->frame.x + plot->frame.width + room &&
            y > plot->frame.y - room && y < plot->frame.y + plot->frame.height + room)
            bat_canvas_cross(canvas, bat_lines_cross_pen, x, y, 0.2 * canvas->em);
    }
}

static void draw_table(bat_canvas *canvas, const bat_lines_sheet *s,
                       const batten_offset_table *table)
{
    for (int i = 0; i < batten_offset_table_station_count(table); i++) {
        const batten_table_station *station = batten_offset_table_station(table, i);
        for (int k = 0; k < station->point_count; k++) {
            const batten_table_point *p = &station->points[k];
            draw_given_point(canvas, s, (double[3]){p->x, p->y, p->z});
        }
    }
}

static void draw_given(bat_canvas *canvas, const bat_lines_sheet *s)
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

static batten_status draw_view(bat_canvas *canvas, const bat_lines_sheet *s,
                               bat_lines_view view)
{
    batten_status status = BATTEN_OK;
    for (double sign = view == BODY ? -1 : 1; sign <= 1 && status == BATTEN_OK; sign += 2) {
        bat_canvas_layer(canvas, (bat_layer)bat_lines_views[view].curves);
        status = draw_curves(canvas, s, view, sign);
        bat_canvas_layer(canvas, BAT_LAYER_EDGES);
        if (status == BATTEN_OK)
            status = draw_edges(canvas, s, view, sign);
        if (status == BATTEN_OK)
            name_curves(canvas, s, view, sign);
    }
    return status;
}

/* The title mentions the diagonals where the view is wide enough. */
static const char *title_of(bat_canvas *canvas, const bat_lines_sheet *s, bat_lines_view view,
                            double size)
{
    static const char with_diagonals[] =
        "Half-breadth plan; below it the diagonals in their true shape";
    /* Bold letters are up to a fifth wider. */
    const bool fits =
        1.2 * bat_canvas_text_width(canvas, size, with_diagonals) <= s->plots[view].frame.width;
    return view == BREADTH && s->hull.reach > 0 && fits ? with_diagonals
                                                        : bat_lines_views[view].title;
}

static void title_views(bat_canvas *canvas, const bat_lines_sheet *s)
{
    const double em = canvas->em, size = 0.95 * em;
    for (int view = 0; view < VIEWS; view++) {
        const bat_rectangle f = s->plots[view].frame;
        bat_canvas_bold(canvas, bat_ink, size, view == BODY ? BAT_MIDDLE : BAT_LEFT,
                        view == BODY ? f.x + 0.5 * f.width : f.x, f.y - 2.2 * em,
                        title_of(canvas, s, (bat_lines_view)view, size));
    }
}

/* A file in the units of the model has the profile where it is. */
static void place_in_model(bat_canvas *canvas, const bat_lines_sheet *s)
{
    if (!canvas->dxf)
        return;
    canvas->dxf->scale = s->scale;
    canvas->dxf->x = bat_plot_x(&s->plots[PROFILE], 0);
    canvas->dxf->y = bat_plot_y(&s->plots[PROFILE], 0);
}

static batten_status draw_sheet(bat_canvas *canvas, bat_lines_sheet *s)
{
    batten_status status = bat_lines_lay_out(s, canvas);
    if (status != BATTEN_OK)
        return status;
    place_in_model(canvas, s);
    title_views(canvas, s);
    canvas->draws_ground = true;
    bat_canvas_layer(canvas, BAT_LAYER_GRID);
    draw_grids(canvas, s);
    canvas->draws_ground = false;
    for (int view = 0; view < VIEWS && status == BATTEN_OK; view++)
        status = draw_view(canvas, s, (bat_lines_view)view);
    if (status == BATTEN_OK)
        status = bat_lines_draw_diagonals(canvas, s);
    bat_canvas_layer(canvas, BAT_LAYER_POINTS);
    draw_given(canvas, s);
    bat_canvas_layer(canvas, BAT_LAYER_SHEET);
    bat_lines_draw_foot(canvas, s);
    bat_canvas_layer(canvas, BAT_LAYER_TABLE);
    if (!bat_lines_draw_table(canvas, s))
        batten_notes_remark(
            s->notes, "", 0, "lines plan",
            "the table of offsets has no room on a sheet of %g x %g and is left out",
            canvas->width, canvas->height);
    return status;
}

/* The names, and the file that was written beside the drawing. */
static batten_status finish_dxf(bat_canvas *canvas, char **data, size_t *size)
{
    bat_dxf_sheet *dxf = canvas->dxf;
    bat_canvas_layer(canvas, BAT_LAYER_TEXT);
    bat_canvas_place_names(canvas);
    batten_status status = canvas->status;
    if (status == BATTEN_OK && cairo_status(canvas->cairo) != CAIRO_STATUS_SUCCESS)
        status = bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for a sheet of %g x %g",
                          canvas->width, canvas->height);
    bat_canvas_end(canvas);
    if (status == BATTEN_OK)
        return bat_dxf_sheet_finish(dxf, data, size);
    bat_dxf_sheet_free(dxf);
    return status;
}

/* A sheet to draw on: of a file in the units of the model, only what is written beside is kept. */
static batten_status begin_sheet(const batten_draw_options *options, bat_dxf_sheet *dxf,
                                 bat_canvas *canvas)
{
    const bool is_dxf = options->format == BATTEN_PICTURE_DXF;
    const double em = bat_max(4, 0.0102 * bat_min_int(options->width, options->height));
    const batten_status status = bat_canvas_begin(
        is_dxf ? BATTEN_PICTURE_SVG : options->format, options->width, options->height, em,
        *options->title ? options->title : "Lines plan", canvas);
    if (status != BATTEN_OK || !is_dxf)
        return status;
    *dxf = bat_dxf_sheet_begin();
    canvas->dxf = dxf;
    return BATTEN_OK;
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
    bat_size_take_share(&picture, sqrt(0.5)); /* as paper of DIN */
    bat_canvas canvas;
    bat_dxf_sheet dxf;
    status = begin_sheet(options, &dxf, &canvas);
    if (status != BATTEN_OK)
        return status;
    bat_lines_sheet s = {.model = model, .plan = plan, .options = options, .notes = notes};
    status = bat_hull_cut(model, plan, notes, &s.hull);
    if (status == BATTEN_OK) {
        s.middle = 0.5 * (s.hull.low[0] + s.hull.high[0]);
        status = draw_sheet(&canvas, &s);
        bat_hull_free(&s.hull);
    }
    if (status == BATTEN_OK)
        return canvas.dxf ? finish_dxf(&canvas, data, size)
                          : bat_canvas_finish(&canvas, data, size);
    if (canvas.dxf)
        bat_dxf_sheet_free(canvas.dxf);
    bat_canvas_end(&canvas);
    return status;
}
