/* The faces of a body that is made of 186, 514 and 510. */
#ifndef BAT_IGES_READ_SOLID_H
#define BAT_IGES_READ_SOLID_H
#include "exchange/iges/read/bodies.h"
#include "exchange/iges/read/loops.h"

/* Matrices within a solid would move a part of what is shared. */
batten_status bat_iges_open_part(bat_iges_reading *reading, const bat_iges_entry *entry,
                                 bat_iges_item *item);
/* An open 510: SURF, N, whether the first loop is the outer one, loops. */
batten_status bat_iges_put_face_of(bat_iges_item *item, bool agrees, bat_builder *builder);
/* The face of a shell; one that is bad is taken back with a note, and *whole is false. */
batten_status bat_iges_add_face(bat_iges_reading *reading, int id, bool agrees,
                                bat_builder *builder, bool *whole);

#endif
