/* Words and numbers of a stretch of text, by lines or over them. */
#ifndef BAT_SCAN_H
#define BAT_SCAN_H
#include "exchange/reading/input.h"

typedef struct {
    const char *at, *end;
    int line; /* where `at` stands, from 1 */
} bat_scan;

bat_scan bat_scan_begin(const char *text, size_t length);
/* The next word, on whichever line it stands; false at the end. */
bool bat_next_word(bat_scan *words, bat_span *word);
/* The next word of the line; false at its end, where `words` stays. */
bool bat_next_in_line(bat_scan *words, bat_span *word);
/* Go from the end of a line to the next; false when there is none. */
bool bat_next_scan_line(bat_scan *words);
/* What is left of the line, without blanks around it; `words` then stands at its end. */
bat_span bat_rest_of_line(bat_scan *words);

bool bat_word_is(bat_span word, const char *text);
/* The same, whatever the case of the letters. */
bool bat_word_is_like(bat_span word, const char *text);
/* Is it a number that a double can hold? */
bool bat_word_number(bat_span word, double *value);
/* The same; one that is too small for a double is 0, with a note. */
bool bat_word_real(const bat_input *input, int line, bat_span word, double *value);
bool bat_word_integer(bat_span word, int64_t low, int64_t high, int64_t *value);
/* A copy that ends with a zero byte, cut where it does not fit. */
void bat_word_copy(bat_span word, size_t size, char *copy);

/* Do these bytes stand at `at`? */
bool bat_begins(const bat_input *input, size_t at, const char *bytes);
/* The first byte after a byte order mark and leading white space. */
size_t bat_past_white(const bat_input *input);

#endif
