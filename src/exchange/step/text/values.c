/* Reads the arguments of a record as values, and reports failures by instance. */
#include "exchange/step/text/instances.h"

#include "exchange/step/text/scan.h"
#include <batten/text.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* What is referred to from many places is read as often; more than so many times the whole file
 * is meant to take long. */
#define TIMES_OVER 256

static bool is_overrun(const bat_step_file *file)
{
    return file->input->again / TIMES_OVER > file->input->size + 8192;
}

/* ---- walking ---- */

static size_t blank(const bat_step_file *file, size_t at)
{
    const char c = at < file->input->size ? file->input->data[at] : ')';
    return c == '/' || bat_step_in(c, BAT_STEP_BLANK)
               ? bat_step_blank(file->input->data, file->input->size, at, NULL)
               : at;
}

static char byte_at(const bat_step_file *file, size_t at)
{
    return at < file->input->size ? file->input->data[at] : ')';
}

/* Behind the item that ends at `at`: over the ',' to the next. */
static size_t behind(const bat_step_file *file, size_t at)
{
    at = blank(file, at);
    return byte_at(file, at) == ',' ? blank(file, at + 1) : at;
}

size_t bat_step_next(const bat_step_file *file, size_t at)
{
    if (byte_at(file, at) == ')')
        return at;
    const size_t end = bat_step_item_end(file->input->data, file->input->size, at);
    file->input->again += end - at;
    return behind(file, end);
}

/* The first argument. */
static size_t first_of(const bat_step_file *file, const bat_step_record *record)
{
    const size_t list = (size_t)(record->keyword - file->input->data) + record->arguments;
    return blank(file, list + 1);
}

size_t bat_step_argument(const bat_step_file *file, const bat_step_record *record, int k)
{
    size_t at = first_of(file, record);
    for (; k > 0 && byte_at(file, at) != ')'; k--)
        at = bat_step_next(file, at);
    return at;
}

static int count_from(const bat_step_file *file, size_t at)
{
    int count = 0;
    for (; count < INT_MAX && byte_at(file, at) != ')'; count++)
        at = bat_step_next(file, at);
    return count;
}

int bat_step_argument_count(const bat_step_file *file, const bat_step_record *record)
{
    return count_from(file, first_of(file, record));
}

static bat_step_kind kind_of(const bat_step_file *file, size_t at)
{
    const char c = byte_at(file, at);
    switch (c) {
    case '$':
        return BAT_STEP_NOTHING;
    case '*':
        return BAT_STEP_DERIVED;
    case '\'':
        return BAT_STEP_STRING;
    case '#':
        return BAT_STEP_REFERENCE;
    case '"':
        return BAT_STEP_BINARY;
    case '(':
        return BAT_STEP_LIST;
    case ')':
        return BAT_STEP_END;
    case '.':
        return bat_step_in(byte_at(file, at + 1), BAT_STEP_DIGIT) ? BAT_STEP_REAL
                                                                  : BAT_STEP_ENUM;
    default:
        return bat_step_in(c, BAT_STEP_LETTER) ? BAT_STEP_TYPED : BAT_STEP_INTEGER;
    }
}

bat_step_value bat_step_value_at(const bat_step_file *file, size_t at)
{
    const bat_input *input = file->input;
    const bat_step_kind kind = kind_of(file, at);
    bat_step_value value = {.kind = kind, .at = at, .length = kind != BAT_STEP_END};
    if (kind == BAT_STEP_LIST) {
        value.first = blank(file, at + 1);
        return value;
    }
    if (kind == BAT_STEP_END)
        return value;
    const size_t end = bat_step_token_end(input->data, input->size, at);
    value.length = end - at;
    if (kind == BAT_STEP_STRING || kind == BAT_STEP_ENUM || kind == BAT_STEP_BINARY) {
        value.at++;
        value.length -= value.length < 2 ? value.length : 2;
    } else if (kind == BAT_STEP_REFERENCE) {
        value.at++;
        value.length--;
    } else if (kind == BAT_STEP_TYPED) {
        value.first = blank(file, blank(file, end) + 1);
    } else if (kind == BAT_STEP_INTEGER) {
        for (size_t i = at; i < end; i++)
            if (input->data[i] == '.' || input->data[i] == 'E' || input->data[i] == 'e')
                value.kind = BAT_STEP_REAL;
    }
    return value;
}

/* ---- failing ---- */

static batten_status fail_for(const bat_step_record *record, batten_status status,
                              const char *keyword, const char *sentence)
{
    return bat_fail(status, "#%llu %s: %s", (unsigned long long)record->id, keyword, sentence);
}

batten_status bat_step_fail(const bat_step_file *file, const bat_step_instance *instance,
                            batten_status status, const char *format, ...)
{
    char sentence[768], keyword[BAT_STEP_KEYWORD_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    return fail_for(bat_step_first(file, instance), status,
                    bat_step_keyword(file, instance, keyword), sentence);
}

static const char *name_of_kind(bat_step_kind kind)
{
    static const char *const names[] = {
        [BAT_STEP_NOTHING] = "$",           [BAT_STEP_DERIVED] = "*",
        [BAT_STEP_INTEGER] = "an integer",  [BAT_STEP_REAL] = "a real",
        [BAT_STEP_STRING] = "a string",     [BAT_STEP_REFERENCE] = "a reference",
        [BAT_STEP_ENUM] = "a word in dots", [BAT_STEP_BINARY] = "a binary value",
        [BAT_STEP_LIST] = "a list",         [BAT_STEP_TYPED] = "a typed value",
        [BAT_STEP_END] = "missing"};
    return names[kind];
}

/* A sentence about the value at `at`, which says in which argument it stands. */
static batten_status fail_at(const bat_step_file *file, const bat_step_record *record,
                             size_t at, batten_status status, const char *format, ...)
    BATTEN_PRINTF(5, 6);
static batten_status fail_at(const bat_step_file *file, const bat_step_record *record,
                             size_t at, batten_status status, const char *format, ...)
{
    char sentence[640], whole[704], keyword[BAT_STEP_KEYWORD_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    int k = 0;
    size_t place = first_of(file, record);
    for (; byte_at(file, place) != ')'; k++) {
        const size_t next = bat_step_next(file, place);
        if (at < next)
            break;
        place = next;
    }
    snprintf(whole, sizeof whole, "%sargument %d %s", place == at ? "" : "an item of ", k + 1,
             sentence);
    return fail_for(record, status, bat_step_upper_keyword(record, keyword), whole);
}

batten_status bat_step_fail_kind(const bat_step_file *file, const bat_step_record *record,
                                 size_t at, const char *wanted)
{
    return fail_at(file, record, at, BATTEN_BAD_FORMAT, "is %s, not %s",
                   name_of_kind(bat_step_value_at(file, at).kind), wanted);
}

batten_status bat_step_leave_out(const bat_step_file *file, bat_census *census,
                                 const bat_step_instance *instance, batten_status reason)
{
    bat_input *input = file->input;
    char keyword[BAT_STEP_KEYWORD_SIZE], entity[BAT_STEP_KEYWORD_SIZE + 32];
    if (reason == BATTEN_OUT_OF_MEMORY || reason == BATTEN_CANCELLED ||
        reason == BATTEN_INCOMPLETE || is_overrun(file))
        return reason;
    const int length =
        snprintf(entity, sizeof entity, "#%llu %s", (unsigned long long)instance->id,
                 bat_step_keyword(file, instance, keyword));
    const char *message = batten_message();
    if (strncmp(message, entity, (size_t)length) == 0 &&
        strncmp(message + length, ": ", 2) == 0)
        message += length + 2;
    batten_notes_add(input->notes, input->file, bat_step_line(file, instance->at), entity,
                     "%s; left out", message);
    input->left_out++;
    return census ? bat_census_leave(input, census, keyword) : BATTEN_OK;
}

/* ---- items ---- */

/* The value in KEYWORD(value), which may be in another; `at` itself when it is none. */
static size_t unwrapped(const bat_step_file *file, size_t at)
{
    while (bat_step_in(byte_at(file, at), BAT_STEP_LETTER))
        at = bat_step_value_at(file, at).first;
    return at;
}

static bool is_number(const bat_step_file *file, size_t at)
{
    const char c = byte_at(file, at);
    return bat_step_in(c, BAT_STEP_DIGIT) || c == '-' || c == '+' ||
           (c == '.' && bat_step_in(byte_at(file, at + 1), BAT_STEP_DIGIT));
}

/* A number that is nearer to 0 than any double became 0. */
static void check_vanished(const bat_step_file *file, const bat_step_record *record, size_t at,
                           size_t length)
{
    const bat_span number = {file->input->data + at, length};
    char entity[32];
    if (!bat_has_vanished(number, 0))
        return;
    snprintf(entity, sizeof entity, "#%llu", (unsigned long long)record->id);
    bat_input_vanished(file->input, bat_step_line(file, at), entity, number, 0);
}

batten_status bat_step_item_real(const bat_step_file *file, const bat_step_record *record,
                                 size_t *at, double *value)
{
    const bat_input *input = file->input;
    const size_t place = unwrapped(file, *at);
    size_t used = 0;
    double read = 0;
    if (!is_number(file, place))
        return bat_step_fail_kind(file, record, *at, "a number");
    if (batten_number_read(input->data + place, input->size - place, &read, &used) != BATTEN_OK)
        return fail_at(file, record, *at, BATTEN_OVERFLOW, "is too large for a double");
    if (read == 0)
        check_vanished(file, record, place, used);
    *value = read;
    *at = place == *at ? behind(file, place + used) : bat_step_next(file, *at);
    return BATTEN_OK;
}

batten_status bat_step_item_integer(const bat_step_file *file, const bat_step_record *record,
                                    size_t *at, int *value)
{
    const size_t place = unwrapped(file, *at);
    const bat_step_value token = bat_step_value_at(file, place);
    int64_t read = 0;
    if (token.kind != BAT_STEP_INTEGER)
        return bat_step_fail_kind(file, record, place, "an integer");
    if (batten_integer_read(file->input->data + token.at, token.length, INT_MIN, INT_MAX, &read,
                            NULL) != BATTEN_OK)
        return fail_at(file, record, *at, BATTEN_OVERFLOW, "is outside %d .. %d", INT_MIN,
                       INT_MAX);
    *value = (int)read;
    *at = bat_step_next(file, *at);
    return BATTEN_OK;
}

batten_status bat_step_item_reference(const bat_step_file *file, const bat_step_record *record,
                                      size_t *at, const bat_step_instance **instance)
{
    const bat_input *input = file->input;
    const size_t place = *at;
    uint64_t id = 0;
    size_t end = place + 1;
    file->input->again += 16; /* also where nothing is walked over */
    if (byte_at(file, place) != '#') {
        *at = bat_step_next(file, place);
        return bat_step_fail_kind(file, record, place, "a reference");
    }
    for (; end < input->size && bat_step_in(input->data[end], BAT_STEP_DIGIT); end++)
        id = 10 * id + (uint64_t)(input->data[end] - '0');
    const bat_step_instance *found = bat_step_find(file, id);
    *at = behind(file, end);
    if (!found)
        return fail_at(file, record, place, BATTEN_BAD_FORMAT,
                       "refers to #%llu, which is missing", (unsigned long long)id);
    if (is_overrun(file))
        return fail_at(file, record, place, BATTEN_TOO_LARGE,
                       "is one reference too many: what is referred to has been read more than "
                       "%d times over",
                       TIMES_OVER);
    *instance = found;
    return BATTEN_OK;
}

batten_status bat_step_item_list(const bat_step_file *file, const bat_step_record *record,
                                 size_t *at, int *count, size_t *first)
{
    if (byte_at(file, *at) != '(')
        return bat_step_fail_kind(file, record, *at, "a list");
    const size_t begin = blank(file, *at + 1);
    int items = 0;
    size_t end = begin;
    for (; items < INT_MAX && byte_at(file, end) != ')'; items++)
        end = bat_step_next(file, end);
    *first = begin;
    *count = items;
    *at = behind(file, end + 1);
    return BATTEN_OK;
}

/* ---- arguments ---- */

batten_status bat_step_get_real(const bat_step_file *file, const bat_step_record *record, int k,
                                double *value)
{
    size_t at = bat_step_argument(file, record, k);
    return bat_step_item_real(file, record, &at, value);
}

batten_status bat_step_get_integer(const bat_step_file *file, const bat_step_record *record,
                                   int k, int *value)
{
    size_t at = bat_step_argument(file, record, k);
    return bat_step_item_integer(file, record, &at, value);
}

batten_status bat_step_get_logical(const bat_step_file *file, const bat_step_record *record,
                                   int k, bool *value)
{
    const size_t at = bat_step_argument(file, record, k);
    const bat_step_value token = bat_step_value_at(file, at);
    const char c =
        token.kind == BAT_STEP_ENUM && token.length == 1 ? file->input->data[token.at] : '\0';
    if (!c || !strchr("TFUtfu", c))
        return bat_step_fail_kind(file, record, at, ".T. or .F.");
    *value = c == 'T' || c == 't';
    return BATTEN_OK;
}

batten_status bat_step_get_reference(const bat_step_file *file, const bat_step_record *record,
                                     int k, const bat_step_instance **instance)
{
    size_t at = bat_step_argument(file, record, k);
    return bat_step_item_reference(file, record, &at, instance);
}

batten_status bat_step_get_list(const bat_step_file *file, const bat_step_record *record, int k,
                                int *count, size_t *first)
{
    size_t at = bat_step_argument(file, record, k);
    return bat_step_item_list(file, record, &at, count, first);
}

bool bat_step_is(const bat_step_file *file, const bat_step_record *record, int k,
                 const char *word)
{
    const bat_step_value token = bat_step_value_at(file, bat_step_argument(file, record, k));
    return token.kind == BAT_STEP_ENUM && token.length == strlen(word) &&
           bat_step_same_word(file->input->data + token.at, word, token.length);
}

bool bat_step_is_nothing(const bat_step_file *file, const bat_step_record *record, int k)
{
    const char c = byte_at(file, bat_step_argument(file, record, k));
    return c == '$' || c == '*' || c == ')';
}
