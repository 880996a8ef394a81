/* Options of the command line as values of a design. */
#ifndef CLI_VALUES_H
#define CLI_VALUES_H
#include "command.h"

/* How far it is to the first of `stops` outside of brackets, or to the end. */
size_t value_span(const char *text, const char *stops);

/* Add ", name: value" when the parameter was given: "[1, 0, 0]" is a list as in a design, and
 * so is "1,0,0" where lists or points of numbers are taken; several options make one list. */
void values_add(batten_text *text, const arguments *given, const batten_parameter *parameter);

#endif
