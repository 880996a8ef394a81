#define _XOPEN_SOURCE 700
#include "base/system/files/posix_file.h"

#include "base/system/files/scratch.h"
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* ---- a system whose calls fail when told to ---- */

static bat_file_calls real_system;
static int call_count, fail_call, fail_errno;
static const char *failed_call;

/* The calls in their order, a blank behind each. */
static char calls_made[2000];

static bool must_fail(const char *name)
{
    if (strlen(calls_made) + strlen(name) + 2 < sizeof calls_made)
        strcat(strcat(calls_made, name), " ");
    if (++call_count != fail_call)
        return false;
    if (fail_errno == 0)
        kill(getpid(), SIGKILL);
    failed_call = name;
    errno = fail_errno;
    return true;
}

static int failing_open(const char *path, int flags, mode_t mode)
{
    return must_fail(flags & O_DIRECTORY ? "open folder" : "open")
               ? -1
               : real_system.open(path, flags, mode);
}

static int failing_stat(const char *path, struct stat *about)
{
    return must_fail("stat") ? -1 : real_system.stat(path, about);
}

static ssize_t failing_readlink(const char *path, char *buffer, size_t size)
{
    return must_fail("readlink") ? -1 : real_system.readlink(path, buffer, size);
}

static ssize_t failing_read(int file, void *bytes, size_t size)
{
    return must_fail("read") ? -1 : real_system.read(file, bytes, size);
}

/* Writes are short: two bytes at a time. */
static ssize_t failing_write(int file, const void *bytes, size_t size)
{
    return must_fail("write") ? -1 : real_system.write(file, bytes, size < 2 ? size : 2);
}

static int failing_fchmod(int file, mode_t mode)
{
    return must_fail("fchmod") ? -1 : real_system.fchmod(file, mode);
}

static int failing_fsync(int file)
{
    (void)file; /* waiting for the disk proves nothing here */
    return must_fail("fsync") ? -1 : 0;
}

static int failing_close(int file)
{
    const bool failed = must_fail("close");
    const int reason = errno;
    real_system.close(file);
    errno = reason;
    return failed ? -1 : 0;
}

static int failing_rename(const char *from, const char *to)
{
    return must_fail("rename") ? -1 : real_system.rename(from, to);
}

static int failing_unlink(const char *path)
{
    return real_system.unlink(path);
}

static void install(int call, int reason)
{
    real_system = bat_system;
    call_count = 0;
    fail_call = call;
    fail_errno = reason;
    failed_call = "";
    calls_made[0] = '\0';
    bat_system = (bat_file_calls){failing_open,
                                  failing_stat,
                                  failing_readlink,
                                  failing_read,
                                  failing_write,
                                  failing_fchmod,
                                  failing_fsync,
                                  failing_close,
                                  failing_rename,
                                  failing_unlink,
                                  real_system.prefer_large_pages};
}

static void uninstall(void)
{
    bat_system = real_system;
}

/* ---- loading ---- */

TEST(a_saved_file_loads)
{
    const char *path = in(folder("plain"), "a");
    CHECK_OK(save(path, "frame"));
    check_loads(path, "frame");
    CHECK_OK(save(path, ""));
    check_loads(path, "");
    char *large = test_array(5000000, 1), *data = NULL;
    size_t size = 0;
    memset(large, 'x', 5000000);
    CHECK_OK(batten_save_file(path, large, 5000000));
    CHECK_OK(batten_load_file(path, SIZE_MAX, &data, &size));
    CHECK(size == 5000000 && memcmp(data, large, size) == 0 && data[size] == 0);
    batten_release(data);
}

TEST(F1_a_file_whose_reading_fails_is_refused)
{
    const char *path = in(folder("reading"), "a");
    put(path, "text");
    char *data = NULL;
    size_t size = 0;
    install(2, EIO);
    batten_status status = batten_load_file(path, 100, &data, &size);
    uninstall();
    if (status != BATTEN_OUT_OF_MEMORY) {
        CHECK_INT(status, BATTEN_FILE_ERROR);
        CHECK_MESSAGE("Input/output error");
    }
    install(2, EINTR);
    status = batten_load_file(path, 100, &data, &size);
    uninstall();
    if (status != BATTEN_OUT_OF_MEMORY) {
        CHECK_INT(status, BATTEN_OK);
        CHECK_TEXT(data, "text");
    }
    batten_release(data);
}

/* ---- saving ---- */

static const int reasons[] = {EINTR, ENOSPC, EDQUOT, EIO, EROFS, EACCES};

/* One save with its call `call` failing; false when there is no such call. */
static bool check_failing_save(const char *where, const char *path, bool existed, int call,
                               int reason)
{
    unlink(path);
    if (existed)
        put(path, "old hull");
    install(call, reason);
    const batten_status status = save(path, "new hull");
    uninstall();
    if (status == BATTEN_OUT_OF_MEMORY) {
        CHECK(existed ? holds(path, "old hull") : access(path, F_OK) != 0);
        CHECK_INT(entry_count(where), existed);
        return call < 30;
    }
    const bool folder_failed = strstr(batten_message(), "power loss") != NULL;
    if (status == BATTEN_OK || folder_failed) {
        CHECK(holds(path, "new hull"));
    } else {
        CHECK_INT(status, BATTEN_FILE_ERROR);
        CHECK(existed ? holds(path, "old hull") : access(path, F_OK) != 0);
    }
    if (status != BATTEN_OK) {
        CHECK_MESSAGE(path);
        CHECK_MESSAGE(strerror(reason));
        /* Interrupted writing goes on. */
        CHECK(reason != EINTR ||
              (strcmp(failed_call, "write") != 0 && strcmp(failed_call, "fsync") != 0 &&
               strcmp(failed_call, "close") != 0));
    }
    CHECK_INT(entry_count(where), existed || status == BATTEN_OK || folder_failed);
    return *failed_call || status != BATTEN_OK;
}

TEST(W1_whichever_call_of_a_save_fails_a_whole_file_remains_and_no_stray)
{
    const char *where = folder("faults");
    const char *path = in(where, "hull.step");
    const int cases = test_cases(COUNT(reasons));
    for (int existed = 0; existed < 2; existed++)
        for (int r = 0; r < cases && r < COUNT(reasons); r++) {
            int call = 1;
            while (check_failing_save(where, path, existed, call, reasons[r]))
                call++;
            CHECK(call > 10);
        }
}

/* A save whose process is killed at a call; false when it came to its end. */
static bool save_and_be_killed(const char *path, int call)
{
    int status = 0;
    const pid_t child = fork();
    if (child == 0) {
        install(call, 0);
        _exit(save(path, "new hull") == BATTEN_OK ? 0 : 1);
    }
    CHECK(waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status) ? WTERMSIG(status) == SIGKILL : status == 0);
    return WIFSIGNALED(status);
}

TEST(W2_a_process_killed_at_any_call_of_a_save_leaves_a_whole_file)
{
    const char *where = folder("killed"), *path = in(where, "hull.step");
    int call = 0;
    bool is_killed = true;
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    int strays = 0;
    while (is_killed) {
        put(path, "old hull");
        is_killed = save_and_be_killed(path, ++call);
        CHECK(holds(path, "new hull") || (is_killed && holds(path, "old hull")));
        strays = entry_count(where) > strays ? entry_count(where) : strays;
    }
    CHECK(call > 10);
    CHECK_INT(strays, 2); /* each save takes away what the one before left */
    CHECK_INT(entry_count(where), 1);
}

/* What is not on the disk when it takes the new name is lost with the power. */
TEST(W3_the_bytes_are_on_the_disk_before_the_name_and_the_name_before_success)
{
    const char *path = in(folder("power"), "hull.step");
    put(path, "old hull");
    install(0, EIO);
    const batten_status status = save(path, "new hull");
    uninstall();
    if (status == BATTEN_OUT_OF_MEMORY)
        return;
    const char *last = calls_made, *next = calls_made;
    while ((next = strstr(next, "write ")))
        last = next++;
    const char *bytes = strstr(last, "fsync "), *name = strstr(last, "rename ");
    CHECK(bytes != NULL && name != NULL && bytes < name);
    const char *opened = strstr(name, "open folder ");
    CHECK(opened != NULL && strstr(opened, "fsync ") != NULL);
}

TEST(W1_a_full_device_is_reported)
{
    if (access("/dev/full", W_OK) != 0)
        SKIP("there is no /dev/full");
    CHECK_STATUS(save("/dev/full", "text"), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("'/dev/full': No space left on device");
}

TEST(W8_a_pipe_or_device_is_written_straight)
{
    CHECK_OK(save("/dev/null", "text"));
    int ends[2];
    CHECK(pipe(ends) == 0);
    char path[40], bytes[10] = "";
    snprintf(path, sizeof path, "/dev/fd/%d", ends[1]);
    if (access(path, W_OK) != 0)
        SKIP("there is no /dev/fd");
    const batten_status status = save(path, "piped");
    close(ends[1]);
    CHECK(read(ends[0], bytes, 9) == (status == BATTEN_OK ? 5 : 0));
    close(ends[0]);
    CHECK(status == BATTEN_OUT_OF_MEMORY || strcmp(bytes, "piped") == 0);
}

TEST(W8_a_pipe_whose_reader_has_gone_is_an_error)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    sigaction(SIGPIPE, &ignore, &before);
    int ends[2];
    CHECK(pipe(ends) == 0);
    char path[40];
    snprintf(path, sizeof path, "/dev/fd/%d", ends[1]);
    close(ends[0]);
    const batten_status status = save(path, "piped");
    sigaction(SIGPIPE, &before, NULL);
    close(ends[1]);
    CHECK(status == BATTEN_FILE_ERROR || status == BATTEN_OUT_OF_MEMORY);
}

TEST(W8_the_closing_of_a_device_is_checked)
{
    install(5, EIO); /* stat, open, write, write, close */
    const batten_status status = save("/dev/null", "text");
    uninstall();
    CHECK(status == BATTEN_FILE_ERROR || status == BATTEN_OUT_OF_MEMORY);
    install(2, EACCES);
    const batten_status closed = save("/dev/null", "text");
    uninstall();
    CHECK(closed == BATTEN_FILE_ERROR || closed == BATTEN_OUT_OF_MEMORY);
}

TEST(W4_the_mode_of_a_file_is_kept)
{
    const char *path = in(folder("mode"), "a");
    struct stat about;
    const mode_t mask = umask(027);
    put(path, "old");
    CHECK(chmod(path, 0751) == 0);
    CHECK_OK(save(path, "new"));
    CHECK(stat(path, &about) == 0 && (about.st_mode & 07777) == 0751);
    CHECK(unlink(path) == 0);
    const batten_status status = save(path, "new");
    umask(mask);
    if (status == BATTEN_OUT_OF_MEMORY)
        return;
    CHECK(stat(path, &about) == 0 && (about.st_mode & 07777) == 0640);
}

TEST(W4_the_target_of_a_link_is_replaced)
{
    const char *where = folder("links");
    const char *other = folder("links/other"), *target = in(other, "target");
    const char *relative = in(where, "relative"), *absolute = in(where, "absolute"),
               *chain = in(other, "chain"), *dangling = in(where, "dangling");
    put(target, "old");
    CHECK(symlink("other/target", relative) == 0 || errno == EEXIST);
    CHECK(symlink(target, absolute) == 0 || errno == EEXIST);
    CHECK(symlink("../relative", chain) == 0 || errno == EEXIST);
    CHECK(symlink("other/new", dangling) == 0 || errno == EEXIST);
    CHECK_OK(save(relative, "1"));
    CHECK(holds(target, "1"));
    CHECK_OK(save(absolute, "2"));
    CHECK(holds(target, "2"));
    CHECK_OK(save(chain, "3"));
    CHECK(holds(target, "3"));
    CHECK_OK(save(dangling, "4"));
    CHECK(holds(in(other, "new"), "4"));
    CHECK(readlink(chain, (char[9]){0}, 9) == 9);
    CHECK_INT(entry_count(where), 4);
    CHECK_INT(entry_count(other), 3);
}

TEST(W4_a_ring_of_links_is_refused)
{
    const char *where = folder("ring");
    CHECK(symlink("b", in(where, "a")) == 0 || errno == EEXIST);
    CHECK(symlink("a", in(where, "b")) == 0 || errno == EEXIST);
    CHECK_STATUS(save(in(where, "a"), "text"), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("Too many levels of symbolic links");
}

TEST(W4_the_other_names_of_a_file_keep_the_old_one)
{
    const char *where = folder("hard"), *path = in(where, "a"), *other = in(where, "b");
    unlink(path);
    unlink(other);
    put(path, "old");
    CHECK(link(path, other) == 0);
    CHECK_OK(save(path, "new"));
    CHECK(holds(path, "new") && holds(other, "old"));
}

TEST(W4_the_target_of_a_link_may_be_on_another_disk)
{
    const char *where = folder("disks"), *path = in(where, "a");
    char target[60];
    struct stat here, there;
    snprintf(target, sizeof target, "/dev/shm/batten-test-%ld", (long)getpid());
    if (access("/dev/shm", W_OK) != 0 || stat("/dev/shm", &there) != 0 ||
        stat(where, &here) != 0 || here.st_dev == there.st_dev)
        SKIP("there is no other disk");
    put(target, "old");
    unlink(path);
    const bool linked = symlink(target, path) == 0;
    const batten_status status = save(path, "new");
    const bool is_new = holds(target, "new");
    unlink(target);
    CHECK(linked);
    if (status == BATTEN_OUT_OF_MEMORY)
        return;
    CHECK_INT(status, BATTEN_OK);
    CHECK(is_new && readlink(path, (char[9]){0}, 9) == 9);
}

enum { SAVED = 7, DENIED = 8, OTHERWISE = 9, NOBODY_IS_NONE = 99 };

/* Save as somebody to whom the system may refuse things. */
static int save_as_nobody(const char *path)
{
    enum { NOBODY = 65534 };
    int status = 0;
    const pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && (setgid(NOBODY) != 0 || setuid(NOBODY) != 0))
            _exit(NOBODY_IS_NONE);
        const batten_status saved = save(path, "new");
        const bool is_denied = saved == BATTEN_FILE_ERROR &&
                               strstr(batten_message(), path) != NULL &&
                               strstr(batten_message(), "Permission denied") != NULL;
        _exit(saved == BATTEN_OK ? SAVED : is_denied ? DENIED : OTHERWISE);
    }
    CHECK(waitpid(child, &status, 0) == child && WIFEXITED(status));
    return WEXITSTATUS(status);
}

TEST(W4_a_file_or_folder_that_may_not_be_written_is_refused)
{
    char where[60];
    snprintf(where, sizeof where, "/tmp/batten-test-%ld", (long)getpid());
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    if (mkdir(where, 0700) != 0)
        SKIP("there is no /tmp");
    const char *path = in(where, "a");
    put(path, "old");
    const bool ready = chmod(where, 0777) == 0 && chmod(path, 0444) == 0;
    const int read_only = save_as_nobody(path);
    const bool kept = holds(path, "old") && entry_count(where) == 1;
    const bool closed = chmod(path, 0666) == 0 && chmod(where, 0555) == 0;
    const int in_closed = save_as_nobody(path);
    const bool kept_again = holds(path, "old") && entry_count(where) == 1;
    const bool opened = chmod(where, 0777) == 0;
    const int in_open = save_as_nobody(path);
    unlink(path);
    rmdir(where);
    if (read_only == NOBODY_IS_NONE)
        SKIP("nobody else can be taken the part of");
    CHECK(ready && closed && opened);
    CHECK_INT(read_only, DENIED);
    CHECK_INT(in_closed, DENIED);
    CHECK_INT(in_open, SAVED);
    CHECK(kept && kept_again);
}

TEST(what_cannot_be_a_file_is_not_saved)
{
    const char *where = folder("cannot");
    CHECK_STATUS(save(where, "text"), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("Is a directory");
    CHECK_STATUS(save(in(where, "new/"), "text"), BATTEN_FILE_ERROR);
    CHECK_STATUS(save("", "text"), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("No such file");
    CHECK_STATUS(save(in(where, "absent/a"), "text"), BATTEN_FILE_ERROR);
    put(in(where, "file"), "");
    CHECK_STATUS(save(in(where, "file/a"), "text"), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("Not a directory");
    if (geteuid() == 0)
        SKIP("the superuser may write read-only files");
    CHECK(chmod(in(where, "file"), 0400) == 0);
    CHECK_STATUS(save(in(where, "file"), "text"), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("Permission denied");
}

TEST(F8_odd_file_names_work_and_are_shown_escaped)
{
    const char *where = folder("odd");
    char longest[256];
    memset(longest, 'n', 255);
    longest[255] = 0;
    const char *const names[] = {"a b",      "'\"",   "new\nline", "\xe9t\xe9",
                                 "-leading", longest, "%s%n"};
    for (int i = 0; i < COUNT(names); i++) {
        CHECK_OK(save(in(where, names[i]), names[i]));
        check_loads(in(where, names[i]), names[i]);
    }
    CHECK_INT(entry_count(where), COUNT(names));
    CHECK_STATUS(save(in(where, "new\nline/\xe9"), ""), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("new\\x0aline/\\xe9'");
    CHECK(chdir(where) == 0);
    CHECK_OK(save("-leading", "here"));
    check_loads("-leading", "here");
    CHECK(chdir("/") == 0);
}

static const char *meddled_path;
static int meddling;

/* What somebody else does to the file while it is being saved. */
static int meddling_fsync(int file)
{
    char other[300];
    snprintf(other, sizeof other, "%s.other", meddled_path);
    switch (meddling) {
    case 0: /* written longer */
        put(meddled_path, "by somebody else");
        break;
    case 1: /* replaced by one of the same size */
        put(other, "new");
        CHECK(rename(other, meddled_path) == 0);
        break;
    case 2: /* written with the same size */
        CHECK(utimensat(AT_FDCWD, meddled_path, (struct timespec[2]){{1, 0}, {1, 0}}, 0) == 0);
        break;
    default:
        unlink(meddled_path);
    }
    return real_system.fsync(file);
}

TEST(a_file_that_changes_meanwhile_is_not_overwritten)
{
    const char *where = folder("meddle");
    meddled_path = in(where, "a");
    for (meddling = 0; meddling < 4; meddling++) {
        put(meddled_path, "old");
        real_system = bat_system;
        bat_system.fsync = meddling_fsync;
        const batten_status status = save(meddled_path, "mine");
        uninstall();
        if (status != BATTEN_OUT_OF_MEMORY) {
            CHECK_INT(status, BATTEN_FILE_ERROR);
            CHECK_MESSAGE("changed by another programme");
            CHECK(!holds(meddled_path, "mine"));
            CHECK_INT(entry_count(where), meddling < 3);
        }
    }
}

static ssize_t no_write(int file, const void *bytes, size_t size)
{
    (void)file, (void)bytes, (void)size;
    errno = EIO; /* which has nothing to say where nothing failed */
    return 0;
}

static int links_read;

static ssize_t endless_readlink(const char *path, char *buffer, size_t size)
{
    (void)path;
    links_read++;
    memset(buffer, 'x', size);
    return (ssize_t)size;
}

static ssize_t circular_readlink(const char *path, char *buffer, size_t size)
{
    (void)path, (void)size;
    links_read++;
    buffer[0] = 'x';
    return 1;
}

static void check_refused_with(batten_status status, const char *reason)
{
    CHECK(status == BATTEN_FILE_ERROR || status == BATTEN_OUT_OF_MEMORY);
    if (status == BATTEN_FILE_ERROR)
        CHECK_MESSAGE(reason);
}

TEST(W1_a_system_that_writes_nothing_or_links_without_end_is_not_waited_for)
{
    const char *path = in(folder("odd_system"), "a");
    real_system = bat_system;
    bat_system.write = no_write;
    batten_status status = save(path, "text");
    uninstall();
    check_refused_with(status, "No space left on device");
    for (int links = 0; links < 2; links++) {
        links_read = 0;
        bat_system.readlink = links ? circular_readlink : endless_readlink;
        status = save(path, "text");
        uninstall();
        check_refused_with(status, "Too many levels of symbolic links");
        CHECK(status == BATTEN_OUT_OF_MEMORY || links_read == (links ? 41 : 1));
    }
    CHECK_INT(entry_count(folder("odd_system")), 0);
}

static int taken_open(const char *path, int flags, mode_t mode)
{
    if (flags & O_EXCL && (fail_call == 0 || ++call_count < fail_call)) {
        errno = EEXIST;
        return -1;
    }
    return real_system.open(path, flags, mode);
}

TEST(a_taken_name_beside_is_not_used)
{
    const char *path = in(folder("taken"), "a");
    for (fail_call = 0; fail_call < 6; fail_call += 5) {
        call_count = 0;
        real_system = bat_system;
        bat_system.open = taken_open;
        const batten_status status = save(path, "text");
        uninstall();
        CHECK(status == BATTEN_OUT_OF_MEMORY ||
              status == (fail_call ? BATTEN_OK : BATTEN_FILE_ERROR));
    }
}

/* ---- signals ---- */

static int signal_sent;

static ssize_t signalling_write(int file, const void *bytes, size_t size)
{
    kill(getpid(), signal_sent);
    return real_system.write(file, bytes, size / 2);
}

static int signalling_fsync(int file)
{
    kill(getpid(), signal_sent);
    return real_system.fsync(file);
}

/* In a child: save while a signal arrives; 7 when the save returned. */
static int status_of_child(const char *path, int sent, bool while_writing, bool handled)
{
    const pid_t child = fork();
    if (child == 0) {
        /* Programs in the background are born with signals ignored. */
        sigaction(sent, &(struct sigaction){.sa_handler = handled ? SIG_IGN : SIG_DFL}, NULL);
        signal_sent = sent;
        real_system = bat_system;
        if (while_writing)
            bat_system.write = signalling_write;
        else
            bat_system.fsync = signalling_fsync;
        _exit(save(path, "new") == BATTEN_OK ? 7 : 8);
    }
    int status = 0;
    CHECK(waitpid(child, &status, 0) == child);
    return status;
}

TEST(W9_a_signal_while_saving_leaves_the_old_file_and_no_stray)
{
    const char *where = folder("signal"), *path = in(where, "a");
    const int sent[] = {SIGINT, SIGTERM, SIGHUP};
    for (int i = 0; i < 2 * COUNT(sent); i++) {
        put(path, "old");
        const int status = status_of_child(path, sent[i / 2], i % 2, false);
        CHECK(WIFSIGNALED(status) && WTERMSIG(status) == sent[i / 2]);
        CHECK(holds(path, "old"));
        CHECK_INT(entry_count(where), 1);
    }
}

TEST(W9_a_signal_that_the_programme_ignores_does_not_end_a_save)
{
    const char *path = in(folder("ignored"), "a");
    put(path, "old");
    const int status = status_of_child(path, SIGINT, true, true);
    CHECK(WIFEXITED(status) && (WEXITSTATUS(status) == 7 || WEXITSTATUS(status) == 8));
    CHECK(holds(path, WEXITSTATUS(status) == 7 ? "new" : "old"));
}

TEST(W9_a_signal_that_the_caller_holds_back_is_the_callers_affair)
{
    const char *path = in(folder("held"), "a");
    sigset_t interrupt, before;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    pthread_sigmask(SIG_BLOCK, &interrupt, &before);
    kill(getpid(), SIGINT);
    const batten_status status = save(path, "new");
    int number = 0;
    sigwait(&interrupt, &number);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    CHECK_INT(number, SIGINT);
    CHECK(status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY);
}

/* In a child whose descriptor 0 is free, which is then the first to be given out: 7 when the file is
 * saved and loaded, 8 without memory. */
static int status_without_input(const char *path)
{
    const pid_t child = fork();
    if (child == 0) {
        char *data = NULL;
        size_t size = 0;
        close(STDIN_FILENO);
        batten_status status = save(path, "new");
        if (status == BATTEN_OK)
            status = batten_load_file(path, 10, &data, &size);
        const bool right = status == BATTEN_OK && size == 3 && memcmp(data, "new", 3) == 0;
        _exit(right ? 7 : status == BATTEN_OUT_OF_MEMORY ? 8 : 9);
    }
    int status = 0;
    CHECK(waitpid(child, &status, 0) == child);
    return status;
}

TEST(a_programme_without_standard_input_saves_and_loads)
{
    const char *where = folder("no_input"), *path = in(where, "a");
    put(path, "old");
    const int status = status_without_input(path);
    CHECK(WIFEXITED(status) && (WEXITSTATUS(status) == 7 || WEXITSTATUS(status) == 8));
    CHECK(holds(path, WEXITSTATUS(status) == 7 ? "new" : "old"));
    CHECK_INT(entry_count(where), 1);
}

/* The names of temporary files that a save opened, one after the other. */
static char opened_names[4][300];
static int opened_count;

static int noting_open(const char *path, int flags, mode_t mode)
{
    if (flags & O_EXCL && opened_count < COUNT(opened_names)) {
        snprintf(opened_names[opened_count], sizeof opened_names[0], "%s", path);
        opened_count++;
    }
    return real_system.open(path, flags, mode);
}

TEST(a_temporary_name_ends_with_six_letters_or_digits_of_its_own)
{
    const char *where = folder("suffix"), *path = in(where, "a");
    static const char letters[] = "0123456789abcdefghijklmnopqrstuvwxyz";
    real_system = bat_system;
    bat_system.open = noting_open;
    opened_count = 0;
    for (int i = 0; i < COUNT(opened_names); i++)
        save(path, "text");
    uninstall();
    int kinds[sizeof letters] = {0}, different = 0;
    for (int i = 0; i < opened_count; i++) {
        const char *name = strstr(opened_names[i], "/.a.");
        CHECK(name && strspn(name + 4, letters) == 6);
        CHECK_TEXT(name + 10, ".batten-tmp");
        for (int k = 0; k < 6; k++)
            different += kinds[strchr(letters, name[4 + k]) - letters]++ == 0;
    }
    CHECK(different >= (opened_count == COUNT(opened_names) ? 7 : 0));
}
