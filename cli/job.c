/* The running job: progress on a terminal, and cancelling by the signals that system.c catches. */
#include "command.h"
#include "system.h"

#include <stdio.h>

static bool shows_progress, line_is_open, is_quiet;
static int thread_count; /* 0 for all processors */

static bool is_cancelled(void *user)
{
    (void)user;
    return system_signal() != 0;
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

void job_begin(bool quiet, int threads)
{
    thread_count = threads;
    system_catch_signals();
    is_quiet = quiet;
    shows_progress = !quiet && system_is_terminal(stderr);
}

bool job_is_quiet(void)
{
    return is_quiet;
}

const batten_job *job_get(void)
{
    static batten_job job = {sizeof(batten_job), 0, 0, is_cancelled, progress, NULL};
    job.thread_count = thread_count;
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
    return system_signal() ? 128 + system_signal() : otherwise;
}
