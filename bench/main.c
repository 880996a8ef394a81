/* Runs the rows: `batten-bench [part of a name ...]`, a table on standard output; `-t FILE`
 * also as TSV. */
#define _XOPEN_SOURCE 700
#include "exchange.h"

#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MOST_RUNS = 15, PEERS = 4 };

/* A row: a name that says what goes in, and what of bench_work it sets. */
#define BENCH(text, ...)          \
    {                             \
        .name = text, __VA_ARGS__ \
    }

static const bench_work rows[] = {
    BENCH("curve, sorted", .kind = CURVE_POINTS, .count = 1000000, .unit = "ns"),
    BENCH("curve, random", .kind = CURVE_POINTS, .random = true, .count = 1000000,
          .unit = "ns"),
    BENCH("curve + 2 derivatives, sorted", .kind = CURVE_POINTS, .order = 2, .count = 1000000,
          .unit = "ns"),
    BENCH("curve + 2 derivatives, random", .kind = CURVE_POINTS, .order = 2, .random = true,
          .count = 1000000, .unit = "ns"),
    BENCH("rational curve, sorted", .kind = CURVE_POINTS, .rational = true, .count = 1000000,
          .unit = "ns"),
    BENCH("rational curve, random", .kind = CURVE_POINTS, .rational = true, .random = true,
          .count = 1000000, .unit = "ns"),
    BENCH("curve, one call a point, random", .kind = CURVE_SINGLE, .random = true,
          .count = 1000000, .unit = "ns"),
    BENCH("surface grid", .kind = SURFACE_GRID, .count = 1000, .unit = "ns"),
    BENCH("surface grid + unit normal", .kind = SURFACE_GRID, .order = 1, .count = 1000,
          .unit = "ns"),
    BENCH("surface, random", .kind = SURFACE_POINTS, .count = 1000000, .unit = "ns"),
    BENCH("surface + unit normal, random", .kind = SURFACE_POINTS, .order = 1, .count = 1000000,
          .unit = "ns"),
    BENCH("surface, one call a point, random", .kind = SURFACE_SINGLE, .count = 1000000,
          .unit = "ns"),
    BENCH("rational surface grid", .kind = SURFACE_GRID, .rational = true, .count = 1000,
          .unit = "ns"),
    BENCH("rational surface grid + unit normal", .kind = SURFACE_GRID, .order = 1,
          .rational = true, .count = 1000, .unit = "ns"),
    BENCH("rational surface, random", .kind = SURFACE_POINTS, .rational = true,
          .count = 1000000, .unit = "ns"),
    BENCH("curve through 1e3 points", .kind = CURVE_THROUGH, .count = 1000, .unit = "ms"),
    BENCH("curve through 1e4 points", .kind = CURVE_THROUGH, .count = 10000, .unit = "ms"),
    BENCH("curve through 1e5 points", .kind = CURVE_THROUGH, .count = 100000, .unit = "ms"),
    BENCH("curve through 1e6 points", .kind = CURVE_THROUGH, .count = 1000000, .unit = "ms"),
    BENCH("surface through 100 x 100 points", .kind = SURFACE_THROUGH, .count = 100,
          .unit = "ms"),
    BENCH("surface through 500 x 500 points", .kind = SURFACE_THROUGH, .count = 500,
          .unit = "ms"),
    BENCH("natural cubic function, 1e5 values", .kind = FUNCTION_THROUGH,
          .method = NATURAL_CUBIC, .count = 100000, .unit = "ms"),
    BENCH("Akima's function, 1e5 values", .kind = FUNCTION_THROUGH, .method = AKIMA,
          .count = 100000, .unit = "ms"),
    BENCH("Steffen's function, 1e5 values", .kind = FUNCTION_THROUGH, .method = STEFFEN,
          .count = 100000, .unit = "ms"),
    BENCH("spline in tension, 1e5 points", .kind = PLANE_THROUGH, .method = TENSION,
          .count = 100000, .unit = "ms"),
    BENCH("nu-spline, 1e5 points", .kind = PLANE_THROUGH, .method = NU_SPLINE, .count = 100000,
          .unit = "ms"),
    BENCH("local cubic, 1e5 points", .kind = PLANE_THROUGH, .method = LOCAL_CUBIC,
          .count = 100000, .unit = "ms"),
    BENCH("Euler spiral, 1e5 points", .kind = PLANE_THROUGH, .method = EULER_SPIRAL,
          .count = 100000, .unit = "ms"),
    BENCH("elastica, 1e5 points", .kind = PLANE_THROUGH, .method = ELASTICA, .count = 100000,
          .unit = "ms"),
    BENCH("arc length of a curve of 997 spans", .kind = CURVE_LENGTH, .count = 1, .unit = "ms"),
    BENCH("surface within 1e-3 of 1e5 scattered values", .kind = SCATTERED_NEAR,
          .count = 100000, .unit = "ms"),
    BENCH("surface within 1e-3 of 1e6 scattered values", .kind = SCATTERED_NEAR,
          .count = 1000000, .unit = "ms"),
    BENCH("triangulation of 1e5 points", .kind = TRIANGULATION, .count = 100000, .unit = "ms"),
    BENCH("triangulation of 1e6 points", .kind = TRIANGULATION, .count = 1000000, .unit = "ms"),
    BENCH("smooth surface over triangles through 1e5 values", .kind = TRIANGLES_THROUGH,
          .count = 100000, .unit = "ms"),
    BENCH("skin of 50 sections", .kind = SKIN, .count = 50, .unit = "ms"),
    BENCH("exchange: STEP of 1e3 patches written", .kind = WRITE_PATCHES, .count = 1000,
          .unit = "ms"),
    BENCH("exchange: IGES of 1e3 patches written", .kind = WRITE_PATCHES, .iges = true,
          .count = 1000, .unit = "ms"),
    BENCH("exchange: STEP of 1e3 patches written", .kind = WRITE_PATCHES, .count = 1000,
          .unit = "MB"),
    BENCH("exchange: IGES of 1e3 patches written", .kind = WRITE_PATCHES, .iges = true,
          .count = 1000, .unit = "MB"),
    BENCH("exchange: STEP of 1e3 patches read", .kind = READ_PATCHES, .count = 1000,
          .unit = "ms"),
    BENCH("exchange: STEP of 1e3 patches read", .kind = READ_PATCHES, .count = 1000,
          .unit = "MB"),
    BENCH("exchange: IGES of 1e3 patches read", .kind = READ_PATCHES, .iges = true,
          .count = 1000, .unit = "ms"),
    BENCH("exchange: IGES of 1e3 patches read", .kind = READ_PATCHES, .iges = true,
          .count = 1000, .unit = "MB"),
    BENCH("exchange: IGES of 1e3 patches read, of Open CASCADE", .kind = READ_PATCHES,
          .iges = true, .theirs = true, .count = 1000, .unit = "ms"),
    BENCH("exchange: STEP of 1e3 patches read, of Open CASCADE", .kind = READ_PATCHES,
          .theirs = true, .count = 1000, .unit = "ms"),
};

enum { BATTEN, OCCT = 2 };

static const struct {
    const char *name;
    const bench_entry *entries;
} peers[PEERS] = {{"batten", bench_batten},
#ifdef BENCH_SISL
                  {"sisl", bench_sisl},
#else
                  {"sisl", NULL},
#endif
#ifdef BENCH_OCCT
                  {"occt", bench_occt},
#else
                  {"occt", NULL},
#endif
#ifdef BENCH_GSL
                  {"gsl", bench_gsl}};
#else
                  {"gsl", NULL}};
#endif

static const bench_entry *entry_of(int peer, bench_kind kind)
{
    if (kind == WRITE_PATCHES || kind == READ_PATCHES) {
        const bool write = kind == WRITE_PATCHES;
        if (peer == BATTEN)
            return write ? &bench_batten_write : &bench_batten_read;
#ifdef BENCH_OCCT
        if (peer == OCCT)
            return write ? &bench_occt_write : &bench_occt_read;
#endif
        return NULL;
    }
    return peers[peer].entries ? &peers[peer].entries[kind] : NULL;
}

static double cpu_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

typedef struct {
    double best, median; /* seconds; 0: did not take part */
} bench_time;

/* Up to MOST_RUNS runs, or two seconds. */
static bench_time measure(const bench_entry *entry, void *object)
{
    double times[MOST_RUNS], sum = 0;
    int count = 0;
    while (count < MOST_RUNS && (count < 3 || sum < 2)) {
        const double start = cpu_seconds();
        entry->run(object);
        times[count] = cpu_seconds() - start;
        sum += times[count++];
    }
    qsort(times, (size_t)count, sizeof *times, compare);
    return (bench_time){times[0], times[count / 2]};
}

static bool is_memory(const bench_work *row)
{
    return strcmp(row->unit, "MB") == 0;
}

static double peak_megabytes(void)
{
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    return (double)used.ru_maxrss / 1024;
}

/* By how many megabytes the work raises the peak of a process of its own. */
static bench_time measure_memory(const bench_entry *entry, void *object)
{
    int ends[2];
    double grown = 0;
    if (pipe(ends) != 0)
        return (bench_time){0, 0};
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
    return (bench_time){grown, grown};
}

/* Coordinates reach 20: agreement to 1e-11 is some hundred roundings of the spans' widths. */
static void check_agreement(const bench_work *work, const char *peer, const double *expected,
                            const double *result)
{
    double worst = 0;
    for (size_t i = 0; i < work->result_count; i++)
        worst = fmax(worst, isfinite(result[i]) ? fabs(result[i] - expected[i]) : INFINITY);
    if (worst <= 1e-11)
        return;
    fprintf(stderr, "bench: %s: %s is off by %g\n", work->name, peer, worst);
    exit(1);
}

static bool offered(int peer, const bench_work *work)
{
    const bench_entry *entry = entry_of(peer, work->kind);
    return entry && entry->open;
}

static void check_all(const bench_work *work, void *const objects[PEERS])
{
    double *first = bench_numbers(work->result_count),
           *other = bench_numbers(work->result_count);
    const double *expected = work->data && work->kind != FUNCTION_THROUGH ? work->data : first;
    for (int i = 0; i < PEERS; i++) {
        if (!objects[i])
            continue;
        const bench_entry *entry = entry_of(i, work->kind);
        entry->run(objects[i]);
        entry->gather(objects[i], i == 0 ? first : other);
        check_agreement(work, peers[i].name, expected, i == 0 ? first : other);
    }
    free(first);
    free(other);
}

/* Each on its own, with no memory left over from others. */
static void run_memory_row(const bench_work *work, bench_time times[PEERS])
{
    for (int i = 0; i < PEERS; i++) {
        times[i] = (bench_time){0, 0};
        if (!offered(i, work))
            continue;
        const bench_entry *entry = entry_of(i, work->kind);
        void *object = entry->open(work);
        malloc_trim(0);
        times[i] = measure_memory(entry, object);
        entry->close(object);
    }
}

/* Open CASCADE writes the file that all read; false when it is not there. */
static bool make_theirs(const bench_work *work)
{
    const bench_entry *entry = entry_of(OCCT, WRITE_PATCHES);
    if (!entry)
        return false;
    void *object = entry->open(work);
    entry->run(object);
    entry->close(object);
    return true;
}

static void run_timed_row(const bench_work *work, bench_time times[PEERS])
{
    void *objects[PEERS] = {0};
    if (work->theirs && !make_theirs(work)) {
        memset(times, 0, PEERS * sizeof *times);
        return;
    }
    for (int i = 0; i < PEERS; i++)
        objects[i] = offered(i, work) ? entry_of(i, work->kind)->open(work) : NULL;
    check_all(work, objects);
    for (int i = 0; i < PEERS; i++) {
        times[i] = (bench_time){0, 0};
        if (!objects[i])
            continue;
        const bench_entry *entry = entry_of(i, work->kind);
        times[i] = measure(entry, objects[i]);
        entry->close(objects[i]);
    }
}

static void run_row(const bench_work *row, bench_time times[PEERS])
{
    bench_work work = *row;
    bench_fill(&work);
    if (is_memory(row))
        run_memory_row(&work, times);
    else
        run_timed_row(&work, times);
    bench_release(&work);
}

static double per_item(const bench_work *row, double seconds)
{
    if (is_memory(row))
        return seconds; /* which are megabytes */
    if (strcmp(row->unit, "ms") == 0)
        return 1e3 * seconds;
    return 1e9 * seconds /
           (double)(row->kind == SURFACE_GRID ? row->count * row->count : row->count);
}

static void print_row(const bench_work *row, const bench_time times[PEERS], FILE *tsv)
{
    double best_peer = 0;
    printf("| %s, %s ", row->name, row->unit);
    if (tsv)
        fprintf(tsv, "%s\t%s", row->name, row->unit);
    for (int i = 0; i < PEERS; i++) {
        const double best = per_item(row, times[i].best),
                     median = per_item(row, times[i].median);
        if (i > 0 && best > 0 && (best_peer == 0 || best < best_peer))
            best_peer = best;
        if (best > 0)
            printf("| %.3g (%.3g) ", best, median);
        else
            printf("| - ");
        if (tsv)
            fprintf(tsv, "\t%.6g\t%.6g", best, median);
    }
    const double ratio = times[0].best > 0 ? best_peer / per_item(row, times[0].best) : 0;
    if (ratio > 0)
        printf("| %.2f |\n", ratio);
    else
        printf("| - |\n");
    if (tsv)
        fprintf(tsv, "\t%.4g\n", ratio);
    fflush(stdout);
}

static bool wanted(const char *name, int count, char *const *parts)
{
    for (int i = 0; i < count; i++)
        if (strstr(name, parts[i]))
            return true;
    return count == 0;
}

int main(int argument_count, char **arguments)
{
    int first = 1;
    FILE *tsv = NULL;
    if (argument_count > 2 && strcmp(arguments[1], "-t") == 0) {
        tsv = fopen(arguments[2], "w");
        first = 3;
        if (!tsv) {
            perror(arguments[2]);
            return 1;
        }
    }
    printf("| workload | batten | sisl | occt | gsl | best peer / batten "
           "|\n|---|---|---|---|---|---|\n");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        bench_time times[PEERS];
        if (!wanted(rows[i].name, argument_count - first, arguments + first))
            continue;
        run_row(&rows[i], times);
        print_row(&rows[i], times, tsv);
    }
    if (tsv && fclose(tsv) != 0) {
        perror(arguments[2]);
        return 1;
    }
    return 0;
}
