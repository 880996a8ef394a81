/* Loops of a face as edges of a body: which way they run, where they meet, what they share. */
#include "exchange/iges/read/loops.h"
#include "numeric/box.h"

#include <string.h>

static batten_status end_of(const bat_iges_side *side, bool last, double p[3])
{
    const batten_interval domain = batten_curve_domain(side->space);
    return batten_curve_evaluate(side->space, last != side->reversed ? domain.b : domain.a, 0,
                                 p);
}

static double distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* ---- which way sides run ---- */

/* Sides in a row of which each begins where the one before ends; some files have them run as
 * they like. Sides that meet stay as they are: of those that close, alone or two together, the
 * other ends may be nearer by a rounding error. */
static batten_status link_sides(bat_iges_loop *loop, double tolerance)
{
    bat_iges_side *sides = loop->sides.items;
    double a[3], b[3], c[3], d[3];
    batten_status status = BATTEN_OK;
    for (size_t k = 1; status == BATTEN_OK && k < loop->sides.count; k++) {
        status = end_of(&sides[k - 1], false, a);
        if (status == BATTEN_OK)
            status = end_of(&sides[k - 1], true, b);
        if (status == BATTEN_OK)
            status = end_of(&sides[k], false, c);
        if (status == BATTEN_OK)
            status = end_of(&sides[k], true, d);
        if (status != BATTEN_OK)
            return status;
        /* The first may have to turn as well. */
        const double kept = bat_min(distance(b, c), distance(b, d)),
                     turned = bat_min(distance(a, c), distance(a, d));
        if (k == 1 && kept > tolerance && turned < kept) {
            sides[0].reversed = !sides[0].reversed;
            memcpy(b, a, sizeof b);
        }
        if (distance(b, c) > tolerance && distance(b, d) < distance(b, c))
            sides[k].reversed = !sides[k].reversed;
    }
    return status;
}

/* Where a side is in (u, v): by its plane curve, or on a plane by its coordinates. */
static bool plane_point(const bat_iges_ground *ground, const bat_iges_side *side, double share,
                        double uv[2])
{
    const batten_curve *curve = side->flat ? side->flat : side->space;
    const batten_interval domain = batten_curve_domain(curve);
    const double at = side->reversed ? 1 - share : share;
    double p[3];
    if (batten_curve_evaluate(curve, domain.a + at * (domain.b - domain.a), 0, p) != BATTEN_OK)
        return false;
    if (side->flat) {
        memcpy(uv, p, 2 * sizeof *uv);
        return true;
    }
    const batten_frame *f = &ground->elementary.frame;
    const batten_vec3 x = f->x, z = f->z;
    const batten_vec3 y = {z.y * x.z - z.z * x.y, z.z * x.x - z.x * x.z, z.x * x.y - z.y * x.x};
    const batten_vec3 way = {p[0] - f->origin.x, p[1] - f->origin.y, p[2] - f->origin.z};
    uv[0] = way.x * x.x + way.y * x.y + way.z * x.z;
    uv[1] = way.x * y.x + way.y * y.y + way.z * y.z;
    return ground->is_elementary && ground->elementary.kind == BAT_PLANE;
}

/* The area of the polygon of samples; 0 when it cannot be told. */
static double area_of(const bat_iges_ground *ground, const bat_iges_loop *loop)
{
    const bat_iges_side *sides = loop->sides.items;
    double first[2] = {0}, last[2] = {0}, area = 0;
    for (size_t k = 0; k < loop->sides.count; k++) {
        const batten_curve *curve = sides[k].flat ? sides[k].flat : sides[k].space;
        const int steps = bat_min_int(64, 4 * batten_curve_spans(curve, NULL));
        for (int i = 0; i < steps; i++) {
            double uv[2];
            if (!plane_point(ground, &sides[k], (double)i / steps, uv))
                return 0;
            if (k == 0 && i == 0)
                memcpy(first, uv, sizeof first);
            else
                area += (last[0] - first[0]) * (uv[1] - first[1]) -
                        (uv[0] - first[0]) * (last[1] - first[1]);
            memcpy(last, uv, sizeof last);
        }
    }
    return area / 2;
}

static void turn_loop(bat_iges_loop *loop)
{
    bat_iges_side *sides = loop->sides.items;
    const size_t count = loop->sides.count;
    for (size_t k = 0; k < count / 2; k++) {
        const bat_iges_side kept = sides[k];
        sides[k] = sides[count - 1 - k];
        sides[count - 1 - k] = kept;
    }
    for (size_t k = 0; k < count; k++)
        sides[k].reversed = !sides[k].reversed;
    loop->area = -loop->area;
}

/* The loop with the largest area is the outer one and runs counter-clockwise, the others
 * clockwise; where areas are not known all stay as they are. */
static void right_loops(bat_iges_face *face, bool border)
{
    bat_iges_loop *loops = face->loops.items;
    size_t outer = 0;
    for (size_t k = 0; k < face->loops.count; k++) {
        loops[k].area = area_of(&face->ground, &loops[k]);
        if (fabs(loops[k].area) > fabs(loops[outer].area))
            outer = k;
    }
    if (border || face->loops.count == 0) {
        outer = face->loops.count;
    } else if (outer > 0) {
        const bat_iges_loop kept = loops[0];
        loops[0] = loops[outer];
        loops[outer] = kept;
        outer = 0;
        face->reading->swapped_loops++;
    }
    for (size_t k = 0; k < face->loops.count; k++)
        if (k == outer ? loops[k].area < 0 : loops[k].area > 0) {
            turn_loop(&loops[k]);
            face->reading->turned_loops++;
        }
}

/* ---- edges and vertices ---- */

/* How far apart two sides are, which may run as they like. */
static batten_status gap_between(const bat_iges_side *side, const bat_iges_side *next,
                                 double *gap)
{
    double p[2][3], q[2][3];
    batten_status status = BATTEN_OK;
    for (int last = 0; status == BATTEN_OK && last < 2; last++) {
        status = end_of(side, last, p[last]);
        if (status == BATTEN_OK)
            status = end_of(next, last, q[last]);
    }
    if (status == BATTEN_OK)
        *gap = bat_min(bat_min(distance(p[0], q[0]), distance(p[0], q[1])),
                       bat_min(distance(p[1], q[0]), distance(p[1], q[1])));
    return status;
}

static bool is_point(const bat_iges_face *face, const bat_iges_side *side)
{
    return !(bat_iges_size_of_curve(side->space) > face->ground.tolerance);
}

/* What is dropped must be where its neighbours are. */
static batten_status check_points(const bat_iges_face *face, const bat_iges_loop *loop)
{
    const bat_iges_side *sides = loop->sides.items;
    const size_t count = loop->sides.count;
    for (size_t k = 0; k < count; k++) {
        const size_t next = (k + 1) % count;
        double gap = 0;
        if (!is_point(face, &sides[k]) && !is_point(face, &sides[next]))
            continue;
        const batten_status status = gap_between(&sides[k], &sides[next], &gap);
        if (status != BATTEN_OK)
            return status;
        if (gap > bat_iges_open_gap(face))
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "part %zu of a loop begins %g from the end of the one before",
                            next + 1, gap);
    }
    return BATTEN_OK;
}

/* Sides of no length are poles, which need no edge. */
static batten_status drop_points(const bat_iges_face *face, bat_iges_loop *loop)
{
    bat_iges_side *sides = loop->sides.items;
    size_t kept = 0;
    const batten_status status = check_points(face, loop);
    if (status != BATTEN_OK)
        return status;
    for (size_t k = 0; k < loop->sides.count; k++)
        if (!is_point(face, &sides[k])) {
            sides[kept++] = sides[k];
        } else {
            batten_curve_unref(sides[k].space);
            batten_curve_unref(sides[k].flat);
        }
    loop->sides.count = kept;
    return BATTEN_OK;
}

/* Vertices and edges of a loop that are looked at for ones that are the same. */
enum { COMPARED = 128 };

typedef struct {
    const bat_iges_face *face;
    bat_builder *builder;
    const bat_iges_loop *loop;
    int *vertices; /* [count + 1]: at the beginning of each side */
    int *edges;    /* [count] */
    bool *paired;  /* [count]: the edge is that of another side, run through the other way */
} putting;

/* The vertex between two sides: halfway where they miss each other. */
static batten_status put_vertex(const putting *put, size_t k)
{
    const bat_iges_side *sides = put->loop->sides.items;
    const size_t count = put->loop->sides.count;
    const double tolerance = put->face->ground.tolerance;
    double p[3], q[3];
    batten_status status = end_of(&sides[(k + count - 1) % count], true, q);
    if (status == BATTEN_OK)
        status = end_of(&sides[k], false, p);
    if (status != BATTEN_OK)
        return status;
    const double gap = distance(p, q);
    const bool is_open = gap > bat_iges_open_gap(put->face);
    if (is_open && k == 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a loop ends %g from where it begins", gap);
    if (is_open)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "part %zu of a loop begins %g from the end of the one before", k + 1,
                        gap);
    if (gap > tolerance) {
        put->face->reading->gaps++;
        put->face->reading->largest_gap = bat_max(put->face->reading->largest_gap, gap);
    }
    for (int i = 0; i < 3; i++)
        p[i] = p[i] / 2 + q[i] / 2;
    for (size_t j = 0; j < k && k < COMPARED; j++) {
        const double *other = put->builder->parts.vertices + 3 * (size_t)put->vertices[j];
        if (distance(p, other) <= tolerance) {
            put->vertices[k] = put->vertices[j];
            return BATTEN_OK;
        }
    }
    return bat_builder_vertex(put->builder, p, &put->vertices[k]);
}

/* Are these the same edge, run through both ways: a seam? */
static bool is_seam(const putting *put, size_t j, size_t k)
{
    const bat_iges_side *sides = put->loop->sides.items;
    static const double shares[] = {0.25, 0.5, 0.75};
    double p[3], nearest = 0;
    if (put->vertices[j] != put->vertices[k + 1] || put->vertices[j + 1] != put->vertices[k])
        return false;
    const batten_interval a = batten_curve_domain(sides[j].space),
                          b = batten_curve_domain(sides[k].space);
    const bool same = sides[j].reversed != sides[k].reversed;
    for (int i = 0; i < 3; i++) {
        double q[3];
        const double share = same ? shares[i] : 1 - shares[i];
        if (batten_curve_evaluate(sides[j].space, a.a + shares[i] * (a.b - a.a), 0, p) !=
                BATTEN_OK ||
            batten_curve_evaluate(sides[k].space, b.a + share * (b.b - b.a), 0, q) != BATTEN_OK)
            return false;
        nearest = bat_max(nearest, distance(p, q));
    }
    return nearest <= put->face->ground.tolerance;
}

static batten_status put_side(const putting *put, size_t k)
{
    const bat_iges_side *side = (const bat_iges_side *)put->loop->sides.items + k;
    const bat_iges_side *sides = put->loop->sides.items;
    bool reversed = side->reversed;
    put->edges[k] = -1;
    for (size_t j = 0; j < k && k < COMPARED && put->edges[k] < 0; j++)
        if (!put->paired[j] && is_seam(put, j, k)) {
            put->edges[k] = put->edges[j];
            put->paired[j] = put->paired[k] = true;
            reversed = !sides[j].reversed;
        }
    batten_status status = BATTEN_OK;
    const bool is_new = put->edges[k] < 0;
    if (is_new)
        status = bat_builder_edge(put->builder, side->space, put->vertices[k + side->reversed],
                                  put->vertices[k + !side->reversed], &put->edges[k]);
    if (status != BATTEN_OK)
        return status;
    /* Its curve in (u, v) must run as the shared edge does. */
    batten_curve *turned = NULL;
    if (side->flat && reversed != side->reversed)
        status = batten_curve_reverse(side->flat, &turned);
    if (status == BATTEN_OK)
        status = bat_builder_use(put->builder, put->edges[k], reversed,
                                 turned ? turned : side->flat);
    batten_curve_unref(turned);
    return status;
}

static batten_status put_loop(const bat_iges_face *face, const bat_iges_loop *loop,
                              bat_builder *builder)
{
    const size_t count = loop->sides.count;
    putting put = {face, builder, loop, NULL, NULL, NULL};
    bat_input *input = face->reading->input;
    batten_status status =
        bat_input_array(input, count + 1, sizeof *put.vertices, &put.vertices);
    if (status == BATTEN_OK)
        status = bat_input_array(input, count, sizeof *put.edges, &put.edges);
    if (status == BATTEN_OK)
        status = bat_input_array(input, count, sizeof *put.paired, &put.paired);
    for (size_t k = 0; status == BATTEN_OK && k < count; k++)
        status = put_vertex(&put, k);
    if (status == BATTEN_OK) {
        put.vertices[count] = put.vertices[0];
        status = bat_builder_loop(builder);
    }
    for (size_t k = 0; status == BATTEN_OK && k < count; k++)
        status = put_side(&put, k);
    bat_release(put.paired);
    bat_release(put.edges);
    bat_release(put.vertices);
    return status;
}

/* The border of the surface as the outer loop. */
static batten_status put_border(const bat_iges_face *face, bat_builder *builder)
{
    batten_body *body = NULL;
    int *vertices = NULL, *edges = NULL;
    batten_status status =
        batten_body_from_surface("", face->ground.surface, face->ground.tolerance, &body);
    if (status != BATTEN_OK)
        return status;
    const batten_body_parts *p = batten_body_view(body);
    bat_input *input = face->reading->input;
    status = bat_input_array(input, (size_t)p->vertex_count + 1, sizeof *vertices, &vertices);
    if (status == BATTEN_OK)
        status = bat_input_array(input, (size_t)p->edge_count + 1, sizeof *edges, &edges);
    for (int k = 0; status == BATTEN_OK && k < p->vertex_count; k++)
        status = bat_builder_vertex(builder, p->vertices + 3 * (size_t)k, &vertices[k]);
    for (int k = 0; status == BATTEN_OK && k < p->edge_count; k++)
        status = bat_builder_edge(builder, p->edges[k].curve, vertices[p->edges[k].vertices[0]],
                                  vertices[p->edges[k].vertices[1]], &edges[k]);
    if (status == BATTEN_OK)
        status = bat_builder_loop(builder);
    for (int k = 0; status == BATTEN_OK && k < p->use_count; k++)
        status = bat_builder_use(builder, edges[p->uses[k].edge], p->uses[k].reversed,
                                 p->uses[k].parameters);
    bat_release(edges);
    bat_release(vertices);
    batten_body_unref(body);
    return status;
}

/* ---- the whole face ---- */

/* Points of all sides, and how large the box of them is. */
static batten_status sample_sides(bat_iges_face *face, bat_list *points)
{
    const bat_iges_loop *loops = face->loops.items;
    batten_box box = bat_box_of_nothing();
    batten_status status = BATTEN_OK;
    for (size_t l = 0; status == BATTEN_OK && l < face->loops.count; l++) {
        const bat_iges_side *sides = loops[l].sides.items;
        for (size_t k = 0; status == BATTEN_OK && k < loops[l].sides.count; k++)
            status = bat_iges_sample(face->reading, sides[k].space, points);
    }
    const double *p = points->items;
    for (size_t k = 0; k < points->count; k++)
        bat_box_join(&box, bat_box_at(p + 3 * k));
    face->size = points->count ? bat_iges_size_of_box(box) : 0;
    if (status == BATTEN_OK && isinf(face->size)) /* every gap would be within it */
        status = bat_fail(BATTEN_OVERFLOW, "its edges reach too far to be measured");
    return status;
}

/* Do the loops leave the face open on one side? They are linked, but may run either way: two
 * that bound it on both sides go around it twice or not at all. */
static batten_status look_around(bat_iges_face *face)
{
    const bat_iges_loop *loops = face->loops.items;
    bat_elementary *elementary = &face->ground.elementary;
    bat_around around;
    batten_status status = bat_around_begin(elementary, face->ground.tolerance, &around);
    for (size_t l = 0; status == BATTEN_OK && l < face->loops.count; l++) {
        const bat_iges_side *sides = loops[l].sides.items;
        for (size_t k = 0; status == BATTEN_OK && k < loops[l].sides.count; k++)
            status = bat_around_add(&around, sides[k].space, sides[k].reversed);
    }
    elementary->goes_on = status == BATTEN_OK && bat_around_is_once(&around);
    return status;
}

/* Which way the sides of all loops run. */
static batten_status link_loops(bat_iges_face *face)
{
    bat_iges_loop *loops = face->loops.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < face->loops.count; k++) {
        status = drop_points(face, &loops[k]);
        if (status == BATTEN_OK && loops[k].sides.count == 0)
            status = bat_fail(BATTEN_TOO_FEW_POINTS, "loop %zu is a point", k + 1);
        if (status == BATTEN_OK)
            status = link_sides(&loops[k], face->ground.tolerance);
    }
    return status;
}

/* Find how large the face is, link its loops, and find the part of an elementary surface that
 * it needs. */
static batten_status settle_ground(bat_iges_face *face, batten_surface **made)
{
    bat_list points = {.size = 3 * sizeof(double)};
    double error = 0;
    bat_iges_ground *ground = &face->ground;
    batten_status status = sample_sides(face, &points);
    if (status == BATTEN_OK && face->size > 0)
        ground->tolerance = bat_iges_tolerance(face->reading, face->size);
    if (status == BATTEN_OK)
        status = link_loops(face);
    if (status == BATTEN_OK && ground->is_elementary)
        status = look_around(face);
    if (status == BATTEN_OK && ground->is_elementary)
        status = bat_elementary_surface(&ground->elementary, (int)points.count, points.items,
                                        ground->tolerance, made, &error);
    bat_release(points.items);
    return status;
}

/* To what the file keeps to. */
static void raise_tolerance(bat_iges_face *face)
{
    const bat_iges_loop *loops = face->loops.items;
    double miss = 0;
    for (size_t l = 0; l < face->loops.count; l++) {
        const bat_iges_side *sides = loops[l].sides.items;
        for (size_t k = 0; k < loops[l].sides.count; k++)
            miss = bat_max(miss, bat_iges_miss(&face->ground, sides[k].space, sides[k].flat));
    }
    face->ground.tolerance =
        bat_iges_tolerance_of_miss(face->reading, face->ground.tolerance, miss, face->size);
}

batten_status bat_iges_make_face(bat_iges_face *face, bool border, bat_builder *builder)
{
    bat_iges_loop *loops = face->loops.items;
    batten_surface *made = NULL;
    batten_status status = settle_ground(face, &made);
    for (size_t k = 0; status == BATTEN_OK && k < face->loops.count; k++)
        status = bat_iges_close_loop(face, &loops[k]);
    if (status == BATTEN_OK) {
        raise_tolerance(face);
        right_loops(face, border);
        const batten_body_face plain = {.surface = made ? made : face->ground.surface};
        status = bat_builder_face(builder, &plain);
    }
    if (status == BATTEN_OK && border && face->loops.count > 0)
        status = put_border(face, builder);
    for (size_t k = 0; status == BATTEN_OK && k < face->loops.count; k++)
        status = put_loop(face, &loops[k], builder);
    batten_surface_unref(made);
    return status;
}
