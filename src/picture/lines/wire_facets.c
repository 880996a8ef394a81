/* The tiles of surfaces as facets on the sheet. */
#include "picture/lines/wires.h"

#include <string.h>

void bat_eye_project(const bat_eye *eye, const double point[3], double out[3])
{
    const double from[3] = {point[0] - eye->centre[0], point[1] - eye->centre[1],
                            point[2] - eye->centre[2]};
    bat_view_project(&eye->view, from, out);
    if (eye->distance > 0) {
        /* Depth too is divided: so lines stay lines and planes planes. */
        const double shrink = eye->distance / (eye->distance - out[2]);
        for (int k = 0; k < 3; k++)
            out[k] *= shrink;
    }
}

static double distance(const double *a, const double *b)
{
    return bat_hypot(bat_hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* How far the surface bulges over an edge of a tile: an arc of length s that turns by t rises
 * s t / 8. Where there is no normal it is taken to turn by a radian. */
static double bulge(const bat_facets *f, const bat_tiles *t, size_t base, size_t a, size_t b)
{
    const double *m = t->normals + 3 * a, *n = t->normals + 3 * b;
    const double length = distance(f->points + 3 * (base + a), f->points + 3 * (base + b));
    const bool known = bat_dot(3, m, m) > 0 && bat_dot(3, n, n) > 0;
    return 0.125 * length * (known ? distance(m, n) : 1);
}

/* How much nearer than a line a facet must be to hide it: where the surface turns away from the
 * eye a bulge makes an error of depth many times as large; 3 points cannot be seen. The largest
 * bulge of the surface counts a little everywhere, for where it bends both ways normals do not
 * tell the bulge of a tile. Plane surfaces hide all that is behind them. */
static float slack_of(double bulge, double largest)
{
    return (float)bat_min(0.01 + 40 * bulge + 5 * largest, 3);
}

static void add_facet(bat_facets *f, size_t a, size_t b, size_t c, double bulge)
{
    f->facets[f->count++] = (bat_facet){{(int)a, (int)b, (int)c}, (float)bulge};
}

static void add_tiles(bat_facets *f, const bat_tiles *t, size_t base)
{
    const size_t n = t->count_v, first = f->count;
    double largest = 0;
    for (size_t i = 0; i + 1 < t->count_u; i++)
        for (size_t j = 0; j + 1 < n; j++) {
            const size_t a = i * n + j, b = a + n, c = b + 1, d = a + 1;
            const double rise =
                bat_max(bat_max(bulge(f, t, base, a, b), bulge(f, t, base, d, c)),
                        bat_max(bulge(f, t, base, a, d), bulge(f, t, base, b, c)));
            add_facet(f, base + a, base + b, base + c, rise);
            add_facet(f, base + a, base + c, base + d, rise);
            largest = bat_max(largest, rise);
        }
    for (size_t i = first; i < f->count; i++)
        f->facets[i].slack = slack_of((double)f->facets[i].slack, largest);
}

static size_t tile_points(const bat_tiles *t)
{
    return t->count_u * t->count_v;
}

static const batten_mesh_parts *mesh_of(const bat_wires *w, int object)
{
    const batten_object *o = batten_model_object(w->model, object);
    return o->kind == BATTEN_OBJECT_MESH ? batten_mesh_view(o->mesh) : NULL;
}

static void count_room(const bat_wires *w, size_t *points, size_t *facets)
{
    *points = *facets = 0;
    for (int i = 0; i < batten_model_count(w->model); i++) {
        const batten_mesh_parts *mesh = mesh_of(w, i);
        *points += mesh ? (size_t)mesh->vertex_count : tile_points(&w->tiles[i]);
        *facets += mesh ? (size_t)mesh->triangle_count : 2 * tile_points(&w->tiles[i]);
    }
}

/* Triangles are plane and hide all that is behind them; curves that they come near to, as those
 * of the shape that they were made from, are not. */
static void add_mesh(bat_facets *f, const batten_mesh_parts *mesh, size_t base)
{
    for (size_t i = 0; i < (size_t)mesh->triangle_count; i++) {
        const int *c = mesh->corners + 3 * i;
        add_facet(f, base + (size_t)c[0], base + (size_t)c[1], base + (size_t)c[2], 0.3);
    }
}

typedef struct {
    const bat_eye *eye;
    double scale, x0, y0;
} sheet;

static void add_points(bat_facets *f, const sheet *s, size_t count, const double *points)
{
    for (size_t k = 0; k < count; k++) {
        double q[3], *p = f->points + 3 * f->point_count++;
        bat_eye_project(s->eye, points + 3 * k, q);
        p[0] = s->x0 + s->scale * q[0];
        p[1] = s->y0 - s->scale * q[1];
        p[2] = s->scale * q[2];
    }
}

batten_status bat_wires_facets(const bat_wires *w, const bat_eye *eye, double scale, double x0,
                               double y0, bat_facets *out)
{
    const sheet s = {eye, scale, x0, y0};
    bat_facets f = {0};
    size_t points = 0;
    count_room(w, &points, &f.capacity);
    f.points = bat_array3(points, 3, sizeof *f.points);
    f.facets = bat_array(f.capacity, sizeof *f.facets);
    batten_status status = f.points && f.facets ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < batten_model_count(w->model) && status == BATTEN_OK; i++) {
        const batten_mesh_parts *mesh = mesh_of(w, i);
        const bat_tiles *t = &w->tiles[i];
        const size_t base = f.point_count;
        add_points(&f, &s, mesh ? (size_t)mesh->vertex_count : tile_points(t),
                   mesh ? mesh->points : t->points);
        if (mesh)
            add_mesh(&f, mesh, base);
        else if (tile_points(t) > 0)
            add_tiles(&f, t, base);
    }
    if (status == BATTEN_OK)
        status = bat_facets_sort(&f);
    if (status == BATTEN_OK)
        *out = f;
    else
        bat_facets_free(&f);
    return status;
}
