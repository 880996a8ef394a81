/* Paths of a design: relative to its folder, and not outside of it. */
#include "base/system.h"
#include "design/text/document.h"

#include <string.h>

/* "../x", "a/../../x", "/x". */
bool bat_path_leaves(const char *path)
{
    int depth = 0;
    if (*path == '/')
        return true;
    while (*path) {
        const size_t length = strcspn(path, "/");
        if (length == 2 && memcmp(path, "..", 2) == 0)
            depth--;
        else if (length > 0 && !(length == 1 && *path == '.'))
            depth++;
        if (depth < 0)
            return true;
        path += length;
        path += strspn(path, "/");
    }
    return false;
}

/* The folder of the design, without the last '/'; "." for a name alone. */
static size_t folder_length(const char *file_name)
{
    const char *slash = strrchr(file_name, '/');
    return slash ? (size_t)(slash - file_name) : 0;
}

static char *joined(const char *folder, size_t folder_length, const char *path)
{
    const size_t length = strlen(path);
    char *whole = bat_array(folder_length + length + 2, 1);
    if (!whole)
        return NULL;
    memcpy(whole, folder, folder_length);
    whole[folder_length] = '/';
    memcpy(whole + folder_length + 1, path, length);
    return whole;
}

/* A path as a message may show it: control characters become '?'. */
static const char *shown(const char *path, char text[256])
{
    size_t i = 0;
    for (; path[i] && i < 255; i++)
        text[i] = (unsigned char)path[i] < 0x20 || path[i] == 0x7F ? '?' : path[i];
    text[i] = 0;
    return text;
}

/* The real path, given back with bat_release. */
static batten_status resolve(const char *path, char **out)
{
    const char *reason;
    char text[256];
    *out = batten_system_real_path(path, &reason);
    if (*out)
        return BATTEN_OK;
    return reason ? bat_fail(BATTEN_FILE_ERROR, "%s: %s", shown(path, text), reason)
                  : BATTEN_OUT_OF_MEMORY;
}

/* The folder itself is in it, too. */
static bool is_in(const char *folder, const char *path)
{
    const size_t length = strlen(folder);
    return strncmp(folder, path, length) == 0 && (path[length] == '/' || path[length] == 0 ||
                                                  (length > 0 && folder[length - 1] == '/'));
}

static batten_status fail_outside(const char *path, const char *how)
{
    char text[256];
    return bat_fail(BATTEN_BAD_ARGUMENT,
                    "%s leads out of the folder of the design%s; --allow-outside allows it",
                    shown(path, text), how);
}

static batten_status check_in(const char *folder, const char *path)
{
    char *real = NULL, *real_path = NULL;
    batten_status status = resolve(folder, &real);
    if (status == BATTEN_OK)
        status = resolve(path, &real_path);
    if (status == BATTEN_OK && !is_in(real, real_path))
        status = fail_outside(path, " through a link");
    bat_release(real);
    bat_release(real_path);
    return status;
}

batten_status bat_path_beside(const bat_document *document, const char *path, char **out)
{
    const char *name = document->file_name;
    const bool has_folder = strchr(name, '/') != NULL;
    const char *folder = has_folder ? name : ".";
    const size_t length = has_folder ? folder_length(name) : 1;
    const bool is_absolute = *path == '/';
    if (!document->allow_outside && bat_path_leaves(path))
        return fail_outside(path, "");
    char *whole = is_absolute ? joined("", 0, path + 1) : joined(folder, length, path);
    char *base = joined(folder, length, "");
    batten_status status = whole && base ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && !document->allow_outside)
        status = check_in(base, whole);
    bat_release(base);
    if (status == BATTEN_OK)
        *out = whole;
    else
        bat_release(whole);
    return status;
}

batten_status bat_path_check_inside(const bat_document *document, const char *folder,
                                    const char *path)
{
    char text[256];
    const char *reason = NULL, *base = *folder ? folder : ".";
    if (document->allow_outside)
        return BATTEN_OK;
    if (batten_system_is_link(path)) {
        char *real = batten_system_real_path(path, &reason);
        bat_release(real);
        if (!real && reason)
            return bat_fail(BATTEN_FILE_ERROR, "%s is a link that leads nowhere",
                            shown(path, text));
        return real ? check_in(base, path) : BATTEN_OUT_OF_MEMORY;
    }
    char *parent = joined(path, folder_length(path), "");
    if (!parent)
        return BATTEN_OUT_OF_MEMORY;
    char *real = batten_system_real_path(strchr(path, '/') ? parent : ".", &reason);
    /* Where there is no such folder saving says so. */
    batten_status status = real     ? check_in(base, strchr(path, '/') ? parent : ".")
                           : reason ? BATTEN_OK
                                    : BATTEN_OUT_OF_MEMORY;
    bat_release(real);
    bat_release(parent);
    return status;
}
