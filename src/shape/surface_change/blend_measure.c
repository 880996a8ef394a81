/* How a blend joins its surfaces, and whether it folds. */
#include "shape/surface_change/blend.h"

#include "numeric/peaks.h"
#include "numeric/vector.h"
#include "shape/boundary/edge_fit.h"
#include <batten/curvature.h>

enum { SAMPLES = 33 };

/* The normal curvature of a surface in the direction of a tangent; false without a normal. */
static batten_status curvature_along(const batten_surface *surface, const double at[2],
                                     batten_vec3 way, batten_vec3 *normal, double *kappa,
                                     bool *there)
{
    batten_surface_local local;
    const batten_status status = batten_surface_local_at(surface, at[0], at[1], &local);
    *there = *there && status == BATTEN_OK;
    if (status != BATTEN_OK)
        return status == BATTEN_SINGULAR_HERE ? BATTEN_OK : status;
    const double norm = bat_vec3_norm(way);
    const double c = bat_vec3_dot(way, local.direction1) / norm;
    const double s = bat_vec3_dot(way, local.direction2) / norm;
    *normal = local.normal;
    *kappa = (local.kappa1 * c * c + local.kappa2 * s * s) / (c * c + s * s);
    return BATTEN_OK;
}

/* One side of a blend that was made. */
typedef struct {
    const bat_blend_contact *contact;
    const batten_surface *made;
    int side;
} blend_side;

/* Where u of the blend is on the surface that it leaves. */
static void find_contact(const blend_side *s, double u, double at[2])
{
    const bat_blend_contact *t = s->contact;
    const batten_surface_blend_end *end = &t->ends[s->side];
    const bat_edge_place place = bat_edge_of(t->surfaces[s->side], end->edge);
    const batten_interval d = batten_surface_domain(t->surfaces[s->side], place.along);
    const double share = s->side && t->report->reversed ? 1 - u : u;
    const double on = (1 - share) * end->from + share * end->to;
    const bool along_u = place.along == BATTEN_U;
    const double along = bat_min(bat_max((1 - on) * d.a + on * d.b, d.a), d.b);
    at[0] = along_u ? along : place.at;
    at[1] = along_u ? place.at : along;
}

/* The gap, the angle of the normals, and the jump of the curvature across at u. */
static batten_status compare_at(void *context, double u, double *values)
{
    const blend_side *s = context;
    const batten_surface *surface = s->contact->surfaces[s->side];
    const double own[2] = {u, s->side};
    double at[2], mine[9], theirs[3], kappa[2];
    batten_vec3 n[2];
    find_contact(s, u, at);
    batten_status status = batten_surface_evaluate(s->made, own[0], own[1], 1, mine);
    if (status == BATTEN_OK)
        status = batten_surface_evaluate(surface, at[0], at[1], 0, theirs);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 way = bat_vec3_of(3, mine + 6);
    bool there = true;
    status = curvature_along(s->made, own, way, &n[0], &kappa[0], &there);
    if (status == BATTEN_OK)
        status = curvature_along(surface, at, way, &n[1], &kappa[1], &there);
    if (status != BATTEN_OK)
        return status;
    values[0] = bat_distance(3, mine, theirs);
    values[1] = values[2] = HUGE_VAL;
    if (!there)
        return BATTEN_OK;
    const double dot = bat_vec3_dot(n[0], n[1]);
    const double sine = bat_vec3_norm(bat_vec3_cross(n[0], n[1]));
    values[1] = bat_atan2(sine, fabs(dot));
    values[2] = fabs(kappa[0] - (dot < 0 ? -kappa[1] : kappa[1]));
    return BATTEN_OK;
}

/* Along u, at least so many places in each span of the edge. */
enum { PLACES = 8 };

static batten_status compare_sides(const bat_blend_contact *t, const batten_surface *made)
{
    batten_surfaces_blend_report *r = t->report;
    const int spans = batten_surface_spans(made, BATTEN_U, NULL) - 1;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        blend_side side = {t, made, k};
        double largest[3];
        status = bat_find_peaks(compare_at, &side, bat_max_int(SAMPLES, PLACES * spans + 1), 3,
                                largest);
        if (status != BATTEN_OK)
            break;
        r->gap[k] = largest[0];
        r->angle[k] = largest[1];
        r->curvature[k] = largest[2];
    }
    return status;
}

/* Along one line of the grid: the first place where the normal turns over, from the last one
 * before it that there is; -1 for none. */
static int fold_on_line(const double *normals, int step)
{
    const double *last = NULL;
    for (int i = 0; i < SAMPLES; i++) {
        const double *n = normals + 3 * i * step;
        if (last && bat_dot(3, n, last) < 0)
            return i;
        if (bat_dot(3, n, n) > 0)
            last = n;
    }
    return -1;
}

static void find_fold(const double *normals, const double *at, batten_surfaces_blend_report *r)
{
    for (int i = 0; i < SAMPLES && !r->folded; i++) {
        const int v = fold_on_line(normals + 3 * i * SAMPLES, 1);
        const int u = v < 0 ? fold_on_line(normals + 3 * i, SAMPLES) : i;
        r->folded = u >= 0;
        if (!r->folded)
            continue;
        r->fold[0] = at[u];
        r->fold[1] = at[v < 0 ? i : v];
    }
}

batten_status bat_blend_measure(const bat_blend_contact *t, const batten_surface *made)
{
    double at[SAMPLES];
    batten_status status = compare_sides(t, made);
    for (int i = 0; i < SAMPLES; i++)
        at[i] = (double)i / (SAMPLES - 1);
    if (status != BATTEN_OK)
        return status;
    /* A fifth above the error of the edges, which is sampled; and the rounding of a rational blend. */
    const double far = bat_max(t->report->gap[0], t->report->gap[1]);
    if (far > 1.2 * t->report->error + 1e-11 * t->size)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the blend misses an edge by %g", far);
    double *normals = bat_array3(SAMPLES, SAMPLES, 3 * sizeof *normals);
    if (!normals)
        return BATTEN_OUT_OF_MEMORY;
    status = batten_surface_normal_grid(made, (batten_uv_grid){SAMPLES, SAMPLES, at, at}, NULL,
                                        NULL, normals);
    if (status == BATTEN_OK)
        find_fold(normals, at, t->report);
    bat_release(normals);
    return status;
}
