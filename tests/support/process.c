#define _XOPEN_SOURCE 700
#include "support/process.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* The command that is tested: that of the build, or another that BATTEN_COMMAND names (dev
 * mutants). */
static const char *command_path(void)
{
    const char *other = getenv("BATTEN_COMMAND");
    return other && *other ? other : TESTS_BUILD "/cli/batten";
}

const char *test_content(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    size_t capacity = 1 << 16, length = 0, got;
    char *text = malloc(capacity);
    while (text && (got = fread(text + length, 1, capacity - length - 1, file)) > 0) {
        length += got;
        if (capacity - length < 2)
            text = realloc(text, capacity *= 2);
    }
    fclose(file);
    if (!text)
        abort();
    text[length] = 0;
    char *kept = test_array(length + 1, 1);
    memcpy(kept, text, length + 1);
    free(text);
    return kept;
}

void test_write(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL);
    CHECK(fwrite(text, 1, strlen(text), file) == strlen(text));
    CHECK(fclose(file) == 0);
}

static void redirect(const char *path, int flags, int to)
{
    const int file = open(path, flags, 0600);
    if (file < 0 || dup2(file, to) < 0)
        _exit(126);
    close(file);
}

test_process test_run(const char *input, const char *const *words)
{
    const char *in = test_scratch("stdin"), *out = test_scratch("stdout"),
               *errors = test_scratch("stderr");
    test_write(in, input ? input : "");
    const char *program = strcmp(words[0], "batten") == 0 ? command_path() : words[0];
    fflush(NULL);
    const pid_t child = fork();
    CHECK(child >= 0);
    if (child == 0) {
        setenv("BATTEN", command_path(), 1);
        redirect(in, O_RDONLY, 0);
        redirect(out, O_WRONLY | O_CREAT | O_TRUNC, 1);
        redirect(errors, O_WRONLY | O_CREAT | O_TRUNC, 2);
        /* exec does not write into its words. */
        execvp(program, (char *const *)(uintptr_t)words);
        _exit(127);
    }
    int status = 0;
    CHECK(waitpid(child, &status, 0) == child);
    test_process done = {.out = test_content(out), .errors = test_content(errors)};
    done.exit = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return done;
}

test_process test_shell(const char *line)
{
    return RUN("sh", "-c", line);
}
