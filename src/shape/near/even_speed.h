/* Curves by arc length, for those who bound their size. */
#ifndef BAT_EVEN_SPEED_H
#define BAT_EVEN_SPEED_H
#include <batten/approximate.h>

/* batten_curve_even_speed in at most so many pieces; more are TOLERANCE_NOT_MET. */
batten_status bat_curve_even_speed(const batten_curve *curve, double tolerance, int most,
                                   batten_curve_even_speed_report *report, batten_curve **out);

#endif
