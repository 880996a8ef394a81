/*
 * A box of 6 x 4 x 2 with a round hole of radius 1 along z in its middle, as a traced solid:
 * six plane faces and two half cylinders, which are turned against their surfaces. By public
 * functions only, so that programs for witnesses can use it.
 */
#ifndef TESTS_SUPPORT_DRILLED_BOX_H
#define TESTS_SUPPORT_DRILLED_BOX_H
#include <batten/body.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

enum { DRILLED_EDGES = 18, DRILLED_FACES = 8, DRILLED_VERTICES = 12, DRILLED_USES = 36 };

/* Corner k has the high x, y, z where bits 0, 1, 2 are set; then the ends of the half circles.
 */
static const double drilled_vertices[DRILLED_VERTICES][3] = {
    {0, 0, 0}, {6, 0, 0}, {0, 4, 0}, {6, 4, 0}, {0, 0, 2}, {6, 0, 2},
    {0, 4, 2}, {6, 4, 2}, {4, 2, 0}, {2, 2, 0}, {4, 2, 2}, {2, 2, 2}};

/* Straight edges, then half circles: below from angle 0 and from pi, the same above. */
static const int drilled_ends[DRILLED_EDGES][2] = {
    {0, 1}, {2, 3}, {4, 5}, {6, 7},  {0, 2},  {1, 3}, {4, 6}, {5, 7},   {0, 4},
    {1, 5}, {2, 6}, {3, 7}, {8, 10}, {9, 11}, {8, 9}, {9, 8}, {10, 11}, {11, 10}};

/* Each plane with its origin and directions; its loops of edges, counted from 1, negative when
 * they run backwards. */
static const struct {
    const char *name;
    double origin[3], x[3], y[3], size[2];
    int loops[8];
} drilled_planes[6] = {
    {"left", {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {2, 4}, {9, 7, -11, -5}},
    {"right", {6, 0, 0}, {0, 1, 0}, {0, 0, 1}, {4, 2}, {6, 12, -8, -10}},
    {"front", {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {6, 2}, {1, 10, -3, -9}},
    {"back", {0, 4, 0}, {0, 0, 1}, {1, 0, 0}, {2, 6}, {11, 4, -12, -2}},
    {"bottom", {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {4, 6}, {5, 2, -6, -1, 15, 16}},
    {"top", {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {6, 4}, {3, 8, -4, -7, -18, -17}}};

/* A straight edge, or half a circle. */
static batten_status drilled_curve(int edge, batten_curve **out)
{
    static const double line[] = {0, 0, 1, 1}, arc[] = {0, 0, 0, 1, 1, 2, 2, 2};
    const double h = sqrt(0.5), weights[] = {1, h, 1, h, 1};
    const double *a = drilled_vertices[drilled_ends[edge][0]];
    const double *b = drilled_vertices[drilled_ends[edge][1]];
    if (edge < 14)
        return batten_curve_create(
            (batten_points){3, 2, (double[]){a[0], a[1], a[2], b[0], b[1], b[2]}}, 1, NULL,
            line, out);
    const double s = a[0] - 3, z = a[2]; /* the side that it begins on: 1 or -1 */
    const double points[] = {3 + s, 2,     z,     3 + s, 2 + s, z, 3, 2 + s,
                             z,     3 - s, 2 + s, z,     3 - s, 2, z};
    return batten_curve_create((batten_points){3, 5, points}, 2, weights, arc, out);
}

/* The curve as the plane has it. */
static batten_status drilled_on_plane(int plane, const batten_curve *curve, batten_curve **out)
{
    const int count = batten_curve_point_count(curve);
    const double *p = batten_curve_points(curve), *o = drilled_planes[plane].origin;
    const double *x = drilled_planes[plane].x, *y = drilled_planes[plane].y;
    double points[10] = {0};
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            points[2 * i] += (p[3 * i + k] - o[k]) * x[k];
            points[2 * i + 1] += (p[3 * i + k] - o[k]) * y[k];
        }
    return batten_curve_create((batten_points){2, count, points}, batten_curve_degree(curve),
                               batten_curve_weights(curve), batten_curve_knots(curve), out);
}

typedef struct {
    batten_body_edge edges[DRILLED_EDGES];
    batten_body_use uses[DRILLED_USES];
    batten_body_loop loops[DRILLED_FACES + 2];
    batten_body_face faces[DRILLED_FACES];
    batten_curve *curves[DRILLED_EDGES + DRILLED_USES]; /* to give back */
    batten_surface *surfaces[DRILLED_FACES];
    int use_count, loop_count, curve_count;
} drilled_parts;

static batten_status drilled_add_use(drilled_parts *d, int edge, bool reversed,
                                     batten_status status, batten_curve *parameters)
{
    d->curves[d->curve_count++] = parameters;
    d->uses[d->use_count++] = (batten_body_use){edge, reversed, parameters};
    d->loops[d->loop_count - 1].count++;
    return status;
}

static batten_status drilled_plane(drilled_parts *d, int k)
{
    const double *o = drilled_planes[k].origin, *x = drilled_planes[k].x;
    const double *y = drilled_planes[k].y, w = drilled_planes[k].size[0],
                 h = drilled_planes[k].size[1];
    const double u[] = {0, 0, w, w}, v[] = {0, 0, h, h};
    const batten_axis axis_u = {1, 2, u, false}, axis_v = {1, 2, v, false};
    double points[12];
    for (int i = 0; i < 4; i++)
        for (int c = 0; c < 3; c++)
            points[3 * i + c] = o[c] + (i / 2) * w * x[c] + (i % 2) * h * y[c];
    batten_status status =
        batten_surface_create(3, &axis_u, &axis_v, points, NULL, &d->surfaces[k]);
    d->faces[k] = (batten_body_face){.name = drilled_planes[k].name,
                                     .has_colour = k == 5,
                                     .colour = {1, 0.5, 0},
                                     .surface = d->surfaces[k],
                                     .first = d->loop_count};
    for (int i = 0; status == BATTEN_OK && i < 8 && drilled_planes[k].loops[i]; i++) {
        const int loop = drilled_planes[k].loops[i], edge = abs(loop) - 1;
        batten_curve *parameters = NULL;
        if (i % 4 == 0) {
            d->loops[d->loop_count++] = (batten_body_loop){d->use_count, 0};
            d->faces[k].count++;
        }
        status = drilled_on_plane(k, d->edges[edge].curve, &parameters);
        status = drilled_add_use(d, edge, loop < 0, status, parameters);
    }
    return status;
}

/* Half the wall of the hole: over the half circles `below` and `above`. */
static batten_status drilled_wall(drilled_parts *d, int k, const int edges[4])
{
    static const double u[] = {0, 0, 0, 1, 1, 2, 2, 2}, v[] = {0, 0, 2, 2};
    static const double ends[4][4] = {{0, 0, 0, 2}, {0, 2, 2, 2}, {2, 0, 2, 2}, {0, 0, 2, 0}};
    const batten_axis axis_u = {2, 5, u, false}, axis_v = {1, 2, v, false};
    const batten_curve *below = d->edges[edges[3]].curve, *above = d->edges[edges[1]].curve;
    double points[30], weights[10];
    for (int i = 0; i < 10; i++) {
        const batten_curve *from = i % 2 ? above : below;
        weights[i] = batten_curve_weights(from)[i / 2];
        for (int c = 0; c < 3; c++)
            points[3 * i + c] = batten_curve_points(from)[3 * (i / 2) + c];
    }
    batten_status status =
        batten_surface_create(3, &axis_u, &axis_v, points, weights, &d->surfaces[k]);
    d->faces[k] = (batten_body_face){.name = "",
                                     .surface = d->surfaces[k],
                                     .reversed = true,
                                     .first = d->loop_count,
                                     .count = 1};
    d->loops[d->loop_count++] = (batten_body_loop){d->use_count, 0};
    for (int i = 0; status == BATTEN_OK && i < 4; i++) {
        const double *e = ends[i], line[] = {0, 0, i % 2 ? 2 : 1, i % 2 ? 2 : 1};
        batten_curve *parameters = NULL;
        status = batten_curve_create((batten_points){2, 2, e}, 1, NULL, line, &parameters);
        status = drilled_add_use(d, edges[i], i >= 2, status, parameters);
    }
    return status;
}

static batten_status drilled_box(batten_body **out)
{
    static const int walls[2][4] = {{12, 16, 13, 14}, {13, 17, 12, 15}};
    static drilled_parts d;
    batten_status status = BATTEN_OK;
    d = (drilled_parts){.use_count = 0};
    for (int i = 0; status == BATTEN_OK && i < DRILLED_EDGES; i++) {
        batten_curve *curve = NULL;
        status = drilled_curve(i, &curve);
        d.curves[d.curve_count++] = curve;
        d.edges[i] = (batten_body_edge){curve, {drilled_ends[i][0], drilled_ends[i][1]}};
    }
    for (int k = 0; status == BATTEN_OK && k < 6; k++)
        status = drilled_plane(&d, k);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = drilled_wall(&d, 6 + k, walls[k]);
    const batten_body_shell shell = {0, DRILLED_FACES, true};
    const batten_body_parts parts = {.vertex_count = DRILLED_VERTICES,
                                     .vertices = drilled_vertices[0],
                                     .edge_count = DRILLED_EDGES,
                                     .edges = d.edges,
                                     .use_count = d.use_count,
                                     .uses = d.uses,
                                     .loop_count = d.loop_count,
                                     .loops = d.loops,
                                     .face_count = DRILLED_FACES,
                                     .faces = d.faces,
                                     .shell_count = 1,
                                     .shells = &shell,
                                     .is_solid = true,
                                     .tolerance = 1e-6,
                                     .is_traced = true};
    if (status == BATTEN_OK)
        status = batten_body_create(&parts, out);
    for (int i = 0; i < d.curve_count; i++)
        batten_curve_unref(d.curves[i]);
    for (int k = 0; k < DRILLED_FACES; k++)
        batten_surface_unref(d.surfaces[k]);
    return status;
}

#endif
