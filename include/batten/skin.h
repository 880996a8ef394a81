#ifndef BATTEN_SKIN_H
#define BATTEN_SKIN_H
/**
 * @file
 * Surfaces from curves: skinned, ruled, extruded.
 */
#include <batten/curvature.h>
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

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

typedef struct batten_surface_skin_options {
    size_t size;
    int degree; /**< across the sections, 3; lowered when there are too few */
    batten_parametrization parameters; /**< across; BATTEN_CENTRIPETAL */
    const double *given;               /**< [count] across, with BATTEN_GIVEN */
    batten_end start, end; /**< natural, clamped (vector: the common tangent), ... */
    bool closed;           /**< the last section is followed by the first */
    bool
        align; /**< reverse sections that run against the first, closed ones by how they run and not by
                           where they start; a message says which */
    double tolerance;          /**< 0: exact union of all knots. Else few common knots are found
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
    bool untwist; /**< with `align`: closed sections that start more than 45 degrees off begin
                       nearest to the one before; those that start at a corner keep it */
    bool smooth_poles; /**< a first or last section that is a point is a smooth pole: the
                            derivatives there are the next section, flat about the pole, times
                            one factor; a clamped, direction or other end given there is not
                            used */
} batten_surface_skin_options;

/** Cubic, centripetal, natural ends, all knots kept (tolerance 0). */
BATTEN_API batten_surface_skin_options batten_surface_skin_defaults(void);

typedef struct batten_surface_skin_report {
    double error;      /**< how far a section moved at most; without a tolerance, what rounding
                          left */
    int worst_section; /**< which one */
    int exact_knot_count; /**< distinct inner knots that the exact union has */
    int knot_count;       /**< distinct inner knots of the result */
    double span_ratio;    /**< smallest span over median span along the sections */
    double normal_jump;   /**< largest jump of the normal over inner knot lines, radians */
    double speed_jump;    /**< largest jump of |Su| there, as a share of the larger */
    double crease; /**< largest jump of the normal beyond that of the sections, where none of
                        them has a corner (0.01 radians), radians; at the seam of closed
                        sections too, and close to poles */
    batten_skin_cure cure;
    int reversed_count; /**< sections that were reversed */
    int turned_count;   /**< closed sections that begin elsewhere */
    int crossing_count; /**< pairs of neighbours that cross: the surface folds there */
    int crossing;       /**< the first section that crosses its successor, or -1 */
    int disorder_count; /**< neighbours nearer in the other order */
    int disorder;       /**< the first section that should rather follow its successor, or -1 */
    int reversed,
        turned; /**< the first section that was reversed, or begins elsewhere, or -1 */
} batten_surface_skin_report;

/**
 * The surface through sections: u runs along a section over [0, 1], v across them.
 *
 * Sections get one degree, one domain and common knots; then their control points are
 * interpolated across, weights included. With an odd degree across the knots stand at the
 * sections and `start`, `end` hold; an even degree has averaged knots. Circle and curvature
 * ends are not possible. A clamped end has the given derivative all along the section. A
 * section may be a point (all control points equal): a pole; as the first or last one it takes
 * the knots and weights of its neighbour, and with `smooth_poles` has a tangent plane. Sections that are periodic, all of
 * them, stay so, and so does the surface along u. With `align` the message says which sections
 * were reversed.
 *
 * With a tolerance, spans of sections are first stretched, corners held, so that their speed
 * does not jump where their tangent continues; then a section moves at most as
 * `report->deviation` says, a bound at equal parameters; corners stay corners; the ends of
 * sections do not move. If that needs as many knots as the exact union, that is taken. When all
 * sections have knots and legs that are symmetric about their middle, so has the surface.
 *
 * Nothing twists when the right points belong together: `align` looks for the direction,
 * `turn` or `starts` for the start of closed sections, `match` for all between. All go by
 * distances, so mirrored sections give the mirrored surface. A section matched otherwise than
 * by its parameters is replaced within a quarter of the tolerance, and periodic ones are then
 * clamped.
 *
 * A crease (report->crease above 1e-4 radians) is cured as `creases` says, and the report says
 * how. A weight between the sections that is not positive is cured by polynomial sections in
 * the same way. Neighbours that cross or stand in another order than their distances ask for
 * are named by the report and the message; the surface is made all the same.
 *
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] v [count] parameters of the sections, 0 .. 1 unless given; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS, COINCIDENT naming two sections, TOO_LARGE with the size it
 * would have, NOT_COMPATIBLE when an interpolated weight is not positive or a section is closed
 * while another is open, TOLERANCE_NOT_MET when a section is missed by more than 1e-13 of its size beyond its
 * deviation; BAD_ARGUMENT, BAD_DEGREE, NOT_FINITE, NOT_INCREASING, OVERFLOW, CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: linear in sections times common control points; with a tolerance the search fits every
 * section about three times for each knot it keeps.
 * Source: [PT97] 10.3; [Woodward88]; [HB91] for creases.
 */
BATTEN_API batten_status batten_surface_skin(batten_curve_row sections,
                                             const batten_surface_skin_options *options,
                                             const batten_job *job, double *v,
                                             batten_surface_skin_report *report,
                                             batten_surface **out);

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
 * Cost: a point costs as many evaluations of sections as there are.
 * Source: [FB89].
 */
BATTEN_API batten_status batten_surface_skin_procedural(
    batten_curve_row sections, const batten_surface_skin_options *options, double *v,
    batten_surface **out);

/**
 * (1 - v) first(u) + v second(u), after unifying; u and v in [0, 1].
 *
 * @param first, second  of one dimension
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_DEGREE, OUT_OF_DOMAIN,
 * BAD_ARGUMENT, NOT_COMPATIBLE, TOLERANCE_NOT_MET, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points after degrees and knots are made common.
 */
BATTEN_API batten_status batten_surface_ruled(const batten_curve *first,
                                              const batten_curve *second, batten_surface **out);
/**
 * curve(u) + v * along, v in [0, 1].
 *
 * @param curve  of 1 to 3 dimensions, taken into space
 * @param along  model units, not 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_FINITE, BAD_ARGUMENT (along), TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_extruded(const batten_curve *curve, batten_vec3 along,
                                                 batten_surface **out);
typedef struct batten_surface_skin_rows_options {
    size_t size;
    int degree;                        /**< along the rows, 3 */
    batten_parametrization parameters; /**< along them, each for itself; BATTEN_CENTRIPETAL */
    const double *given; /**< one for each point, row after row, each from 0 to 1, with
                            BATTEN_GIVEN */
    double margin;       /**< a knot keeps away from the ends of the interval in which it is
                              admissible by this share of its length, 0.25; below 0.5 */
    const batten_surface_skin_options
        *across; /**< NULL: the defaults; without a tolerance, a spine,
                                          starts or matching */
} batten_surface_skin_rows_options;

/** Rows of points, of different lengths; borrowed for the call. */
typedef struct batten_rows {
    int dimension;
    int count;         /**< rows */
    const int *counts; /**< [count], points of each row */
    const double *at;  /**< [sum of counts][dimension], row after row */
} batten_rows;

/** The defaults of skins of rows: those beside the fields of batten_surface_skin_rows_options. */
BATTEN_API batten_surface_skin_rows_options batten_surface_skin_rows_defaults(void);

typedef struct batten_surface_skin_rows_report {
    int knot_count;          /**< distinct inner knots that all rows share */
    int separate_knot_count; /**< those that the rows have together when each is interpolated
                                  with averaged knots of its own */
    int free_rows;     /**< rows with fewer points than control points: the rest is energy */
    double span_ratio; /**< smallest span over median span along the rows */
    double error;      /**< largest distance of a point from the surface */
} batten_surface_skin_rows_report;

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
 * @param points  counts: [row_count], 2 or more in each row
 *     row after row [counts[r]][dimension]
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] uv  u: one for each point; may be NULL
 *     v: [row_count]; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS, COINCIDENT, NOT_FINITE, NOT_INCREASING naming the row;
 * BAD_DEGREE, BAD_ARGUMENT; TOO_LARGE before the work; TOLERANCE_NOT_MET when a point is missed
 * by more than 1e-11 of the size; and as batten_surface_skin
 * Cost: points n of a row that has fewer than the N control points: n N + n^3.
 * Source: [PT00], [PK96].
 */
BATTEN_API batten_status batten_surface_skin_rows(
    batten_rows points, const batten_surface_skin_rows_options *options, const batten_job *job,
    batten_uv_out uv, batten_surface_skin_rows_report *report, batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
