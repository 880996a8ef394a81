/* The program `batten`: one word chooses the command, a table knows them all. */
#include "commands/help.h"
#include "commands/method.h"
#include "value_check.h"

#include <batten/design.h>
#include <batten/text.h>
#include <stdio.h>
#include <string.h>

static int run_help(const arguments *given);

static const option help_options[] = {
    {"as", 0, OPTION_VALUE, "FORM",
     "print the whole manual as man, man-design, completion, literature, or the schema of designs"},
};

/* The manual is made from the table of commands, so it is the one command that belongs here. */
static const command command_help = {
    .name = "help",
    .usage = "[TOPIC | WORD ...]",
    .summary = "the manual, offline",
    .manual =
        "TOPIC is a command, a feature, 'features', 'design', 'formats' or 'files'. Any other\n"
        "WORDs are looked for in the whole manual, with accents or without: names that books\n"
        "and other programs use, authors, parameters, places in the literature ('batten help\n"
        "section III.6', 'batten help paper 10', 'batten help formula 12.7.14').",
    .most_files = 16,
    .option_count = 1,
    .options = help_options,
    .run = run_help,
};

static const command *const commands[] = {
    &command_build,   &command_fit,     &command_fair,         &command_check,
    &command_info,    &command_measure, &command_hydrostatics, &command_eval,
    &command_convert, &command_draw,    &command_compare,      &command_help,
};
#define COMMAND_COUNT ((int)(sizeof commands / sizeof commands[0]))

static int run_help(const arguments *given)
{
    return help_show(given, &(command_table){COMMAND_COUNT, commands});
}

static const command *find_command(const char *name)
{
    for (int i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(commands[i]->name, name) == 0)
            return commands[i];
    return NULL;
}

/* Complain about a name that is not a command, with the nearest one. */
static void complain_of_command(const char *name)
{
    const char *names[COMMAND_COUNT];
    for (int i = 0; i < COMMAND_COUNT; i++)
        names[i] = commands[i]->name;
    const char *near = nearest_name(name, COMMAND_COUNT, names);
    complain("batten: there is no command '%s'%s%s%s; see 'batten help'", name,
             near ? "; did you mean '" : "", near ? near : "", near ? "'" : "");
}

/* The value of --method, which says whose parameters are options; NULL when it is not given. */
static const char *find_method(const command *c, int count, char **words)
{
    static const char key[] = "--method";
    const size_t length = sizeof key - 1;
    if (!command_has_option(c, "method"))
        return NULL;
    for (int i = 0; i < count; i++) {
        if (strncmp(words[i], key, length) == 0 && words[i][length] == '=')
            return words[i] + length + 1;
        if (strcmp(words[i], key) == 0 && i + 1 < count)
            return words[i + 1];
    }
    return NULL;
}

static int run_job(const command *c, const arguments *given)
{
    int threads = 0;
    if (arguments_has(given, "threads") &&
        !arguments_count(c->name, given, "threads", 1, MOST_THREADS, &threads))
        return EXIT_USAGE;
    job_begin(arguments_has(given, "quiet"), threads);
    int status = c->run(given);
    if (status == EXIT_FAILED)
        status = job_exit(status); /* a signal made it fail */
    job_end();
    return status;
}

static int run_command(const command *c, int count, char **words)
{
    for (int i = 0; i < count && strcmp(words[i], "--") != 0; i++)
        if (strcmp(words[i], "--help") == 0 || strcmp(words[i], "-h") == 0) {
            const char *files[] = {c->name};
            return run_help(&(arguments){.file_count = 1, .files = files});
        }

    int option_count = 0;
    const char *choice = find_method(c, count, words);
    option *options = command_options(c, choice, &option_count);
    if (!options)
        return output_failed(c->name, BATTEN_OUT_OF_MEMORY);
    arguments given;
    int status = EXIT_USAGE;
    if (arguments_read(c->name, option_count, options, c->least_files, c->most_files, count,
                       words, &given)) {
        if (value_check_all(c, command_feature(c, choice), &given))
            status = run_job(c, &given);
        arguments_free(&given);
    }
    batten_release(options);
    return status;
}

int main(int count, char **words)
{
    if (count > 1 && (strcmp(words[1], "--version") == 0 || strcmp(words[1], "-V") == 0)) {
        batten_text text = BATTEN_TEXT;
        batten_text_add(&text, "batten %s\n", batten_version());
        return output_print(&text);
    }
    if (count < 2) {
        run_help(&(arguments){0});
        return EXIT_USAGE;
    }
    const char *name =
        strcmp(words[1], "--help") == 0 || strcmp(words[1], "-h") == 0 ? "help" : words[1];
    const command *c = find_command(name);
    if (!c) {
        complain_of_command(name);
        return EXIT_USAGE;
    }
    return run_command(c, count - 2, words + 2);
}
