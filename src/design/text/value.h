/* Numbers with units, and expressions over them. */
#ifndef BAT_DESIGN_VALUE_H
#define BAT_DESIGN_VALUE_H
#include "base/base.h"

/* A number in design units to the power `length`, times radians to the power `angle`. */
typedef struct {
    double value;
    int length, angle;
} bat_quantity;

/* What names mean in an expression. */
typedef struct {
    double unit_metres; /* of the design */
    /* The value of a parameter, or NULL when there is none of that name. */
    const bat_quantity *(*find)(void *user, const char *name, size_t length);
    void *user;
    const char *(*nearest)(void *user, const char *name); /* or NULL */
} bat_names;

/*
 * Read "3", "3.2 m", "90 deg", "5 ft 6 1/2 in", "5' 6\"", or after '=' an expression with
 * + - * / ^ ( ), parameters, pi and sin cos tan sqrt abs min max.
 *
 * @param[out] vanished  true when a number was too small for a double and became 0; may be NULL
 */
batten_status bat_quantity_read(const char *text, const bat_names *names, bool *vanished,
                                bat_quantity *out);

/* A whole number as a count: digits alone. */
batten_status bat_count_read(const char *text, int *out);

/* "a length", "a number", "an area" ...; `text` [48] is used for those without a name. */
const char *bat_dimension_name(int length, int angle, char *text);

/* Is this pi or a function, and so no name for a parameter? */
bool bat_expression_has_word(const char *name, size_t length);
/* Go through the names of an expression that are not functions. `*position` begins at 0.
 * @return false at the end */
bool bat_expression_next_name(const char *text, size_t *position, const char **name,
                              size_t *length);

#endif
