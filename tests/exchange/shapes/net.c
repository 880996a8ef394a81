#include "exchange/shapes/net.h"

#include "exchange/reading.h"

TEST(a_net_with_u_fastest_becomes_one_with_v_fastest)
{
    /* Row by row it says 100 i + 10 j + k, for i in u and j in v. */
    enum { U = 4, V = 3, WIDTH = 2 };
    double values[U * V * WIDTH], *turned = NULL;
    bat_input input;
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, NULL, &input));
    for (int n = 0; n < U * V * WIDTH; n++)
        values[n] = 100 * (n / WIDTH % U) + 10 * (n / WIDTH / U) + n % WIDTH;
    CHECK_OK(bat_net_transpose(&input, U, V, WIDTH, values, &turned));
    for (int i = 0; i < U; i++)
        for (int j = 0; j < V; j++)
            for (int k = 0; k < WIDTH; k++)
                CHECK_BITS(turned[(i * V + j) * WIDTH + k], 100 * i + 10 * j + k);
    CHECK_INT((long long)input.memory, sizeof values);
    batten_release(turned);
}
