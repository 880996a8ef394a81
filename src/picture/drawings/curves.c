/* A drawing of curves: their combs, polygons and points, with axes and a legend. */
#include "picture/sheet/axes.h"
#include "picture/sheet/drawing.h"
#include "picture/sheet/flat.h"

#include <stdio.h>
#include <string.h>

/* So many objects are told apart by colour; more are named where they end. */
enum { COLOURED = 8 };

static const bat_colour palette[COLOURED] = {
    {0.09, 0.32, 0.62}, {0.76, 0.26, 0.10}, {0.08, 0.48, 0.30}, {0.48, 0.22, 0.58},
    {0.72, 0.50, 0.04}, {0.05, 0.50, 0.58}, {0.70, 0.16, 0.38}, {0.36, 0.36, 0.36}};

/* ---- gathering ---- */

static batten_status gather_comb(bat_shape *s)
{
    const batten_curve *curve = s->object->curve;
    const int spans = batten_curve_spans(curve, NULL) - 1;
    const int per_span = bat_max_int(4, 160 / bat_max_int(spans, 1));
    const int count = spans * (per_span + 1);
    batten_tooth *teeth = bat_array((size_t)count, sizeof *teeth);
    if (!teeth)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_curve_comb(curve, per_span, 1, teeth);
    if (status != BATTEN_OK) {
        bat_release(teeth);
        /* A curve with a cusp is still a curve: it is drawn without a comb. */
        return status == BATTEN_SINGULAR_HERE ? BATTEN_OK : status;
    }
    s->teeth = teeth;
    s->tooth_count = count;
    for (int i = 0; i < count; i++)
        s->sharpest = bat_max(s->sharpest, fabs(teeth[i].curvature));
    return BATTEN_OK;
}

static batten_status gather_curve(const bat_drawing *d, bat_shape *s)
{
    bat_stroke stroke = {0, NULL};
    batten_status status = bat_stroke_curve(s->object->curve, &stroke);
    if (status == BATTEN_OK)
        status = bat_strokes_add(&s->lines, stroke);
    if (status == BATTEN_OK && d->options->comb && batten_curve_dimension(s->object->curve) > 1)
        status = gather_comb(s);
    return status;
}

static batten_status gather_isolines(const bat_drawing *d, bat_shape *s,
                                     batten_direction direction)
{
    const batten_interval domain = batten_surface_domain(s->object->surface, direction);
    const int count = d->options->isolines;
    batten_status status = BATTEN_OK;
    for (int k = 0; k <= count && status == BATTEN_OK; k++) {
        const double at = k < count ? domain.a + (domain.b - domain.a) * k / count : domain.b;
        bat_stroke stroke = {0, NULL};
        status = bat_stroke_isoline(s->object->surface, direction, at, &stroke);
        if (status == BATTEN_OK)
            status = bat_strokes_add(&s->lines, stroke);
    }
    return status;
}

static batten_status gather_stations(bat_shape *s)
{
    const batten_offset_table *table = s->object->offset_table;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_offset_table_station_count(table) && status == BATTEN_OK; i++) {
        const batten_table_station *station = batten_offset_table_station(table, i);
        const size_t count = (size_t)station->point_count;
        double *points = bat_array3(count, 3, sizeof *points);
        if (!points)
            return BATTEN_OUT_OF_MEMORY;
        for (size_t k = 0; k < count; k++) {
            const batten_table_point *p = &station->points[k];
            memcpy(points + 3 * k, (double[3]){p->x, p->y, p->z}, 3 * sizeof *points);
        }
        status = bat_strokes_add(&s->lines, (bat_stroke){count, points});
    }
    return status;
}

static batten_status gather_shape(const bat_drawing *d, bat_shape *s)
{
    switch (s->object->kind) {
    case BATTEN_OBJECT_CURVE:
        return gather_curve(d, s);
    case BATTEN_OBJECT_SURFACE: {
        const batten_status status = gather_isolines(d, s, BATTEN_U);
        return status == BATTEN_OK ? gather_isolines(d, s, BATTEN_V) : status;
    }
    case BATTEN_OBJECT_OFFSET_TABLE:
        return gather_stations(s);
    case BATTEN_OBJECT_TRIANGLES:
        return bat_stroke_triangles(s->object->triangles, d->options->isolines, &s->lines);
    case BATTEN_OBJECT_MESH:
        return bat_stroke_mesh(s->object->mesh, BAT_MESH_EDGES_OR_ALL, NULL, &s->lines);
    case BATTEN_OBJECT_POINTS:
    case BATTEN_OBJECT_BODY: /* the model was made flat, and its bodies meshes */
    case BATTEN_OBJECT_INSTANCE:
        break;
    }
    return BATTEN_OK;
}

static bat_colour colour_of(const batten_object *object, int index, int count)
{
    /* Colours of faces are often too pale for lines. */
    const double share = object->kind == BATTEN_OBJECT_MESH ? 0.5 : 1;
    if (object->has_colour)
        return (bat_colour){share * object->colour[0], share * object->colour[1],
                            share * object->colour[2]};
    return palette[count <= COLOURED ? index : 0];
}

static batten_status gather(bat_drawing *d)
{
    d->shape_count = batten_model_count(d->model);
    if (d->shape_count == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the model has no objects: there is nothing to draw");
    d->shapes = bat_array((size_t)d->shape_count, sizeof *d->shapes);
    if (!d->shapes)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < d->shape_count && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(d->model, i);
        d->shapes[i].object = object;
        d->shapes[i].colour = colour_of(object, i, d->shape_count);
        status = gather_shape(d, &d->shapes[i]);
    }
    return status;
}

/* ---- every point that will be drawn, for those who must know them all ---- */

typedef void visit_point(void *user, const double point[3]);

static bool shows_polygon(const bat_drawing *d, const batten_object *object)
{
    return object->kind == BATTEN_OBJECT_CURVE && d->options->control_polygon &&
           batten_curve_dimension(object->curve) > 1;
}

static bool shows_points(const bat_drawing *d, const batten_object *object)
{
    return object->point_count > 0 &&
           (object->kind == BATTEN_OBJECT_POINTS || d->options->data_points);
}

static void control_point(const batten_curve *curve, int i, double point[3])
{
    const int dimension = batten_curve_dimension(curve);
    for (int k = 0; k < 3; k++)
        point[k] = k < dimension ? batten_curve_points(curve)[i * dimension + k] : 0;
}

static void comb_tip(const batten_tooth *tooth, double scale, double tip[3])
{
    tip[0] = tooth->foot.x + scale * (tooth->tip.x - tooth->foot.x);
    tip[1] = tooth->foot.y + scale * (tooth->tip.y - tooth->foot.y);
    tip[2] = tooth->foot.z + scale * (tooth->tip.z - tooth->foot.z);
}

static void visit_shape(const bat_drawing *d, const bat_shape *s, visit_point *visit,
                        void *user)
{
    double point[3];
    for (size_t i = 0; i < s->lines.count; i++)
        for (size_t k = 0; k < s->lines.strokes[i].count; k++)
            visit(user, s->lines.strokes[i].points + 3 * k);
    if (shows_points(d, s->object))
        for (int i = 0; i < s->object->point_count; i++)
            visit(user, s->object->points + 3 * (size_t)i);
    if (shows_polygon(d, s->object))
        for (int i = 0; i < batten_curve_point_count(s->object->curve); i++) {
            control_point(s->object->curve, i, point);
            visit(user, point);
        }
    for (int i = 0; d->comb_scale > 0 && i < s->tooth_count; i++) {
        comb_tip(&s->teeth[i], d->comb_scale, point);
        visit(user, point);
    }
}

static void visit_all(const bat_drawing *d, visit_point *visit, void *user)
{
    for (int i = 0; i < d->shape_count; i++)
        visit_shape(d, &d->shapes[i], visit, user);
}

/* ---- view, scale of the combs, range ---- */

typedef struct {
    double low[3], high[3];
} extent;

static const extent nothing = {{HUGE_VAL, HUGE_VAL, HUGE_VAL},
                               {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};

static void extend(void *user, const double point[3])
{
    extent *e = user;
    for (int k = 0; k < 3; k++) {
        e->low[k] = bat_min(e->low[k], point[k]);
        e->high[k] = bat_max(e->high[k], point[k]);
    }
}

typedef struct {
    const bat_view *view;
    extent extent;
} seen;

static void extend_seen(void *user, const double point[3])
{
    seen *s = user;
    double projected[3];
    bat_view_project(s->view, point, projected);
    extend(&s->extent, projected);
}

/* The plane in which everything lies, to rounding, else from the side. */
static batten_view detect_view(const extent *e)
{
    double range[3], largest = 0, coordinate = 0;
    for (int k = 0; k < 3; k++) {
        range[k] = e->high[k] - e->low[k];
        largest = bat_max(largest, range[k]);
        coordinate = bat_max(coordinate, bat_max(fabs(e->low[k]), fabs(e->high[k])));
    }
    const double flat = bat_max(1e-9 * largest, 1e-14 * coordinate);
    if (range[2] <= flat)
        return BATTEN_VIEW_TOP;
    if (range[1] <= flat)
        return BATTEN_VIEW_SIDE;
    return range[0] <= flat ? BATTEN_VIEW_FRONT : BATTEN_VIEW_AXONOMETRIC;
}

static double largest_range(const bat_drawing *d)
{
    seen s = {&d->view, nothing};
    visit_all(d, extend_seen, &s);
    return bat_max(s.extent.high[0] - s.extent.low[0], s.extent.high[1] - s.extent.low[1]);
}

/* The longest tooth of all combs becomes a tenth of the picture. */
static double choose_comb_scale(const bat_drawing *d)
{
    double sharpest = 0;
    for (int i = 0; i < d->shape_count; i++)
        sharpest = bat_max(sharpest, d->shapes[i].sharpest);
    if (d->options->comb_scale > 0)
        return d->options->comb_scale;
    const double range = largest_range(d);
    /* What is straight but for roundings has no comb, rather than a picture of the
     * roundings. */
    return sharpest * range > 1e-9 ? 0.1 * range / sharpest : 0;
}

static batten_status choose_view(bat_drawing *d)
{
    extent e = nothing;
    visit_all(d, extend, &e);
    if (!(e.low[0] <= e.high[0]))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "none of the %d objects has anything that could be drawn",
                        d->shape_count);
    d->kind = d->options->view == BATTEN_VIEW_AUTO ? detect_view(&e) : d->options->view;
    d->view = bat_view_make(d->kind, d->options->azimuth, d->options->elevation);
    if (d->kind == BATTEN_VIEW_ISOMETRIC)
        d->kind = BATTEN_VIEW_AXONOMETRIC;
    d->comb_scale = choose_comb_scale(d);
    return bat_drawing_find_range(d);
}

batten_status bat_drawing_find_range(bat_drawing *d)
{
    seen s = {&d->view, nothing};
    visit_all(d, extend_seen, &s);
    const double margin = 0.03 * largest_range(d);
    for (int k = 0; k < 2; k++) {
        d->low[k] = s.extent.low[k] - margin;
        d->high[k] = s.extent.high[k] + margin;
        if (!isfinite(d->high[k] - d->low[k]))
            return bat_fail(BATTEN_OVERFLOW, "coordinates from %g to %g are too large to draw",
                            s.extent.low[k], s.extent.high[k]);
    }
    return BATTEN_OK;
}

static batten_status make_room(bat_drawing *d)
{
    size_t longest = 2;
    for (int i = 0; i < d->shape_count; i++) {
        const bat_shape *s = &d->shapes[i];
        for (size_t k = 0; k < s->lines.count; k++)
            if (s->lines.strokes[k].count > longest)
                longest = s->lines.strokes[k].count;
        if ((size_t)s->tooth_count > longest)
            longest = (size_t)s->tooth_count;
        if (s->object->kind == BATTEN_OBJECT_CURVE &&
            (size_t)batten_curve_point_count(s->object->curve) > longest)
            longest = (size_t)batten_curve_point_count(s->object->curve);
    }
    d->xy = bat_array3(longest, 2, sizeof *d->xy);
    return d->xy ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- drawing ---- */

static void to_sheet(const bat_drawing *d, const double point[3], double xy[2])
{
    double projected[3];
    bat_view_project(&d->view, point, projected);
    xy[0] = bat_plot_x(&d->plot, projected[0]);
    xy[1] = bat_plot_y(&d->plot, projected[1]);
}

static void draw_stroke(bat_canvas *canvas, const bat_drawing *d, bat_pen pen,
                        const bat_stroke *stroke)
{
    for (size_t i = 0; i < stroke->count; i++)
        to_sheet(d, stroke->points + 3 * i, d->xy + 2 * i);
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
    for (int i = 0; i < s->tooth_count; i++) {
        const batten_vec3 foot = s->teeth[i].foot;
        double tip[3], from[2];
        comb_tip(&s->teeth[i], d->comb_scale, tip);
        to_sheet(d, (double[3]){foot.x, foot.y, foot.z}, from);
        to_sheet(d, tip, d->xy + 2 * i);
        bat_canvas_segment(canvas, tooth, from[0], from[1], d->xy[2 * i], d->xy[2 * i + 1]);
    }
    bat_canvas_line(canvas, (bat_pen){lighter(s->colour, 0.35), 1, BAT_SOLID},
                    (size_t)s->tooth_count, d->xy);
}

static void draw_polygon(bat_canvas *canvas, const bat_drawing *d, const bat_shape *s)
{
    const int count = batten_curve_point_count(s->object->curve);
    for (int i = 0; i < count; i++) {
        double point[3];
        control_point(s->object->curve, i, point);
        to_sheet(d, point, d->xy + 2 * i);
    }
    bat_canvas_line(canvas, (bat_pen){bat_grey, 0.7, BAT_DASHED}, (size_t)count, d->xy);
    for (int i = 0; i < count; i++)
        bat_canvas_disc(canvas, bat_grey, d->xy[2 * i], d->xy[2 * i + 1], 0.2 * canvas->em);
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
        to_sheet(d, s->object->points + 3 * (size_t)(i - 1), from);
        to_sheet(d, s->object->points + 3 * (size_t)i, to);
        close += hypot(to[0] - from[0], to[1] - from[1]) < 2 * arm;
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
        to_sheet(d, s->object->points + 3 * (size_t)i, xy);
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
    for (size_t i = 0; i < s->lines.count; i++)
        draw_stroke(canvas, d, (bat_pen){s->colour, line_width(d, s, i), BAT_SOLID},
                    &s->lines.strokes[i]);
}

static void draw_name(bat_canvas *canvas, const bat_drawing *d, const bat_shape *s)
{
    if (s->lines.count == 0)
        return;
    const bat_stroke *line = &s->lines.strokes[0];
    double end[2];
    to_sheet(d, line->points + 3 * (line->count - 1), end);
    bat_canvas_label(canvas, s->colour, 0.8 * canvas->em, BAT_LEFT, end[0] + 0.5 * canvas->em,
                     end[1], s->object->name);
}

void bat_drawing_draw(bat_canvas *canvas, const bat_drawing *d)
{
    for (int i = 0; i < d->shape_count; i++)
        draw_comb(canvas, d, &d->shapes[i]);
    for (int i = 0; i < d->shape_count; i++)
        if (shows_polygon(d, d->shapes[i].object))
            draw_polygon(canvas, d, &d->shapes[i]);
    for (int i = 0; i < d->shape_count; i++)
        draw_lines(canvas, d, &d->shapes[i]);
    for (int i = 0; i < d->shape_count; i++)
        if (shows_points(d, d->shapes[i].object))
            draw_points(canvas, d, &d->shapes[i]);
    for (int i = 0; d->shape_count > COLOURED && i < d->shape_count; i++)
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
        polygon |= shows_polygon(d, s->object);
        if (shows_points(d, s->object) && s->object->kind == BATTEN_OBJECT_CURVE) {
            data = true;
            if (mark_of(d, s, em) == BAT_SAMPLE_CROSS)
                mark = BAT_SAMPLE_CROSS;
        }
        comb |= s->tooth_count > 0 && d->comb_scale > 0;
        if (d->shape_count <= COLOURED)
            add_name(d, s, em, legend);
    }
    char length[BATTEN_NUMBER_SIZE];
    bat_digits_text(d->comb_scale, 3, length);
    if (polygon)
        bat_legend_add(legend, BAT_SAMPLE_POLYGON, (bat_pen){bat_grey, 0.7, BAT_DASHED},
                       "control polygon");
    if (data)
        bat_legend_add(legend, mark, (bat_pen){bat_ink, 1, BAT_SOLID}, "data points");
    if (comb)
        bat_legend_add(legend, BAT_SAMPLE_LINE,
                       (bat_pen){lighter(palette[0], 0.35), 1, BAT_SOLID},
                       "curvature comb: 1/%s is %s %s long", unit_of(d), length, unit_of(d));
}

/* The plot takes what title, legend and numbers leave. */
static void place_plot(bat_canvas *canvas, bat_drawing *d, double legend)
{
    const double em = canvas->em, top = *d->options->title ? 3 * em : em;
    double left = em, bottom = legend + em;
    const bool grid = d->kind != BATTEN_VIEW_AXONOMETRIC;
    if (grid)
        bottom += 2.4 * em;
    for (int pass = 0; pass < 2; pass++) {
        /* The numbers depend a little on the scale, and the scale on the room they leave. */
        if (grid)
            left = (pass == 0 ? 4 * em : bat_plot_numbers_width(canvas, &d->plot)) + 2.4 * em;
        const bat_rectangle frame = {left, top, bat_max(canvas->width - left - em, em),
                                     bat_max(canvas->height - top - bottom, em)};
        d->plot = bat_plot_fit(frame, d->low, d->high);
    }
}

static batten_status draw_picture(bat_drawing *d, char **data, size_t *size)
{
    const batten_draw_options *o = d->options;
    bat_canvas canvas;
    const double em = bat_max(5, 0.0165 * bat_min_int(o->width, o->height));
    batten_status status =
        bat_canvas_begin(o->format, o->width, o->height, em, o->title, &canvas);
    if (status != BATTEN_OK)
        return status;

    bat_legend legend = {0};
    fill_legend(d, em, &legend);
    const double width = canvas.width - 4 * em;
    const double height = bat_legend_height(&canvas, &legend, width);
    place_plot(&canvas, d, height);
    legend.count = 0; /* again, for only now it is known how close the points stand */
    fill_legend(d, em, &legend);
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
        status = gather(d);
    if (status == BATTEN_OK)
        status = choose_view(d);
    if (status == BATTEN_OK)
        status = make_room(d);
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

batten_status batten_draw(const batten_model *model, const batten_draw_options *options,
                          char **data, size_t *size)
{
    batten_draw_options chosen = batten_draw_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    bat_drawing d = {.options = options};
    batten_model *flat = NULL;
    status = bat_canvas_check_size(options->width, options->height);
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
