/* Motions of all kinds: giving them back, and how smooth they are where their pieces meet. */
#include "shape/sweep/motion.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"

void bat_motion_free(bat_motion *motion)
{
    if (!motion)
        return;
    bat_release(motion->breaks);
    bat_release(motion->smoothness);
    motion->free(motion);
}

/* Do the derivatives of order k agree? Beside their own size, roundoff is measured by what the
 * motion does in a span of length h. */
static bool agrees(const bat_motion *motion, const bat_pose *a, const bat_pose *b, int k,
                   double h)
{
    double unit[2] = {1, motion->size}; /* of the axes, of the origin */
    for (int i = 0; i < k; i++) {
        unit[0] /= h;
        unit[1] /= h;
    }
    for (int c = 0; c < 4; c++) {
        const double *p = a->d[k][c], *q = b->d[k][c];
        const double allowed =
            BAT_MEANT_SAME * (bat_norm(3, p) + bat_norm(3, q) + unit[c == BAT_POSE_ORIGIN]);
        if (bat_distance(3, p, q) > allowed && !(motion->flat && c == BAT_POSE_Z))
            return false;
    }
    return true;
}

batten_status bat_motion_find_smoothness(bat_motion *motion)
{
    for (int i = 1; i + 1 < motion->break_count; i++) {
        const double v = motion->breaks[i];
        const double h = bat_min(v - motion->breaks[i - 1], motion->breaks[i + 1] - v);
        bat_pose left, right;
        batten_status status = motion->pose(motion, v, BATTEN_FROM_LEFT, &left);
        if (status == BATTEN_OK)
            status = motion->pose(motion, v, BATTEN_FROM_RIGHT, &right);
        if (status != BATTEN_OK)
            return status;
        int k = 0;
        while (k <= BAT_POSE_ORDER && agrees(motion, &left, &right, k, h))
            k++;
        motion->smoothness[i] = k - 1;
    }
    return BATTEN_OK;
}
