/* Just enough of a reader of STEP to check what was written. */
#ifndef TESTS_EXCHANGE_STEP_READING_H
#define TESTS_EXCHANGE_STEP_READING_H
#include "exchange/shapes.h"

#include <stdlib.h>

/* The STEP file of a model, given back when the test ends. */
static inline const char *step_text(const batten_model *model, batten_notes *notes)
{
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_FORMAT_STEP;
    options.name = "hull";
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    char *copy = test_array(size + 1, 1);
    memcpy(copy, data, size);
    batten_release(data);
    return copy;
}

/* How often a keyword occurs as an entity. */
static inline int step_count(const char *text, const char *keyword)
{
    int count = 0;
    const size_t length = strlen(keyword);
    for (const char *at = text; (at = strstr(at, keyword)); at += length)
        count += at[length] == '(' && strchr("= (", at[-1]);
    return count;
}

/* Ids run from 1 on, each is made once, references are to ids that exist, brackets close, lines
 * are ASCII and no longer than 120 columns. */
static inline void step_check(const char *text)
{
    int count = 0, depth = 0, column = 0;
    bool quoted = false;
    for (const char *at = strstr(text, "DATA;\n"); *at; at++) {
        column = *at == '\n' ? 0 : column + 1;
        CHECK(column <= 120 || quoted);
        CHECK((*at >= 32 && *at < 127) || *at == '\n');
        quoted ^= *at == '\'';
        if (!quoted)
            depth += (*at == '(') - (*at == ')');
        if (*at == '\n' && at[1] == '#' && depth == 0)
            CHECK_INT(atoi(at + 2), ++count);
    }
    CHECK_INT(depth, 0);
    CHECK(!quoted);
    for (const char *at = strstr(text, "DATA;\n"); (at = strchr(at, '#')); at++)
        CHECK(atoi(at + 1) >= 1 && atoi(at + 1) <= count);
    CHECK(strstr(text, "ENDSEC;\nEND-ISO-10303-21;\n") != NULL);
}

#endif
