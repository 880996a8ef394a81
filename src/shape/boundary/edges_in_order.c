/* Boundary curves put end to end. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/coons.h>

enum { PROBES = 5 };

/* What the search looks at: the ends of each curve, and points between. */
typedef struct {
    double ends[2][3], probes[PROBES][3];
    bool used;
} strand;

static double gap_between(int d, const double *a, const double *b)
{
    return bat_distance(d, a, b);
}

static batten_status look_at_ends(const batten_curve *curve, int number, double tolerance,
                                  strand *out)
{
    const batten_interval domain = batten_curve_domain(curve);
    const int d = curve->dimension;
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, out->ends[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, domain.b, 0, out->ends[1]);
    double reach = 0;
    for (int i = 0; status == BATTEN_OK && i < PROBES; i++) {
        const double t = (i + 1.0) / (PROBES + 1);
        status = batten_curve_evaluate(curve, domain.a + t * (domain.b - domain.a), 0,
                                       out->probes[i]);
    }
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < curve->count; i++)
        reach =
            bat_max(reach, gap_between(d, curve->points + (size_t)i * (size_t)d, out->ends[0]));
    if (!(reach > tolerance))
        return bat_fail(BATTEN_COINCIDENT,
                        "curve %d has no length: it reaches %g from its start", number, reach);
    const double gap = gap_between(d, out->ends[0], out->ends[1]);
    if (!(gap > tolerance))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "curve %d is closed (its ends are %g apart); a side of a loop is open",
                        number, gap);
    return BATTEN_OK;
}

/* Do both run through the same points, in one direction or the other? */
static bool same_point(int d, const strand *a, const strand *b, double tolerance)
{
    for (int reversed = 0; reversed < 2; reversed++) {
        double far = 0;
        for (int e = 0; e < 2; e++)
            far = bat_max(far, gap_between(d, a->ends[e], b->ends[reversed ? 1 - e : e]));
        for (int i = 0; i < PROBES; i++)
            far = bat_max(
                far, gap_between(d, a->probes[i], b->probes[reversed ? PROBES - 1 - i : i]));
        if (far <= tolerance)
            return true;
    }
    return false;
}

static batten_status check_edges(int count, const batten_curve *const *curves, double tolerance,
                                 strand *strands)
{
    if (count < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a loop has 2 curves or more, not %d", count);
    if (!(tolerance >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, below 0", tolerance);
    const int d = curves[0]->dimension;
    for (int i = 0; i < count; i++) {
        if (curves[i]->dimension != d)
            return bat_fail(BATTEN_NOT_COMPATIBLE, "curves 1 and %d have %d and %d dimensions",
                            i + 1, d, curves[i]->dimension);
        const batten_status status = look_at_ends(curves[i], i + 1, tolerance, &strands[i]);
        if (status != BATTEN_OK)
            return status;
    }
    for (int i = 0; i < count; i++)
        for (int j = i + 1; j < count; j++)
            if (same_point(d, &strands[i], &strands[j], tolerance))
                return bat_fail(BATTEN_COINCIDENT, "curves %d and %d are the same", i + 1,
                                j + 1);
    return BATTEN_OK;
}

static batten_status open_at(int corner, int from, int to, double gap)
{
    return bat_fail(BATTEN_NOT_COMPATIBLE, "corner %d, between curves %d and %d, is open by %g",
                    corner, from, to, gap);
}

/* Corner k, counted from 1, is where curve k of the loop begins. */
static batten_status walk_around(int count, int d, double tolerance, strand *strands,
                                 batten_loop_place *places)
{
    places[0] = (batten_loop_place){0, false, 0};
    strands[0].used = true;
    const double *at = strands[0].ends[1];
    for (int k = 1; k < count; k++) {
        batten_loop_place best = {-1, false, 0};
        double gap = INFINITY;
        for (int i = 0; i < count; i++)
            for (int e = 0; !strands[i].used && e < 2; e++) {
                const double far = gap_between(d, at, strands[i].ends[e]);
                if (best.curve < 0 || far < gap) {
                    best = (batten_loop_place){i, e == 1, 0};
                    gap = far;
                }
            }
        if (!(gap <= tolerance))
            return open_at(k + 1, places[k - 1].curve + 1, best.curve + 1, gap);
        places[k - 1].gap = gap;
        places[k] = best;
        strands[best.curve].used = true;
        at = strands[best.curve].ends[best.reversed ? 0 : 1];
    }
    const double gap = gap_between(d, at, strands[0].ends[0]);
    if (!(gap <= tolerance))
        return open_at(1, places[count - 1].curve + 1, 1, gap);
    places[count - 1].gap = gap;
    return BATTEN_OK;
}

batten_status batten_curves_loop(int count, const batten_curve *const *curves, double tolerance,
                                 batten_loop_place *places)
{
    assert(curves && places);
    strand *strands = bat_array((size_t)bat_max_int(count, 1), sizeof *strands);
    batten_loop_place *found = bat_array((size_t)bat_max_int(count, 1), sizeof *found);
    batten_status status = strands && found ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = check_edges(count, curves, tolerance, strands);
    if (status == BATTEN_OK)
        status = walk_around(count, curves[0]->dimension, tolerance, strands, found);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        places[i] = found[i];
    bat_release(found);
    bat_release(strands);
    return status;
}
