/*
 * The one mechanism under curves near points: control values that make the weighted squares of
 * the distances from data at given parameters, and of what a penalty adds, as small as can be.
 */
#ifndef BAT_APPROXIMATE_H
#define BAT_APPROXIMATE_H
#include "numeric/givens.h"
#include <batten/approximate.h>

/* Rows of equal width that touch neighbouring unknowns, in the order in which bat_givens wants
 * them. */
typedef struct {
    int count, width;
    int *first;     /* [count] */
    double *values; /* [count][width] */
    int *start;     /* [unknowns + 1] where the rows of each place begin in `order` */
    int *order;     /* [count] */
} bat_rows_of_fit;

typedef struct {
    int dimension; /* numbers of a datum: coordinates, or those of a whole line of a grid */
    int degree;
    int count; /* control values; periodic: of one period */
    bool periodic;
    double *knots; /* [count + degree + 1]; periodic: those of one period [count + 1] */
    int data_count;
    const double *points, *parameters; /* the caller's */
    double *factors;                   /* [data_count] roots of the weights */
    bat_rows_of_fit data, penalty;
    double penalty_scale;  /* trace of the data's normal matrix by that of the penalty's */
    bool fixed[2];         /* the first and the last control value are known */
    const double *ends[2]; /* [dimension] */
    double *right;         /* [dimension], the right side of a row on its way */
    bat_givens qr;
} bat_fit;

/* A wish for a fit. */
typedef struct {
    int dimension, degree, count;
    bool periodic;
    const double *knots; /* as in bat_fit */
    int data_count;
    const double *points, *parameters; /* never decreasing, inside the domain */
    const double *weights;             /* NULL: all 1 */
} bat_fit_request;

batten_status bat_fit_begin(const bat_fit_request *request, bat_fit *out);
void bat_fit_end(bat_fit *fit);
/* Other weights; finite, 0 or more. */
void bat_fit_weigh(bat_fit *fit, const double *weights);
/* The squares of the differences of this order of the control values. */
batten_status bat_fit_penalise_differences(bat_fit *fit, int order);
/* The integral of the square of the derivative of this order. */
batten_status bat_fit_penalise_energy(bat_fit *fit, int order);
/* Control values [count][dimension] with lambda times the penalty. SINGULAR_SYSTEM when they
 * are not determined; *unknown names the first. */
batten_status bat_fit_solve(bat_fit *fit, double lambda, double *control, int *unknown);
/* The trace of the matrix that makes values of the fit from data; after bat_fit_solve. */
batten_status bat_fit_freedom(const bat_fit *fit, double *trace);
/* What the curve of `control` has at each datum, minus the datum; [data_count][dimension]. */
void bat_fit_residuals(const bat_fit *fit, const double *control, double *residuals);
/* The first control value that has no datum of its own after Schoenberg and Whitney; -1: none.
 * Not for periodic fits. */
int bat_fit_undetermined(const bat_fit *fit);
batten_status bat_fit_curve(const bat_fit *fit, const double *control, batten_curve **out);

/* How many control values there are with those of a period wrapped, and all their knots;
 * release them. */
int bat_fit_all_count(const bat_fit *fit);
batten_status bat_fit_all_knots(const bat_fit *fit, double **out);

/* ---- under conditions ---- */

enum { BAT_MAX_CONDITIONS = 100000 };

/* What a row is for. */
typedef enum {
    BAT_FOR_START,
    BAT_FOR_END,
    BAT_FOR_CONDITION,
    BAT_FOR_SHAPE,
    BAT_FOR_SIDE,
    BAT_FOR_BAND
} bat_condition_for;

/* values . (normal . control points from `first` on) = right, or >= right. */
typedef struct {
    int first, length;
    double values[BATTEN_MAX_DEGREE + 1], normal[3], right;
    bool least;
    bat_condition_for what;
    int number;
} bat_condition_row;

typedef struct {
    int count;
    bat_condition_row *rows;
    bool coupled; /* some rows bear on several coordinates */
} bat_condition_rows;

/* Are there any in the options? The ends alone do not count. */
bool bat_fit_has_conditions(const batten_curve_least_squares_options *options);
/* NOT_FINITE, BAD_ARGUMENT, OUT_OF_DOMAIN naming the condition. */
batten_status bat_fit_conditions(const bat_fit *fit,
                                 const batten_curve_least_squares_options *options,
                                 bat_condition_rows *out);
void bat_condition_rows_free(bat_condition_rows *rows);
/* As bat_fit_solve, under conditions, and how many of them press; `freedom` as of
 * bat_fit_freedom. NOT_COMPATIBLE naming the condition. */
batten_status bat_fit_solve_under(const bat_fit *fit, double lambda,
                                  const batten_curve_least_squares_options *options,
                                  const bat_condition_rows *rows, double *control,
                                  int *pressing, double *freedom);

/* ---- robust ---- */

typedef struct {
    batten_robust how;
    double threshold; /* 0: choose it, once */
    double cost;      /* what is summed, of the last fit */
    double gap;
    int rounds;
} bat_robust;

/* Weigh the data anew until the sum is least. The fit is solved; `solve` solves it again and
 * fills `residuals`. At the end the factors are those of the last solution. */
batten_status bat_fit_robustly(bat_fit *fit, const double *weights,
                               batten_status (*solve)(void *user, bat_fit *fit), void *user,
                               double *residuals, bat_robust *robust);

/* ---- parameters and knots ---- */

/* Parameters of data where neighbours may coincide: [count], periodic [count + 1]. */
batten_status bat_fit_parameters(int dimension, int count, const double *points,
                                 batten_parametrization kind, const double *given,
                                 bool periodic, double *parameters);
batten_status bat_weights_check(int count, const double *weights);
/* Knots with equally many data between, `count` control values; [count + degree + 1] or
 * periodic [count + 1]. Data of weight 0 do not count. TOO_FEW_POINTS when fewer parameters
 * differ than there are values. */
batten_status bat_fit_knots(const bat_fit_request *request, double *knots);
/* Knots where the derivative after the last is large, from a first curve. */
batten_status bat_fit_knots_by_curvature(const bat_fit_request *request,
                                         const batten_curve *first, double *knots);

/* The report's max, rms, worst from residuals; data of weight 0 do not count. */
void bat_fit_measure(const bat_fit *fit, const double *residuals, batten_fit_report *report);
/* Parameters one step of Newton nearer to the feet of the data, in the same order. */
batten_status bat_fit_correct(int dimension, int count, const double *points,
                              const batten_curve *curve, double *parameters);

#endif
