/*
 * Bodies whole: 186 of shells, 514, of faces, 510, within loops, 508, which share the edges and
 * vertices of two lists, 504 and 502. A loop runs around the normal of its surface, so those of
 * a face with its outside against the normal are turned, and the shell says which these are.
 */
#include "exchange/iges/write/writing.h"
#include "exchange/shapes/prepare.h"

#include <string.h>

static const bat_iges_look part = {.is_part = true};
static const bat_iges_look parameters = {.is_part = true, .use = 5};

typedef struct {
    bat_iges_writing *w;
    const batten_body_parts *p;
    int lists[2];    /* the ids: of vertices, of edges */
    int *numbers[2]; /* of each vertex and edge in its list, from 1; 0: in none */
    int *order[2];   /* the other way round: [from 0] */
    int counts[2];   /* that are in them */
    int *curves, *loops, *faces, *flat; /* ids; [edges], [loops], [faces], [uses] */
} whole;

enum { VERTICES, EDGES };

static void end_part(bat_iges_writing *w, int type, int form)
{
    bat_iges_look look = part;
    look.type = type;
    look.form = form;
    bat_iges_put_properties(w, 0);
    bat_iges_end_entity(w, &look);
}

/* ---- lists, in the order in which loops come by, as a reader has it ---- */

static void meet(whole *of, int list, int index)
{
    if (of->numbers[list][index])
        return;
    of->order[list][of->counts[list]++] = index;
    of->numbers[list][index] = of->counts[list];
}

static const batten_body_use *use_from(const whole *of, const batten_body_loop *loop, int i,
                                       bool turned)
{
    return &of->p->uses[loop->first + (turned ? loop->count - 1 - i : i)];
}

/* Loops begin with an edge that is no point: those that are do not come back where they were.
 */
static const batten_body_use *use_at(const whole *of, const batten_body_loop *loop, int i,
                                     bool turned)
{
    int start = 0;
    while (start < loop->count && !of->p->edges[use_from(of, loop, start, turned)->edge].curve)
        start++;
    return use_from(of, loop, (start + i) % loop->count, turned);
}

static void meet_loop(whole *of, const batten_body_loop *loop, bool turned)
{
    for (int i = 0; i < loop->count; i++) {
        const int edge = use_at(of, loop, i, turned)->edge;
        const int *ends = of->p->edges[edge].vertices;
        if (of->p->edges[edge].curve)
            meet(of, EDGES, edge);
        meet(of, VERTICES, ends[0]);
        meet(of, VERTICES, ends[1]);
    }
}

static void meet_faces(whole *of, int first, int count)
{
    for (int f = first; f < first + count; f++) {
        const batten_body_face *face = &of->p->faces[f];
        for (int l = face->first; l < face->first + face->count; l++)
            meet_loop(of, &of->p->loops[l], face->reversed);
    }
}

static void put_vertices(whole *of)
{
    bat_iges_writing *w = of->w;
    of->lists[VERTICES] = bat_iges_begin_entity(w, 502);
    bat_iges_put_integer(&w->data, of->counts[VERTICES], ',');
    for (int i = 0; i < of->counts[VERTICES]; i++)
        for (int k = 0; k < 3; k++)
            bat_iges_put_real(&w->data, of->p->vertices[3 * of->order[VERTICES][i] + k], ',');
    end_part(w, 502, 1);
}

static batten_status put_edge_curve(whole *of, int i)
{
    batten_curve *curve = NULL;
    batten_status status =
        bat_iges_meet_vertices(of->w, of->p, &of->p->edges[of->order[EDGES][i]], &curve);
    if (status == BATTEN_OK) {
        of->curves[i] = bat_iges_put_curve(of->w, curve, 0, part);
        status = bat_iges_check_room(of->w);
    }
    batten_curve_unref(curve);
    return status;
}

static batten_status put_curves(whole *of)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < of->counts[EDGES]; i++)
        status = put_edge_curve(of, i);
    return status;
}

/* Its curve, and the list and number of the vertex at each end. */
static void put_edge(whole *of, int i)
{
    bat_iges_writing *w = of->w;
    const int *ends = of->p->edges[of->order[EDGES][i]].vertices;
    bat_iges_put_integer(&w->data, of->curves[i], ',');
    for (int end = 0; end < 2; end++) {
        bat_iges_put_integer(&w->data, of->lists[VERTICES], ',');
        bat_iges_put_integer(&w->data, of->numbers[VERTICES][ends[end]], ',');
    }
}

static batten_status put_edges(whole *of)
{
    bat_iges_writing *w = of->w;
    batten_status status = put_curves(of);
    if (status != BATTEN_OK || of->counts[EDGES] == 0)
        return status;
    of->lists[EDGES] = bat_iges_begin_entity(w, 504);
    bat_iges_put_integer(&w->data, of->counts[EDGES], ',');
    for (int i = 0; i < of->counts[EDGES]; i++)
        put_edge(of, i);
    end_part(w, 504, 1);
    return BATTEN_OK;
}

/* ---- loops, faces, shells ---- */

static batten_status put_flat_use(whole *of, int i)
{
    const batten_body_use *use = &of->p->uses[i];
    batten_curve *clamped = NULL;
    if (!use->parameters || !of->numbers[EDGES][use->edge])
        return BATTEN_OK;
    batten_status status = batten_curve_clamp(use->parameters, &clamped);
    if (status == BATTEN_OK)
        of->flat[i] = bat_iges_put_curve(of->w, clamped, 0, parameters);
    batten_curve_unref(clamped);
    return status;
}

/* The curves in (u, v) of a loop, which run as the edges do. */
static batten_status put_flat(whole *of, const batten_body_loop *loop)
{
    batten_status status = BATTEN_OK;
    for (int i = loop->first; status == BATTEN_OK && i < loop->first + loop->count; i++)
        status = put_flat_use(of, i);
    return status;
}

/* An edge, and whether the loop goes along it, and its curve in (u, v); or a vertex, at a pole.
 */
static void put_use(const whole *of, const batten_body_use *use, bool turned)
{
    const int number = of->numbers[EDGES][use->edge], flat = of->flat[use - of->p->uses];
    const int vertex = of->numbers[VERTICES][of->p->edges[use->edge].vertices[0]];
    const int values[] = {number == 0,
                          of->lists[number ? EDGES : VERTICES],
                          number ? number : vertex,
                          number == 0 || use->reversed == turned,
                          flat != 0,
                          0,
                          flat};
    for (int k = 0; k < (flat ? 7 : 5); k++)
        bat_iges_put_integer(&of->w->data, values[k], ',');
}

static batten_status put_loop(whole *of, const batten_body_loop *loop, bool turned, int *id)
{
    const batten_status status = put_flat(of, loop);
    if (status != BATTEN_OK)
        return status;
    *id = bat_iges_begin_entity(of->w, 508);
    bat_iges_put_integer(&of->w->data, loop->count, ',');
    for (int i = 0; i < loop->count; i++)
        put_use(of, use_at(of, loop, i, turned), turned);
    end_part(of->w, 508, 1);
    return BATTEN_OK;
}

/* The face's own look: a part of the body, in its colour if it has one. */
static batten_status put_face(whole *of, int number, const bat_iges_look *body, int *id)
{
    bat_iges_writing *w = of->w;
    const batten_body_face *face = &of->p->faces[number];
    const batten_object object = {.name = face->name, .surface = face->surface};
    batten_surface *surface = NULL;
    batten_status status = bat_prepare_surface(&object, w->tolerance, w->notes, &surface);
    if (status != BATTEN_OK)
        return status;
    bat_iges_look look = *body;
    look.type = 510;
    look.form = 1;
    look.is_part = true;
    if (face->has_colour)
        look.colour = bat_iges_put_colour(w, face->colour);
    const int base = bat_iges_put_surface(w, surface, 0, part);
    const int name = bat_iges_put_name(w, face->name);
    for (int l = 0; status == BATTEN_OK && l < face->count; l++)
        status = put_loop(of, &of->p->loops[face->first + l], face->reversed, &of->loops[l]);
    batten_surface_unref(surface);
    if (status != BATTEN_OK)
        return status;
    *id = bat_iges_begin_entity(w, 510);
    bat_iges_put_integer(&w->data, base, ',');
    bat_iges_put_integer(&w->data, face->count, ',');
    bat_iges_put_integer(&w->data, face->count > 0, ','); /* the first is the outer one */
    for (int l = 0; l < face->count; l++)
        bat_iges_put_integer(&w->data, of->loops[l], ',');
    bat_iges_put_properties(w, name);
    bat_iges_end_entity(w, &look);
    return bat_iges_check_room(w);
}

static batten_status put_shell(whole *of, const batten_body_shell *shell, int name,
                               const bat_iges_look *body, bool is_part, int *id)
{
    bat_iges_writing *w = of->w;
    batten_status status = BATTEN_OK;
    for (int f = 0; status == BATTEN_OK && f < shell->count; f++)
        status = put_face(of, shell->first + f, body, &of->faces[f]);
    if (status != BATTEN_OK)
        return status;
    bat_iges_look look = *body;
    look.type = 514;
    look.form = shell->closed ? 1 : 2;
    look.is_part = is_part || body->is_part;
    *id = bat_iges_begin_entity(w, 514);
    bat_iges_put_integer(&w->data, shell->count, ',');
    for (int f = 0; f < shell->count; f++) {
        bat_iges_put_integer(&w->data, of->faces[f], ',');
        bat_iges_put_integer(&w->data, !of->p->faces[shell->first + f].reversed, ',');
    }
    bat_iges_put_properties(w, name);
    bat_iges_end_entity(w, &look);
    return BATTEN_OK;
}

/* The first shell bounds it; the others are voids, with their outside in them. */
static batten_status put_solid(whole *of, int name, const bat_iges_look *look, int *id)
{
    bat_iges_writing *w = of->w;
    const int count = of->p->shell_count;
    int *shells = bat_array((size_t)count, sizeof *shells);
    batten_status status = shells ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int s = 0; status == BATTEN_OK && s < count; s++)
        status = put_shell(of, &of->p->shells[s], 0, look, true, &shells[s]);
    if (status == BATTEN_OK) {
        bat_iges_look solid = *look;
        solid.type = 186;
        *id = bat_iges_begin_entity(w, 186);
        for (int s = 0; s < count; s++) {
            bat_iges_put_integer(&w->data, shells[s], ',');
            bat_iges_put_integer(&w->data, 1, ',');
            if (s == 0)
                bat_iges_put_integer(&w->data, count - 1, ',');
        }
        bat_iges_put_properties(w, name);
        bat_iges_end_entity(w, &solid);
    }
    bat_release(shells);
    return status;
}

/* ---- bodies ---- */

static batten_status begin_body(bat_iges_writing *w, const batten_body_parts *parts, whole *of,
                                int **memory)
{
    const size_t counts[2] = {(size_t)parts->vertex_count, (size_t)parts->edge_count};
    const size_t loops = (size_t)parts->loop_count, faces = (size_t)parts->face_count;
    int *next = bat_array(
        2 * counts[0] + 3 * counts[1] + loops + faces + (size_t)parts->use_count, sizeof *next);
    *of = (whole){.w = w, .p = parts};
    *memory = next;
    if (!next)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < 2; k++) {
        of->numbers[k] = next;
        of->order[k] = next + counts[k];
        next += 2 * counts[k];
    }
    of->curves = next;
    of->loops = of->curves + counts[1];
    of->faces = of->loops + loops;
    of->flat = of->faces + faces;
    return BATTEN_OK;
}

/* The lists of what some faces have. */
static batten_status put_lists(whole *of, int first, int count)
{
    meet_faces(of, first, count);
    if (of->counts[VERTICES] > 0)
        put_vertices(of);
    return put_edges(of);
}

/* Shells of no solid are bodies of their own to a reader. */
static batten_status put_sheet(whole *of, const batten_body_shell *shell, const char *name,
                               const bat_iges_look *look, int *id)
{
    const int named = bat_iges_put_name(of->w, name);
    memset(of->numbers[VERTICES], 0, (size_t)of->p->vertex_count * sizeof(int));
    memset(of->numbers[EDGES], 0, (size_t)of->p->edge_count * sizeof(int));
    of->counts[VERTICES] = of->counts[EDGES] = 0;
    const batten_status status = put_lists(of, shell->first, shell->count);
    return status == BATTEN_OK ? put_shell(of, shell, named, look, false, id) : status;
}

batten_status bat_iges_put_body(bat_iges_writing *w, const batten_body_parts *parts,
                                const char *name, const bat_iges_look *look,
                                bat_iges_keep *keep, void *context)
{
    whole of;
    int *memory = NULL, id = 0;
    batten_status status = begin_body(w, parts, &of, &memory);
    if (status == BATTEN_OK && parts->is_solid) {
        const int named = bat_iges_put_name(w, name);
        status = put_lists(&of, 0, parts->face_count);
        if (status == BATTEN_OK)
            status = put_solid(&of, named, look, &id);
        if (status == BATTEN_OK)
            status = keep(context, id);
    }
    for (int s = 0; status == BATTEN_OK && !parts->is_solid && s < parts->shell_count; s++) {
        status = put_sheet(&of, &parts->shells[s], name, look, &id);
        if (status == BATTEN_OK)
            status = keep(context, id);
    }
    bat_release(memory);
    return status;
}
