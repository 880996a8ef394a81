/* Reads single entities as curves, points and faces. */
#include "exchange/dxf/entities.h"
#include "base/plural.h"
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/round.h"
#include "exchange/dxf/round_curve.h"
#include "exchange/dxf/splines.h"
#include "exchange/shapes/path.h"
#include "numeric/vector.h"

#include <batten/standard.h>

static const batten_vec3 zero = {0, 0, 0};

batten_status bat_dxf_plane(const bat_dxf_pairs *pairs, batten_frame *frame)
{
    batten_vec3 z;
    batten_status status = bat_dxf_get_point(pairs, 210, (batten_vec3){0, 0, 1}, &z);
    const double length = bat_vec3_norm(z);
    if (status == BATTEN_OK && !(length > 0 && isfinite(length)))
        status = bat_fail(BATTEN_BAD_FORMAT, "the normal of its plane is 0");
    if (status != BATTEN_OK)
        return status;
    *frame = bat_dxf_axes(bat_vec3_scale(z, 1 / length));
    return BATTEN_OK;
}

static batten_status read_vector(const bat_dxf_pairs *pairs, int code, double out[3])
{
    batten_vec3 p = zero;
    const batten_status status = bat_dxf_get_point(pairs, code, zero, &p);
    out[0] = p.x;
    out[1] = p.y;
    out[2] = p.z;
    return status;
}

static batten_status read_normal(const bat_dxf_pairs *pairs, double out[3])
{
    batten_frame frame = batten_frame_world();
    const batten_status status = bat_dxf_plane(pairs, &frame);
    out[0] = frame.z.x;
    out[1] = frame.z.y;
    out[2] = frame.z.z;
    return status;
}

static batten_status read_line(const bat_dxf_pairs *pairs, batten_curve **out)
{
    batten_vec3 a, b;
    batten_status status = bat_dxf_get_point(pairs, 10, zero, &a);
    if (status == BATTEN_OK)
        status = bat_dxf_get_point(pairs, 11, zero, &b);
    if (status != BATTEN_OK)
        return status;
    return batten_curve_line(3, (double[]){a.x, a.y, a.z}, (double[]){b.x, b.y, b.z}, out);
}

/* Angles in degrees; an arc goes counter-clockwise from the first to the second. */
static batten_status read_arc(const bat_dxf_pairs *pairs, bool is_full, batten_curve **out)
{
    bat_dxf_round circle = {.kind = is_full ? BAT_DXF_CIRCLE : BAT_DXF_ARC, .angles = {0, 360}};
    batten_status status = read_normal(pairs, circle.normal);
    if (status == BATTEN_OK)
        status = read_vector(pairs, 10, circle.centre);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, 40, 0, &circle.size);
    for (int k = 0; status == BATTEN_OK && k < 2 && !is_full; k++)
        status = bat_dxf_get_real(pairs, 50 + k, circle.angles[k], &circle.angles[k]);
    return status == BATTEN_OK ? bat_dxf_round_curve(&circle, out) : status;
}

/* The centre and the long half axis are in the world. */
static batten_status read_ellipse(const bat_dxf_pairs *pairs, batten_curve **out)
{
    bat_dxf_round ellipse = {.kind = BAT_DXF_ELLIPSE, .angles = {0, 2 * BAT_PI}};
    batten_status status = read_normal(pairs, ellipse.normal);
    if (status == BATTEN_OK)
        status = read_vector(pairs, 10, ellipse.centre);
    if (status == BATTEN_OK)
        status = read_vector(pairs, 11, ellipse.axis);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, 40, 1, &ellipse.size);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_dxf_get_real(pairs, 41 + k, ellipse.angles[k], &ellipse.angles[k]);
    return status == BATTEN_OK ? bat_dxf_round_curve(&ellipse, out) : status;
}

/* ---- polylines ---- */

static bool is_same_place(const bat_vertex *v, const bat_vertex *w)
{
    return v->x == w->x && v->y == w->y;
}

/* A vertex where the last one is gives that one its bulge: false. */
static bool append_vertex(bat_path *path, bat_vertex made)
{
    bat_vertex *last = path->count ? &path->vertices[path->count - 1] : NULL;
    if (last && is_same_place(last, &made)) {
        last->bulge = made.bulge;
        return false;
    }
    path->vertices[path->count++] = made;
    return true;
}

/* Neighbours that are one point become one vertex: programmes write them often. Returns how many
 * are dropped. */
static int fill_path(bat_path *path, size_t count, const double *vertices)
{
    int dropped = 0;
    for (size_t i = 0; i < count; i++) { /* of no vertices there may be no array */
        const double *v = vertices + 4 * i;
        dropped += !append_vertex(path, (bat_vertex){v[0], v[1], v[3]});
    }
    while (path->closed && path->count > 1 &&
           is_same_place(&path->vertices[0], &path->vertices[path->count - 1])) {
        path->count--;
        dropped++;
    }
    return dropped;
}

static batten_status make_path(const bat_input *input, int line, const batten_frame *frame,
                               bool closed, size_t count, const double *vertices,
                               batten_curve **out)
{
    bat_path path = {
        .closed = closed, .frame = *frame, .vertices = bat_array(count, sizeof *path.vertices)};
    if (!path.vertices)
        return BATTEN_OUT_OF_MEMORY;
    const int dropped = fill_path(&path, count, vertices);
    if (dropped)
        batten_notes_add(input->notes, input->file, line, "polyline",
                         "points that repeat their neighbour: %d; dropped", dropped);
    const batten_status status = bat_path_curve(&path, out);
    bat_path_release(&path);
    return status;
}

/* x, y and the bulge of each vertex follow one another. */
static batten_status read_vertices(const bat_dxf_pairs *pairs, bat_list *vertices)
{
    const bat_dxf_group *groups = pairs->groups.items;
    batten_status status = BATTEN_OK;
    for (size_t i = 0; status == BATTEN_OK && i < pairs->groups.count; i++) {
        const int code = groups[i].code;
        const double none[4] = {0, 0, 0, 0};
        if (code == 10)
            status = bat_list_add(pairs->input, vertices, none);
        double *last =
            vertices->count ? (double *)vertices->items + 4 * (vertices->count - 1) : NULL;
        if (status == BATTEN_OK && last && (code == 10 || code == 20 || code == 42))
            status = bat_dxf_number(pairs, &groups[i],
                                    &last[code == 10   ? 0
                                          : code == 20 ? 1
                                                       : 3]);
    }
    return status;
}

static batten_status read_light_polyline(const bat_dxf_pairs *pairs, batten_curve **out)
{
    int flags = 0;
    double height = 0;
    batten_frame frame;
    bat_list vertices = {.size = 4 * sizeof(double)};
    batten_status status = bat_dxf_plane(pairs, &frame);
    if (status == BATTEN_OK)
        status = bat_dxf_get_integer(pairs, 70, 0, &flags);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, 38, 0, &height);
    if (status == BATTEN_OK)
        status = read_vertices(pairs, &vertices);
    frame.origin = bat_vec3_scale(frame.z, height);
    if (status == BATTEN_OK)
        status = make_path(pairs->input, pairs->line, &frame, flags & 1, vertices.count,
                           vertices.items, out);
    bat_release(vertices.items);
    return status;
}

batten_status bat_dxf_polyline_begin(const bat_dxf_pairs *pairs, bat_dxf_polyline *polyline)
{
    int flags = 0;
    batten_vec3 elevation;
    polyline->vertices.count = 0;
    batten_status status = bat_dxf_plane(pairs, &polyline->frame);
    if (status == BATTEN_OK)
        status = bat_dxf_get_integer(pairs, 70, 0, &flags);
    if (status == BATTEN_OK)
        status = bat_dxf_get_point(pairs, 10, zero, &elevation);
    if (status != BATTEN_OK)
        return status;
    polyline->is_open = true;
    polyline->line = pairs->line;
    polyline->closed = flags & 1;
    polyline->is_plane = !(flags & 8);
    polyline->frame.origin = bat_vec3_scale(polyline->frame.z, elevation.z);
    return bat_dxf_polymesh_begin(pairs, flags, polyline);
}

/* Vertices that only frame a spline, flag 16, are no part of the curve. */
batten_status bat_dxf_polyline_vertex(const bat_dxf_pairs *pairs, bat_dxf_polyline *polyline)
{
    int flags = 0;
    batten_vec3 p;
    double vertex[4] = {0, 0, 0, 0};
    batten_status status = bat_dxf_get_integer(pairs, 70, 0, &flags);
    if (status == BATTEN_OK && polyline->is_polyface && (flags & (64 | 128)) == 128)
        return bat_dxf_polymesh_face(pairs, polyline);
    if (status == BATTEN_OK)
        status = bat_dxf_get_point(pairs, 10, zero, &p);
    if (status == BATTEN_OK && polyline->is_plane)
        status = bat_dxf_get_real(pairs, 42, 0, &vertex[3]);
    if (status != BATTEN_OK || (flags & 16))
        return status;
    vertex[0] = p.x;
    vertex[1] = p.y;
    vertex[2] = p.z;
    return bat_list_add(pairs->input, &polyline->vertices, vertex);
}

/* A polyline in space, closed by its first point once more. */
static batten_status make_space(const bat_dxf_polyline *polyline, batten_curve **out)
{
    const double *v = polyline->vertices.items;
    const size_t count = polyline->vertices.count;
    double *points = bat_array3(count + 1, 3, sizeof *points);
    int used = 0;
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < count + (polyline->closed ? 1 : 0); i++) {
        const double *p = &v[4 * (i % count)], *last = &points[3 * (used - (used > 0))];
        if (used > 0 && bat_distance(3, p, last) == 0)
            continue;
        for (int k = 0; k < 3; k++)
            points[3 * used + k] = p[k];
        used++;
    }
    const batten_status status = batten_curve_polyline((batten_points){3, used, points}, out);
    bat_release(points);
    return status;
}

batten_status bat_dxf_polyline_curve(const bat_dxf_pairs *pairs,
                                     const bat_dxf_polyline *polyline, batten_curve **out)
{
    if (polyline->vertices.count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "it has %zu point%s", polyline->vertices.count,
                        bat_plural(polyline->vertices.count));
    if (polyline->is_plane)
        return make_path(pairs->input, polyline->line, &polyline->frame, polyline->closed,
                         polyline->vertices.count, polyline->vertices.items, out);
    return make_space(polyline, out);
}

/* ---- */

batten_status bat_dxf_read_curve(const bat_dxf_pairs *pairs, bool *is_curve, batten_curve **out)
{
    *is_curve = true;
    if (bat_dxf_is(pairs, "LINE"))
        return read_line(pairs, out);
    if (bat_dxf_is(pairs, "ARC") || bat_dxf_is(pairs, "CIRCLE"))
        return read_arc(pairs, bat_dxf_is(pairs, "CIRCLE"), out);
    if (bat_dxf_is(pairs, "ELLIPSE"))
        return read_ellipse(pairs, out);
    if (bat_dxf_is(pairs, "SPLINE"))
        return bat_dxf_read_spline(pairs, out);
    if (bat_dxf_is(pairs, "LWPOLYLINE"))
        return read_light_polyline(pairs, out);
    *is_curve = false;
    return BATTEN_OK;
}

batten_status bat_dxf_read_face(const bat_dxf_pairs *pairs, double corners[4][3], int *count)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < 4; i++) {
        batten_vec3 p;
        const batten_vec3 third = i == 3 ? bat_dxf_vector(corners[2]) : zero;
        status = bat_dxf_get_point(pairs, 10 + i, third, &p);
        if (status == BATTEN_OK)
            bat_dxf_put_vector(p, corners[i]);
    }
    *count = status == BATTEN_OK && bat_distance(3, corners[2], corners[3]) == 0 ? 3 : 4;
    return status;
}
