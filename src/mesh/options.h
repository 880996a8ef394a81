/* What may be asked of a mesh. */
#ifndef BATTEN_MESH_OPTIONS_H
#define BATTEN_MESH_OPTIONS_H
#include "base/base.h"

#include <batten/mesh.h>

/* BAD_ARGUMENT names the option and its value. */
batten_status bat_mesh_check_options(const batten_mesh_options *options);

#endif
