/* The door to the operating system: threads and the clock. */
#define _XOPEN_SOURCE 700
#include "base/base.h"
#include "base/system.h"

#include "support/test.h"
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
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

static void *wait_for_leave(void *user)
{
    while (!atomic_load((atomic_bool *)user))
        bat_pause();
    return NULL;
}

/* Stacks of earlier threads may be used again, so some succeed. */
TEST(a_thread_for_which_there_is_no_memory_is_not_started)
{
    enum { MOST = 64 };
    if (SANITIZED)
        SKIP("the sanitizer ends a program whose threads cannot start");
    atomic_bool leave = false;
    bat_thread threads[MOST];
    struct rlimit before;
    CHECK(getrlimit(RLIMIT_AS, &before) == 0);
    const struct rlimit little = {1 << 20, before.rlim_max};
    CHECK(setrlimit(RLIMIT_AS, &little) == 0);
    int started = 0;
    while (started < MOST && bat_thread_start(&threads[started], wait_for_leave, &leave))
        started++;
    CHECK(setrlimit(RLIMIT_AS, &before) == 0);
    atomic_store(&leave, true);
    for (int i = 0; i < started; i++)
        bat_thread_wait(threads[i]);
    CHECK(started < MOST);
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

TEST(a_pause_takes_about_a_thousandth_of_a_second)
{
    const double begin = batten_system_seconds();
    for (int i = 0; i < 5; i++)
        bat_pause();
    const double elapsed = batten_system_seconds() - begin;
    CHECK(elapsed >= 0.005 && elapsed < 5);
}
