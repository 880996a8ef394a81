/* The promise of every options struct: the size in it is checked, and a shorter one gets defaults. */
#ifndef TESTS_SUPPORT_OPTIONS_H
#define TESTS_SUPPORT_OPTIONS_H
#include "support/test.h"

/* A public function that takes options; `stage` is what else it is given. It need not be enough
 * to succeed, and the call releases what it made. */
typedef struct {
    const char *function, *type;
    size_t size;
    void (*defaults)(void *options);
    batten_status (*call)(const void *stage, const void *options);
} options_taker;

/* A size that nobody set, or that is longer than ours, is refused with the name of the type. */
void check_wrong_sizes(int count, const options_taker *takers, const void *stage);

/* What stands beyond the size that an older caller gave may be anything: each shorter struct gives
 * what the defaults give, status and message. */
void check_shorter_options(int count, const options_taker *takers, const void *stage);

#endif
