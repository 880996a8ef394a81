/* The door to the operating system: threads, paths and the clock. */
#define _XOPEN_SOURCE 700
#include "base/base.h"
#include "base/system.h"

#include "support/test.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
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

TEST(a_real_path_is_absolute_and_has_no_links)
{
    const char *folder = test_scratch("real"), *link = test_scratch("link"), *reason = "none";
    /* Run again with failing allocations, it finds them there. */
    CHECK(mkdir(folder, 0700) == 0 || errno == EEXIST);
    CHECK(symlink(folder, link) == 0 || errno == EEXIST);
    char *real = batten_system_real_path(folder, &reason);
    CHECK(real || !reason);
    char *followed = batten_system_real_path(link, &reason);
    if (real && followed) {
        CHECK_TEXT(followed, real);
        CHECK(real[0] == '/');
    }
    bat_release(real);
    bat_release(followed);
}

TEST(a_path_to_nothing_has_no_real_path_and_a_reason)
{
    const char *reason = NULL;
    CHECK(!batten_system_real_path(test_scratch("nothing"), &reason));
    if (reason)
        CHECK_TEXT(reason, "there is no such file");
}
