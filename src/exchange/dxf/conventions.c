/* What reading and writing share: units, and the axes of planes. */
#include "exchange/dxf/dxf.h"
#include "numeric/vector.h"

static const struct {
    double metres;
    int code;
} units[] = {/* inch, foot, mile */
             {0.0254, 1},
             {0.3048, 2},
             {1609.344, 3},
             /* mm, cm, m, km */
             {0.001, 4},
             {0.01, 5},
             {1, 6},
             {1000, 7},
             /* microinch, thousandth of an inch, yard */
             {2.54e-8, 8},
             {2.54e-5, 9},
             {0.9144, 10},
             /* angstrom, nanometre, micrometre, dm, dam, hm, Gm */
             {1e-10, 11},
             {1e-9, 12},
             {1e-6, 13},
             {0.1, 14},
             {10, 15},
             {100, 16},
             /* gigametre */
             {1e9, 17},
             /* astronomical unit, light year, parsec */
             {149597870700, 18},
             {9460730472580800, 19},
             {3.0856775814913673e16, 20},
             /* foot, inch, yard and mile of surveyors in the United States */
             {1200.0 / 3937, 21},
             {100.0 / 3937, 22},
             {3600.0 / 3937, 23},
             {6336000.0 / 3937, 24}};
#define UNITS (sizeof units / sizeof units[0])

double bat_dxf_unit_of(int code)
{
    for (size_t k = 0; k < UNITS; k++)
        if (units[k].code == code)
            return units[k].metres;
    return 0;
}

int bat_dxf_code_of(double metres)
{
    for (size_t k = 0; k < UNITS; k++)
        if (fabs(metres - units[k].metres) <= BAT_WRITTEN * units[k].metres)
            return units[k].code;
    return 0;
}

batten_frame bat_dxf_axes(batten_vec3 normal)
{
    /* "Near the world's z" is the format's own rule, and its number. */
    const bool near_z = fabs(normal.x) < 1.0 / 64 && fabs(normal.y) < 1.0 / 64;
    const batten_vec3 x =
        bat_vec3_cross(near_z ? (batten_vec3){0, 1, 0} : (batten_vec3){0, 0, 1}, normal);
    return (batten_frame){
        .origin = {0, 0, 0}, .x = bat_vec3_scale(x, 1 / bat_vec3_norm(x)), .z = normal};
}
