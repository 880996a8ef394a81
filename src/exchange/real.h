/* Numbers as STEP and IGES want them. */
#ifndef BAT_REAL_H
#define BAT_REAL_H
#include <batten/number.h>

#define BAT_REAL_SIZE (BATTEN_NUMBER_SIZE + 2)
#define BAT_INTEGER_SIZE 24

/* A number with a point and a capital E: "1.", "-2.5E-7". The length is handed back. */
int bat_real_write(double value, char text[BAT_REAL_SIZE]);
/* The decimal digits of a whole number, with a zero byte; the length is handed back. */
int bat_integer_write(int64_t value, char text[BAT_INTEGER_SIZE]);

#endif
