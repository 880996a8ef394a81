/* `batten compare`: curves of several methods through the same points, in panels and a table. */
#include "commands/method.h"
#include "formats.h"
#include "values.h"

#include <batten/design.h>
#include <batten/picture.h>
#include <batten/text.h>
#include <string.h>

enum { MAX_METHODS = 64 };

/* One panel. */
typedef struct {
    method choice;
    bool works;
} panel;

typedef struct {
    const arguments *given;
    const batten_model *model;
    batten_notes *notes;
    batten_format format; /* of the file */
    int count;
    panel panels[MAX_METHODS];
} comparison;

static const option options[] = {
    {"output", 'o', OPTION_VALUE, "PICTURE", "the picture to write: .png, .svg or .pdf"},
    {"methods", 'm', OPTION_VALUE, "LIST",
     "names with commas between them, each with settings: tension:amount=5,akima; or all"},
    FROM_FORMAT_OPTION,
    {"unit", 0, OPTION_VALUE, "UNIT", "the unit in which to work (that of the file, else m)"},
    {"json", 0, OPTION_FLAG, NULL, "print the table as JSON"},
    THREADS_OPTION,
    {"quiet", 'q', OPTION_FLAG, NULL, "no progress, no table, no remarks"},
};

/* What most designers want to see beside each other. */
static const char usual[] = "interpolate,akima,bessel,tension,nu-spline,local-cubic,hobby,"
                            "euler-spiral,elastica,minimum-variation,biarcs,arc-spline";

/* ---- the list of methods ---- */

static bool add_method(comparison *c, const char *word, size_t length)
{
    if (c->count == MAX_METHODS) {
        complain("batten compare: more than %d methods", MAX_METHODS);
        return false;
    }
    if (!method_choose("compare", word, length, &c->panels[c->count].choice))
        return false;
    c->panels[c->count++].works = true;
    return true;
}

static bool add_list(comparison *c, const char *list)
{
    for (const char *at = list; *at;) {
        const size_t length = value_span(at, ",");
        if (!add_method(c, at, length))
            return false;
        at += length;
        at += *at == ',';
    }
    return c->count > 0;
}

/* Does the feature make curves through points, and need nothing else? */
static bool needs_points_alone(int index)
{
    static const char group[] = "Curves through points";
    const batten_feature *f = batten_feature_at(index);
    if (strncmp(batten_feature_group(index), group, sizeof group - 1) != 0)
        return false;
    for (int k = 1; k < f->parameter_count; k++)
        if (f->parameters[k].required)
            return false;
    return true;
}

static void add_all(comparison *c)
{
    for (int i = 0; i < batten_feature_count() && c->count < MAX_METHODS; i++) {
        const batten_feature *f = batten_feature_at(i);
        if (needs_points_alone(i)) {
            panel *p = &c->panels[c->count++];
            p->works = method_choose("compare", f->name, strlen(f->name), &p->choice);
        }
    }
}

/* ---- the design ---- */

static void put_feature(const method *m, const char *input, batten_text *text)
{
    batten_text_add(text, "  ");
    batten_text_json(text, m->name);
    batten_text_add(text, ": {%s: ", m->operation);
    input_name_add(text, input);
    batten_text_add(text, "%s}\n", m->settings);
}

static void put_output(const comparison *c, const char *name, bool is_picture,
                       batten_text *text)
{
    const batten_feature *feature = batten_feature_find("compare");
    const char *separator = "";
    batten_text_add(text, "  ");
    batten_text_json(text, name);
    batten_text_add(text, ": {compare: [");
    for (int i = 0; i < c->count; i++)
        if (c->panels[i].works) {
            batten_text_add(text, "%s", separator);
            batten_text_json(text, c->panels[i].choice.name);
            separator = ", ";
        }
    batten_text_add(text, "]");
    for (int k = 1; is_picture && k < feature->parameter_count; k++)
        values_add(text, c->given, &feature->parameters[k]);
    batten_text_add(text, "}\n");
}

static batten_status compose(const comparison *c, batten_text *text)
{
    const char *picture = arguments_get(c->given, "output");
    const char *unit = arguments_get(c->given, "unit");
    if (!unit)
        unit = batten_unit_name(batten_model_unit_metres(c->model));
    batten_text_add(text, "batten: 1\nunits: %s\nfeatures:\n", unit ? unit : "m");
    input_add(text, c->given->files[0]);
    for (int i = 0; i < c->count; i++)
        if (c->panels[i].works)
            put_feature(&c->panels[i].choice, c->given->files[0], text);
    batten_text_add(text, "outputs:\n");
    put_output(c, strcmp(picture, "-") == 0 ? "picture.svg" : picture, true, text);
    put_output(c, arguments_has(c->given, "json") ? "table.json" : "table.txt", false, text);
    return text->failed ? batten_fail(BATTEN_OUT_OF_MEMORY, "no memory for the design")
                        : BATTEN_OK;
}

static batten_status open_design(const comparison *c, batten_design **design)
{
    batten_text text = BATTEN_TEXT;
    batten_design_options o = batten_design_defaults();
    o.allow_outside = true;
    o.provided_file = c->given->files[0];
    o.provided = c->model;
    batten_status status = compose(c, &text);
    if (status == BATTEN_OK)
        status = batten_design_parse(text.bytes, text.length, &o, c->notes, design);
    batten_text_free(&text);
    return status;
}

/* ---- the work ---- */

/* Try each method alone; what fails has no panel, and a line that says why. */
static batten_status find_working(comparison *c, batten_design *design, int *working)
{
    *working = 0;
    for (int i = 0; i < c->count; i++) {
        panel *p = &c->panels[i];
        const batten_status one =
            batten_design_evaluate(design, p->choice.name, job_get(), NULL);
        if (one == BATTEN_CANCELLED || one == BATTEN_OUT_OF_MEMORY)
            return one;
        p->works = one == BATTEN_OK || one == BATTEN_PARTLY_READ;
        *working += p->works;
        if (!p->works)
            complain("left out: %s", message_shown());
    }
    return *working > 0
               ? BATTEN_OK
               : batten_fail(BATTEN_BAD_ARGUMENT, "no method makes a curve of these points");
}

/* The design of the methods that work; it keeps the curves that were made on trial. */
static batten_status open_working(comparison *c, batten_design **design)
{
    int working;
    batten_status status = open_design(c, design);
    if (status == BATTEN_OK)
        status = find_working(c, *design, &working);
    if (status != BATTEN_OK || working == c->count)
        return status;
    batten_design_free(*design);
    *design = NULL;
    return open_design(c, design);
}

/* Make an output and save it; the table goes to standard output. */
static int make_output(batten_design *design, int index, const char *path, batten_notes *notes)
{
    char *data = NULL;
    size_t size = 0;
    const batten_status status =
        batten_design_output(design, index, job_get(), notes, &data, &size);
    const int exit =
        status == BATTEN_OK ? output_save(path, data, size) : output_failed("compare", status);
    batten_release(data);
    return exit;
}

static int compare(comparison *c)
{
    const char *output = arguments_get(c->given, "output");
    batten_design *design = NULL;
    const batten_status status = open_working(c, &design);
    if (status != BATTEN_OK) {
        batten_design_free(design);
        return output_failed("compare", status);
    }
    int exit = make_output(design, 0, output, c->notes);
    if (exit == EXIT_DONE && !arguments_has(c->given, "quiet") && strcmp(output, "-") != 0)
        exit = make_output(design, 1, "-", c->notes);
    batten_design_free(design);
    return exit;
}

static int run_on(comparison *c)
{
    batten_model *model = NULL;
    int exit = input_read(c->given->files[0], c->format, c->notes, &model);
    if (exit != EXIT_FAILED) {
        c->model = model;
        const int compared = compare(c);
        exit = compared == EXIT_DONE ? exit : compared;
    }
    exit == EXIT_FAILED ? failed_show(c->notes) : notes_show(c->notes);
    batten_model_unref(model);
    return exit;
}

static bool add_methods(comparison *c, const char *list)
{
    if (list && strcmp(list, "all") == 0) {
        add_all(c);
        return true;
    }
    return add_list(c, list ? list : usual);
}

static bool check_unit(const arguments *given)
{
    const char *unit = arguments_get(given, "unit");
    if (!unit || batten_unit_metres(unit) > 0)
        return true;
    complain("batten compare: --unit: unknown unit of length '%s'", unit);
    return false;
}

static int run_compare(const arguments *given)
{
    const char *output = arguments_get(given, "output");
    const char *list = arguments_get(given, "methods");
    batten_picture_format format;
    comparison c = {.given = given};
    if (!output ||
        (strcmp(output, "-") != 0 && !batten_picture_format_from_name(output, &format))) {
        complain("batten compare: -o PICTURE is needed, which ends in .png, .svg or .pdf; see "
                 "'batten help compare'");
        return EXIT_USAGE;
    }
    if (!add_methods(&c, list) || !check_unit(given))
        return EXIT_USAGE;
    if (!formats_option("compare", given, "from-format", &c.format) ||
        output_is_input("compare", given->files[0], output))
        return EXIT_USAGE;
    if (batten_notes_create(1000, &c.notes) != BATTEN_OK)
        return output_failed("compare", BATTEN_OUT_OF_MEMORY);
    const int exit = run_on(&c);
    batten_notes_free(c.notes);
    return exit;
}

const command command_compare = {
    .name = "compare",
    .usage = "POINTS -o PICTURE [--methods LIST]",
    .summary = "curves of several methods through the same points, side by side",
    .manual =
        "Draws each method in a panel of its own with its curvature comb, all at one scale, and\n"
        "prints a table: bending energy (infinite with corners), variation of curvature (infinite\n"
        "where it jumps), inflections, extrema of curvature, the largest curvature, length and\n"
        "time. A method is the name of a feature, with settings after colons: --methods\n"
        "interpolate:parameters=chord,tension:amount=8,elastica. 'batten help features' lists the\n"
        "methods; --methods all takes every one that needs nothing but points. A method that\n"
        "fails is left out, with the reason.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .feature = "compare",
    .run = run_compare,
};
