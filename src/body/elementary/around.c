/* Do the loops of a face go around the surface that it lies on? */
#include "body/elementary/parts.h"
#include <batten/curvature.h>

/* Steps of a span at first and at most: four times as many until none turns too far to be told.
 */
enum { FIRST = 8, MOST = 2048 };

/* ---- along a curve ---- */

/* Across the axis, from the origin. */
static void see(const bat_around *around, const double point[3], double at[2])
{
    const batten_vec3 way = bat_vec3_subtract(bat_vec3_of(3, point), around->origin);
    at[0] = bat_vec3_dot(way, around->x);
    at[1] = bat_vec3_dot(way, around->y);
}

/* The sum over `count` steps of a span; *widest is the largest angle of a step. */
static batten_status sum_steps(bat_around *around, const batten_curve *curve, double a,
                               double b, int count, double *sum, double *widest)
{
    double before[2] = {0, 0}, here[2];
    *sum = *widest = 0;
    for (int i = 0; i <= count; i++, before[0] = here[0], before[1] = here[1]) {
        double point[3];
        const batten_status status = batten_curve_evaluate_side(
            curve, i == count ? b : a + (b - a) * i / count, BATTEN_FROM_LEFT, 0, point);
        if (status != BATTEN_OK)
            return status;
        see(around, point, here);
        around->meets_axis |= around->is_turned && bat_hypot(here[0], here[1]) <= around->near;
        if (i == 0)
            continue;
        const double cross = before[0] * here[1] - before[1] * here[0];
        const double turn = bat_atan2(cross, before[0] * here[0] + before[1] * here[1]);
        *sum += around->is_turned ? turn : cross;
        *widest = bat_max(*widest, fabs(turn));
    }
    return BATTEN_OK;
}

static batten_status sum_span(bat_around *around, const batten_curve *curve, double a, double b,
                              double *sum)
{
    double widest = 0;
    batten_status status = BATTEN_OK;
    for (int count = FIRST; count <= MOST; count *= 4) {
        status = sum_steps(around, curve, a, b, count, sum, &widest);
        if (status != BATTEN_OK || !around->is_turned || around->meets_axis ||
            widest < BAT_PI / 2)
            break;
    }
    return status;
}

static batten_status sum_curve(bat_around *around, const batten_curve *curve, double *sum)
{
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    *sum = 0;
    if (knots)
        batten_curve_spans(curve, knots);
    for (int k = 0; status == BATTEN_OK && k + 1 < count; k++) {
        double part = 0;
        status = sum_span(around, curve, knots[k], knots[k + 1], &part);
        *sum += part;
    }
    bat_release(knots);
    return status;
}

/* ---- all of it ---- */

batten_status bat_around_begin(const bat_elementary *elementary, double tolerance,
                               bat_around *around)
{
    const bat_elementary_kind kind = elementary->kind;
    batten_frame frame;
    *around = (bat_around){.near = bat_max(0, tolerance)};
    if (kind != BAT_CYLINDER && kind != BAT_CONE && kind != BAT_EXTRUSION)
        return BATTEN_OK;
    const batten_status status = bat_elementary_frame(elementary, &frame, &around->y);
    if (status != BATTEN_OK)
        return status;
    around->origin = frame.origin;
    around->x = frame.x;
    around->is_turned = kind != BAT_EXTRUSION;
    around->whole = 2 * BAT_PI;
    if (around->is_turned)
        return BATTEN_OK;
    /* What is extruded may be anywhere; areas are larger the farther the origin is from it. */
    around->origin = bat_vec3_of(3, batten_curve_points(elementary->curve));
    if (!batten_curve_is_closed(elementary->curve, around->near)) {
        around->whole = 0;
        return BATTEN_OK;
    }
    return sum_curve(around, elementary->curve, &around->whole);
}

batten_status bat_around_add(bat_around *around, const batten_curve *curve, bool reversed)
{
    double sum = 0;
    if (around->whole == 0 || around->meets_axis)
        return BATTEN_OK;
    const batten_status status = sum_curve(around, curve, &sum);
    around->sum += reversed ? -sum : sum;
    return status;
}

bool bat_around_is_once(const bat_around *around)
{
    return around->whole != 0 && !around->meets_axis &&
           fabs(fabs(around->sum / around->whole) - 1) < 0.1;
}
