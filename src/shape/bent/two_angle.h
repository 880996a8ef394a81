/*
 * The common scheme of all nonlinear plane splines through points: a span family tells the
 * curvatures at both ends of a span from the two angles between its chord and its tangents; one
 * driver finds the tangents for which curvature is continuous.
 *
 * Of a span with chord length l: alpha = theta_0 - phi, beta = theta_1 - phi, where phi is the
 * direction of the chord and theta that of the tangents. A left turn is positive.
 */
#ifndef BAT_TWO_ANGLE_H
#define BAT_TWO_ANGLE_H
#include "base/base.h"
#include <batten/bent.h>

/* The curvatures at the ends, and how they change. */
typedef struct {
    double k0, k1;
    double k0_alpha, k0_beta, k1_alpha, k1_beta; /* partial derivatives */
} bat_end_curvatures;

/* The most spans of a chain that stand for one span between points. */
enum { BAT_FAMILY_SPANS = 2 };

typedef struct bat_span_family bat_span_family;
struct bat_span_family {
    const char *name;
    double limit;       /* the largest |alpha| and |beta| that the family allows, radians */
    const char *remedy; /* what to use where it allows no more: "an Euler spiral" */
    /* SINGULAR_SYSTEM when the span has no solution at these angles. `tension`: sigma l of this
     * span; families without one ignore it. Newton ends at jumps of 1e-12 of the largest
     * curvature, so values need a relative precision of 1e-13. */
    batten_status (*curvatures)(double alpha, double beta, double l, double tension,
                                bat_end_curvatures *out);
    /* The span itself, in its own frame: from (0, 0) to (l, 0), with directions alpha and beta.
     * Fills 1..BAT_FAMILY_SPANS spans. */
    batten_status (*spans)(double alpha, double beta, double l, double tension,
                           batten_span *out, int *count);
};

/* The families, each in its file family_NAME.c. */
extern const bat_span_family bat_family_local_cubic, bat_family_local_tension,
    bat_family_geometric, bat_family_euler_spiral, bat_family_arcs, bat_family_elastica,
    bat_family_hobby;

/* The most sigma l that is chosen for a span: the curve is then all but the chord. */
#define BAT_MOST_TENSION 1e3
/* The least sigma l for which a local spline in tension bends to one side only; alpha and beta
 * of opposite signs. BAT_MOST_TENSION where that is not enough. */
double bat_local_tension_for(double alpha, double beta);

/* The polygon of the points and what is asked of the tangents. Lengths in any unit. */
typedef struct {
    const bat_span_family *family;
    int count, spans; /* points; one span fewer, closed as many */
    bool closed;
    const double *length; /* [spans] of the chords */
    const double *turn;   /* [count] of the polygon at each point, radians; 0 at the ends */
    double *tension;      /* [spans] sigma l */
    batten_nonlinear_end start, end;
    double start_value, end_value; /* TANGENT: measured from the end chord */
} bat_two_angle;

/* Angles of span j, from those [count] of the tangents, each measured from the chord that
 * leaves its point (the last one of an open curve: from the last chord). */
void bat_two_angle_span(const bat_two_angle *task, const double *angles, int j, double *alpha,
                        double *beta);
/* Those of the circles through three points, within the limits of the family. */
batten_status bat_two_angle_start(const bat_two_angle *task, double *angles);
/* Improve them until curvature is continuous; `report`: all but inflections_added. */
batten_status bat_two_angle_solve(const bat_two_angle *task, int max_steps, double *angles,
                                  batten_chain_nonlinear_report *report);

#endif
