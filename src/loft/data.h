/* The points of a lofting: their rows, their feet on the patch, and how far it moved from them. */
#ifndef BAT_LOFT_DATA_H
#define BAT_LOFT_DATA_H
#include "loft/program.h"

typedef struct {
    double point[3], within;
    bool in_station; /* the distance counts in the plane x = const; else from the patch */
    bool on_u_edge, on_v_edge; /* it belongs to an edge u = const, v = const */
    bool is_fixed;      /* it belongs to the place (u, v) of the patch, which does not slide */
    double u, v;        /* its foot on the patch */
    double move;        /* from the point to its foot */
    int station, index; /* its place in the table */
} bat_loft_datum;

typedef struct {
    double largest, rms, largest_part; /* of a move against its bound */
} bat_loft_moves;

/* The patch keeps the point within its bound, by the tangent plane at the foot, and changes
 * little. */
batten_status bat_loft_add_datum(bat_loft_program *program, const bat_loft_datum *datum);
/* Only the square of the distance: for a first fit. */
void bat_loft_attract_datum(bat_loft_program *program, const bat_loft_datum *datum);

void bat_loft_find_feet(const bat_loft_patch *patch, int count, bat_loft_datum *data,
                        bat_loft_moves *out);

#endif
