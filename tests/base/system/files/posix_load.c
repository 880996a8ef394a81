/* Loading a file whole. */
#define _XOPEN_SOURCE 700
#include "base/system/files/posix_file.h"

#include "base/system/files/scratch.h"
#include <pthread.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

TEST(S1_a_file_above_the_limit_is_refused)
{
    const char *path = in(folder("limit"), "a");
    put(path, "12345");
    char *data = NULL;
    size_t size = 77;
    CHECK_STATUS(batten_load_file(path, 4, &data, &size), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("more than the 4 bytes");
    CHECK_STATUS(batten_load_file("/dev/zero", 100000, &data, &size), BATTEN_TOO_LARGE);
    CHECK(data == NULL && size == 77);
    CHECK_OK(batten_load_file(path, 5, &data, &size));
    batten_release(data);
}

static void check_load_refused(const char *path, const char *reason)
{
    char *data = NULL;
    size_t size = 77;
    CHECK_STATUS(batten_load_file(path, 100, &data, &size), BATTEN_FILE_ERROR);
    CHECK_MESSAGE(path);
    CHECK_MESSAGE(reason);
    CHECK(data == NULL && size == 77);
}

TEST(F1_what_is_no_file_is_refused_with_the_reason_in_words)
{
    const char *where = folder("nofile");
    check_load_refused(where, "Is a directory");
    check_load_refused(in(where, "absent"), "No such file or directory");
    check_load_refused("", "No such file or directory");
    const char *closed = in(where, "closed");
    put(closed, "secret");
    CHECK(chmod(closed, 0) == 0);
    if (geteuid() != 0)
        check_load_refused(closed, "Permission denied");
    check_loads("/dev/null", "");
}

TEST(F1_a_pipe_that_nobody_writes_into_is_not_waited_for)
{
    const char *pipe = in(folder("fifo"), "pipe");
    CHECK(mkfifo(pipe, 0600) == 0 || errno == EEXIST);
    check_load_refused(pipe, "nobody writes");
    CHECK_STATUS(save(pipe, "text"), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("No such device");
}

static void pause_briefly(void)
{
    nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
}

static void *write_slowly(void *user)
{
    const int file = *(const int *)user;
    pause_briefly();
    if (write(file, "slow", 4) == 4)
        pause_briefly();
    if (write(file, "ly", 2) == 2)
        close(file);
    return NULL;
}

TEST(a_pipe_is_read_at_the_pace_of_its_writer)
{
    int ends[2];
    CHECK(pipe(ends) == 0);
    char path[40];
    snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
    if (access(path, R_OK) != 0)
        SKIP("there is no /dev/fd");
    pthread_t thread;
    CHECK(pthread_create(&thread, NULL, write_slowly, &ends[1]) == 0);
    char *data = NULL;
    size_t size = 0;
    const batten_status status = batten_load_file(path, 100, &data, &size);
    pthread_join(thread, NULL);
    close(ends[0]);
    if (status == BATTEN_OK) {
        CHECK_TEXT(data, "slowly");
        batten_release(data);
    }
    CHECK(status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY);
}

TEST(a_pipe_of_any_length_is_read_to_its_end)
{
    static const size_t sizes[] = {1, 4095, 4096, 4097, 8192, 20000};
    for (int i = 0; i < COUNT(sizes); i++) {
        int ends[2];
        char path[40], text[20000], *data = NULL;
        size_t size = 0;
        CHECK(pipe(ends) == 0);
        snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
        if (access(path, R_OK) != 0)
            SKIP("there is no /dev/fd");
        for (size_t k = 0; k < sizes[i]; k++)
            text[k] = (char)('a' + k % 23);
        CHECK(write(ends[1], text, sizes[i]) == (ssize_t)sizes[i]);
        close(ends[1]);
        const batten_status status = batten_load_file(path, 20000, &data, &size);
        close(ends[0]);
        CHECK(status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY);
        if (status != BATTEN_OK)
            continue;
        CHECK(size == sizes[i] && memcmp(data, text, size) == 0 && data[size] == 0);
        batten_release(data);
    }
}

TEST(S1_the_limit_itself_is_allowed_and_one_more_is_not)
{
    static const struct {
        const char *text;
        size_t limit;
        batten_status status;
    } rows[] = {{"", 0, BATTEN_OK},
                {"a", 0, BATTEN_TOO_LARGE},
                {"abc", 3, BATTEN_OK},
                {"abcd", 3, BATTEN_TOO_LARGE},
                {"abc", SIZE_MAX, BATTEN_OK}};
    const char *path = in(folder("bounds"), "a");
    for (int i = 0; i < COUNT(rows); i++) {
        char *data = NULL;
        size_t size = 77;
        put(path, rows[i].text);
        CHECK_STATUS(batten_load_file(path, rows[i].limit, &data, &size), rows[i].status);
        CHECK(rows[i].status == BATTEN_OK ? size == strlen(rows[i].text) : size == 77 && !data);
        batten_release(data);
    }
}

TEST(a_file_that_is_not_open_has_no_writer_to_wait_for)
{
    CHECK_STATUS(bat_file_wait_for_writer(-1, "hull.step"), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("hull.step");
}

enum { LARGE_PAGE = 2 << 20 };

/* What was wished for since the last load began. */
static struct {
    int count;
    char *from;
    size_t size;
} wished;

static void note_wish(void *from, size_t size)
{
    wished.count++;
    wished.from = from;
    wished.size = size;
}

TEST(large_pages_are_wished_for_wherever_a_whole_one_lies_within_the_file)
{
    static const int sizes[] = {1, LARGE_PAGE / 2, 2 * LARGE_PAGE, 5 * LARGE_PAGE + 12345};
    const char *path = in(folder("large_pages"), "a");
    const bat_file_calls real = bat_system;
    for (int i = 0; i < COUNT(sizes); i++) {
        char *data = NULL;
        size_t size = 0;
        put(path, "x");
        CHECK(truncate(path, sizes[i]) == 0);
        wished.count = 0;
        bat_system.prefer_large_pages = note_wish;
        const batten_status status = batten_load_file(path, SIZE_MAX, &data, &size);
        bat_system = real;
        CHECK(status == BATTEN_OUT_OF_MEMORY || wished.count == (sizes[i] > LARGE_PAGE));
        if (status == BATTEN_OK && wished.count > 0) {
            CHECK_INT((uintptr_t)wished.from % LARGE_PAGE, 0);
            CHECK_INT(wished.size % LARGE_PAGE, 0);
            CHECK(wished.from >= data && wished.from - data < LARGE_PAGE);
            /* There is room for one byte more than the file has. */
            const ptrdiff_t left = data + size + 1 - (wished.from + wished.size);
            CHECK(left >= 0 && left < LARGE_PAGE);
        }
        batten_release(data);
    }
}

static size_t most_asked;

static ssize_t noting_read(int file, void *bytes, size_t size)
{
    most_asked = size > most_asked ? size : most_asked;
    return read(file, bytes, size);
}

/* However long a pipe is, there is room for one byte beyond the limit at most. */
TEST(S1_no_more_is_asked_for_than_one_byte_beyond_the_limit)
{
    const bat_file_calls real = bat_system;
    for (size_t limit = 10; limit < 20000; limit *= 30) {
        char *data = NULL;
        size_t size = 77;
        most_asked = 0;
        bat_system.read = noting_read;
        CHECK_STATUS(batten_load_file("/dev/zero", limit, &data, &size), BATTEN_TOO_LARGE);
        bat_system = real;
        CHECK(most_asked > 0 && most_asked <= limit + 1);
        CHECK(data == NULL && size == 77);
    }
}
