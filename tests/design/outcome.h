/* What a design came to, for tests that compare one design with another. */
#ifndef TESTS_DESIGN_OUTCOME_H
#define TESTS_DESIGN_OUTCOME_H
#include "support/test.h"

/* All that a design came to: how it ended, what was said, the boxes and control points of all
 * results but that named "odd", all bytes. */
typedef struct {
    char *said, *made;
} outcome;

/* The files that examples of the manual read; first of all. */
void outcome_write_inputs(void);
outcome outcome_of(const char *text);
void outcome_release(outcome *o);

#endif
