/*
 * Units of length: the metres of a unit by any of its names, and the short name of a unit by
 * its metres.
 */
#include <batten/text.h>

#include <float.h>
#include <math.h>
#include <string.h>

/* The first name of each unit is the short one. The inch is 25.4 mm since 1959. */
static const struct {
    double metres;
    const char *names[6];
} units[] = {
    {1, {"m", "metre", "metres", "meter", "meters"}},
    {1e-3, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
    {1e-2, {"cm", "centimetre", "centimetres", "centimeter", "centimeters"}},
    {1e3, {"km", "kilometre", "kilometres", "kilometer", "kilometers"}},
    {1e-6, {"um", "micrometre", "micrometres", "micrometer", "micrometers", "micron"}},
    {0.0254, {"in", "inch", "inches"}},
    {0.3048, {"ft", "foot", "feet"}},
    {2.54e-5, {"mil", "mils"}},
    {1609.344, {"mi", "mile", "miles"}},
    {2.54e-8, {"uin", "microinch", "microinches"}},
    {0.9144, {"yd", "yard", "yards"}},
    {0.1, {"dm", "decimetre", "decimetres", "decimeter", "decimeters"}},
    {10, {"dam", "decametre", "decametres", "decameter", "decameters"}},
    {100, {"hm", "hectometre", "hectometres", "hectometer", "hectometers"}},
    {1e-9, {"nm", "nanometre", "nanometres", "nanometer", "nanometers"}},
    {1e-10, {"angstrom", "angstroms"}},
    {1200.0 / 3937, {"usft"}}, /* the foot of surveyors in the United States */
};
#define UNIT_COUNT (sizeof units / sizeof units[0])

double batten_unit_metres(const char *name)
{
    for (size_t i = 0; i < UNIT_COUNT; i++)
        for (size_t k = 0; k < 6 && units[i].names[k]; k++)
            if (strcmp(units[i].names[k], name) == 0)
                return units[i].metres;
    return 0;
}

const char *batten_unit_name(double metres)
{
    for (size_t i = 0; i < UNIT_COUNT; i++)
        if (fabs(metres - units[i].metres) <= 4 * DBL_EPSILON * units[i].metres)
            return units[i].names[0];
    return NULL;
}
