/* The input of a reader: its limits, memory, lines, and how failures name a place. */
#include "exchange/reading/input.h"
#include "base/plural.h"

#include <limits.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define MEBIBYTE ((size_t)1 << 20)

batten_limits batten_limits_defaults(void)
{
    return (batten_limits){.size = sizeof(batten_limits),
                           .file_bytes = 1024 * MEBIBYTE,
                           .memory_bytes = 0,
                           .entities = 10000000,
                           .nesting = 64,
                           .string_bytes = MEBIBYTE,
                           .line_bytes = 65536,
                           .points = 10000000,
                           .notes = 1000};
}

batten_read_options batten_read_defaults(void)
{
    return (batten_read_options){.size = sizeof(batten_read_options),
                                 .format = BATTEN_FORMAT_AUTO,
                                 .limits = NULL,
                                 .file_name = ""};
}

batten_status bat_input_begin(const char *data, size_t size, const batten_read_options *options,
                              const batten_job *job, batten_notes *notes, bat_input *input)
{
    batten_limits limits = batten_limits_defaults();
    const batten_status status =
        BAT_TAKE_OPTIONS(batten_limits, options ? options->limits : NULL, &limits);
    if (status != BATTEN_OK)
        return status;
    *input = (bat_input){.data = data,
                         .size = size,
                         .file = options && options->file_name ? options->file_name : "",
                         .limits = limits,
                         .work = {.job = job},
                         .notes = notes};
    if (input->limits.memory_bytes == 0)
        input->limits.memory_bytes = 16 * MEBIBYTE + 40 * size;
    return bat_input_limit(input, 0, size, input->limits.file_bytes, "bytes in the file");
}

static bool begins(const bat_input *input, const char *bytes, size_t length)
{
    return input->size >= length && memcmp(input->data, bytes, length) == 0;
}

static int line_of(const bat_input *input, size_t at)
{
    int line = 0;
    bat_span text;
    for (size_t next = 0; next <= at && line < INT_MAX && bat_next_line(input, &next, &text);)
        line++;
    return line;
}

batten_status bat_input_past_mark(bat_input *input)
{
    if (begins(input, "\xff\xfe", 2) || begins(input, "\xfe\xff", 2))
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 0,
                              "the text is in UTF-16; save it as UTF-8");
    if (begins(input, "\xef\xbb\xbf", 3)) {
        input->data += 3;
        input->size -= 3;
    }
    return BATTEN_OK;
}

batten_status bat_input_as_text(bat_input *input)
{
    const batten_status status = bat_input_past_mark(input);
    if (status != BATTEN_OK)
        return status;
    while (input->size > 0 && input->data[input->size - 1] == '\x1a')
        input->size--;
    const char *zero = input->size ? memchr(input->data, 0, input->size) : NULL;
    if (zero) {
        const size_t at = (size_t)(zero - input->data);
        return bat_input_fail(input, BATTEN_BAD_FORMAT, line_of(input, at),
                              "byte %zu is zero; this is not text", at);
    }
    return BATTEN_OK;
}

batten_status bat_input_fail(const bat_input *input, batten_status status, int line,
                             const char *format, ...)
{
    char place[16] = "", sentence[768], shown[BAT_SHOWN_SIZE];
    va_list arguments;
    va_start(arguments, format);
    bat_format(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    if (line > 0)
        snprintf(place, sizeof place, "%d", line);
    const bool named = input->file[0] != '\0';
    return bat_fail(status, "%s%s%s%s%s",
                    named      ? bat_shown(input->file, strlen(input->file), shown)
                    : line > 0 ? "line "
                               : "",
                    named && line > 0 ? ":" : "", place, named || line > 0 ? ": " : "",
                    sentence);
}

const char *bat_input_reason(const bat_input *input, int *line)
{
    char shown[BAT_SHOWN_SIZE];
    const char *message = batten_message(), *at = message;
    const char *file = bat_shown(input->file, strlen(input->file), shown);
    const size_t named = strlen(file);
    int number = 0;
    *line = 0;
    if (named > 0) {
        if (strncmp(at, file, named) != 0 || at[named] != ':')
            return message;
        at += named + 1;
    } else if (strncmp(at, "line ", 5) == 0) {
        at += 5;
    }
    const char *digits = at;
    while (*at >= '0' && *at <= '9' && number < INT_MAX / 10 - 1)
        number = 10 * number + (*at++ - '0');
    if (at > digits && *at == ':') {
        *line = number;
        at++;
    } else if (named == 0 || at > digits) {
        return message;
    }
    return *at == ' ' ? at + 1 : message;
}

void bat_input_behind(const bat_input *input, size_t at)
{
    const size_t from = at;
    while (at < input->size && (bat_is_white(input->data[at]) || input->data[at] == '\0' ||
                                input->data[at] == '\x1a'))
        at++;
    if (at < input->size)
        batten_notes_add(input->notes, input->file, 0, "",
                         "%zu byte%s %s where the file should end, at byte %zu; not read",
                         input->size - from, bat_plural(input->size - from),
                         bat_one_or_many(input->size - from, "follows", "follow"), from);
}

batten_status bat_input_step(bat_input *input, size_t at)
{
    const double fraction = input->size ? (double)at / (double)input->size : 1;
    return bat_work_step(&input->work, 1000, fraction, "reading");
}

batten_status bat_input_limit(const bat_input *input, int line, size_t count, size_t limit,
                              const char *what)
{
    if (count <= limit)
        return BATTEN_OK;
    return bat_input_fail(input, BATTEN_TOO_LARGE, line, "%zu %s; the limit is %zu", count,
                          what, limit);
}

static batten_status charge(bat_input *input, size_t count, size_t size)
{
    const size_t left = input->limits.memory_bytes - input->memory;
    if (count > left / size)
        return bat_input_fail(input, BATTEN_TOO_LARGE, 0,
                              "reading needs more memory than the limit of %zu bytes",
                              input->limits.memory_bytes);
    input->memory += count * size;
    return BATTEN_OK;
}

int bat_input_most_near(const bat_input *input, double points)
{
    /* 4e6 points of four doubles are 128 MB: memory ends before patience does. */
    const double most = bat_min(10000 + 100 * points, 4e6);
    return (int)bat_max(1, bat_min(most, (double)input->limits.points));
}

batten_status bat_input_array(bat_input *input, size_t count, size_t size, void *memory)
{
    batten_status status = charge(input, count, size);
    if (status != BATTEN_OK)
        return status;
    void *array = bat_array(count, size);
    if (!array) {
        input->memory -= count * size;
        return BATTEN_OUT_OF_MEMORY;
    }
    memcpy(memory, &array, sizeof array);
    return BATTEN_OK;
}

void bat_input_release(bat_input *input, size_t count, size_t size, void *memory)
{
    if (memory)
        input->memory -= count * size;
    bat_release(memory);
}

/* Not base/list.h: what this grows by counts towards the limit on memory before it is asked for. */
batten_status bat_list_reserve(bat_input *input, bat_list *list, size_t count)
{
    size_t capacity = list->capacity ? list->capacity : 16;
    if (count <= list->capacity - list->count)
        return BATTEN_OK;
    while (capacity - list->count < count && capacity <= SIZE_MAX / 4)
        capacity *= 2;
    batten_status status = charge(input, capacity - list->capacity, list->size);
    if (status != BATTEN_OK)
        return status;
    void *items = bat_resize(list->items, capacity, list->size);
    if (!items) {
        input->memory -= (capacity - list->capacity) * list->size;
        return BATTEN_OUT_OF_MEMORY;
    }
    list->items = items;
    list->capacity = capacity;
    return BATTEN_OK;
}

batten_status bat_list_append(bat_input *input, bat_list *list, const void *items, size_t count)
{
    batten_status status = bat_list_reserve(input, list, count);
    if (status != BATTEN_OK || count == 0)
        return status;
    memcpy((char *)list->items + list->count * list->size, items, count * list->size);
    list->count += count;
    return BATTEN_OK;
}

batten_status bat_list_add(bat_input *input, bat_list *list, const void *item)
{
    return bat_list_append(input, list, item, 1);
}

bool bat_is_white(char c)
{
    return c == '\n' || c == '\r' || bat_is_blank(c);
}

int bat_hex_digit(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

size_t bat_utf8_write(uint32_t code, char bytes[4])
{
    size_t count = 0;
    if (code == 0 || (code >= 0xd800 && code < 0xe000) || code > 0x10ffff)
        return 0;
    if (code < 0x80) {
        bytes[count++] = (char)code;
    } else if (code < 0x800) {
        bytes[count++] = (char)(0xc0 | code >> 6);
        bytes[count++] = (char)(0x80 | (code & 0x3f));
    } else {
        if (code < 0x10000) {
            bytes[count++] = (char)(0xe0 | code >> 12);
        } else {
            bytes[count++] = (char)(0xf0 | code >> 18);
            bytes[count++] = (char)(0x80 | (code >> 12 & 0x3f));
        }
        bytes[count++] = (char)(0x80 | (code >> 6 & 0x3f));
        bytes[count++] = (char)(0x80 | (code & 0x3f));
    }
    return count;
}

batten_status bat_input_hand_over(batten_status status, batten_model *model, batten_model **out)
{
    if (status == BATTEN_OK)
        *out = model;
    else
        batten_model_unref(model);
    return status;
}

bool bat_input_ends(batten_status status)
{
    return status == BATTEN_OUT_OF_MEMORY || status == BATTEN_TOO_LARGE ||
           status == BATTEN_CANCELLED;
}

bool bat_has_vanished(bat_span number, double value)
{
    if (value != 0)
        return false;
    for (size_t i = 0; i < number.length; i++) {
        const char c = number.bytes[i];
        if (c >= '1' && c <= '9')
            return true;
        if (c != '0' && c != '.' && c != '-' && c != '+') /* the exponent */
            return false;
    }
    return false;
}

void bat_input_vanished(const bat_input *input, int line, const char *entity, bat_span number,
                        double value)
{
    char shown[BAT_SHOWN_SIZE];
    if (bat_has_vanished(number, value))
        batten_notes_add(input->notes, input->file, line, entity,
                         "the number %.60s is too small for a double; read as 0",
                         bat_shown(number.bytes, number.length, shown));
}

bool bat_is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/* The next end of a line from `begin` on, or `end`. */
static const char *end_of_line(const char *begin, const char *end)
{
    enum { WINDOW = 256 }; /* both kinds of end are looked for in what is near */
    while (begin < end) {
        const size_t width = end - begin < WINDOW ? (size_t)(end - begin) : WINDOW;
        const char *feed = memchr(begin, '\n', width);
        const char *back = memchr(begin, '\r', feed ? (size_t)(feed - begin) : width);
        if (back || feed)
            return back ? back : feed;
        begin += width;
    }
    return end;
}

bool bat_next_line(const bat_input *input, size_t *at, bat_span *line)
{
    if (*at >= input->size)
        return false;
    const char *begin = input->data + *at, *end = input->data + input->size;
    const char *p = end_of_line(begin, end);
    *line = (bat_span){begin, (size_t)(p - begin)};
    if (p < end)
        p += p[0] == '\r' && p + 1 < end && p[1] == '\n' ? 2 : 1;
    *at = (size_t)(p - input->data);
    return true;
}

double bat_judged_accuracy(double stated, double size, double coarsest, double sizeless)
{
    /* 1e-12: what doubles of that size, and sums of a few of them, can hold */
    if (stated > 0 && stated < 1e-12 * size)
        return 1e-12 * size;
    if (stated > 0 && isfinite(stated) && (size == 0 || stated <= coarsest * size))
        return stated;
    /* 1e-6: of the size, what most programs keep */
    return size > 0 ? 1e-6 * size : sizeless;
}
