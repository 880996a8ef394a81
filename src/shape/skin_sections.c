/* The sections of a skin: placed, run the same way, with common knots. */
#include "shape/common_knots.h"
#include "shape/skin_parts.h"

#include <string.h>

/* ---- placing and aligning the sections ---- */

static batten_status place(const bat_skin *t, const batten_curve *section,
                           const batten_affine *map, batten_curve **out)
{
    batten_curve *raised = NULL;
    batten_status status = BATTEN_OK;
    if (batten_curve_dimension(section) == t->dimension)
        raised = batten_curve_ref(section);
    else
        status = batten_curve_to_dimension(section, t->dimension, &raised);
    if (status == BATTEN_OK && map)
        status = batten_curve_transform(raised, map, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(raised);
    batten_curve_unref(raised);
    return status;
}

batten_status bat_skin_place(bat_skin *t, const batten_curve *const *sections)
{
    for (int k = 0; k < t->count; k++)
        t->dimension = bat_max_int(t->dimension, batten_curve_dimension(sections[k]));
    batten_affine *maps = NULL;
    batten_status status = BATTEN_OK;
    if (t->options->spine) {
        t->dimension = 3;
        maps = bat_array((size_t)t->count, sizeof *maps);
        status = maps ? bat_skin_places(t->count, t->options, maps) : BATTEN_OUT_OF_MEMORY;
    }
    for (int k = 0; status == BATTEN_OK && k < t->count; k++)
        status = place(t, sections[k], maps ? &maps[k] : NULL, &t->placed[k]);
    bat_release(maps);
    return status;
}

/* Points that tell in which direction a section runs. */
enum { SAMPLES = 17 };

static batten_status sample(const batten_curve *curve, double points[SAMPLES][3])
{
    const batten_interval domain = batten_curve_domain(curve);
    for (int i = 0; i < SAMPLES; i++) {
        const double s = (double)i / (SAMPLES - 1);
        const batten_status status =
            batten_curve_evaluate(curve, (1 - s) * domain.a + s * domain.b, 0, points[i]);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

static bool runs_against(int d, double a[SAMPLES][3], double b[SAMPLES][3])
{
    double along = 0, against = 0;
    for (int i = 0; i < SAMPLES; i++) {
        along += bat_distance(d, a[i], b[i]);
        against += bat_distance(d, a[i], b[SAMPLES - 1 - i]);
    }
    return against < along;
}

/* Reverse each section that runs against the one before it, and say so. */
batten_status bat_skin_align(bat_skin *t)
{
    double before[SAMPLES][3], here[SAMPLES][3];
    int reversed_count = 0;
    batten_status status = sample(t->placed[0], before);
    for (int k = 1; status == BATTEN_OK && k < t->count; k++) {
        status = sample(t->placed[k], here);
        if (status == BATTEN_OK && runs_against(t->dimension, before, here)) {
            batten_curve *reversed = NULL;
            status = batten_curve_reverse(t->placed[k], &reversed);
            if (status == BATTEN_OK) {
                batten_curve_unref(t->placed[k]);
                t->placed[k] = reversed;
                status = sample(reversed, here);
                bat_fail(BATTEN_OK, "section %d was reversed, and %d before it", k,
                         reversed_count++);
            }
        }
        memcpy(before, here, sizeof before);
    }
    return status;
}

/* ---- common knots ---- */

static bool all_periodic(const bat_skin *t)
{
    bool periodic = true;
    for (int k = 0; k < t->count; k++)
        periodic = periodic && batten_curve_is_periodic(t->placed[k]);
    return periodic;
}

/* A jump of the speed would ask for knots that the shape does not need. */
static batten_status even_speeds(bat_skin *t)
{
    for (int k = 0; k < t->count; k++) {
        batten_curve *even = NULL;
        const batten_status status = bat_skin_even_speed(t->placed[k], &even);
        if (status != BATTEN_OK)
            return status;
        batten_curve_unref(t->placed[k]);
        t->placed[k] = even;
    }
    return BATTEN_OK;
}

batten_status bat_skin_unify(bat_skin *t)
{
    const batten_curve *const *placed = (const batten_curve *const *)t->placed;
    t->periodic_u = all_periodic(t);
    const bool exact = t->periodic_u || t->options->tolerance == 0;
    batten_status status = exact ? BATTEN_OK : even_speeds(t);
    if (status == BATTEN_OK && !exact)
        status = bat_common_knots(t->count, placed, t->options->tolerance, &t->work, t->unified,
                                  t->deviation);
    else if (status == BATTEN_OK)
        status = batten_curves_unify(t->count, placed, t->unified);
    if (status != BATTEN_OK)
        return status;
    const batten_curve *first = t->unified[0];
    t->rational = batten_curve_is_rational(first);
    t->width = (size_t)t->dimension + t->rational;
    t->points =
        batten_curve_point_count(first) - (t->periodic_u ? batten_curve_degree(first) : 0);
    const double size = (double)t->points * (t->count + 2);
    if (size > BAT_MAX_MADE_POINTS)
        return bat_fail(
            BATTEN_TOO_LARGE,
            "%d sections with %d common control points make a surface of %.3g; the limit is %d",
            t->count, t->points, size, (int)BAT_MAX_MADE_POINTS);
    return BATTEN_OK;
}
