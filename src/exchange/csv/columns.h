/* The names that columns of a table may have, with their units: "x", "z_mm", "Half-breadth
 * [m]". */
#ifndef BAT_COLUMNS_H
#define BAT_COLUMNS_H
#include "exchange/csv/separated.h"

typedef enum {
    BAT_COLUMN_OTHER,
    BAT_COLUMN_X,       /* along the ship; of a point */
    BAT_COLUMN_Y,       /* half-breadth */
    BAT_COLUMN_Z,       /* height */
    BAT_COLUMN_STATION, /* x of the station, where a point may have its own */
    BAT_COLUMN_LINE,    /* name of the line */
    BAT_COLUMN_SECTION  /* name of the station */
} bat_column_kind;

typedef struct {
    bat_column_kind kind;
    bool is_letter;     /* plain x, y or z: also of a table of points */
    bool is_of_hull;    /* no surveyor would call a column so */
    double unit_metres; /* 0 when not said */
} bat_column;

bat_column bat_column_of(const char *text);

/* The unit of the coordinates among `columns`: 0 when none says one. Two different ones are
 * refused; one that is said for some holds for all, with a note. The current row is the header.
 */
batten_status bat_columns_unit(const bat_separated *table, const bat_column *columns, int count,
                               double *unit_metres);

#endif
