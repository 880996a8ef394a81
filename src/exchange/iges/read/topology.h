/* 502 and 504: lists of vertices and edges, and what they are in the body that is being made.
 */
#ifndef BAT_IGES_TOPOLOGY_H
#define BAT_IGES_TOPOLOGY_H
#include "body/builder.h"
#include "exchange/iges/read/bodies.h"

/* Begin another body: vertices and edges met from now on are put into its builder. */
void bat_iges_next_body(bat_iges_reading *reading);
/* The index in the builder of edge `number`, from 1, of the list `id`; it is added when it is
 * met for the first time. */
batten_status bat_iges_body_edge(bat_iges_reading *reading, bat_builder *builder, int id,
                                 int number, int *index);

#endif
