/* Numbers that a change of the unit leaves beside a short decimal one. */
#ifndef BAT_NEAR_DECIMAL_H
#define BAT_NEAR_DECIMAL_H
#include "base/base.h"

/* The number of 13 digits next to x when that is at most two last places of x away, else x. */
double bat_near_decimal(double x);

#endif
