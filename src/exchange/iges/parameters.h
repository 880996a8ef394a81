/* The parameters of an entity, told apart and read as numbers. */
#ifndef BAT_IGES_PARAMETERS_H
#define BAT_IGES_PARAMETERS_H
#include "exchange/input.h"

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
    bat_list text;   /* of char: the columns of the records, one after another */
    bat_list tokens; /* of bat_iges_token */
    bat_list values; /* of double: of each token the number, or 0 */
    size_t odd;      /* tokens that are neither numbers nor empty */
} bat_iges_parameters;

typedef struct {
    char delimiter, terminator;
} bat_iges_delimiters;

void bat_iges_parameters_begin(bat_iges_parameters *parameters);
void bat_iges_parameters_end(bat_iges_parameters *parameters);
/* Forget what was read, but not the room for it. */
void bat_iges_parameters_clear(bat_iges_parameters *parameters);

/* Read on from *at, which is then behind the last token that was whole. *done when that ended
 * with the terminator; else there is more text to come. BAD_FORMAT with a message. */
batten_status bat_iges_tokenise(bat_input *input, bat_iges_delimiters delimiters,
                                bat_iges_parameters *parameters, size_t *at, bool *done);

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
