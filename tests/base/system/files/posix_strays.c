/* Temporary files that a killed save left, and those of others. */
#define _XOPEN_SOURCE 700
#include "base/system/files/posix_strays.h"

#include "base/system/files/scratch.h"
#include <fcntl.h>
#include <unistd.h>

TEST(W2_a_save_removes_strays_of_its_own_file_that_nobody_holds)
{
    const char *where = folder("strays"), *path = in(where, "hull.step");
    const char *const kept[] = {".hull.step.abcde.batten-tmp",  ".hull.step.abcdef.batten-tm",
                                ".hull.step.ABCDEF.batten-tmp", ".bull.step.abcdef.batten-tmp",
                                ".hull.step.a12345.batten-tmp", "hull.step.abcdef.batten-tmp"};
    put(in(where, ".hull.step.abcdef.batten-tmp"), "half");
    put(in(where, ".hull.step.012345.batten-tmp"), "");
    for (int i = 0; i < COUNT(kept); i++)
        put(in(where, kept[i]), "other");
    /* The last but one is being written by another process. */
    const int held = open(in(where, kept[4]), O_WRONLY);
    CHECK(held >= 0 && bat_hold_temporary(held));
    const batten_status status = save(path, "new hull");
    close(held);
    if (status == BATTEN_OUT_OF_MEMORY)
        return;
    CHECK_INT(status, BATTEN_OK);
    for (int i = 0; i < COUNT(kept); i++)
        CHECK(holds(in(where, kept[i]), "other"));
    CHECK_INT(entry_count(where), COUNT(kept) + 1);
}

TEST(W2_what_looks_like_a_stray_and_is_no_file_of_ours_stays)
{
    const char *where = folder("no_strays"), *path = in(where, "hull.step");
    const char *sub = in(where, ".hull.step.aaaaaa.batten-tmp"),
               *link = in(where, ".hull.step.bbbbbb.batten-tmp"),
               *pipe = in(where, ".hull.step.cccccc.batten-tmp");
    put(in(where, "target"), "other");
    CHECK(mkdir(sub, 0700) == 0 && symlink("target", link) == 0 && mkfifo(pipe, 0600) == 0);
    const batten_status status = save(path, "new hull");
    const bool kept = holds(link, "other");
    CHECK(rmdir(sub) == 0 && unlink(link) == 0 && unlink(pipe) == 0);
    if (status == BATTEN_OUT_OF_MEMORY)
        return;
    CHECK_INT(status, BATTEN_OK);
    CHECK(kept);
    CHECK(holds(path, "new hull") && holds(in(where, "target"), "other"));
}

TEST(W2_a_temporary_file_that_was_taken_away_is_not_held)
{
    const char *path = in(folder("taken_away"), "a");
    put(path, "");
    const int file = open(path, O_WRONLY), other = open(path, O_WRONLY);
    CHECK(file >= 0 && other >= 0);
    CHECK(bat_hold_temporary(file) && !bat_hold_temporary(other));
    close(file);
    CHECK(bat_hold_temporary(other));
    CHECK(unlink(path) == 0);
    CHECK(!bat_hold_temporary(other));
    close(other);
}

/* The number that the next file opened gets. */
static int next_file(void)
{
    const int file = open("/dev/null", O_RDONLY);
    close(file);
    return file;
}

TEST(saving_loading_and_refusals_leave_no_file_open)
{
    const char *where = folder("open"), *path = in(where, "a");
    put(in(where, ".a.abcdef.batten-tmp"), "half");
    const int before = next_file();
    for (int i = 0; i < 3; i++) {
        char *data = NULL;
        size_t size = 0;
        if (save(path, "text") == BATTEN_OK &&
            batten_load_file(path, 2 + 2 * (size_t)i, &data, &size) == BATTEN_OK)
            batten_release(data);
        save(where, "text");
        CHECK_INT(next_file(), before);
    }
}
