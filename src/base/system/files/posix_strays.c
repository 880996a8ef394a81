/* Temporary files that killed processes left behind: finding and removing them. POSIX systems. */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE /* flock */
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_POSIX
#include "base/system/files/posix_strays.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

bool bat_hold_temporary(int file)
{
    struct stat about;
    if (flock(file, LOCK_EX | LOCK_NB) < 0 && errno == EWOULDBLOCK)
        return false;
    return fstat(file, &about) < 0 || about.st_nlink > 0;
}

/* A file of ours that nobody holds is left over. */
static void remove_stray(const char *path)
{
    struct stat about;
    const int file = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return;
    if (fstat(file, &about) == 0 && S_ISREG(about.st_mode) && about.st_uid == geteuid() &&
        flock(file, LOCK_EX | LOCK_NB) == 0)
        unlink(path);
    close(file);
}

void bat_remove_strays(const char *folder, char *temporary, char *suffix)
{
    enum { LETTERS = 6 };
    static const char letters[] = "0123456789abcdefghijklmnopqrstuvwxyz";
    const char *slash = strrchr(temporary, '/');
    const char *name = slash ? slash + 1 : temporary;
    const size_t before = (size_t)(suffix - name), length = strlen(name);
    DIR *directory = opendir(folder);
    const struct dirent *entry;
    while (directory && (entry = readdir(directory))) {
        const char *found = entry->d_name;
        if (strlen(found) != length || memcmp(found, name, before) != 0 ||
            strspn(found + before, letters) != LETTERS ||
            strcmp(found + before + LETTERS, suffix + LETTERS) != 0)
            continue;
        memcpy(suffix, found + before, LETTERS);
        remove_stray(temporary);
    }
    if (directory)
        closedir(directory);
}

#endif
