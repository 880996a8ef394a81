/* Bodies as values: checked when they are made, immutable and counted. */
#include "base/plural.h"
#include "body/measure/box.h"

#include <limits.h>
#include <stdint.h>
#include <string.h>

struct batten_body {
    bat_references references;
    batten_body_parts
        parts; /* owns its arrays, the names, and one reference to each geometry */
    bat_kept_box box;
};

/* Casts away the const under which the parts show what they own. */
static void release_array(const void *memory)
{
    bat_release((void *)(uintptr_t)memory);
}

static void drop_curve(const batten_curve *curve)
{
    batten_curve_unref((batten_curve *)(uintptr_t)curve);
}

static void drop_geometry(const batten_body_parts *parts)
{
    for (int i = 0; i < parts->edge_count; i++)
        drop_curve(parts->edges[i].curve);
    for (int i = 0; i < parts->use_count; i++)
        drop_curve(parts->uses[i].parameters);
    for (int i = 0; i < parts->face_count; i++) {
        release_array(parts->faces[i].name);
        batten_surface_unref((batten_surface *)(uintptr_t)parts->faces[i].surface);
    }
}

static void drop_arrays(const batten_body_parts *parts)
{
    release_array(parts->vertices);
    release_array(parts->edges);
    release_array(parts->uses);
    release_array(parts->loops);
    release_array(parts->faces);
    release_array(parts->shells);
}

batten_body *batten_body_ref(const batten_body *body)
{
    batten_body *counted = (batten_body *)(uintptr_t)body;
    bat_references_add(&counted->references);
    return counted;
}

void batten_body_unref(batten_body *body)
{
    if (!body || !bat_references_drop(&body->references))
        return;
    drop_geometry(&body->parts);
    drop_arrays(&body->parts);
    bat_release(body);
}

const batten_body_parts *batten_body_view(const batten_body *body)
{
    return &body->parts;
}

/* ---- its box ---- */

bat_kept_box *bat_body_kept_box(const batten_body *body)
{
    return &((batten_body *)(uintptr_t)body)->box;
}

/* ---- what is allowed ---- */

static batten_status check_counts(const batten_body_parts *p)
{
    const int counts[] = {p->vertex_count, p->edge_count, p->use_count,
                          p->loop_count,   p->face_count, p->shell_count};
    static const char *const names[] = {"vertices", "edges", "uses",
                                        "loops",    "faces", "shells"};
    for (int k = 0; k < 6; k++)
        if (counts[k] < 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "%d %s", counts[k], names[k]);
    if (!(p->tolerance > 0 && isfinite(p->tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance of the body is %g", p->tolerance);
    const size_t bad = bat_first_not_finite(p->vertices, 3 * (size_t)p->vertex_count);
    if (bad < 3 * (size_t)p->vertex_count)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of vertex %zu is not finite",
                        bad % 3 + 1, bad / 3 + 1);
    return BATTEN_OK;
}

static batten_status check_edges(const batten_body_parts *p)
{
    for (int i = 0; i < p->edge_count; i++) {
        const batten_body_edge *edge = &p->edges[i];
        for (int k = 0; k < 2; k++)
            if (edge->vertices[k] < 0 || edge->vertices[k] >= p->vertex_count)
                return bat_fail(BATTEN_BAD_ARGUMENT, "edge %d has vertex %d, of %d", i + 1,
                                edge->vertices[k] + 1, p->vertex_count);
        if (edge->curve && batten_curve_dimension(edge->curve) != 3)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the curve of edge %d has %d dimension%s, not 3", i + 1,
                            batten_curve_dimension(edge->curve),
                            bat_plural(batten_curve_dimension(edge->curve)));
        if (!edge->curve && edge->vertices[0] != edge->vertices[1])
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "edge %d has no curve, but goes from vertex %d to vertex %d", i + 1,
                            edge->vertices[0] + 1, edge->vertices[1] + 1);
    }
    return BATTEN_OK;
}

/* The vertex where a use begins (k = 0) or ends (k = 1). */
static int end_of(const batten_body_parts *p, const batten_body_use *use, int k)
{
    return p->edges[use->edge].vertices[use->reversed ? 1 - k : k];
}

static batten_status check_uses(const batten_body_parts *p)
{
    for (int i = 0; i < p->use_count; i++) {
        const batten_body_use *use = &p->uses[i];
        if (use->edge < 0 || use->edge >= p->edge_count)
            return bat_fail(BATTEN_BAD_ARGUMENT, "use %d is of edge %d, of %d", i + 1,
                            use->edge + 1, p->edge_count);
        if (use->parameters && batten_curve_dimension(use->parameters) != 2)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the parameter curve of use %d has %d dimension%s, not 2", i + 1,
                            batten_curve_dimension(use->parameters),
                            bat_plural(batten_curve_dimension(use->parameters)));
        if (p->is_traced && !use->parameters)
            return bat_fail(BATTEN_BAD_ARGUMENT, "use %d of a traced body has no parameters",
                            i + 1);
    }
    return BATTEN_OK;
}

/* Do ranges follow one another and take up all of `count`? */
static batten_status check_range(int first, int count, int least, int *next, int all,
                                 const char *what, int index)
{
    if (first != *next || count < least || count > all - first)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%s %d has the parts %d .. %d, of %d; it should "
                        "begin with %d",
                        what, index + 1, first + 1, first + count, all, *next + 1);
    *next = first + count;
    return BATTEN_OK;
}

static batten_status check_loops(const batten_body_parts *p)
{
    batten_status status = BATTEN_OK;
    int next = 0;
    for (int i = 0; status == BATTEN_OK && i < p->loop_count; i++) {
        const batten_body_loop *loop = &p->loops[i];
        status = check_range(loop->first, loop->count, 1, &next, p->use_count, "loop", i);
        for (int k = 0; status == BATTEN_OK && k < loop->count; k++) {
            const batten_body_use *use = &p->uses[loop->first + k];
            const batten_body_use *then = &p->uses[loop->first + (k + 1) % loop->count];
            if (end_of(p, use, 1) != end_of(p, then, 0))
                return bat_fail(
                    BATTEN_BAD_ARGUMENT,
                    "loop %d is broken: edge %d ends in vertex %d, edge %d begins in "
                    "vertex %d",
                    i + 1, use->edge + 1, end_of(p, use, 1) + 1, then->edge + 1,
                    end_of(p, then, 0) + 1);
        }
    }
    if (status == BATTEN_OK && next != p->use_count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d of %d uses are in no loop",
                        p->use_count - next, p->use_count);
    return status;
}

static batten_status check_faces(const batten_body_parts *p)
{
    batten_status status = BATTEN_OK;
    int loops = 0, faces = 0;
    for (int i = 0; status == BATTEN_OK && i < p->face_count; i++) {
        const batten_body_face *face = &p->faces[i];
        if (!face->surface || batten_surface_dimension(face->surface) != 3)
            return bat_fail(BATTEN_BAD_ARGUMENT, "face %d has no surface in space", i + 1);
        for (int k = 0; face->has_colour && k < 3; k++)
            if (!(face->colour[k] >= 0 && face->colour[k] <= 1))
                return bat_fail(BATTEN_BAD_ARGUMENT,
                                "colour part %d of face %d is %g, not in 0..1", k + 1, i + 1,
                                face->colour[k]);
        status = check_range(face->first, face->count, 0, &loops, p->loop_count, "face", i);
    }
    for (int i = 0; status == BATTEN_OK && i < p->shell_count; i++)
        status = check_range(p->shells[i].first, p->shells[i].count, 1, &faces, p->face_count,
                             "shell", i);
    if (status == BATTEN_OK && (loops != p->loop_count || faces != p->face_count))
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d loop%s %s of no face, %d face%s of no shell",
                        p->loop_count - loops, bat_plural(p->loop_count - loops),
                        bat_one_or_many(p->loop_count - loops, "is", "are"),
                        p->face_count - faces, bat_plural(p->face_count - faces));
    return status;
}

/* ---- making ---- */

/* A copy of `count` items; also of none. */
static batten_status copy(const void *items, int count, size_t size, const void **out)
{
    void *copied = bat_array((size_t)count, size);
    if (!copied)
        return BATTEN_OUT_OF_MEMORY;
    if (count)
        memcpy(copied, items, (size_t)count * size);
    *out = copied;
    return BATTEN_OK;
}

#define COPY(field, count)                                                     \
    if (status == BATTEN_OK) {                                                 \
        const void *copied = NULL;                                             \
        status = copy(from->field, from->count, sizeof *from->field, &copied); \
        to->field = copied;                                                    \
    }

static batten_status copy_arrays(const batten_body_parts *from, batten_body_parts *to)
{
    batten_status status = BATTEN_OK;
    const void *vertices = NULL;
    COPY(edges, edge_count)
    COPY(uses, use_count)
    COPY(loops, loop_count)
    COPY(faces, face_count)
    COPY(shells, shell_count)
    if (status == BATTEN_OK)
        status = copy(from->vertices, from->vertex_count, 3 * sizeof(double), &vertices);
    to->vertices = vertices;
    return status;
}

/* The copied faces get names of their own; on failure those so far are given back. */
static batten_status copy_names(batten_body_parts *parts)
{
    batten_body_face *faces = (batten_body_face *)(uintptr_t)parts->faces;
    for (int i = 0; i < parts->face_count; i++) {
        const char *name = faces[i].name ? faces[i].name : "";
        char *copied = bat_array(strlen(name) + 1, 1);
        if (!copied) {
            while (i-- > 0)
                release_array(faces[i].name);
            return BATTEN_OUT_OF_MEMORY;
        }
        strcpy(copied, name);
        faces[i].name = copied;
    }
    return BATTEN_OK;
}

static void take_geometry(const batten_body_parts *parts)
{
    for (int i = 0; i < parts->edge_count; i++)
        if (parts->edges[i].curve)
            batten_curve_ref(parts->edges[i].curve);
    for (int i = 0; i < parts->use_count; i++)
        if (parts->uses[i].parameters)
            batten_curve_ref(parts->uses[i].parameters);
    for (int i = 0; i < parts->face_count; i++)
        batten_surface_ref(parts->faces[i].surface);
}

batten_status batten_body_create(const batten_body_parts *parts, batten_body **out)
{
    batten_status status = check_counts(parts);
    if (status == BATTEN_OK)
        status = check_edges(parts);
    if (status == BATTEN_OK)
        status = check_uses(parts);
    if (status == BATTEN_OK)
        status = check_loops(parts);
    if (status == BATTEN_OK)
        status = check_faces(parts);
    if (status != BATTEN_OK)
        return status;
    batten_body *body = bat_array(1, sizeof *body);
    if (!body)
        return BATTEN_OUT_OF_MEMORY;
    bat_references_begin(&body->references);
    bat_kept_box_begin(&body->box);
    body->parts = *parts;
    body->parts.vertices = NULL;
    body->parts.edges = NULL;
    body->parts.uses = NULL;
    body->parts.loops = NULL;
    body->parts.faces = NULL;
    body->parts.shells = NULL;
    status = copy_arrays(parts, &body->parts);
    if (status == BATTEN_OK)
        status = copy_names(&body->parts);
    if (status != BATTEN_OK) {
        drop_arrays(&body->parts);
        bat_release(body);
        return status;
    }
    take_geometry(&body->parts);
    *out = body;
    return BATTEN_OK;
}
