/* Numbers of a text where line ends mean nothing, with failures that say the line. */
#ifndef BAT_WORDS_H
#define BAT_WORDS_H
#include "exchange/reading/input.h"
#include "exchange/reading/scan.h"

typedef struct {
    bat_input *input;
    bat_scan scan;
    bat_span word;    /* the last one */
    int line;         /* of the last word, from 1 */
    bool begins_line; /* it is the first of its line */
} bat_words;

void bat_words_begin(bat_words *words, bat_input *input);
/* Go to the next word; false at the end. */
bool bat_words_next(bat_words *words);

/* The next word as a number; `what` names it in a failure, which says the line. BAD_FORMAT also
 * when the text ends. */
batten_status bat_words_real(bat_words *words, const char *what, double *value);
/* A whole number from `low` to `high`. */
batten_status bat_words_integer(bat_words *words, const char *what, int low, int high,
                                int *value);
/* Many numbers into new memory. More than could stand in the rest of the text are refused
 * before anything is allocated. */
batten_status bat_words_reals(bat_words *words, const char *what, size_t count, double **out);
/* `count` things of `least` words each that a header promises: could they stand in the rest? */
batten_status bat_words_check(const bat_words *words, const char *what, size_t count,
                              size_t least);

#endif
