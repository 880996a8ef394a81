/* One trial of an approximation within a tolerance: its fit, and the best so far. */
#ifndef BAT_NEAR_WITHIN_TRIAL_H
#define BAT_NEAR_WITHIN_TRIAL_H
#include "shape/near/within.h"

/* One fit: inner knots, and what came of them. */
typedef struct {
    int count; /* inner knots */
    double *inner;
    int data_count;
    double *parameters, *distances; /* [data_count + 1] */
    batten_curve *curve;            /* NULL: the knots do not do */
    double max;
} bat_trial;

void bat_trial_end(bat_trial *t);
batten_status bat_trial_begin(int count, bat_trial *out);
batten_status bat_trial_fit(bat_within *w, bat_trial *t);
bool bat_trial_is_near(const bat_within *w, const bat_trial *t);
/* The curve of this way so far: later fits begin with its parameters; and perhaps the best. */
void bat_trial_keep(bat_within *w, const bat_trial *t);
void bat_trial_copy_parameters(const bat_within *w, const double *from, double *to);
int bat_trial_size(const batten_curve *curve);
/* The knots of `t`, and one in each span that is too far off. */
batten_status bat_trial_refine(const bat_within *w, const bat_trial *t, bat_trial *out);

#endif
