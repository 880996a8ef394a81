#include "support/bodies.h"
#include "body/builder.h"
#include "support/test.h"

#include <batten/standard.h>

/* Corner k has the high x, y, z where bits 0, 1, 2 are set. */
static batten_vec3 corner(batten_vec3 low, batten_vec3 high, int k)
{
    return (batten_vec3){k & 1 ? high.x : low.x, k & 2 ? high.y : low.y,
                         k & 4 ? high.z : low.z};
}

/* Counter-clockwise from outside. */
static const struct {
    const char *name;
    int corners[4];
} sides[6] = {{"left", {0, 4, 6, 2}}, {"right", {1, 3, 7, 5}},  {"front", {0, 1, 5, 4}},
              {"back", {2, 6, 7, 3}}, {"bottom", {0, 2, 3, 1}}, {"top", {4, 5, 7, 6}}};

/* The edge between two corners, made when it is not there: [from][to], -1 for none. */
static batten_status make_edge(bat_builder *builder, batten_vec3 low, batten_vec3 high,
                               int from, int to, int edges[8][8])
{
    const batten_vec3 a = corner(low, high, from), b = corner(low, high, to);
    const double p[3] = {a.x, a.y, a.z}, q[3] = {b.x, b.y, b.z};
    batten_curve *line = NULL;
    if (edges[from][to] >= 0 || edges[to][from] >= 0)
        return BATTEN_OK;
    batten_status status = batten_curve_line(3, p, q, &line);
    if (status == BATTEN_OK)
        status = bat_builder_edge(builder, line, from, to, &edges[from][to]);
    batten_curve_unref(line);
    return status;
}

static batten_status add_side(bat_builder *builder, batten_vec3 low, batten_vec3 high, int side,
                              int edges[8][8])
{
    const int *c = sides[side].corners;
    batten_surface *surface = NULL;
    batten_status status =
        batten_surface_bilinear(corner(low, high, c[0]), corner(low, high, c[1]),
                                corner(low, high, c[3]), corner(low, high, c[2]), &surface);
    const batten_body_face face = {.name = sides[side].name, .surface = surface};
    if (status == BATTEN_OK)
        status = bat_builder_face(builder, &face);
    if (status == BATTEN_OK)
        status = bat_builder_loop(builder);
    for (int k = 0; status == BATTEN_OK && k < 4; k++) {
        const int from = c[k], to = c[(k + 1) % 4];
        status = make_edge(builder, low, high, from, to, edges);
        const bool forward = edges[from][to] >= 0;
        if (status == BATTEN_OK)
            status = bat_builder_use(builder, edges[forward ? from : to][forward ? to : from],
                                     !forward, NULL);
    }
    batten_surface_unref(surface);
    return status;
}

static batten_status make_box(batten_vec3 low, batten_vec3 high, batten_body **out)
{
    bat_builder builder;
    int edges[8][8], index;
    batten_status status = BATTEN_OK;
    memset(edges, -1, sizeof edges);
    bat_builder_begin(&builder, 1e-6);
    for (int k = 0; status == BATTEN_OK && k < 8; k++) {
        const batten_vec3 p = corner(low, high, k);
        status = bat_builder_vertex(&builder, (double[]){p.x, p.y, p.z}, &index);
    }
    if (status == BATTEN_OK)
        status = bat_builder_shell(&builder, true);
    for (int side = 0; status == BATTEN_OK && side < 6; side++)
        status = add_side(&builder, low, high, side, edges);
    if (status == BATTEN_OK)
        return bat_builder_finish(&builder, true, out);
    bat_builder_end(&builder);
    return status;
}

batten_body *test_box(batten_vec3 low, batten_vec3 high)
{
    batten_body *body = NULL;
    CHECK_OK(make_box(low, high, &body));
    return body;
}
