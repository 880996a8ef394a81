/*
 * The border of a surface as edges.
 *
 * Corners 0 .. 3 and sides 0 .. 3 go around counter-clockwise from the least u and v; the curve
 * of a side runs with its parameter:
 *
 *     3 --2-> 2
 *     ^       ^
 *     3       1
 *     |       |
 *     0 --0-> 1
 */
#include "body/border.h"
#include "base/plural.h"
#include "numeric/vector.h"
#include "spline/surface/surface.h"

#include <stdint.h>

typedef struct {
    batten_direction fixed;
    bool high;      /* at the end of its domain */
    int corners[2]; /* where the curve begins and ends */
} side;

static const side SIDES[4] = {{BATTEN_V, false, {0, 1}},
                              {BATTEN_U, true, {1, 2}},
                              {BATTEN_V, true, {3, 2}},
                              {BATTEN_U, false, {0, 3}}};

typedef struct {
    batten_interval domain[2];
    batten_curve *curves[4];
    bool is_pole[4];
    int same[4];   /* the side whose edge this one is: itself, or the opposite of a seam */
    int corner[4]; /* the first corner at this point */
} border;

batten_status bat_border_surface(const batten_surface *surface, double tolerance,
                                 batten_surface **out)
{
    batten_surface *made = NULL;
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    if (batten_surface_dimension(surface) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the surface has %d dimension%s, not 3",
                        batten_surface_dimension(surface),
                        bat_plural(batten_surface_dimension(surface)));
    batten_status status = batten_surface_to_nurbs(surface, tolerance, NULL, &made);
    if (status == BATTEN_OK)
        status = bat_surface_clamp_both(&made);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_surface_unref(made);
    return status;
}

bool bat_border_is_point(const batten_curve *curve, double tolerance)
{
    const batten_box box = batten_curve_box(curve);
    return bat_vec3_norm(bat_vec3_subtract(box.high, box.low)) <= tolerance;
}

batten_status bat_border_line(const double a[2], const double b[2], batten_interval on,
                              batten_curve **out)
{
    const double points[] = {a[0], a[1], b[0], b[1]}, knots[] = {on.a, on.a, on.b, on.b};
    return batten_curve_create((batten_points){2, 2, points}, 1, NULL, knots, out);
}

static void border_end(border *b)
{
    for (int k = 0; k < 4; k++)
        batten_curve_unref(b->curves[k]);
}

/* Corners that are one point because a side is a pole, or two are a seam. */
static void merge_corners(border *b, int i, int k)
{
    const int low = bat_min_int(b->corner[i], b->corner[k]),
              high = bat_max_int(b->corner[i], b->corner[k]);
    for (int c = 0; c < 4; c++)
        if (b->corner[c] == high)
            b->corner[c] = low;
}

static batten_status border_begin(const batten_surface *surface, double tolerance, border *b)
{
    batten_status status = BATTEN_OK;
    *b = (border){.corner = {0, 1, 2, 3}, .same = {0, 1, 2, 3}};
    b->domain[0] = batten_surface_domain(surface, BATTEN_U);
    b->domain[1] = batten_surface_domain(surface, BATTEN_V);
    for (int k = 0; status == BATTEN_OK && k < 4; k++) {
        const batten_interval domain = b->domain[SIDES[k].fixed];
        status = batten_surface_isocurve(surface, SIDES[k].fixed,
                                         SIDES[k].high ? domain.b : domain.a, &b->curves[k]);
        b->is_pole[k] = status == BATTEN_OK && bat_border_is_point(b->curves[k], tolerance);
        if (b->is_pole[k])
            merge_corners(b, SIDES[k].corners[0], SIDES[k].corners[1]);
    }
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < 2; k++) {
        const int first = k ? 0 : 3, second = k ? 2 : 1;
        if (b->is_pole[first] || b->is_pole[second] ||
            !batten_surface_is_closed(surface, SIDES[first].fixed, tolerance))
            continue;
        b->same[second] = first;
        for (int end = 0; end < 2; end++)
            merge_corners(b, SIDES[first].corners[end], SIDES[second].corners[end]);
    }
    return BATTEN_OK;
}

static batten_status add_edges(bat_builder *builder, const border *b, int edges[4])
{
    batten_status status = BATTEN_OK;
    int vertices[4] = {0};
    /* Corner k is where side 0 or 2 begins or ends. */
    for (int k = 0; status == BATTEN_OK && k < 4; k++) {
        const batten_curve *curve = b->curves[k < 2 ? 0 : 2];
        const batten_interval domain = batten_curve_domain(curve);
        double point[3];
        if (b->corner[k] != k) {
            vertices[k] = vertices[b->corner[k]];
            continue;
        }
        status = batten_curve_evaluate(curve, k == 0 || k == 3 ? domain.a : domain.b, 0, point);
        if (status == BATTEN_OK)
            status = bat_builder_vertex(builder, point, &vertices[k]);
    }
    for (int k = 3; status == BATTEN_OK && k >= 0; k--)
        if (b->same[k] == k)
            status = bat_builder_edge(builder, b->is_pole[k] ? NULL : b->curves[k],
                                      vertices[SIDES[k].corners[0]],
                                      vertices[SIDES[k].corners[1]], &edges[k]);
    for (int k = 0; k < 4; k++)
        edges[k] = edges[b->same[k]];
    return status;
}

static batten_status add_use(bat_builder *builder, const border *b, int k, bool reversed,
                             int edge)
{
    const side *s = &SIDES[k];
    const int along = s->fixed == BATTEN_U ? 1 : 0;
    const batten_interval across = b->domain[1 - along], on = b->domain[along];
    double from[2], to[2];
    from[along] = on.a;
    to[along] = on.b;
    from[1 - along] = to[1 - along] = s->high ? across.b : across.a;
    batten_curve *line = NULL;
    batten_status status = bat_border_line(from, to, on, &line);
    /* Sides 2 and 3 run against the loop, which is counter-clockwise. */
    if (status == BATTEN_OK)
        status = bat_builder_use(builder, edge, (k >= 2) != reversed, line);
    batten_curve_unref(line);
    return status;
}

batten_status bat_border_loop(bat_builder *builder, const batten_surface *surface,
                              bool reversed, double tolerance, bat_border_count *count)
{
    border b;
    int edges[4] = {0};
    batten_status status = border_begin(surface, tolerance, &b);
    if (status == BATTEN_OK)
        status = add_edges(builder, &b, edges);
    if (status == BATTEN_OK)
        status = bat_builder_loop(builder);
    for (int i = 0; status == BATTEN_OK && i < 4; i++) {
        const int k = reversed ? 3 - i : i;
        status = add_use(builder, &b, k, reversed, edges[k]);
        if (b.is_pole[k])
            count->poles++;
        else if (b.same[k] != k)
            count->seams++;
        else if (b.same[(k + 2) % 4] == k)
            continue;
        else
            count->rims++;
    }
    border_end(&b);
    return status;
}

batten_status batten_body_from_surface(const char *name, const batten_surface *surface,
                                       double tolerance, batten_body **out)
{
    batten_surface *nurbs = NULL;
    bat_border_count count = {0};
    bat_builder builder;
    bat_builder_begin(&builder, tolerance);
    batten_status status = bat_border_surface(surface, tolerance, &nurbs);
    if (status == BATTEN_OK)
        status = bat_builder_shell(&builder, false);
    if (status == BATTEN_OK)
        status =
            bat_builder_face(&builder, &(batten_body_face){.name = name, .surface = nurbs});
    if (status == BATTEN_OK)
        status = bat_border_loop(&builder, nurbs, false, tolerance, &count);
    batten_surface_unref(nurbs);
    builder.parts.is_traced = true;
    if (status == BATTEN_OK) {
        batten_body_shell *shells = (batten_body_shell *)(uintptr_t)builder.parts.shells;
        shells[0].closed = count.rims == 0;
        return bat_builder_finish(&builder, false, out);
    }
    bat_builder_end(&builder);
    return status;
}
