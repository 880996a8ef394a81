#ifndef BATTEN_SWEEP_H
#define BATTEN_SWEEP_H
/**
 * @file
 * Surfaces that a curve leaves when it is moved: translated, swung, swept along a spine or two
 * rails, screwed about an axis; and those of straight lines through a curve.
 */
#include <batten/curvature.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A screw motion. */
typedef struct batten_screw {
    batten_vec3 origin, axis;
    double pitch; /**< the way along the axis for a full turn, model units */
    double angle; /**< radians */
} batten_screw;

/* ---- exact ---- */

/**
 * The translational surface: C(u) + D(v) - D(a), `curve` moved along `path` without turning,
 * where a is the start of the path. Exact, also where one or both are rational; every u-line is
 * a copy of `curve`, every v-line one of `path`.
 *
 * @param curve, path  of 1 to 3 dimensions, taken into space; degrees, knots and periods are
 *                     kept
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; COINCIDENT when one of them is a point, or both lie along one line: a
 * surface without area; TOO_LARGE (10 million control points), OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of the result: the product of those of both.
 * Source: [PT97] 10.4.
 */
BATTEN_API batten_status batten_surface_translational(const batten_curve *curve,
                                                      const batten_curve *path,
                                                      batten_surface **out);

/** What a swing found: the surface cuts through itself where the profile passes the axis, or
 * the trajectory the origin; it has a pole where one of them touches it. */
typedef struct batten_surface_swung_report {
    double least_x,
        largest_x;       /**< how far the profile's control points reach across the axis */
    double least_radius; /**< the least distance of the trajectory from the axis, of 65
                              points of each span */
} batten_surface_swung_report;

/**
 * Swing a profile P(u) of the xz-plane along a trajectory T(v) of the xy-plane: (factor Px Tx,
 * factor Px Ty, Pz). Heights stay, horizontal lines are copies of T in other sizes. With the
 * unit circle and factor 1 it is the surface of revolution.
 *
 * @param profile     in space with y = 0, or in the plane: then its coordinates are x and z
 * @param trajectory  in space with z = 0, or in the plane
 * @param factor  above 0
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; NOT_COMPATIBLE for a function, and for a curve that leaves its plane by more
 * than 1e-12 of its size, naming its control point; COINCIDENT for a curve that is a point, or when all swings
 * within one line; BAD_ARGUMENT, NOT_FINITE, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of the result: the product of those of both.
 * Source: [PT97] 8.5 and 10.2; [Woodward87].
 */
BATTEN_API batten_status batten_surface_swung(const batten_curve *profile,
                                              const batten_curve *trajectory, double factor,
                                              batten_surface_swung_report *report,
                                              batten_surface **out);

/**
 * The tabulated cylinder: straight lines through a curve along `direction`, from the signed
 * distance `from` to `to`; u along the curve, v along the lines, in model units.
 *
 * @param curve  of 1 to 3 dimensions, taken into space
 * @param direction  of any length but 0
 * @param from, to  model units, from < to
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT (no direction, or from >= to), NOT_FINITE, COINCIDENT for a
 * curve that is a point or lies along the direction: a surface without area; OVERFLOW,
 * OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_tabulated(const batten_curve *curve,
                                                  batten_vec3 direction, double from, double to,
                                                  batten_surface **out);

/**
 * The cone of straight lines from a curve (v = 0) to an apex (v = 1): a pole.
 *
 * @param curve  of 1 to 3 dimensions, taken into space
 * @param apex  model units
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; COINCIDENT when the curve is a point or lies on a line through the apex: a
 * surface without area; NOT_FINITE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_conical(const batten_curve *curve, batten_vec3 apex,
                                                batten_surface **out);

/**
 * The ruled surface whose lines join points of equal shares of arc length. Both curves are
 * followed at even speed within `tolerance` (polylines exactly).
 * @param first, second  of 1 to 3 dimensions
 * @param tolerance  model units, above 0
 * @param[out] error  how far the curves were moved at most, model units; may be NULL
 * @return as batten_curve_even_speed and batten_surface_ruled
 *
 * Cost: batten_curve_even_speed for both curves, then that of batten_surface_ruled.
 */
BATTEN_API batten_status batten_surface_ruled_by_length(const batten_curve *first,
                                                        const batten_curve *second,
                                                        double tolerance, double *error,
                                                        batten_surface **out);

/* ---- along a spine ---- */

/** What becomes of a corner of the spine. */
typedef enum batten_corner_kind {
    BATTEN_CORNER_REFUSE,
    BATTEN_CORNER_MITRE, /**< the sections on both sides meet in the plane halfway: they lean
                              along the tangent there, and less and less towards the next
                              corner. Exact for straight sides */
    BATTEN_CORNER_SPLIT  /**< one surface for each part between corners where sections do not
                            meet */
} batten_corner_kind;

typedef struct batten_surface_sweep_options {
    size_t size;
    double tolerance; /**< model units, > 0: how far the surface may be from the true sweep */
    int degree;       /**< along the path, 3 */
    batten_frame_kind frames; /**< rotation-minimising */
    batten_vec3 x;         /**< where the x-axis of the first frame should point, as far as the
                                   tangent lets it; 0: as batten_curve_frames chooses */
    const batten_vec3 *up; /**< instead of `frames`: the y-axis looks this way */
    const batten_curve *guide;   /**< instead of `frames`: the y-axis looks at the point of this
                                      curve that has the same share of its parameters */
    const batten_curve *scale;   /**< functions (dimension 1) over the shares of the spine's
                                      length, whatever their domain; scale > 0; or NULL */
    const batten_curve *scale_y; /**< of the y-axis; then `scale` is that of x, and z stays */
    const batten_curve *twist;   /**< radians about the tangent */
    batten_corner_kind corners;
    const double *at; /**< [section count] shares of the length at which sections stand, rising
                           from 0 to 1; NULL: evenly */
    bool allow_folds; /**< do not refuse where sections run into each other */
    bool align; /**< of several sections, reverse those that run against the one before, and let
                           closed ones begin near it when they start more than 45 degrees off */
} batten_surface_sweep_options;

/** Rotation-minimising frames, degree 3, the tolerance 1e-6 units. */
BATTEN_API batten_surface_sweep_options batten_surface_sweep_defaults(void);

typedef struct batten_surface_sweep_report {
    double error; /**< largest measured distance from the true sweep, of control points of the
                       section: a bound for its points; at 11 places between all knots, at
                       63 where it is largest, with a margin */
    int section_count; /**< at which the surface is the true sweep */
    double length;     /**< of the spine */
    double turn; /**< of closing frames: the angle by which minimising ones miss, radians */
    double clearance; /**< least of 1 - curvature times reach of the section: not above 0 where
                           sections run into each other; 1 for frames that do not turn */
    double clearance_at; /**< where, parameter of the spine */
    int reversed_count;  /**< sections that were reversed */
    int reversed;        /**< the first of them, from 0, or -1 */
    int turned_count;    /**< closed sections that begin elsewhere */
    int turned;          /**< the first of them, from 0, or -1 */
} batten_surface_sweep_report;

/**
 * Sweep a section along a spine: S(u, v) = spine(v) + x(u) X(v) + y(u) Y(v) + z(u) Z(v), where
 * the section (x, y, z) is drawn in the xy-plane around the origin, Z is the tangent of the
 * spine, X and Y are the axes of the frames, turned by the twist and scaled by the scale at
 * that share of the spine's length. u is the parameter of the section, whose knots and weights
 * are kept; v that of the spine, from which the knots along v come.
 *
 * Not a NURBS surface but for straight lines: the surface interpolates sections, as many as
 * are needed to keep the tolerance. Where the spine has corners, see `corners`.
 *
 * Several sections are blended by a cubic spline over the shares of the length (batten_surface
 * _skin, with its rules for unifying and weights); the first and the last may be a point.
 *
 * @param sections  count: sections, 1 or more
 * @param options  NULL for the defaults
 * @param job  may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; NOT_COMPATIBLE naming a corner that is not allowed, or the part of the
 * spine where sections run into each other (curvature times reach 1 or more); COINCIDENT (a
 * spine no longer than the tolerance, a single section that is a point); SINGULAR_HERE (no tangent, no
 * frame); BAD_ARGUMENT (a scale that is not above 0 all along, with the place where it is
 * least); TOLERANCE_NOT_MET where 2000 sections would not do, with what was reached, or below
 * the rounding of the coordinates; TOO_LARGE (a path of too many spans, or a surface of more than a million control
 * points, before the work); TOO_FEW_POINTS (no section), NOT_FINITE, OVERFLOW, CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: each section that is placed or measured costs a frame, 6 evaluations of the spine, and
 * one step for each of its control points; minimising frames are found to 1e-10 radians first.
 * Source: [PT97] 10.4; [WJZL08]; [BR91].
 */
BATTEN_API batten_status batten_surface_sweep(batten_curve_row sections,
                                              const batten_curve *spine,
                                              const batten_surface_sweep_options *options,
                                              const batten_job *job,
                                              batten_surface_sweep_report *report,
                                              batten_surface **out);
/**
 * The same with as many surfaces as there are parts between corners that split.
 * @param sections  [count], in their order
 * @param spine  the curve along which they stand
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @param[out] out in the order of the spine; release with batten_surfaces_release
 * @return as batten_surface_sweep, OUT_OF_MEMORY and CANCELLED among them
 *
 * Cost: as batten_surface_sweep for each part.
 */
BATTEN_API batten_status batten_surfaces_sweep(batten_curve_row sections,
                                               const batten_curve *spine,
                                               const batten_surface_sweep_options *options,
                                               const batten_job *job,
                                               batten_surface_sweep_report *report,
                                               batten_surfaces *out);
/**
 * The true sweep, a surface of kind "sweep": exact but for the frames, 1e-10 radians.
 * Corners cannot split.
 *
 * @param sections  [count], in their order
 * @param spine  the curve along which they stand
 * @param options  NULL for the defaults; the tolerance does not count
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT, BAD_ARGUMENT, NOT_COMPATIBLE,
 * SINGULAR_HERE, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: the frames of the spine to make it; a point of the surface costs one section, one point
 * of the spine and a search for its frame.
 */
BATTEN_API batten_status batten_surface_sweep_procedural(
    batten_curve_row sections, const batten_curve *spine,
    const batten_surface_sweep_options *options, batten_surface **out);

/**
 * A pipe: the sweep of a circle of this radius around the spine; rational, with the weights of
 * the circle all along.
 * @param radius  model units, above 0
 * @param spine  in space
 * @param options  as for batten_surfaces_sweep
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  in the order of the spine; release with batten_surfaces_release
 * @return as batten_surfaces_sweep; BAD_ARGUMENT (radius); NOT_COMPATIBLE where radius times
 * curvature is 1 or more
 *
 * Cost: as batten_surfaces_sweep.
 */
BATTEN_API batten_status batten_surfaces_pipe(double radius, const batten_curve *spine,
                                              const batten_surface_sweep_options *options,
                                              const batten_job *job,
                                              batten_surface_sweep_report *report,
                                              batten_surfaces *out);

/* ---- about an axis ---- */

/**
 * The surface that a curve leaves when it is turned about an axis and moved along it: a
 * helicoid, a thread. v is the angle.
 * @param curve  of 1 to 3 dimensions, taken into space
 * @param screw  pitch: model units for a full turn, of any sign; 0: a revolution, within the
 * tolerance
 *     angle: radians, > 0, at most 1000 turns
 * @param tolerance  model units, above 0
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; COINCIDENT when the curve is a point; TOLERANCE_NOT_MET as for sweeps;
 * BAD_ARGUMENT, NOT_FINITE, TOO_LARGE, CANCELLED, OUT_OF_MEMORY
 *
 * Cost: as batten_surface_sweep; a turn takes some ten placed sections, more for a small
 * tolerance.
 */
BATTEN_API batten_status batten_surface_helical(const batten_curve *curve, batten_screw screw,
                                                double tolerance, const batten_job *job,
                                                batten_surface_sweep_report *report,
                                                batten_surface **out);

/* ---- along two rails ---- */

/** Which points of two rails belong together. */
typedef enum batten_rail_match {
    BATTEN_RAILS_BY_PARAMETER, /**< equal shares of the parameters */
    BATTEN_RAILS_BY_LENGTH, /**< of the lengths; the rails are followed at even speed within a
                                 tenth of the tolerance */
    BATTEN_RAILS_BY_PLANES  /**< those in one plane square to `across` */
} batten_rail_match;

typedef struct batten_surface_two_rails_options {
    size_t size;
    double tolerance; /**< model units, > 0 */
    int degree;       /**< along the rails, 3 */
    batten_rail_match match;
    batten_vec3 across; /**< of BATTEN_RAILS_BY_PLANES; both rails rise along it */
    bool fixed_height;  /**< y (and z) of the section keep their size; else the section is
                             scaled as a whole with the distance of the rails */
} batten_surface_two_rails_options;

/** The defaults of two rails: those beside the fields of batten_surface_two_rails_options. */
BATTEN_API batten_surface_two_rails_options batten_surface_two_rails_defaults(void);

/**
 * Sweep a section along two rails: its start runs on the first, its end on the second. The
 * section is drawn in the xy-plane; its chord comes to lie between the rails, its y-axis
 * square to the chord and to the mean of their tangents: Z x chord.
 *
 * v is the share of the length along the rails, 0 to 1; of planes, the share of the height.
 * Rails may meet at their ends: a pole, with a section that is scaled.
 *
 * @param section  in the xy-plane
 * @param rails  [2], in space
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_COMPATIBLE where the rails cross or meet inside, with the place, or,
 * of planes, do not have the same heights or do not rise; COINCIDENT for a section whose ends
 * are one point, rails no longer than the tolerance, or rails that coincide; SINGULAR_HERE
 * where the mean tangent vanishes or lies along the chord; TOLERANCE_NOT_MET, BAD_ARGUMENT,
 * NOT_FINITE, TOO_LARGE, CANCELLED, OUT_OF_MEMORY
 *
 * Cost: as batten_surface_sweep.
 */
BATTEN_API batten_status
batten_surface_two_rails(const batten_curve *section, const batten_curve *const rails[2],
                         const batten_surface_two_rails_options *options, const batten_job *job,
                         batten_surface_sweep_report *report, batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
