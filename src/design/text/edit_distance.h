/* How many letters two words differ in. */
#ifndef BAT_DESIGN_EDIT_DISTANCE_H
#define BAT_DESIGN_EDIT_DISTANCE_H

/* How many letters must be changed, added, dropped or swapped to make one word the other;
 * `limit` when it is not less. */
int bat_edit_distance(const char *a, const char *b, int limit);

#endif
