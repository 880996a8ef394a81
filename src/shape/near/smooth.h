/* What smoothing splines and P-splines share: a fit with a penalty, a search for its weight. */
#ifndef BAT_SMOOTH_H
#define BAT_SMOOTH_H
#include "shape/near/approximate.h"

/* How the weight of any penalty is chosen: rms of the residuals rises with lambda, the score of
 * a cross validation has a least. SINGULAR_SYSTEM from `rms` says that lambda is beyond all
 * numbers; `score` gives HUGE_VAL instead. */
typedef struct {
    batten_smooth_by by;
    double amount; /* the target of rms, or lambda */
    double scale;  /* lambda of decade 0: trace of the data's matrix by that of the penalty's */
    double last;   /* the last decade that is tried */
    bool coarse;   /* a fit costs much */
    double near;   /* > 0: a lambda near which the score is likely to have its least */
    void *user;
    batten_status (*rms)(void *user, double lambda, double *rms);
    batten_status (*score)(void *user, double lambda, double *score);
} bat_lambda_search;
/* 0 to infinity. */
batten_status bat_lambda_choose(const bat_lambda_search *search, double *lambda);
/* The penalty of the smoothest shape that is not a polynomial is so much smaller than the mean:
 * about (pi / count)^(2 m); four decades more make it as good as a polynomial. */
double bat_last_decade(int order, int count);

typedef struct {
    const batten_curve_smooth_options *options;
    bat_fit_request request;
    double *parameters; /* [count + 1] */
    double *knots;
    double *control, *residuals;
    int distinct;  /* parameters that differ, of data that count */
    int counted;   /* data that count */
    double weight; /* of all data */
    bat_fit fit;
    batten_fit_report report;
    batten_curve *curve;
} bat_smoothing;

/* The fit with this weight: control values, residuals, report. */
batten_status bat_smoothing_try(bat_smoothing *t, double lambda);
/* The weight that the options ask for, 0 to infinity. */
batten_status bat_smoothing_choose(bat_smoothing *t, double *lambda);

#endif
