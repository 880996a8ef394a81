#define _XOPEN_SOURCE 700
#include "command.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The signal that came, or 0. The only thing a handler touches. */
static volatile sig_atomic_t caught;
static bool shows_progress, line_is_open, is_quiet;

/* Work that does not look at the job, a search say, is ended when it has not stopped by then; a
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

static bool is_cancelled(void *user)
{
    (void)user;
    return caught != 0;
}

static void progress(void *user, double fraction, const char *what)
{
    (void)user;
    if (!shows_progress)
        return;
    fprintf(stderr, "\r\033[K%3.0f %%  %s", 100 * fraction, what ? what : "");
    fflush(stderr);
    line_is_open = true;
}

void job_begin(bool quiet)
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
    is_quiet = quiet;
    shows_progress = !quiet && isatty(STDERR_FILENO);
}

bool job_is_quiet(void)
{
    return is_quiet;
}

const batten_job *job_get(void)
{
    static const batten_job job = {sizeof(batten_job), 0, 0, is_cancelled, progress, NULL};
    return &job;
}

void job_end(void)
{
    if (line_is_open)
        fputs("\r\033[K", stderr);
    line_is_open = false;
}

int job_exit(int otherwise)
{
    return caught ? 128 + (int)caught : otherwise;
}
