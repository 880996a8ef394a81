/* Decodes strings: doubled quotes, and the \X\, \X2\, \X4\ and \S\ directives. */
#include "exchange/step/text/instances.h"

#include <string.h>

/* A string that is taken apart, and what became of it. */
typedef struct {
    const char *at, *end;
    char *to, *to_end; /* the last byte is for the zero */
    bool is_full;
} decoding;

static void put_bytes(decoding *d, const char *bytes, size_t count)
{
    d->is_full |= (size_t)(d->to_end - d->to) < count;
    if (d->is_full)
        return;
    memcpy(d->to, bytes, count);
    d->to += count;
}

/* A code point as UTF-8; what is none, and 0, which would end the string, as U+FFFD. */
static void put_code(decoding *d, uint32_t code)
{
    char bytes[4];
    size_t count = bat_utf8_write(code, bytes);
    if (count == 0)
        count = bat_utf8_write(0xfffd, bytes);
    put_bytes(d, bytes, count);
}

/* `count` hexadecimal digits; false when others stand there. */
static bool read_hex(const char *at, const char *end, int count, uint32_t *value)
{
    uint32_t sum = 0;
    if (end - at < count)
        return false;
    for (int i = 0; i < count; i++) {
        const int digit = bat_hex_digit(at[i]);
        if (digit < 0)
            return false;
        sum = 16 * sum + (uint32_t)digit;
    }
    *value = sum;
    return true;
}

static bool stands(const decoding *d, const char *word)
{
    const size_t length = strlen(word);
    return (size_t)(d->end - d->at) >= length && memcmp(d->at, word, length) == 0;
}

/* The first of a surrogate pair with the second, which is passed; others as they are. */
static uint32_t join_surrogates(decoding *d, uint32_t first)
{
    uint32_t second = 0;
    if (first < 0xd800 || first >= 0xdc00 || !read_hex(d->at, d->end, 4, &second) ||
        second < 0xdc00 || second >= 0xe000)
        return first;
    d->at += 4;
    return 0x10000 + ((first - 0xd800) << 10) + (second - 0xdc00);
}

/* \X2\ with 4 digits a character, of which two may be a surrogate pair, or \X4\ with 8, up to
 * \X0\. */
static void decode_wide(decoding *d, int digits)
{
    uint32_t code = 0;
    d->at += 4;
    while (read_hex(d->at, d->end, digits, &code)) {
        d->at += digits;
        put_code(d, digits == 4 ? join_surrogates(d, code) : code);
    }
    if (stands(d, "\\X0\\"))
        d->at += 4;
}

/* What stands at a backslash; what is no escape stays as it is. */
static void decode_escape(decoding *d)
{
    uint32_t code = 0;
    if (stands(d, "\\X2\\")) {
        decode_wide(d, 4);
    } else if (stands(d, "\\X4\\")) {
        decode_wide(d, 8);
    } else if (stands(d, "\\X\\") && read_hex(d->at + 3, d->end, 2, &code)) {
        put_code(d, code);
        d->at += 5;
    } else if (stands(d, "\\S\\") && d->end - d->at >= 4) { /* the upper half of Latin-1 */
        put_code(d, 0x80 | (unsigned char)d->at[3]);
        d->at += 4;
    } else if (stands(d, "\\P") && d->end - d->at >= 4 && d->at[3] == '\\') {
        d->at += 4; /* another alphabet for \S\, of which only the first is known */
    } else {
        put_bytes(d, "\\", 1);
        d->at += stands(d, "\\\\") ? 2 : 1;
    }
}

batten_status bat_step_get_string(const bat_step_file *file, const bat_step_record *record,
                                  int k, size_t size, char *buffer)
{
    const size_t place = bat_step_argument(file, record, k);
    const bat_step_value value = bat_step_value_at(file, place);
    assert(size > 0);
    if (value.kind == BAT_STEP_NOTHING) {
        buffer[0] = '\0';
        return BATTEN_OK;
    }
    if (value.kind != BAT_STEP_STRING)
        return bat_step_fail_kind(file, record, place, "a string");
    const char *text = file->input->data + value.at;
    decoding d = {
        .at = text, .end = text + value.length, .to = buffer, .to_end = buffer + size - 1};
    while (d.at < d.end && !d.is_full) {
        const char c = *d.at;
        if (c == '\\') {
            decode_escape(&d);
        } else if (c == '\n' || c == '\r') {
            d.at++;
        } else if (c == '\'') {
            put_bytes(&d, "'", 1);
            d.at += 2;
        } else {
            size_t length = 1; /* of a character of UTF-8: cut nowhere else */
            while (length < 4 && d.at + length < d.end && (d.at[length] & 0xc0) == 0x80 &&
                   (c & 0xc0) == 0xc0)
                length++;
            put_bytes(&d, d.at, length);
            d.at += length;
        }
    }
    *d.to = '\0';
    return BATTEN_OK;
}
