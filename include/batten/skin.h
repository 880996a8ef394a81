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
} batten_skin_report;

/**
 * The surface through sections: u runs along a section over [0, 1], v across them.
 *
 * Sections get one degree, one domain and common knots; then their control points are
 * interpolated across, weights included. With an odd degree across the knots stand at the
 * sections and `start`, `end` hold; an even degree has averaged knots. Circle and curvature
 * ends are not possible. A clamped end has the given derivative all along the section. A
 * section may be a point (all control points equal): a pole. Sections that are periodic, all of
 * them, stay so and are unified exactly whatever the tolerance. With `align` the message says
 * which sections were reversed.
 *
 * With a tolerance, spans of sections are first stretched, corners held, so that their speed
 * does not jump where their tangent goes on; then a section moves at most as
 * `report->deviation` says, a bound at equal parameters; corners stay corners; the ends of
 * sections do not move. If that needs as many knots as the exact union, that is taken.
 *
 * @param[out] v [count] parameters of the sections, 0 .. 1 unless given; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS, COINCIDENT naming two sections, TOO_LARGE with the size it
 * would have, NOT_COMPATIBLE when an interpolated weight is not positive, TOLERANCE_NOT_MET
 * when a section is missed by more than 1e-13 of its size beyond its deviation; BAD_ARGUMENT
 * ...
 *
 * Cost: linear in sections times common control points; with a tolerance the search fits every
 * section about three times for each knot it keeps. Source: [PT97] 10.3; [Woodward88].
 */
BATTEN_API batten_status batten_surface_skin(int count, const batten_curve *const *sections,
                                             const batten_skin_options *options,
                                             const batten_job *job, double *v,
                                             batten_skin_report *report, batten_surface **out);

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
