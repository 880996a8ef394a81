/*
 * The calls through which files are read and written: a table, so that a test can let each of them fail.
 * A file that includes this begins with _XOPEN_SOURCE 700.
 */
#ifndef BAT_FILE_H
#define BAT_FILE_H
#include <batten/text.h>
#include <sys/stat.h>
#include <sys/types.h>

typedef struct {
    int (*open)(const char *path, int flags, mode_t mode);
    int (*stat)(const char *path, struct stat *status);
    ssize_t (*readlink)(const char *path, char *buffer, size_t size);
    ssize_t (*read)(int file, void *bytes, size_t size);
    ssize_t (*write)(int file, const void *bytes, size_t size);
    int (*fchmod)(int file, mode_t mode);
    int (*fsync)(int file);
    int (*close)(int file);
    int (*rename)(const char *from, const char *to);
    int (*unlink)(const char *path);
    void (*prefer_large_pages)(void *from, size_t size); /* a wish: the system may refuse it */
} bat_file_calls;

/* Written by tests alone. */
extern bat_file_calls bat_system;

/* ---- posix_load.c ---- */

/* "cannot DO 'PATH': REASON", the reason in English whatever the locale. */
batten_status bat_file_refused(const char *doing, const char *path, int reason);
/* A pipe was opened without waiting; whoever writes into it may take their time. */
batten_status bat_file_wait_for_writer(int file, const char *path);

#endif
