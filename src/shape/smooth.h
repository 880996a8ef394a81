/* What smoothing splines and P-splines share: a fit with a penalty, a search for its weight. */
#ifndef BAT_SMOOTH_H
#define BAT_SMOOTH_H
#include "shape/approximate.h"

typedef struct {
    const batten_smooth_options *options;
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
