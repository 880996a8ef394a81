/* Files are loaded, and what loading and saving share, on POSIX systems. */
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

static int open_file(const char *path, int flags, mode_t mode)
{
    int file;
    do
        file = open(path, flags | O_CLOEXEC, mode);
    while (file < 0 && errno == EINTR);
    return file;
}

static void prefer_large_pages(void *from, size_t size)
{
#ifdef MADV_HUGEPAGE
    madvise(from, size, MADV_HUGEPAGE);
#else
    (void)from;
    (void)size;
#endif
}

bat_file_calls bat_system = {
    open_file, stat,   readlink,          read, write, fchmod, fsync, close,
    rename,    unlink, prefer_large_pages};

batten_status bat_file_refused(const char *doing, const char *path, int reason)
{
    char shown[BAT_SHOWN_SIZE];
    const locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    bat_fail(BATTEN_FILE_ERROR, "cannot %s '%s': %s", doing,
             bat_shown(path, strlen(path), shown),
             c ? strerror_l(reason, c) : "the system refuses");
    if (c)
        freelocale(c);
    return BATTEN_FILE_ERROR;
}

/* ---- loading ---- */

typedef struct {
    const char *path;
    size_t limit;
    char *data; /* [capacity + 1] */
    size_t length, capacity;
} loading;

static batten_status too_large(const loading *load)
{
    char shown[BAT_SHOWN_SIZE];
    return bat_fail(BATTEN_TOO_LARGE, "'%s' has more than the %zu bytes allowed",
                    bat_shown(load->path, strlen(load->path), shown), load->limit);
}

/* Asking the system for its small pages one by one takes longer than filling them. */
static void take_large_pages(char *data, size_t size)
{
    const size_t large = (size_t)2 << 20, before = (large - (uintptr_t)data % large) % large;
    if (size >= before + large)
        bat_system.prefer_large_pages(data + before, (size - before) / large * large);
}

/* Room for `capacity` bytes, but for no more than one beyond the limit. */
static batten_status reserve(loading *load, size_t capacity)
{
    if (load->limit < SIZE_MAX - 1 && capacity > load->limit + 1)
        capacity = load->limit + 1;
    char *data = bat_resize(load->data, capacity + 1, 1);
    if (!data)
        return BATTEN_OUT_OF_MEMORY;
    take_large_pages(data, capacity);
    load->data = data;
    load->capacity = capacity;
    return BATTEN_OK;
}

batten_status bat_file_wait_for_writer(int file, const char *path)
{
    const int flags = fcntl(file, F_GETFL);
    if (flags < 0 || fcntl(file, F_SETFL, flags & ~O_NONBLOCK) < 0)
        return bat_file_refused("read", path, errno);
    return BATTEN_OK;
}

/* Read to the end, for a file may grow or shrink meanwhile. */
static batten_status read_all(int file, loading *load)
{
    batten_status status = BATTEN_OK;
    ssize_t got = 1;
    while (status == BATTEN_OK && got != 0) {
        if (load->length == load->capacity) {
            status = reserve(load, 2 * load->capacity);
            continue;
        }
        got = bat_system.read(file, load->data + load->length, load->capacity - load->length);
        if (got > 0)
            load->length += (size_t)got;
        else if (got < 0 && errno == EAGAIN)
            status = bat_file_wait_for_writer(file, load->path);
        else if (got < 0 && errno != EINTR)
            status = bat_file_refused("read", load->path, errno);
        if (load->length > load->limit)
            status = too_large(load);
    }
    return status;
}

static batten_status load_open_file(int file, loading *load)
{
    struct stat about;
    const bool known = fstat(file, &about) == 0;
    const bool is_regular = known && S_ISREG(about.st_mode);
    const size_t expected = is_regular && about.st_size > 0 ? (size_t)about.st_size : 0;
    if (expected > load->limit)
        return too_large(load);
    /* One more, to see the end without growing. */
    batten_status status = reserve(load, expected + (is_regular ? 1 : 4096));
    if (status == BATTEN_OK)
        status = read_all(file, load);
    char shown[BAT_SHOWN_SIZE];
    if (status == BATTEN_OK && load->length == 0 && known && S_ISFIFO(about.st_mode))
        status = bat_fail(BATTEN_FILE_ERROR, "nobody writes into the pipe '%s'",
                          bat_shown(load->path, strlen(load->path), shown));
    return status;
}

batten_status batten_load_file(const char *path, size_t limit, char **data, size_t *size)
{
    const int file = bat_system.open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY, 0);
    if (file < 0)
        return bat_file_refused("open", path, errno);
    loading load = {.path = path, .limit = limit};
    const batten_status status = load_open_file(file, &load);
    bat_system.close(file);
    if (status != BATTEN_OK) {
        bat_release(load.data);
        return status;
    }
    load.data[load.length] = 0;
    *data = load.data;
    *size = load.length;
    return BATTEN_OK;
}

#endif
