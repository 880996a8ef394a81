/* Threads, processors and the clock on POSIX systems. */
#define _XOPEN_SOURCE 700
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_POSIX
#include "base/base.h"

#include <pthread.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* ---- threads ---- */

_Static_assert(sizeof(pthread_t) <= sizeof(uintptr_t), "a thread must fit into its handle");

static bool start_thread(bat_thread *thread, bat_thread_body body, void *user)
{
    pthread_t started;
    if (pthread_create(&started, NULL, body, user) != 0)
        return false;
    memset(thread, 0, sizeof *thread);
    memcpy(&thread->handle, &started, sizeof started);
    return true;
}

bool (*bat_thread_start)(bat_thread *thread, bat_thread_body body, void *user) = start_thread;

void bat_thread_wait(bat_thread thread)
{
    pthread_t started;
    memcpy(&started, &thread.handle, sizeof started);
    pthread_join(started, NULL);
}

void bat_pause(void)
{
    nanosleep(&(struct timespec){0, 1000000}, NULL); /* nanoseconds */
}

int bat_processor_count(void)
{
    return bat_max_int(1, (int)sysconf(_SC_NPROCESSORS_ONLN));
}

/* ---- time ---- */

double batten_system_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec; /* nanoseconds */
}

#endif
