/* How smoothly the faces of a body continue across their common edges. */
#include "base/list.h"
#include "base/work.h"
#include "inspect/continuity.h"
#include "inspect/joins/walk.h"
#include "numeric/box.h"
#include "numeric/vector.h"
#include <batten/nearest.h>

/* A face beside an edge. */
typedef struct {
    int face;
    const batten_surface *surface;
    const batten_curve *parameters; /* or NULL */
    double inward;                  /* of tangent of the edge x Su x Sv: 1 or -1 */
} beside;

typedef struct {
    const batten_curve *curve;
    beside faces[2];
    bat_straight straight;
} common_edge;

/* The parameters of an edge on a face, which run as the edge does. */
static batten_status start_on_face(const common_edge *edge, const beside *face, double t,
                                   double uv[2])
{
    const batten_interval d = batten_curve_domain(edge->curve),
                          f = batten_curve_domain(face->parameters);
    const double share = (t - d.a) / (d.b - d.a);
    return batten_curve_evaluate(face->parameters, (1 - share) * f.a + share * f.b, 0, uv);
}

/* The face at the foot of a place of the edge. */
static batten_status look_from(const common_edge *edge, const beside *face, double t,
                               const double c[6], double at[3], bool *is_regular,
                               bat_across *across)
{
    const batten_vec3 tangent = bat_vec3_of(3, c + 3);
    double uv[2], s[BATTEN_SURFACE_DERIVATIVES(3) * 3];
    batten_deviation foot;
    batten_status status = face->parameters ? start_on_face(edge, face, t, uv) : BATTEN_OK;
    if (status == BATTEN_OK)
        status = batten_surface_project(face->surface, (batten_points){3, 1, c},
                                        face->parameters ? uv : NULL, NULL,
                                        (batten_feet){.uv = uv, .distances = NULL}, &foot);
    if (status == BATTEN_OK)
        status = batten_surface_evaluate(face->surface, uv[0], uv[1], 3, s);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < 3; k++)
        at[k] = s[k];
    const batten_vec3 normal = bat_vec3_cross(bat_vec3_of(3, s + 3), bat_vec3_of(3, s + 6));
    *is_regular = bat_across_edge(
        3, s, tangent, bat_vec3_scale(bat_vec3_cross(normal, tangent), face->inward), across);
    return BATTEN_OK;
}

/* Of a seam without parameters one foot is both sides: there only the gap is known. */
static batten_status meet_at(const void *context, int span, double t, bat_meeting *out)
{
    const common_edge *edge = context;
    const beside *f = edge->faces;
    double c[6], at[2][3];
    bool is_regular[2] = {false, false};
    bat_across across[2];
    (void)span;
    batten_status status = batten_curve_evaluate(edge->curve, t, 1, c);
    out->point = bat_vec3_of(3, c);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = look_from(edge, &f[k], t, c, at[k], &is_regular[k], &across[k]);
    if (status != BATTEN_OK)
        return status;
    out->gap = bat_distance(3, at[0], at[1]);
    if (is_regular[0] && is_regular[1] && (f[0].face != f[1].face || f[0].parameters))
        bat_meeting_compare(&across[0], &across[1], &edge->straight, out);
    return BATTEN_OK;
}

/* ---- all edges ---- */

/* The uses of an edge: the first two, and how many. */
typedef struct {
    int count;
    beside faces[2];
} used_edge;

static void list_uses(const batten_body_parts *p, used_edge *edges)
{
    for (int f = 0; f < p->face_count; f++)
        for (int l = p->faces[f].first; l < p->faces[f].first + p->faces[f].count; l++)
            for (int i = 0; i < p->loops[l].count; i++) {
                const batten_body_use *use = &p->uses[p->loops[l].first + i];
                used_edge *e = &edges[use->edge];
                const bool against = use->reversed != p->faces[f].reversed;
                if (e->count < 2)
                    e->faces[e->count] =
                        (beside){f, p->faces[f].surface, use->parameters, against ? -1 : 1};
                e->count++;
            }
}

static batten_status join_at(const batten_body_parts *p, int index, const used_edge *used,
                             const batten_curve_continuity_options *bounds, double size,
                             batten_join *join)
{
    const batten_curve *curve = p->edges[index].curve;
    const common_edge edge = {
        curve, {used->faces[0], used->faces[1]}, bat_straight_within(bounds->gap, size)};
    const int spans = batten_curve_spans(curve, NULL) - 1;
    double *breaks = bat_array((size_t)spans + 1, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, breaks);
    const bat_edge_walk walk = {meet_at, &edge, spans, breaks};
    *join = (batten_join){.shape = {used->faces[0].face, used->faces[1].face},
                          .side = {-1, -1},
                          .part = -1,
                          .edge = index,
                          .parametric = -1};
    const batten_status status = bat_follow_edge(&walk, bounds, join);
    bat_release(breaks);
    return status;
}

static batten_status visit_edges(const batten_body *body, const used_edge *edges,
                                 const batten_curve_continuity_options *bounds,
                                 const batten_job *job, batten_joins *out)
{
    const batten_body_parts *p = batten_body_view(body);
    const double size = bat_box_diagonal(batten_body_box(body));
    bat_work work = {.job = job};
    int room = 0;
    batten_status status = BATTEN_OK;
    for (int e = 0; e < p->edge_count && status == BATTEN_OK; e++) {
        batten_join join;
        status = bat_work_step(&work, 1, (double)e / p->edge_count, "comparing faces");
        if (status != BATTEN_OK || !p->edges[e].curve || edges[e].count != 2)
            continue;
        status = join_at(p, e, &edges[e], bounds, size, &join);
        if (status == BATTEN_OK)
            status = BAT_LIST_ADD(out->at, out->count, room, join);
    }
    return status;
}

batten_status batten_body_joins(const batten_body *body,
                                const batten_curve_continuity_options *options,
                                const batten_job *job, batten_joins *out)
{
    assert(body && out);
    const batten_body_parts *p = batten_body_view(body);
    batten_curve_continuity_options bounds;
    batten_joins found = {0, NULL, false};
    batten_status status = bat_continuity_bounds(options, &bounds);
    if (status != BATTEN_OK)
        return status;
    if (!(bounds.gap > 0))
        bounds.gap = p->tolerance;
    used_edge *edges = bat_array((size_t)p->edge_count + 1, sizeof *edges);
    if (!edges)
        return BATTEN_OUT_OF_MEMORY;
    for (int e = 0; e < p->edge_count; e++)
        edges[e] = (used_edge){.count = 0};
    list_uses(p, edges);
    status = visit_edges(body, edges, &bounds, job, &found);
    bat_release(edges);
    if (status == BATTEN_OK)
        *out = found;
    else
        bat_release(found.at);
    return status;
}
