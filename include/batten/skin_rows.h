#ifndef BATTEN_SKIN_ROWS_H
#define BATTEN_SKIN_ROWS_H
/**
 * @file
 * Surfaces through rows of points that do not make a grid.
 */
#include <batten/skin.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_skin_rows_options {
    size_t size;
    int degree;                        /**< along the rows, 3 */
    batten_parametrization parameters; /**< along them, each for itself; BATTEN_CENTRIPETAL */
    const double *given; /**< one for each point, row after row, each from 0 to 1, with
                            BATTEN_GIVEN */
    double margin;       /**< a knot keeps away from the ends of the interval in which it is
                              admissible by this share of its length, 0.25; below 0.5 */
    const batten_skin_options *across; /**< NULL: the defaults; without a tolerance, a spine,
                                          starts or matching */
} batten_skin_rows_options;

BATTEN_API batten_skin_rows_options batten_skin_rows_defaults(void);

typedef struct batten_skin_rows_report {
    int knot_count;          /**< distinct inner knots that all rows share */
    int separate_knot_count; /**< those that the rows have together when each is interpolated
                                  with averaged knots of its own */
    int free_rows;     /**< rows with fewer points than control points: the rest is energy */
    double span_ratio; /**< smallest span over median span along the rows */
    double residual;   /**< largest distance of a point from the surface */
} batten_skin_rows_report;

/**
 * The surface through rows of points, in each row as many as it needs.
 *
 * A row can be interpolated with any knots that are admissible for its parameters (Schoenberg
 * and Whitney). So each row, the longest first, takes those knots that other rows have already
 * and that are admissible for it, and adds one where there is none. Then all rows have the
 * knots of the surface, and no row is fitted and refitted. What a row's points leave open, for
 * it has fewer than there are control points, makes the integral of the squared second
 * derivative least (degree 1: of the first). The rows are then sections of a skin.
 *
 * @param counts [row_count], 2 or more in each row
 * @param points row after row [counts[r]][dimension]
 * @param[out] u one for each point; may be NULL
 * @param[out] v [row_count]; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS, COINCIDENT, NOT_FINITE, NOT_INCREASING naming the row;
 * BAD_DEGREE, BAD_ARGUMENT; TOO_LARGE before the work; TOLERANCE_NOT_MET when a point is missed
 * by more than 1e-11 of the size; and as batten_surface_skin
 * Cost: points n of a row that has fewer than the N control points: n N + n^3. Source: [PT00],
 * [PK96].
 */
BATTEN_API batten_status batten_surface_skin_rows(int dimension, int row_count,
                                                  const int *counts, const double *points,
                                                  const batten_skin_rows_options *options,
                                                  const batten_job *job, double *u, double *v,
                                                  batten_skin_rows_report *report,
                                                  batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
