/* Words that go with a count of any type: "1 point is", "2 points are". */
#ifndef BAT_PLURAL_H
#define BAT_PLURAL_H
#include <batten/text.h>

#include <math.h>
#include <string.h>

/* The ending of a regular noun. */
#define bat_plural(count) ((count) == 1 ? "" : "s")
/* "vertex" or "vertices", "is" or "are". */
#define bat_one_or_many(count, one, many) ((count) == 1 ? (one) : (many))

/* The ending of a regular noun after a number that is printed with "%.*g" and so many digits: "1 degree", "1.5
 * degrees". */
static inline const char *bat_plural_real(double value, int digits)
{
    char text[32]; /* at most 17 digits, a point, a sign, an exponent */
    batten_text_print(text, sizeof text, "%.*g", digits, fabs(value));
    return strcmp(text, "1") == 0 ? "" : "s";
}

#endif
