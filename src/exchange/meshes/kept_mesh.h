/* What a format keeps of a mesh. */
#ifndef BAT_KEPT_MESH_H
#define BAT_KEPT_MESH_H
#include "exchange/formats.h"

/* The mesh without the colours and values that the format does not have, with a note for each;
 * the mesh itself when it loses nothing. */
batten_status bat_mesh_kept(const bat_format_row *row, const batten_object *object,
                            batten_notes *notes, batten_mesh **out);

#endif
