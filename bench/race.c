/*
 * Contestants as processes. Each obeys letters that come through a pipe: o makes ready, r runs and answers with the CPU time,
 * g lays the result into memory that all share, q ends it.
 */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE
#include "race.h"

#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

/* A sample is the mean of the runs of so many seconds, an entry is asked for samples until it has used up its share of CPU,
 * or thrice when that takes less than the most. */
static const double sample_seconds = 0.02, share_seconds = 0.7, most_seconds = 10;

enum { MOST_RUNS_OF_SAMPLE = 1 << 20 };

typedef struct {
    race_result result;
    pid_t process;
    int ask, answer; /* pipes */
    double *shown;   /* shared: what g lays down */
    double used;
} contestant;

/* ---- inside of a contestant's process ---- */

static double seconds_of(clockid_t clock)
{
    struct timespec now;
    return clock_gettime(clock, &now) == 0 ? (double)now.tv_sec + 1e-9 * (double)now.tv_nsec
                                           : 0;
}

static double timed_run(const bench_entry *entry, void *object)
{
    const double start = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    entry->run(object);
    return entry->seconds ? entry->seconds(object)
                          : seconds_of(CLOCK_PROCESS_CPUTIME_ID) - start;
}

/* The mean, for the clock of a process may jump by more than a short run takes. */
static double sample_time(const bench_entry *entry, void *object)
{
    double sum = 0;
    int count = 0;
    do {
        sum += timed_run(entry, object);
        count++;
    } while (sum < sample_seconds && count < MOST_RUNS_OF_SAMPLE);
    return sum / count;
}

static double peak_megabytes(void)
{
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    return (double)used.ru_maxrss / 1024;
}

/* By how many megabytes the work raises the peak of a process that has nothing left over; 0 when it fails. */
static double sample_memory(const bench_entry *entry, void *object)
{
    int ends[2];
    double grown = 0;
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    if (pipe(ends) != 0)
        return 0;
    const pid_t child = fork();
    if (child == 0) {
        const double before = peak_megabytes();
        entry->run(object);
        grown = peak_megabytes() - before;
        _exit(write(ends[1], &grown, sizeof grown) != (ssize_t)sizeof grown);
    }
    close(ends[1]);
    if (read(ends[0], &grown, sizeof grown) != (ssize_t)sizeof grown)
        grown = 0;
    close(ends[0]);
    waitpid(child, NULL, 0);
    return grown;
}

static void obey(const bench_work *work, const bench_entry *entry, double *shown, int ask,
                 int answer)
{
    void *object = NULL;
    char letter;
#ifdef __GLIBC__
    /* Freed memory is kept, else page faults on results of a megabyte drown the work. */
    if (!work->of_memory) {
        mallopt(M_MMAP_THRESHOLD, 1 << 25);
        mallopt(M_TRIM_THRESHOLD, 1 << 30);
    }
#endif
    while (read(ask, &letter, 1) == 1 && letter != 'q') {
        double reply = 1;
        if (letter == 'o')
            reply = (object = entry->open(work)) != NULL;
        else if (letter == 'g')
            entry->gather(object, shown);
        else if (work->of_memory)
            reply = sample_memory(entry, object);
        else
            reply = sample_time(entry, object);
        if (write(answer, &reply, sizeof reply) != (ssize_t)sizeof reply)
            _exit(1);
    }
    if (object)
        entry->close(object);
    _exit(0);
}

/* ---- from outside ---- */

static bool start_contestant(contestant *c, const bench_work *work)
{
    const size_t size = work->result_count * sizeof *c->shown;
    int there[2], back[2];
    c->shown = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (c->shown == MAP_FAILED || pipe(there) != 0 || pipe(back) != 0)
        return false;
    fflush(NULL);
    c->process = fork();
    if (c->process == 0) {
        setpgid(0, 0);
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        close(there[1]);
        close(back[0]);
        obey(work, c->result.entry, c->shown, there[0], back[1]);
    }
    if (c->process > 0)
        setpgid(c->process, c->process);
    close(there[0]);
    close(back[1]);
    c->ask = there[1];
    c->answer = back[0];
    return c->process > 0;
}

static void end_contestant(contestant *c)
{
    int status = 0;
    if (c->process <= 0)
        return;
    if (c->result.state == RACE_SLOW || write(c->ask, "q", 1) != 1)
        kill(-c->process, SIGKILL);
    close(c->ask);
    waitpid(c->process, &status, 0);
    if (c->result.state == RACE_FAILED && WIFSIGNALED(status))
        c->result.signal = WTERMSIG(status);
    close(c->answer);
    c->process = 0;
}

/* An answer comes before its process has worked for so many seconds. One that sleeps, or works in a process of its own, has
 * four times as long by the clock on the wall: others may share the machine. */
static bool answers_within(const contestant *c, double limit)
{
    const int slice = 100; /* milliseconds */
    const double begin = seconds_of(CLOCK_MONOTONIC);
    struct pollfd ready = {c->answer, POLLIN, 0};
    clockid_t clock;
    const bool has_clock = clock_getcpuclockid(c->process, &clock) == 0;
    const double worked = has_clock ? seconds_of(clock) : 0;
    while (poll(&ready, 1, slice) == 0)
        if ((has_clock && seconds_of(clock) - worked > limit) ||
            seconds_of(CLOCK_MONOTONIC) - begin > 4 * limit)
            return false;
    return true;
}

/* Its answer to a letter; when there is none within the limit, or never will be, it is out. */
static bool ask(contestant *c, char letter, double limit, double *reply)
{
    if (c->result.state != RACE_TIMED)
        return false;
    if (write(c->ask, &letter, 1) != 1)
        c->result.state = RACE_FAILED;
    else if (!answers_within(c, limit))
        c->result.state = RACE_SLOW;
    else if (read(c->answer, reply, sizeof *reply) != (ssize_t)sizeof *reply)
        c->result.state = RACE_FAILED;
    if (c->result.state != RACE_TIMED)
        end_contestant(c);
    return c->result.state == RACE_TIMED;
}

/* Ready, run once, and shown; what has nothing for the row is out. Memory is measured in processes of their own, which show
 * nothing: the row of the same work in time does. */
static void prepare(contestant *c, const bench_work *work, double limit)
{
    double reply = 0;
    c->result.state = RACE_TIMED;
    if (!start_contestant(c, work))
        c->result.state = RACE_FAILED;
    else if (ask(c, 'o', limit, &reply) && reply == 0) {
        c->result.state = RACE_ABSENT;
        end_contestant(c);
    } else if (!work->of_memory && ask(c, 'r', limit, &reply))
        ask(c, 'g', limit, &reply);
}

static double distance(const bench_work *work, const double *expected, const double *result)
{
    double worst = 0;
    for (size_t i = 0; i < work->result_count; i++) {
        const double scale = work->is_relative ? fmax(fabs(expected[i]), 0x1p-1000) : 1;
        worst =
            fmax(worst, isfinite(result[i]) ? fabs(result[i] - expected[i]) / scale : INFINITY);
    }
    return worst;
}

/* All are compared with what the data say, or where they do not, with the first that has a result. */
static void compare_results(contestant *all, int count, const bench_work *work)
{
    const double *expected = work->truth;
    for (int i = 0; i < count; i++) {
        contestant *c = &all[i];
        if (c->result.state != RACE_TIMED || work->of_memory)
            continue;
        if (!expected)
            expected = c->shown;
        c->result.off = distance(work, expected, c->shown);
        if (!(c->result.off <= work->within))
            c->result.state = RACE_DIFFERS;
    }
}

static bool wants_more(const contestant *c, const bench_work *work)
{
    if (c->result.state != RACE_TIMED || c->result.count >= RACE_MOST_RUNS)
        return false;
    if (work->of_memory)
        return c->result.count == 0;
    return c->used < share_seconds || (c->result.count < 3 && c->used < most_seconds);
}

/* In turns, so that what slows the machine slows all. */
static void take_times(contestant *all, int count, const bench_work *work, double limit)
{
    bool is_going = true;
    while (is_going) {
        is_going = false;
        for (int i = 0; i < count; i++) {
            contestant *c = &all[i];
            if (!wants_more(c, work) || !ask(c, 'r', limit, &c->result.times[c->result.count]))
                continue;
            c->used += fmax(c->result.times[c->result.count++], sample_seconds);
            is_going = true;
        }
    }
}

static int compare_times(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(const double *numbers, int count)
{
    double sorted[RACE_MOST_RUNS];
    memcpy(sorted, numbers, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, compare_times);
    return sorted[count / 2];
}

static void finish(contestant *c, const bench_work *work)
{
    race_result *r = &c->result;
    end_contestant(c);
    if (c->shown != MAP_FAILED)
        munmap(c->shown, work->result_count * sizeof *c->shown);
    if (r->count == 0)
        return;
    r->median = median(r->times, r->count);
    r->best = r->times[0];
    for (int i = 1; i < r->count; i++)
        r->best = fmin(r->best, r->times[i]);
}

double race_ratio(const race_result *first, const race_result *second)
{
    double ratios[RACE_MOST_RUNS];
    const int count = first->count < second->count ? first->count : second->count;
    for (int i = 0; i < count; i++)
        ratios[i] = second->times[i] / first->times[i];
    return count > 0 ? median(ratios, count) : 0;
}

int race_run(const bench_work *work, const bench_peer *peers, int peer_count, double limit,
             int most, race_result *results)
{
    contestant *all = calloc((size_t)most, sizeof *all);
    int count = 0;
    signal(SIGPIPE, SIG_IGN);
    for (int p = 0; all && p < peer_count; p++)
        for (const bench_entry *e = peers[p].entries; e && e->way && count < most; e++) {
            if (e->kind != work->kind)
                continue;
            all[count].result.entry = e;
            all[count].result.peer = p;
            prepare(&all[count++], work, limit);
        }
    compare_results(all, count, work);
    take_times(all, count, work, limit);
    for (int i = 0; i < count; i++) {
        finish(&all[i], work);
        results[i] = all[i].result;
    }
    free(all);
    return count;
}

const race_result *race_best(const race_result *results, int count, int first_peer,
                             int last_peer)
{
    const race_result *best = NULL;
    for (int i = 0; i < count; i++) {
        const race_result *r = &results[i];
        const bool is_meant = r->peer >= first_peer && r->peer <= last_peer;
        if (is_meant && r->state == RACE_TIMED && (!best || r->median < best->median))
            best = r;
    }
    return best;
}
