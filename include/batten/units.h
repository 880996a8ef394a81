#ifndef BATTEN_UNITS_H
#define BATTEN_UNITS_H
/**
 * @file
 * Units of length by name.
 */
#include <batten/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @param name "m", "mm", "cm", "km", "um", "in", "ft", "yd", "mil", "mi", "uin", "dm", "dam",
 * "hm", "nm", "angstrom" and their long names in lower case, singular or plural: "metre",
 * "meters", "foot", "feet"; "usft", the US survey foot
 * @return metres in one of them, or 0 when the name is unknown */
BATTEN_API double batten_unit_metres(const char *name);

/** The short name of a unit, to 4 units of the last place, or NULL when there is none. */
BATTEN_API const char *batten_unit_name(double metres);

#ifdef __cplusplus
}
#endif
#endif
