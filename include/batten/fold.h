#ifndef BATTEN_FOLD_H
#define BATTEN_FOLD_H
/**
 * @file
 * The folded edge: a sheet folded along a curve becomes two developable surfaces.
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

/** What is given besides the crease. Values along it are at equal steps of its length: one is a
 * constant, two a line, more a cubic through them. */
typedef enum batten_fold_given {
    BATTEN_FOLD_ANGLE,     /**< crease in space, and the angles a */
    BATTEN_FOLD_CURVATURE, /**< crease in space, and the curvature of the flat crease, below its
                                own: a = arccos of the quotient */
    BATTEN_FOLD_FLAT /**< crease in the flat sheet, the angles a, and torsions of the space
                          curve that it becomes: k = flat curvature / cos a */
} batten_fold_given;

typedef struct batten_fold_options {
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
} batten_fold_options;
/** One angle of 30 degrees must still be put in its place: `values` is NULL. */
BATTEN_API batten_fold_options batten_fold_defaults(void);

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
 * the lengths of their edges are within the tolerance. Source: [Huffman76], [DuncanDuncan82],
 * [FuchsTabachnikov99].
 */
BATTEN_API batten_status batten_fold_create(const batten_curve *crease,
                                            const batten_fold_options *options,
                                            batten_fold *out);
BATTEN_API void batten_fold_release(batten_fold *fold);

#ifdef __cplusplus
}
#endif
#endif
