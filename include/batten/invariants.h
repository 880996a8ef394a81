#ifndef BATTEN_INVARIANTS_H
#define BATTEN_INVARIANTS_H
/**
 * @file
 * What no affine map changes about a polynomial curve of any degree: its singular points, its
 * canonical form and invariants, whether another curve is an affine image of it, its affine
 * arc length.
 *
 * A span is given by its Bezier points and stands for the polynomial X(t) with t from 0 to 1;
 * "the whole" is the same polynomial for all real t. Cubics have more of their own in cubic.h.
 */
#include <batten/inspect.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the census: inflections, cusps, double points, each of them and how many ---- */

/* The one table of special points: name, word, plural. */
#define BATTEN_SPECIAL_TABLE(ROW)                \
    ROW(INFLECTION, "inflection", "inflections") \
    ROW(UNDULATION, "undulation", "undulations") \
    ROW(CUSP, "cusp", "cusps")                   \
    ROW(PAUSE, "pause", "pauses")                \
    ROW(CROSSING, "crossing", "crossings")       \
    ROW(ISOLATED, "isolated point", "isolated points")

#define BATTEN_SPECIAL_ENUM(name, word, plural) BATTEN_SPECIAL_##name,
/**
 * INFLECTION: x'y'' - x''y' changes its sign. UNDULATION: it is 0 and does not. CUSP: the
 * curve stops and turns back, x' and y' vanish to an odd order. PAUSE: it stops and goes on.
 * CROSSING: it passes twice through a point (a crunode, or a tacnode). ISOLATED: a real point
 * with two conjugate complex parameters, off the curve that is drawn (an acnode).
 */
typedef enum batten_special_kind {
    BATTEN_SPECIAL_TABLE(BATTEN_SPECIAL_ENUM) BATTEN_SPECIAL_COUNT
} batten_special_kind;
#undef BATTEN_SPECIAL_ENUM

/** "isolated point", or in the plural "isolated points". */
BATTEN_API const char *batten_special_name(batten_special_kind kind, bool plural);

typedef struct batten_special {
    batten_special_kind kind;
    bool inside;      /**< in the open span; of a crossing with both parameters */
    int multiplicity; /**< 1: simple; of a crossing 2 where the branches touch, and so on */
    double t;         /**< parameter; of a crossing the lower, of an isolated point the real
                         part */
    double s; /**< of a crossing the upper parameter, of an isolated point the imaginary part
                 above 0; else NaN */
    batten_vec3 point;
} batten_special;

typedef struct batten_census {
    double from, to;    /**< the span: 0 and 1, or that of the curve; so are t and s */
    int degree;         /**< of the polynomial itself, which may be below that of the form */
    int flat_dimension; /**< 0: a point, 1: a line, 2: in a plane, 3: in space, where only
                             this is found out */
    double flatness;    /**< what is missing to the dimension below, by the size of the span */
    bool is_repeated;   /**< X(t) = Y(g(t)): every point is passed more than once, so double
                             points are not counted */
    bool is_complete;   /**< double points are proved to be all; else only those crossings
                             inside are listed that a search found */
    int whole[BATTEN_SPECIAL_COUNT], segment[BATTEN_SPECIAL_COUNT];
    int complex_count;  /**< double points that are not real, by multiplicity */
    int infinite_count; /**< and those at infinity; with crossings, isolated points, cusps and
                             pauses they make (degree - 1) (degree - 2) / 2 */
    double margin;      /**< of the counts inside the span: the smallest of what x'y'' - x''y'
                             would have to change by, by its size, before it had a root more or
                             less, and of how far, in parts of the span, crossings are from
                             its ends. A pair of crossings that nearly comes to be is not seen */
    int count;
    batten_special *specials; /**< [count] by kind, then by t */
} batten_census;

/**
 * Count the special points of a polynomial span in the plane, or of one in space that lies in
 * a plane.
 *
 * The coordinates are taken as the exact numbers that they are, and all counts are decided in
 * whole numbers: they are right, boundaries included.
 *
 * @param dimension 2 or 3
 * @param degree    1 .. 25
 * @param points    [degree + 1][dimension] Bezier points
 * @param tolerance relative, 0 or more and below 1: a span within this part of its size counts
 *                  as lying in a plane, a line or a point. 0: only what does exactly
 * @param[out] out  release with batten_census_release
 * @return BATTEN_OK; BAD_ARGUMENT; BAD_DEGREE; NOT_FINITE; INCOMPLETE where the coordinates
 *         differ by more than 2^300 in size, or roots are nearer than 2^-200
 * Cost: about 0.2 ms for a cubic, 1 ms for a sextic, 0.1 s for degree 10. From degree 12 or so
 * the work of eliminating would be too large: then 0.2 s are spent and is_complete is false.
 * Source: [SL] VIII; [SWP08] for elimination, [CA76] for roots. The counts are [Walker50]'s.
 */
BATTEN_API batten_status batten_census_take(int dimension, int degree, const double *points,
                                            double tolerance, batten_census *out);
BATTEN_API void batten_census_release(batten_census *census);
/**
 * The same for every span of a polynomial curve. Its Bezier points are rounded when it has
 * more than one span, so what lies on a boundary may come to lie beside it: see the margin.
 * @param[out] count how many spans
 * @param[out] out   [count]; release with batten_censuses_release
 * @return also UNSUPPORTED for rational curves
 */
BATTEN_API batten_status batten_curve_census(const batten_curve *curve, double tolerance,
                                             int *count, batten_census **out);
BATTEN_API void batten_censuses_release(int count, batten_census *censuses);

#ifdef __cplusplus
}
#endif
#endif
