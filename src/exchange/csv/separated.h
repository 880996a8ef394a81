/*
 * Text in rows and columns: separated by commas, semicolons, tabs or blanks. Fields may stand
 * in double quotes, a quote inside them doubled. Blank lines, and lines whose first field
 * begins with
 * '#' (also inside quotes), are no rows.
 */
#ifndef BAT_SEPARATED_H
#define BAT_SEPARATED_H
#include "exchange/reading/input.h"
#include <batten/text.h>

typedef struct {
    const char *text; /* ends with a zero byte */
    int column;       /* of its first character in the line, from 1 */
} bat_field;

typedef struct {
    bat_input *input;
    char separator; /* ',' ';' '\t', or ' ' for runs of blanks and tabs */
    bool tabs_are_blanks, no_quotes;
    size_t at;      /* where the next line begins */
    int line;       /* of the current row, from 1 */
    bool after_gap; /* did a blank line stand before the current row? */
    int comments;   /* so far */
    bat_span raw;   /* the current row as it stands */
    int count;
    const bat_field *fields; /* [count], valid until the next row */
    bat_list list;
    char *text;
    size_t capacity;
} bat_separated;

void bat_separated_begin(bat_separated *table, bat_input *input);
void bat_separated_end(bat_separated *table);
/* Go to the next row and cut it into fields. The separator is that of the first row unless it
 * was set before. *more is false at the end. */
batten_status bat_separated_next(bat_separated *table, bool *more);

/* Name the field in a failure: "hull.csv:3: column 7: ...". */
batten_status bat_field_fail(const bat_separated *table, int field, const char *format, ...)
    BATTEN_PRINTF(3, 4);
/* The number of a field; one too small for a double is 0, with a note. */
batten_status bat_field_number(const bat_separated *table, int field, double *value);
/* Feet, inches and eighths of an inch, "1-7-4": inches below 12, but in the names of lines, "0-36-0". */
bool bat_read_feet(const char *text, bool is_name, double *inches);
/* Feet, inches and eighths, in inches, which sets *has_feet, or a number; NaN where nothing is. Eight eighths are borne with a
 * note. */
batten_status bat_field_length(const bat_separated *table, int field, bool *has_feet,
                               double *value);
/* Is nothing there: blank, "-" or "x"? */
bool bat_field_is_absent(const bat_separated *table, int field);
/* Does a number stand there? */
bool bat_field_is_number(const bat_separated *table, int field);

/* How many fields the row has without empty ones at its end. */
int bat_row_length(const bat_separated *table);
/* Refuse a row that has not `count` fields; further ones must be empty. */
batten_status bat_row_check(const bat_separated *table, int count);

/* Write a field in quotes, its own quotes doubled; line ends become blanks. */
void bat_put_quoted(batten_text *text, const char *field);

/* Are two words the same but for the case of their letters A to Z? */
bool bat_same_word(const char *a, const char *b);

#endif
