/* Units of length as options give them. */
#include "unit.h"

#include <batten/text.h>
#include <stdio.h>
#include <string.h>

void unit_words(double metres, char out[UNIT_SIZE])
{
    const char *name = batten_unit_name(metres);
    out[0] = '\0';
    if (name)
        snprintf(out, UNIT_SIZE, "%s", name);
    else if (metres > 0)
        snprintf(out, UNIT_SIZE, "%.12g m", metres);
}

/* A number and the unit behind it, 0 metres for none. False when either cannot be read. */
static bool read_length(const char *text, double *value, double *metres)
{
    size_t used = 0;
    if (batten_number_read(text, strlen(text), value, &used) != BATTEN_OK)
        return false;
    const char *unit = text + used + strspn(text + used, " ");
    *metres = *unit ? batten_unit_metres(unit) : 0;
    return !*unit || *metres > 0;
}

bool unit_length_check(const char *asked, const arguments *given, const char *name)
{
    const char *text = arguments_get(given, name);
    double value = 0, metres = 0;
    if (!text)
        return true;
    if (!read_length(text, &value, &metres)) {
        complain("batten %s: --%s wants a length, as 0.1 or 0.1mm, not '%s'", asked, name,
                 text);
        return false;
    }
    if (value > 0)
        return true;
    complain("batten %s: --%s is %s; it must be above 0", asked, name, text);
    return false;
}

bool unit_value_check(const char *asked, const arguments *given, const char *name)
{
    const char *text = arguments_get(given, name);
    return (text && *text == '=') || unit_length_check(asked, given, name);
}

batten_status unit_length_in(const arguments *given, const char *name, double metres,
                             double *out)
{
    const char *text = arguments_get(given, name);
    double value = 0, own = 0;
    if (!text || !read_length(text, &value, &own))
        return BATTEN_OK;
    if (own > 0 && !(metres > 0))
        return batten_fail(BATTEN_BAD_ARGUMENT,
                           "--%s is %s, and the file gives no unit; --from-unit may", name,
                           text);
    *out = own > 0 && own != metres ? value * own / metres : value;
    return BATTEN_OK;
}
