#ifndef BAT_REAL_H
#define BAT_REAL_H
#include <batten/number.h>

#define BAT_REAL_SIZE (BATTEN_NUMBER_SIZE + 2)

/* A number as STEP and IGES want it, with a point and a capital E: "1.", "-2.5E-7". */
void bat_real_write(double value, char text[BAT_REAL_SIZE]);

#endif
