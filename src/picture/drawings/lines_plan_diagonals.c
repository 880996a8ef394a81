/* The diagonals of a lines plan: straight in the body plan, and in their true shape beside the half-breadth plan. */
#include "picture/drawings/lines_plan.h"

/* How far the straight lines run beyond the hull, in letters. */
static const double overhang = 1.2;

static bat_lettering lettering_of(const bat_canvas *canvas)
{
    return (bat_lettering){bat_lines_colours[BAT_DIAGONALS], 0.75 * canvas->em, true};
}

/* The longest way along a diagonal that its lines reach; 0 without any. */
static double longest_way(const bat_cut *cut)
{
    double longest = 0;
    for (size_t k = 0; k < cut->lines.count; k++)
        for (size_t n = 0; n < cut->lines.strokes[k].count; n++)
            longest =
                bat_max(longest, bat_diagonal_way(cut, cut->lines.strokes[k].points + 3 * n));
    return longest;
}

/* From the centre line, or the top of the view, to a little beyond the hull; named there. */
static void draw_straight(bat_canvas *canvas, const bat_lines_sheet *s, int i, double sign)
{
    const bat_cut *cut = &s->hull.families[BAT_DIAGONALS].cuts[i];
    const bat_plot *plot = &s->plots[BODY];
    const double c = bat_cos(cut->angle), sn = bat_sin(cut->angle);
    const double begin = bat_max(0, (cut->at - s->hull.high[2]) / sn);
    const double longest = longest_way(cut), end = longest + overhang * canvas->em / s->scale;
    if (!(longest > 0))
        return;
    const double tip[2] = {bat_plot_x(plot, sign * end * c),
                           bat_plot_y(plot, cut->at - end * sn)};
    char name[48];
    bat_lines_name(s, BAT_DIAGONALS, i, name);
    bat_canvas_segment(canvas, bat_lines_curve_pen(BAT_DIAGONALS, false),
                       bat_plot_x(plot, sign * begin * c),
                       bat_plot_y(plot, cut->at - begin * sn), tip[0], tip[1]);
    bat_canvas_name(canvas, lettering_of(canvas), 1, tip, name);
}

static batten_status draw_true_shape(bat_canvas *canvas, const bat_lines_sheet *s,
                                     const bat_cut *cut, const bat_stroke *line)
{
    const bat_plot *plot = &s->plots[BREADTH];
    double *xy = bat_array3(line->count, 2, sizeof *xy);
    if (!xy)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t n = 0; n < line->count; n++) {
        xy[2 * n] = bat_plot_x(plot, line->points[3 * n]);
        xy[2 * n + 1] = bat_plot_y(plot, -bat_diagonal_way(cut, line->points + 3 * n));
    }
    bat_canvas_line(canvas, bat_lines_curve_pen(BAT_DIAGONALS, false), line->count, xy);
    bat_release(xy);
    return BATTEN_OK;
}

/* Along its first line. */
static void name_true_shape(bat_canvas *canvas, const bat_lines_sheet *s, int i)
{
    const bat_cut *cut = &s->hull.families[BAT_DIAGONALS].cuts[i];
    const bat_plot *plot = &s->plots[BREADTH];
    if (cut->lines.count == 0)
        return;
    const bat_stroke *line = &cut->lines.strokes[0];
    double at[BAT_NAME_PLACES][2];
    char name[48];
    bat_lines_name(s, BAT_DIAGONALS, i, name);
    for (size_t n = 0; n < BAT_NAME_PLACES; n++) {
        const double *p =
            line->points + 3 * ((line->count - 1) * (n + 1) / (BAT_NAME_PLACES + 1));
        at[n][0] = bat_plot_x(plot, p[0]);
        at[n][1] = bat_plot_y(plot, -bat_diagonal_way(cut, p));
    }
    bat_canvas_name(canvas, lettering_of(canvas), BAT_NAME_PLACES, at[0], name);
}

batten_status bat_lines_draw_diagonals(bat_canvas *canvas, const bat_lines_sheet *s)
{
    const bat_cuts *cuts = &s->hull.families[BAT_DIAGONALS];
    batten_status status = BATTEN_OK;
    bat_canvas_layer(canvas, BAT_LAYER_DIAGONALS);
    for (int i = 0; i < cuts->count && status == BATTEN_OK; i++) {
        const bat_cut *cut = &cuts->cuts[i];
        for (size_t k = 0; k < cut->lines.count && status == BATTEN_OK; k++)
            status = draw_true_shape(canvas, s, cut, &cut->lines.strokes[k]);
        draw_straight(canvas, s, i, -1);
        draw_straight(canvas, s, i, 1);
        name_true_shape(canvas, s, i);
    }
    return status;
}
