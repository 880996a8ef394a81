/* Meshes as triangles to be shaded, with normals where their edges are smooth. */
#include "picture/shaded/mesh_solid.h"

#include <string.h>

/* Values of a corner: the normal, then the colour. */
enum { NORMAL = 0, DYE = 3 };

/* More triangles than these would be hidden under their edges. */
enum { MOST_OUTLINED = 4000 };

static batten_status copy_points(bat_mesh_solid *s)
{
    const size_t count = (size_t)s->mesh->vertex_count;
    s->points = bat_array3(count, 3, sizeof *s->points);
    if (!s->points)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(s->points, s->mesh->points, 3 * count * sizeof *s->points);
    return BATTEN_OK;
}

static batten_status make_normals(bat_mesh_solid *s)
{
    if (s->mesh->normals)
        return BATTEN_OK;
    s->flat = bat_array3((size_t)s->mesh->triangle_count, 3, sizeof *s->flat);
    for (int t = 0; s->flat && t < s->mesh->triangle_count; t++)
        bat_triangle_normal(s->mesh, t, s->flat + 3 * (size_t)t);
    return s->flat ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status make_dyes(bat_mesh_solid *s)
{
    const double *c = s->mesh->colours;
    if (!c)
        return BATTEN_OK;
    s->dyes = bat_array((size_t)s->mesh->vertex_count, sizeof *s->dyes);
    for (size_t i = 0; s->dyes && i < (size_t)s->mesh->vertex_count; i++)
        s->dyes[i] = bat_light_of((bat_colour){c[3 * i], c[3 * i + 1], c[3 * i + 2]});
    return s->dyes ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

batten_status bat_mesh_solid_make(const batten_mesh *mesh, bool all_edges,
                                  const bat_scene *scene, bat_light albedo, bat_mesh_solid *out)
{
    bat_mesh_solid s = {.mesh = batten_mesh_view(mesh), .scene = scene, .albedo = albedo};
    const bool all = all_edges && !s.mesh->faces && s.mesh->triangle_count <= MOST_OUTLINED;
    batten_status status = copy_points(&s);
    if (status == BATTEN_OK)
        status = make_normals(&s);
    if (status == BATTEN_OK)
        status = make_dyes(&s);
    if (status == BATTEN_OK)
        status = bat_stroke_mesh(mesh, all ? BAT_MESH_ALL : BAT_MESH_EDGES, NULL, &s.lines);
    if (status == BATTEN_OK)
        *out = s;
    else
        bat_mesh_solid_free(&s);
    return status;
}

void bat_mesh_solid_free(bat_mesh_solid *s)
{
    bat_release(s->points);
    bat_release(s->flat);
    bat_release(s->dyes);
    bat_strokes_free(&s->lines);
}

static void shade(const void *user, const bat_fragment *f, float colour[3])
{
    const bat_mesh_solid *s = user;
    double n[3] = {f->value[NORMAL], f->value[NORMAL + 1], f->value[NORMAL + 2]};
    const double length = sqrt(bat_dot(3, n, n));
    for (int k = 0; k < 3; k++)
        n[k] = length > 0 ? n[k] / length : s->scene->eye[k];
    const bat_light own = {f->value[DYE], f->value[DYE + 1], f->value[DYE + 2]};
    /* Triangles have no curvature. */
    const bat_light light =
        bat_light_of_sample(s->scene, s->dyes ? own : s->albedo, (double)NAN, n);
    colour[0] = (float)light.red;
    colour[1] = (float)light.green;
    colour[2] = (float)light.blue;
}

static bat_corner corner(const bat_mesh_solid *s, size_t at)
{
    const size_t vertex = (size_t)s->mesh->corners[at];
    const double *p = s->points + 3 * vertex;
    const double *n = s->flat ? s->flat + at - at % 3 : s->mesh->normals + 3 * at;
    const bat_light dye = s->dyes ? s->dyes[vertex] : (bat_light){0, 0, 0};
    return (bat_corner){p[0], p[1], p[2], {n[0], n[1], n[2], dye.red, dye.green, dye.blue}};
}

static bool touches(const bat_raster *band, const bat_mesh_solid *s, size_t triangle)
{
    const int *c = s->mesh->corners + 3 * triangle;
    const double *y = s->points + 1;
    const double p = y[3 * (size_t)c[0]], q = y[3 * (size_t)c[1]], r = y[3 * (size_t)c[2]];
    return bat_max(bat_max(p, q), r) >= band->first_row &&
           bat_min(bat_min(p, q), r) <= band->first_row + band->rows;
}

void bat_mesh_solid_fill(bat_raster *band, const bat_mesh_solid *s)
{
    for (size_t t = 0; t < (size_t)s->mesh->triangle_count; t++) {
        if (!touches(band, s, t))
            continue;
        const bat_corner a = corner(s, 3 * t), b = corner(s, 3 * t + 1);
        const bat_corner c = corner(s, 3 * t + 2);
        bat_raster_triangle(band, &a, &b, &c, shade, s);
    }
}
