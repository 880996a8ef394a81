/* The command's door to the operating system: signals, terminals, folders, and which files are the same. */
#define _XOPEN_SOURCE 700
#include "system.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef _WIN32
#include <direct.h>
#include <io.h>
#include <stdlib.h>
#endif

/* ---- signals ---- */

/* The signal that came, or 0. The only thing a handler touches. */
static volatile sig_atomic_t caught;

int system_signal(void)
{
    return (int)caught;
}

#ifdef _WIN32

static void catch_signal(int number)
{
    if (caught)
        _Exit(128 + caught);
    caught = number;
    signal(number, catch_signal);
}

void system_catch_signals(void)
{
    signal(SIGINT, catch_signal);
    signal(SIGTERM, catch_signal);
}

#else

/* Seconds. Work that does not look at the job, a search say, is ended when it has not stopped by then; a
 * file is complete or was never there, since it is renamed when it is written. */
enum { GRACE = 3 };

static void catch_signal(int number)
{
    if (caught)
        _exit(128 + caught);
    caught = number;
    alarm(GRACE);
}

static void end_now(int number)
{
    (void)number;
    _exit(128 + caught);
}

void system_catch_signals(void)
{
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = catch_signal;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    action.sa_handler = end_now;
    sigaction(SIGALRM, &action, NULL);
    /* A closed pipe is a failed write, which every writer reports. */
    signal(SIGPIPE, SIG_IGN);
}

#endif

/* ---- files ---- */

bool system_is_terminal(FILE *stream)
{
    return isatty(fileno(stream));
}

bool system_exists(const char *path)
{
    return access(path, F_OK) == 0;
}

bool system_is_same_file(const char *path, const char *other)
{
    struct stat from, to;
    return stat(path, &to) == 0 && S_ISREG(to.st_mode) &&
           (other ? stat(other, &from) : fstat(fileno(stdin), &from)) == 0 &&
           from.st_dev == to.st_dev && from.st_ino == to.st_ino;
}

int system_make_folder(const char *path)
{
    struct stat found;
#ifdef _WIN32
    const bool made = _mkdir(path) == 0;
#else
    const bool made = mkdir(path, 0777) == 0;
#endif
    if (made)
        return 0;
    const int error = errno;
    return error == EEXIST && stat(path, &found) == 0 && S_ISDIR(found.st_mode) ? 0 : error;
}
