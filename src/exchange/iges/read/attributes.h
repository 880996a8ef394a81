/* Names, colours and groups of entities. */
#ifndef BAT_IGES_ATTRIBUTES_H
#define BAT_IGES_ATTRIBUTES_H
#include "exchange/iges/read/reading.h"
#include <batten/model.h>

/* The name of an item from its properties, its label, or its number: yours to release. */
batten_status bat_iges_name(bat_iges_item *item, char **name);
/* The same from its properties or its label alone; *name stays NULL when it has none. */
batten_status bat_iges_given_name(bat_iges_item *item, char **name);
/* 0 is none; 1..8 are named; minus the id of a 314 gives percents. A bad one is none, and
 * counted as wrong. */
batten_status bat_iges_colour(bat_iges_reading *reading, const bat_iges_entry *entry, bool *has,
                              double rgb[3]);

/* Call the model by the string at `index`, if there is one. */
batten_status bat_iges_call(bat_input *input, const bat_iges_parameters *parameters,
                            size_t index, batten_model *model);

void bat_iges_start_groups(bat_iges_reading *reading);
/* Find out which entries belong to which groups. */
batten_status bat_iges_read_groups(bat_iges_reading *reading);
void bat_iges_end_groups(bat_iges_reading *reading);
/* "outer/inner" into memory that is yours; "" for none. */
batten_status bat_iges_group(bat_iges_reading *reading, const bat_iges_entry *entry,
                             char **group);

#endif
