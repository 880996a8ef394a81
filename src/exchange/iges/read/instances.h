/* Subfigures and their instances. */
#ifndef BAT_IGES_INSTANCES_H
#define BAT_IGES_INSTANCES_H
#include "exchange/iges/read/reading.h"

batten_status bat_iges_read_definition(bat_iges_item *item); /* 308 */
batten_status bat_iges_read_instance(bat_iges_item *item);   /* 408 */

#endif
