/*
 * The race, as a table: `batten-bench [-l SECONDS] [-t FILE] [part of a name ...]` runs the rows whose name contains a part,
 * each step of a contestant for at most so many seconds (60), and prints Markdown; `-t` also one line of TSV for each way of
 * each contestant. It returns 1 when a row is refused or Batten has no result.
 */
#define _XOPEN_SOURCE 700
#include "race.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef BENCH_SISL
#define SISL bench_sisl
#else
#define SISL NULL
#endif
#ifdef BENCH_OCCT
#define OCCT bench_occt
#define OCCT_EXCHANGE bench_occt_exchange
#else
#define OCCT NULL
#define OCCT_EXCHANGE NULL
#endif
#ifdef BENCH_GSL
#define GSL bench_gsl
#else
#define GSL NULL
#endif
#ifdef BENCH_SCIPY
#define SCIPY bench_scipy
#else
#define SCIPY NULL
#endif

static const bench_peer peers[] = {
    {"batten", bench_batten, NULL},
    {"batten", bench_batten_fits, NULL},
    {"batten", bench_batten_exchange, NULL},
    {"batten", bench_batten_functions, NULL},
    {"sisl", SISL, "libsisl-dev"},
    {"occt", OCCT, "libocct-modeling-algorithms-dev"},
    {"occt", OCCT_EXCHANGE, "libocct-data-exchange-dev"},
    {"gsl", GSL, "libgsl-dev"},
    {"scipy", SCIPY, "python3-scipy"},
    {"libm", bench_libm, NULL},
};
enum { PEERS = sizeof peers / sizeof *peers, LAST_BATTEN = 3, MOST_WAYS = 16 };

typedef struct {
    double limit;
    FILE *tsv;
    bool is_clean; /* no row was refused, and Batten has a result in each */
} session;

/* Open CASCADE writes the file that all read; false when it is not there, or falls. */
static bool make_theirs(const bench_work *work)
{
    const bench_entry *e = OCCT_EXCHANGE;
    int status = 1;
    while (e && e->way && e->kind != WRITE_PATCHES)
        e++;
    if (!e || !e->way)
        return false;
    const pid_t child = fork();
    if (child == 0) {
        e->run(e->open(work));
        _exit(0);
    }
    return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

static double per_item(const bench_work *row, double seconds)
{
    if (row->of_memory)
        return seconds; /* which are megabytes */
    if (strcmp(row->unit, "ms") == 0)
        return 1e3 * seconds;
    return 1e9 * seconds /
           (double)(row->kind == SURFACE_GRID ? row->count * row->count : row->count);
}

static void print_result(const bench_work *row, const race_result *r, double limit)
{
    const char *name = peers[r->peer].name;
    switch (r->state) {
    case RACE_TIMED:
        printf("%s %.3g (%.3g) %s", name, per_item(row, r->best), per_item(row, r->median),
               r->entry->way);
        break;
    case RACE_SLOW:
        printf("%s more than %g s %s", name, limit, r->entry->way);
        break;
    case RACE_DIFFERS:
        printf("%s **off by %.2g**, %.2g allowed, %s", name, r->off, row->within,
               r->entry->way);
        break;
    case RACE_FAILED:
        printf("%s **failed**", name);
        if (r->signal)
            printf(" by signal %d", r->signal);
        printf(", %s", r->entry->way);
        break;
    default:
        break;
    }
}

static bool is_refused(const race_result *results, int count)
{
    for (int i = 0; i < count; i++)
        if (results[i].state == RACE_DIFFERS)
            return true;
    return false;
}

static void print_others(const bench_work *row, const race_result *results, int count,
                         const race_result *const shown[2], double limit)
{
    const char *between = "";
    for (int i = 0; i < count; i++) {
        if (results[i].state == RACE_ABSENT || &results[i] == shown[0] ||
            &results[i] == shown[1])
            continue;
        printf("%s", between);
        print_result(row, &results[i], limit);
        between = "; ";
    }
}

static void write_tsv(const bench_work *row, const race_result *results, int count, FILE *tsv)
{
    static const char *const states[] = {"absent", "timed", "slow", "failed", "differs"};
    for (int i = 0; tsv && i < count; i++) {
        const race_result *r = &results[i];
        if (r->state != RACE_ABSENT)
            fprintf(tsv, "%s\t%s\t%s\t%s\t%s\t%.6g\t%.6g\t%.3g\n", row->name, row->unit,
                    peers[r->peer].name, r->entry->way, states[r->state],
                    per_item(row, r->best), per_item(row, r->median), r->off);
    }
}

static void print_row(const bench_work *row, const race_result *results, int count, session *s)
{
    const race_result *ours = race_best(results, count, 0, LAST_BATTEN),
                      *theirs = race_best(results, count, LAST_BATTEN + 1, PEERS - 1);
    const race_result *const shown[2] = {ours, theirs};
    const bool refused = is_refused(results, count);
    printf("| %s, %s | ", row->name, row->unit);
    if (ours)
        printf("%.3g (%.3g)", per_item(row, ours->best), per_item(row, ours->median));
    else
        printf("**none**");
    printf(" | ");
    if (theirs)
        print_result(row, theirs, s->limit);
    else
        printf("-");
    if (refused)
        printf(" | **refused** | ");
    else if (ours && theirs)
        printf(" | %.2f | ", race_ratio(ours, theirs));
    else
        printf(" | - | ");
    print_others(row, results, count, shown, s->limit);
    printf(" |\n");
    fflush(stdout);
    write_tsv(row, results, count, s->tsv);
    s->is_clean = s->is_clean && ours && !refused;
}

static void run_row(const bench_work *row, session *s)
{
    race_result results[MOST_WAYS];
    bench_work work = *row;
    bench_fill(&work);
    if (work.theirs && !make_theirs(&work))
        printf("| %s, %s | - | occt, which writes the file, is missing or fails | - | |\n",
               row->name, row->unit);
    else {
        const int count = race_run(&work, peers, PEERS, s->limit, MOST_WAYS, results);
        print_row(&work, results, count, s);
    }
    bench_release(&work);
}

static bool is_wanted(const char *name, int count, char *const *parts)
{
    for (int i = 0; i < count; i++)
        if (strstr(name, parts[i]))
            return true;
    return count == 0;
}

static void print_head(void)
{
    for (int i = 0; i < PEERS; i++)
        if (!peers[i].entries)
            printf("%s is missing: its package is %s.\n", peers[i].name, peers[i].package);
    printf(
        "\n| workload | batten | fastest peer | peer : batten | others |\n|---|---|---|---|---|\n");
}

int main(int argument_count, char **arguments)
{
    session s = {60, NULL, true};
    int option;
    while ((option = getopt(argument_count, arguments, "l:t:")) != -1) {
        if (option == 'l')
            s.limit = strtod(optarg, NULL);
        else if (option != 't' || !(s.tsv = fopen(optarg, "w")))
            return 2;
    }
    if (!(s.limit > 0)) {
        fprintf(stderr, "bench: -l needs seconds > 0\n");
        return 2;
    }
    print_head();
    for (size_t i = 0; i < bench_row_count; i++)
        if (is_wanted(bench_rows[i].name, argument_count - optind, arguments + optind))
            run_row(&bench_rows[i], &s);
    if (s.tsv && fclose(s.tsv) != 0)
        return 2;
    return s.is_clean ? 0 : 1;
}
