/* The defaults of meshing, and what may be asked instead. */
#include "mesh/options.h"

batten_mesh_options batten_mesh_defaults(void)
{
    return (batten_mesh_options){.size = sizeof(batten_mesh_options),
                                 .chord = 0,
                                 .angle = 0.35,
                                 .longest = 0,
                                 .most = 10000000};
}

batten_status bat_mesh_check_options(const batten_mesh_options *options)
{
    if (!(options->chord >= 0 && isfinite(options->chord)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the chord is %g; it must not be below 0",
                        options->chord);
    if (!(options->angle > 0 && isfinite(options->angle)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle is %g; it must be above 0",
                        options->angle);
    if (!(options->longest >= 0 && isfinite(options->longest)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the longest edge is %g; it must not be below 0",
                        options->longest);
    if (options->most < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d triangles are allowed", options->most);
    return BATTEN_OK;
}
