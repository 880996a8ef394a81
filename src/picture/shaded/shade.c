/* The shaded picture of surfaces, bodies and meshes. */
#include "numeric/box.h"
#include "picture/lines/stroke.h"
#include "picture/shaded/light.h"
#include "picture/shaded/mesh_solid.h"
#include "picture/shaded/raster.h"
#include "picture/shaded/smooth_edges.h"
#include "picture/shaded/tiles.h"
#include "picture/sheet/flat.h"
#include "picture/sheet/sheet.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* About so many grid points in all surfaces together. */
static const double point_limit = 1500000;

/* What each sample of a surface carries. */
enum { NORMAL = 0, LINE_U = 3, LINE_V = 4, CURVATURE = 5 };

/* One surface, ready to be filled in. */
typedef struct {
    bat_tiles tiles; /* after fit_picture its points are in samples, depth towards the eye */
    const bat_scene *scene;
    bat_light albedo;
    double lines;         /* isolines in each direction */
    bool edges[2];        /* does the domain end in u, in v, at edges? */
    unsigned char smooth; /* sides that go over into others and are not drawn */
    bool shows_isolines;
} solid;

/* How a stroke is drawn. */
typedef struct {
    bat_light light;
    double dot; /* radius of the marks of its points, samples; 0: it is a line */
} style;

typedef struct {
    const batten_model *model;
    unsigned char *smooth; /* [count of the model], see smooth_edges.h */
    const batten_draw_options *options;
    const batten_job *job;
    bat_view view;
    bat_scene scene;
    int solid_count, mesh_count;
    solid *solids;
    bat_mesh_solid *meshes;
    bat_strokes curves; /* and rows of points; after fit_picture in samples too */
    style *styles;
    double least, greatest; /* raw curvatures */
    double em;
} picture;

/* Both halves of a hull are one hull: surfaces without a colour of their own look alike. */
static const bat_colour soft = {0.60, 0.73, 0.85};

/* ---- gathering ---- */

static bool is_surface(const batten_object *object)
{
    return object->kind == BATTEN_OBJECT_SURFACE &&
           batten_surface_dimension(object->surface) == 3;
}

static int longest_axis(const batten_box *box)
{
    const double range[] = {box->high.x - box->low.x, box->high.y - box->low.y,
                            box->high.z - box->low.z};
    const int longer = range[1] > range[0] ? 1 : 0;
    return range[2] > range[longer] ? 2 : longer;
}

static double diagonal(const batten_box *box)
{
    return hypot(hypot(box->high.x - box->low.x, box->high.y - box->low.y),
                 box->high.z - box->low.z);
}

/* Count the surfaces and meshes, and find their box. */
static void count_shapes(picture *p, batten_box *box)
{
    for (int i = 0; i < batten_model_count(p->model); i++) {
        const batten_object *object = batten_model_object(p->model, i);
        const bool is_mesh = object->kind == BATTEN_OBJECT_MESH;
        if (!is_mesh && !is_surface(object))
            continue;
        const batten_box b =
            is_mesh ? batten_mesh_box(object->mesh) : batten_surface_box(object->surface);
        bat_box_join(box, b);
        p->solid_count += !is_mesh;
        p->mesh_count += is_mesh;
    }
}

static bat_colour colour_of(const batten_object *object, bat_colour otherwise)
{
    if (!object->has_colour)
        return otherwise;
    return (bat_colour){object->colour[0], object->colour[1], object->colour[2]};
}

static bat_curvature curvature_of(batten_shading shading)
{
    return shading == BATTEN_SHADING_GAUSSIAN ? BAT_CURVATURE_GAUSSIAN
           : shading == BATTEN_SHADING_MEAN   ? BAT_CURVATURE_MEAN
                                              : BAT_CURVATURE_NONE;
}

static bool has_stripes(batten_shading shading)
{
    return shading == BATTEN_SHADING_ZEBRA || shading == BATTEN_SHADING_ISOPHOTES;
}

static batten_status make_solid(picture *p, const batten_object *object, double size,
                                solid *out)
{
    const batten_draw_options *o = p->options;
    /* A fifth of a pixel, if the shape filled the picture. Colours of curvature and mirror
     * images change faster than the shape, so that they need more. */
    const bat_curvature curvature = curvature_of(o->shading);
    const bool finer = curvature != BAT_CURVATURE_NONE || has_stripes(o->shading);
    const double tolerance = (finer ? 0.02 : 0.2) * size / bat_max_int(o->width, o->height);
    const int least = finer ? 16 : 4;
    const batten_surface *s = object->surface;
    solid made = {.scene = &p->scene, .lines = o->isolines};
    const batten_status status =
        bat_tiles_make(s, tolerance, least, (size_t)(point_limit / p->solid_count), curvature,
                       p->job, &made.tiles);
    if (status != BATTEN_OK)
        return status;
    made.edges[0] = !batten_surface_is_closed(s, BATTEN_U, 1e-9 * size);
    made.edges[1] = !batten_surface_is_closed(s, BATTEN_V, 1e-9 * size);
    made.shows_isolines = o->shading == BATTEN_SHADING_ISOLINES;
    *out = made;
    return BATTEN_OK;
}

static batten_status gather_solids(picture *p, double size)
{
    const int wanted = p->solid_count;
    p->solids = bat_array((size_t)wanted, sizeof *p->solids);
    if (!p->solids)
        return BATTEN_OUT_OF_MEMORY;
    int count = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(p->model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(p->model, i);
        if (!is_surface(object))
            continue;
        status = make_solid(p, object, size, &p->solids[count]);
        p->solids[count].smooth = p->smooth[i];
        p->solids[count++].albedo = bat_light_of(colour_of(object, soft));
    }
    return status;
}

static batten_status gather_meshes(picture *p)
{
    const bool all_edges = p->options->shading == BATTEN_SHADING_ISOLINES;
    const int wanted = p->mesh_count;
    p->mesh_count = 0;
    p->meshes = bat_array((size_t)wanted, sizeof *p->meshes);
    batten_status status = p->meshes ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < batten_model_count(p->model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(p->model, i);
        if (object->kind != BATTEN_OBJECT_MESH)
            continue;
        status = bat_mesh_solid_make(object->mesh, all_edges, &p->scene,
                                     bat_light_of(colour_of(object, soft)),
                                     &p->meshes[p->mesh_count]);
        p->mesh_count += status == BATTEN_OK;
    }
    return status;
}

/* Marks are smaller where there are many, so that they do not hide the shape. */
static double dot_of(const picture *p, int count)
{
    const double radius = 0.16 * p->em * sqrt(bat_min(1, 400.0 / count));
    return BAT_SAMPLES * bat_max(radius, 0.8);
}

static batten_status copy_points(const batten_object *object, bat_stroke *out)
{
    double *points = bat_array3((size_t)object->point_count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(points, object->points, 3 * (size_t)object->point_count * sizeof *points);
    *out = (bat_stroke){(size_t)object->point_count, points};
    return BATTEN_OK;
}

/* Curves, and points. */
static batten_status gather_curves(picture *p)
{
    const bat_colour dark = {0.12, 0.16, 0.24};
    const int count = batten_model_count(p->model);
    p->styles = bat_array((size_t)count, sizeof *p->styles);
    batten_status status = p->styles ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(p->model, i);
        const bool is_row = object->kind == BATTEN_OBJECT_POINTS;
        if (object->kind != BATTEN_OBJECT_CURVE && !is_row)
            continue;
        p->styles[p->curves.count] = (style){bat_light_of(colour_of(object, dark)),
                                             is_row ? dot_of(p, object->point_count) : 0};
        bat_stroke stroke = {0, NULL};
        status =
            is_row ? copy_points(object, &stroke) : bat_stroke_curve(object->curve, &stroke);
        if (status == BATTEN_OK)
            status = bat_strokes_add(&p->curves, stroke);
    }
    return status;
}

/* ---- range of the colours ---- */

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Samples of |K| over all surfaces, evenly thinned to at most `room`; notes the extremes. */
static size_t sample_curvatures(picture *p, size_t room, double *samples)
{
    size_t total = 0, kept = 0;
    for (int i = 0; i < p->solid_count; i++)
        total += p->solids[i].tiles.count_u * p->solids[i].tiles.count_v;
    const size_t every = total / room + 1;
    p->least = HUGE_VAL;
    p->greatest = -HUGE_VAL;
    for (int i = 0; i < p->solid_count; i++) {
        const bat_tiles *t = &p->solids[i].tiles;
        for (size_t k = 0; k < t->count_u * t->count_v; k++) {
            if (isnan(t->curvature[k]))
                continue;
            p->least = bat_min(p->least, t->curvature[k]);
            p->greatest = bat_max(p->greatest, t->curvature[k]);
            if (k % every == 0)
                samples[kept++] = fabs(t->curvature[k]);
        }
    }
    return kept;
}

/* The colours end where 95 of 100 samples lie inside: a few sharp places must not bleach all
 * others. */
static batten_status choose_range(picture *p, double size)
{
    enum { ROOM = 60000 };
    double *samples = bat_array(ROOM + (size_t)p->solid_count, sizeof *samples);
    if (!samples)
        return BATTEN_OUT_OF_MEMORY;
    const size_t count = sample_curvatures(p, ROOM, samples);
    qsort(samples, count, sizeof *samples, ascending);
    /* What is developable but for roundings stays white. */
    double range =
        p->options->shading == BATTEN_SHADING_MEAN ? 1e-6 / size : 1e-6 / (size * size);
    if (count > 0)
        range = bat_max(range, samples[(size_t)(0.95 * (double)(count - 1))]);
    bat_release(samples);
    const double power = pow(10, floor(log10(range)) - 1);
    p->scene.range = ceil(range / power) * power; /* two digits */
    return isfinite(p->scene.range)
               ? BATTEN_OK
               : bat_fail(BATTEN_OVERFLOW, "curvatures up to %g are too large to show", range);
}

/* ---- from space to samples ---- */

typedef struct {
    const bat_view *view;
    double low[2], high[2];
} projection;

static void project_points(void *user, size_t count, double *points)
{
    projection *to = user;
    for (size_t i = 0; i < count; i++) {
        double q[3];
        bat_view_project(to->view, points + 3 * i, q);
        memcpy(points + 3 * i, q, sizeof q);
        for (int k = 0; k < 2; k++) {
            to->low[k] = bat_min(to->low[k], q[k]);
            to->high[k] = bat_max(to->high[k], q[k]);
        }
    }
}

static void move_points(void *user, size_t count, double *points)
{
    const bat_plot *plot = user;
    for (size_t i = 0; i < count; i++) {
        double *p = points + 3 * i;
        p[0] = BAT_SAMPLES * bat_plot_x(plot, p[0]);
        p[1] = BAT_SAMPLES * bat_plot_y(plot, p[1]);
        p[2] = BAT_SAMPLES * plot->scale * p[2];
    }
}

/* The part of the picture that title and legend leave to the shape. */
static bat_rectangle stage(const picture *p)
{
    const batten_draw_options *o = p->options;
    const double em = p->em, top = *o->title ? 4 * em : 2 * em;
    const double right = curvature_of(o->shading) != BAT_CURVATURE_NONE ? 9 * em : 2 * em;
    const double bottom = has_stripes(o->shading) ? 3.5 * em : 2 * em;
    return (bat_rectangle){2 * em, top, bat_max(o->width - 2 * em - right, 8),
                           bat_max(o->height - top - bottom, 8)};
}

typedef void change_points(void *user, size_t count, double *points);

static void change_strokes(const bat_strokes *strokes, change_points *change, void *user)
{
    for (size_t i = 0; i < strokes->count; i++)
        change(user, strokes->strokes[i].count, strokes->strokes[i].points);
}

static void change_all(const picture *p, change_points *change, void *user)
{
    for (int i = 0; i < p->solid_count; i++) {
        const bat_tiles *t = &p->solids[i].tiles;
        change(user, t->count_u * t->count_v, t->points);
    }
    for (int i = 0; i < p->mesh_count; i++) {
        change(user, (size_t)p->meshes[i].mesh->vertex_count, p->meshes[i].points);
        change_strokes(&p->meshes[i].lines, change, user);
    }
    change_strokes(&p->curves, change, user);
}

static batten_status fit_picture(picture *p)
{
    projection seen = {&p->view, {HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
    change_all(p, project_points, &seen);
    bat_plot plot = bat_plot_fit(stage(p), seen.low, seen.high);
    if (!isfinite(plot.x0) || !isfinite(plot.y0) || !(plot.scale > 0))
        return bat_fail(BATTEN_OVERFLOW, "coordinates from %g to %g are too large to draw",
                        seen.low[0], seen.high[0]);
    change_all(p, move_points, &plot);
    return BATTEN_OK;
}

/* ---- colours of samples ---- */

static void put(bat_light light, float colour[3])
{
    colour[0] = (float)light.red;
    colour[1] = (float)light.green;
    colour[2] = (float)light.blue;
}

/* Is this sample on an isoline? Lines are half a pixel to both sides. Edges are drawn as
 * strokes, for on the surface they would thin out where it turns edge on. */
static bool is_on_line(const solid *s, const bat_fragment *f, int direction)
{
    const int n = LINE_U + direction;
    const double place = f->value[n], line = round(place);
    const bool is_edge = s->edges[direction] && (line <= 0 || line >= s->lines);
    return s->shows_isolines && !is_edge &&
           fabs(place - line) < 0.5 * BAT_SAMPLES * f->slope[n];
}

static void shade_solid(const void *user, const bat_fragment *f, float colour[3])
{
    const solid *s = user;
    double n[3] = {f->value[NORMAL], f->value[NORMAL + 1], f->value[NORMAL + 2]};
    const double length = sqrt(bat_dot(3, n, n));
    /* Where no corner has a normal, the surface is taken to face the eye. */
    for (int k = 0; k < 3; k++)
        n[k] = length > 0 ? n[k] / length : s->scene->eye[k];

    const bat_light light = bat_light_of_sample(s->scene, s->albedo, f->value[CURVATURE], n);
    const double ink = is_on_line(s, f, 0) || is_on_line(s, f, 1) ? 0.12 : 1;
    put((bat_light){ink * light.red, ink * light.green, ink * light.blue}, colour);
}

static void shade_flat(const void *user, const bat_fragment *f, float colour[3])
{
    (void)f;
    put(*(const bat_light *)user, colour);
}

/* ---- filling ---- */

static bat_corner corner(const solid *s, size_t i, size_t j)
{
    const bat_tiles *t = &s->tiles;
    const size_t at = i * t->count_v + j;
    const double *p = t->points + 3 * at, *n = t->normals + 3 * at;
    const double u = (t->u[i] - t->u[0]) / (t->u[t->count_u - 1] - t->u[0]);
    const double v = (t->v[j] - t->v[0]) / (t->v[t->count_v - 1] - t->v[0]);
    return (bat_corner){
        p[0],
        p[1],
        p[2],
        {n[0], n[1], n[2], s->lines * u, s->lines * v, t->curvature ? t->curvature[at] : 0}};
}

/* Does the cell reach into the band? Most do not, and making corners costs more than asking. */
static bool touches(const bat_raster *band, const solid *s, size_t i, size_t j)
{
    const size_t n = s->tiles.count_v, at = i * n + j;
    const double *y = s->tiles.points + 1;
    const double a = y[3 * at], b = y[3 * (at + 1)], c = y[3 * (at + n)],
                 d = y[3 * (at + n + 1)];
    return bat_max(bat_max(a, b), bat_max(c, d)) >= band->first_row &&
           bat_min(bat_min(a, b), bat_min(c, d)) <= band->first_row + band->rows;
}

static void fill_solid(bat_raster *band, const solid *s)
{
    for (size_t i = 0; i + 1 < s->tiles.count_u; i++)
        for (size_t j = 0; j + 1 < s->tiles.count_v; j++) {
            if (!touches(band, s, i, j))
                continue;
            const bat_corner a = corner(s, i, j), b = corner(s, i + 1, j);
            const bat_corner c = corner(s, i + 1, j + 1), d = corner(s, i, j + 1);
            bat_raster_triangle(band, &a, &b, &c, shade_solid, s);
            bat_raster_triangle(band, &a, &c, &d, shade_solid, s);
        }
}

/* A segment as two triangles, `half` samples to both sides and beyond its ends, a little nearer
 * to the eye than the surface that it lies on. */
static void fill_segment(bat_raster *band, const double *from, const double *to, double half,
                         double nearer, const bat_light *light)
{
    double x = to[0] - from[0], y = to[1] - from[1];
    const double length = hypot(x, y);
    x = length > 0 ? half * x / length : half;
    y = length > 0 ? half * y / length : 0;
    bat_corner c[4] = {{.x = from[0] - x - y, .y = from[1] - y + x, .depth = from[2] + nearer},
                       {.x = from[0] - x + y, .y = from[1] - y - x, .depth = from[2] + nearer},
                       {.x = to[0] + x + y, .y = to[1] + y - x, .depth = to[2] + nearer},
                       {.x = to[0] + x - y, .y = to[1] + y + x, .depth = to[2] + nearer}};
    bat_raster_triangle(band, &c[0], &c[1], &c[2], shade_flat, light);
    bat_raster_triangle(band, &c[0], &c[2], &c[3], shade_flat, light);
}

/* An edge of the grid: `count` points from `first` on, `step` apart. */
static void fill_edge(bat_raster *band, const solid *s, size_t first, size_t step, size_t count)
{
    const bat_light a = s->albedo, ink = {0.05 * a.red, 0.05 * a.green, 0.05 * a.blue};
    const double half = 0.7 * BAT_SAMPLES, nearer = 2 * BAT_SAMPLES;
    for (size_t k = 0; k + 1 < count; k++) {
        const double *from = s->tiles.points + 3 * (first + k * step), *to = from + 3 * step;
        fill_segment(band, from, to, half, nearer, &ink);
    }
}

static void fill_edges(bat_raster *band, const solid *s)
{
    const size_t m = s->tiles.count_u, n = s->tiles.count_v;
    if (s->edges[0] && !(s->smooth & BAT_SIDE_U0))
        fill_edge(band, s, 0, 1, n);
    if (s->edges[0] && !(s->smooth & BAT_SIDE_U1))
        fill_edge(band, s, (m - 1) * n, 1, n);
    if (s->edges[1] && !(s->smooth & BAT_SIDE_V0))
        fill_edge(band, s, 0, n, m);
    if (s->edges[1] && !(s->smooth & BAT_SIDE_V1))
        fill_edge(band, s, n - 1, n, m);
}

static void fill_mesh_lines(bat_raster *band, const bat_mesh_solid *m)
{
    const bat_light a = m->albedo, ink = {0.05 * a.red, 0.05 * a.green, 0.05 * a.blue};
    const double half = 0.7 * BAT_SAMPLES, nearer = 2 * BAT_SAMPLES;
    for (size_t i = 0; i < m->lines.count; i++) {
        const bat_stroke *s = &m->lines.strokes[i];
        for (size_t k = 0; k + 1 < s->count; k++)
            fill_segment(band, s->points + 3 * k, s->points + 3 * (k + 1), half, nearer, &ink);
    }
}

/* A disc that faces the eye, before the surface by its radius: a point on it, or near it, is
 * seen whole. */
static void fill_dot(bat_raster *band, const double *at, const style *i)
{
    enum { CORNERS = 10 };
    if (at[1] + i->dot < band->first_row || at[1] - i->dot > band->first_row + band->rows)
        return;
    bat_corner c[3] = {{.x = at[0], .y = at[1], .depth = at[2] + i->dot}};
    c[1] = c[2] = c[0];
    c[2].x += i->dot;
    for (int k = 1; k <= CORNERS; k++) {
        const double angle = 2 * BAT_PI * k / CORNERS;
        c[1] = c[2];
        c[2].x = at[0] + i->dot * cos(angle);
        c[2].y = at[1] + i->dot * sin(angle);
        bat_raster_triangle(band, &c[0], &c[1], &c[2], shade_flat, &i->light);
    }
}

static void fill_curves(bat_raster *band, const picture *p)
{
    const double half = 0.9 * BAT_SAMPLES, nearer = 3 * BAT_SAMPLES;
    for (size_t i = 0; i < p->curves.count; i++) {
        const bat_stroke *s = &p->curves.strokes[i];
        const style *how = &p->styles[i];
        for (size_t k = 0; how->dot > 0 && k < s->count; k++)
            fill_dot(band, s->points + 3 * k, how);
        for (size_t k = 0; !(how->dot > 0) && k + 1 < s->count; k++)
            fill_segment(band, s->points + 3 * k, s->points + 3 * (k + 1), half, nearer,
                         &how->light);
    }
}

static batten_status ask(const picture *p, double fraction)
{
    if (!p->job)
        return BATTEN_OK;
    if (p->job->progress)
        p->job->progress(p->job->user, fraction, "shading");
    if (p->job->is_cancelled && p->job->is_cancelled(p->job->user))
        return bat_fail(BATTEN_CANCELLED, "cancelled after %.0f %% of the picture",
                        100 * fraction);
    return BATTEN_OK;
}

static batten_status fill_image(const picture *p, bat_canvas *canvas)
{
    enum { BAND = 32 };
    const int width = p->options->width, height = p->options->height;
    cairo_surface_t *image = canvas->surface;
    cairo_surface_flush(image);
    /* cairo aligns its rows so that they may be read as words. */
    uint32_t *pixels = (uint32_t *)(void *)cairo_image_surface_get_data(image);
    const size_t stride = (size_t)cairo_image_surface_get_stride(image) / sizeof *pixels;
    if (!pixels)
        return bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for a picture of %d x %d", width,
                        height);

    static const float top[3] = {1, 1, 1}, bottom[3] = {0.80f, 0.84f, 0.88f};
    bat_raster band;
    batten_status status = bat_raster_make(width * BAT_SAMPLES, BAND * BAT_SAMPLES, &band);
    if (status != BATTEN_OK)
        return status;
    for (int y = 0; y < height && status == BATTEN_OK; y += BAND) {
        band.rows = BAT_SAMPLES * bat_min_int(BAND, height - y);
        bat_raster_begin(&band, y * BAT_SAMPLES, height * BAT_SAMPLES, top, bottom);
        for (int i = 0; i < p->solid_count; i++)
            fill_solid(&band, &p->solids[i]);
        for (int i = 0; i < p->mesh_count; i++)
            bat_mesh_solid_fill(&band, &p->meshes[i]);
        for (int i = 0; i < p->solid_count; i++)
            fill_edges(&band, &p->solids[i]);
        for (int i = 0; i < p->mesh_count; i++)
            fill_mesh_lines(&band, &p->meshes[i]);
        fill_curves(&band, p);
        bat_raster_resolve(&band, pixels + (size_t)y * stride, stride);
        status = ask(p, (double)y / height);
    }
    bat_raster_free(&band);
    cairo_surface_mark_dirty(image);
    return status;
}

/* ---- title and legend ---- */

static void write_colours(bat_canvas *canvas, const picture *p)
{
    enum { STEPS = 128 };
    const double em = p->em, height = 0.5 * canvas->height, wide = 1.2 * em;
    const double x = canvas->width - 7.5 * em, y = 0.5 * (canvas->height - height);
    for (int i = 0; i < STEPS; i++)
        bat_canvas_box(canvas, bat_colour_diverging(1 - 2 * (i + 0.5) / STEPS),
                       (bat_rectangle){x, y + height * i / STEPS, wide, height / STEPS + 1});
    bat_canvas_frame(canvas, (bat_pen){bat_grey, 0.8, BAT_SOLID},
                     (bat_rectangle){x, y, wide, height});
    for (int i = -2; i <= 2; i++) {
        char text[BATTEN_NUMBER_SIZE];
        bat_digits_text(0.5 * i * p->scene.range, 3, text);
        bat_canvas_text(canvas, bat_ink, 0.85 * em, BAT_LEFT, x + wide + 0.5 * em,
                        y + 0.25 * (2 - i) * height, text);
    }
    const char *unit = batten_unit_name(batten_model_unit_metres(p->model));
    char text[64], number[BATTEN_NUMBER_SIZE];
    const bool mean = p->options->shading == BATTEN_SHADING_MEAN;
    snprintf(text, sizeof text, mean ? "H in 1/%s" : "K in 1/%s\u00b2", unit ? unit : "unit");
    bat_canvas_bold(canvas, bat_ink, 0.85 * em, BAT_LEFT, x, y - 3.2 * em, text);
    bat_digits_text(p->greatest, 3, number);
    snprintf(text, sizeof text, "max %s", number);
    bat_canvas_text(canvas, bat_grey, 0.8 * em, BAT_LEFT, x, y - 1.6 * em, text);
    bat_digits_text(p->least, 3, number);
    snprintf(text, sizeof text, "min %s", number);
    bat_canvas_text(canvas, bat_grey, 0.8 * em, BAT_LEFT, x, y + height + 1.6 * em, text);
}

static void write_around(bat_canvas *canvas, const picture *p)
{
    const double em = p->em, middle = 0.5 * canvas->width;
    bat_canvas_bold(canvas, bat_ink, 1.25 * em, BAT_MIDDLE, middle, 2 * em, p->options->title);
    if (curvature_of(p->options->shading) != BAT_CURVATURE_NONE && p->least <= p->greatest)
        write_colours(canvas, p);
    if (has_stripes(p->options->shading)) {
        char text[BATTEN_NUMBER_SIZE + 80], number[BATTEN_NUMBER_SIZE];
        bat_digits_text(p->options->stripes, 4, number);
        const bool zebra = p->options->shading == BATTEN_SHADING_ZEBRA;
        snprintf(text, sizeof text, "%s: %s stripes over the half turn",
                 zebra ? "zebra" : "isophotes", number);
        bat_canvas_text(canvas, bat_grey, 0.85 * em, BAT_MIDDLE, middle,
                        canvas->height - 1.5 * em, text);
    }
}

static batten_status make_picture(picture *p, char **data, size_t *size)
{
    const batten_draw_options *o = p->options;
    bat_canvas canvas;
    batten_status status =
        bat_canvas_begin(BATTEN_PICTURE_PNG, o->width, o->height, p->em, o->title, &canvas);
    if (status != BATTEN_OK)
        return status;
    status = fill_image(p, &canvas);
    if (status == BATTEN_OK) {
        write_around(&canvas, p);
        return bat_canvas_finish(&canvas, data, size);
    }
    bat_canvas_end(&canvas);
    return status;
}

/* ---- the whole ---- */

static batten_status check_options(const batten_draw_options *o)
{
    if (o->format != BATTEN_PICTURE_PNG)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "shaded pictures are PNG; SVG and PDF show lines only");
    if (o->isolines < 1 || o->isolines > 1000)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d isolines are asked for; from 1 to 1000 are drawn", o->isolines);
    if (!(o->stripes > 0 && o->stripes <= 1000))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%g zebra stripes are asked for; up to 1000 are drawn", o->stripes);
    if (!isfinite(o->azimuth) || !isfinite(o->elevation))
        return bat_fail(BATTEN_NOT_FINITE, "azimuth %g and elevation %g must be finite",
                        o->azimuth, o->elevation);
    return bat_canvas_check_size(o->width, o->height);
}

static batten_status prepare(picture *p)
{
    batten_box box = bat_box_of_nothing();
    const batten_draw_options *o = p->options;
    count_shapes(p, &box);
    const double size = diagonal(&box);
    if (p->solid_count + p->mesh_count == 0)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "none of the %d objects of the model is a surface in space, a body or a "
            "mesh: there is nothing to shade",
            batten_model_count(p->model));
    if (!isfinite(size))
        return bat_fail(BATTEN_OVERFLOW, "coordinates up to %g are too large to draw",
                        box.high.x);
    p->em = bat_max(5, 0.0165 * bat_min_int(o->width, o->height));
    p->view = bat_view_make(o->view, o->azimuth, o->elevation);
    p->scene = bat_scene_make(o->shading, &p->view, longest_axis(&box), o->stripes);

    batten_status status = gather_solids(p, size);
    if (status == BATTEN_OK)
        status = gather_meshes(p);
    if (status == BATTEN_OK)
        status = gather_curves(p);
    if (status == BATTEN_OK && curvature_of(o->shading) != BAT_CURVATURE_NONE)
        status = choose_range(p, size);
    return status == BATTEN_OK ? fit_picture(p) : status;
}

batten_status batten_draw_shaded(const batten_model *model, const batten_draw_options *options,
                                 const batten_job *job, char **data, size_t *size)
{
    batten_draw_options chosen = batten_draw_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    picture p = {.options = options, .job = job};
    batten_model *flat = NULL, *patches = NULL;
    status = check_options(options);
    if (status == BATTEN_OK)
        status = bat_picture_model(model, options, job, &flat);
    if (status == BATTEN_OK)
        status = batten_model_with_patches(flat, BATTEN_PATCHES_POLE, &patches);
    p.model = patches;
    if (status == BATTEN_OK)
        status = bat_smooth_edges(flat, patches, &p.smooth);
    if (status == BATTEN_OK)
        status = prepare(&p);
    if (status == BATTEN_OK)
        status = make_picture(&p, data, size);
    for (int i = 0; p.solids && i < p.solid_count; i++)
        bat_tiles_free(&p.solids[i].tiles);
    for (int i = 0; p.meshes && i < p.mesh_count; i++)
        bat_mesh_solid_free(&p.meshes[i]);
    bat_release(p.solids);
    bat_release(p.meshes);
    bat_release(p.smooth);
    bat_strokes_free(&p.curves);
    bat_release(p.styles);
    batten_model_unref(patches);
    batten_model_unref(flat);
    return status;
}
