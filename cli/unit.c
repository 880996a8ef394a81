#include "unit.h"

#include <batten/units.h>
#include <stdio.h>

void unit_words(double metres, char out[UNIT_SIZE])
{
    const char *name = batten_unit_name(metres);
    out[0] = '\0';
    if (name)
        snprintf(out, UNIT_SIZE, "%s", name);
    else if (metres > 0)
        snprintf(out, UNIT_SIZE, "%.12g m", metres);
}
