/* The view, the scale of the combs and the range of a drawing, from every point that it draws. */
#include "base/plural.h"
#include "picture/drawings/drawing.h"
#include "picture/sheet/axes.h"
#include "picture/sheet/flat.h"

#include <string.h>

/* ---- every point that will be drawn, for those who must know them all ---- */

typedef void visit_point(void *user, const double point[3]);

/* Points that shape a curve are its control polygon, whoever asks for points or polygon. */
static bool has_vertices(const batten_object *object)
{
    return object->kind == BATTEN_OBJECT_CURVE && object->points_are_vertices &&
           object->point_count > 0;
}

bool bat_drawing_shows_polygon(const bat_drawing *d, const batten_object *object)
{
    const bool asked =
        d->options->control_polygon || (has_vertices(object) && d->options->data_points);
    return object->kind == BATTEN_OBJECT_CURVE && asked &&
           batten_curve_dimension(object->curve) > 1;
}

bool bat_drawing_shows_points(const bat_drawing *d, const batten_object *object)
{
    return object->point_count > 0 && !has_vertices(object) &&
           (object->kind == BATTEN_OBJECT_POINTS || d->options->data_points);
}

int bat_drawing_control_count(const batten_object *object)
{
    return has_vertices(object) ? object->point_count : batten_curve_point_count(object->curve);
}

void bat_drawing_control_point(const batten_object *object, int i, double point[3])
{
    const batten_curve *curve = object->curve;
    if (has_vertices(object)) {
        memcpy(point, object->points + 3 * (size_t)i, 3 * sizeof *point);
        return;
    }
    const int dimension = batten_curve_dimension(curve);
    for (int k = 0; k < 3; k++)
        point[k] = k < dimension ? batten_curve_points(curve)[i * dimension + k] : 0;
}

void bat_drawing_comb_tip(const batten_tooth *tooth, double scale, double tip[3])
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
    if (bat_drawing_shows_points(d, s->object))
        for (int i = 0; i < s->object->point_count; i++)
            visit(user, s->object->points + 3 * (size_t)i);
    if (bat_drawing_shows_polygon(d, s->object))
        for (int i = 0; i < bat_drawing_control_count(s->object); i++) {
            bat_drawing_control_point(s->object, i, point);
            visit(user, point);
        }
    for (int i = 0; d->comb_scale > 0 && i < s->tooth_count; i++) {
        bat_drawing_comb_tip(&s->teeth[i], d->comb_scale, point);
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
    /* Flat to the rounding of files, or of coordinates far from the origin. */
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

batten_status bat_drawing_choose_view(bat_drawing *d)
{
    extent e = nothing;
    visit_all(d, extend, &e);
    if (!(e.low[0] <= e.high[0]))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "of %d object%s none has anything that could be drawn", d->shape_count,
                        bat_plural(d->shape_count));
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

batten_status bat_drawing_make_room(bat_drawing *d)
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
            (size_t)bat_drawing_control_count(s->object) > longest)
            longest = (size_t)bat_drawing_control_count(s->object);
    }
    d->xy = bat_array3(longest, 2, sizeof *d->xy);
    return d->xy ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

void bat_drawing_to_sheet(const bat_drawing *d, const double point[3], double xy[2])
{
    double projected[3];
    bat_view_project(&d->view, point, projected);
    xy[0] = bat_plot_x(&d->plot, projected[0]);
    xy[1] = bat_plot_y(&d->plot, projected[1]);
}
