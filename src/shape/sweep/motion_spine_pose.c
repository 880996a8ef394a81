/* The pose of a motion along a spine. */
#include "shape/sweep/motion_spine.h"

#include <string.h>

static const bat_spine_motion *motion_of(const bat_motion *motion)
{
    return (const bat_spine_motion *)(const void *)motion;
}

/* The run that holds u: of two that meet there, by the side. */
static const bat_spine_run *run_at(const bat_spine_motion *m, double u, batten_side side)
{
    int k = 0;
    while (k + 1 < m->run_count) {
        const double end = m->u[m->runs[k].last];
        if (u < end || (u == end && side == BATTEN_FROM_LEFT))
            break;
        k++;
    }
    return &m->runs[k];
}

/* The last node of the run at or before u; not the last of the run. */
static int node_before(const bat_spine_motion *m, const bat_spine_run *r, double u)
{
    int low = r->first, high = r->last;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (m->u[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void put_pose(const bat_bare_frame *f, const bat_jet *share, bat_pose *out)
{
    const bat_jet3 *columns[4] = {&f->x, &f->y, &f->z, &f->point};
    for (int k = 0; k <= BAT_POSE_ORDER; k++) {
        for (int c = 0; c < 4; c++) {
            const batten_vec3 at = bat_jet3_in_v(columns[c], k);
            memcpy(out->d[k][c], (double[3]){at.x, at.y, at.z}, sizeof out->d[k][c]);
        }
        out->share[k] = bat_jet_in_v(share, k);
    }
}

batten_status bat_spine_pose(const bat_motion *motion, double v, batten_side side,
                             bat_pose *out)
{
    const bat_spine_motion *m = motion_of(motion);
    const bat_spine_run *r = run_at(m, v, side);
    const int node = node_before(m, r, v);
    bat_bare_frame f;
    double length = 0;
    batten_status status = bat_spine_frame(m, node, v, side, &f);
    if (status == BATTEN_OK)
        status = bat_spine_length(m, m->u[node], v, &length);
    if (status != BATTEN_OK)
        return status;
    length += m->length[node];
    const bat_jet share = bat_share(length, &f.speed, m->total);
    status = bat_spine_turn(m, &share, side, &f);
    if (status == BATTEN_OK)
        status = bat_spine_scale(m, &share, side, &f);
    if (status != BATTEN_OK)
        return status;
    bat_spine_lean(m, r, length, &f);
    put_pose(&f, &share, out);
    return BATTEN_OK;
}
