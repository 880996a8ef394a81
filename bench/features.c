/*
 * What a feature costs: `batten-bench-features DESIGN` makes the last feature of a design, or its
 * last output where it has outputs, inside of `bench_measured`, after all that it needs. bench/features
 * runs it with many designs, and compares with the C function behind the feature. With `-j THREADS` the
 * feature is made under a job, and what is printed is its time, the longest time for which the job was
 * not asked whether to cancel, after what that was, and how often it was asked and told of progress.
 */
#define _POSIX_C_SOURCE 200809L
#include <batten/design.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "bench: %s\n", batten_message());
    exit(1);
}

/* ---- what a job hears ---- */

typedef struct {
    clockid_t clock; /* of the process where it has one thread, so that other work does not count */
    double last, longest;
    long asked, told;
    char at[80], longest_at[80];
} watcher;

static double seconds(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void note_gap(watcher *w)
{
    const double now = seconds(w->clock);
    if (now - w->last > w->longest) {
        w->longest = now - w->last;
        memcpy(w->longest_at, w->at, sizeof w->at);
    }
    w->last = now;
}

static bool hear_question(void *user)
{
    watcher *w = user;
    w->asked++;
    note_gap(w);
    return false;
}

static void hear_progress(void *user, double fraction, const char *what)
{
    watcher *w = user;
    w->told++;
    snprintf(w->at, sizeof w->at, "%.40s at %.0f %%", what, 100 * fraction);
}

/* ---- the feature ---- */

/* Not static, and called by a pointer: callgrind finds it by its name. */
void bench_measured(batten_design *design, const char *feature, const batten_job *job);

void bench_measured(batten_design *design, const char *feature, const batten_job *job)
{
    char *data = NULL;
    size_t size = 0;
    if (feature)
        must(batten_design_evaluate(design, feature, job, NULL));
    else
        must(batten_design_output(design, batten_design_output_count(design) - 1, job, NULL,
                                  &data, &size));
    batten_release(data);
}

static void watch(batten_design *design, const char *feature, int thread_count)
{
    watcher w = {.clock = thread_count == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC,
                 .at = "the beginning"};
    const batten_job job = {.size = sizeof job,
                            .thread_count = thread_count,
                            .is_cancelled = hear_question,
                            .progress = hear_progress,
                            .user = &w};
    const double begin = w.last = seconds(w.clock);
    bench_measured(design, feature, &job);
    note_gap(&w);
    printf("%.3f\t%.3f\t%s\t%ld\t%ld\n", w.last - begin, w.longest, w.longest_at, w.asked,
           w.told);
}

int main(int count, char **arguments)
{
    const bool is_watched = count == 4 && strcmp(arguments[1], "-j") == 0;
    /* The feature that is measured bears this name, and what it needs is made by the one before. */
    static const char needed[] = "needed", measured[] = "measured";
    void (*volatile measure)(batten_design *, const char *, const batten_job *) = bench_measured;
    batten_design *design = NULL;
    if (count != 2 && !is_watched) {
        fputs("usage: batten-bench-features [-j THREADS] DESIGN\n", stderr);
        return 2;
    }
    must(batten_design_open(arguments[count - 1], false, NULL, &design));
    const bool has_output = batten_design_output_count(design) > 0;
    if (batten_design_evaluate(design, needed, NULL, NULL) != BATTEN_NOT_FOUND)
        must(batten_design_evaluate(design, needed, NULL, NULL));
    if (is_watched)
        watch(design, has_output ? NULL : measured, atoi(arguments[2]));
    else
        measure(design, has_output ? NULL : measured, NULL);
    batten_design_free(design);
    return 0;
}
