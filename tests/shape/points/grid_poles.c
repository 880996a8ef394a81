/* Rims of grids that are single points. */
#include "shape/points/grid_poles.h"
#include "support/test.h"

/* The rim of a net of 4 x 5 points that a node stands on: 0 and 1 for the start and the end of
 * direction 0, 2 and 3 of direction 1. */
static bool is_on_rim(int rim, int count_u, int count_v, int i, int j)
{
    return rim == 0   ? i == 0
           : rim == 1 ? i == count_u - 1
           : rim == 2 ? j == 0
                      : j == count_v - 1;
}

TEST(a_rim_of_data_that_is_one_point_makes_the_rim_of_the_net_that_point_and_nothing_else)
{
    const int data_count[2] = {3, 4}, control_count[2] = {4, 5};
    for (int rim = 0; rim < 4; rim++)
        for (int odd = -1; odd < 4; odd++) { /* which point of the rim differs, if any */
            double data[3 * 4 * 2], control[4 * 5 * 2], expected[4 * 5 * 2];
            int on = 0;
            for (int n = 0; n < 12; n++) {
                const bool pole = is_on_rim(rim, 3, 4, n / 4, n % 4);
                data[2 * n] = pole ? 8 : n;
                data[2 * n + 1] = pole ? 9 + (on == odd) : n;
                on += pole;
            }
            for (int n = 0; n < 20; n++)
                for (int k = 0; k < 2; k++) {
                    control[2 * n + k] = 100 + 2 * n + k;
                    const bool pole = is_on_rim(rim, 4, 5, n / 5, n % 5);
                    expected[2 * n + k] = pole && odd < 0 ? 8 + k : control[2 * n + k];
                }
            if (odd >= on)
                continue;
            bat_keep_pole((batten_grid){2, data_count[0], data_count[1], data}, control_count,
                          control, rim / 2, rim % 2 == 0);
            CHECK(!memcmp(control, expected, sizeof control));
        }
}
