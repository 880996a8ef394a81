/* The defaults of meshing. */
#include <batten/mesh.h>

batten_mesh_options batten_mesh_defaults(void)
{
    return (batten_mesh_options){.size = sizeof(batten_mesh_options),
                                 .chord = 0,
                                 .angle = 0.35,
                                 .longest = 0,
                                 .most = 10000000};
}
