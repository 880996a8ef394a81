/* Tables of command lines: see lines.h. */
#include "cli/lines.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* A line of length 4, a circle of radius 2, a rectangle 4 x 3, a sphere of radius 1, and a curve through points. */
static const char shapes[] = "batten: 1\nunits: m\nparameters:\n  long: 4 m\nfeatures:\n"
                             "  one: {line: [[0, 0], [=long, 0]]}\n"
                             "  ring: {circle: 2}\n"
                             "  net: {points: [[0, 0], [4, 0], [0, 3], [4, 3]], columns: 2}\n"
                             "  sheet: {bezier-surface: net}\n"
                             "  ball: {sphere: 1}\n"
                             "  ducks: {points: [[0, 0], [1, 1], [2, 0], [3, 1]]}\n"
                             "  bow: {interpolate: ducks}\n"
                             "outputs:\n"
                             "  one.igs: one\n"
                             "  all.step: {write: [one, ring, sheet, ball]}\n"
                             "  sheet.step: sheet\n"
                             "  report.txt: {check: bow}\n"
                             "  report.json: {check: bow}\n";

static const char *folder(void)
{
    static char path[400];
    snprintf(path, sizeof path, "%s", test_scratch("lines"));
    mkdir(path, 0700);
    char name[460];
    snprintf(name, sizeof name, "%s/all.yaml", path);
    test_write(name, shapes);
    snprintf(name, sizeof name, "%s/ducks.xyz", path);
    test_write(name, "0 0\n1 .6\n2 .1\n3 .9\n");
    return path;
}

static int wrong;

static void check_words(const line_row *row, const char *what, const char *text,
                        const char *wanted)
{
    if (!wanted)
        return;
    bool good = wanted[0] || !text[0];
    if (wanted[0] == '=')
        good = strcmp(text, wanted + 1) == 0;
    for (const char *at = wanted; good && wanted[0] != '=' && *at;) {
        char word[400];
        const size_t length = strcspn(at, "|");
        const bool absent = *at == '!';
        snprintf(word, sizeof word, "%.*s", (int)(length - absent), at + absent);
        good = (strstr(text, word) == NULL) == absent;
        at += length + (at[length] == '|');
    }
    if (good)
        return;
    wrong++;
    fprintf(stderr, "%s\n    %s should have: %s\n    it is: %.1500s\n", row->line, what, wanted,
            text);
}

void run_lines(const line_row *rows, int count)
{
    const char *at = folder();
    wrong = 0;
    for (int i = 0; i < count; i++) {
        char line[1500];
        snprintf(line, sizeof line, "cd '%s' && %s", at, rows[i].line);
        const test_process run = test_shell(line);
        if (run.exit != rows[i].exit) {
            wrong++;
            fprintf(stderr, "%s\n    exit %d, not %d: %s\n", rows[i].line, run.exit,
                    rows[i].exit, run.errors);
        }
        check_words(&rows[i], "standard output", run.out, rows[i].out);
        check_words(&rows[i], "standard error", run.errors, rows[i].errors);
    }
    char all[500];
    snprintf(all, sizeof all, "rm -rf '%s'", at);
    test_shell(all);
    CHECK_INT(wrong, 0);
}
