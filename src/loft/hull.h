/* The lofting of a hull from its table of offsets. */
#ifndef BAT_LOFT_HULL_H
#define BAT_LOFT_HULL_H
#include "loft/rounds.h"
#include <batten/hull.h>

/* A station from the profile to the sheer. */
typedef struct {
    double x;
    int count;
    batten_table_point *points;
    double *v;    /* girth in parts of the whole */
    int *from;    /* [count]: which point of the table */
    bool is_stem; /* all points lie on the centre plane */
} bat_hull_station;

/* The patch, its points, and the cuts by which it is judged; `smooth` is left at 0. */
batten_status bat_hull_make(const batten_offset_table *table, double within, bat_loft *out);
void bat_hull_release(bat_loft *loft);

/* The cuts of a hull, in hull_cuts.c: its stations and waterlines and those halfway between,
 * buttocks, two families of diagonals, profile and sheer. */
batten_status bat_hull_cuts(const batten_offset_table *table, int count,
                            const bat_hull_station *stations, bat_loft *loft);

#endif
