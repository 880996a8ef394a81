/* The patch of what is known at its corners alone: all lines of the formula are made of these.
 */
#include "shape/boundary/coons_formula.h"

#include <string.h>

batten_status batten_surface_corner_patch(int dimension, const double *corners,
                                          batten_blending family, batten_surface **out)
{
    assert(corners && out);
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    const size_t count = 16 * (size_t)dimension;
    if (bat_first_not_finite(corners, count) < count)
        return bat_fail(BATTEN_NOT_FINITE, "number %zu of the corners is not finite",
                        bat_first_not_finite(corners, count) + 1);
    bat_coons coons;
    batten_status status = bat_coons_begin(dimension, 4, 4, &coons);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = batten_blending_functions(family, 2, coons.blend[k]);
    /* All lines are made of their corners: + C. */
    for (int i = 0; status == BATTEN_OK && i < 4; i++)
        for (int j = 0; j < 4; j++)
            memcpy(coons.corner + (i * 4 + j) * dimension,
                   corners + (((i % 2) * 2 + j % 2) * 4 + (i / 2) + 2 * (j / 2)) * dimension,
                   (size_t)dimension * sizeof *corners);
    double moved;
    if (status == BATTEN_OK)
        status = bat_coons_to_spline(&coons, 0, &moved, out);
    bat_coons_clear(&coons);
    return status;
}
