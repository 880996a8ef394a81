/* Numbers with units, read from the start of a text; and the characters that names are made of.
 */
#ifndef BAT_DESIGN_LITERAL_H
#define BAT_DESIGN_LITERAL_H
#include "design/text/value.h"

/* ---- characters, the same in every locale ---- */

static inline bool bat_is_white(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static inline bool bat_is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static inline bool bat_begins_name(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static inline size_t bat_name_length(const char *text)
{
    size_t length = 0;
    if (bat_begins_name(*text))
        while (bat_begins_name(text[length]) || bat_is_digit(text[length]))
            length++;
    return length;
}

static inline const char *bat_skip_blanks(const char *at)
{
    while (bat_is_white(*at))
        at++;
    return at;
}

/* Where a number is read from, and what its unit is measured in. */
typedef struct {
    const char *at;
    const bat_names *names;
    bool vanished;
    bool in_expression; /* '-' is an operator */
} bat_reader;

/* Read a number with or without a unit, without a sign, and step behind it. */
batten_status bat_literal_read(bat_reader *r, bat_quantity *out);
/* Read a number that may have a sign, behind which nothing may stand. */
batten_status bat_signed_read(bat_reader *r, bat_quantity *out);

#endif
