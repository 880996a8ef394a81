#ifndef BATTEN_TEXT_H
#define BATTEN_TEXT_H
/**
 * @file
 * A text that grows: how files, reports and JSON are put together.
 *
 * A text that could not grow stays `failed`, and batten_text_take reports it: so a writer
 * checks once, at its end.
 */
#include <batten/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Begin with BATTEN_TEXT. */
typedef struct batten_text {
    char *bytes; /**< ends with a zero byte; NULL while empty */
    size_t length, capacity;
    bool failed;
} batten_text;

#ifdef __cplusplus
#define BATTEN_TEXT          \
    batten_text              \
    {                        \
        nullptr, 0, 0, false \
    }
#else
#define BATTEN_TEXT ((batten_text){NULL, 0, 0, false})
#endif

/** Append as printf does, in the C locale; for doubles use batten_text_number. */
BATTEN_API void batten_text_add(batten_text *text, const char *format, ...) BATTEN_PRINTF(2, 3);
BATTEN_API void batten_text_bytes(batten_text *text, const char *bytes, size_t length);
/** Append the fewest digits that read back to the same bits. */
BATTEN_API void batten_text_number(batten_text *text, double value);
/** Append a JSON string with its quotes; bytes that are no UTF-8 become U+FFFD. */
BATTEN_API void batten_text_json(batten_text *text, const char *value);
/** Hand the bytes over (release with batten_release) and begin anew. */
BATTEN_API batten_status batten_text_take(batten_text *text, char **bytes, size_t *length);
BATTEN_API void batten_text_free(batten_text *text);

#ifdef __cplusplus
}
#endif
#endif
