/* What a text for people must not have: orphan lines, and lines that are too wide. */
#ifndef TEST_PROSE_H
#define TEST_PROSE_H
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* The widest line of a paragraph, in bytes: narrow enough to be read, and for a terminal. */
#define TEST_WIDEST_LINE 95

static inline int test_word_count(const char *line, size_t length)
{
    int count = 0;
    for (size_t i = 0; i < length; i++)
        count += line[i] != ' ' && (i == 0 || line[i - 1] == ' ');
    return count;
}

/* The first line of a paragraph (indented lines are none) that has one or two words and is not
 * its last, or that is too wide; NULL when all are well. */
static inline const char *test_orphan_line(const char *text)
{
    while (*text) {
        const size_t length = strcspn(text, "\n");
        const char *next = text + length + (text[length] == '\n');
        const bool goes_on = *next && *next != '\n' && *next != ' ';
        if (length && *text != ' ' &&
            (length > TEST_WIDEST_LINE || (goes_on && test_word_count(text, length) <= 2)))
            return text;
        text = next;
    }
    return NULL;
}

#endif
