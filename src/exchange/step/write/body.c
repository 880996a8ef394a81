/*
 * Bodies as STEP has them: first the surfaces, then the edges, each once however many faces
 * share it, with its curves in the parameters of the surfaces; then faces and shells.
 */
#include "exchange/shapes/prepare.h"
#include "exchange/step/step.h"

#include <string.h>

typedef struct {
    bat_step *step;
    const batten_body_parts *parts;
    int *memory;             /* holds the arrays below */
    int *surfaces, *nets;    /* [face_count] ids of the surface and of its first point */
    int *vertices, *edges;   /* ids of each; 0 while not written, and of poles */
    int *owners;             /* [use_count] the face */
    int *loops;              /* [loop_count] ids */
    int (*uses)[2];          /* [edge_count] of the edge, plus 1; 0 for none; one that runs as
                                the edge does comes first */
    batten_surface **shapes; /* [face_count] */
} writing;

static batten_status begin_body(writing *w)
{
    const batten_body_parts *p = w->parts;
    const size_t faces = (size_t)p->face_count, edges = (size_t)p->edge_count;
    w->memory = bat_array(2 * faces + (size_t)p->vertex_count + 3 * edges +
                              (size_t)p->use_count + (size_t)p->loop_count,
                          sizeof *w->memory);
    w->shapes = bat_array(faces, sizeof *w->shapes);
    if (!w->memory || !w->shapes)
        return BATTEN_OUT_OF_MEMORY;
    w->uses = (int(*)[2])w->memory;
    w->edges = w->memory + 2 * edges;
    w->surfaces = w->edges + edges;
    w->nets = w->surfaces + faces;
    w->vertices = w->nets + faces;
    w->owners = w->vertices + p->vertex_count;
    w->loops = w->owners + p->use_count;
    return BATTEN_OK;
}

static void end_body(writing *w)
{
    for (int i = 0; w->shapes && i < w->parts->face_count; i++)
        batten_surface_unref(w->shapes[i]);
    bat_release(w->shapes);
    bat_release(w->memory);
}

/* Who uses what. */
static void gather_uses(writing *w)
{
    const batten_body_parts *p = w->parts;
    for (int f = 0; f < p->face_count; f++)
        for (int l = 0; l < p->faces[f].count; l++) {
            const batten_body_loop *loop = &p->loops[p->faces[f].first + l];
            for (int u = loop->first; u < loop->first + loop->count; u++)
                w->owners[u] = f;
        }
    for (int u = 0; u < p->use_count; u++) {
        int *uses = w->uses[p->uses[u].edge];
        if (!uses[0])
            uses[0] = u + 1;
        else if (!uses[1])
            uses[1] = u + 1;
    }
    for (int e = 0; e < p->edge_count; e++) {
        int *uses = w->uses[e];
        if (uses[1] && p->uses[uses[0] - 1].reversed && !p->uses[uses[1] - 1].reversed) {
            const int other = uses[0];
            uses[0] = uses[1];
            uses[1] = other;
        }
    }
}

static batten_status put_surfaces(writing *w)
{
    bat_step *step = w->step;
    batten_status status = BATTEN_OK;
    for (int f = 0; status == BATTEN_OK && f < w->parts->face_count; f++) {
        const batten_body_face *face = &w->parts->faces[f];
        const batten_object object = {.name = face->name, .surface = face->surface};
        status = bat_prepare_surface(&object, step->tolerance, step->notes, &w->shapes[f]);
        if (status != BATTEN_OK)
            break;
        const batten_surface *shape = w->shapes[f];
        const size_t count = (size_t)batten_surface_point_count(shape, BATTEN_U) *
                             (size_t)batten_surface_point_count(shape, BATTEN_V);
        w->nets[f] = bat_step_points(step, 3, batten_surface_points(shape), count);
        w->surfaces[f] = bat_step_surface(step, face->name, shape, w->nets[f]);
    }
    return status;
}

/* ---- edges ---- */

/* Are the points of the curve those of the net from `first` on, `stride` apart? */
static bool is_row(const batten_curve *curve, const double *net, int first, int stride)
{
    const double *points = batten_curve_points(curve);
    const int count = batten_curve_point_count(curve);
    for (int i = 0; i < count; i++)
        if (memcmp(&points[3 * (size_t)i], &net[3 * (ptrdiff_t)(first + i * stride)],
                   3 * sizeof *net) != 0)
            return false;
    return true;
}

/* The border of the net that the curve has its points from. */
static bool find_row(const batten_surface *surface, int net, const batten_curve *curve,
                     bat_step_row *row)
{
    const double *points = batten_surface_points(surface);
    const int count_u = batten_surface_point_count(surface, BATTEN_U);
    const int count_v = batten_surface_point_count(surface, BATTEN_V);
    const int last = (count_u - 1) * count_v, count = batten_curve_point_count(curve);
    const struct {
        int count, first, step;
    } sides[] = {{count_u, 0, count_v},
                 {count_v, last, 1},
                 {count_u, count_v - 1, count_v},
                 {count_v, 0, 1}};
    for (int k = 0; k < 8; k++) {
        const bool back = k >= 4;
        const int step = back ? -sides[k % 4].step : sides[k % 4].step;
        const int first =
            sides[k % 4].first + (back ? (sides[k % 4].count - 1) * sides[k % 4].step : 0);
        if (count != sides[k % 4].count || !is_row(curve, points, first, step))
            continue;
        *row = (bat_step_row){net + first, step};
        return true;
    }
    return false;
}

static int put_parameter_curve(bat_step *step, int surface, const batten_curve *curve)
{
    if (!step->plane_context)
        step->plane_context =
            bat_step_add(step, "",
                         "GEOMETRIC_REPRESENTATION_CONTEXT(2) "
                         "PARAMETRIC_REPRESENTATION_CONTEXT() REPRESENTATION_CONTEXT('2D','')");
    const int id = bat_step_curve(step, "", curve, NULL);
    const int definition = bat_step_add(step, "DEFINITIONAL_REPRESENTATION", "'',(#%d),#%d", id,
                                        step->plane_context);
    return bat_step_add(step, "PCURVE", "'',#%d,#%d", surface, definition);
}

/* The curve with those in the parameters of its faces: the id of what the edge refers to. */
static batten_status put_with_parameters(writing *w, int e, int *id)
{
    const batten_body_parts *p = w->parts;
    int curves[2], count = 0;
    for (int k = 0; k < 2 && w->uses[e][k]; k++) {
        const int use = w->uses[e][k] - 1;
        batten_curve *clamped = NULL;
        if (!p->uses[use].parameters)
            continue;
        const batten_status status = batten_curve_clamp(p->uses[use].parameters, &clamped);
        if (status != BATTEN_OK)
            return status;
        curves[count++] = put_parameter_curve(w->step, w->surfaces[w->owners[use]], clamped);
        batten_curve_unref(clamped);
    }
    if (count == 0)
        return BATTEN_OK;
    const bool seam =
        count == 2 && w->owners[w->uses[e][0] - 1] == w->owners[w->uses[e][1] - 1];
    const int space = *id;
    *id = bat_step_open(w->step, seam ? "SEAM_CURVE" : "SURFACE_CURVE");
    bat_step_token(w->step, "'',");
    bat_step_id(w->step, space, ",(");
    bat_step_ids(w->step, curves, count, "),.CURVE_3D.");
    bat_step_close(w->step);
    return BATTEN_OK;
}

static int vertex_id(writing *w, int vertex)
{
    if (!w->vertices[vertex]) {
        const int point = bat_step_point(w->step, 3, &w->parts->vertices[3 * (size_t)vertex]);
        w->vertices[vertex] = bat_step_add(w->step, "VERTEX_POINT", "'',#%d", point);
    }
    return w->vertices[vertex];
}

static batten_status put_edge(writing *w, int e)
{
    const batten_body_edge *edge = &w->parts->edges[e];
    const batten_object object = {.name = "", .curve = edge->curve};
    batten_curve *curve = NULL;
    bat_step_row row;
    bool found = false;
    const int start = vertex_id(w, edge->vertices[0]), stop = vertex_id(w, edge->vertices[1]);
    batten_status status = bat_prepare_curve(&object, &curve);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < 2 && !found && w->uses[e][k]; k++) {
        const int f = w->owners[w->uses[e][k] - 1];
        found = find_row(w->shapes[f], w->nets[f], curve, &row);
    }
    int id = bat_step_curve(w->step, "", curve, found ? &row : NULL);
    batten_curve_unref(curve);
    if (w->step->has_parameter_curves)
        status = put_with_parameters(w, e, &id);
    w->edges[e] = bat_step_add(w->step, "EDGE_CURVE", "'',#%d,#%d,#%d,.T.", start, stop, id);
    return status;
}

/* In the order of their first use, as readers meet them. */
static batten_status put_edges(writing *w)
{
    const batten_body_parts *p = w->parts;
    batten_status status = BATTEN_OK;
    for (int u = 0; status == BATTEN_OK && u < p->use_count; u++) {
        const int e = p->uses[u].edge;
        if (p->edges[e].curve && !w->edges[e])
            status = put_edge(w, e);
    }
    return status;
}

/* ---- faces ---- */

/* The id of the loop; of one that is a point, when it bounds nothing else, 0. */
static int put_loop(writing *w, const batten_body_loop *loop, bool alone)
{
    bat_step *step = w->step;
    const batten_body_use *uses = &w->parts->uses[loop->first];
    int count = 0;
    for (int i = 0; i < loop->count; i++)
        count += w->edges[uses[i].edge] != 0;
    if (count == 0) {
        const int vertex = w->parts->edges[uses[0].edge].vertices[0];
        return alone ? 0 : bat_step_add(step, "VERTEX_LOOP", "'',#%d", vertex_id(w, vertex));
    }
    const int first = step->count + 1;
    for (int i = 0; i < loop->count; i++)
        if (w->edges[uses[i].edge])
            bat_step_add(step, "ORIENTED_EDGE", "'',*,*,#%d,%s", w->edges[uses[i].edge],
                         uses[i].reversed ? ".F." : ".T.");
    const int id = bat_step_open(step, "EDGE_LOOP");
    bat_step_token(step, "'',(");
    bat_step_range(step, first, count, ")");
    bat_step_close(step);
    return id;
}

/* The id of the face, 0 when it has no border: then it is left out. */
static int put_face(writing *w, int f)
{
    bat_step *step = w->step;
    const batten_body_face *face = &w->parts->faces[f];
    int *loops = &w->loops[face->first];
    for (int l = 0; l < face->count; l++)
        loops[l] = put_loop(w, &w->parts->loops[face->first + l], face->count == 1);
    if (face->count == 0 || !loops[0]) {
        batten_notes_add(step->notes, "", 0, face->name,
                         "face %d: the border of the surface is one point; left out", f + 1);
        return 0;
    }
    /* The first loop is known to be the outer one when it is alone, or the body traced. */
    const bool outer = face->count == 1 || w->parts->is_traced;
    const int first = step->count + 1;
    for (int l = 0; l < face->count; l++)
        bat_step_add(step, l == 0 && outer ? "FACE_OUTER_BOUND" : "FACE_BOUND", "'',#%d,.T.",
                     loops[l]);
    const int id = bat_step_open(step, "ADVANCED_FACE");
    bat_step_string(step, face->name, ",(");
    bat_step_range(step, first, face->count, "),");
    bat_step_id(step, w->surfaces[f], face->reversed ? ",.F." : ",.T.");
    bat_step_close(step);
    return id;
}

/* ---- shells ---- */

static int put_shell(bat_step *step, const char *name, const batten_body_shell *shell,
                     bool closed, const int *faces)
{
    int first = 0;
    for (int i = shell->first; i < shell->first + shell->count; i++)
        first = first ? first : faces[i];
    if (!first)
        return 0;
    const int id = bat_step_open(step, closed ? "CLOSED_SHELL" : "OPEN_SHELL");
    bat_step_string(step, name, ",(");
    bool any = false;
    for (int i = shell->first; i < shell->first + shell->count; i++) {
        if (!faces[i])
            continue;
        if (any)
            bat_step_token(step, ",");
        bat_step_id(step, faces[i], "");
        any = true;
    }
    bat_step_token(step, ")");
    bat_step_close(step);
    return id;
}

/* A solid of its outer shell and voids, whose sides are away from the material already. */
static int put_solid(bat_step *step, const char *name, const int *shells, int count)
{
    const int first = step->count + 1;
    for (int i = 1; i < count; i++)
        bat_step_add(step, "ORIENTED_CLOSED_SHELL", "'',*,#%d,.T.", shells[i]);
    const int id = bat_step_open(step, count > 1 ? "BREP_WITH_VOIDS" : "MANIFOLD_SOLID_BREP");
    bat_step_string(step, name, ",");
    bat_step_id(step, shells[0], count > 1 ? ",(" : "");
    bat_step_range(step, first, count - 1, ")");
    bat_step_close(step);
    return id;
}

static batten_status put_shells(writing *w, const char *name, const int *faces, int *out)
{
    const batten_body_parts *p = w->parts;
    int *shells = bat_array((size_t)p->shell_count, sizeof *shells), count = 0, missing = 0;
    if (!shells)
        return BATTEN_OUT_OF_MEMORY;
    for (int f = 0; f < p->face_count; f++)
        missing += !faces[f];
    for (int i = 0; i < p->shell_count; i++) {
        const bool closed = (p->is_solid || p->shells[i].closed) && !missing;
        const int id = put_shell(w->step, name, &p->shells[i], closed, faces);
        if (id)
            shells[count++] = id;
    }
    if (count == 0)
        *out = 0;
    else if (p->is_solid && !missing)
        *out = put_solid(w->step, name, shells, count);
    else
        *out = bat_step_list(w->step, "SHELL_BASED_SURFACE_MODEL", name, shells, count);
    bat_release(shells);
    return BATTEN_OK;
}

batten_status bat_step_body(bat_step *step, const char *name, const batten_body *body,
                            int *faces, int *out)
{
    writing w = {.step = step, .parts = batten_body_view(body)};
    batten_status status = begin_body(&w);
    if (status == BATTEN_OK) {
        gather_uses(&w);
        status = put_surfaces(&w);
    }
    if (status == BATTEN_OK)
        status = put_edges(&w);
    if (status == BATTEN_OK) {
        for (int f = 0; f < w.parts->face_count; f++)
            faces[f] = put_face(&w, f);
        status = put_shells(&w, name, faces, out);
    }
    end_body(&w);
    return status;
}
