/* Numbers of a text found and replaced, and what is read compared. */
#ifndef TESTS_EXCHANGE_REPLACE_H
#define TESTS_EXCHANGE_REPLACE_H
#include <ctype.h>

#include "exchange/reading.h"

/* Where the next number of a text begins, and how long it is; false for none. */
static inline bool next_number(const char *text, size_t *at, size_t *length)
{
    for (size_t i = *at; text[i]; i++) {
        const bool is_new =
            i == 0 || (!isalnum((unsigned char)text[i - 1]) && text[i - 1] != '.');
        if (!is_new ||
            !(isdigit((unsigned char)text[i]) ||
              ((text[i] == '-' || text[i] == '.') && isdigit((unsigned char)text[i + 1]))))
            continue;
        *at = i;
        *length = 1 + strspn(text + i + 1, "0123456789.eE");
        return true;
    }
    return false;
}

/* The text with another number there. In records of 80 columns the blanks that follow give way,
 * or what is beyond column 72 moves: that harms no more than it should. */
static inline char *with_number(char *room, const char *text, size_t at, size_t length,
                                const char *number)
{
    const size_t more = strlen(number) > length ? strlen(number) - length : 0;
    const char *rest = text + at + length, *line = strchr(rest, '\n');
    char *to = room + sprintf(room, "%.*s%s", (int)at, text, number);
    const char *blank = strstr(rest, "  ");
    if (more > 0 && blank && line && blank < line && strspn(blank, " ") > more) {
        to += sprintf(to, "%.*s", (int)(blank - rest), rest);
        rest = blank + more;
    }
    strcpy(to, rest);
    return room;
}

/* All that was read, as bytes: two models are the same when these are. */
static inline batten_status to_bytes(const batten_model *model, batten_format format,
                                     char **data, size_t *size)
{
    batten_write_options options = batten_write_defaults();
    options.format = format == BATTEN_FORMAT_OFFSET_TABLE ? format : BATTEN_FORMAT_STEP;
    options.schema = BATTEN_STEP_AP242; /* which has meshes */
    return batten_write_memory(model, &options, NULL, data, size);
}

static inline char *as_bytes(const batten_model *model, batten_format format, size_t *size)
{
    char *data = NULL;
    CHECK_OK(to_bytes(model, format, &data, size));
    return data;
}

#endif
