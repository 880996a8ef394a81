/*
 * Loading and saving where there is no POSIX: by the streams of C. A file is saved beside its place and renamed, so
 * that it is whole or as it was; links, devices, permissions and signals get no attention here.
 */
#include "base/system.h"
#if BAT_SYSTEM != BAT_SYSTEM_POSIX
#include "base/base.h"
#include "base/system/files/plain_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static batten_status fail_file(const char *doing, const char *path, int reason)
{
    char shown[BAT_SHOWN_SIZE];
    return bat_fail(BATTEN_FILE_ERROR, "cannot %s '%s': %s", doing,
                    bat_shown(path, strlen(path), shown), strerror(reason));
}

static batten_status read_stream(FILE *file, const char *path, size_t limit, char **data,
                                 size_t *size)
{
    size_t length = 0, capacity = 0;
    char *bytes = NULL, shown[BAT_SHOWN_SIZE];
    for (;;) {
        if (length == capacity) {
            capacity = capacity ? 2 * capacity : 1 << 16;
            char *more = bat_resize(bytes, capacity + 1, 1);
            if (!more) {
                bat_release(bytes);
                return BATTEN_OUT_OF_MEMORY;
            }
            bytes = more;
        }
        const size_t got = fread(bytes + length, 1, capacity - length, file);
        length += got;
        if (got > 0 && length <= limit)
            continue;
        const bool failed = ferror(file) != 0;
        if (length <= limit && !failed)
            break;
        bat_release(bytes);
        return failed ? fail_file("read", path, errno)
                      : bat_fail(BATTEN_TOO_LARGE, "'%s' has more than the %zu bytes allowed",
                                 bat_shown(path, strlen(path), shown), limit);
    }
    bytes[length] = 0;
    *data = bytes;
    *size = length;
    return BATTEN_OK;
}

batten_status batten_load_file(const char *path, size_t limit, char **data, size_t *size)
{
    FILE *file = bat_plain_open(path, "rb");
    if (!file)
        return fail_file("open", path, errno);
    const batten_status status = read_stream(file, path, limit, data, size);
    fclose(file);
    return status;
}

batten_status batten_save_file(const char *path, const char *data, size_t size)
{
    static const char ending[] = ".batten-tmp";
    const size_t length = strlen(path);
    char *temporary = bat_array(length + sizeof ending, 1);
    if (!temporary)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(temporary, path, length);
    memcpy(temporary + length, ending, sizeof ending);
    batten_status status = BATTEN_OK;
    FILE *file = bat_plain_open(temporary, "wb");
    if (!file)
        status = fail_file("save", path, errno);
    if (file && size > 0 && fwrite(data, 1, size, file) != size)
        status = fail_file("write", path, errno);
    if (file && fclose(file) != 0 && status == BATTEN_OK)
        status = fail_file("write", path, errno);
    if (file && status == BATTEN_OK && !bat_plain_replace(temporary, path))
        status = fail_file("save", path, errno);
    if (file && status != BATTEN_OK)
        bat_plain_remove(temporary);
    bat_release(temporary);
    return status;
}

#else
typedef int bat_no_plain_files; /* a file of C must declare something */
#endif
