/* Where an INSERT puts its block, once or in an array. */
#ifndef BAT_DXF_INSERT_H
#define BAT_DXF_INSERT_H
#include "exchange/dxf/survey.h"
#include <batten/geometry.h>

/* The first one, and the ways from one to the next of its row and of its column. */
typedef struct {
    batten_affine first;
    int columns, rows;
    batten_vec3 along, up;
} bat_dxf_places;

/* A message for a note on failure. What stands 0 apart stands there once, with a note. */
batten_status bat_dxf_read_places(const bat_dxf_pairs *pairs, const bat_dxf_block *block,
                                  bat_dxf_places *places);
batten_affine bat_dxf_place_at(const bat_dxf_places *places, int column, int row);

#endif
