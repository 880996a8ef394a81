/* The program `batten`: one word chooses the command, a table knows them all. */
#include "commands/method.h"

#include <batten/design.h>
#include <batten/text.h>
#include <stdio.h>
#include <string.h>

static const command *const commands[] = {
    &command_build, &command_fit,     &command_fair, &command_check,
    &command_info,  &command_measure, &command_eval, &command_convert,
    &command_draw,  &command_compare, &command_help,
};

int command_count(void)
{
    return (int)(sizeof commands / sizeof commands[0]);
}

const command *command_at(int index)
{
    return commands[index];
}

const command *command_find(const char *name)
{
    for (int i = 0; i < command_count(); i++)
        if (strcmp(commands[i]->name, name) == 0)
            return commands[i];
    return NULL;
}

void command_complain(const char *name)
{
    const char *names[sizeof commands / sizeof commands[0]];
    for (int i = 0; i < command_count(); i++)
        names[i] = commands[i]->name;
    const char *near = nearest_name(name, command_count(), names);
    complain("batten: there is no command '%s'%s%s%s; see 'batten help'", name,
             near ? "; did you mean '" : "", near ? near : "", near ? "'" : "");
}

static bool has_own_option(const command *c, const char *name)
{
    for (int i = 0; i < c->option_count; i++)
        if (strcmp(c->options[i].name, name) == 0)
            return true;
    return false;
}

static const char *value_name(const batten_parameter *p)
{
    return p->kind == BATTEN_VALUE_ANGLE    ? "ANGLE"
           : p->kind == BATTEN_VALUE_LENGTH ? "LENGTH"
                                            : "VALUE";
}

const char *command_value_units(int count, const option *options)
{
    bool length = false, angle = false;
    for (int i = 0; i < count; i++) {
        length |= options[i].value && strcmp(options[i].value, "LENGTH") == 0;
        angle |= options[i].value && strcmp(options[i].value, "ANGLE") == 0;
    }
    return length && angle ? "An ANGLE has a unit, 30deg or 0.5rad; a LENGTH may have one, 2mm."
           : angle         ? "An ANGLE has a unit, 30deg or 0.5rad."
           : length        ? "A LENGTH may have a unit, 2mm."
                           : NULL;
}

option *command_options(const command *c, const char *choice, int *count)
{
    char chosen[METHOD_SIZE] = "";
    const char *name = choice ? chosen : c->feature;
    if (choice && method_length(choice) < sizeof chosen)
        memcpy(chosen, choice, method_length(choice));
    const batten_feature *feature = name ? batten_feature_find(name) : NULL;
    const int more = feature ? feature->parameter_count : 0;
    option *all = batten_array((size_t)(c->option_count + more) + 1, sizeof *all);
    if (!all)
        return NULL;
    memcpy(all, c->options, (size_t)c->option_count * sizeof *all);
    *count = c->option_count;
    /* The first parameter is the input, which is a word of the command line. */
    for (int i = 1; i < more; i++) {
        const batten_parameter *p = &feature->parameters[i];
        const option_kind kind = p->kind == BATTEN_VALUE_YES_NO ? OPTION_SWITCH
                                 : p->is_list                   ? OPTION_MANY
                                                                : OPTION_VALUE;
        if (!has_own_option(c, p->name))
            all[(*count)++] =
                (option){p->name, 0, kind, p->words ? p->words : value_name(p), p->summary};
    }
    return all;
}

/* The value of --method, which says whose parameters are options; NULL when it is not given. */
static const char *find_method(const command *c, int count, char **words)
{
    static const char key[] = "--method";
    const size_t length = sizeof key - 1;
    if (!has_own_option(c, "method"))
        return NULL;
    for (int i = 0; i < count; i++) {
        if (strncmp(words[i], key, length) == 0 && words[i][length] == '=')
            return words[i] + length + 1;
        if (strcmp(words[i], key) == 0 && i + 1 < count)
            return words[i + 1];
    }
    return NULL;
}

static int run(const command *c, int count, char **words)
{
    for (int i = 0; i < count && strcmp(words[i], "--") != 0; i++)
        if (strcmp(words[i], "--help") == 0 || strcmp(words[i], "-h") == 0) {
            const char *files[] = {c->name};
            return command_help.run(&(arguments){.file_count = 1, .files = files});
        }

    int option_count = 0;
    option *options = command_options(c, find_method(c, count, words), &option_count);
    if (!options)
        return output_failed(c->name, BATTEN_OUT_OF_MEMORY);
    arguments given;
    int status = EXIT_USAGE;
    if (arguments_read(c->name, option_count, options, c->least_files, c->most_files, count,
                       words, &given)) {
        job_begin(arguments_has(&given, "quiet"));
        status = c->run(&given);
        if (status == EXIT_FAILED)
            status = job_exit(status); /* a signal made it fail */
        job_end();
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
        command_help.run(&(arguments){0});
        return EXIT_USAGE;
    }
    const char *name =
        strcmp(words[1], "--help") == 0 || strcmp(words[1], "-h") == 0 ? "help" : words[1];
    const command *c = command_find(name);
    if (!c) {
        command_complain(name);
        return EXIT_USAGE;
    }
    return run(c, count - 2, words + 2);
}
