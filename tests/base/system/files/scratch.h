/*
 * A folder of its own for each test of files, and failing calls. A file that includes this
 * begins with _XOPEN_SOURCE 700.
 */
#ifndef TESTS_BASE_SYSTEM_FILES_SCRATCH_H
#define TESTS_BASE_SYSTEM_FILES_SCRATCH_H
#include "support/test.h"

#include <batten/text.h>
#include <dirent.h>
#include <errno.h>
#include <sys/stat.h>

static inline const char *folder(const char *name)
{
    const char *path = test_scratch(name);
    CHECK(mkdir(path, 0700) == 0 || errno == EEXIST);
    return path;
}

static inline const char *in(const char *where, const char *name)
{
    const size_t size = strlen(where) + strlen(name) + 2;
    char *path = test_array(size, 1);
    snprintf(path, size, "%s/%s", where, name);
    return path;
}

static inline int entry_count(const char *where)
{
    DIR *directory = opendir(where);
    CHECK(directory != NULL);
    int count = 0;
    while (directory && readdir(directory))
        count++;
    closedir(directory);
    return count - 2;
}

static inline void put(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL);
    CHECK(fwrite(text, 1, strlen(text), file) == strlen(text));
    CHECK(fclose(file) == 0);
}

static inline bool holds(const char *path, const char *text)
{
    char bytes[100] = "";
    FILE *file = fopen(path, "rb");
    const size_t length = file ? fread(bytes, 1, sizeof bytes - 1, file) : 0;
    if (file)
        fclose(file);
    return file && length == strlen(text) && memcmp(bytes, text, length) == 0;
}

static inline batten_status save(const char *path, const char *text)
{
    return batten_save_file(path, text, strlen(text));
}

static inline void check_loads(const char *path, const char *text)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_load_file(path, 1000, &data, &size));
    CHECK_INT(size, strlen(text));
    CHECK_TEXT(data, text);
    batten_release(data);
}

#endif
