/* Tables of command lines and what they must say: each line is run by a shell in a folder of its own. */
#ifndef TESTS_CLI_LINES_H
#define TESTS_CLI_LINES_H
#include "support/process.h"

/* Words separated by '|' must all be there; behind '!' they must be absent, behind '=' they are the whole text. NULL is
 * not looked at, "" means nothing is written. */
typedef struct {
    const char *line; /* $BATTEN is the command */
    int exit;
    const char *out, *errors;
} line_row;

/* The folder: a design of shapes whose measures are known, and what it makes; see lines.c. */
void run_lines(const line_row *rows, int count);
#define RUN_LINES(rows) run_lines(rows, COUNT(rows))

#endif
