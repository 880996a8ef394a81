/* Loading a file whole, and saving one so that it is complete or as it was, on POSIX systems. */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE /* madvise */
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_POSIX
#include "base/base.h"
#include "base/system/files/posix_file.h"
#include "base/system/files/posix_strays.h"

#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

/* ---- saving ---- */

typedef struct {
    const char *path;   /* as the caller named it */
    char *target;       /* what it stands for, links followed */
    char *temporary;    /* beside the target */
    char *folder;       /* of both */
    struct stat before; /* of the target, where it exists */
    bool existed;
    sigset_t held; /* signals that wait until the temporary file is gone */
} saving;

static char *copy_text(const char *text, size_t length)
{
    char *copy = bat_array(length + 1, 1);
    if (copy)
        memcpy(copy, text, length);
    return copy;
}

/* Where the name begins: behind the last slash. */
static const char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* The path that a link at `path` leads to. */
static char *joined(const char *path, const char *link, size_t length)
{
    const size_t folder = length > 0 && link[0] == '/' ? 0 : (size_t)(name_of(path) - path);
    char *whole = bat_array(folder + length + 1, 1);
    if (whole) {
        memcpy(whole, path, folder);
        memcpy(whole + folder, link, length);
    }
    return whole;
}

/* Follow links at the end of the path, existing or not, as far as the system itself would. */
static batten_status resolve(saving *save)
{
    enum { MOST_LINKS = 40, LONGEST = 4096 };
    char *link = bat_array(LONGEST, 1);
    batten_status status = link ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int count = 0; status == BATTEN_OK; count++) {
        const ssize_t length = bat_system.readlink(save->target, link, LONGEST);
        if (length < 0 && (errno == EINVAL || errno == ENOENT))
            break;
        if (length < 0 || length == LONGEST || count == MOST_LINKS) {
            status = bat_file_refused("save", save->path, length < 0 ? errno : ELOOP);
            break;
        }
        char *next = joined(save->target, link, (size_t)length);
        bat_release(save->target);
        save->target = next;
        status = next ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    bat_release(link);
    return status;
}

/* Look at what is there now. */
static batten_status look_at_target(const saving *save, struct stat *about, bool *exists)
{
    *exists = bat_system.stat(save->target, about) == 0;
    if (!*exists && errno != ENOENT)
        return bat_file_refused("save", save->path, errno);
    return BATTEN_OK;
}

static const int ending_signals[] = {SIGINT, SIGTERM, SIGHUP};
enum { ENDING_COUNT = sizeof ending_signals / sizeof ending_signals[0] };

/* Has a signal come that would have ended the programme? */
static bool is_asked_to_end(const saving *save)
{
    sigset_t pending;
    sigpending(&pending);
    for (int i = 0; i < ENDING_COUNT; i++)
        if (sigismember(&pending, ending_signals[i]) == 1 &&
            sigismember(&save->held, ending_signals[i]) == 1)
            return true;
    return false;
}

static batten_status cancelled(const saving *save)
{
    char shown[BAT_SHOWN_SIZE];
    return bat_fail(BATTEN_CANCELLED, "a signal ended saving '%s', which is as it was",
                    bat_shown(save->path, strlen(save->path), shown));
}

static batten_status write_all(int file, const saving *save, const char *data, size_t size)
{
    const size_t most = (size_t)1 << 20; /* between questions */
    while (size > 0) {
        if (is_asked_to_end(save))
            return cancelled(save);
        const ssize_t written = bat_system.write(file, data, size < most ? size : most);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return bat_file_refused("write", save->path, written < 0 ? errno : ENOSPC);
        data += written;
        size -= (size_t)written;
    }
    return BATTEN_OK;
}

static batten_status synchronise(int file, const char *path)
{
    int result;
    do
        result = bat_system.fsync(file);
    while (result < 0 && errno == EINTR);
    return result < 0 ? bat_file_refused("save", path, errno) : BATTEN_OK;
}

/* After EINTR the file is closed, and what was synchronised is safe. */
static batten_status close_file(int file, const char *path)
{
    if (bat_system.close(file) < 0 && errno != EINTR)
        return bat_file_refused("save", path, errno);
    return BATTEN_OK;
}

/* A device or a pipe cannot be replaced. */
static batten_status write_straight(const saving *save, const char *data, size_t size)
{
    /* Without waiting for a reader of the pipe, but then at the pace of the one there is. */
    const int file = bat_system.open(save->target, O_WRONLY | O_NONBLOCK | O_NOCTTY, 0);
    if (file < 0)
        return bat_file_refused("write", save->path, errno);
    batten_status status = bat_file_wait_for_writer(file, save->path);
    if (status == BATTEN_OK)
        status = write_all(file, save, data, size);
    const batten_status closed = close_file(file, save->path);
    return status == BATTEN_OK ? closed : status;
}

/* Six letters and digits that another saving is unlikely to choose. */
static void choose_suffix(uint64_t seed, char *suffix)
{
    static const char letters[] = "0123456789abcdefghijklmnopqrstuvwxyz";
    seed = (seed ^ seed >> 31) * 0x7fb5d329728ea185u;
    seed = (seed ^ seed >> 27) * 0x81dadef4bc2dd44du;
    for (int i = 0; i < 6; i++, seed /= 36)
        suffix[i] = letters[seed % 36];
}

/* `.name.XXXXXX.batten-tmp` beside the target; of a long name only what a file system takes. */
static batten_status name_temporary(saving *save)
{
    enum { LONGEST_NAME = 255, ADDED = 1 + 7 + 11 };
    const char *name = name_of(save->target);
    const size_t length = strlen(name), folder = (size_t)(name - save->target);
    const int kept = (int)(length < LONGEST_NAME - ADDED ? length : LONGEST_NAME - ADDED);
    save->folder = folder > 0 ? copy_text(save->target, folder) : copy_text(".", 1);
    save->temporary = bat_array(folder + (size_t)kept + ADDED + 1, 1);
    if (!save->folder || !save->temporary)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(save->temporary, save->target, folder);
    snprintf(save->temporary + folder, (size_t)kept + ADDED + 1, ".%.*s.XXXXXX.batten-tmp",
             kept, name);
    return BATTEN_OK;
}

static batten_status open_temporary(saving *save, int *file)
{
    enum { TRIALS = 100 };
    char *suffix = save->temporary + strlen(save->temporary) - strlen("XXXXXX.batten-tmp");
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    const uint64_t seed =
        (uint64_t)now.tv_nsec ^ (uint64_t)getpid() << 32 ^ (uint64_t)(uintptr_t)save;
    const mode_t mode = save->existed ? 0600 : 0666;
    *file = -1;
    bat_remove_strays(save->folder, save->temporary, suffix);
    for (uint64_t trial = 0; *file < 0 && trial < TRIALS; trial++) {
        choose_suffix(seed + trial, suffix);
        *file = bat_system.open(save->temporary, O_WRONLY | O_CREAT | O_EXCL, mode);
        if (*file < 0 && errno != EEXIST)
            break;
        if (*file >= 0 && !bat_hold_temporary(*file)) {
            close(*file);
            *file = -1;
            errno = EEXIST;
        }
    }
    return *file < 0 ? bat_file_refused("save", save->path, errno) : BATTEN_OK;
}

/* Is what lies at the target what lay there at the beginning? */
static batten_status check_unchanged(const saving *save)
{
    struct stat now;
    bool exists;
    const batten_status status = look_at_target(save, &now, &exists);
    if (status != BATTEN_OK)
        return status;
    const struct stat *before = &save->before;
    const bool same =
        exists == save->existed &&
        (!exists ||
         (now.st_dev == before->st_dev && now.st_ino == before->st_ino &&
          now.st_size == before->st_size && now.st_mtim.tv_sec == before->st_mtim.tv_sec &&
          now.st_mtim.tv_nsec == before->st_mtim.tv_nsec));
    char shown[BAT_SHOWN_SIZE];
    return same ? BATTEN_OK
                : bat_fail(BATTEN_FILE_ERROR, "'%s' was changed by another programme meanwhile",
                           bat_shown(save->path, strlen(save->path), shown));
}

static batten_status fill_temporary(const saving *save, int file, const char *data, size_t size)
{
    batten_status status = BATTEN_OK;
    if (save->existed && bat_system.fchmod(file, save->before.st_mode & 07777) < 0)
        status = bat_file_refused("save", save->path, errno);
    if (status == BATTEN_OK)
        status = write_all(file, save, data, size);
    if (status == BATTEN_OK)
        status = synchronise(file, save->path);
    const batten_status closed = close_file(file, save->path);
    return status == BATTEN_OK ? closed : status;
}

/* Without this the renaming may be lost when the power fails, the file itself is whole. */
static batten_status synchronise_folder(const saving *save)
{
    const int folder = bat_system.open(save->folder, O_RDONLY | O_DIRECTORY, 0);
    batten_status status = BATTEN_OK;
    if (folder < 0)
        status = bat_file_refused("open", save->folder, errno);
    if (status == BATTEN_OK) {
        status = synchronise(folder, save->folder);
        const batten_status closed = close_file(folder, save->folder);
        status = status == BATTEN_OK ? closed : status;
    }
    char shown[BAT_SHOWN_SIZE];
    if (status != BATTEN_OK)
        bat_fail(status, "'%.400s' was saved, but may not survive a power loss: %s",
                 bat_shown(save->path, strlen(save->path), shown), batten_message());
    return status;
}

static batten_status replace(saving *save, const char *data, size_t size)
{
    int file = -1;
    batten_status status = open_temporary(save, &file);
    if (status != BATTEN_OK)
        return status;
    status = fill_temporary(save, file, data, size);
    if (status == BATTEN_OK)
        status = check_unchanged(save);
    if (status == BATTEN_OK && is_asked_to_end(save))
        status = cancelled(save);
    if (status == BATTEN_OK && bat_system.rename(save->temporary, save->target) < 0)
        status = bat_file_refused("save", save->path, errno);
    if (status != BATTEN_OK) {
        bat_system.unlink(save->temporary);
        return status;
    }
    return synchronise_folder(save);
}

/* Hold back the signals that would leave the temporary file behind, unless the caller does
 * already. */
static batten_status replace_undisturbed(saving *save, const char *data, size_t size)
{
    batten_status status = resolve(save);
    if (status == BATTEN_OK)
        status = name_temporary(save);
    if (status != BATTEN_OK)
        return status;
    if (save->existed && access(save->target, W_OK) < 0)
        return bat_file_refused("save", save->path, errno);
    sigset_t before;
    pthread_sigmask(SIG_BLOCK, NULL, &before);
    for (int i = 0; i < ENDING_COUNT; i++)
        if (sigismember(&before, ending_signals[i]) == 0)
            sigaddset(&save->held, ending_signals[i]);
    pthread_sigmask(SIG_BLOCK, &save->held, NULL);
    status = replace(save, data, size);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return status;
}

batten_status batten_save_file(const char *path, const char *data, size_t size)
{
    saving save = {.path = path};
    sigemptyset(&save.held);
    save.target = copy_text(path, strlen(path));
    batten_status status = save.target ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = look_at_target(&save, &save.before, &save.existed);
    const mode_t mode = save.existed ? save.before.st_mode : S_IFREG;
    if (status == BATTEN_OK && !*name_of(path))
        status = bat_file_refused("save", path, *path ? EISDIR : ENOENT);
    else if (status == BATTEN_OK && S_ISDIR(mode))
        status = bat_file_refused("save", path, EISDIR);
    else if (status == BATTEN_OK && !S_ISREG(mode))
        status = write_straight(&save, data, size);
    else if (status == BATTEN_OK)
        status = replace_undisturbed(&save, data, size);
    bat_release(save.target);
    bat_release(save.temporary);
    bat_release(save.folder);
    return status;
}

#endif
