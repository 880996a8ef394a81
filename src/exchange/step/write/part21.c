/* Writes instances as text: numbers, strings and lists. */
#include "base/real.h"
#include "exchange/step/step.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* 120 with the end of an instance. */
#define COLUMNS 118

static void put_bytes(bat_step *step, const char *token, size_t length)
{
    const size_t used = step->text->length - step->line;
    if (used > 0 && used + length > COLUMNS) {
        batten_text_bytes(step->text, "\n", 1);
        step->line = step->text->length;
    }
    batten_text_bytes(step->text, token, length);
}

void bat_step_token(bat_step *step, const char *token)
{
    put_bytes(step, token, strlen(token));
}

/* Put a number that stands in the token, with what comes after it. */
static void put_number(bat_step *step, char *token, int length, const char *after)
{
    const size_t more = strlen(after);
    assert(more < 16);
    memcpy(token + length, after, more);
    put_bytes(step, token, (size_t)length + more);
}

int bat_step_open(bat_step *step, const char *keyword)
{
    char head[BAT_INTEGER_SIZE + 80] = "#";
    int length = 1 + bat_integer_write(++step->count, head + 1);
    const size_t more = strlen(keyword);
    assert(more < 70);
    head[length++] = '=';
    memcpy(head + length, keyword, more);
    head[(size_t)length + more] = '(';
    put_bytes(step, head, (size_t)length + more + 1);
    return step->count;
}

void bat_step_close(bat_step *step)
{
    batten_text_bytes(step->text, ");\n", 3);
    step->line = step->text->length;
}

void bat_step_id(bat_step *step, int id, const char *after)
{
    char token[BAT_INTEGER_SIZE + 16] = "#";
    put_number(step, token, 1 + bat_integer_write(id, token + 1), after);
}

void bat_step_integer(bat_step *step, int value, const char *after)
{
    char token[BAT_INTEGER_SIZE + 16];
    put_number(step, token, bat_integer_write(value, token), after);
}

void bat_step_real(bat_step *step, double value, const char *after)
{
    char token[BAT_REAL_SIZE + 16];
    put_number(step, token, bat_real_write(value, token), after);
}

void bat_step_ids(bat_step *step, const int *ids, int count, const char *after)
{
    for (int i = 0; i < count; i++)
        bat_step_id(step, ids[i], i + 1 < count ? "," : after);
}

void bat_step_range(bat_step *step, int first, int count, const char *after)
{
    for (int i = 0; i < count; i++)
        bat_step_id(step, first + i, i + 1 < count ? "," : after);
}

/* ---- strings ---- */

/* One character of UTF-8 from *text on; a byte that is none stands for itself, as in Latin-1.
 */
static uint32_t next_character(const unsigned char **text, bool *valid)
{
    static const uint32_t least[] = {0, 0x80, 0x800, 0x10000};
    const unsigned char *s = *text;
    const int more = s[0] < 0x80 ? 0 : s[0] >= 0xf0 ? 3 : s[0] >= 0xe0 ? 2 : 1;
    uint32_t c = more ? s[0] & (0x3fU >> more) : s[0];
    bool good = s[0] < 0x80 || (s[0] >= 0xc2 && s[0] < 0xf5);
    for (int k = 1; good && k <= more; k++) {
        good = (s[k] & 0xc0) == 0x80;
        c = c << 6 | (s[k] & 0x3fU);
    }
    good = good && c >= least[more] && c < 0x110000 && (c < 0xd800 || c > 0xdfff);
    *text += good ? more + 1 : 1;
    *valid = good;
    return good ? c : s[0];
}

/* Quotes and backslashes stand twice. */
static void add_printable(batten_text *text, char c)
{
    const char twice[2] = {c, c};
    batten_text_bytes(text, twice, c == '\'' || c == '\\' ? 2 : 1);
}

static void add_character(batten_text *text, uint32_t c, bool valid)
{
    if (valid && c >= 32 && c < 127)
        add_printable(text, (char)c);
    else if (!valid || c < 128)
        batten_text_add(text, "\\X\\%02X", (unsigned)c);
    else if (c < 0x10000)
        batten_text_add(text, "\\X2\\%04X\\X0\\", (unsigned)c);
    else
        batten_text_add(text, "\\X4\\%08X\\X0\\", (unsigned)c);
}

void bat_step_string(bat_step *step, const char *value, const char *after)
{
    batten_text token = BATTEN_TEXT;
    const unsigned char *at = (const unsigned char *)value;
    if (!value[0]) {
        char empty[24] = "''";
        put_number(step, empty, 2, after);
        return;
    }
    batten_text_bytes(&token, "'", 1);
    while (*at) {
        bool valid = true;
        const uint32_t c = next_character(&at, &valid);
        add_character(&token, c, valid);
    }
    batten_text_add(&token, "'%s", after);
    if (token.failed)
        step->text->failed = true;
    else
        bat_step_token(step, token.bytes);
    batten_text_free(&token);
}

int bat_step_add(bat_step *step, const char *keyword, const char *format, ...)
{
    char arguments[256];
    va_list list;
    va_start(list, format);
    vsnprintf(arguments, sizeof arguments, format, list);
    va_end(list);
    const int id = bat_step_open(step, keyword);
    bat_step_token(step, arguments);
    bat_step_close(step);
    return id;
}

int bat_step_list(bat_step *step, const char *keyword, const char *name, const int *ids,
                  int count)
{
    const int id = bat_step_open(step, keyword);
    bat_step_string(step, name, ",(");
    bat_step_ids(step, ids, count, ")");
    bat_step_close(step);
    return id;
}
