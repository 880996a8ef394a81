#include "base/work.h"
#include "base/system.h"

#include "support/test.h"

enum { COUNT_ITEMS = 1003 };

static batten_status fill(void *context, size_t begin, size_t end)
{
    double *values = context, sum = 0;
    for (size_t i = begin; i < end; i++) {
        sum += sin((double)i);
        values[i] = sum;
    }
    return BATTEN_OK;
}

TEST(T1_any_number_of_threads_gives_the_same_bits)
{
    double alone[COUNT_ITEMS], many[COUNT_ITEMS];
    CHECK_OK(bat_parallel(NULL, COUNT_ITEMS, 10, fill, alone));
    for (int threads = 0; threads <= 100; threads = threads < 4 ? threads + 1 : threads * 5) {
        memset(many, 0, sizeof many);
        batten_job job = BATTEN_JOB;
        job.thread_count = threads;
        CHECK_OK(bat_parallel(&job, COUNT_ITEMS, 10, fill, many));
        CHECK(memcmp(alone, many, sizeof alone) == 0);
    }
}

TEST(no_items_are_no_work)
{
    CHECK_OK(bat_parallel(NULL, 0, 10, fill, NULL));
    double one = 7;
    batten_job job = BATTEN_JOB;
    job.thread_count = 4;
    CHECK_OK(bat_parallel(&job, 1, 10, fill, &one));
    CHECK_BITS(one, 0);
}

static batten_status fail_late(void *context, size_t begin, size_t end)
{
    (void)context, (void)end;
    return begin >= 300 ? bat_fail(BATTEN_NOT_FINITE, "item %d is bad", (int)begin) : BATTEN_OK;
}

TEST(the_first_failing_piece_speaks_in_the_calling_thread)
{
    for (int threads = 1; threads <= 4; threads++) {
        batten_job job = BATTEN_JOB;
        job.thread_count = threads;
        bat_fail(BATTEN_OK, "nothing yet");
        CHECK_STATUS(bat_parallel(&job, COUNT_ITEMS, 10, fail_late, NULL), BATTEN_NOT_FINITE);
        CHECK_TEXT(batten_message(), "item 300 is bad");
    }
}

static int threads_left;

static bool (*real_start)(bat_thread *thread, bat_thread_body body, void *user);

static bool scarce_threads(bat_thread *thread, bat_thread_body body, void *user)
{
    return threads_left-- > 0 && real_start(thread, body, user);
}

TEST(where_threads_are_scarce_fewer_do_the_work)
{
    double alone[COUNT_ITEMS], few[COUNT_ITEMS];
    CHECK_OK(bat_parallel(NULL, COUNT_ITEMS, 10, fill, alone));
    real_start = bat_thread_start;
    for (int given = 0; given < 3; given++) {
        threads_left = given;
        bat_thread_start = scarce_threads;
        batten_job job = BATTEN_JOB;
        job.thread_count = 8;
        const batten_status status = bat_parallel(&job, COUNT_ITEMS, 10, fill, few);
        bat_thread_start = real_start;
        CHECK_INT(status, BATTEN_OK);
        CHECK(memcmp(alone, few, sizeof alone) == 0);
    }
}

/* A caller who counts the questions and says yes at the last. */
typedef struct {
    int questions, yes_at, reports;
    double fraction;
} caller;

static bool is_cancelled(void *user)
{
    caller *c = user;
    return ++c->questions == c->yes_at;
}

static void progress(void *user, double fraction, const char *what)
{
    caller *c = user;
    c->reports++;
    c->fraction = fraction;
    CHECK_TEXT(what, "fairing");
}

TEST(I8_cancelling_stops_the_pieces)
{
    double values[COUNT_ITEMS];
    for (int threads = 1; threads <= 3; threads++) {
        caller c = {.yes_at = 1};
        batten_job job = BATTEN_JOB;
        job.thread_count = threads;
        job.is_cancelled = is_cancelled;
        job.user = &c;
        const batten_status status = bat_parallel(&job, COUNT_ITEMS, 10, fill, values);
        /* The helpers may have taken every piece before the caller could be asked. */
        CHECK(status == BATTEN_CANCELLED || (threads > 1 && c.questions == 0));
    }
    CHECK_MESSAGE("cancelled after");
}

/* Ends when the job says so, which each item asks for itself. */
static batten_status wait_for_cancelling(void *context, const batten_job *job, size_t index)
{
    (void)context;
    CHECK_INT(job->thread_count, 1);
    while (!job->is_cancelled(job->user))
        bat_pause();
    return bat_fail(BATTEN_CANCELLED, "item %d stopped", (int)index);
}

static batten_status square(void *context, const batten_job *job, size_t index)
{
    (void)job;
    ((double *)context)[index] = (double)(index * index);
    return BATTEN_OK;
}

TEST(I8_long_items_hear_at_once_that_the_caller_cancelled)
{
    for (int threads = 1; threads <= 3; threads++) {
        caller c = {.yes_at = 5};
        batten_job job = BATTEN_JOB;
        job.thread_count = threads;
        job.is_cancelled = is_cancelled;
        job.user = &c;
        CHECK_STATUS(bat_parallel_long(&job, 4, "fairing", wait_for_cancelling, NULL),
                     BATTEN_CANCELLED);
    }
}

TEST(long_items_are_all_done_and_their_progress_is_told)
{
    for (int threads = 0; threads <= 4; threads++) {
        double squares[100] = {0};
        caller c = {.yes_at = -1};
        batten_job job = BATTEN_JOB;
        job.thread_count = threads;
        job.progress = progress;
        job.user = &c;
        CHECK_OK(bat_parallel_long(&job, 100, "fairing", square, squares));
        for (int i = 0; i < 100; i++)
            CHECK_BITS(squares[i], i * i);
        CHECK_BITS(c.fraction, 1);
    }
}

TEST(I8_steps_are_counted_reported_and_cancelled)
{
    caller c = {.yes_at = 3};
    batten_job job = BATTEN_JOB;
    job.is_cancelled = is_cancelled;
    job.progress = progress;
    job.user = &c;
    bat_work work = {&job, 0};
    CHECK_OK(bat_work_step(&work, 10, 0.25, "fairing"));
    CHECK_OK(bat_work_step(&work, 10, 0.5, "fairing"));
    CHECK_STATUS(bat_work_step(&work, 10, 0.75, "fairing"), BATTEN_CANCELLED);
    CHECK_MESSAGE("fairing: cancelled at 75 %");
    CHECK_INT(c.reports, 2);
    CHECK_BITS(c.fraction, 0.5);
}

TEST(a_limit_of_work_ends_incomplete)
{
    batten_job job = BATTEN_JOB;
    job.work_limit = 25;
    bat_work work = {&job, 0};
    CHECK_OK(bat_work_step(&work, 25, 0.1, "search"));
    CHECK_STATUS(bat_work_step(&work, 1, 0.2, "search"), BATTEN_INCOMPLETE);
    CHECK_MESSAGE("26 of 25 steps");
    work.steps = UINT64_MAX - 1;
    CHECK_STATUS(bat_work_step(&work, 7, 0.2, "search"), BATTEN_INCOMPLETE);
    bat_work free_work = {NULL, 0};
    CHECK_OK(bat_work_step(&free_work, 1000, 0, "search"));
}

TEST(pairwise_sums_round_less_than_plain_ones)
{
    enum { N = 1000000 };
    double *values = test_array(N, sizeof *values);
    for (int i = 0; i < N; i++)
        values[i] = 0.1;
    /* 5 roundings in a block and 15 levels above, against a million. */
    CHECK_NEAR(bat_sum(values, N, 1) / 100000, 1, 40 * DBL_EPSILON);
    for (int i = 0; i < N; i++)
        values[i] = i;
    for (int count = 0; count <= 200; count++)
        CHECK_BITS(bat_sum(values, (size_t)count, 1), count * (count - 1) / 2);
    CHECK_BITS(bat_sum(values, 100, 3), 3 * 99 * 50);
}

/* ---- the size of a job ---- */

TEST(a_job_whose_size_nobody_set_or_that_is_longer_than_ours_is_refused)
{
    static const size_t sizes[] = {0, sizeof(size_t) - 1, sizeof(batten_job) + 1, SIZE_MAX};
    double values[COUNT_ITEMS];
    for (int k = 0; k < COUNT(sizes); k++) {
        batten_job job = BATTEN_JOB;
        bat_work work = {&job, 0};
        job.size = sizes[k];
        CHECK_STATUS(bat_parallel(&job, COUNT_ITEMS, 10, fill, values), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the size in a batten_job is");
        CHECK_STATUS(bat_work_step(&work, 1, 0.5, "fairing"), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the size in a batten_job is");
    }
}

/* What stands beyond the size that an older caller gave is no callback. */
TEST(a_shorter_job_is_one_thread_and_asks_nothing)
{
    double values[COUNT_ITEMS];
    for (size_t size = sizeof size; size < sizeof(batten_job); size += sizeof size) {
        unsigned char bytes[sizeof(batten_job)];
        batten_job job = BATTEN_JOB;
        memset(bytes, 0xA5, sizeof bytes);
        job.size = size;
        memcpy(bytes, &job, size);
        memcpy(&job, bytes, sizeof job);
        bat_work work = {&job, 0};
        CHECK_OK(bat_parallel(&job, COUNT_ITEMS, 10, fill, values));
        CHECK_OK(bat_work_step(&work, 1, 0.5, "fairing"));
    }
}
