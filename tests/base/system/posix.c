/* The door to the operating system: threads and the clock. */
#define _XOPEN_SOURCE 700
#include "base/base.h"
#include "base/system.h"

#include "support/test.h"
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static void *count_up(void *user)
{
    atomic_fetch_add((atomic_int *)user, 1);
    return NULL;
}

TEST(a_thread_that_is_waited_for_has_done_its_work)
{
    atomic_int count = 0;
    bat_thread threads[3];
    for (int i = 0; i < 3; i++)
        CHECK(bat_thread_start(&threads[i], count_up, &count));
    for (int i = 0; i < 3; i++)
        bat_thread_wait(threads[i]);
    CHECK_INT(atomic_load(&count), 3);
}

TEST(the_processors_are_those_that_the_system_has_online)
{
    CHECK_INT(bat_processor_count(), sysconf(_SC_NPROCESSORS_ONLN));
}

TEST(the_clock_counts_seconds_and_never_runs_backwards)
{
    const double begin = batten_system_seconds();
    nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
    const double elapsed = batten_system_seconds() - begin;
    CHECK(elapsed >= 0.02 && elapsed < 60);
}
