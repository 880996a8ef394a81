/* Commands that are a design of one feature: fit, fair, check, draw. */
#ifndef CLI_SINGLE_H
#define CLI_SINGLE_H
#include "commands/results.h"

typedef struct {
    const char *command;
    const char *operation; /* a feature, or NULL: the output works on what was read */
    const char *settings;  /* of the operation, as in a design, ", amount: 2"; or NULL */
    const char *choice; /* the option that chose the operation: none of its parameters, though
                           one may have its name; or NULL */
    const char *output_operation; /* of the output, or NULL: written by its ending */
    const char *output; /* file name; "-": printed, with `output_ending` to choose the form */
    const char *output_ending;
    bool is_plain; /* options give those values alone that are required */
} single;

/* Read the file, apply the operation, write the output; options of the feature's name are its
 * parameters. */
int single_run(const single *s, const arguments *given);

#endif
