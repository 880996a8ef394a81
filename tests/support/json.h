/* A little of JSON, enough for the files of published data. */
#ifndef TESTS_SUPPORT_JSON_H
#define TESTS_SUPPORT_JSON_H
#include <stdlib.h>

#include "support/test.h"

/* The text of a file of the shared data; the test is skipped when there is none. */
static inline const char *json_file(const char *path)
{
    FILE *file = fopen(test_data(path), "rb");
    CHECK(file != NULL);
    char *text = test_array(1 << 20, 1);
    const size_t size = fread(text, 1, (1 << 20) - 1, file);
    fclose(file);
    CHECK(size > 0 && size < (1 << 20) - 1);
    return text;
}

static inline const char *json_blank(const char *at)
{
    return at + strspn(at, " \n\r\t,:");
}

/* Behind the value that stands at `at`. */
static inline const char *json_behind(const char *at)
{
    int depth = 0;
    at = json_blank(at);
    do {
        CHECK(*at != '\0');
        if (*at == '"') {
            for (at++; *at != '"'; at++)
                if (*at == '\\')
                    at++;
            at++;
        } else if (strchr("[{", *at)) {
            depth++, at++;
        } else if (strchr("]}", *at)) {
            depth--, at++;
        } else {
            at += strcspn(at, ",]}\"[{ \n");
        }
        if (depth > 0)
            at = json_blank(at);
    } while (depth > 0);
    return at;
}

/* The value that an object has under a key; NULL when it has none. */
static inline const char *json_try(const char *object, const char *key)
{
    const char *at = json_blank(object);
    CHECK(*at == '{');
    for (at = json_blank(at + 1); *at != '}'; at = json_blank(json_behind(at))) {
        const char *end = json_behind(at);
        const bool here =
            strlen(key) + 2 == (size_t)(end - at) && strncmp(at + 1, key, strlen(key)) == 0;
        at = json_blank(end);
        if (here)
            return at;
    }
    return NULL;
}

static inline const char *json_key(const char *object, const char *key)
{
    const char *value = json_try(object, key);
    CHECK(value != NULL);
    return value;
}

/* Item i of an array, or NULL beyond its end. */
static inline const char *json_item(const char *array, int i)
{
    const char *at = json_blank(array);
    CHECK(*at == '[');
    for (at = json_blank(at + 1); *at != ']'; at = json_blank(json_behind(at)))
        if (i-- == 0)
            return at;
    return NULL;
}

/* All numbers of a value, whatever its arrays; in strings too, where they may be fractions. */
static inline int json_numbers(const char *value, int most, double *out)
{
    const char *end = json_behind(value);
    int count = 0;
    for (const char *at = json_blank(value); at < end;) {
        char *after;
        const double number = strtod(at, &after);
        if (after == at) {
            at++;
            continue;
        }
        CHECK(count < most);
        out[count] = number;
        at = after;
        if (*at == '/')
            out[count] /= strtod(at + 1, &after), at = after;
        count++;
    }
    return count;
}

static inline double json_number(const char *value)
{
    double number = 0;
    CHECK_INT(json_numbers(value, 1, &number), 1);
    return number;
}

static inline bool json_is(const char *value, const char *text)
{
    value = json_blank(value);
    return value[0] == '"' && strncmp(value + 1, text, strlen(text)) == 0 &&
           value[1 + strlen(text)] == '"';
}

#endif
