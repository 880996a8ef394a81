/* The bicubic patch through sixteen points. */
#include <batten/standard.h>

#include "base/base.h"
#include "numeric/vector.h"

#include <string.h>

/* Bezier's points of the cubic that passes four points at 0, 1/3, 2/3 and 1, six times. */
static const double through_thirds[4][4] = {
    {6, 0, 0, 0}, {-5, 18, -9, 2}, {2, -9, 18, -5}, {0, 0, 0, 6}};

batten_status batten_surface_sixteen_points(const double *points, batten_surface **out)
{
    assert(points && out);
    static const double unit[2] = {0, 1};
    const size_t bad = bat_first_not_finite(points, 48);
    if (bad < 48)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of point %zu is not finite",
                        bad % 3 + 1, bad / 3 + 1);
    double half[4][4][3] = {{{0}}}, net[4][4][3] = {{{0}}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 4; k++)
                for (int c = 0; c < 3; c++)
                    half[i][j][c] += through_thirds[i][k] * points[(4 * k + j) * 3 + c] / 6;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 4; k++)
                for (int c = 0; c < 3; c++)
                    net[i][j][c] += through_thirds[j][k] * half[i][k][c] / 6;
    return batten_surface_from_bezier(3, (batten_pieces){3, 1, unit},
                                      (batten_pieces){3, 1, unit}, net[0][0], NULL, out);
}
