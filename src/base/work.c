/*
 * Loops over independent pieces on several threads, progress and cancellation by the caller,
 * and pairwise summation. None of the results depends on the number of threads.
 */
#include "base/work.h"
#include "base/system.h"

#include <stdio.h>
#include <string.h>

/* ---- chunks on threads ---- */

enum { MOST_THREADS = 64 };

/* What the threads of one call share. */
typedef struct {
    const batten_job *job;
    size_t count, size, piece_count;
    bat_chunk chunk;
    void *context;
    atomic_size_t next;  /* the first piece that nobody has taken */
    atomic_bool stopped; /* a piece failed, or the caller cancelled */
    atomic_flag lock;
    size_t failed; /* the first piece that failed, and its failure */
    batten_status status;
    char message[1024];
    /* Of long items: what each thread obeys, the caller's and the others. */
    bat_long_chunk long_chunk;
    const char *what;
    batten_job asking, listening;
    atomic_bool cancelled; /* the caller has said so */
    atomic_size_t ended;   /* items */
    atomic_int helpers_at_work;
} crew;

/* Held for the few instructions in which a failure is noted. */
static void lock_failure(crew *all)
{
    while (atomic_flag_test_and_set_explicit(&all->lock, memory_order_acquire))
        continue;
}

static void keep_failure(crew *all, size_t piece, batten_status status)
{
    lock_failure(all);
    if (all->status == BATTEN_OK || piece < all->failed) {
        all->status = status;
        all->failed = piece;
        snprintf(all->message, sizeof all->message, "%s", batten_message());
    }
    atomic_flag_clear_explicit(&all->lock, memory_order_release);
    atomic_store(&all->stopped, true);
}

/* ---- long items ---- */

static bool ask_caller(void *user)
{
    crew *all = user;
    if (all->job->is_cancelled && all->job->is_cancelled(all->job->user))
        atomic_store(&all->cancelled, true);
    return atomic_load(&all->cancelled);
}

static bool hear_caller(void *user)
{
    crew *all = user;
    return atomic_load(&all->cancelled);
}

static void tell_progress(const crew *all)
{
    if (all->what && all->job->progress)
        all->job->progress(all->job->user,
                           (double)atomic_load(&all->ended) / (double)all->piece_count,
                           all->what);
}

static batten_status work_piece(crew *all, size_t begin, size_t end, bool may_ask)
{
    if (!all->long_chunk)
        return all->chunk(all->context, begin, end);
    const batten_status status =
        all->long_chunk(all->context, may_ask ? &all->asking : &all->listening, begin);
    atomic_fetch_add(&all->ended, 1);
    return status;
}

/* The calling thread has nothing more to do, and goes on asking for the others. */
static void wait_for_items(crew *all)
{
    while (atomic_load(&all->helpers_at_work) > 0) {
        ask_caller(all);
        bat_pause();
    }
    tell_progress(all);
}

/* ---- pieces ---- */

/* Pieces are taken in order, and whoever has one finishes it: so the first that fails is always
 * found. */
static void take_pieces(crew *all, bool may_ask)
{
    while (!atomic_load(&all->stopped)) {
        const size_t piece = atomic_fetch_add(&all->next, 1);
        if (piece >= all->piece_count)
            return;
        const size_t begin = piece * all->size;
        const size_t end = all->count - begin < all->size ? all->count : begin + all->size;
        batten_status status = work_piece(all, begin, end, may_ask);
        if (may_ask)
            tell_progress(all);
        if (status == BATTEN_OK && may_ask && ask_caller(all))
            status = bat_fail(BATTEN_CANCELLED, "cancelled after %zu of %zu pieces", piece + 1,
                              all->piece_count);
        if (status != BATTEN_OK)
            keep_failure(all, piece, status);
    }
}

static void *run_thread(void *user)
{
    crew *all = user;
    take_pieces(all, false);
    atomic_fetch_sub(&all->helpers_at_work, 1);
    return NULL;
}

static int wanted_threads(const batten_job *job, size_t piece_count)
{
    long wanted = job->thread_count;
    if (wanted == 0)
        wanted = bat_processor_count();
    if (wanted > MOST_THREADS)
        wanted = MOST_THREADS;
    if (wanted > 1 && (size_t)wanted > piece_count)
        wanted = (long)piece_count;
    return wanted < 1 ? 1 : (int)wanted;
}

static batten_status work_together(crew *all)
{
    bat_thread threads[MOST_THREADS];
    const int wanted = wanted_threads(all->job, all->piece_count) - 1;
    int helpers = 0;
    atomic_store(&all->helpers_at_work, wanted);
    /* Where the system gives no more threads, those there are do the work. */
    while (helpers < wanted && bat_thread_start(&threads[helpers], run_thread, all))
        helpers++;
    atomic_fetch_sub(&all->helpers_at_work, wanted - helpers);
    take_pieces(all, true);
    if (all->long_chunk)
        wait_for_items(all);
    for (int i = 0; i < helpers; i++)
        bat_thread_wait(threads[i]);
    return all->status == BATTEN_OK ? BATTEN_OK : bat_fail(all->status, "%s", all->message);
}

batten_status bat_parallel(const batten_job *job, size_t count, size_t size, bat_chunk chunk,
                           void *context)
{
    assert(size > 0);
    batten_job chosen = BATTEN_JOB;
    const batten_status taken = BAT_TAKE_OPTIONS(batten_job, job, &chosen);
    if (taken != BATTEN_OK)
        return taken;
    crew all = {.job = &chosen,
                .count = count,
                .size = size,
                .piece_count = count / size + (count % size != 0),
                .chunk = chunk,
                .context = context,
                .lock = ATOMIC_FLAG_INIT};
    return work_together(&all);
}

batten_status bat_parallel_long(const batten_job *job, size_t count, const char *what,
                                bat_long_chunk chunk, void *context)
{
    batten_job chosen = BATTEN_JOB;
    const batten_status taken = BAT_TAKE_OPTIONS(batten_job, job, &chosen);
    if (taken != BATTEN_OK)
        return taken;
    if (count == 1)
        return chunk(context, &chosen, 0);
    crew all = {.job = &chosen,
                .count = count,
                .size = 1,
                .piece_count = count,
                .context = context,
                .lock = ATOMIC_FLAG_INIT,
                .long_chunk = chunk,
                .what = what};
    all.asking = all.listening = BATTEN_JOB;
    all.asking.work_limit = all.listening.work_limit = chosen.work_limit;
    all.asking.is_cancelled = ask_caller;
    all.listening.is_cancelled = hear_caller;
    all.asking.user = all.listening.user = &all;
    return work_together(&all);
}

/* ---- questions to the caller ---- */

batten_status bat_work_step(bat_work *work, uint64_t steps, double fraction, const char *what)
{
    batten_job job = BATTEN_JOB;
    const batten_status taken = BAT_TAKE_OPTIONS(batten_job, work->job, &job);
    if (taken != BATTEN_OK)
        return taken;
    work->steps = work->steps > UINT64_MAX - steps ? UINT64_MAX : work->steps + steps;
    if (job.work_limit > 0 && work->steps > job.work_limit)
        return bat_fail(BATTEN_INCOMPLETE,
                        "%s: stopped at %.0f %% after %llu of %llu steps allowed", what,
                        100 * fraction, (unsigned long long)work->steps,
                        (unsigned long long)job.work_limit);
    if (job.is_cancelled && job.is_cancelled(job.user))
        return bat_fail(BATTEN_CANCELLED, "%s: cancelled at %.0f %%", what, 100 * fraction);
    if (job.progress)
        job.progress(job.user, fraction, what);
    return BATTEN_OK;
}

/* ---- stages ---- */

static bool stage_cancelled(void *user)
{
    const bat_stage *stage = user;
    return stage->whole.is_cancelled(stage->whole.user);
}

static void stage_progress(void *user, double fraction, const char *what)
{
    const bat_stage *stage = user;
    stage->whole.progress(stage->whole.user, stage->begin + stage->share * fraction, what);
}

batten_status bat_stage_begin(const batten_job *job, double begin, double share,
                              bat_stage *stage, batten_job *out)
{
    *stage = (bat_stage){BATTEN_JOB, begin, share};
    const batten_status taken = BAT_TAKE_OPTIONS(batten_job, job, &stage->whole);
    if (taken != BATTEN_OK)
        return taken;
    *out = stage->whole;
    out->user = stage;
    out->is_cancelled = stage->whole.is_cancelled ? stage_cancelled : NULL;
    out->progress = stage->whole.progress ? stage_progress : NULL;
    return BATTEN_OK;
}

/* ---- sums ---- */

/* A binary tree over blocks of 32, walked from left to right: `partial` holds the sums of the
 * whole subtrees so far, one for each bit of the count of blocks. */
double bat_sum(const double *values, size_t count, size_t stride)
{
    enum { BLOCK = 32 };
    double partial[64];
    int depth = 0;
    for (size_t first = 0, blocks = 0; first < count; first += BLOCK, blocks++) {
        const size_t last = count - first < BLOCK ? count : first + BLOCK;
        double sum = 0;
        for (size_t i = first; i < last; i++)
            sum += values[i * stride];
        for (size_t bits = blocks; bits & 1; bits >>= 1)
            sum = partial[--depth] + sum;
        partial[depth++] = sum;
    }
    double sum = depth > 0 ? partial[--depth] : 0;
    while (depth > 0)
        sum = partial[--depth] + sum;
    return sum;
}
