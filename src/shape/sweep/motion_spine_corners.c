/* Where a spine closes, and its corners. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/sweep/motion_spine.h"

#include <string.h>

batten_vec3 bat_unit_across(batten_vec3 v, batten_vec3 t)
{
    const batten_vec3 rest = bat_vec3_along(v, -bat_vec3_dot(v, t), t);
    const double length = bat_vec3_norm(rest);
    return length > BAT_LEAST_SINE * bat_vec3_norm(v) ? bat_vec3_scale(rest, 1 / length)
                                                      : (batten_vec3){0, 0, 0};
}

batten_vec3 bat_turn_least(batten_vec3 x, batten_vec3 a, batten_vec3 b)
{
    /* Two reflections: in the plane between a and -b, and in that across b. */
    const batten_vec3 sum = bat_vec3_add(a, b);
    const batten_vec3 once =
        bat_vec3_along(x, -2 * bat_vec3_dot(x, sum) / bat_vec3_dot(sum, sum), sum);
    return bat_unit_across(bat_vec3_along(once, -2 * bat_vec3_dot(once, b), b), b);
}

double bat_angle_about(batten_vec3 t, batten_vec3 x, batten_vec3 y)
{
    return bat_atan2(bat_vec3_dot(y, bat_vec3_cross(t, x)), bat_vec3_dot(y, x));
}

/* Do the ends meet; and the tangents there. */
static batten_status look_at_seam(const bat_spine_motion *m, bool *closed,
                                  batten_vec3 tangent[2])
{
    const batten_interval domain = batten_curve_domain(m->spine);
    batten_vec3 point[2];
    batten_status status =
        bat_spine_tangent(m, domain.b, BATTEN_FROM_LEFT, &point[0], &tangent[0]);
    if (status == BATTEN_OK)
        status = bat_spine_tangent(m, domain.a, BATTEN_FROM_RIGHT, &point[1], &tangent[1]);
    if (status == BATTEN_OK)
        *closed = bat_vec3_norm(bat_vec3_subtract(point[0], point[1])) <=
                  BAT_MEANT_SAME * m->base.size;
    return status;
}

batten_status bat_spine_close(bat_spine_motion *m)
{
    batten_vec3 tangent[2];
    bool closed = false;
    if (m->kind != BATTEN_FRAME_CLOSING || m->has_up || m->guide)
        return BATTEN_OK;
    batten_status status = look_at_seam(m, &closed, tangent);
    if (status == BATTEN_OK && !closed)
        status = bat_fail(BATTEN_NOT_COMPATIBLE,
                          "closing frames need a closed spine, and its ends do not meet");
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 last = bat_turn_least(m->x[m->node_count - 1], tangent[0], tangent[1]);
    m->turn = -bat_angle_about(tangent[1], m->x[0], last);
    return BATTEN_OK;
}

/* How far X and Y of a pose must lean along t to lie in the plane with normal n. */
static batten_status lean_of(const bat_spine_motion *m, double u, batten_side side,
                             batten_vec3 t, batten_vec3 n, double shear[2])
{
    bat_pose pose;
    const batten_status status = bat_spine_pose(&m->base, u, side, &pose);
    for (int i = 0; status == BATTEN_OK && i < 2; i++)
        shear[i] = -bat_vec3_dot(bat_vec3_of(3, pose.d[0][i]), n) / bat_vec3_dot(t, n);
    return status;
}

/* The mitre between the end of one run and the start of another. */
static batten_status mitre(bat_spine_motion *m, bat_spine_run *before, bat_spine_run *after,
                           double u[2])
{
    batten_vec3 point, t[2];
    batten_status status = bat_spine_tangent(m, u[0], BATTEN_FROM_LEFT, &point, &t[0]);
    if (status == BATTEN_OK)
        status = bat_spine_tangent(m, u[1], BATTEN_FROM_RIGHT, &point, &t[1]);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 n = bat_vec3_add(t[0], t[1]);
    double ends[2][2];
    status = lean_of(m, u[0], BATTEN_FROM_LEFT, t[0], n, ends[0]);
    if (status == BATTEN_OK)
        status = lean_of(m, u[1], BATTEN_FROM_RIGHT, t[1], n, ends[1]);
    if (status == BATTEN_OK) {
        memcpy(before->shear[1], ends[0], sizeof ends[0]);
        memcpy(after->shear[0], ends[1], sizeof ends[1]);
    }
    return status;
}

batten_status bat_spine_mitre(bat_spine_motion *m)
{
    batten_status status = BATTEN_OK;
    if (m->kind == BATTEN_FRAME_FIXED && !m->has_up && !m->guide)
        return BATTEN_OK;
    for (int k = 1; k < m->run_count && status == BATTEN_OK; k++) {
        const double u = m->u[m->runs[k].first];
        status = mitre(m, &m->runs[k - 1], &m->runs[k], (double[2]){u, u});
    }
    batten_vec3 tangent[2];
    bool closed = false;
    if (status == BATTEN_OK)
        status = look_at_seam(m, &closed, tangent);
    if (status != BATTEN_OK || !closed)
        return status;
    const double sine = bat_vec3_norm(bat_vec3_cross(tangent[0], tangent[1]));
    if (sine <= BAT_LEAST_SINE)
        return BATTEN_OK;
    const batten_interval domain = batten_curve_domain(m->spine);
    return mitre(m, &m->runs[m->run_count - 1], &m->runs[0], (double[2]){domain.b, domain.a});
}
