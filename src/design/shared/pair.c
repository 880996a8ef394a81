/* Two curves or two surfaces that a feature joins, in order. */
#include "design/shared/pair.h"

#include <batten/blend.h>

/* The words behind 'nearest'. */
static const batten_curve_end pairs[4][2] = {{BATTEN_CURVE_END, BATTEN_CURVE_START},
                                             {BATTEN_CURVE_END, BATTEN_CURVE_END},
                                             {BATTEN_CURVE_START, BATTEN_CURVE_START},
                                             {BATTEN_CURVE_START, BATTEN_CURVE_END}};

static batten_status reverse_or_keep(const batten_curve *curve, bool reverse,
                                     batten_curve **out)
{
    if (reverse)
        return batten_curve_reverse(curve, out);
    *out = batten_curve_ref(curve);
    return BATTEN_OK;
}

batten_status bat_pair_take(const bat_run *run, const char *parameter, batten_curve *curves[2])
{
    bat_objects all;
    batten_status status = bat_gather(run, parameter, BAT_CURVES, &all);
    if (status != BATTEN_OK)
        return status;
    const int word = bat_word(run, "ends");
    batten_curve_end ends[2] = {BATTEN_CURVE_END, BATTEN_CURVE_START};
    batten_curve *made[2] = {NULL, NULL};
    if (all.count != 2)
        status =
            bat_fail(BATTEN_NOT_COMPATIBLE, "two curves are needed, there are %d", all.count);
    if (status == BATTEN_OK && word == 0)
        status = batten_curves_nearest_ends(all.at[0]->curve, all.at[1]->curve, ends);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        if (word > 0)
            ends[k] = pairs[word - 1][k];
        const bool reverse = ends[k] == (k ? BATTEN_CURVE_END : BATTEN_CURVE_START);
        status = reverse_or_keep(all.at[k]->curve, reverse, &made[k]);
    }
    bat_objects_release(&all);
    for (int k = 0; k < 2; k++) {
        if (status == BATTEN_OK)
            curves[k] = made[k];
        else
            batten_curve_unref(made[k]);
    }
    return status;
}

/* Nothing, when the whole curve went. */
static batten_status rest_of(const batten_curve *curve, double a, double b, batten_curve **out)
{
    const batten_interval domain = batten_curve_domain(curve);
    if (b - a <= 1e-12 * (domain.b - domain.a))
        return BATTEN_OK;
    return batten_curve_subrange(curve, a, b, out);
}

/* `made` and `more`, which may be NULL, as one; both are given back. */
static batten_status join_rest(batten_status status, batten_curve *made, batten_curve *more,
                               double within, batten_curve **out)
{
    if (status == BATTEN_OK && made && more)
        status = batten_curve_join(made, more, within, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(made ? made : more);
    batten_curve_unref(more);
    batten_curve_unref(made);
    return status;
}

batten_status bat_pair_join(const batten_curve *const curves[2], const double u[2],
                            const batten_curve *link, double within, batten_curve **out)
{
    batten_curve *before = NULL, *behind = NULL, *half = NULL;
    batten_status status = rest_of(curves[0], batten_curve_domain(curves[0]).a, u[0], &before);
    status = join_rest(status, before, batten_curve_ref(link), within, &half);
    if (status == BATTEN_OK)
        status = rest_of(curves[1], u[1], batten_curve_domain(curves[1]).b, &behind);
    return join_rest(status, half, behind, within, out);
}
