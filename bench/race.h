/*
 * The race itself: each contestant works in a process of its own, in turns with the others, so that one that hangs, falls or
 * writes over its memory costs itself alone.
 */
#ifndef RACE_H
#define RACE_H
#include "bench.h"

enum { RACE_MOST_RUNS = 31 };

typedef enum {
    RACE_ABSENT, /* it has nothing for the row */
    RACE_TIMED,  /* it is right, and its times stand */
    RACE_SLOW,   /* one step took longer than the limit */
    RACE_FAILED, /* its process ended */
    RACE_DIFFERS /* it is right for itself alone: the row has no ratio */
} race_state;

/* What came of one way of one peer. */
typedef struct {
    const bench_entry *entry;
    int peer;
    race_state state;
    double best, median;          /* seconds of CPU, or megabytes */
    double times[RACE_MOST_RUNS]; /* of each round */
    int count;
    double off; /* the largest distance of its result from what is expected */
    int signal; /* of RACE_FAILED: what ended it, or 0 */
} race_result;

/* The entries that offer the row, all peers', run against each other: results [most]; their number. `limit`: seconds that a
 * step may take (making ready, one run, showing the result). */
int race_run(const bench_work *work, const bench_peer *peers, int peer_count, double limit,
             int most, race_result *results);

/* How many times as long the second took as the first: the median over the rounds, in each of which they worked one after the
 * other. */
double race_ratio(const race_result *first, const race_result *second);

/* The fastest of some peers, by the median, that is right; or NULL. */
const race_result *race_best(const race_result *results, int count, int first_peer,
                             int last_peer);

#endif
