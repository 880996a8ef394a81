/* Trimmed surfaces, faces, shells and solids: each reads an open item into item->body. */
#ifndef BAT_IGES_BODIES_H
#define BAT_IGES_BODIES_H
#include "exchange/iges/read/reading.h"

batten_status bat_iges_read_plane(bat_iges_item *item);   /* 108, bounded */
batten_status bat_iges_read_bounded(bat_iges_item *item); /* 143 */
batten_status bat_iges_read_trimmed(bat_iges_item *item); /* 144 */
batten_status bat_iges_read_solid(bat_iges_item *item);   /* 186 */
batten_status bat_iges_read_face(bat_iges_item *item);    /* 510 */
batten_status bat_iges_read_shell(bat_iges_item *item);   /* 514 */

/* The lists of vertices and edges that were met. */
void bat_iges_start_tables(bat_iges_reading *reading);
void bat_iges_end_tables(bat_iges_reading *reading);

#endif
