/*
 * Faces as trimmed surfaces: 144 of a surface and, for each loop, a curve on it, 142, of two
 * composites, 102: one in the parameters, one in space, whose members are pairs. The outer loop
 * runs counter-clockwise in (u, v). A trimmed surface has no side of its own, so a face with
 * its outside against its surface is written on the surface reversed in u, with its curves
 * mirrored there: their control points only change signs.
 */
#include "exchange/iges/write/writing.h"
#include "exchange/shapes/prepare.h"
#include "spline/curve/curve.h"

#include <string.h>

static const bat_iges_look part = {.is_part = true};
static const bat_iges_look parameters = {.is_part = true, .use = 5};

/* The clamped curve in (u, v) as one in (-u, v). */
static batten_status mirror(const batten_curve *curve, batten_curve **out)
{
    const int count = batten_curve_point_count(curve);
    double *points = bat_array(2 * (size_t)count, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(points, batten_curve_points(curve), 2 * (size_t)count * sizeof *points);
    for (int i = 0; i < count; i++)
        points[2 * i] = -points[2 * i];
    const batten_status status =
        batten_curve_create((batten_points){2, count, points}, batten_curve_degree(curve),
                            batten_curve_weights(curve), batten_curve_knots(curve), out);
    bat_release(points);
    return status;
}

/* The curve, clamped, as the loop goes along it; `mirrored` when it is on a reversed surface.
 */
static batten_status along_loop(const batten_curve *curve, bool reversed, bool mirrored,
                                batten_curve **out)
{
    batten_curve *along = NULL, *made = NULL;
    batten_status status = batten_curve_clamp(curve, &along);
    if (status == BATTEN_OK && reversed)
        status = bat_curve_replace(batten_curve_reverse(along, &made), &along, &made);
    if (status == BATTEN_OK && mirrored)
        status = bat_curve_replace(mirror(along, &made), &along, &made);
    *out = along;
    return status;
}

static double distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* The end of a curve that misses its vertex is put there. */
static batten_status meet_vertex(const bat_iges_writing *w, const double *vertex, bool is_end,
                                 batten_curve **curve)
{
    const int last = is_end ? batten_curve_point_count(*curve) - 1 : 0;
    batten_curve *made = NULL;
    if (distance(batten_curve_points(*curve) + 3 * (size_t)last, vertex) <= w->tolerance)
        return BATTEN_OK;
    return bat_curve_replace(batten_curve_with_point(*curve, last, vertex, &made), curve,
                             &made);
}

batten_status bat_iges_meet_vertices(const bat_iges_writing *w, const batten_body_parts *p,
                                     const batten_body_edge *edge, batten_curve **out)
{
    batten_curve *curve = NULL;
    batten_status status = batten_curve_clamp(edge->curve, &curve);
    for (int end = 0; status == BATTEN_OK && end < 2; end++)
        status =
            meet_vertex(w, p->vertices + 3 * (size_t)edge->vertices[end], end == 1, &curve);
    *out = curve;
    return status;
}

static batten_status put_member(bat_iges_writing *w, const batten_curve *curve, bool reversed,
                                bool mirrored, const bat_iges_look *look, int *id)
{
    batten_curve *along = NULL;
    const batten_status status = along_loop(curve, reversed, mirrored, &along);
    if (status == BATTEN_OK)
        *id = bat_iges_put_curve(w, along, 0, *look);
    batten_curve_unref(along);
    return status;
}

static batten_status put_edge(bat_iges_writing *w, const batten_body_parts *p,
                              const batten_body_use *use, int *id)
{
    batten_curve *curve = NULL;
    batten_status status = bat_iges_meet_vertices(w, p, &p->edges[use->edge], &curve);
    if (status == BATTEN_OK)
        status = put_member(w, curve, use->reversed, false, &part, id);
    batten_curve_unref(curve);
    return status;
}

/* A composite of the members; 0 of none. */
static int put_composite(bat_iges_writing *w, const int *members, int count,
                         const bat_iges_look *look)
{
    bat_iges_look composite = *look;
    if (count == 0)
        return 0;
    composite.type = 102;
    const int id = bat_iges_begin_entity(w, 102);
    bat_iges_put_integer(&w->data, count, ',');
    for (int i = 0; i < count; i++)
        bat_iges_put_integer(&w->data, members[i], ',');
    bat_iges_put_properties(w, 0);
    bat_iges_end_entity(w, &composite);
    return id;
}

/* The members of a loop in the parameters and in space. Poles have none: a curve in space that
 * is a point makes others stumble, and so do members without a partner. */
static batten_status put_members(bat_iges_writing *w, const batten_body_parts *p,
                                 const batten_body_loop *loop, bool mirrored, int *members[2],
                                 int counts[2])
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < loop->count; i++) {
        const batten_body_use *use = &p->uses[loop->first + i];
        const batten_body_edge *edge = &p->edges[use->edge];
        if (!edge->curve)
            continue;
        if (use->parameters)
            status = put_member(w, use->parameters, use->reversed, mirrored, &parameters,
                                &members[0][counts[0]++]);
        if (status == BATTEN_OK)
            status = put_edge(w, p, use, &members[1][counts[1]++]);
    }
    return status;
}

static batten_status put_loop(bat_iges_writing *w, const batten_body_parts *p,
                              const batten_body_loop *loop, bool mirrored, int surface, int *id)
{
    int *memory = bat_array(2 * (size_t)loop->count, sizeof *memory), counts[2] = {0};
    int *members[2] = {memory, memory + (memory ? loop->count : 0)};
    if (!memory)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = put_members(w, p, loop, mirrored, members, counts);
    *id = 0;
    if (status == BATTEN_OK && counts[1] > 0) {
        const int b =
            counts[0] == counts[1] ? put_composite(w, members[0], counts[0], &parameters) : 0;
        const int c = put_composite(w, members[1], counts[1], &part);
        const int preferred = b && c ? 3 : b ? 1 : 2;
        const int values[] = {0, surface, b, c, preferred};
        bat_iges_look look = part;
        look.type = 142;
        *id = bat_iges_begin_entity(w, 142);
        for (int k = 0; k < 5; k++)
            bat_iges_put_integer(&w->data, values[k], ',');
        bat_iges_put_properties(w, 0);
        bat_iges_end_entity(w, &look);
    }
    bat_release(memory);
    return status;
}

static batten_status put_trimmed(bat_iges_writing *w, const batten_body_parts *p,
                                 const batten_body_face *face, int surface, int name,
                                 const bat_iges_look *look, int *id)
{
    int *loops = bat_array((size_t)face->count, sizeof *loops), count = 0;
    batten_status status = loops ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int l = 0; status == BATTEN_OK && l < face->count; l++) {
        status =
            put_loop(w, p, &p->loops[face->first + l], face->reversed, surface, &loops[count]);
        count += status == BATTEN_OK && loops[count];
    }
    if (status == BATTEN_OK) {
        bat_iges_look trimmed = *look;
        trimmed.type = 144;
        *id = bat_iges_begin_entity(w, 144);
        bat_iges_put_integer(&w->data, surface, ',');
        bat_iges_put_integer(&w->data, count > 0, ',');
        bat_iges_put_integer(&w->data, count > 0 ? count - 1 : 0, ',');
        if (count == 0)
            bat_iges_put_integer(&w->data, 0, ',');
        for (int l = 0; l < count; l++)
            bat_iges_put_integer(&w->data, loops[l], ',');
        bat_iges_put_properties(w, name);
        bat_iges_end_entity(w, &trimmed);
    }
    bat_release(loops);
    return status;
}

batten_status bat_iges_put_face(bat_iges_writing *w, const batten_body_parts *parts, int face,
                                int name, const bat_iges_look *look, int *id)
{
    const batten_body_face *f = &parts->faces[face];
    const batten_object object = {.name = f->name, .surface = f->surface};
    batten_surface *surface = NULL;
    batten_status status = bat_prepare_surface(&object, w->tolerance, w->notes, &surface);
    if (status != BATTEN_OK)
        return status;
    if (f->reversed) {
        batten_surface *turned = NULL;
        status = batten_surface_reverse(surface, BATTEN_U, &turned);
        batten_surface_unref(surface);
        surface = turned;
    }
    if (status != BATTEN_OK)
        return status;
    if (f->count == 0) {
        *id = bat_iges_put_surface(w, surface, name, *look);
    } else {
        const int base = bat_iges_put_surface(w, surface, 0, part);
        status = put_trimmed(w, parts, f, base, name, look, id);
    }
    batten_surface_unref(surface);
    return status;
}

void bat_iges_note_ends(const bat_iges_writing *w, const batten_body_parts *parts,
                        const char *name)
{
    int count = 0;
    double largest = 0;
    for (int e = 0; e < parts->edge_count; e++)
        for (int end = 0; end < 2 && parts->edges[e].curve; end++) {
            const batten_interval domain = batten_curve_domain(parts->edges[e].curve);
            const double at = end ? domain.b : domain.a;
            double p[3];
            if (batten_curve_evaluate(parts->edges[e].curve, at, 0, p) != BATTEN_OK)
                continue;
            const double gap =
                distance(p, parts->vertices + 3 * (size_t)parts->edges[e].vertices[end]);
            count += gap > w->tolerance;
            largest = bat_max(largest, gap);
        }
    if (count)
        batten_notes_add(
            w->notes, "", 0, name,
            "ends of edges that miss their vertices, by %g at most: %d; they are moved "
            "to them",
            largest, count);
}
