/*
 * Checks of points and parameters passed in by callers, with messages that name the first bad
 * one.
 */
#include "spline/data_check.h"

#include "base/plural.h"
#include "spline/curve/curve.h"

batten_status bat_points_check(int dimension, int count, const double *points, int least)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "points have %d coordinates, not 1 to 3",
                        dimension);
    if (count < least)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "there %s %d point%s, and at least %d are needed",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count), least);
    if (count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "there are %d points; the limit is %d", count,
                        (int)BAT_MAX_POINTS);
    const size_t n = (size_t)count * (size_t)dimension, bad = bat_first_not_finite(points, n);
    if (bad < n)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of point %zu is %g",
                        bad % (size_t)dimension + 1, bad / (size_t)dimension + 1, points[bad]);
    return BATTEN_OK;
}

batten_status bat_parameters_check(int count, const double *parameters)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(parameters[i]))
            return bat_fail(BATTEN_NOT_FINITE, "parameter %d is %g", i + 1, parameters[i]);
        if (i > 0 && !(parameters[i] > parameters[i - 1]))
            return bat_fail(BATTEN_NOT_INCREASING,
                            "parameter %d is %.17g, not above the one before, %.17g", i + 1,
                            parameters[i], parameters[i - 1]);
    }
    return BATTEN_OK;
}

batten_status bat_wrong_dimension(batten_points points, int expected)
{
    return bat_fail(BATTEN_UNSUPPORTED, "the points have %d coordinates, %d are expected",
                    points.dimension, expected);
}
