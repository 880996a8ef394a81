/* Paths as the system knows them. */
#define _XOPEN_SOURCE 700
#include "base/base.h"
#include "base/system.h"

#include "support/test.h"
#include <errno.h>
#include <sys/stat.h>
#include <unistd.h>

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

TEST(a_link_is_one_and_what_it_leads_to_is_none)
{
    const char *folder = test_scratch("linked"), *link = test_scratch("to_linked");
    CHECK(mkdir(folder, 0700) == 0 || errno == EEXIST);
    CHECK(symlink(folder, link) == 0 || errno == EEXIST);
    CHECK(batten_system_is_link(link) && !batten_system_is_link(folder));
    CHECK(!batten_system_is_link(test_scratch("nothing")));
}
