/*
 * A text that grows as it is written, with numbers and JSON strings; a failed allocation is
 * reported once, when the text is taken. Also how foreign bytes are shown in messages.
 */
#include "base/base.h"
#include "base/system.h"
#include <batten/text.h>

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Room for `more` bytes and the final zero. */
static bool make_room(batten_text *text, size_t more)
{
    if (text->failed)
        return false;
    if (text->capacity > text->length && text->capacity - text->length > more)
        return true;
    size_t capacity = 64;
    while (capacity < SIZE_MAX / 2 &&
           (capacity <= text->length || capacity - text->length <= more))
        capacity *= 2;
    char *bytes = bat_resize(text->bytes, capacity, 1);
    if (!bytes) {
        text->failed = true;
        return false;
    }
    text->bytes = bytes;
    text->capacity = capacity;
    return true;
}

void batten_text_bytes(batten_text *text, const char *bytes, size_t length)
{
    if (!make_room(text, length))
        return;
    if (length > 0)
        memcpy(text->bytes + text->length, bytes, length);
    text->length += length;
    text->bytes[text->length] = 0;
}

void bat_text_insert(batten_text *text, const char *bytes, size_t length)
{
    if (length == 0 || !make_room(text, length))
        return;
    if (text->length > 0)
        memmove(text->bytes + length, text->bytes, text->length);
    memcpy(text->bytes, bytes, length);
    text->length += length;
    text->bytes[text->length] = 0;
}

void bat_text_reserve(batten_text *text, size_t length)
{
    make_room(text, length);
}

int batten_text_print(char *buffer, size_t size, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length = bat_format(buffer, size, format, arguments);
    va_end(arguments);
    return length;
}

void batten_text_add(batten_text *text, const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    char first[256];
    const int length = bat_format(first, sizeof first, format, arguments);
    if (length >= 0 && (size_t)length < sizeof first) {
        batten_text_bytes(text, first, (size_t)length);
    } else if (length >= 0 && make_room(text, (size_t)length)) {
        bat_format(text->bytes + text->length, (size_t)length + 1, format, again);
        text->length += (size_t)length;
    }
    va_end(again);
    va_end(arguments);
}

void batten_text_number(batten_text *text, double value)
{
    char digits[BATTEN_NUMBER_SIZE];
    batten_text_bytes(text, digits, (size_t)batten_number_write(value, digits));
}

size_t bat_utf8_length(const char *text)
{
    const unsigned char *c = (const unsigned char *)text;
    if (c[0] < 0x80)
        return c[0] != 0;
    const size_t length = c[0] >= 0xf0 ? 4 : c[0] >= 0xe0 ? 3 : 2;
    if (c[0] < 0xc2 || c[0] > 0xf4)
        return 0;
    for (size_t i = 1; i < length; i++)
        if ((c[i] & 0xc0) != 0x80)
            return 0;
    /* Longer than need be, halves of UTF-16 pairs, beyond the last character. */
    const bool bad = (c[0] == 0xe0 && c[1] < 0xa0) || (c[0] == 0xed && c[1] >= 0xa0) ||
                     (c[0] == 0xf0 && c[1] < 0x90) || (c[0] == 0xf4 && c[1] >= 0x90);
    return bad ? 0 : length;
}

static void add_json_character(batten_text *text, char c)
{
    static const char marked[] = "\"\\\n\r\t\b\f", letters[] = "\"\\nrtbf";
    const char *found = strchr(marked, c);
    if (found)
        batten_text_add(text, "\\%c", letters[found - marked]);
    else if ((unsigned char)c < 0x20 || c == 0x7f)
        batten_text_add(text, "\\u%04x", (unsigned)c);
    else
        batten_text_bytes(text, &c, 1);
}

void batten_text_json(batten_text *text, const char *value)
{
    batten_text_bytes(text, "\"", 1);
    while (*value) {
        const size_t length = bat_utf8_length(value);
        if (length == 0)
            batten_text_bytes(text, "\xef\xbf\xbd", 3);
        else if (length == 1)
            add_json_character(text, *value);
        else
            batten_text_bytes(text, value, length);
        value += length > 0 ? length : 1;
    }
    batten_text_bytes(text, "\"", 1);
}

batten_status batten_text_take(batten_text *text, char **bytes, size_t *length)
{
    batten_text_bytes(text, "", 0);
    if (text->failed) {
        const size_t reached = text->length;
        batten_text_free(text);
        return bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for a text longer than %zu bytes",
                        reached);
    }
    *bytes = text->bytes;
    if (length)
        *length = text->length;
    *text = BATTEN_TEXT;
    return BATTEN_OK;
}

void batten_text_free(batten_text *text)
{
    bat_release(text->bytes);
    *text = BATTEN_TEXT;
}

/* How long the letter beyond ASCII is that begins there; 0 for what is none, or a control. */
static size_t letter_length(const char *bytes, size_t left)
{
    char copy[5] = "";
    memcpy(copy, bytes, left < 4 ? left : 4);
    const size_t length = bat_utf8_length(copy);
    const bool is_control = (unsigned char)copy[0] == 0xc2 && (unsigned char)copy[1] < 0xa0;
    return length > 1 && !is_control ? length : 0;
}

const char *bat_shown(const char *bytes, size_t length, char buffer[BAT_SHOWN_SIZE])
{
    static const char hex[] = "0123456789abcdef";
    size_t used = 0;
    for (size_t i = 0; i < length; i++) {
        if (used + 8 > BAT_SHOWN_SIZE) {
            memcpy(buffer + used, "...", 3);
            used += 3;
            break;
        }
        const unsigned char c = (unsigned char)bytes[i];
        const size_t letter = letter_length(bytes + i, length - i);
        if (c >= 0x20 && c < 0x7f && c != '\\') {
            buffer[used++] = (char)c;
        } else if (letter > 0) {
            memcpy(buffer + used, bytes + i, letter);
            used += letter;
            i += letter - 1;
        } else {
            const char escaped[4] = {'\\', 'x', hex[c >> 4], hex[c & 15]};
            memcpy(buffer + used, escaped, 4);
            used += 4;
        }
    }
    buffer[used] = 0;
    return buffer;
}
