/* What both the correction of spans and that of their joins ask of a span. */
#include "numeric/vector.h"
#include "shape/local/correct_tangents.h"

bool bat_correction_is_bad(batten_cubic_region region)
{
    return region != BATTEN_REGION_REGULAR && region != BATTEN_REGION_S_SHAPED;
}

double bat_correction_bend(const bat_correction *w, int i, int end)
{
    const double *a = bat_correction_point(w, end ? 3 * i + 3 : 3 * i);
    const double *b = bat_correction_point(w, end ? 3 * i + 2 : 3 * i + 1);
    const double *c = bat_correction_point(w, end ? 3 * i + 1 : 3 * i + 2);
    const double leg[2] = {b[0] - a[0], b[1] - a[1]}, next[2] = {c[0] - b[0], c[1] - b[1]};
    const double length = bat_norm(2, leg);
    const double cross = leg[0] * next[1] - leg[1] * next[0];
    return (end ? -1 : 1) * 2 * cross / (3 * length * length * length);
}

int bat_correction_before(const bat_correction *w, int j)
{
    return j == 0 ? w->count - 1 : j - 1;
}
