#ifndef BATTEN_THIN_H
#define BATTEN_THIN_H
/**
 * @file
 * Fewer points: rows of points, and polylines, without those that say nothing.
 */
#include <batten/geometry.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How far the points that went are from the polyline through those that stayed, each from the
 * chord that stands for it; model units. */
typedef struct batten_thin_report {
    double max, rms; /**< the largest, root of the mean square over all points */
    int worst;       /**< index of the farthest point */
} batten_thin_report;

/**
 * The points of a row that are needed so that every other point lies within `tolerance` of the
 * chord between its two kept neighbours.
 *
 * The distance is that of the points from the chords, not of the chords from the row: where a
 * row runs to and fro, a chord may lie farther from it than `tolerance`. A row is split where
 * it is farthest from its chord, so corners stay; the ends stay. Parts that would cost more
 * than 32 log2(count) looks at each point that way are walked with chords as long as the
 * tolerance allows, which keeps the bound.
 *
 * @param points    [count][dimension], dimension 2 or 3; neighbours may coincide
 * @param tolerance model units, 0 or more; with 0 only points that lie on their chords to
 *                  rounding go
 * @param closed    the last point is followed by the first; then any point may go, but two stay
 * @param[out] kept [count], indices of those that stay, increasing
 * @param[out] kept_count
 * @param[out] report may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS (none), NOT_FINITE, OVERFLOW
 * (coordinates above 1e150)
 *
 * Cost: count log(count) at most, no recursion. Source: [Ramer72], [DP73].
 */
BATTEN_API batten_status batten_points_thin(int dimension, int count, const double *points,
                                            double tolerance, bool closed, int *kept,
                                            int *kept_count, batten_thin_report *report);

#ifdef __cplusplus
}
#endif
#endif
