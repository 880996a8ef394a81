/* Round numbers, and numbers rounded to be read. */
#ifndef BAT_SHEET_NUMBERS_H
#define BAT_SHEET_NUMBERS_H
#include "base/base.h"
#include <batten/text.h>

/* The smallest of 1, 2, 5, 10 ... times a power of ten that divides `range` into at most
 * `count` parts. */
double bat_round_step(double range, double count);
/* How many decimals a multiple of a round step has; negative for 20, 500 ... */
int bat_decimals_of_step(double step);
/* `value` rounded to so many decimals, as text. */
void bat_number_text(double value, int decimals, char text[static BATTEN_NUMBER_SIZE]);
/* The same, to so many significant digits. */
void bat_digits_text(double value, int digits, char text[static BATTEN_NUMBER_SIZE]);

#endif
