/* Reorders nets of control points that a file lists with u fastest. */
#include "exchange/shapes/net.h"

#include <string.h>

batten_status bat_net_transpose(bat_input *input, size_t count_u, size_t count_v, size_t width,
                                const double *values, double **out)
{
    double *turned = NULL;
    batten_status status =
        bat_input_array(input, count_u * count_v * width, sizeof *turned, &turned);
    if (status != BATTEN_OK)
        return status;
    for (size_t j = 0; j < count_v; j++)
        for (size_t i = 0; i < count_u; i++)
            memcpy(&turned[(i * count_v + j) * width], &values[(j * count_u + i) * width],
                   width * sizeof *turned);
    *out = turned;
    return BATTEN_OK;
}
