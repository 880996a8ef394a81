#include "bench/race.h"

#include "support/test.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

/* Contestants that count to three, each in its own way. */
static double counted;

static void *open_any(const bench_work *work)
{
    (void)work;
    counted = 0;
    return &counted;
}

static void *open_nothing(const bench_work *work)
{
    (void)work;
    return NULL;
}

static void count_to_three(void *object)
{
    *(double *)object = 3;
}

static void count_too_far(void *object)
{
    *(double *)object = 3.5;
}

static void count_to_nothing(void *object)
{
    *(double *)object = NAN;
}

static void hang(void *object)
{
    (void)object;
    pause();
}

static void fall(void *object)
{
    (void)object;
    signal(SIGABRT, SIG_DFL);
    abort();
}

static void leave(void *object)
{
    (void)object;
    _exit(3);
}

static void show(void *object, double *result)
{
    *result = *(double *)object;
}

static void close_any(void *object)
{
    (void)object;
}

static double a_tenth(void *object)
{
    (void)object;
    return 0.1;
}

static double a_fifth(void *object)
{
    (void)object;
    return 0.2;
}

#define WAY(name, run, seconds)                                     \
    {                                                               \
        name, CURVE_LENGTH, open_any, run, show, close_any, seconds \
    }

static const bench_entry ours[] = {WAY("ours", count_to_three, a_fifth), {.way = NULL}};
static const bench_entry right[] = {
    WAY("slower", count_to_three, a_fifth), WAY("faster", count_to_three, a_tenth), {.way = NULL}};
static const bench_entry wrong[] = {WAY("too far", count_too_far, a_tenth), {.way = NULL}};
static const bench_entry void_of_sense[] = {WAY("nan", count_to_nothing, a_tenth), {.way = NULL}};
static const bench_entry hanging[] = {WAY("hangs", hang, a_tenth), {.way = NULL}};
static const bench_entry falling[] = {
    WAY("falls", fall, a_tenth), WAY("leaves", leave, a_tenth), {.way = NULL}};
static const bench_entry without[] = {
    {"has none", CURVE_LENGTH, open_nothing, count_to_three, show, close_any, NULL},
    {"is for others", SKIN, open_any, hang, show, close_any, NULL},
    {.way = NULL}};

enum { MOST = 8 };

/* Ours against another; one number is compared. */
static int race(const bench_entry *others, race_result results[MOST])
{
    const bench_peer peers[] = {
        {"ours", ours, NULL}, {"missing", NULL, "none"}, {"theirs", others, NULL}};
    const bench_work work = {.kind = CURVE_LENGTH, .result_count = 1, .within = 0.25};
    return race_run(&work, peers, COUNT(peers), 0.5, MOST, results);
}

TEST(the_fastest_way_of_a_peer_counts)
{
    race_result results[MOST];
    const int count = race(right, results);
    CHECK_INT(count, 3);
    const race_result *first = race_best(results, count, 0, 0),
                      *best = race_best(results, count, 1, 2);
    CHECK(first && best);
    CHECK_BITS(first->best, 0.2);
    CHECK_BITS(best->best, 0.1);
    CHECK_BITS(best->median, 0.1);
    CHECK_BITS(race_ratio(first, best), 0.5);
    CHECK_TEXT(best->entry->way, "faster");
}

TEST(a_result_beyond_the_tolerance_is_told_with_its_distance)
{
    race_result results[MOST];
    int count = race(wrong, results);
    CHECK_INT(results[0].state, RACE_TIMED);
    CHECK_INT(results[1].state, RACE_DIFFERS);
    CHECK_BITS(results[1].off, 0.5);
    CHECK(!race_best(results, count, 1, 2));
    race(void_of_sense, results);
    CHECK_INT(results[1].state, RACE_DIFFERS);
    CHECK_BITS(results[1].off, INFINITY);
}

TEST(a_contestant_that_hangs_costs_the_limit_and_itself_alone)
{
    race_result results[MOST];
    race(hanging, results);
    CHECK_INT(results[0].state, RACE_TIMED);
    CHECK_INT(results[1].state, RACE_SLOW);
}

TEST(a_contestant_that_falls_is_told_with_its_signal)
{
    race_result results[MOST];
    race(falling, results);
    CHECK_INT(results[0].state, RACE_TIMED);
    CHECK_INT(results[1].state, RACE_FAILED);
    CHECK_INT(results[1].signal, SIGABRT);
    CHECK_INT(results[2].state, RACE_FAILED);
    CHECK_INT(results[2].signal, 0);
}

TEST(who_has_nothing_for_a_row_stays_away)
{
    race_result results[MOST];
    CHECK_INT(race(without, results), 2);
    CHECK_INT(results[1].state, RACE_ABSENT);
}
