/* Units as reports print them, and lengths with units as options take them. */
#ifndef CLI_UNIT_H
#define CLI_UNIT_H
#include "command.h"

enum { UNIT_SIZE = 32 };

/* "mm"; "0.75 m" for one without a name; "" when none is stated. */
void unit_words(double metres, char out[UNIT_SIZE]);

/* Is the option not given, or a length above 0, "0.1", "0.1mm" or "0.1 mm"? False with a
 * complaint. */
bool unit_length_check(const char *asked, const arguments *given, const char *name);
/* The same of a value that a design evaluates: an expression, "= 2 * 1 mm", is left to it. */
bool unit_value_check(const char *asked, const arguments *given, const char *name);
/* The option, which was checked, in the unit that is `metres` long; a number alone is in it
 * already. Untouched when it was not given; BAD_ARGUMENT when it has a unit and `metres` is 0,
 * not known. */
batten_status unit_length_in(const arguments *given, const char *name, double metres,
                             double *out);

#endif
