/* The parameters of an entity, told apart and read as numbers. */
#ifndef BAT_IGES_PARAMETERS_H
#define BAT_IGES_PARAMETERS_H
#include "exchange/reading/input.h"

#include <stdint.h>

typedef enum {
    BAT_IGES_EMPTY,
    BAT_IGES_NUMBER,
    BAT_IGES_STRING,
    BAT_IGES_OTHER /* what is none of these, also numbers that are too large */
} bat_iges_token_kind;

typedef struct {
    uint32_t begin, length; /* where it stands in the text; of a string its characters */
    bat_iges_token_kind kind;
} bat_iges_token;

/* Used again and again, so that memory is asked for but a few times. */
typedef struct {
    const char *records; /* as they stand in the file, */
    size_t stride;       /* so far from one to the next */
    size_t in_place;     /* characters, 64 of each, that were read there */
    bat_list text;   /* of char: the columns of the records behind these, one after another */
    bat_list tokens; /* of bat_iges_token, which count all characters */
    bat_list values; /* of double: of each token the number, or 0 */
    size_t odd;      /* tokens that are neither numbers nor empty */
    size_t vanished; /* the last number that is too small for a double and is 0; 0 for none */
} bat_iges_parameters;

enum {
    BAT_IGES_BLOCK = 64, /* columns of a record that hold parameters */
    /* Longer than any number that says something: a double has at most 767 significant digits.
     */
    BAT_IGES_LONGEST_NUMBER = 1100
};

typedef struct {
    char delimiter, terminator;
} bat_iges_delimiters;

void bat_iges_parameters_begin(bat_iges_parameters *parameters);
void bat_iges_parameters_end(bat_iges_parameters *parameters);
/* Forget what was read, but not the room for it. */
void bat_iges_parameters_clear(bat_iges_parameters *parameters);

/* ---- telling apart (tokens.c) ---- */

/* From `at` on the first place that is not a blank, or the end of the text. */
static inline size_t bat_iges_past_blanks(bat_span text, size_t at)
{
    while (at < text.length && text.bytes[at] == ' ')
        at++;
    return at;
}

/* Read what is in records of the file, as long as it is numbers that do not lie in two of them;
 * *at is then behind these. What follows is to be put into the text from in_place on. */
batten_status bat_iges_tokenise_in_place(bat_input *input, bat_iges_delimiters delimiters,
                                         bat_iges_parameters *parameters, const char *records,
                                         size_t stride, size_t count, size_t *at, bool *done);
/* Read on from *at, which is then behind the last token that was whole. *done when that ended
 * with the terminator; else there is more text to come. BAD_FORMAT with a message. */
batten_status bat_iges_tokenise(bat_input *input, bat_iges_delimiters delimiters,
                                bat_iges_parameters *parameters, size_t *at, bool *done);

/* ---- values ---- */

/* How many there are, the type first. */
size_t bat_iges_count_of(const bat_iges_parameters *parameters);
/* The characters of a parameter; none when there is no such. */
bat_span bat_iges_text(const bat_iges_parameters *parameters, size_t index, bool *is_string);
/* Numbers; what is empty or not there is 0. BAD_FORMAT with a message that names `index`. */
batten_status bat_iges_real(const bat_iges_parameters *parameters, size_t index, double *value);
batten_status bat_iges_reals(const bat_iges_parameters *parameters, size_t first, size_t count,
                             double *values);
/* The same where they stand already, until the parameters are read anew; all must be there. */
batten_status bat_iges_reals_in_place(const bat_iges_parameters *parameters, size_t first,
                                      size_t count, const double **values);
batten_status bat_iges_integer(const bat_iges_parameters *parameters, size_t index, int *value);

#endif
