#ifndef BATTEN_GORDON_H
#define BATTEN_GORDON_H
/**
 * @file
 * The surface through a network of curves: two families that cross each other.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The functions that are 1 at one curve of a family and 0 at all others. */
typedef enum batten_gordon_blend {
    BATTEN_GORDON_SPLINE,  /**< cubic splines, C2; periodic where the network closes smoothly */
    BATTEN_GORDON_LINEAR,  /**< piecewise linear: local, with creases along the curves */
    BATTEN_GORDON_LAGRANGE /**< polynomials: smooth, and they swing; at most 12 curves */
} batten_gordon_blend;

typedef struct batten_surface_gordon_options {
    size_t size;
    double tolerance; /**< model units, > 0; must be set: how far the surface may be from a
                           curve */
    double
        gap; /**< model units: the widest gap between two curves that should meet, and between
                     the ends of a curve that should close; 0: the tolerance. Where gaps are
                     wider than the tolerance, a curve may lie farther from the surface by the
                     widest gap that there is, as the surface runs midway */
    batten_gordon_blend blend; /**< BATTEN_GORDON_SPLINE */
    bool cut; /**< curves that continue beyond the outermost ones they meet are cut there; true.
                   Else they are refused */
    const char *const *profile_names; /**< [profile_count] for messages, or NULL */
    const char *const *guide_names;   /**< [guide_count], or NULL */
} batten_surface_gordon_options;
/** The defaults of Gordon surfaces: those beside the fields of batten_surface_gordon_options. */
BATTEN_API batten_surface_gordon_options batten_surface_gordon_defaults(void);

/** Two curves of a family that are one, at the seam of closed ones: the first is used. */
typedef struct batten_gordon_repeated {
    bool is_guide;
    int used, left; /**< as numbered by the caller */
    double apart;   /**< how far the curve that is left out is from the other one */
} batten_gordon_repeated;
enum { BATTEN_GORDON_REPEATED = 4 };

typedef struct batten_surface_gordon_report {
    double gap; /**< the widest between a profile and a guide, model units */
    int gap_profile, gap_guide;
    double error; /**< the largest distance of a curve from its line on the surface, at
                         equal parameters: at all knots and 8 places between any two, with what
                           making it polynomial cost */
    bool worst_is_guide;
    int worst;         /**< the profile or guide that is missed most */
    double node_error; /**< the largest distance of the surface from a node: the middle of the
                          gap */
    double spread; /**< the largest difference of a node's parameter on a curve (over [0, 1])
                        from that of the surface; curves are reparametrised by that */
    double cut;    /**< the longest piece cut off, as the distance of its ends */
    int cut_count; /**< curves that were cut */
    int reversed_count; /**< curves that are run backwards */
    int repeated_count; /**< curves that were given twice, at the seam, and are used once */
    batten_gordon_repeated repeated[BATTEN_GORDON_REPEATED]; /**< the first of them */
    double seam;        /**< the widest distance of the ends of a curve taken as closed */
    bool seam_is_guide; /**< whose ends these are */
    int seam_curve;
    double size;    /**< batten_network_size of all curves */
    double nearest; /**< the smallest distance of neighbours of a family where they meet
                       one of the other; HUGE_VAL when there are no two */
    bool nearest_is_guide;
    int nearest_curves[2];
    double guide_error; /**< the largest distance of a guide from the skin of the profiles
                          alone: what the guides do between them; at 2 to 8 places between
                          any two profiles */
    int guide_worst;    /**< that guide, and the place */
    batten_vec3 guide_worst_at;
    int pole_count;          /**< points in which one family ends */
    bool closed_u, closed_v; /**< the profiles close; the guides close */
    bool smooth_u, smooth_v; /**< and do so smoothly */
    bool exact_u, exact_v;   /**< profiles, guides are met exactly, with all their knots */
    int points_u, points_v;  /**< control points of the surface; of a period */
    int exact_knots_u, exact_knots_v; /**< inner knots that all curves have together */
} batten_surface_gordon_report;

/**
 * Gordon's surface: u runs along the profiles, v along the guides, both over [0, 1].
 *
 * Where each profile meets each guide is searched for; the order of the curves and their
 * directions are found: u runs as the first profile that is not a point does, v as the first
 * such guide. Curves that are not parametrised alike are reparametrised by a monotone function
 * such that all nodes stand at common parameters, the means. Then the curves of each family get
 * few common knots (all they have, exactly, when they fit together as they are and that is no
 * more than twice the mean), and the surface is the sum of the skin of the guides and that of
 * the profiles minus the tensor surface of the nodes, which are met to rounding. What closes
 * smoothly becomes periodic, with two continuous derivatives across the seam; where it stays
 * exact, or the blend is not a spline, it is clamped there and as smooth as the curves are.
 *
 * Each profile must meet each guide in one place; a gap much wider than that place's own does
 * not count, so that a wide `gap` joins nothing that meets more closely elsewhere. Two curves
 * of a family are one when they are within 1e-6 of the size of the network, or twice the widest
 * gap of their own joints. A curve whose ends are within the gap is closed, but not when two
 * different curves begin at them. A curve that is closed may start anywhere; a network whose
 * profiles (guides) all close, closes; the guide at the seam may be given once or twice. A
 * profile may be a point; where all guides end in one point and no profile is given, a pole is
 * made there. Rational curves are made polynomial.
 *
 * @param profiles  profile_count, guide_count: 1 or more; 2 with poles and the seam of closed
 *              ones counted
 * @param options  its tolerance must be set
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; NOT_COMPATIBLE with how many pairs miss each other and the three widest
 * gaps, or naming two curves that meet twice, or whose order differs; COINCIDENT;
 * TOO_FEW_POINTS; BAD_ARGUMENT; NOT_FINITE; UNSUPPORTED (dimension 1); TOO_LARGE with the size
 * it would have; TOLERANCE_NOT_MET with the curve that is missed
 *
 * Cost: log(n) for each pair of curves with n spans to find where they meet; the common knots
 * as batten_surface_skin; then points_u points_v (profile_count + guide_count). Source:
 * [Gordon69], [Gordon71]; [PT97] 10.5.
 */
BATTEN_API batten_status batten_surface_gordon(batten_curve_row profiles,
                                               batten_curve_row guides,
                                               const batten_surface_gordon_options *options,
                                               const batten_job *job,
                                               batten_surface_gordon_report *report,
                                               batten_surface **out);

/** The diagonal of the box round the control points of all curves.
 * @param count 1 or more */
BATTEN_API double batten_network_size(int count, const batten_curve *const *curves);

/**
 * Split one list of curves into two families such that no curve meets one of its own family,
 * but in end points that they share: poles.
 *
 * @param tolerance model units, > 0: curves that come so near to each other meet
 * @param names [count] for messages, or NULL
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] family [count]: 0 for profiles, the family of the first curve, 1 for guides
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_COMPATIBLE naming a curve that meets no other, with
 * the distance of the nearest, or two that cross and would be of one family, or two parts that
 * do not meet Cost: count^2 pairs.
 */
BATTEN_API batten_status batten_network_split(int count, const batten_curve *const *curves,
                                              double tolerance, const char *const *names,
                                              const batten_job *job, int *family);

#ifdef __cplusplus
}
#endif
#endif
