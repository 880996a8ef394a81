#ifndef BATTEN_CATMULL_ROM_H
#define BATTEN_CATMULL_ROM_H
/**
 * @file
 * The class of Catmull and Rom: local polynomials through a few points, blended with B-splines;
 * and the cubics of its kind whose tangents are shaped by hand: cardinal splines, and those of
 * Kochanek and Bartels.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What stands beyond the ends of an open row of points, where a local method asks for more
 * points than there are. Their parameters go on in the mirror image of the steps. */
typedef enum batten_phantoms {
    BATTEN_PHANTOM_EXTRAPOLATE, /**< the polynomial through the end points goes on: of the
                                     degree that the method reproduces, as points allow */
    BATTEN_PHANTOM_REFLECT,     /**< the points beyond are those inside, mirrored in the end
                                     point: the curve ends without bending where it is C2 */
    BATTEN_PHANTOM_REPEAT       /**< the end point is repeated: the curve starts slowly */
} batten_phantoms;

typedef struct batten_catmull_rom_options {
    size_t size;
    int blend;    /**< degree of the B-splines that blend, k - 1: 1 or more; 2 */
    int local;    /**< degree of the polynomials that are blended, m: 0 or more; 1 */
    double alpha; /**< steps are chords to this power: 0 uniform, 1/2 centripetal, 1 chords; 0
                       to 1; 0.5 */
    const double *given;      /**< parameters [count], closed [count + 1], instead of alpha */
    bool closed;              /**< the first point is not repeated */
    batten_phantoms phantoms; /**< BATTEN_PHANTOM_EXTRAPOLATE */
} batten_catmull_rom_options;
BATTEN_API batten_catmull_rom_options batten_catmull_rom_defaults(void);

typedef struct batten_catmull_rom_report {
    int continuity; /**< derivatives that are continuous for all points: k - 2; from m = k on
                         k - 1 */
    bool through;   /**< does it pass the points: m >= k - 2 */
    double off;     /**< largest distance of a point from the curve at its parameter */
} batten_catmull_rom_report;

/**
 * The curve F(t) = sum L_j(t) N_j(t): N_j are the B-splines of order k with knots at the
 * parameters of the points, L_j is the polynomial of degree m through the m + 1 points in the
 * middle of the knots of N_j. Degree m + k - 1; it reproduces polynomials of degree max(m, k -
 * 1) of the parameter.
 *
 * With k = 3, m = 1 this is the spline of Catmull and Rom, whose cubics have no cusps and do
 * not cross themselves for alpha = 1/2. Of (k, m) and (k + 1, m - 1) with m = k both give the
 * same curve. Where m - k is odd the middle falls between points: L_j then takes one more point
 * after it than before, and reversed points give another curve.
 *
 * @param points  [count][dimension], dimension 1 to 3, 2 points, closed 3; neighbours apart
 * unless alpha is 0
 * @param options NULL for the defaults
 * @param[out] parameters [count], closed [count + 1]; may be NULL
 * @param[out] report may be NULL
 * @param[out] out a B-spline curve with just so many knots at each parameter as its continuity
 * asks for
 * @return BATTEN_OK, BAD_ARGUMENT, BAD_DEGREE, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT or
 * OVERFLOW naming the points, NOT_INCREASING, TOO_LARGE; TOLERANCE_NOT_MET when the curve
 * misses a point by more than rounding
 *
 * A point that moves changes at most m + k spans. Cost: (m + k)^3 for a span.
 * Source: [CR74], [BG88]; [YSK11] for alpha.
 */
BATTEN_API batten_status batten_curve_catmull_rom(
    int dimension, int count, const double *points, const batten_catmull_rom_options *options,
    double *parameters, batten_catmull_rom_report *report, batten_curve **out);

typedef struct batten_kochanek_bartels_options {
    size_t size;
    const double *tension; /**< [count], NULL for 0: 1 halts at a point, below 0 is rounder */
    const double *continuity; /**< [count], NULL for 0: -1 turns at a point as the chords do, 1
                                   turns there the other way; not 0: a corner */
    const double *bias;       /**< [count], NULL for 0: 1 leaves along the chord before the
                                   point, -1 along the one after */
    double alpha;             /**< as for batten_catmull_rom_options; 0 */
    const double *given;
    bool closed;
    batten_phantoms phantoms;
} batten_kochanek_bartels_options;
BATTEN_API batten_kochanek_bartels_options batten_kochanek_bartels_defaults(void);

/**
 * Tangents of Kochanek and Bartels; with batten_curve_from_tangents they make the curve. With
 * tension alone it is the cardinal spline, with zeros the cubic of Catmull and Rom.
 *
 * For uneven steps the two chords at a point weigh as in Bessel's parabola, so that zeros give
 * the curve of Catmull and Rom for every alpha; the authors weigh them the other way round
 * there.
 *
 * @param points [count][dimension], dimension 1 to 3, 2 points, closed 3
 * @param options NULL for the defaults
 * @param[out] parameters [count], closed [count + 1]
 * @param[out] leaving, arriving [count][dimension]: derivatives after each point and before it,
 * the same bits where continuity is 0
 * @return as batten_curve_catmull_rom. Cost: linear in count. Source: [KB84].
 */
BATTEN_API batten_status
batten_tangents_kochanek_bartels(int dimension, int count, const double *points,
                                 const batten_kochanek_bartels_options *options,
                                 double *parameters, double *leaving, double *arriving);

#ifdef __cplusplus
}
#endif
#endif
