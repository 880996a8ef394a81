/* `batten help`: what is printed about commands, features, designs, files and formats. */
#include "commands/help.h"
#include "commands/literature.h"
#include "commands/manual.h"
#include "commands/search.h"
#include "formats.h"

#include <batten/design.h>
#include <batten/text.h>
#include <string.h>

static void add_option(batten_text *text, const option *o)
{
    const size_t begin = text->length;
    const bool has_value = o->kind == OPTION_VALUE || o->kind == OPTION_MANY;
    const bool is_long = has_value && strlen(o->value) > 24;
    batten_text_add(text, "  --%s", o->name);
    if (has_value)
        batten_text_add(text, " %s", is_long ? "WORD" : o->value);
    else if (o->kind == OPTION_SWITCH)
        batten_text_add(text, "[=no]");
    if (o->letter)
        batten_text_add(text, ", -%c", o->letter);
    for (size_t column = text->length - begin; column < 26; column++)
        batten_text_add(text, " ");
    batten_text_add(text, "  %s", o->help);
    if (is_long)
        batten_text_add(text, ": %s", o->value);
    batten_text_add(text, "%s\n", o->kind == OPTION_MANY ? " (may be repeated)" : "");
}

static void add_commands(batten_text *text, const command_table *table)
{
    batten_text_add(
        text,
        "batten %s: from points to fair, manufacturable free-form curves and surfaces\n\n"
        "usage: batten COMMAND ...\n\n",
        batten_version());
    for (int i = 0; i < table->count; i++)
        batten_text_add(text, "  %-12s  %s\n", table->at[i]->name, table->at[i]->summary);
    batten_text_add(
        text,
        "\n"
        "'batten help COMMAND' says more; 'batten help design' describes design files, 'batten help\n"
        "formats' lists the formats of files, 'batten help files' describes tables and points;\n"
        "'batten help features' lists the operations, 'batten help NAME' describes one.\n\n"
        "Exit status: 0 done, 1 failed or a bound not met, 2 wrong usage, 3 partly read or measured.\n");
}

static void add_command(batten_text *text, const command *c)
{
    int count;
    option *options = command_options(c, NULL, &count);
    batten_text_add(text, "usage: batten %s %s\n\n%s\n\n%s\n", c->name, c->usage, c->summary,
                    c->manual);
    if (options && count > 0)
        batten_text_add(text, "\nOptions:\n");
    for (int i = 0; options && i < count; i++)
        add_option(text, &options[i]);
    const char *units = options ? command_value_units(count, options) : NULL;
    if (units)
        batten_text_add(text, "\n%s\n", units);
    batten_release(options);
}

static int widest_name(void)
{
    size_t widest = 0;
    for (int i = 0; i < batten_feature_count(); i++)
        if (strlen(batten_feature_at(i)->name) > widest)
            widest = strlen(batten_feature_at(i)->name);
    return (int)widest;
}

static void add_summary(batten_text *text, int width, const batten_feature *f)
{
    batten_text_add(text, "  %-*s %s\n", width, f->name, f->summary);
}

/* The title of a group stands before its first row. */
static void add_operation(batten_text *text, int width, int i)
{
    if (i == 0 || strcmp(batten_feature_group(i), batten_feature_group(i - 1)) != 0)
        batten_text_add(text, "%s%s\n\n", i ? "\n" : "", batten_feature_group(i));
    add_summary(text, width, batten_feature_at(i));
}

static void add_features(batten_text *text)
{
    const int width = widest_name();
    batten_text_add(text, "Operations of a design file:\n\n");
    for (int i = 0; i < batten_feature_count(); i++)
        if (!batten_feature_at(i)->is_output)
            add_operation(text, width, i);
    batten_text_add(text, "\nOutputs of a design file:\n\n");
    for (int i = 0; i < batten_feature_count(); i++)
        if (batten_feature_at(i)->is_output)
            add_summary(text, width, batten_feature_at(i));
}

static const char *kind_name(const batten_parameter *p)
{
    static const char *const names[] = {[BATTEN_VALUE_MODEL] = "a feature",
                                        [BATTEN_VALUE_LENGTH] = "a length",
                                        [BATTEN_VALUE_ANGLE] = "an angle",
                                        [BATTEN_VALUE_NUMBER] = "a number",
                                        [BATTEN_VALUE_COUNT] = "a whole number",
                                        [BATTEN_VALUE_WORD] = "a word",
                                        [BATTEN_VALUE_TEXT] = "a text",
                                        [BATTEN_VALUE_FILE] = "a file",
                                        [BATTEN_VALUE_YES_NO] = "yes or no",
                                        [BATTEN_VALUE_POINT] = "a point",
                                        [BATTEN_VALUE_RANGE] = "a range",
                                        [BATTEN_VALUE_POINTS] =
                                            "a point or a feature with points",
                                        [BATTEN_VALUE_MOVE] = "a move [i, j, k, dx, dy, dz]"};
    return (size_t)p->kind < sizeof names / sizeof names[0] ? names[p->kind] : "a value";
}

static void add_other_names(batten_text *text, const char *also)
{
    batten_text line = BATTEN_TEXT;
    char *words = NULL;
    batten_text_add(&line, "Also known as: %s.", also);
    if (batten_text_take(&line, &words, NULL) == BATTEN_OK)
        literature_wrap(text, "", words);
    batten_text_add(text, "\n");
    batten_release(words);
}

static void add_formula(batten_text *text, const batten_feature *f)
{
    batten_text_add(text, "Formula:\n\n%s\n\n", f->formula);
    literature_wrap(text, "", f->promise);
    batten_text_add(text, "\n");
}

static void add_parameter(batten_text *text, const batten_parameter *p)
{
    batten_text_add(text, "  %-14s %s%s", p->name, kind_name(p),
                    p->is_list ? ", or several" : "");
    if (p->words)
        batten_text_add(text, ": %s", p->words);
    if (p->standard)
        batten_text_add(text, " (%s)", p->standard);
    batten_text_add(text, "%s\n                 %s\n", p->required ? ", required" : "",
                    p->summary);
}

static void add_feature(batten_text *text, const batten_feature *f)
{
    batten_text_add(text, "%s: %s\n\n", f->name, f->summary);
    if (f->also)
        add_other_names(text, f->also);
    batten_text_add(text, "%s\n\n", f->manual);
    if (f->formula)
        add_formula(text, f);
    batten_text_add(text, "Parameters:\n");
    for (int i = 0; i < f->parameter_count; i++)
        add_parameter(text, &f->parameters[i]);
    batten_text_add(text, "\nExample:\n\n%s\n\nIn C: %s\n", f->example, f->function);
    if (f->source && *f->source) {
        batten_text_add(text, "Sources:\n");
        literature_add_sources(text, f);
    }
}

static const char design_manual[] =
    "A design file says how shapes come to be: a graph of named features in YAML.\n\n"
    "    batten: 1                 # version of the format\n"
    "    units: m\n"
    "    tolerance: 0.1 mm         # what \"the same point\" means in this design\n\n"
    "    parameters:\n"
    "      beam: 3.2 m\n\n"
    "    features:\n"
    "      table:    {read: offsets.csv}\n"
    "      lines:    {fair: table, within: 3 mm}\n"
    "      stations: {interpolate: lines, each: station}\n"
    "      hull:     {skin: stations, within: 1 mm}\n\n"
    "    outputs:\n"
    "      hull.step:  hull\n"
    "      lines.pdf:  {lines-plan: hull}\n"
    "      hull.png:   {picture: hull, shading: zebra}\n"
    "      report.txt: {check: hull}\n\n"
    "The first key of a feature names the operation, its value is the principal input. Names\n"
    "refer to other features, in any order. A value may carry a unit (2 mm, 30 deg) or be an\n"
    "expression over the parameters (=beam/2). Paths are relative to the file and stay below\n"
    "its folder unless --allow-outside is given.\n\n"
    "most-objects: the features together make at most 1,000,000 objects unless this line gives\n"
    "another number, as most-objects: 5000000.\n"
    "units: the unit of numbers without one: m (the default), mm, cm, in, ft ... A number may\n"
    "have a unit of its own.\n"
    "tolerance: what counts as the same point, 0.1 mm unless given. Curves that must meet may\n"
    "miss each other by it, and what cannot be written exactly (arcs of clothoids, surfaces\n"
    "that are not NURBS) is written to within it; operations with a parameter 'within' use\n"
    "that instead. For models of a few millimetres, or of kilometres, give a tolerance that\n"
    "suits them.\n\n"
    "'batten build FILE' makes the outputs. 'batten help features' lists the operations.\n";

static const char files_manual[] =
    "Files that Batten reads, told apart by their content:\n\n"
    "Tables of offsets (.csv), in three forms. An empty cell, x or - is a point that was not\n"
    "measured; a unit may follow a name, as in height (mm), otherwise it is that of the\n"
    "design, or that of 'unit: in' of 'read'.\n\n"
    "  A row for each point, columns in any order (the line may be left out):\n\n"
    "    x_m,  z_m,   half_breadth_m, line\n"
    "    0,    0.24,  0,              keel\n"
    "    0,    0.30,  0.283,          wl 0.30\n"
    "    0.48, 0.618, 0.882,          sheer\n\n"
    "  A matrix: the corner says what runs down and across, the cells are half-breadths:\n\n"
    "    station\\height, 0.1,  0.25, 0.5\n"
    "    0,              ,     0.40, 0.70\n"
    "    1.2,            0.15, 0.60, 0.90\n\n"
    "  The loftsman's table: blocks of rows, each row one line with a height and a width at every\n"
    "  station. 2-8-6 is feet, inches and eighths:\n\n"
    "    axis,    name,    stem,  1,     2\n"
    "    length,  station, 0,     24,    48\n"
    "    heights, sheer,   2-8-6, 2-6-1, 2-3-5\n"
    "    widths,  sheer,   0-0-7, 1-1-3, 1-11-0\n\n"
    "Points (.xyz, .csv, .txt): two or three numbers in a row, or columns x, y and z; other\n"
    "columns are ignored. An empty line separates one curve from the next. A table of offsets\n"
    "has a column named station, half-breadth, half-width, waterline, line or section.\n"
    "Aerofoils (.dat): a name, then x and y from the trailing edge around the nose, or upper\n"
    "and lower side.\n\n"
    "Shapes and meshes come from STEP, IGES, G2, DXF, SVG, OBJ, STL, PLY and others: 'batten\n"
    "help formats' lists what is read and written. Batten also writes reports (.txt, .json),\n"
    "pictures (.svg, .pdf, .png), and drawings at true scale (.svg). In a design 'plan.svg:\n"
    "plan' is a picture on a page, 'plan.svg: {write: plan}' the drawing at true scale.\n\n"
    "'batten info FILE' says what Batten sees in a file; 'batten help read' how a design\n"
    "reads it.\n";

/* The whole manual in a form that other programs want. */
static int print_as(const char *form, const command_table *table)
{
    batten_text text = BATTEN_TEXT;
    if (strcmp(form, "man") == 0) {
        manual_page(&text, table);
    } else if (strcmp(form, "man-design") == 0) {
        manual_design_page(&text);
    } else if (strcmp(form, "completion") == 0) {
        manual_completion(&text, table);
    } else if (strcmp(form, "literature") == 0) {
        literature_page(&text);
    } else if (strcmp(form, "schema") == 0) {
        char *json = NULL;
        const batten_status status = batten_design_schema(&json);
        if (status != BATTEN_OK)
            return output_failed("help", status);
        batten_text_add(&text, "%s\n", json);
        batten_release(json);
    } else {
        complain(
            "batten help: --as knows man, man-design, completion, literature and schema, not '%s'",
            form);
        return EXIT_USAGE;
    }
    return output_print(&text);
}

/* Are two names the same but for hyphens? */
static bool same_letters(const char *a, const char *b)
{
    do {
        a += *a == '-';
        b += *b == '-';
        if (*a != *b)
            return false;
    } while (*a++ && *b++);
    return true;
}

/* The feature of that name, or the one that is spelt so but for hyphens: "gcode". */
static const batten_feature *find_feature(const char *topic)
{
    const batten_feature *found = batten_feature_find(topic);
    for (int i = 0; !found && i < batten_feature_count(); i++)
        if (same_letters(topic, batten_feature_at(i)->name))
            found = batten_feature_at(i);
    return found;
}

static const command *find_command(const command_table *table, const char *topic)
{
    for (int i = 0; i < table->count; i++)
        if (strcmp(table->at[i]->name, topic) == 0)
            return table->at[i];
    return NULL;
}

/* The words that are given, with blanks between them; NULL for none. Yours to batten_release. */
static char *take_topic(const arguments *given)
{
    batten_text words = BATTEN_TEXT;
    char *topic = NULL;
    for (int i = 0; i < given->file_count; i++)
        batten_text_add(&words, "%s%s", i ? " " : "", given->files[i]);
    if (given->file_count > 0)
        (void)batten_text_take(&words, &topic, NULL);
    return topic;
}

/* There is neither a topic of that name nor anything that has the words in it. */
static int complain_of_topic(const char *topic)
{
    const char *near = batten_feature_nearest(topic);
    complain("batten help: there is no topic '%s'%s%s%s; see 'batten help' and 'batten "
             "help features'",
             topic, near ? "; did you mean '" : "", near ? near : "", near ? "'" : "");
    return EXIT_USAGE;
}

static int show_topic(const char *topic, const command_table *table)
{
    batten_text text = BATTEN_TEXT;
    const command *c = topic ? find_command(table, topic) : NULL;
    const batten_feature *f = topic ? find_feature(topic) : NULL;
    if (!topic)
        add_commands(&text, table);
    else if (strcmp(topic, "features") == 0)
        add_features(&text);
    else if (strcmp(topic, "design") == 0 || strcmp(topic, "tolerance") == 0 ||
             strcmp(topic, "units") == 0)
        batten_text_add(&text, "%s", design_manual);
    else if (strcmp(topic, "files") == 0 || strcmp(topic, "offsets") == 0)
        batten_text_add(&text, "%s", files_manual);
    else if (strcmp(topic, "formats") == 0)
        formats_manual(&text);
    if (c)
        add_command(&text, c);
    if (c && f)
        batten_text_add(&text, "\n---- the feature of the same name ----\n\n");
    if (f)
        add_feature(&text, f);
    if (text.length > 0)
        return output_print(&text);
    const char *near = batten_feature_nearest(topic);
    if (search_add(&text, topic, table)) {
        if (near)
            batten_text_add(&text, "Or did you mean '%s'?\n", near);
        return output_print(&text);
    }
    return complain_of_topic(topic);
}

int help_show(const arguments *given, const command_table *table)
{
    const char *form = arguments_get(given, "as");
    if (form)
        return print_as(form, table);
    char *topic = take_topic(given);
    const int status = show_topic(topic, table);
    batten_release(topic);
    return status;
}
