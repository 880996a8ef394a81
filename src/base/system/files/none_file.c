/* Paths and files without an operating system: paths are what they are. */
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_NONE
#include "base/base.h"
#include "base/system/files/plain_file.h"

#include <string.h>

char *batten_system_real_path(const char *path, const char **reason)
{
    *reason = NULL;
    const size_t length = strlen(path);
    char *copy = bat_array(length + 1, 1);
    if (copy)
        memcpy(copy, path, length);
    return copy;
}

bool batten_system_is_link(const char *path)
{
    (void)path;
    return false;
}

FILE *bat_plain_open(const char *path, const char *mode)
{
    return fopen(path, mode);
}

bool bat_plain_replace(const char *from, const char *to)
{
    return rename(from, to) == 0;
}

void bat_plain_remove(const char *path)
{
    remove(path);
}

#endif
