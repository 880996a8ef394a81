/*
 * References of entities to others, and matrices.
 *
 * Where an entity refers to geometry is said by a pattern of its parameters from 1 on: 'p' a
 * reference, 'n' a count, '(' ... ')' repeated as often as the last count says, anything else a
 * parameter without meaning here.
 */
#ifndef BAT_IGES_REFERENCES_H
#define BAT_IGES_REFERENCES_H
#include "exchange/iges/read/reading.h"

const bat_iges_entry *bat_iges_entry_at(const bat_iges_reading *reading, size_t place);
size_t bat_iges_place_of(const bat_iges_reading *reading, const bat_iges_entry *entry);
bat_iges_shape *bat_iges_shape_of(const bat_iges_reading *reading, const bat_iges_entry *entry);

/* The entry of an id. BAD_FORMAT, with a message, when there is none or it is damaged. */
batten_status bat_iges_find(const bat_iges_reading *reading, int id,
                            const bat_iges_entry **out);
/* The same, of one type; when it is of another, BAD_FORMAT. */
batten_status bat_iges_find_type(const bat_iges_reading *reading, int id, int type,
                                 const bat_iges_entry **out);

/* Mark all entries that geometric entities refer to. */
batten_status bat_iges_mark_parts(bat_iges_reading *reading);

/* The chain of matrices that begins at `id`: the first is applied first. */
batten_status bat_iges_transform(bat_iges_reading *reading, int id, batten_affine *map);

/* The coordinates of a point 116, a direction 123, moved by its matrices. */
batten_status bat_iges_point(bat_iges_reading *reading, int id, double point[3]);
batten_status bat_iges_direction(bat_iges_reading *reading, int id, double direction[3]);

#endif
