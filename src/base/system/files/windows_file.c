/* Real paths and files on Windows; paths are UTF-8. */
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_WINDOWS
#define WIN32_LEAN_AND_MEAN
#include "base/base.h"
#include "base/system/files/plain_file.h"

#include <errno.h>
#include <windows.h>

static wchar_t *widened(const char *path)
{
    const int length = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, NULL, 0);
    wchar_t *wide = length > 0 ? bat_array((size_t)length, sizeof *wide) : NULL;
    if (wide)
        MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, length);
    else
        errno = length > 0 ? ENOMEM : EINVAL;
    return wide;
}

static char *narrowed(const wchar_t *wide)
{
    const int length = WideCharToMultiByte(CP_UTF8, 0, wide, -1, NULL, 0, NULL, NULL);
    char *path = length > 0 ? bat_array((size_t)length, 1) : NULL;
    if (path)
        WideCharToMultiByte(CP_UTF8, 0, wide, -1, path, length, NULL, NULL);
    for (char *c = path; c && *c; c++)
        if (*c == '\\')
            *c = '/';
    return path;
}

/* The final path of an open file follows links, which GetFullPathName does not. */
char *batten_system_real_path(const char *path, const char **reason)
{
    *reason = NULL;
    wchar_t *wide = widened(path);
    if (!wide)
        return NULL;
    const HANDLE file =
        CreateFileW(wide, 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, NULL,
                    OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    bat_release(wide);
    if (file == INVALID_HANDLE_VALUE) {
        *reason = "there is no such file";
        return NULL;
    }
    char *real = NULL;
    const DWORD length = GetFinalPathNameByHandleW(file, NULL, 0, FILE_NAME_NORMALIZED);
    wchar_t *final = length > 0 ? bat_array((size_t)length + 1, sizeof *final) : NULL;
    if (final && GetFinalPathNameByHandleW(file, final, length + 1, FILE_NAME_NORMALIZED) > 0)
        real = narrowed(final);
    if (length == 0)
        *reason = "the system does not tell its path";
    bat_release(final);
    CloseHandle(file);
    return real;
}

bool batten_system_is_link(const char *path)
{
    wchar_t *wide = widened(path);
    const DWORD found = wide ? GetFileAttributesW(wide) : INVALID_FILE_ATTRIBUTES;
    bat_release(wide);
    return found != INVALID_FILE_ATTRIBUTES && (found & FILE_ATTRIBUTE_REPARSE_POINT);
}

FILE *bat_plain_open(const char *path, const char *mode)
{
    wchar_t *wide = widened(path), letters[4] = {0};
    for (int i = 0; i < 3 && mode[i]; i++)
        letters[i] = (wchar_t)mode[i];
    FILE *file = wide ? _wfopen(wide, letters) : NULL;
    const int reason = errno;
    bat_release(wide);
    errno = reason;
    return file;
}

bool bat_plain_replace(const char *from, const char *to)
{
    wchar_t *wide_from = widened(from), *wide_to = widened(to);
    const bool done =
        wide_from && wide_to &&
        MoveFileExW(wide_from, wide_to, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH);
    bat_release(wide_from);
    bat_release(wide_to);
    if (!done)
        errno = EACCES;
    return done;
}

void bat_plain_remove(const char *path)
{
    wchar_t *wide = widened(path);
    if (wide)
        DeleteFileW(wide);
    bat_release(wide);
}

#endif
