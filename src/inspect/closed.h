/* Plane curves that enclose something. */
#ifndef BAT_CLOSED_H
#define BAT_CLOSED_H
#include <batten/curve.h>

/* In the plane, and with ends no farther apart than `closed`; else NOT_COMPATIBLE. */
batten_status bat_closed_check(const batten_curve *curve, double closed);

#endif
