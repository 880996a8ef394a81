/* Numbers as STEP and IGES want them. */
#ifndef BAT_REAL_H
#define BAT_REAL_H
#include <batten/text.h>

#define BAT_REAL_SIZE BATTEN_NUMBER_SIZE
#define BAT_INTEGER_SIZE 24

/* A number with a point and a capital E: "1.", "-2.5E-7"; to text[BAT_REAL_SIZE].
 * The length is handed back. */
int bat_real_write(double value, char *text);
/* The decimal digits of a whole number, with a zero byte, to text[BAT_INTEGER_SIZE]; the length
 * is handed back. */
int bat_integer_write(int64_t value, char *text);

#endif
