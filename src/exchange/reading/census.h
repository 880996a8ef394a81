/* What a reader met: how many entities of each kind it read, and how many it left out. */
#ifndef BAT_CENSUS_H
#define BAT_CENSUS_H
#include "exchange/reading/input.h"

typedef struct {
    bat_list rows; /* names with counts, by name */
} bat_census;

void bat_census_begin(bat_census *census);
void bat_census_end(bat_census *census);
/* The name is copied, at most 79 bytes of it; after 1,000 names the rest are counted as one. */
batten_status bat_census_read(bat_input *input, bat_census *census, const char *name);
batten_status bat_census_leave(bat_input *input, bat_census *census, const char *name);
/* A remark for each name that was read, and a note for each with what was left out: "12 read, 3
 * left out". */
void bat_census_note(const bat_input *input, const bat_census *census);

#endif
