#include "exchange/real.h"
#include "exchange/step/step.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* 120 with the end of an instance. */
#define COLUMNS 118

void bat_step_token(bat_step *step, const char *token)
{
    const size_t length = strlen(token), used = step->text.length - step->line;
    if (used > 0 && used + length > COLUMNS) {
        batten_text_bytes(&step->text, "\n", 1);
        step->line = step->text.length;
    }
    batten_text_bytes(&step->text, token, length);
}

int bat_step_open(bat_step *step, const char *keyword)
{
    char head[64];
    snprintf(head, sizeof head, "#%d=%s(", ++step->count, keyword);
    bat_step_token(step, head);
    return step->count;
}

void bat_step_close(bat_step *step)
{
    batten_text_bytes(&step->text, ");\n", 3);
    step->line = step->text.length;
}

void bat_step_id(bat_step *step, int id, const char *after)
{
    char token[32];
    assert(strlen(after) < 16);
    snprintf(token, sizeof token, "#%d%s", id, after);
    bat_step_token(step, token);
}

void bat_step_integer(bat_step *step, int value, const char *after)
{
    char token[32];
    assert(strlen(after) < 16);
    snprintf(token, sizeof token, "%d%s", value, after);
    bat_step_token(step, token);
}

void bat_step_real(bat_step *step, double value, const char *after)
{
    char number[BAT_REAL_SIZE], token[BAT_REAL_SIZE + 16];
    assert(strlen(after) < 16);
    bat_real_write(value, number);
    snprintf(token, sizeof token, "%s%s", number, after);
    bat_step_token(step, token);
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

static void add_character(batten_text *text, uint32_t c, bool valid)
{
    if (valid && c >= 32 && c < 127) {
        const char twice[2] = {(char)c, (char)c};
        batten_text_bytes(text, twice, c == '\'' || c == '\\' ? 2 : 1);
    } else if (!valid || c < 128) {
        batten_text_add(text, "\\X\\%02X", (unsigned)c);
    } else if (c < 0x10000) {
        batten_text_add(text, "\\X2\\%04X\\X0\\", (unsigned)c);
    } else {
        batten_text_add(text, "\\X4\\%08X\\X0\\", (unsigned)c);
    }
}

void bat_step_string(bat_step *step, const char *value, const char *after)
{
    batten_text token = BATTEN_TEXT;
    const unsigned char *at = (const unsigned char *)value;
    batten_text_bytes(&token, "'", 1);
    while (*at) {
        bool valid = true;
        const uint32_t c = next_character(&at, &valid);
        add_character(&token, c, valid);
    }
    batten_text_add(&token, "'%s", after);
    if (token.failed)
        step->text.failed = true;
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
