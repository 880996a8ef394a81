/* A method as one chooses it on the command line: "tension:amount=5:ends=natural". */
#ifndef CLI_METHOD_H
#define CLI_METHOD_H
#include "command.h"

enum { METHOD_SIZE = 96 };

/* An operation, with settings as one would write them in a design. */
typedef struct {
    char name[METHOD_SIZE];      /* "tension amount=5": as the user wrote it */
    char operation[METHOD_SIZE]; /* "tension" */
    char settings[METHOD_SIZE];  /* ", amount: 5" */
} method;

/* The part of the word that names the operation. */
size_t method_length(const char *word);
/* Read `length` characters; false after a complaint, when they name no operation. */
bool method_choose(const char *asker, const char *word, size_t length, method *out);

#endif
