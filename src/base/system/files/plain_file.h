/* What plain_file.c asks of a system that is not POSIX; paths are UTF-8. Each sets errno when it fails. */
#ifndef BAT_PLAIN_FILE_H
#define BAT_PLAIN_FILE_H
#include <stdbool.h>
#include <stdio.h>

FILE *bat_plain_open(const char *path, const char *mode);
/* Rename, over a file that exists. */
bool bat_plain_replace(const char *from, const char *to);
void bat_plain_remove(const char *path);

#endif
