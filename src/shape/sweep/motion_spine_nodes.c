/* Nodes along a spine: its lengths, and the axes that turn least. */
#include "base/plural.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/sweep/motion_spine.h"

/* The angle between the tangents on both sides of a knot. */
static batten_status corner_at(const bat_spine_motion *m, double u, double *angle)
{
    batten_vec3 point, tangent[2];
    batten_status status = bat_spine_tangent(m, u, BATTEN_FROM_LEFT, &point, &tangent[0]);
    if (status == BATTEN_OK)
        status = bat_spine_tangent(m, u, BATTEN_FROM_RIGHT, &point, &tangent[1]);
    if (status == BATTEN_OK)
        *angle = bat_atan2(bat_vec3_norm(bat_vec3_cross(tangent[0], tangent[1])),
                           bat_vec3_dot(tangent[0], tangent[1]));
    return status;
}

static batten_status check_corner(batten_corner_kind corners, double u, double angle)
{
    const double degrees = angle * 180 / BAT_PI;
    if (angle > BAT_PI - 1e-3)
        return bat_fail(BATTEN_SINGULAR_HERE, "the spine turns back at %.17g", u);
    if (corners != BATTEN_CORNER_REFUSE)
        return BATTEN_OK;
    return bat_fail(
        BATTEN_NOT_COMPATIBLE,
        "the spine has a corner of %g degree%s at %.17g: ask for a mitre, or split it "
        "there",
        degrees, bat_plural_real(degrees, 6), u);
}

static void begin_run(bat_spine_motion *m, double u)
{
    m->runs[m->run_count++] = (bat_spine_run){.first = m->node_count, .last = m->node_count};
    m->u[m->node_count++] = u;
}

batten_status bat_spine_lay_nodes(bat_spine_motion *m, int knot_count, const double *knots,
                                  batten_corner_kind corners)
{
    begin_run(m, knots[0]);
    for (int s = 0; s + 1 < knot_count; s++) {
        const double low = knots[s], high = knots[s + 1];
        double angle = 0;
        if (s > 0) {
            const batten_status status = corner_at(m, low, &angle);
            if (status != BATTEN_OK)
                return status;
        }
        /* A smaller bend is rounding: sections there differ by less than that of themselves. */
        if (angle > BAT_MEANT_SAME) {
            const batten_status status = check_corner(corners, low, angle);
            if (status != BATTEN_OK)
                return status;
            begin_run(m, low);
        }
        for (int i = 1; i <= BAT_SPINE_STEPS; i++)
            m->u[m->node_count++] =
                i < BAT_SPINE_STEPS ? low + (high - low) * i / BAT_SPINE_STEPS : high;
        m->runs[m->run_count - 1].last = m->node_count - 1;
    }
    return BATTEN_OK;
}

batten_status bat_spine_measure(bat_spine_motion *m)
{
    for (int i = 1; i < m->node_count; i++) {
        double step = 0;
        const batten_status status = bat_spine_length(m, m->u[i - 1], m->u[i], &step);
        if (status != BATTEN_OK)
            return status;
        m->length[i] = m->length[i - 1] + step;
    }
    m->total = m->length[m->node_count - 1];
    return BATTEN_OK;
}

/* Minimising axes of one run that begin with `x`. */
static batten_status frame_run(bat_spine_motion *m, const bat_spine_run *r, batten_vec3 x)
{
    const int count = r->last - r->first + 1;
    const batten_interval whole = batten_curve_domain(m->spine);
    const double a = m->u[r->first], b = m->u[r->last];
    batten_curve *part = NULL;
    batten_frame *frames = bat_array((size_t)count, sizeof *frames);
    batten_status status = frames ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && a == whole.a && b == whole.b)
        part = batten_curve_ref(m->spine);
    else if (status == BATTEN_OK)
        status = batten_curve_subrange(m->spine, a, b, &part);
    if (status == BATTEN_OK)
        status = batten_curve_minimising_frames(part, count, m->u + r->first, BAT_MEANT_SAME,
                                                NULL, frames);
    const double angle = status == BATTEN_OK ? bat_angle_about(frames[0].z, frames[0].x, x) : 0;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const batten_vec3 y = bat_vec3_cross(frames[i].z, frames[i].x);
        m->x[r->first + i] =
            bat_vec3_along(bat_vec3_scale(frames[i].x, bat_cos(angle)), bat_sin(angle), y);
    }
    batten_curve_unref(part);
    bat_release(frames);
    return status;
}

/* The first X: the wanted one, or that of batten_curve_frames. */
static batten_status first_axis(const bat_spine_motion *m, batten_vec3 wanted, batten_vec3 *x,
                                batten_vec3 *z)
{
    batten_frame frame;
    batten_status status = batten_curve_frames(m->spine, 1, m->u, BATTEN_FRAME_FIXED, &frame);
    if (status != BATTEN_OK)
        return status;
    *x = frame.x;
    *z = frame.z;
    if (!isfinite(bat_vec3_norm(wanted)))
        return bat_fail(BATTEN_NOT_FINITE, "the first x-axis is (%g, %g, %g)", wanted.x,
                        wanted.y, wanted.z);
    if (bat_vec3_norm(wanted) > 0)
        *x = bat_unit_across(wanted, *z);
    if (bat_vec3_norm(*x) == 0)
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the first x-axis, (%g, %g, %g), lies along the spine", wanted.x,
                        wanted.y, wanted.z);
    return BATTEN_OK;
}

batten_status bat_spine_frame_runs(bat_spine_motion *m, batten_vec3 wanted)
{
    batten_vec3 x, z;
    batten_status status = first_axis(m, wanted, &x, &z);
    if (status != BATTEN_OK)
        return status;
    m->fixed[0] = x;
    m->fixed[1] = z;
    if (m->has_up || m->guide || m->kind == BATTEN_FRAME_FIXED ||
        m->kind == BATTEN_FRAME_FRENET)
        return BATTEN_OK;
    for (int k = 0; k < m->run_count && status == BATTEN_OK; k++) {
        batten_vec3 point, t[2];
        if (k > 0) {
            const double u = m->u[m->runs[k].first];
            status = bat_spine_tangent(m, u, BATTEN_FROM_LEFT, &point, &t[0]);
            if (status == BATTEN_OK)
                status = bat_spine_tangent(m, u, BATTEN_FROM_RIGHT, &point, &t[1]);
            if (status == BATTEN_OK)
                x = bat_turn_least(m->x[m->runs[k - 1].last], t[0], t[1]);
        }
        if (status == BATTEN_OK)
            status = frame_run(m, &m->runs[k], x);
    }
    return status;
}
