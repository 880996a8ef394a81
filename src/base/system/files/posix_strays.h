/* Temporary files of saves whose process was killed. */
#ifndef BAT_STRAYS_H
#define BAT_STRAYS_H
#include <stdbool.h>

/* Hold a temporary file, so that no other saving takes it for a stray; false when one did
 * before. It is held until it is closed. */
bool bat_hold_temporary(int file);
/* Remove from the folder the files of a name as long as that of `temporary`, a path whose name
 * has six letters or digits of any kind at `suffix`, unless somebody holds them. The letters
 * there are then others. */
void bat_remove_strays(const char *folder, char *temporary, char *suffix);

#endif
