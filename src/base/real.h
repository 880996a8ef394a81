/* Numbers as STEP and IGES want them. */
#ifndef BAT_REAL_H
#define BAT_REAL_H
#include <batten/text.h>

#define BAT_REAL_SIZE BATTEN_NUMBER_SIZE
#define BAT_INTEGER_SIZE 24

/* A number with a point and a capital E: "1.", "-2.5E-7"; to text[BAT_REAL_SIZE].
 * The length is handed back. */
int bat_real_write(double value, char *text);
/* The number that begins at `text`, as batten_number_read has it, when it is of a common kind:
 * its end is handed back, or NULL when that function must be asked. */
const char *bat_number_quick(const char *text, const char *end, double *value);
/* The decimal digits of a whole number, with a zero byte, to text[BAT_INTEGER_SIZE]; the length
 * is handed back. */
int bat_integer_write(int64_t value, char *text);

#endif
