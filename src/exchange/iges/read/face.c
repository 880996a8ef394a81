/* Loops of a face as edges of a body: which way they run, where they meet, what they share. */
#include "exchange/iges/read/loops.h"
#include "numeric/box.h"

#include <string.h>

/* ---- edges and vertices ---- */

/* How far apart two sides are, which may run as they like. */
static batten_status gap_between(const bat_iges_side *side, const bat_iges_side *next,
                                 double *gap)
{
    double p[2][3], q[2][3];
    batten_status status = BATTEN_OK;
    for (int last = 0; status == BATTEN_OK && last < 2; last++) {
        status = bat_iges_end_of(side, last, p[last]);
        if (status == BATTEN_OK)
            status = bat_iges_end_of(next, last, q[last]);
    }
    if (status == BATTEN_OK)
        *gap = bat_min(bat_min(bat_iges_distance(p[0], q[0]), bat_iges_distance(p[0], q[1])),
                       bat_min(bat_iges_distance(p[1], q[0]), bat_iges_distance(p[1], q[1])));
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
    batten_status status = bat_iges_end_of(&sides[(k + count - 1) % count], true, q);
    if (status == BATTEN_OK)
        status = bat_iges_end_of(&sides[k], false, p);
    if (status != BATTEN_OK)
        return status;
    const double gap = bat_iges_distance(p, q);
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
        if (bat_iges_distance(p, other) <= tolerance) {
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
        nearest = bat_max(nearest, bat_iges_distance(p, q));
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
            status = bat_iges_link_sides(&loops[k], face->ground.tolerance);
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
        bat_iges_right_loops(face, border);
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
