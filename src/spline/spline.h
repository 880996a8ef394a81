/*
 * The one mechanism under curves and surfaces: a polynomial spline whose control values are
 * rows of `width` numbers. A polynomial curve has width d, a rational one d + 1 (w x, w y, ..,
 * w); a surface is, along u, a spline whose rows hold a whole line of control points, and along
 * v the same after transposing. So knot insertion, removal, elevation, splitting are written
 * once.
 *
 * A bat_spline owns its arrays. All operations make a new one and leave the old; they know
 * nothing of weights or of periodicity.
 */
#ifndef BAT_SPLINE_H
#define BAT_SPLINE_H
#include "base/base.h"
#include <batten/curve.h>

typedef struct {
    int degree, count;
    size_t width;
    double *knots;  /* [count + degree + 1] */
    double *values; /* [count][width] */
} bat_spline;

batten_status bat_spline_make(int degree, int count, size_t width, bat_spline *out);
void bat_spline_free(bat_spline *spline);

/* ---- knots (src/spline/knots/knots.c) ---- */

/* Check what a caller gave: finite, not decreasing, multiplicities, a domain. `what` names it
 * in messages: "knot", "knot in u". */
batten_status bat_knots_check(int degree, int count, const double *knots, const char *what);
/* The span index k with U[k] <= u < U[k + 1], p <= k < n; the last span is closed on the right;
 * from the left: U[k] < u <= U[k + 1]. u must lie in the domain. */
int bat_knots_span(int degree, int count, const double *knots, double u, batten_side side);
int bat_knots_multiplicity(int degree, int count, const double *knots, double u);
/* How many derivatives do not jump at any inner knot, from 0 to `most`. */
int bat_knots_smoothness(int degree, int count, const double *knots, int most);
/* Move a parameter at most 4 ulps outside onto the end; OUT_OF_DOMAIN or NOT_FINITE otherwise.
 */
batten_status bat_knots_clip(double a, double b, double *u);
/* May `new_knots` [added] be inserted? They rise, lie in the domain, and stand not too often
 * with those there. */
batten_status bat_knots_check_insertion(int degree, int count, const double *knots,
                                        bool periodic, int added, const double *new_knots);
/* All m + 2 p + 1 knots of a periodic spline from the m + 1 of one period; `period` becomes
 * knots p .. p + m. */
void bat_knots_wrap(int degree, int m, const double *period, double *knots);
/* The knots of the reversed spline: negated, so that reversing twice gives the same bits. */
void bat_knots_reverse(int degree, int count, const double *knots, double *out);
/* The knots with their domain mapped linearly to [a, b]; BAD_KNOTS when distinct ones would
 * coincide there. */
batten_status bat_knots_map(int degree, int count, const double *knots, double a, double b,
                            double *out);
/* Greville's abscissa of control point i, where it acts most: the mean of the knots i + 1 .. i +
 * degree, never outside them. The degree is at least 1. */
double bat_greville(int degree, const double *knots, int i);
/* Basis functions N[0..p] that live on span k, and their derivatives up to `order`: out [order
 * + 1][p + 1]. */
void bat_basis(int degree, const double *knots, int span, double u, int order, double *out);

/* ---- one span in Bezier form (src/spline/piece.c) ----
 *
 * Evaluation turns the p + 1 rows that bear on a span into its Bezier rows and combines these
 * with Bernstein polynomials of t = (u - U[k]) / (U[k + 1] - U[k]): a convex combination, so
 * accurate for every degree, and exact at both ends of the span. One call and a batch share
 * these steps, hence the same bits. */

/* In place: the rows [p + 1][width] of points span - p .. span become Bezier rows. */
void bat_piece_from_rows(int degree, const double *knots, int span, size_t width, double *rows);
/* In place: Bezier rows of degree p become those of the derivative, degree p - 1. */
void bat_piece_derive(int degree, double width_of_span, size_t width, double *rows);
/* In place: rows of points span - p .. span become those of the derivative; the knots stay and
 * the degree is one less, points span - p + 1 .. span. */
void bat_rows_derive(int degree, const double *knots, int span, size_t width, double *rows);
/* Is the span so much narrower than its neighbours that differences of its Bezier rows would
 * lose digits? Then derivatives go through bat_rows_derive. 64 degree: at most 6 bits beyond
 * those of equal spans are lost. */
bool bat_span_is_tight(int degree, const double *knots, int span);
/* Bernstein polynomials out [p + 1] at t, s = 1 - t; at 0 and 1 exactly 0 and 1. */
void bat_bernstein(int degree, double t, double s, double *out);
/* out [width] = sum of basis[i] rows[i]. */
void bat_combine(int degree, const double *basis, size_t width, const double *rows,
                 double *out);
extern const double bat_binomials[BATTEN_MAX_DEGREE + 1][BATTEN_MAX_DEGREE + 1];

/* ---- other forms (src/spline/curve/forms.c) ---- */

/* Breaks [piece_count + 1] are finite and rise. */
batten_status bat_breaks_check(int piece_count, const double *breaks);
/* Each break `times` times, the first and the last degree + 1 times; release them. */
double *bat_knots_of_breaks(int degree, int times, int piece_count, const double *breaks);
/* The control rows out [count][k][width], degree 2 k - 1, that take values [count][k][width]
 * (value, first .. derivative) at the parameters. */
void bat_hermite_points(int width, int count, int k, const double *parameters,
                        const double *values, double *out);
/* The Bezier rows b [p + 1][width] of a piece of length h in powers c [p + 1][width]. */
void bat_power_to_bezier(int p, size_t width, double h, const double *c, double *b);

/* ---- exact algebra (src/spline/knots) ---- */

/* Insert knots [count], never decreasing, inside the domain or at its ends, none more often
 * than p + 1 times together with those there. Rows that do not change keep their bits. */
batten_status bat_spline_insert(const bat_spline *spline, int count, const double *knots,
                                bat_spline *out);
/* One knot, inside the domain, up to `times` times while no point moves by more than
 * `tolerance`: a row is a number of points of `group` coordinates, group <= 4. *error: a bound
 * on the movement of the whole shape. */
batten_status bat_spline_remove(const bat_spline *spline, double u, int times, size_t group,
                                double tolerance, int *removed, double *error, bat_spline *out);
/* All inner knots that can go while the spline moves by no more than `tolerance`: one by one,
 * movements added up span by span, those that cost least first; then by
 * bat_spline_reduce_knots.
 */
batten_status bat_spline_remove_all(const bat_spline *spline, size_t group, double tolerance,
                                    int *removed, double *error, bat_spline *out);
/* The part of it that goes knot by knot, in place. */
batten_status bat_spline_thin(bat_spline *spline, size_t group, double tolerance, int *removed,
                              double *error);
/* What one removal of each distinct inner knot alone would move, at its last index; infinity
 * elsewhere. errors [count + degree + 1]. */
batten_status bat_spline_removal_errors(const bat_spline *spline, size_t group, double *errors);
/* Those knots in the order in which they can best be spared, judged against `tolerance`, such
 * that the first few of equal rank are spread evenly. order [count + degree + 1]
 * (reduce_knots.c). */
batten_status bat_spline_rank_knots(const bat_spline *spline, size_t group, double tolerance,
                                    int *order, int *count);
/* Fewer knots still for a spline that is within `tolerance` of `fine` and has a part of its
 * knots: groups of them go, and the rest is fitted to `fine` by least squares. The ends stay to
 * the bit. *error: a bound, changed when the spline is; a spline with unclamped ends is left as
 * it is (reduce_knots.c). Cost 64 log2(count) fits at most, each of count degree^2 width. */
batten_status bat_spline_reduce_knots(const bat_spline *fine, size_t group, double tolerance,
                                      bat_spline *coarse, double *error);
/* Every distinct knot `by` times more; of unclamped ends as many knots are kept as are needed.
 */
batten_status bat_spline_elevate(const bat_spline *spline, int by, bat_spline *out);
/* Weights [p + 1] of the rows span - p .. span in the elevated row that has the p + 1 knots
 * `window`; the span is that which holds the knot before them. */
void bat_elevation_row(int degree, const double *knots, int span, const double *window,
                       double *out);
/* Clamped; inner knots stand once less for each degree, once at least. TOLERANCE_NOT_MET when
 * rows move by more than `tolerance`, in the sense of bat_spline_remove. */
batten_status bat_spline_reduce(const bat_spline *spline, int degree, size_t group,
                                double tolerance, double *error, bat_spline *out);
/* A tolerance is a number, and not negative (curve_simplify.c). */
batten_status bat_tolerance_check(double tolerance);
/* Clamped at both ends of [a, b] inside the domain. */
batten_status bat_spline_subrange(const bat_spline *spline, double a, double b,
                                  bat_spline *out);
/* Both parts clamped at both ends; they share the row at u. */
batten_status bat_spline_split(const bat_spline *spline, double u, bat_spline *low,
                               bat_spline *high);
/* Every knot of the domain p times, p + 1 at its ends. */
batten_status bat_spline_to_bezier(const bat_spline *spline, bat_spline *out);

#endif
