/* What a table of offsets is made of. */
#ifndef BAT_OFFSET_TABLE_H
#define BAT_OFFSET_TABLE_H
#include "base/base.h"
#include <batten/hull.h>

struct batten_offset_table {
    bat_references references;
    double unit_metres;
    int line_count, station_count;
    batten_table_line *lines;
    batten_table_station *stations;
    batten_table_point *points; /* of all stations, one after another */
    char *names;
};

/* How many points all stations have together. */
size_t bat_offset_table_points(const batten_offset_table *offsets);

/* The line of this name. NOT_FOUND: the message has the names that there are. */
batten_status bat_offset_table_find_line(const batten_offset_table *offsets, const char *name,
                                         int *out);

#endif
