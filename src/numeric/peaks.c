/* The largest values of quantities along a line: even samples, and a golden section around each that stands out. */
#include "numeric/peaks.h"

#include <math.h>

typedef struct {
    bat_quantities look;
    void *context;
    int samples, count;
    double *values; /* [samples][count] */
    double *largest;
} peak_search;

/* The smaller part of the golden section, (3 - sqrt 5) / 2, and the sections that leave a millionth. */
static const double smaller_part = 0.38196601125010515;
enum { SECTIONS = 30 };

static double at_sample(const peak_search *s, int i)
{
    return (double)i / (s->samples - 1);
}

static double value_of(const peak_search *s, int i, int which)
{
    return s->values[i * s->count + which];
}

/* Every look counts for all quantities. */
static batten_status look_at(const peak_search *s, double t, double *values)
{
    const batten_status status = s->look(s->context, t, values);
    for (int k = 0; status == BATTEN_OK && k < s->count; k++)
        if (!isnan(s->largest[k]))
            s->largest[k] =
                values[k] > s->largest[k] || isnan(values[k]) ? values[k] : s->largest[k];
    return status;
}

static batten_status narrow(const peak_search *s, int which, double low, double high)
{
    double values[2][BAT_PEAKS_MOST],
        at[2] = {low + smaller_part * (high - low), high - smaller_part * (high - low)};
    batten_status status = look_at(s, at[0], values[0]);
    if (status == BATTEN_OK)
        status = look_at(s, at[1], values[1]);
    for (int i = 0; i < SECTIONS && status == BATTEN_OK; i++) {
        const int keep = values[1][which] > values[0][which];
        const int renew = !keep;
        if (keep)
            low = at[0];
        else
            high = at[1];
        at[renew] = at[keep];
        for (int k = 0; k < s->count; k++)
            values[renew][k] = values[keep][k];
        at[keep] =
            keep ? high - smaller_part * (high - low) : low + smaller_part * (high - low);
        status = look_at(s, at[keep], values[keep]);
    }
    return status;
}

/* A sample that is not below its neighbours, and so near the largest that its peak, which rises above it by less than
 * it stands above the lower neighbour where the quantity is smooth, may be larger. */
static bool may_be_largest(const peak_search *s, int i, int which)
{
    const double here = value_of(s, i, which);
    const double before = value_of(s, i > 0 ? i - 1 : i, which);
    const double after = value_of(s, i + 1 < s->samples ? i + 1 : i, which);
    return isfinite(s->largest[which]) && isfinite(before) && isfinite(after) &&
           here >= before && here >= after && (here > before || here > after) &&
           here + (here - fmin(before, after)) >= s->largest[which];
}

static batten_status refine_peaks(const peak_search *s)
{
    batten_status status = BATTEN_OK;
    for (int which = 0; which < s->count; which++)
        for (int i = 0; i < s->samples && status == BATTEN_OK; i++)
            if (may_be_largest(s, i, which))
                status = narrow(s, which, at_sample(s, i > 0 ? i - 1 : i),
                                at_sample(s, i + 1 < s->samples ? i + 1 : i));
    return status;
}

batten_status bat_find_peaks(bat_quantities look, void *context, int samples, int count,
                             double *largest)
{
    assert(samples >= 3 && count <= BAT_PEAKS_MOST);
    double *values = bat_array3((size_t)samples, (size_t)count, sizeof *values);
    if (!values)
        return BATTEN_OUT_OF_MEMORY;
    const peak_search s = {look, context, samples, count, values, largest};
    batten_status status = BATTEN_OK;
    for (int k = 0; k < count; k++)
        largest[k] = 0;
    for (int i = 0; i < samples && status == BATTEN_OK; i++)
        status = look_at(&s, at_sample(&s, i), values + i * count);
    if (status == BATTEN_OK)
        status = refine_peaks(&s);
    bat_release(values);
    return status;
}
