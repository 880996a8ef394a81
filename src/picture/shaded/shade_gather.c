/* What a shaded picture shows: surfaces as tiles, bodies and meshes as triangles, curves as strokes. */
#include "picture/shaded/shade.h"

#include <string.h>

/* About this many grid points in all surfaces together. */
static const double point_limit = 1500000;

/* Both halves of a hull are one hull: surfaces without a colour of their own look alike. */
static const bat_colour soft = {0.60, 0.73, 0.85};

static bool is_surface(const batten_object *object)
{
    return object->kind == BATTEN_OBJECT_SURFACE &&
           batten_surface_dimension(object->surface) == 3;
}

/* Count the surfaces and meshes, and find their box. */
void bat_shaded_count(bat_shaded *p, batten_box *box)
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

/* The line at a fixed parameter, unless it is a pole. */
static batten_status add_line(const batten_surface *surface, batten_direction direction,
                              double at, double pixel, bat_strokes *lines)
{
    /* A thirtieth of a pixel turns by less than the eye sees; a thousandth is a point. */
    bat_stroke stroke = {0, NULL};
    const batten_status status =
        bat_stroke_isoline_within(surface, direction, at, pixel / 30, &stroke);
    if (status != BATTEN_OK)
        return status;
    if (!bat_stroke_is_point(&stroke, pixel / 1000))
        return bat_strokes_add(lines, stroke);
    bat_stroke_free(&stroke);
    return BATTEN_OK;
}

/* The edges at both ends of a direction that is not closed, and the isolines between them; of one
 * that is closed the seam is an isoline. */
static batten_status add_lines(const bat_shaded *p, const batten_surface *surface,
                               batten_direction direction, unsigned char smooth, double size,
                               bat_shaded_solid *solid)
{
    static const unsigned char sides[2][2] = {{BAT_SIDE_U0, BAT_SIDE_U1},
                                              {BAT_SIDE_V0, BAT_SIDE_V1}};
    const batten_draw_options *o = p->options;
    const double pixel = size / bat_max_int(o->width, o->height);
    const batten_interval domain = batten_surface_domain(surface, direction);
    /* Closed to the rounding of files. */
    const bool closed = batten_surface_is_closed(surface, direction, 1e-9 * size);
    const bool inside = o->shading == BATTEN_SHADING_ISOLINES;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && !closed && status == BATTEN_OK; k++)
        if (!(smooth & sides[direction == BATTEN_V][k]))
            status =
                add_line(surface, direction, k ? domain.b : domain.a, pixel, &solid->edges);
    for (int k = closed ? 0 : 1; inside && k < o->isolines && status == BATTEN_OK; k++)
        status =
            add_line(surface, direction, domain.a + (domain.b - domain.a) * k / o->isolines,
                     pixel, &solid->isolines);
    return status;
}

static batten_status make_solid(bat_shaded *p, int object, double size, bat_shaded_solid *out)
{
    const batten_draw_options *o = p->options;
    /* A fifth of a pixel, if the shape filled the picture. Colours of curvature and mirror
     * images change faster than the shape, so that they need more. */
    const bat_curvature curvature = bat_curvature_of_shading(o->shading);
    const bool finer = curvature != BAT_CURVATURE_NONE || bat_has_stripes(o->shading);
    const double tolerance = (finer ? 0.02 : 0.2) * size / bat_max_int(o->width, o->height);
    const int least = finer ? 16 : 4;
    const batten_object *shown = batten_model_object(p->model, object);
    out->scene = &p->scene;
    out->albedo = bat_light_of(colour_of(shown, soft));
    batten_status status =
        bat_tiles_make(shown->surface, tolerance, least, (size_t)(point_limit / p->solid_count),
                       curvature, p->job, &out->tiles);
    for (int d = 0; d < 2 && status == BATTEN_OK; d++)
        status =
            add_lines(p, shown->surface, d ? BATTEN_V : BATTEN_U, p->smooth[object], size, out);
    return status;
}

static batten_status gather_solids(bat_shaded *p, double size)
{
    const int wanted = p->solid_count;
    p->solids = bat_array((size_t)wanted, sizeof *p->solids);
    if (!p->solids)
        return BATTEN_OUT_OF_MEMORY;
    int count = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(p->model) && status == BATTEN_OK; i++) {
        if (is_surface(batten_model_object(p->model, i)))
            status = make_solid(p, i, size, &p->solids[count++]);
    }
    return status;
}

static batten_status gather_meshes(bat_shaded *p)
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
static double dot_of(const bat_shaded *p, int count)
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
static batten_status gather_curves(bat_shaded *p)
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
        p->styles[p->curves.count] = (bat_shaded_style){
            bat_light_of(colour_of(object, dark)), is_row ? dot_of(p, object->point_count) : 0};
        bat_stroke stroke = {0, NULL};
        status =
            is_row ? copy_points(object, &stroke) : bat_stroke_curve(object->curve, &stroke);
        if (status == BATTEN_OK)
            status = bat_strokes_add(&p->curves, stroke);
    }
    return status;
}

batten_status bat_shaded_gather(bat_shaded *p, double size)
{
    batten_status status = gather_solids(p, size);
    if (status == BATTEN_OK)
        status = gather_meshes(p);
    if (status == BATTEN_OK)
        status = gather_curves(p);
    return status;
}
