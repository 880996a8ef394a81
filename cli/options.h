/* The words of a command line: options from a table, and the rest. */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H
#include <batten/base.h>

typedef enum {
    OPTION_FLAG,   /* --json */
    OPTION_SWITCH, /* --comb, which is --comb=yes; or --comb=no */
    OPTION_VALUE,  /* --within 2mm, --within=2mm */
    OPTION_MANY    /* --set a=1 --set b=2 */
} option_kind;

typedef struct {
    const char *name;
    char letter; /* 0 for none */
    option_kind kind;
    const char *value; /* what the value is called in the help */
    const char *help;
} option;

/* What was found. Texts belong to argv. */
typedef struct {
    int option_count;
    const option *options;
    int given_count;
    struct given {
        int option;
        const char *value;
    } * given;
    int file_count;
    const char **files;
} arguments;

/* Sort the words; a complaint goes to standard error. At most `most` words that are not options.
 * `--` ends the options; a lone `-` is a file. False for a usage error. */
bool arguments_read(const char *command, int option_count, const option *options, int least,
                    int most, int count, char **words, arguments *out);
void arguments_free(arguments *read);

/* The value of an option, "" of a flag, NULL when it was not given. */
const char *arguments_get(const arguments *read, const char *name);
bool arguments_has(const arguments *read, const char *name);
/* *index becomes the place of the value among these words; false when it is not one of them. */
bool arguments_word(const arguments *read, const char *name, int count,
                    const char *const *words, int *index);
/* A finite number; false with a complaint when something else was given; untouched when nothing
 * was. */
bool arguments_number(const char *command, const arguments *read, const char *name,
                      double *value);
bool arguments_count(const char *command, const arguments *read, const char *name, int least,
                     int most, int *value);

#endif
