/* The groups of a DXF text: a line with a code, a line with a value. */
#ifndef TESTS_EXCHANGE_DXF_GROUPS_H
#define TESTS_EXCHANGE_DXF_GROUPS_H
#include "support/test.h"

#include <stdlib.h>

enum { VALUE = 300 };

/* The next group, its code and value; where the one after it begins, NULL at the end. */
static inline const char *next_group(const char *at, int *code, char value[VALUE])
{
    if (!at || !*at)
        return NULL;
    *code = atoi(at);
    at = strchr(at, '\n');
    CHECK(at != NULL);
    const size_t length = strcspn(at + 1, "\n");
    CHECK(length < VALUE);
    memcpy(value, at + 1, length);
    value[length] = '\0';
    return at + 1 + length + 1;
}

/* Where the groups of the first entity of a kind begin. */
static inline const char *entity(const char *text, const char *kind)
{
    char head[40];
    snprintf(head, sizeof head, "  0\n%s\n", kind);
    const char *section = strstr(text, "\nENTITIES\n");
    const char *found = strstr(section ? section : text, head);
    CHECK(found != NULL);
    return found + strlen(head);
}

/* All numbers under `code` in the entity that begins at `at`. */
static inline int numbers(const char *at, int wanted, double *out, int room)
{
    int code = -1, count = 0;
    char value[VALUE];
    while ((at = next_group(at, &code, value)) && code != 0)
        if (code == wanted && count < room)
            out[count++] = strtod(value, NULL);
    return count;
}

#endif
