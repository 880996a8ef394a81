/* Running a program as a user would. */
#ifndef TESTS_SUPPORT_PROCESS_H
#define TESTS_SUPPORT_PROCESS_H
#include "support/test.h"

typedef struct {
    int exit;        /* its status; 128 + the signal that killed it */
    const char *out; /* what it wrote; freed with the test */
    const char *errors;
} test_process;

/* Run words, the last being NULL, with standard input from `input` (NULL: nothing). A first
 * word "batten" means the command that was just built. */
test_process test_run(const char *input, const char *const *words);
#define RUN(...) test_run(NULL, (const char *const[]){__VA_ARGS__, NULL})

/* Run a line by the shell; $BATTEN is the command. */
test_process test_shell(const char *line);

/* The whole content of a file, or NULL. */
const char *test_content(const char *path);
/* Put text into a file. */
void test_write(const char *path, const char *text);

#endif
