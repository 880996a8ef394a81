/* Fairing that moves one point at a time: what a method says of them. */
#ifndef BAT_ONE_BY_ONE_H
#define BAT_ONE_BY_ONE_H
#include "fair/elastic_batten.h"

typedef struct {
    void *state;
    /* How unfair the whole is, 0 for nothing to mend, and each point [count]. */
    double (*measure)(void *state, const double *z, double *unfairness);
    /* Where point i should be for the sake of those beside it; `to` [width] is where it is. */
    void (*propose)(void *state, const double *z, int i, double *to);
    /* Whether to stop, asked of `judge`; NULL: go on. */
    batten_status (*is_done)(const void *judge, const double *z, bool *done);
    const void *judge;
    int count;
    const bat_ducks *ducks; /* pull and anchor are not looked at */
    int most;               /* moves; 0: 20 for each point */
    const batten_job *job;
} bat_one_by_one;

/* z [count][width]: the measure falls with every move. Cost: a measure and `count` for each trial. */
batten_status bat_move_one_by_one(const bat_one_by_one *method, double *z);

#endif
