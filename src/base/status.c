/*
 * Status codes with their names and texts, the message of the last failure on each thread, and
 * the version of the library.
 */
#include "base/base.h"

#include <string.h>

#define TEXT(value) #value
#define VERSION(major, minor, patch) TEXT(major) "." TEXT(minor) "." TEXT(patch)

static const struct {
    const char *name, *text;
} statuses[] = {
#define ROW(name, text) {#name, text},
    BATTEN_STATUS_TABLE(ROW)
#undef ROW
};

/* Long enough for a sentence with a path in it; longer ones are cut. */
static _Thread_local char message[1024];

const char *batten_status_name(batten_status status)
{
    return (unsigned)status < BATTEN_STATUS_COUNT ? statuses[status].name : "?";
}

const char *batten_status_text(batten_status status)
{
    return (unsigned)status < BATTEN_STATUS_COUNT ? statuses[status].text : "unknown status";
}

const char *batten_message(void)
{
    return message;
}

const char *batten_version(void)
{
    return VERSION(BATTEN_VERSION_MAJOR, BATTEN_VERSION_MINOR, BATTEN_VERSION_PATCH);
}

batten_status batten_fail(batten_status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    /* An argument may be the last message itself. */
    char sentence[sizeof message];
    bat_format(sentence, sizeof sentence, format, arguments);
    memcpy(message, sentence, sizeof message);
    va_end(arguments);
    return status;
}

/* 0 times what is finite is 0, else no number; the sums of a block say whether to look. */
static bool block_is_finite(const double *values, size_t count)
{
    double even = 0, odd = 0;
    for (size_t i = 0; i < count; i += 2) {
        even += 0 * values[i];
        odd += 0 * values[i + 1];
    }
    return even + odd == 0;
}

size_t bat_first_not_finite(const double *values, size_t count)
{
    enum { BLOCK = 16 };
    size_t i = 0;
    while (count - i >= BLOCK && block_is_finite(values + i, BLOCK))
        i += BLOCK;
    while (i < count && isfinite(values[i]))
        i++;
    return i;
}
