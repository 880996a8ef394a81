/* The promise of every options struct, checked for any function that takes one. */
#include "support/options.h"

enum { MOST_BYTES = 1024 };

static void set_size(unsigned char *options, size_t size)
{
    memcpy(options, &size, sizeof size);
}

void check_wrong_sizes(int count, const options_taker *takers, const void *stage)
{
    for (int i = 0; i < count; i++) {
        const options_taker *t = &takers[i];
        const size_t sizes[] = {0, sizeof(size_t) - 1, t->size + 1, SIZE_MAX};
        _Alignas(16) unsigned char options[MOST_BYTES] = {0};
        CHECK(t->size < sizeof options);
        t->defaults(options);
        for (int k = 0; k < COUNT(sizes); k++) {
            set_size(options, sizes[k]);
            CHECK_STATUS(t->call(stage, options), BATTEN_BAD_ARGUMENT);
            CHECK_MESSAGE("the size in a");
            CHECK_MESSAGE(t->type);
        }
    }
}

/* What stands beyond the size is here what crashes when it is followed. */
static void check_shorter(const options_taker *t, const void *stage)
{
    _Alignas(16) unsigned char options[MOST_BYTES];
    char message[512];
    t->defaults(options);
    const batten_status whole = t->call(stage, options);
    CHECK(whole != BATTEN_BAD_ARGUMENT || !strstr(batten_message(), "the size in a"));
    snprintf(message, sizeof message, "%s", whole == BATTEN_OK ? "" : batten_message());
    for (size_t size = sizeof size; size < t->size; size += sizeof size) {
        t->defaults(options);
        memset(options + size, 0xA5, sizeof options - size);
        set_size(options, size);
        const batten_status shorter = t->call(stage, options);
        if (whole == BATTEN_OUT_OF_MEMORY || shorter == BATTEN_OUT_OF_MEMORY)
            continue; /* when allocations are made to fail */
        CHECK_INT(shorter, whole);
        if (whole != BATTEN_OK)
            CHECK_TEXT(batten_message(), message);
    }
}

void check_shorter_options(int count, const options_taker *takers, const void *stage)
{
    for (int i = 0; i < count; i++)
        check_shorter(&takers[i], stage);
}
