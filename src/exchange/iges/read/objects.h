/* Entities as objects of a model. */
#ifndef BAT_IGES_OBJECTS_H
#define BAT_IGES_OBJECTS_H
#include "exchange/iges/read/reading.h"

/* Add what an entry stands for to a model. One that cannot be read is left out with a note;
 * what is returned is not its fault. */
batten_status bat_iges_add(bat_iges_reading *reading, const bat_iges_entry *entry,
                           batten_model *model);
/* Add all that stand for themselves. */
batten_status bat_iges_add_roots(bat_iges_reading *reading);
/* Say once what was odd in many places. */
void bat_iges_note_oddities(const bat_iges_reading *reading);

#endif
