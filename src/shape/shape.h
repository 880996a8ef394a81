/*
 * The one mechanism under interpolation: a linear operator that turns data at parameters into
 * the control values of a spline. Curves give it rows of d numbers; a grid gives it whole lines
 * of points, along u and then along v; a skin gives it the control points of its sections.
 */
#ifndef BAT_SHAPE_H
#define BAT_SHAPE_H
#include "numeric/banded.h"
#include "spline/data_check.h"
#include <batten/interpolate.h>

/* The steps between the parameters of checked points, 0 where points coincide; [count - 1],
 * closed [count]. */
void bat_steps(int dimension, int count, const double *points, batten_parametrization kind,
               bool closed, double *steps);
/* batten_parametrize for checked points; on failure `parameters` is spoilt. */
batten_status bat_parametrize(int dimension, int count, const double *points,
                              batten_parametrization kind, bool closed, double *parameters);
/* The same with steps that are chords to the power alpha, 0 to 1. */
batten_status bat_parametrize_power(int dimension, int count, const double *points,
                                    double alpha, bool closed, double *parameters);

/* The parameters of points by a kind or as given, in *out [count], closed [count + 1]; release
 * them, after a failure too. */
batten_status bat_parameters_of(int dimension, int count, const double *points,
                                batten_parametrization kind, const double *given, bool closed,
                                double **out);

/* What holds at start and end of a curve through at least two points, with the derivatives it
 * asks for: directions and circles become CLAMPED (or BESSEL, where there is no circle),
 * curvatures SECOND, still to be found. */
batten_status bat_ends_resolve(int dimension, int count, const double *points,
                               const double *parameters, const batten_end ends[2],
                               batten_end_kind kinds[2], double values[2][3]);
/* The same as one of CLAMPED, SECOND and PARABOLIC alone; others are refused in the name of
 * `what`: "splines in tension". */
batten_status bat_ends_plain(int dimension, int count, const double *points,
                             const double *parameters, const batten_end ends[2],
                             const char *what, batten_end_kind kinds[2], double values[2][3]);

/* A family of lines of points that shall have the same parameters: the rows of a grid. */
typedef struct {
    const char *name;             /* of what crosses them, for messages: "u grid lines" */
    int dimension, count, lines;  /* `lines` of `count` points */
    size_t point_step, line_step; /* in numbers */
    bool periodic;
    const double *points, *given;
} bat_family;

/* Parameters 0 .. 1, the average of those of all lines that are not a single point; or those
 * given.
 * @param u  [count], periodic [count + 1], zeros; @param spread  how far a line's own are from
 * them, in steps */
batten_status bat_family_parametrize(const bat_family *family, batten_parametrization kind,
                                     double *u, double *spread);

/* When all data of a rim, that at the start or end of direction 0 (u) or 1, are one point, so
 * are, but for rounding, all its control points: make them it. */
void bat_keep_pole(int dimension, const int data_count[2], const double *data,
                   const int control_count[2], double *control, int direction, bool at_start);

/* What is asked of the spline: its value at each parameter, and more. */
typedef struct {
    int degree;
    int count;                /* data */
    const double *parameters; /* [count], increasing; periodic [count + 1] */
    bool knots_at_data, periodic;
    batten_end_kind start, end; /* with knots at the data; those that are linear: not CIRCLE,
                                   CURVATURE, DIRECTION */
    int condition_count;        /* derivatives at data points */
    const batten_derivative *conditions;
} bat_request;

/* Where the right side of an equation comes from; else it is the number of a condition. */
enum {
    BAT_FROM_DATA = -1,
    BAT_FROM_START = -2,
    BAT_FROM_END = -3,
    BAT_FROM_BESSEL_START = -4,
    BAT_FROM_BESSEL_END = -5,
    BAT_FROM_ZERO = -6
};

/* One row of the equations: a derivative of the spline at a data point. */
typedef struct {
    int index, order;
    int source;
} bat_row;

typedef struct {
    int degree, data_count;
    int count; /* control values; periodic: of one period */
    bool periodic;
    double *knots;  /* [count + degree + 1]; periodic [count + 1] */
    double step[4]; /* the first two steps of the parameters and the last two, for Bessel's
                       slopes */
    bat_row *rows;  /* [count] */
    int lower, upper;
    double *matrix, *factor; /* bands; when periodic `cyclic` instead of `factor` */
    bat_cyclic *cyclic;
    /* Ends that are FAIR: their rows, the control values for a unit slope there and zeros else,
     * the gradient of the sum of squared jumps of the third derivative along these, and their
     * Gram matrix. */
    int fair_count;
    int fair_row[2];
    double *response, *gradient; /* [fair_count][count] */
    double gram[2][2];
} bat_operator;

batten_status bat_operator_make(const bat_request *request, bat_operator *out);
void bat_operator_free(bat_operator *op);
/*
 * Control values [count][width] from data [data_count][width], the values that the ends CLAMPED
 * and SECOND ask for
 * ([width] each; NULL for zeros) and those of the conditions [condition_count][width]. The
 * result is checked against the data: TOLERANCE_NOT_MET when a value is missed by more than 8
 * eps of the largest number.
 */
batten_status bat_operator_apply(const bat_operator *op, size_t width, const double *data,
                                 const double *start, const double *end,
                                 const double *conditions, double *control);

/* The slope at a of the parabola through a, b, c that are h0 and h1 apart. */
void bat_bessel_slope(size_t width, double h0, double h1, const double *a, const double *b,
                      const double *c, double *slope);

#endif
