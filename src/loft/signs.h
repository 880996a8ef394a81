/* Rows that forbid cuts the wrong sign of curvature. */
#ifndef BAT_LOFT_SIGNS_H
#define BAT_LOFT_SIGNS_H
#include "loft/cut.h"
#include "loft/program.h"

/* Rows for one cut along its trace, elastic at `price`. */
batten_status bat_loft_add_signs(bat_loft_program *program, const bat_loft_cut *cut,
                                 const bat_cut_trace *trace, double price);

#endif
