/* The options of a command: its own, and the parameters of the feature that it carries out. */
#include "commands/method.h"

#include <string.h>

bool command_has_option(const command *c, const char *name)
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

const batten_feature *command_feature(const command *c, const char *choice)
{
    char chosen[METHOD_SIZE] = "";
    const char *name = choice ? chosen : c->feature;
    if (choice && method_length(choice) < sizeof chosen)
        memcpy(chosen, choice, method_length(choice));
    return name ? batten_feature_find(name) : NULL;
}

option *command_options(const command *c, const char *choice, int *count)
{
    const batten_feature *feature = command_feature(c, choice);
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
        if (!command_has_option(c, p->name))
            all[(*count)++] =
                (option){p->name, 0, kind, p->words ? p->words : value_name(p), p->summary};
    }
    return all;
}
