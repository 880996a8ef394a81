#ifndef BATTEN_SKIN_H
#define BATTEN_SKIN_H
/**
 * @file
 * Surfaces from curves: skinned, ruled, extruded.
 */
#include <batten/interpolate.h>
#include <batten/standard.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_frame_kind {
    BATTEN_FRAME_ROTATION_MINIMISING,
    BATTEN_FRAME_FIXED,
    BATTEN_FRAME_FRENET,
    BATTEN_FRAME_CLOSING /**< minimising, and along a closed spine turned evenly by arc length
                            so that the last frame is the first */
} batten_frame_kind;

/** Which points of the sections belong together. */
typedef enum batten_skin_match {
    BATTEN_MATCH_PARAMETERS, /**< those at equal parameters of the sections, each over [0, 1] */
    BATTEN_MATCH_ARC_LENGTH, /**< those after the same share of the length; needs a tolerance */
    BATTEN_MATCH_MARKS       /**< the marks given, and what lies evenly between, by a monotone
                                  C1 map of the parameter; needs a tolerance */
} batten_skin_match;

/** What is done where a surface has a crease although its sections have no corner. It comes
 * from speeds, or weights, that jump differently in different sections. */
typedef enum batten_skin_creases {
    BATTEN_CREASES_WITHIN, /**< cured when there is a tolerance */
    BATTEN_CREASES_CURE,   /**< cured; without a tolerance by exact means alone */
    BATTEN_CREASES_KEEP    /**< kept, and with them the parameters of the sections */
} batten_skin_creases;

/** How creases were cured, the simplest first. */
typedef enum batten_skin_cure {
    BATTEN_CURE_NONE,
    BATTEN_CURE_STRETCHED, /**< spans stretched so that speeds do not jump: exact; polynomial
                                sections */
    BATTEN_CURE_RESCALED,  /**< the weights of each piece rescaled, a Moebius change of its
                                parameter, so that they do not jump either: exact */
    BATTEN_CURE_POLYNOMIAL /**< rational sections replaced within a quarter of the tolerance */
} batten_skin_cure;

typedef struct batten_skin_options {
    size_t size;
    int degree; /**< across the sections, 3; lowered when there are too few */
    batten_parametrization parameters; /**< across; BATTEN_CENTRIPETAL */
    const double *given;               /**< [count] across, with BATTEN_GIVEN */
    batten_end start, end; /**< natural, clamped (vector: the common tangent), ... */
    bool periodic;         /**< the last section is followed by the first */
    bool align;       /**< reverse sections that run against the first; a message says which */
    double tolerance; /**< 0: exact union of all knots. Else few common knots are found
                           so that no section moves farther than this */
    const batten_curve *spine; /**< NULL: sections stand where they are. Else they are drawn in
                                  the xy-plane and are placed along the spine */
    const double *spine_at; /**< [count] parameters of the sections on the spine; NULL: evenly
                               by arc length */
    const double *twist;    /**< [count] radians about the spine; NULL: none */
    const double *scale;    /**< [count]; NULL: all 1 */
    batten_frame_kind frames;
    bool turn;            /**< closed sections begin where they are nearest, at equal parameters
                               in the mean of squares, to the one before */
    const double *starts; /**< [count] parameters at which closed sections begin; NULL */
    batten_skin_match match;
    int mark_count;
    const double *marks; /**< [count][mark_count] increasing, inside the domain of each section
                              as given, before it is aligned or turned */
    batten_skin_creases creases;
} batten_skin_options;

BATTEN_API batten_skin_options batten_skin_defaults(void);

typedef struct batten_skin_report {
    double deviation;  /**< how far a section moved at most; without a tolerance, what rounding
                          left */
    int worst_section; /**< which one */
    int exact_knot_count; /**< distinct inner knots that the exact union has */
    int knot_count;       /**< distinct inner knots of the result */
    double span_ratio;    /**< smallest span over median span along the sections */
    double normal_jump;   /**< largest jump of the normal over inner knot lines, radians */
    double speed_jump;    /**< largest jump of |Su| there, as a share of the larger */
    double crease; /**< largest jump of the normal beyond that of the sections, where none of
                        them has a corner (0.01 radians), radians */
    batten_skin_cure cure;
    int reversed_count; /**< sections that were reversed */
    int turned_count;   /**< closed sections that begin elsewhere */
    int crossing_count; /**< pairs of neighbours that cross: the surface folds there */
    int crossing;       /**< the first section that crosses its successor, or -1 */
    int disorder_count; /**< neighbours nearer in the other order */
    int disorder;       /**< the first section that should rather follow its successor, or -1 */
} batten_skin_report;

/**
 * The surface through sections: u runs along a section over [0, 1], v across them.
 *
 * Sections get one degree, one domain and common knots; then their control points are
 * interpolated across, weights included. With an odd degree across the knots stand at the
 * sections and `start`, `end` hold; an even degree has averaged knots. Circle and curvature
 * ends are not possible. A clamped end has the given derivative all along the section. A
 * section may be a point (all control points equal): a pole. Sections that are periodic, all of
 * them, stay so, and so does the surface along u. With `align` the message says
 * which sections were reversed.
 *
 * With a tolerance, spans of sections are first stretched, corners held, so that their speed
 * does not jump where their tangent goes on; then a section moves at most as
 * `report->deviation` says, a bound at equal parameters; corners stay corners; the ends of
 * sections do not move. If that needs as many knots as the exact union, that is taken. When all
 * sections have knots and legs that are symmetric about their middle, so has the surface.
 *
 * Nothing twists when the right points belong together: `align` looks for the direction,
 * `turn` or `starts` for the begin of closed sections, `match` for all between. All go by
 * distances, so mirrored sections give the mirrored surface. A section matched otherwise than
 * by its parameters is replaced within a quarter of the tolerance, and periodic ones are then
 * clamped.
 *
 * A crease (report->crease above 1e-4 radians) is cured as `creases` says, and the report says
 * how. A weight between the sections that is not positive is cured by polynomial sections in
 * the same way. Neighbours that cross or stand in another order than their distances ask for
 * are named by the report and the message; the surface is made all the same.
 *
 * @param[out] v [count] parameters of the sections, 0 .. 1 unless given; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS, COINCIDENT naming two sections, TOO_LARGE with the size it
 * would have, NOT_COMPATIBLE when an interpolated weight is not positive or a section is closed
 * while another is open, TOLERANCE_NOT_MET
 * when a section is missed by more than 1e-13 of its size beyond its deviation; BAD_ARGUMENT
 * ...
 *
 * Cost: linear in sections times common control points; with a tolerance the search fits every
 * section about three times for each knot it keeps. Source: [PT97] 10.3;
 * [Woodward88]; [HB91] for creases.
 */
BATTEN_API batten_status batten_surface_skin(int count, const batten_curve *const *sections,
                                             const batten_skin_options *options,
                                             const batten_job *job, double *v,
                                             batten_skin_report *report, batten_surface **out);

/**
 * The procedural skin: S(u, v) = sum of L_k(v) C_k(u), with the cardinal splines L_k of the
 * same interpolation across, 1 at section k and 0 at the others. u runs over [0, 1] and the
 * sections stay as they are: no knots are merged, and between rational sections points are
 * blended, not weights. So it passes them exactly, has no slivers, and as many creases as the
 * sections have corners.
 *
 * Parameters across come from the distances of 33 places of the sections.
 * batten_surface_to_nurbs gives the skin of common knots within its tolerance, 0 of polynomial
 * sections the one with all knots; the error is that of batten_surface_skin times the largest
 * sum of |L_k|.
 *
 * @param options as for batten_surface_skin; the tolerance and `creases` do not matter, but for
 *        matching. DIRECTION ends are not possible
 * @param[out] v [count]; may be NULL
 * @param[out] out of the kind "skin", evaluated to order 3; later changes need NURBS
 * @return as batten_surface_skin
 * Cost: a point costs as many evaluations of sections as there are. Source: [FB89].
 */
BATTEN_API batten_status batten_surface_skin_procedural(int count,
                                                        const batten_curve *const *sections,
                                                        const batten_skin_options *options,
                                                        double *v, batten_surface **out);

/** (1 - v) first(u) + v second(u), after unifying; u and v in [0, 1]. */
BATTEN_API batten_status batten_surface_ruled(const batten_curve *first,
                                              const batten_curve *second, batten_surface **out);
/** curve(u) + v * along, v in [0, 1]. */
BATTEN_API batten_status batten_surface_extruded(const batten_curve *curve, batten_vec3 along,
                                                 batten_surface **out);

/**
 * Frames along a spine, for those who place things themselves: orthonormal, axis z along the
 * tangent.
 *
 * The first minimising or fixed frame stands at the start of the spine; its x is that axis of
 * the world which lies most across the tangent (x before y before z). A fixed frame keeps both
 * axes all along.
 * @param at [count] increasing, in the domain of the spine
 * @param[out] frames [count]
 * @return BATTEN_OK; SINGULAR_HERE without a tangent, or, Frenet, where the spine is straight;
 * NOT_COMPATIBLE, closing, where the spine does not close with one tangent; OUT_OF_DOMAIN,
 * NOT_INCREASING Source: [WJZL08], with 64 double reflections for each span of
 * the spine.
 */
BATTEN_API batten_status batten_curve_frames(const batten_curve *spine, int count,
                                             const double *at, batten_frame_kind kind,
                                             batten_frame *frames);

/**
 * Rotation-minimising frames as exact as wanted: the double reflections of each span are
 * doubled until no frame turns by more than `tolerance`. As their error falls with the fourth
 * power of the step, the frames are then some fifteen times better than that.
 * @param tolerance radians, > 0
 * @param[out] error the last turn, radians; may be NULL
 * @return as batten_curve_frames; BAD_ARGUMENT; TOLERANCE_NOT_MET at 16384 steps for each span
 */
BATTEN_API batten_status batten_curve_minimising_frames(const batten_curve *spine, int count,
                                                        const double *at, double tolerance,
                                                        batten_frame *frames, double *error);
/**
 * By which angle a rotation-minimising frame is turned about the tangent after one round of a
 * closed curve, radians in (-pi, pi]. Where curvature never vanishes it is minus the total
 * torsion; on a sphere and in a plane it is 0.
 * @param tolerance, error as above
 * @return as batten_curve_minimising_frames; NOT_COMPATIBLE when the ends do not meet with one
 * tangent
 */
BATTEN_API batten_status batten_curve_holonomy(const batten_curve *curve, double tolerance,
                                               double *angle, double *error);

#ifdef __cplusplus
}
#endif
#endif
