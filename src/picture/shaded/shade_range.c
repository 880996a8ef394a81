/* The range of the colours of curvature, from samples of all surfaces. */
#include "picture/shaded/shade.h"

#include <stdlib.h>

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Samples of |K| over all surfaces, evenly thinned to at most `room`; notes the extremes. */
static size_t sample_curvatures(bat_shaded *p, size_t room, double *samples)
{
    size_t total = 0, kept = 0;
    for (int i = 0; i < p->solid_count; i++)
        total += p->solids[i].tiles.count_u * p->solids[i].tiles.count_v;
    const size_t every = total / room + 1;
    p->least = HUGE_VAL;
    p->greatest = -HUGE_VAL;
    for (int i = 0; i < p->solid_count; i++) {
        const bat_tiles *t = &p->solids[i].tiles;
        for (size_t k = 0; k < t->count_u * t->count_v; k++) {
            if (isnan(t->curvature[k]))
                continue;
            p->least = bat_min(p->least, t->curvature[k]);
            p->greatest = bat_max(p->greatest, t->curvature[k]);
            if (k % every == 0)
                samples[kept++] = fabs(t->curvature[k]);
        }
    }
    return kept;
}

/* The colours end where 95 of 100 samples lie inside: a few sharp places must not bleach all
 * others. */
batten_status bat_shaded_choose_range(bat_shaded *p, double size)
{
    enum { ROOM = 60000 };
    double *samples = bat_array(ROOM + (size_t)p->solid_count, sizeof *samples);
    if (!samples)
        return BATTEN_OUT_OF_MEMORY;
    const size_t count = sample_curvatures(p, ROOM, samples);
    qsort(samples, count, sizeof *samples, ascending);
    /* What is developable but for roundings stays white. */
    double range =
        p->options->shading == BATTEN_SHADING_MEAN ? 1e-6 / size : 1e-6 / (size * size);
    if (count > 0)
        range = bat_max(range, samples[(size_t)(0.95 * (double)(count - 1))]);
    bat_release(samples);
    const double power = bat_pow(10, floor(bat_log10(range)) - 1);
    p->scene.range = ceil(range / power) * power; /* two digits */
    return isfinite(p->scene.range)
               ? BATTEN_OK
               : bat_fail(BATTEN_OVERFLOW, "curvatures up to %g are too large to show", range);
}
