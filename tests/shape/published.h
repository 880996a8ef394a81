/* Numbers out of the files of published data: tables and the arrays of peers' results. */
#ifndef TESTS_SHAPE_PUBLISHED_H
#define TESTS_SHAPE_PUBLISHED_H
#include <stdlib.h>

#include "support/test.h"

/* The text of a file; the test is skipped when there is none. */
static inline char *published_text(const char *path)
{
    FILE *file = fopen(test_data(path), "rb");
    CHECK(file != NULL);
    char *text = test_array(1 << 20, 1);
    const size_t size = fread(text, 1, (1 << 20) - 1, file);
    fclose(file);
    CHECK(size > 0);
    return text;
}

/* The numbers of text from `at` on, whatever stands between, up to `end`; at most `most`. */
static inline int published_numbers(const char *at, char end, int most, double *out)
{
    int count = 0;
    while (*at && *at != end && count < most) {
        char *after;
        const double value = strtod(at, &after);
        if (after == at) {
            at++;
            continue;
        }
        out[count++] = value;
        at = after;
    }
    return count;
}

/* The rows of a table of `columns` columns with one line of titles; how many. */
static inline int published_table(const char *path, int columns, int most, double *out)
{
    const char *text = published_text(path);
    const int count = published_numbers(strchr(text, '\n'), '\0', most * columns, out);
    CHECK_INT(count % columns, 0);
    return count / columns;
}

/* The array or number that stands under a key, the `nth` time it occurs. */
static inline int published_array(const char *text, const char *key, int nth, int most,
                                  double *out)
{
    char quoted[64];
    snprintf(quoted, sizeof quoted, "\"%s\"", key);
    for (; nth >= 0; nth--) {
        text = strstr(text, quoted);
        CHECK(text != NULL);
        text += strlen(quoted);
    }
    text += strcspn(text, "[0123456789-");
    return *text == '[' ? published_numbers(text, ']', most, out)
                        : published_numbers(text, ',', 1, out);
}

#endif
