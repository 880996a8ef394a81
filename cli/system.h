/* What the command asks of the operating system; libbatten has src/base/system for its own questions. */
#ifndef SYSTEM_H
#define SYSTEM_H
#include <stdbool.h>
#include <stdio.h>

/* From now on a request to end is noted, and the first one ends the process after three seconds at most, the second
 * at once. A closed pipe is a failed write. */
void system_catch_signals(void);
/* The signal that came, or 0. */
int system_signal(void);

bool system_is_terminal(FILE *stream);
bool system_exists(const char *path);
/* Is `path` an ordinary file, and the same as `other`, or as what the standard input reads where `other` is NULL? */
bool system_is_same_file(const char *path, const char *other);
/* 0 when the folder is there afterwards, else an errno. */
int system_make_folder(const char *path);

#endif
