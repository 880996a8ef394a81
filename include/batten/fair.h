#ifndef BATTEN_FAIR_H
#define BATTEN_FAIR_H
/**
 * @file
 * How fair a curve is, and how to make it fairer without moving any point farther than allowed.
 */
#include <batten/chain.h>
#include <batten/hull.h>
#include <batten/interpolate.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The numbers behind the word "fair". */
typedef struct batten_fairness {
    int inflections;        /**< of the curve; in space: of no meaning, 0 */
    int excess_inflections; /**< beyond those that the data themselves require */
    int curvature_extrema;
    double jumps;     /**< sum of squares of the jumps of the third derivative at the knots */
    double energy;    /**< integral of curvature^2 ds (functions: of the second derivative^2);
                           HUGE_VAL when there are corners */
    double variation; /**< integral of (d curvature / ds)^2 ds; HUGE_VAL when there are corners
                         or curvature jumps */
    double max_curvature; /**< HUGE_VAL where it grows without bound, as at most cusps */
    bool fair;            /**< the verdict: no excess inflections, corners, curvature jumps or
                              places of unbounded curvature */
    int corners;          /**< places at which the direction turns by more than the bound, also
                              where the curve stands still */
    int curvature_jumps;  /**< other joints at which curvature steps by more than the bound */
    int halts;            /**< places inside at which the first derivative vanishes */
    int cusps;            /**< of these, those at which the curve turns back */
    int unbounded; /**< other places, ends among them, at which the curve stands still and
                              its curvature grows without bound */
    double energy_error, variation_error; /**< how far off the integrals may be, estimated. An
                              error that is no small part of its integral says that this is
                              not known: it is infinite or nearly so */
    double largest_turn; /**< the sharpest corner, radians (functions: the step of the slope) */
    double largest_jump; /**< the largest step of curvature, over the larger of both */
} batten_fairness;

/** The bounds of the verdict. */
typedef struct batten_fairness_options {
    size_t size;
    double angle;     /**< joints that turn by more are corners; radians, of slopes of functions
                           a part of the steeper; above 0, below pi; 1e-6 */
    double curvature; /**< other joints at which curvature steps by more than this part of the
                           larger are jumps; above 0; 1e-6 */
    double within;    /**< inflections are required by the points wherever they lie within this
                           of their places, model units; not below 0; 0 */
    double error;     /**< of a curve that stands for another: it is within this of that, and
                           inflections and extrema that such moves of its control points may
                           make are not counted, model units; not below 0; of chains ignored; 0 */
} batten_fairness_options;
/** The defaults: those beside the fields of batten_fairness_options. */
BATTEN_API batten_fairness_options batten_fairness_defaults(void);

/**
 * Judge a curve. Of a function (dimension 1) the second derivative stands for curvature.
 *
 * Inflections and extrema are found exactly, by the roots of polynomials; extrema between which
 * curvature changes by less than 1e-6 of the largest are not counted, for a search leaves such
 * waves on what should be an arc. Energy and variation are found by adaptive quadrature to 1e-9
 * of their values, between knots and the extrema of curvature, so that no sharp bend escapes
 * it. Joints are the knots inside; the seam is one of a periodic curve only.
 *
 * @param curve  any curve
 * @param points its data [count][dimension], from which the required inflections are counted:
 * the changes of side to which the polygon turns; of a function the values at its distinct
 * knots. at = NULL: none are required
 * @param options  NULL for the defaults
 * @param[out] out  inflections, extrema, energy and variation; see the struct
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, UNSUPPORTED (points of another dimension),
 * NOT_COMPATIBLE, OUT_OF_MEMORY
 *
 * Cost: linear in the spans, some 40 evaluations of each; up to 10000 where it bends sharply
 */
BATTEN_API batten_status batten_curve_fairness(const batten_curve *curve, batten_points points,
                                               const batten_fairness_options *options,
                                               batten_fairness *out);

/**
 * Judge a chain. A plane one, placed in space or not, is judged in its plane.
 *
 * Energy and variation are exact but for rounding where curvature is a polynomial of arc
 * length, else right to 1e-12. Curvature may step where spans meet: a step over 0 is an
 * inflection, and steps take part in the extrema. What is below 1e-9 of the largest curvature
 * is neither. In elastica and spans in tension extrema are searched between 64 samples.
 *
 * @param chain  any chain
 * @param points its data [count][dimension of the chain], as for batten_curve_fairness; those
 * of a function stand at the breaks
 * @param options  NULL for the defaults
 * @param[out] out  inflections, extrema, energy and variation; see the struct
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, UNSUPPORTED (points of another dimension),
 * NOT_COMPATIBLE, OUT_OF_MEMORY
 *
 * Cost: linear in the spans; elastica and spans in tension 64 samples each.
 */
BATTEN_API batten_status batten_chain_fairness(const batten_chain *chain, batten_points points,
                                               const batten_fairness_options *options,
                                               batten_fairness *out);

/**
 * Add the fairness of one curve to that of a family: sums of counts and integrals, the largest of
 * curvatures, turns and jumps, fair when all are.
 *
 * @param[in,out] sum  of those before; begin with zeros and `fair` true
 * @param one  as a judgement left it
 *
 * Cost: constant.
 */
BATTEN_API void batten_fairness_add(batten_fairness *sum, const batten_fairness *one);

/**
 * How many inflections of a polyline can be seen: the changes of side of its turning, between
 * bulges that rise from their chord by more than a height.
 *
 * @param count  of points; fewer than 4 have none
 * @param points  [count][2], in the plane
 * @param height  of the bulges that count, model units, 0 or above
 *
 * Cost: linear in the points.
 */
BATTEN_API int batten_polyline_inflections(int count, const double *points, double height);

typedef enum batten_fair_order {
    BATTEN_FAIR_WORST_FIRST, /**< release the duck under the largest force */
    BATTEN_FAIR_SWEEPS,      /**< one after another, until the energy is the least */
    BATTEN_FAIR_ALTERNATE    /**< even ducks, then odd ones */
} batten_fair_order;

/** By what the points of a curve are moved. */
typedef enum batten_fair_method {
    BATTEN_FAIR_SPRINGBACK,  /**< ducks are released, in an order */
    BATTEN_FAIR_CIRCLE_RATE, /**< in the plane: the curvature of the circle through each three
                                  points is made linear over their chords, the worst point first */
    BATTEN_FAIR_KJELLANDER,  /**< a point goes to the cubic with the positions and tangents of
                                  its neighbours, the worst point first */
    BATTEN_FAIR_LEAST_CHANGE /**< of a function or in the plane: the points move as little as
                                  removes the inflections in excess */
} batten_fair_method;

typedef struct batten_fair_options {
    size_t size;
    double within; /**< no point moves farther than this, in model units; required */
    const double *within_each; /**< [count] instead of it; 0 holds a point; may be NULL */
    bool hold_ends;            /**< true */
    batten_fair_order order;   /**< BATTEN_FAIR_SWEEPS */
    double relaxation;         /**< 1; (0, 1] */
    int max_moves;             /**< 0: a bound from the number of points */
    bool stop_when_fair;       /**< worst first: stop at the verdict, not at the least energy */
    const int *corners; /**< [corner_count] indices of points at which the curve is cut; held */
    int corner_count;
    double corner_angle; /**< of tables, radians: a turn of a station by this much more than at
                            both neighbours is a corner (a chine), and not rounded; 25 degrees */
    batten_fair_method method; /**< BATTEN_FAIR_SPRINGBACK; of tables no other */
} batten_fair_options;

/** The defaults of fairing: no point moves farther than `within`, model units. */
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
    int suspect_count; /**< maybe blunders: force above 6 medians, its neighbours' opposite */
    int move_count;    /**< length of `moves`: one for each point that moved */
    batten_fair_move *moves;    /**< release with batten_fair_report_release */
    batten_fair_move *suspects; /**< with the suggested place; not carried out */
    bool control_points; /**< what moved are control points; `max_move` is of the curve */
    bool net;            /**< the points are a net: `set` is a row of it */
} batten_fair_report;
/** Release the moves and the suspects of a report. */
BATTEN_API void batten_fair_report_release(batten_fair_report *report);

/**
 * Fair the points of one curve within bounds.
 *
 * With BATTEN_FAIR_SPRINGBACK each duck in turn is released and the batten, a natural cubic spline, takes its place between
 * the others, but no point leaves the ball of radius `within` about where it was given: not by
 * a single rounding. Parameters are held. A point of the plane or of space moves at right
 * angles to the chord from its given predecessor to its successor, so that it does not slide
 * along the curve; where these two coincide, freely. A function (dimension 1) over `parameters`
 * moves up and down.
 *
 * The energy, the integral of |z''|^2 over the parameters, is convex, so with
 * BATTEN_FAIR_SWEEPS the result is the one least-energy batten within the bounds, wherever
 * sweeps begin: no duck that is released alone would go farther than a millionth of its bound.
 * It is found by an interior-point method in some 20 banded solves; `relaxation` and
 * `max_moves` do not matter. WORST_FIRST releases at most `max_moves` ducks (0: 20 for each
 * point), ALTERNATE alternates at most `max_moves` / count times (0: 100). A second run whose
 * bounds count from the result of the first would continue moving; to continue within the same
 * bounds, begin with the same points.
 *
 * With BATTEN_FAIR_CIRCLE_RATE the first and the last two points stay, and the sum of the
 * departures of the circle rates from the lines between their neighbours falls with every move;
 * with BATTEN_FAIR_KJELLANDER the sum of the squares of the forces does. Both end after
 * `max_moves` (0: 20 for each point) or when no move, nor an eighth of one, makes it fall.
 *
 * With BATTEN_FAIR_LEAST_CHANGE a curve without inflections in excess is not moved. Else of all
 * battens that turn where the one of least energy does, as often as the points require, that
 * with the least sum of (move / bound)^2 is taken, whose points may also slide along the curve;
 * where the bounds leave none, or the search ends elsewhere, `after` says what is in excess. A
 * curve of which no inflection in excess is removed stays as it was.
 *
 * Pieces of fewer than 4 points are judged and not moved. Bounds and moves below the last places
 * of the coordinates count as 0.
 *
 * In the report, `before` and `after` are of the batten through the points, in pieces between
 * corners; the inflections required are the fewest of any curve within the bounds. An
 * inflection that a millionth of the bound would remove is not counted.
 *
 * @param points      [count][dimension], count >= 2
 * @param parameters  [count] increasing, or NULL for chord length (not with dimension 1)
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] faired [count][dimension]
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, COINCIDENT,
 *         CANCELLED, INCOMPLETE, UNSUPPORTED (a method that is not for points of this
 *         dimension), TOO_LARGE, or TOLERANCE_NOT_MET with the residual in the message
 *
 * Cost: linear in count (the worst first: count for each move).
 * Source: [SL] ch. VII; [NW06] ch. 19 for the method; [Kje83].
 */
BATTEN_API batten_status batten_fair_points(batten_points points, const double *parameters,
                                            const batten_fair_options *options,
                                            const batten_job *job, batten_fair_report *report,
                                            double *faired);

/** By what the control points of a curve are moved. */
typedef enum batten_curve_fair_method {
    BATTEN_CURVE_FAIR_KNOTS, /**< cubics: the knot with the largest jump of the third derivative
                                  is taken out and put in again */
    BATTEN_CURVE_FAIR_COEFFICIENTS /**< the control point by which the integral of the square of
                                        the third derivative (degree 2: of the second) falls
                                        most goes to its best place */
} batten_curve_fair_method;

typedef struct batten_curve_fair_options {
    size_t size;
    double within; /**< no point of the curve moves farther than this, model units; required */
    batten_curve_fair_method method; /**< BATTEN_CURVE_FAIR_KNOTS */
    int hold; /**< so many control points stay at each end: 1 the ends, 2 the tangents, 3 the
                   curvatures too; of periodic curves none; 1 */
    int max_moves; /**< 0: 20 for each control point */
} batten_curve_fair_options;
/** The defaults of fairing a curve: no point of it moves farther than `within`, model units. */
BATTEN_API batten_curve_fair_options batten_curve_fair_defaults(double within);

/**
 * Fair a curve that comes without the points it was made from.
 *
 * Control points are moved one at a time, the worst first, each within a ball about where it was
 * given. The balls have the largest radius found, `within` or more, with which no point of the
 * curve is farther than `within` from where it was at the same parameter. With every move falls the sum of the jumps of the third derivative at simple knots
 * (KNOTS), or the integral (COEFFICIENTS); where no move, nor an eighth of one, makes it fall,
 * the search ends. Degree, knots and period stay.
 *
 * In the report, the moves are those of control points, which may be above `within`; `max_move`
 * is how far the curve moved, exceeded by no point of it and right to some hundredths. The
 * inflections required are the fewest of any curve within the bound of 8 points of each span of
 * the given one; in space none.
 *
 * @param curve  polynomial, of degree 2 or more; KNOTS: cubic
 * @param options  the bound
 * @param job  progress, cancelling; NULL for no questions
 * @param[out] report  what was reached, release it; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, UNSUPPORTED, CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: the control points for each move.
 * Source: [FS90]; [EH95].
 */
BATTEN_API batten_status batten_curve_fair(const batten_curve *curve,
                                           const batten_curve_fair_options *options,
                                           const batten_job *job, batten_fair_report *report,
                                           batten_curve **out);

/** By what a net of points is made fair. */
typedef enum batten_net_fair_method {
    BATTEN_NET_FAIR_ENERGY, /**< the least energy of battens along its rows and columns */
    BATTEN_NET_FAIR_LEAST_CHANGE /**< the points move as little as removes the inflections in
                                      excess from sections of the surface */
} batten_net_fair_method;

typedef struct batten_net_fair_options {
    size_t size;
    double within; /**< no point moves farther than this, in model units; required */
    const double *within_each; /**< [count_u][count_v] instead of it; 0 holds a point; may be NULL */
    batten_net_fair_method method; /**< BATTEN_NET_FAIR_ENERGY */
    int hold; /**< at each rim that does not close: 0 nothing, 1 its points, and so the edge of
                   the surface; with LEAST_CHANGE also 2 the tangent planes, 3 the curvatures
                   of the surface there; 0 */
    bool closed_u, closed_v; /**< the net closes smoothly, its first point is not repeated; with
                                  ENERGY; false */
    batten_parametrization parameters; /**< BATTEN_CHORD, averaged over the lines of the net */
    bool mend_blunders; /**< points that look like blunders are first put where their neighbours
                             have them, and their bounds count from there; false */
} batten_net_fair_options;
/** The defaults of fairing a net: no point moves farther than `within`, model units. */
BATTEN_API batten_net_fair_options batten_net_fair_defaults(double within);

/** What the fairing of a net reached, measured on the surface through it. */
typedef struct batten_net_fair_report {
    batten_fair_report points; /**< `set` is the index along v, `index` that along u, and of the
                                    fairness before and after: inflections of all sections, those
                                    in excess, the energy of the battens, the verdict */
    int section_count;         /**< plane sections that are judged */
    int sections_before, sections_after; /**< those with inflections in excess */
    double height;   /**< bulges of sections up to this are not seen */
    double residual; /**< of the least energy: the farthest a point released alone would go, as a part of the
                          lesser of its bound and of the farthest that one would have gone at the start */
} batten_net_fair_report;
/** Release the moves and the suspects of a report. */
BATTEN_API void batten_net_fair_report_release(batten_net_fair_report *report);

/**
 * Fair a rectangular net of points in space, and the bicubic spline through it: its knots are at
 * the points, its ends not-a-knot.
 *
 * With ENERGY the points go where the battens along rows and columns, natural cubic splines (or
 * periodic ones) over the averaged parameters, have the least energy: the sum of the integrals
 * of |z''|^2, each direction times the cube of its mean spacing. All points step at once, so a
 * net that is symmetric stays so. The steps end when no point that is released alone would go
 * farther than a thousandth of the lesser of its bound and of the farthest that one would have gone
 * at the start; `residual` says how far after 3000 of them.
 *
 * With LEAST_CHANGE the control points are found by convex programs: the least sum of
 * (move / bound)^2 and a share of the integral of the squares of the third derivatives, in
 * which linear rows forbid sections the wrong sign of curvature. A net without
 * inflections in excess, and one of which none can be removed, comes back bit for bit.
 *
 * Sections are cut by planes across the rows, across the columns and along both diagonals of the
 * net, at twice as many places as it has points,
 * diagonals at as many, of a family at most 60. A section needs the inflections that the
 * surface of least energy within the bounds has, of bulges above the largest bound;
 * those beyond it, of bulges above a millionth of the size of the net, are in excess.
 *
 * A point is a suspect when it sticks out from the cubics through its neighbours in its row and in
 * its column to the same side, by 6 times the median of all points and by 2 of its bounds; the
 * worst is the first, and those that follow are sought as if it stood right. When more than one
 * in twenty does, none is: the net is rough.
 *
 * @param points  [count_u][count_v][3], at least 4 along each direction
 * @param options  the bound
 * @param job  progress, cancelling; NULL for no questions
 * @param[out] report  what was reached, release it; may be NULL
 * @param[out] faired  [count_u][count_v][3]
 * @param[out] out  the surface through `faired`; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, UNSUPPORTED (by
 * LEAST_CHANGE closed nets, and those whose points times the square of those along v are above a
 * million; tangents held by ENERGY), CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: ENERGY linear for each step; LEAST_CHANGE up to some 500 times the points times the square
 * of 9 times those along v, which is better the shorter side.
 * Source: [SL] VII.3; [BT09] with the restarts of [OC15]; [NW06] ch. 16.
 */
BATTEN_API batten_status batten_fair_net(batten_grid points,
                                         const batten_net_fair_options *options,
                                         const batten_job *job, batten_net_fair_report *report,
                                         double *faired, batten_surface **out);

/** Which families of a table are faired. */
typedef enum batten_fair_families {
    BATTEN_FAIR_STATIONS = 1,
    BATTEN_FAIR_LINES =
        2, /**< waterlines (half-breadths) or named lines (half-breadths and heights) */
    BATTEN_FAIR_BOTH = 3
} batten_fair_families;

/**
 * Fair a table of offsets. A point of a waterline moves in half-breadth only, any other point
 * within the ball of its bound in half-breadth and height; the bound counts from the given
 * table (`within_each`: station by station) and is never exceeded.
 *
 * Each run of at least 4 points of a line is a batten over x; each run of a station is one over
 * its chord length, cut at corners (`corner_angle`). Both are cut at the centre line. Minimised
 * is the sum of the energies of all battens, each family times the cube of its mean spacing, so
 * that a released point listens to both: one batten after another takes the least energy it can
 * reach while the others pull at its ducks as springs. So the sum never rises; the rounds end
 * when no point moves by more than a thousandth of its bound.
 *
 * Held are points on the centre line, points that only end battens (`hold_ends`), and points
 * between neighbours of exactly the same half-breadth: parallel middle body, flat of side.
 * `order`, `relaxation`, `max_moves` and `stop_when_fair` have no meaning here.
 *
 * Moves and suspects of the report name station and point; from and to are (x, y, z).
 *
 * @param offsets  a table with stations; looked at only
 * @param families  which lines are battens
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what moved and what is suspect; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, SINGULAR_HERE, TOLERANCE_NOT_MET, CANCELLED, INCOMPLETE,
 * OUT_OF_MEMORY
 *
 * Cost: linear in the points of the table for each round.
 */
BATTEN_API batten_status batten_fair_offset_table(const batten_offset_table *offsets,
                                                  batten_fair_families families,
                                                  const batten_fair_options *options,
                                                  const batten_job *job,
                                                  batten_fair_report *report,
                                                  batten_offset_table **out);

/* ---- a fair surface at once ---- */

/** How a line is looked at. */
typedef enum batten_loft_view {
    BATTEN_LOFT_IN_SPACE,  /**< both of the others */
    BATTEN_LOFT_IN_PLAN,   /**< from above: its half-breadths over x */
    BATTEN_LOFT_IN_PROFILE /**< from the side: its heights over x */
} batten_loft_view;

/** A run along which a line of a hull is straight. */
typedef struct batten_loft_straight {
    const char *line; /**< its name in the table; or "profile", "sheer" */
    int from, to;     /**< between these stations, from < to, counted from 0 */
    batten_loft_view view;
} batten_loft_straight;

typedef struct batten_loft_options {
    size_t size;
    double within; /**< no point of the table is farther from the surface, in the plane of its
                        station; model units, above 0; required */
    double height; /**< bulges up to this are not seen; 0: a millionth of the breadth */
    int knuckle_count;           /**< lines at which the hull has an edge; 0 */
    const char *const *knuckles; /**< [knuckle_count], their names in the table, in any order */
    int straight_count;          /**< straight runs of its lines; 0 */
    const batten_loft_straight *straight; /**< [straight_count], in any order */
} batten_loft_options;
/** The defaults of a lofting: no point is farther than `within`, model units. */
BATTEN_API batten_loft_options batten_loft_defaults(double within);

/** The families of cuts by which a lofting is judged. */
typedef enum batten_loft_family {
    BATTEN_LOFT_STATION,   /**< x = const */
    BATTEN_LOFT_WATERLINE, /**< z = const */
    BATTEN_LOFT_BUTTOCK,   /**< y = const */
    BATTEN_LOFT_DIAGONAL, /**< through a line of the centre plane, falling by 30 or 45 degrees */
    BATTEN_LOFT_PROFILE,  /**< the lower edge, from the side */
    BATTEN_LOFT_SHEER,    /**< the upper edge, from the side and from above */
    BATTEN_LOFT_KNUCKLE   /**< the lower edge of a panel above the first, likewise */
} batten_loft_family;

/** A cut of the surface, and what the table asks of it. */
typedef struct batten_loft_cut {
    batten_loft_family family;
    double at;  /**< x, z or y; of a diagonal z where it leaves the centre plane; of edges 0 */
    int needed; /**< what the points require; without points the cuts beside, or the first fit */
    int found;  /**< those of the surface, between bulges above the height */
    int panel; /**< which surface, from below and 0; a knuckle counts with the panel above it */
} batten_loft_cut;

/** Why a surface is not at a point of the table. */
typedef enum batten_loft_reason {
    BATTEN_LOFT_NOISE, /**< the point is uneven by less than the bound, and was evened out */
    BATTEN_LOFT_BOUND, /**< the point holds the surface at its bound, which would move farther */
    BATTEN_LOFT_SUSPECT /**< 5 medians off, and all its neighbours to the other side: wrong? */
} batten_loft_reason;

/** A correction of the table: where the surface is instead of a point. */
typedef struct batten_loft_correction {
    int station, index;    /**< which point of the table */
    double from[3], to[3]; /**< as the table and as the faired table have it */
    double distance;       /**< from the point to the surface, in the plane of the station */
    batten_loft_reason reason;
} batten_loft_correction;

/** How far a panel that is straight across is from a plate bent from flat sheet: the warps, angles
 * between the normals at both ends, of 81 rulings at equal steps along its lower line, which lead to where
 * on the upper line the warp is least. The panel itself is straight along its frames, not along these. */
typedef struct batten_loft_warp {
    int panel;                    /**< which surface, from below and 0 */
    double median, most, largest; /**< of half, 90 of 100 and all rulings at most, radians */
    double at[2];                 /**< x on the lower and on the upper line, of the largest */
} batten_loft_warp;

typedef struct batten_loft_report {
    int cut_count;
    batten_loft_cut *cuts;     /**< release with batten_loft_report_release */
    int cuts_in_excess;        /**< those with more inflections than needed */
    int excess_inflections;    /**< of all of them */
    double height;             /**< of the bulges that are seen */
    double max_move, rms_move; /**< from the points of the table to the surface, model units */
    int worst_station, worst_index; /**< where max_move is */
    int correction_count;
    batten_loft_correction *corrections; /**< of the points that moved, the farthest first */
    /** The table as the surfaces have it: points on waterlines at their height, those on edges
     * where the edge is, others the nearest in the plane of the station. */
    batten_offset_table *faired;
    double faired_error; /**< how far its points are off stations and waterlines */
    int trimmed_count;   /**< points on the centre plane that only say that there is no hull */
    int rounds;          /**< programs with conditions on the sign of curvature */
    double enough;   /**< with NOT_COMPATIBLE: a bound that would do, or with which a straight run that
                          the message names can be; 0 when none was found */
    int panel_count; /**< surfaces: one more than knuckles */
    int ruled_count; /**< of these, without points between their lines: straight across */
    int warp_count;  /**< ruled_count, or 0 of one smooth surface */
    batten_loft_warp *warps; /**< [warp_count], from below */
} batten_loft_report;
/** Release the cuts, the corrections, the warps and the faired table of a report. */
BATTEN_API void batten_loft_report_release(batten_loft_report *report);

/**
 * The smooth surface of one half of a hull that keeps every point of a table within a bound, with
 * as few plane sections as it finds that have more inflections than the points require.
 *
 * Along a station runs v, from the profile to the sheer; along the ship u. Found are the control
 * points of one bicubic B-spline surface with knots at the stations: of all whose distance from
 * each point, in the plane of its station, is within the bound, that for which
 *
 *     sum (distance / within)^2 + lambda J3,  J3 = sum C(3, a) integral (S_u..uv..v)^2
 *
 * is least, a = 0 .. 3 derivatives along u; lambda makes the mean distance at most a
 * quarter of the bound.
 * Then stations, waterlines, buttocks, diagonals and the edges are cut. Where there are inflections in
 * excess, the sign of curvature becomes a linear condition, sample by sample, on these cuts and on all
 * stations, waterlines and edges; the program is solved again about the surface that it gave, until no
 * cut is in excess, four rounds in turn do not gain, or ten are done. Profile and stem stay on the
 * centre plane or at their half siding, and the surface does not cross it by more than the height of
 * visible bulges.
 *
 * Points on waterlines alone make stairs of a profile or a sheer that is no waterline. Such a table is lofted as
 * a function y(x, z), where it has no more than one chord in twenty flatter than 1 in 6: x and z of the
 * control points are a map between four lines and held. A 0 there, or no point below the lowest of a station,
 * says that there is no hull and not where it begins: a first function over the whole grid, at most the
 * bound there, tells where stem, stern and foot lie on the centre plane; the top lies between the highest
 * points and the next waterline. These lines are made fair within what the bound leaves open.
 *
 * What is returned has what is reported: distances and inflections are measured on it. A surface
 * with cuts in excess is returned as well; `cuts_in_excess` tells.
 *
 * One surface has no knuckles: a table whose stations turn at a chine is refused, unless the chine is
 * declared to batten_hull_loft.
 *
 * @param table  stations from aft to forward, points from the profile to the sheer or back
 * @param options  never NULL, for the bound has no default
 * @param job  progress, cancelling; NULL for no questions
 * @param[out] report  what was reached; may be NULL. With NOT_COMPATIBLE `enough` is filled in
 * @param[out] out  the half that the table describes, of the table's unit
 * @return BATTEN_OK; BAD_ARGUMENT (the bound: from a billionth of the size to the largest
 * half-breadth; the height; no half-breadth above 0); TOO_FEW_POINTS (3 stations of 3 points, 2 points
 * at each); COINCIDENT; NOT_INCREASING (a station beyond an end of the hull); UNSUPPORTED (knuckles);
 * NOT_COMPATIBLE when no smooth surface was found that keeps the bound: the message has one that can
 * be kept, to a tenth, and the points that hold it; INCOMPLETE, CANCELLED, OUT_OF_MEMORY
 *
 * Cost: 15 to 30 programs, each 10 to 20 times n b^2 for n = 2 or 3 (stations + 2) (points + 2)
 * unknowns in a band b of three rows of control points across: some 0.3 seconds for 100 points
 * Source: [EH95] for the energy, [NW06] ch. 16 and 18 for the programs.
 */
BATTEN_API batten_status batten_surface_loft(const batten_offset_table *table,
                                             const batten_loft_options *options,
                                             const batten_job *job, batten_loft_report *report,
                                             batten_surface **out);

/**
 * The surfaces of one half of a hull with chines and knuckles: panels that share their lines.
 *
 * The profile, each knuckle and the sheer are made fair first, in space: x linear in u, y and z the
 * functions f in the knots of the panels that are within the bound of the points and have the least
 *
 *     sum (distance / bound)^2 + lambda integral (d^3 f / du^3)^2 du
 *
 * with no more inflections over x than the points require; y and z have the bound over the square root
 * of 2 each, and lambda makes the mean distance at most a quarter of it. On a straight run f'' is 0 but for
 * rounding: its control points lie on one straight line; a run begins and ends at knots, which are at the
 * stations of the sheer, and where a line's own ends are elsewhere it reaches out to the next. Panels on both
 * sides of a line have the same control points there. A panel with nothing between its lines is ruled: of degree
 * 1 across, so that its frames are straight; it is judged by its lines, for its other sections turn
 * where its twist makes them. One with points between them is found as by batten_surface_loft, with
 * its edges held. Lines of the table beyond the profile or the sheer are left out before, by
 * batten_offset_table_select.
 *
 * @param table  stations from aft to forward; every line that is named has a point at each
 * @param options  never NULL; without knuckles and straight runs as batten_surface_loft
 * @param job  progress, cancelling; NULL for no questions
 * @param[out] report  of all panels; may be NULL. With NOT_COMPATIBLE `enough` is filled in
 * @param[out] out  [knuckle_count + 1], from below
 * @return as batten_surface_loft; NOT_FOUND (a line that the table does not have, or not at each
 * station; a straight run on a line that bounds no panel); BAD_ARGUMENT (a line named twice; lines that change
 * places from station to station, or may within the bound; straight runs with no room between them);
 * TOO_FEW_POINTS (3 stations)
 *
 * Cost: a few programs of twice as many unknowns as stations for each line; of panels with points
 * as batten_surface_loft
 * Source: as batten_surface_loft.
 */
BATTEN_API batten_status batten_hull_loft(const batten_offset_table *table,
                                          const batten_loft_options *options,
                                          const batten_job *job, batten_loft_report *report,
                                          batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
