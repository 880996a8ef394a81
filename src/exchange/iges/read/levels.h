/* Levels of entities as layers. */
#ifndef BAT_IGES_LEVELS_H
#define BAT_IGES_LEVELS_H
#include "exchange/iges/read/reading.h"

void bat_iges_start_levels(bat_iges_reading *reading);
/* Find out which levels have names: by properties 406 form 3. */
batten_status bat_iges_read_levels(bat_iges_reading *reading);
void bat_iges_end_levels(bat_iges_reading *reading);
/* The name of its level, or the number, into memory that is yours; "" for level 0; of minus the
 * id of a property with several levels the first of them. */
batten_status bat_iges_layer(bat_iges_reading *reading, const bat_iges_entry *entry,
                             char **layer);

#endif
