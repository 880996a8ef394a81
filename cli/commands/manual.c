/* The manual pages and the completion of the shell, made from the tables of commands and features. */
#include "commands/manual.h"

#include <batten/design.h>
#include <batten/text.h>
#include <string.h>

static void add_character(batten_text *text, const char *c)
{
    if (*c == '\\')
        batten_text_add(text, "\\e");
    else if (*c == '-')
        batten_text_add(text, "\\-");
    else
        batten_text_bytes(text, c, 1);
}

/* Text as troff wants it: backslashes and leading dots made harmless. */
static void add_escaped(batten_text *text, const char *words)
{
    bool at_start = true;
    for (const char *c = words; *c; c++) {
        if (at_start && (*c == '.' || *c == '\''))
            batten_text_add(text, "\\&");
        add_character(text, c);
        at_start = *c == '\n';
    }
}

static void add_section(batten_text *text, const char *title)
{
    batten_text_add(text, ".SH %s\n", title);
}

/* A tagged paragraph: the term, then what it is. */
static void add_term(batten_text *text, const char *term, const char *explanation)
{
    batten_text_add(text, ".TP\n.B \"");
    add_escaped(text, term);
    batten_text_add(text, "\"\n");
    add_escaped(text, explanation);
    batten_text_add(text, "\n");
}

static void add_literal(batten_text *text, const char *words)
{
    batten_text_add(text, ".PP\n.nf\n");
    add_escaped(text, words);
    batten_text_add(text, "\n.fi\n");
}

static void add_header(batten_text *text, const char *name, int section, const char *summary)
{
    batten_text_add(text, ".TH %s %d \"\" \"Batten %s\" \"Batten\"\n", name, section,
                    batten_version());
    add_section(text, "NAME");
    add_escaped(text, summary);
    batten_text_add(text, "\n");
}

static void add_option_head(batten_text *text, const option *o)
{
    batten_text_add(text, ".TP\n.B \\-\\-");
    add_escaped(text, o->name);
    if (o->letter)
        batten_text_add(text, ", \\-%c", o->letter);
    if (o->kind == OPTION_VALUE || o->kind == OPTION_MANY) {
        batten_text_add(text, " ");
        add_escaped(text, o->value);
    }
}

static void add_command(batten_text *text, const command *c)
{
    int count = 0;
    option *options = command_options(c, NULL, &count);
    batten_text_add(text, ".SS \"batten ");
    add_escaped(text, c->name);
    batten_text_add(text, " ");
    add_escaped(text, c->usage);
    batten_text_add(text, "\"\n");
    add_escaped(text, c->summary);
    batten_text_add(text, ".\n.PP\n");
    add_escaped(text, c->manual);
    batten_text_add(text, "\n");
    for (int i = 0; options && i < count; i++) {
        add_option_head(text, &options[i]);
        batten_text_add(text, "\n");
        add_escaped(text, options[i].help);
        batten_text_add(text, "\n");
    }
    const char *units = options ? command_value_units(count, options) : NULL;
    if (units)
        batten_text_add(text, ".PP\n%s\n", units);
    batten_release(options);
}

void manual_page(batten_text *text, const command_table *table)
{
    add_header(text, "BATTEN", 1,
               "batten - from points to fair, manufacturable free-form curves and surfaces");
    add_section(text, "SYNOPSIS");
    batten_text_add(text, ".B batten\n.I command\n[\\fIargument\\fR ...]\n");
    add_section(text, "COMMANDS");
    for (int i = 0; i < table->count; i++)
        add_command(text, table->at[i]);
    add_section(text, "FILES");
    add_escaped(text,
                "IN is a file, file#name for one object in it, or - for standard input.\n");
    add_section(text, "EXIT STATUS");
    add_term(text, "0", "done");
    add_term(text, "1", "failed, or a bound is not met");
    add_term(text, "2", "wrong usage");
    add_term(text, "3", "only a part of a file could be read");
    add_term(text, "130, 143", "interrupted; nothing half-written remains");
    add_section(text, "SEE ALSO");
    batten_text_add(text, ".BR batten-design (5)\n");
}

static void add_formula(batten_text *text, const batten_feature *f)
{
    add_literal(text, f->formula);
    batten_text_add(text, ".PP\n");
    add_escaped(text, f->promise);
    batten_text_add(text, "\n");
}

/* Nothing where there are no words. */
static void add_between(batten_text *text, const char *before, const char *words,
                        const char *after)
{
    if (!words)
        return;
    batten_text_add(text, "%s", before);
    add_escaped(text, words);
    batten_text_add(text, "%s", after);
}

static void add_feature(batten_text *text, const batten_feature *f)
{
    batten_text_add(text, ".SS %s\n", f->name);
    add_escaped(text, f->summary);
    batten_text_add(text, ".\n.PP\n");
    add_escaped(text, f->manual);
    batten_text_add(text, "\n");
    if (f->formula)
        add_formula(text, f);
    for (int i = 0; i < f->parameter_count; i++) {
        const batten_parameter *p = &f->parameters[i];
        add_term(text, p->name, p->summary);
        add_between(text, "(", p->words, ")\n");
        add_between(text, "Default: ", p->standard, ".\n");
    }
    add_literal(text, f->example);
}

void manual_design_page(batten_text *text)
{
    add_header(text, "BATTEN\\-DESIGN", 5,
               "batten-design - the file that says how shapes come to be");
    add_section(text, "DESCRIPTION");
    batten_text_add(text,
                    "A design is a YAML file. The first key of a feature names its operation.\n"
                    "See\n"
                    ".B batten help design\n"
                    "for the shape of the file.\n");
    for (int output = 0; output < 2; output++) {
        add_section(text, output ? "OUTPUTS" : "OPERATIONS");
        for (int i = 0; i < batten_feature_count(); i++)
            if (batten_feature_at(i)->is_output == (output == 1))
                add_feature(text, batten_feature_at(i));
    }
    add_section(text, "SEE ALSO");
    batten_text_add(text, ".BR batten (1)\n");
}

static void add_case(batten_text *text, const command *c)
{
    int count = 0;
    option *options = command_options(c, NULL, &count);
    batten_text_add(text, "    %s) options='", c->name);
    for (int k = 0; options && k < count; k++)
        batten_text_add(text, "--%s ", options[k].name);
    for (int k = 0; strcmp(c->name, "help") == 0 && k < batten_feature_count(); k++)
        batten_text_add(text, "%s ", batten_feature_at(k)->name);
    batten_text_add(text, "' ;;\n");
    batten_release(options);
}

void manual_completion(batten_text *text, const command_table *table)
{
    batten_text_add(text, "# bash completion for batten\n"
                          "_batten()\n"
                          "{\n"
                          "    local word=${COMP_WORDS[COMP_CWORD]} options=\n"
                          "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
                          "        COMPREPLY=($(compgen -W '");
    for (int i = 0; i < table->count; i++)
        batten_text_add(text, "%s ", table->at[i]->name);
    batten_text_add(text,
                    "' -- \"$word\"))\n        return\n    fi\n    case ${COMP_WORDS[1]} in\n");
    for (int i = 0; i < table->count; i++)
        add_case(text, table->at[i]);
    batten_text_add(
        text,
        "    esac\n"
        "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\") $(compgen -f -- \"$word\"))\n"
        "}\n"
        "complete -o filenames -F _batten batten\n");
}
