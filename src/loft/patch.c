/* The patch of a lofting: its basis, its derivatives and its normals. */
#include "loft/patch.h"
#include "numeric/vector.h"
#include "spline/spline.h"

void bat_loft_knots(int inner_count, const double *inner, double *knots)
{
    for (int k = 0; k < BAT_LOFT_SUPPORT; k++) {
        knots[k] = 0;
        knots[BAT_LOFT_SUPPORT + inner_count + k] = 1;
    }
    for (int k = 0; k < inner_count; k++)
        knots[BAT_LOFT_SUPPORT + k] = inner[k];
}

batten_status bat_loft_patch_make(int nu, const double *u_knots, int nv, const double *v_knots,
                                  bat_loft_patch *out)
{
    bat_loft_patch patch = {.nu = nu, .nv = nv};
    patch.u_knots = bat_array((size_t)nu + BAT_LOFT_SUPPORT, sizeof *patch.u_knots);
    patch.v_knots = bat_array((size_t)nv + BAT_LOFT_SUPPORT, sizeof *patch.v_knots);
    patch.points = bat_array3((size_t)nu, (size_t)nv, 3 * sizeof *patch.points);
    if (!patch.u_knots || !patch.v_knots || !patch.points) {
        bat_loft_patch_free(&patch);
        return BATTEN_OUT_OF_MEMORY;
    }
    memcpy(patch.u_knots, u_knots, ((size_t)nu + BAT_LOFT_SUPPORT) * sizeof *u_knots);
    memcpy(patch.v_knots, v_knots, ((size_t)nv + BAT_LOFT_SUPPORT) * sizeof *v_knots);
    *out = patch;
    return BATTEN_OK;
}

void bat_loft_patch_free(bat_loft_patch *patch)
{
    bat_release(patch->u_knots);
    bat_release(patch->v_knots);
    bat_release(patch->points);
    *patch = (bat_loft_patch){0};
}

static int basis_at(int count, const double *knots, double t, double out[3][BAT_LOFT_SUPPORT])
{
    const int span = bat_knots_span(BAT_LOFT_DEGREE, count, knots, t, BATTEN_FROM_RIGHT);
    bat_basis(BAT_LOFT_DEGREE, knots, span, t, 2, &out[0][0]);
    return span - BAT_LOFT_DEGREE;
}

static void add_point(const bat_loft_place *place, int a, int b, const double *p,
                      double s[3][3][3])
{
    for (int du = 0; du <= 2; du++)
        for (int dv = 0; dv <= 2 - du; dv++)
            for (int c = 0; c < 3; c++)
                s[du][dv][c] += place->along_u[du][a] * place->along_v[dv][b] * p[c];
}

void bat_loft_place_at(const bat_loft_patch *patch, double u, double v, bat_loft_place *out)
{
    bat_loft_place place = {.u = bat_min(bat_max(u, 0), 1), .v = bat_min(bat_max(v, 0), 1)};
    place.i = basis_at(patch->nu, patch->u_knots, place.u, place.along_u);
    place.j = basis_at(patch->nv, patch->v_knots, place.v, place.along_v);
    for (int a = 0; a < BAT_LOFT_SUPPORT; a++)
        for (int b = 0; b < BAT_LOFT_SUPPORT; b++)
            add_point(&place, a, b,
                      patch->points + 3 * ((size_t)(place.i + a) * (size_t)patch->nv +
                                           (size_t)(place.j + b)),
                      place.s);
    *out = place;
}

double bat_loft_normal(const bat_loft_place *place, double normal[3])
{
    bat_loft_cross(place->s[1][0], place->s[0][1], normal);
    const double length = bat_norm(3, normal);
    for (int c = 0; c < 3 && length > 0; c++)
        normal[c] /= length;
    return length;
}
