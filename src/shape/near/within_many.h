/* Knots that come and go where there are very many data. */
#ifndef BAT_NEAR_WITHIN_MANY_H
#define BAT_NEAR_WITHIN_MANY_H
#include "shape/near/within_trial.h"

/* Beyond, a fit is dear, and a second way to fewer knots is not worth its time. */
enum { BAT_WITHIN_MANY = 5000 };

/* Let the knots of `t`, the first few, become more by samples of the data, while a sample of all is enough for them:
 * where a sample is too far off, all data are. t has no curve, neither before nor after. */
batten_status bat_within_first_knots(bat_within *work, bat_trial *t);

/* Take ranked knots away in many places at once, until `most` fits are done; *t becomes the curve without them. */
batten_status bat_within_thin(bat_within *work, bat_trial *t, int count, const int *ranked,
                              int most, int *removed);

#endif
