/* The geometry of an IGES file: one entry of its directory after another. */
#ifndef BAT_IGES_ENTITIES_H
#define BAT_IGES_ENTITIES_H
#include "exchange/iges/records.h"

typedef struct {
    bat_iges_file file;
    bat_input *input;
    double unit_metres;
    bat_list left_out;   /* of bat_iges_count: what is not read, by type and form */
    int dependent_count; /* parts of other entities */
    batten_model *model;
} bat_iges_reading;

typedef struct {
    int type, form, count;
} bat_iges_count;

/* What to call a type: "rational B-spline curve"; "entity" when unknown. */
const char *bat_iges_type_name(int type);

/* Read the entry into the model when it stands for itself. An entry that cannot be read is left
 * out with a note; what is returned is not its fault. */
batten_status bat_iges_read_entry(bat_iges_reading *reading, size_t place);

#endif
