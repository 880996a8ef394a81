#ifndef BATTEN_FAIR_H
#define BATTEN_FAIR_H
/**
 * @file
 * How fair a curve is, and how to make it fairer without moving any point farther than allowed.
 */
#include <batten/curve.h>
#include <batten/offsets.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The numbers behind the word "fair"; fairing.md section 1. */
typedef struct batten_fairness {
    int inflections;        /**< of the curve; in space: of no meaning, 0 */
    int excess_inflections; /**< beyond those that the data themselves require */
    int curvature_extrema;
    double jumps;           /**< sum of squares of the jumps of the third derivative at the knots */
    double energy;          /**< integral of curvature^2 ds (functions: of the second derivative^2) */
    double variation;       /**< integral of (d curvature / ds)^2 ds */
    double max_curvature;
    bool fair;              /**< the default verdict: no excess inflections */
} batten_fairness;

/** Judge a curve. @param points its data [count][dimension], from which the required inflections are
 * counted; NULL: none are required */
BATTEN_API batten_status batten_curve_fairness(const batten_curve *curve, int count,
                                               const double *points, batten_fairness *out);

typedef enum batten_fair_order {
    BATTEN_FAIR_WORST_FIRST, /**< release the duck under the largest force */
    BATTEN_FAIR_SWEEPS,      /**< one after another, until nothing moves: the least-energy curve within the bounds */
    BATTEN_FAIR_ALTERNATE    /**< even ducks, then odd ones */
} batten_fair_order;

typedef struct batten_fair_options {
    size_t size;
    double within;            /**< no point moves farther than this, in model units; required */
    const double *within_each;/**< [count] instead of it; 0 holds a point; may be NULL */
    bool hold_ends;           /**< true */
    batten_fair_order order;  /**< BATTEN_FAIR_SWEEPS */
    double relaxation;        /**< 1; (0, 1] */
    int max_moves;            /**< 0: a bound from the number of points */
    bool stop_when_fair;      /**< stop at the verdict (worst first); else go on to the least energy */
    const int *corners;       /**< [corner_count] indices of points at which the curve is cut; held */
    int corner_count;
} batten_fair_options;

BATTEN_API batten_fair_options batten_fair_defaults(double within);

/** One move of one point, so that a user can undo it. */
typedef struct batten_fair_move {
    int set;   /**< which curve of the family; in a table the station */
    int index; /**< which point of it */
    double from[3], to[3];
} batten_fair_move;

typedef struct batten_fair_report {
    batten_fairness before, after; /**< of a family: sums, maxima, all fair */
    double max_move, rms_move;     /**< over all points, model units */
    int moved_count;               /**< points that moved at all */
    int worst_set, worst_index;    /**< where the largest move is */
    int suspect_count;             /**< points that look like blunders: force above 6 times the median with
                                        neighbours of the opposite sign */
    int move_count;                /**< length of `moves`: one for each point that moved */
    batten_fair_move *moves;       /**< release with batten_fair_report_release */
    batten_fair_move *suspects;    /**< [suspect_count], with the suggested place; not carried out */
} batten_fair_report;
BATTEN_API void batten_fair_report_release(batten_fair_report *report);

/**
 * Fair the points of one curve by bounded springback.
 *
 * Each duck in turn is released and the batten takes its place between the others, but no point
 * leaves the ball of radius `within` about where it was given. Points are moved at right angles to
 * their chord, with parameters held (plane and space); dimension 1 is a function over `parameters`.
 *
 * @param points      [count][dimension]
 * @param parameters  [count] increasing, or NULL for chord length
 * @param[out] faired [count][dimension]
 * @param[out] report may be NULL
 * Source: [SL] ch. VII.
 */
BATTEN_API batten_status batten_fair_points(int dimension, int count, const double *points,
                                            const double *parameters,
                                            const batten_fair_options *options,
                                            const batten_job *job, double *faired,
                                            batten_fair_report *report);

/** Which families of a table are faired. */
typedef enum batten_fair_families {
    BATTEN_FAIR_STATIONS = 1,
    BATTEN_FAIR_LINES = 2, /**< waterlines (half-breadths) or named lines (half-breadths and heights) */
    BATTEN_FAIR_BOTH = 3
} batten_fair_families;

/**
 * Fair a table of offsets. Heights of waterlines are never changed. The families are taken in turn
 * until no point moves by more than a tenth of the bound; the bound counts from the given table.
 * Points on the centre line stay there.
 */
BATTEN_API batten_status batten_fair_offsets(const batten_offsets *offsets,
                                             batten_fair_families families,
                                             const batten_fair_options *options,
                                             const batten_job *job, batten_fair_report *report,
                                             batten_offsets **out);

#ifdef __cplusplus
}
#endif
#endif
