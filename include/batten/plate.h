#ifndef BATTEN_PLATE_H
#define BATTEN_PLATE_H
/**
 * @file
 * Plates: developable surfaces, their flat patterns, and folds.
 *
 * A ruling from a point of the first edge to one of the second belongs to a developable surface
 * where the tangents of both edges and the ruling lie in one plane, which then touches the
 * surface all along it. The angle between the normals at its ends is the warp.
 *
 * At a crease with curvature k and torsion tau both sheets stand at the angle a to its
 * osculating plane, on its two sides; so they meet at pi - 2 a. In the flat sheet the crease
 * has the curvature k cos a. A negative angle folds the other way: mountain and valley change
 * places.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_surface_developable_options {
    size_t size;
    bool keep_matching;   /**< points of equal parameter are joined, exactly; only the warp is
                               looked at. Else rulings are found; false */
    double tolerance;     /**< of the edges, model units, > 0 */
    double warp;          /**< largest of a surface called developable, radians; 0.5 degrees */
    bool keep_regression; /**< an edge of regression between the edges is reported, not refused;
                               false */
} batten_surface_developable_options;
/** The defaults of developable surfaces: those beside the fields of
 * batten_surface_developable_options. */
BATTEN_API batten_surface_developable_options batten_surface_developable_defaults(void);

/** One ruling of the surface. */
typedef struct batten_ruling {
    double u;    /**< of the surface */
    double s, t; /**< parameters on the first and on the second edge */
    double warp; /**< angle between the normals at its ends, radians; 0 where one end rests */
} batten_ruling;

typedef struct batten_developable {
    batten_surface *surface; /**< v = 0 on the first edge, 1 on the second; u from 0 to 1 */
    int count;
    batten_ruling *rulings; /**< [count] */
    bool cone[2]; /**< the surface begins, or ends, with a cone about the end of one edge */
    double error; /**< of the edges of the surface, measured midway between the rulings; 0 when
                       they are exact */
    double warp;  /**< the largest, between the rulings too, radians */
    double warp_at;       /**< the u where it is */
    bool is_developable;  /**< the warp is within that of the options, and there is no edge of
                               regression between the edges */
    bool has_regression;  /**< rulings that follow each other meet between the edges */
    double regression_at; /**< the u where they do so first */
    double regression_share; /**< of the ruling there, from the first edge */
} batten_developable;

/**
 * The developable surface between two curves.
 *
 * The pairs of points that rulings join form a path from the start of both edges to their ends.
 * Of all such paths on a lattice of equal steps of length that of the least warp is taken by
 * dynamic programming, and its pairs are then moved to where the warp is 0. Where one edge ends
 * before the other, the rest is a cone about its end. Where there is no developable surface,
 * the one of nearly the least warp comes back, and it is said how large that is. One edge may
 * be a point.
 *
 * Edges are exact where rulings join equal shares of both domains, and in cones; else they are
 * followed within the tolerance, by C2 cubics, or by C1 cubics in warped plates, where rulings
 * without warp exist in places only. Closed edges begin with the ruling between their starts.
 *
 * @param first, second in space or plane, smooth, open or closed; they may meet at their ends
 * only
 * @param options NULL for the defaults
 * @param[out] out filled; give it back with batten_developable_release
 * @return BATTEN_OK; BAD_ARGUMENT (options, two points); NOT_COMPATIBLE for edges with corners,
 * that touch, that run against each other, or with an edge of regression between them: with the
 * parameters; SINGULAR_HERE for an edge without tangent; TOLERANCE_NOT_MET
 *
 * Cost: about 40000 evaluations of the warp, and some for each ruling.
 * Source: [PW01] 6; [Aumann91] for the condition.
 */
BATTEN_API batten_status batten_surface_developable(
    const batten_curve *first, const batten_curve *second,
    const batten_surface_developable_options *options, batten_developable *out);
/** Release a developable surface and its rulings. */
BATTEN_API void batten_developable_release(batten_developable *developable);

/**
 * Do the tangent planes at both ends of a line from first(s) to second(t) agree?
 *
 * @param first, second  of dimension 2 or 3
 * @param s  on the first
 * @param t  on the second
 * @param[out] condition det(first'(s), second'(t), second(t) - first(s)): 0 where they do, or
 * where a tangent runs along the line
 * @param[out] warp the angle between the planes, radians, 0 to pi; NaN where one has no plane.
 * pi, with condition 0, where the surface would turn over
 * @return as batten_curve_evaluate
 *
 * Cost: two evaluations to order 1; no allocation.
 */
BATTEN_API batten_status batten_ruling_condition(const batten_curve *first, double s,
                                                 const batten_curve *second, double t,
                                                 double *condition, double *warp);
/** Which lines of the surface are its rulings. */
typedef enum batten_straight {
    BATTEN_STRAIGHT_FIND, /**< those that are straighter */
    BATTEN_STRAIGHT_V,    /**< v runs along the rulings */
    BATTEN_STRAIGHT_U
} batten_straight;

typedef struct batten_surface_unroll_options {
    size_t size;
    batten_straight straight; /**< BATTEN_STRAIGHT_FIND */
    double tolerance; /**< of the flat outline, and of how straight the rulings are; model
                           units, > 0 */
} batten_surface_unroll_options;
/** The defaults of flat patterns: those beside the fields of batten_surface_unroll_options. */
BATTEN_API batten_surface_unroll_options batten_surface_unroll_defaults(void);

/** A surface laid flat. The first edge is where the rulings begin; it starts at (0, 0), and the
 * first ruling points along y. */
typedef struct batten_unrolled {
    batten_surface *surface;      /**< NURBS with its rulings along v */
    batten_curve *first, *second; /**< flat edges [2], with the u of the surface; a vertex of a
                                       cone is an edge of length 0 */
    int count;      /**< of rulings known: those between the cubic pieces of the edges */
    double *u;      /**< [count] where they are */
    double *points; /**< [count][2][2] their flat ends, on the first and on the second edge */
    double turn;    /**< of the rulings from first to last, radians, positive to the left */
    double error;   /**< of the flat edges, model units, measured midway between the rulings */
    double bow;     /**< how far a line taken for a ruling is from its chord */

    /* What the sheet suffers: 0 but for rounding when the surface is developable. */
    double length_first[2], length_second[2]; /**< of the edges: in space, flat */
    double area[2];                           /**< in space, flat */
    double strain;       /**< largest relative change of length at a point, in any direction */
    double strain_rms;   /**< its root mean square over the area */
    double strain_at[2]; /**< (u, v) of the largest */
    double diagonal[2];  /**< largest relative change of a diagonal between neighbouring known
                              rulings, and the u where it is */
} batten_unrolled;

/**
 * Lay a ruled surface flat.
 *
 * Each ruling keeps its length; it turns in the plane as fast as it turns in space about the
 * normal of the surface midway along it, and the first edge moves as it moves in the tangent
 * plane there. For developable surfaces this is the isometry; for others the tangent planes at
 * the ends of a ruling differ, and the strain says what that costs. Seen so that the normal
 * S_u x S_v points to the reader or away from him: first edge below for u to the right.
 *
 * Closed surfaces are cut at their seam. Outlines that overlap themselves in the plane are not
 * looked for.
 *
 * @param surface  in space or in the plane, any kind: any other than NURBS is converted within
 *              the tolerance
 * @param options NULL for the defaults
 * @param[out] out filled; give it back with batten_unrolled_release
 * @return BATTEN_OK; BAD_ARGUMENT (tolerance); NOT_COMPATIBLE where no lines are straight
 * within the tolerance, with the distance and place; SINGULAR_HERE where a ruling has no length
 * within the surface or the surface no tangent plane, with the u; TOLERANCE_NOT_MET
 *
 * Cost: linear in the number of known rulings, which are doubled until the edges are within the
 * tolerance; the integration is of order 8 in their distance, the edges of order 4. Source:
 * [PW01] 6.
 */
BATTEN_API batten_status batten_surface_unroll(const batten_surface *surface,
                                               const batten_surface_unroll_options *options,
                                               batten_unrolled *out);
/**
 * Release a flat pattern.
 *
 * @param unrolled  the flat pattern
 */
BATTEN_API void batten_unrolled_release(batten_unrolled *unrolled);

/**
 * Where a point of the surface is in the plane: a mark.
 * @param unrolled  of batten_surface_unroll
 * @param u, v of `unrolled->surface`
 * @param[out] out as exact as the edges
 * @return BATTEN_OK or OUT_OF_DOMAIN
 *
 * Cost: three points of the surface and two of the edges.
 */
BATTEN_API batten_status batten_unrolled_at(const batten_unrolled *unrolled, double u, double v,
                                            batten_vec2 *out);
/** What is given besides the crease. Values along it are at equal steps of its length: one is a
 * constant, two a line, more a cubic through them. */
typedef enum batten_fold_given {
    BATTEN_FOLD_ANGLE,     /**< crease in space, and the angles a */
    BATTEN_FOLD_CURVATURE, /**< crease in space, and the curvature of the flat crease, below its
                                own: a = arccos of the quotient */
    BATTEN_FOLD_FLAT /**< crease in the flat sheet, the angles a, and torsions of the space
                          curve that it becomes: k = flat curvature / cos a */
} batten_fold_given;

typedef struct batten_fold_create_options {
    size_t size;
    batten_fold_given given; /**< BATTEN_FOLD_ANGLE */
    int count;               /**< of the values */
    const double *values;    /**< [count] angles in radians, 0 < |a| < pi / 2; or curvatures */
    int torsion_count;
    const double *torsions; /**< [torsion_count] with FLAT; NULL: 0, the crease stays plane */
    bool other_side;        /**< CURVATURE: the angles are negative */
    double left, right;     /**< widths of the sheets, at right angles to the crease */
    double tolerance;       /**< of the surfaces and of the lengths of edges in space and flat;
                                 model units, > 0 */
} batten_fold_create_options;
/** One angle of 30 degrees must still be put in its place: `values` is NULL. */
BATTEN_API batten_fold_create_options batten_fold_create_defaults(void);

/** One side of the crease. */
typedef struct batten_fold_sheet {
    batten_surface *surface; /**< degree 3 along the crease, 1 along the rulings: v = 0 on it */
    double *rulings;         /**< [count][3] unit directions, away from the crease */
    double *flat_rulings;    /**< [count][2] the same in the flat sheet */
    double *lengths;         /**< [count] of the rulings, to the edge of the sheet */
    double regression;       /**< smallest distance of the edge of regression, at right angles
                                  to the crease: the sheet could be so wide; infinity for none */
    double regression_at;    /**< length along the crease where that is */
} batten_fold_sheet;

typedef struct batten_fold {
    int count;            /**< samples along the crease, at equal steps of length */
    double length;        /**< of the crease */
    batten_curve *crease; /**< in space */
    double *points;       /**< [count][3] of the crease */
    double *flat;         /**< [count][2] of the crease in the flat sheet */
    double *angles;       /**< [count] a */
    batten_fold_sheet left, right;
    double flat_turn; /**< integral of the flat curvature, radians */
    double error;     /**< of the surfaces, measured between the samples */
    double twist;     /**< largest |det(T, r, r')| against |r'|: 0 for developables */
    double stretch;   /**< largest relative difference between the lengths of an edge in
                           space and in the flat sheet */
} batten_fold;

/**
 * Fold a sheet along a crease.
 *
 * @param crease in space (FLAT: in the plane, or in space with z constant), curvature nowhere
 * 0, not closed
 * @param[out] out filled; give it back with batten_fold_release
 * @return BATTEN_OK; BAD_ARGUMENT (options, an angle out of range); SINGULAR_HERE where the
 * crease is straight or has no tangent, with the length along it; NOT_COMPATIBLE where the flat
 * curvature is not below that of the crease, or a sheet would be wider than its edge of
 * regression allows, with the place and the width that would do; TOLERANCE_NOT_MET
 *
 * Cost: linear in the number of samples, which is doubled from 65 until the surfaces and
 * the lengths of their edges are within the tolerance.
 * Source: [Huffman76], [DuncanDuncan82], [FuchsTabachnikov99].
 */
BATTEN_API batten_status batten_fold_create(const batten_curve *crease,
                                            const batten_fold_create_options *options,
                                            batten_fold *out);
/** Release a fold. */
BATTEN_API void batten_fold_release(batten_fold *fold);

#ifdef __cplusplus
}
#endif
#endif
