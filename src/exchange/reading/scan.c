/* Goes through text word by word, and compares and converts words. */
#include "exchange/reading/scan.h"

#include <batten/text.h>
#include <limits.h>
#include <string.h>

bat_scan bat_scan_begin(const char *text, size_t length)
{
    return (bat_scan){text, text + length, 1};
}

static bool is_end_of_line(char c)
{
    return c == '\n' || c == '\r';
}

/* The end of a line is LF, CRLF or CR. */
bool bat_next_scan_line(bat_scan *words)
{
    if (words->at >= words->end)
        return false;
    const bool is_return = *words->at++ == '\r';
    if (is_return && words->at < words->end && *words->at == '\n')
        words->at++;
    if (words->line < INT_MAX)
        words->line++;
    return true;
}

bool bat_next_in_line(bat_scan *words, bat_span *word)
{
    const char *p = words->at, *const end = words->end;
    while (p < end && bat_is_blank(*p))
        p++;
    const char *begin = p;
    while (p < end && !bat_is_blank(*p) && !is_end_of_line(*p))
        p++;
    words->at = p;
    *word = (bat_span){begin, (size_t)(p - begin)};
    return p > begin;
}

bool bat_next_word(bat_scan *words, bat_span *word)
{
    while (!bat_next_in_line(words, word))
        if (!bat_next_scan_line(words))
            return false;
    return true;
}

bat_span bat_rest_of_line(bat_scan *words)
{
    const char *begin = words->at;
    while (words->at < words->end && !is_end_of_line(*words->at))
        words->at++;
    const char *end = words->at;
    while (begin < end && bat_is_blank(*begin))
        begin++;
    while (end > begin && bat_is_blank(end[-1]))
        end--;
    return (bat_span){begin, (size_t)(end - begin)};
}

bool bat_word_is(bat_span word, const char *text)
{
    return strlen(text) == word.length && memcmp(word.bytes, text, word.length) == 0;
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool bat_word_is_like(bat_span word, const char *text)
{
    size_t i = 0;
    for (; i < word.length && text[i]; i++)
        if (lower(word.bytes[i]) != lower(text[i]))
            return false;
    return i == word.length && !text[i];
}

bool bat_word_number(bat_span word, double *value)
{
    return batten_number_read(word.bytes, word.length, value, NULL) == BATTEN_OK;
}

bool bat_word_real(const bat_input *input, int line, bat_span word, double *value)
{
    if (!bat_word_number(word, value))
        return false;
    bat_input_vanished(input, line, "", word, *value);
    return true;
}

bool bat_word_integer(bat_span word, int64_t low, int64_t high, int64_t *value)
{
    return batten_integer_read(word.bytes, word.length, low, high, value, NULL) == BATTEN_OK;
}

void bat_word_copy(bat_span word, size_t size, char *copy)
{
    const size_t length = word.length < size ? word.length : size - 1;
    if (length)
        memcpy(copy, word.bytes, length);
    copy[length] = '\0';
}

bool bat_begins(const bat_input *input, size_t at, const char *bytes)
{
    const size_t length = strlen(bytes);
    return at <= input->size && input->size - at >= length &&
           memcmp(input->data + at, bytes, length) == 0;
}

size_t bat_past_white(const bat_input *input)
{
    size_t at = bat_begins(input, 0, "\xef\xbb\xbf") ? 3 : 0;
    while (at < input->size && (bat_is_blank(input->data[at]) || input->data[at] == '\n' ||
                                input->data[at] == '\r'))
        at++;
    return at;
}
