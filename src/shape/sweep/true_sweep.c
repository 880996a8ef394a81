/* The true sweep at its parameters: the section carried by the motion, with its derivatives. */
#include "shape/sweep/true_sweep.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <string.h>

void bat_sweep_release(bat_sweep *sweep)
{
    bat_motion_free(sweep->motion);
    batten_curve_unref(sweep->section);
    batten_surface_unref(sweep->row);
    *sweep = (bat_sweep){0};
}

/* ---- control points ---- */

static bool weights_change(const bat_sweep *s)
{
    return s->row && batten_surface_is_rational(s->row);
}

int bat_sweep_count(const bat_sweep *s)
{
    return s->row ? batten_surface_point_count(s->row, BATTEN_U)
                  : batten_curve_point_count(s->section);
}

size_t bat_sweep_width(const bat_sweep *s)
{
    return weights_change(s) ? 4 : 3;
}

/* The section at a share of the way, in its own plane. */
batten_status bat_sweep_section_at(const bat_sweep *s, double share, batten_curve **out)
{
    if (!s->row) {
        *out = batten_curve_ref(s->section);
        return BATTEN_OK;
    }
    return batten_surface_isocurve(s->row, BATTEN_V, bat_max(0, bat_min(1, share)), out);
}

batten_status bat_sweep_rows(const bat_sweep *s, double v, batten_side side, double *rows)
{
    bat_pose pose;
    batten_curve *section = NULL;
    batten_status status = s->motion->pose(s->motion, v, side, &pose);
    if (status == BATTEN_OK)
        status = bat_sweep_section_at(s, pose.share[0], &section);
    if (status != BATTEN_OK)
        return status;
    const int count = bat_sweep_count(s);
    const size_t width = bat_sweep_width(s);
    const double *points = batten_curve_points(section), *w = batten_curve_weights(section);
    for (int i = 0; i < count; i++, rows += width) {
        const double *p = points + 3 * i;
        for (int c = 0; c < 3; c++)
            rows[c] = pose.d[0][BAT_POSE_ORIGIN][c] + p[0] * pose.d[0][BAT_POSE_X][c] +
                      p[1] * pose.d[0][BAT_POSE_Y][c] + p[2] * pose.d[0][BAT_POSE_Z][c];
        for (int c = 0; c < 3 && width == 4; c++)
            rows[c] *= w[i];
        if (width == 4)
            rows[3] = w[i];
    }
    batten_curve_unref(section);
    return BATTEN_OK;
}

/* ---- derivatives ---- */

/* Derivatives of the section in its own plane: c[k][j] is the k-th in u, j-th in v. */
typedef struct {
    double c[4][4][3];
} local_section;

static batten_status look_at_section(const bat_sweep *s, double u, batten_side side, int order,
                                     local_section *out)
{
    double values[12];
    *out = (local_section){{{{0}}}};
    const batten_status status = batten_curve_evaluate_side(s->section, u, side, order, values);
    for (int k = 0; status == BATTEN_OK && k <= order; k++)
        memcpy(out->c[k][0], values + 3 * k, sizeof out->c[k][0]);
    return status;
}

/* The same of a row of sections at the share sigma(v): the chain rule. */
static batten_status look_at_row(const bat_sweep *s, const bat_surface_place *at,
                                 const double *sigma, int order, local_section *out)
{
    double values[30];
    const double share = bat_max(0, bat_min(1, sigma[0]));
    const batten_status status = batten_surface_evaluate_side(
        s->row, at->u, share, (batten_sides){at->sides.u, BATTEN_FROM_RIGHT}, order, values);
    *out = (local_section){{{{0}}}};
    for (int k = 0; status == BATTEN_OK && k <= order; k++)
        for (int c = 0; c < 3; c++) {
            double d[4] = {0};
            for (int j = 0; k + j <= order; j++)
                d[j] = values[3 * BATTEN_SURFACE_DERIVATIVE(k, j) + c];
            out->c[k][0][c] = d[0];
            out->c[k][1][c] = d[1] * sigma[1];
            out->c[k][2][c] = d[2] * sigma[1] * sigma[1] + d[1] * sigma[2];
            out->c[k][3][c] = d[3] * sigma[1] * sigma[1] * sigma[1] +
                              3 * d[2] * sigma[1] * sigma[2] + d[1] * sigma[3];
        }
    return status;
}

/* The derivative k times in u, l times in v, of o + x X + y Y + z Z, after Leibniz. */
static void combine_section(const local_section *section, const bat_pose *pose, int k, int l,
                            double *out)
{
    for (int c = 0; c < 3; c++)
        out[c] = k == 0 ? pose->d[l][BAT_POSE_ORIGIN][c] : 0;
    for (int j = 0; j <= l; j++)
        for (int axis = 0; axis < 3; axis++)
            for (int c = 0; c < 3; c++)
                out[c] +=
                    bat_binomials[l][j] * section->c[k][j][axis] * pose->d[l - j][axis][c];
}

batten_status bat_sweep_evaluate(const bat_sweep *s, const bat_surface_place *at, int order,
                                 double *out)
{
    bat_pose pose;
    local_section section;
    batten_status status = s->motion->pose(s->motion, at->v, at->sides.v, &pose);
    if (status == BATTEN_OK && s->row)
        status = look_at_row(s, at, pose.share, order, &section);
    else if (status == BATTEN_OK)
        status = look_at_section(s, at->u, at->sides.u, order, &section);
    if (status != BATTEN_OK)
        return status;
    for (int total = 0; total <= order; total++)
        for (int l = 0; l <= total; l++)
            combine_section(&section, &pose, total - l, l,
                            out + 3 * BATTEN_SURFACE_DERIVATIVE(total - l, l));
    return BATTEN_OK;
}

/* ---- the surface of kind "sweep" ---- */
