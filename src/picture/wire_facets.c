/* The tiles of surfaces as facets on the sheet. */
#include "picture/wires.h"

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
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* How far the surface bulges over an edge of a tile: an arc of length s that turns by t rises
 * s t / 8. Where there is no normal it is taken to turn by a radian. */
static double bulge(const bat_facets *f, const bat_tiles *t, size_t base, size_t a, size_t b)
{
    const double *m = t->normals + 3 * a, *n = t->normals + 3 * b;
    const double length = distance(f->points + 3 * (base + a), f->points + 3 * (base + b));
    const bool known = bat_dot(m, m) > 0 && bat_dot(n, n) > 0;
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

batten_status bat_wires_facets(const bat_wires *w, const bat_eye *eye, double scale, double x0,
                               double y0, bat_facets *out)
{
    const int count = batten_model_count(w->model);
    bat_facets f = {0};
    for (int i = 0; i < count; i++)
        f.capacity += 2 * tile_points(&w->tiles[i]);
    f.points = bat_array3(f.capacity / 2, 3, sizeof *f.points);
    f.facets = bat_array(f.capacity, sizeof *f.facets);
    batten_status status = f.points && f.facets ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        const bat_tiles *t = &w->tiles[i];
        const size_t base = f.point_count;
        for (size_t k = 0; k < tile_points(t); k++) {
            double q[3], *p = f.points + 3 * f.point_count++;
            bat_eye_project(eye, t->points + 3 * k, q);
            p[0] = x0 + scale * q[0];
            p[1] = y0 - scale * q[1];
            p[2] = scale * q[2];
        }
        if (tile_points(t) > 0)
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
