/* How a blend joins its surfaces, and whether it folds. */
#include "shape/surface_change/blend.h"

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

static batten_status compare(const bat_blend_contact *t, const batten_surface *made, int side,
                             double u)
{
    batten_surfaces_blend_report *r = t->report;
    const batten_surface *surface = t->surfaces[side];
    const batten_surface_blend_end *end = &t->ends[side];
    const bat_edge_place place = bat_edge_of(surface, end->edge);
    const batten_interval d = batten_surface_domain(surface, place.along);
    const double share = side && r->reversed ? 1 - u : u;
    const double on = (1 - share) * end->from + share * end->to;
    const bool along_u = place.along == BATTEN_U;
    const double along = bat_min(bat_max((1 - on) * d.a + on * d.b, d.a), d.b);
    const double at[2] = {along_u ? along : place.at, along_u ? place.at : along};
    const double own[2] = {u, side};
    double mine[9], theirs[3], kappa[2];
    batten_vec3 n[2];
    batten_status status = batten_surface_evaluate(made, own[0], own[1], 1, mine);
    if (status == BATTEN_OK)
        status = batten_surface_evaluate(surface, at[0], at[1], 0, theirs);
    if (status != BATTEN_OK)
        return status;
    r->gap[side] = bat_max(r->gap[side], bat_distance(3, mine, theirs));
    const batten_vec3 way = bat_vec3_of(3, mine + 6);
    bool there = true;
    status = curvature_along(made, own, way, &n[0], &kappa[0], &there);
    if (status == BATTEN_OK)
        status = curvature_along(surface, at, way, &n[1], &kappa[1], &there);
    if (status != BATTEN_OK)
        return status;
    if (!there) {
        r->angle[side] = r->curvature[side] = HUGE_VAL;
        return BATTEN_OK;
    }
    const double dot = bat_vec3_dot(n[0], n[1]);
    const double sine = bat_vec3_norm(bat_vec3_cross(n[0], n[1]));
    r->angle[side] = bat_max(r->angle[side], bat_atan2(sine, fabs(dot)));
    r->curvature[side] =
        bat_max(r->curvature[side], fabs(kappa[0] - (dot < 0 ? -kappa[1] : kappa[1])));
    return BATTEN_OK;
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
    batten_status status = BATTEN_OK;
    for (int i = 0; i < SAMPLES; i++)
        at[i] = (double)i / (SAMPLES - 1);
    for (int i = 0; i < 2 * SAMPLES && status == BATTEN_OK; i++)
        status = compare(t, made, i / SAMPLES, at[i % SAMPLES]);
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
