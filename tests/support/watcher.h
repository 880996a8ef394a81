/* A job that counts what it hears, and is cancelled at a question. */
#ifndef TEST_WATCHER_H
#define TEST_WATCHER_H
#include "support/test.h"

typedef struct {
    int asked, stop_at, told; /* cancelled at the question stop_at, from 1; 0: never */
} watcher;

static inline bool watcher_stops(void *user)
{
    watcher *w = user;
    return ++w->asked == w->stop_at;
}

static inline void watcher_hears(void *user, double fraction, const char *what)
{
    watcher *w = user;
    CHECK(fraction >= 0 && fraction <= 1 && *what);
    w->told++;
}

/* Work that is watched from its beginning, whenever it is done again. */
typedef batten_status (*watched_work)(void *context, const batten_job *job);

static inline batten_status watch_work(watched_work work, void *context, int stop_at,
                                       watcher *out)
{
    *out = (watcher){.stop_at = stop_at};
    const batten_job job = {.size = sizeof(batten_job),
                            .thread_count = 1,
                            .is_cancelled = watcher_stops,
                            .progress = watcher_hears,
                            .user = out};
    return work(context, &job);
}

/* Does work that asks `least` times and more, and tells as it goes, end as cancelled at its first question, one in the middle and the
 * last? */
static inline void check_cancelling(watched_work work, void *context, int least)
{
    watcher whole, stopped;
    CHECK_OK(watch_work(work, context, 0, &whole));
    CHECK(whole.told > 0 && whole.asked >= least);
    const int stops[3] = {1, (whole.asked + 1) / 2, whole.asked};
    for (int i = 0; i < 3; i++) {
        CHECK_STATUS(watch_work(work, context, stops[i], &stopped), BATTEN_CANCELLED);
        CHECK_INT(stopped.asked, stops[i]);
    }
}

#endif
