/* The table of instances as it is made. */
#ifndef BAT_STEP_TABLE_H
#define BAT_STEP_TABLE_H
#include "exchange/step/text/instances.h"

/* Where lines end, for bat_step_line. */
batten_status bat_step_table_lines(bat_step_file *file);
/* Sort the instances; of those with the same id the first stays, the others are noted. */
batten_status bat_step_table_finish(bat_step_file *file);

#endif
