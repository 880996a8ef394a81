#ifndef BATTEN_OFFSET_H
#define BATTEN_OFFSET_H
/**
 * @file
 * Parallel curves and surfaces, and free-form deformation: shapes in a box that follow its lattice of control points.
 */
#include <batten/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What goes around the outside of a corner. */
typedef enum batten_offset_corner {
    BATTEN_OFFSET_ROUND, /**< an arc about the corner: the true offset */
    BATTEN_OFFSET_MITRE, /**< both sides continue straight until they meet */
    BATTEN_OFFSET_SQUARE /**< both sides continue straight as far as the tangent of the arc in its
                              middle */
} batten_offset_corner;

typedef enum batten_loops {
    BATTEN_LOOPS_REMOVE, /**< only what is as far from the whole curve as asked stays */
    BATTEN_LOOPS_KEEP /**< the offset of every point, with its cusps and loops, in one piece */
} batten_loops;

typedef struct batten_curve_offset_options {
    size_t size;
    double tolerance; /**< model units, > 0: how far from the true offset; 1e-4 */
    batten_offset_corner corners;
    double mitre_limit; /**< a mitre longer than this times the distance becomes SQUARE; 4 */
    batten_loops loops;
    batten_vec3 normal; /**< of a curve in space: the offset goes across this direction and the
                             tangent; (0, 0, 1) */
    int most_pieces;    /**< of one run between corners; more are TOLERANCE_NOT_MET. 100,000 */
} batten_curve_offset_options;
/** The defaults of parallel curves: those beside the fields of batten_curve_offset_options. */
BATTEN_API batten_curve_offset_options batten_curve_offset_defaults(void);

typedef struct batten_curve_offset_report {
    double error;  /**< the largest distance from the true offset at equal parameters: 1.1374
                        times that of 7 samples of each piece, a bound once the error of the
                        pieces varies linearly; 0 when all is lines and arcs */
    int cusps;     /**< places where curvature times distance is 1 */
    int crossings; /**< of the offset with itself, before loops were removed */
    int removed;   /**< parts that were nearer to the curve than asked */
} batten_curve_offset_report;

/**
 * The offset of a curve: P + distance * normal, where the normal points to the left.
 *
 * Lines and arcs give lines and arcs, exactly; all else pieces of degree 5 that have the point,
 * the first and the second derivative of the true offset at their ends. With REMOVE the offset
 * is cut where it crosses itself and wherever it comes too near to the curve, and what is left
 * is joined: none, one or several curves. Pieces keep the parameters of the curve where nothing
 * was cut. An end of an open curve keeps distance too, as if it had a round cap. Loops that
 * come nearer by less than three tolerances may stay, and parts whose ends lie within the
 * tolerance of each other are joined there.
 *
 * @param curve    of 2 or 3 dimensions; periodic curves give clamped closed ones
 * @param distance model units; negative: to the right
 * @param options  NULL for the defaults
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK, also with no curve when nothing is that far inside; BAD_ARGUMENT,
 * NOT_FINITE, UNSUPPORTED (dimension 1), SINGULAR_HERE (curve along `normal`, or a point),
 * TOLERANCE_NOT_MET, TOO_LARGE
 *
 * Cost: for each piece the distance of a few points, log n as long as few spans are that near;
 * n log n for crossings.
 * Source: [TH84], [EK91].
 */
BATTEN_API batten_status batten_curve_offset(const batten_curve *curve, double distance,
                                             const batten_curve_offset_options *options,
                                             batten_curve_offset_report *report,
                                             batten_curves *out);
typedef struct batten_surface_offset_options {
    size_t size;
    double tolerance; /**< model units: how far from the true offset; 0: the true one, of the
                           kind "offset", where it is not a NURBS surface. 1e-4 */
    bool keep;        /**< make it also where it turns over; else that is refused. false */
    int most_points;  /**< of the surface near it; more are TOLERANCE_NOT_MET. 4,000,000 */
} batten_surface_offset_options;
/** The defaults of parallel surfaces: those beside the fields of
 * batten_surface_offset_options. */
BATTEN_API batten_surface_offset_options batten_surface_offset_defaults(void);

typedef struct batten_surface_offset_report {
    bool exact;         /**< a NURBS surface of the knots and weights of the given one */
    double error;       /**< the largest measured distance from the true offset at equal
                             parameters, 0 when exact or of the kind "offset" */
    double least, most; /**< principal curvatures of the given surface, as far as they were
                             found: most >= least, positive where it bends to its normal */
    double factor;      /**< the least 1 - distance * curvature: not above 0 where the offset
                             has a ridge or lies the other way round */
    double at[2];       /**< the parameters of that place */
    batten_interval turned[2]; /**< the box of u and v that holds all places found where the
                               factor is 0 or less; empty, a > b, when there are none */
} batten_surface_offset_report;

/**
 * S + distance * n, with the unit normal n of Su x Sv; at the same parameters.
 *
 * The offset of a plane, sphere, cylinder, cone, torus, pipe or surface turned from lines and
 * arcs is a surface with the same knots and weights; that is tried with each surface, and
 * verified at 9 places of each patch to 1e-12 of its size. All others are met within the
 * tolerance. Derivatives of the offset come from one order more of the surface's, at poles
 * (edges that are points) two, and are exact; very near a pole they lose digits to rounding. A
 * pole whose normals agree stays a pole; the apex of a cone becomes a circle.
 *
 * Where 1 - distance * curvature vanishes the offset has a ridge. Principal curvatures are
 * sampled, at degree + 1 places or more of each span both ways, and the extreme ones refined by
 * a search around them; what lies between samples and not near an extreme of them is not seen.
 * Whether far parts of the offset cross each other is not asked.
 *
 * @param surface  NURBS, in space; knots where normals jump by more than 1e-6 are refused
 * @param distance model units; negative: against the normal
 * @param options  NULL for the defaults
 * @param[out] report  what was reached; may be NULL; filled in also after SINGULAR_HERE for a
 *              turned offset
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE; UNSUPPORTED (other kinds: make them NURBS first,
 * with the error that this has); NOT_COMPATIBLE (a crease, with its place and angle);
 * SINGULAR_HERE (no normal, with the place; or an offset that turns over, with place, radius
 * and the box of parameters); TOLERANCE_NOT_MET, TOO_LARGE, OVERFLOW
 *
 * Cost: about 30 evaluations for each patch of degree 3; those of batten_surface_to_nurbs.
 * Source: [PM02] ch. 11.
 */
BATTEN_API batten_status batten_surface_offset(const batten_surface *surface, double distance,
                                               const batten_surface_offset_options *options,
                                               batten_surface_offset_report *report,
                                               batten_surface **out);

/* ---- free-form deformation ---- */

/** A map of space by a lattice of control points; immutable, shared among threads. */
typedef struct batten_deformation batten_deformation;

/** A box along the axes and the lattice in it. */
typedef struct batten_lattice {
    batten_box box; /**< of some extent in x, y and z */
    int counts[3];  /**< lattice points in x, y and z, each 2 or more */
    int degrees[3]; /**< 1 to 8 each, below the count; count - 1: one Bezier polynomial, less: a
                         B-spline of count - degree equal spans */
} batten_lattice;

/** What becomes of shapes that leave the box. Where they may, they stay outside as they are, and the layers of lattice
 * points beside the sides through which they leave may not be moved. */
typedef enum batten_box_join {
    BATTEN_BOX_JOIN_NONE,      /**< they are refused */
    BATTEN_BOX_JOIN_POSITION,  /**< one layer stays: the map is continuous */
    BATTEN_BOX_JOIN_TANGENT,   /**< two layers: its first derivatives are, too */
    BATTEN_BOX_JOIN_CURVATURE, /**< three layers: the second ones, too */
    BATTEN_BOX_JOIN_COUNT      /**< how many there are */
} batten_box_join;

typedef struct batten_deformation_options {
    size_t size;          /**< set by batten_deformation_defaults */
    batten_box_join join; /**< NONE */
    int most_parts;       /**< parts of spans that the search for folds takes at most; 4096 */
} batten_deformation_options;

/** Shapes within the box, and 4096 parts. */
BATTEN_API batten_deformation_options batten_deformation_defaults(void);

/** Whether a deformation turns space inside out somewhere in its box. */
typedef enum batten_folding {
    BATTEN_FOLDS_NOWHERE, /**< proved: the determinant of the Jacobian is above `bound`, above 0 */
    BATTEN_FOLDS,         /**< it is `least`, 0 or less, at `at` */
    BATTEN_FOLDS_UNKNOWN /**< no fold was found, and none excluded, in `most_parts` */
} batten_folding;

typedef struct batten_deformation_report {
    batten_folding folding;
    double bound; /**< the determinant is nowhere below, over the box; 1 where nothing moves */
    double least; /**< the least that was met */
    double at[3]; /**< where in the box, before it is deformed */
    double
        moved; /**< the longest move of a lattice point, model units: no point moves farther */
} batten_deformation_report;

/**
 * Where the lattice points are when nothing is deformed: at the Greville abscissae, evenly for a Bezier lattice.
 *
 * @param lattice  the box, counts and degrees
 * @param[out] points  [counts[0]][counts[1]][counts[2]][3], model units; z runs fastest
 * @return BATTEN_OK; BAD_ARGUMENT, BAD_DEGREE, NOT_FINITE, TOO_LARGE for a lattice that cannot be
 *
 * Cost: linear in the lattice points.
 */
BATTEN_API batten_status batten_lattice_home(const batten_lattice *lattice, double *points);

/**
 * The map D(x) = sum of N_i(s) N_j(t) N_k(r) P_ijk, where (s, t, r) are the coordinates of x in the box, from 0 to 1,
 * and N the B-splines of the degrees over evenly spaced clamped knots. With all points at home D is the identity.
 *
 * Whether it folds is judged here, by the Bezier coefficients of the determinant of its Jacobian, span by span, which are
 * halved until their sign is one or a value of 0 or less is met. Only local folds are found: distant parts may still come to
 * lie upon each other.
 *
 * @param lattice  the box, counts and degrees
 * @param points  [counts[0]][counts[1]][counts[2]][3], model units; z runs fastest; copied
 * @param options  NULL: the defaults
 * @param[out] report  may be NULL
 * @param[out] out  the map, also when it folds: then nothing can be deformed by it
 * @return BATTEN_OK; BAD_ARGUMENT, BAD_DEGREE, NOT_FINITE, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the spans that move; for each p^6 for degrees p, some 0.1 ms for cubics.
 * Source: [SP86], [GP89] for B-splines.
 */
BATTEN_API batten_status batten_deformation_create(const batten_lattice *lattice,
                                                   const double *points,
                                                   const batten_deformation_options *options,
                                                   batten_deformation_report *report,
                                                   batten_deformation **out);
/** One more reference to a deformation, from borrowed to yours. */
BATTEN_API batten_deformation *batten_deformation_ref(const batten_deformation *deformation);
/** Give a reference to a deformation back; NULL is welcome. */
BATTEN_API void batten_deformation_unref(batten_deformation *deformation);

/**
 * The images of points.
 *
 * @param deformation  one that does not fold
 * @param points  in space, model units
 * @param[out] out  [points.count][3]; may be the given points
 * @return BATTEN_OK; SINGULAR_HERE when the deformation folds, with the place; OUT_OF_DOMAIN naming the first point
 * outside of a box that refuses it; NOT_COMPATIBLE for a side that they leave and whose layers are moved;
 * BAD_ARGUMENT for points that are not in space; NOT_FINITE
 *
 * Cost: (p + 1)^3 multiplications each for degrees p; no allocation.
 */
BATTEN_API batten_status batten_deformation_apply(const batten_deformation *deformation,
                                                  batten_points points, double *out);

/**
 * The curve near the image of a curve: quintic pieces that agree with the image in point and first two derivatives where
 * they meet, halved until they are near enough, with the parameters of the given curve. Measured between seven samples of
 * each piece; not exact but where the image is of degree 5 or less.
 *
 * @param curve  in space, in the box or as the deformation allows
 * @param deformation  one that does not fold
 * @param tolerance  model units, > 0; at equal parameters
 * @param[out] error  the largest that was measured; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_deformation_apply; UNSUPPORTED for curves that are not in space; BAD_ARGUMENT,
 * TOLERANCE_NOT_MET, OUT_OF_MEMORY
 *
 * Cost: some twenty evaluations for each piece that is tried.
 * Source: [SP86].
 */
BATTEN_API batten_status batten_curve_deform(const batten_curve *curve,
                                             const batten_deformation *deformation,
                                             double tolerance, double *error,
                                             batten_curve **out);

/**
 * The biquintic B-spline near the image of a surface, with its parameters, measured between the points that it
 * interpolates.
 *
 * @param surface  in space, in the box or as the deformation allows
 * @param deformation  one that does not fold
 * @param tolerance  model units; 0: the image itself, as a surface of the kind "deformed"
 * @param[out] error  the largest distance at equal parameters that was measured; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_curve_deform; UNSUPPORTED for surfaces that are not in space
 *
 * Cost: as batten_surface_to_nurbs of a formula.
 * Source: [SP86].
 */
BATTEN_API batten_status batten_surface_deform(const batten_surface *surface,
                                               const batten_deformation *deformation,
                                               double tolerance, double *error,
                                               batten_surface **out);

/**
 * The mesh with its vertices moved, and nothing else: triangles stay flat. Normals of corners follow the map.
 *
 * @param mesh  in the box or as the deformation allows
 * @param deformation  one that does not fold
 * @param[out] error  the largest distance of the middle of a side from the image of that middle; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_deformation_apply; OUT_OF_MEMORY
 *
 * Cost: linear in vertices and triangles.
 */
BATTEN_API batten_status batten_mesh_deform(const batten_mesh *mesh,
                                            const batten_deformation *deformation,
                                            double *error, batten_mesh **out);

/**
 * The body whose faces and edges are near the images of those of a body; what belongs together stays together. Surfaces
 * are taken as far as their faces reach.
 *
 * @param body  in the box or as the deformation allows
 * @param deformation  one that does not fold
 * @param tolerance  model units, > 0, of surfaces and of edges at equal parameters
 * @param job  for tracing faces that lack parameter curves; may be NULL
 * @param[out] error  the largest that was measured; may be NULL
 * @param[out] out  the result, whose tolerance is that of the body, stretched, and twice `tolerance` more
 * @return as batten_surface_deform; what batten_body_trace returns; NOT_COMPATIBLE where a face cannot be traced
 *
 * Cost: that of its surfaces and edges.
 */
BATTEN_API batten_status batten_body_deform(const batten_body *body,
                                            const batten_deformation *deformation,
                                            double tolerance, const batten_job *job,
                                            double *error, batten_body **out);

#ifdef __cplusplus
}
#endif
#endif
