/* What our own files use of the ground: failing, memory, references. */
#ifndef BAT_BASE_H
#define BAT_BASE_H
#include "base/elementary.h"

#include <assert.h>
#include <batten/base.h>
#include <batten/text.h>
#include <math.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <string.h>

/* The exported names serve the sister libraries; inside we write bat_. */
#define bat_fail batten_fail
#define bat_array batten_array
#define bat_array3 batten_array3
#define bat_resize batten_resize
#define bat_release batten_release

#define BAT_PI 3.14159265358979323846

/* A reference count, the first member of every counted object. */
typedef struct {
    atomic_int count;
} bat_references;

static inline void bat_references_begin(bat_references *references)
{
    atomic_init(&references->count, 1);
}

static inline void bat_references_add(bat_references *references)
{
    atomic_fetch_add_explicit(&references->count, 1, memory_order_relaxed);
}

/* Drop one; true when it was the last and the object must go. */
static inline bool bat_references_drop(bat_references *references)
{
    return atomic_fetch_sub_explicit(&references->count, 1, memory_order_acq_rel) == 1;
}

static inline double bat_max(double a, double b)
{
    return a > b ? a : b;
}

static inline double bat_min(double a, double b)
{
    return a < b ? a : b;
}

static inline int bat_max_int(int a, int b)
{
    return a > b ? a : b;
}

static inline int bat_min_int(int a, int b)
{
    return a < b ? a : b;
}

/* Lay the options of a caller over `chosen`, which holds the defaults, at the top of every
 * public function that takes some. The caller's struct is as long as its header said: what an
 * older one does not have keeps its default; a longer one holds wishes that this library cannot
 * know, and is refused, as is a size that nobody set. NULL asks for the defaults. */
#define BAT_TAKE_OPTIONS(type, given, chosen)                               \
    bat_take_options(#type, 1 ? (given) : (const type *)NULL, sizeof(type), \
                     1 ? (chosen) : (type *)NULL)

static inline batten_status bat_take_options(const char *type, const void *given, size_t known,
                                             void *chosen)
{
    size_t size;
    if (!given)
        return BATTEN_OK;
    memcpy(&size, given, sizeof size);
    if (size < sizeof size || size > known)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the size in a %s is %zu; it must be %zu to %zu bytes: start from the "
                        "defaults, which set it",
                        type, size, sizeof size, known);
    memcpy(chosen, given, size);
    memcpy(chosen, &known, sizeof known);
    return BATTEN_OK;
}

/* vsnprintf in the C locale, whatever the locale of the process (base/system). */
int bat_format(char *buffer, size_t size, const char *format, va_list arguments)
    BATTEN_PRINTF(3, 0);

/* How many bytes the UTF-8 character at `text` has; 0 at the end and where there is none. Reads
 * no byte after a zero. */
size_t bat_utf8_length(const char *text);

/* Put bytes before a text that grows. */
struct batten_text;
void bat_text_insert(struct batten_text *text, const char *bytes, size_t length);
/* Make room for so many bytes more at once: a long text then need not move as it grows. */
void bat_text_reserve(struct batten_text *text, size_t length);

/* Bytes as they may stand in a message: what is no printable character of UTF-8 as \xNN, cut
 * where they do not fit. */
#define BAT_SHOWN_SIZE 512
const char *bat_shown(const char *bytes, size_t length, char buffer[BAT_SHOWN_SIZE]);

/* The index of the first number that is not finite, or `count`. */
size_t bat_first_not_finite(const double *values, size_t count);

#endif
