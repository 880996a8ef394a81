/* Real paths on POSIX systems. */
#define _XOPEN_SOURCE 700
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_POSIX
#include "base/base.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

char *batten_system_real_path(const char *path, const char **reason)
{
    *reason = NULL;
    char *real = bat_array(PATH_MAX, 1);
    if (!real || realpath(path, real))
        return real;
    *reason = errno == ENOENT ? "there is no such file" : strerror(errno);
    bat_release(real);
    return NULL;
}

bool batten_system_is_link(const char *path)
{
    struct stat found;
    return lstat(path, &found) == 0 && S_ISLNK(found.st_mode);
}

#endif
