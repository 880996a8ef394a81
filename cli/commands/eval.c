/* `batten eval`: points and derivatives of curves and surfaces at given parameters. */
#include "formats.h"

#include <batten/exchange.h>
#include <batten/text.h>
#include <string.h>

enum { HIGHEST_ORDER = 10 };

static const option options[] = {
    {"at", 0, OPTION_MANY, "U[,V]", "a parameter of a curve, or two of a surface"},
    {"order", 0, OPTION_VALUE, "K", "derivatives up to this order (0)"},
    {"beyond", 0, OPTION_VALUE, "RULE",
     "of a curve beyond its domain: refuse, continue its last span, or linear (refuse)"},
    FROM_FORMAT_OPTION,
    THREADS_OPTION,
    {"json", 0, OPTION_FLAG, NULL, "print JSON"},
};

/* "0.5" or "0.5,0.25": the number of parameters that stand there, or 0. */
static int read_at(const char *text, double at[2])
{
    const char *comma = strchr(text, ',');
    const size_t length = comma ? (size_t)(comma - text) : strlen(text);
    if (batten_number_read(text, length, &at[0], NULL) != BATTEN_OK)
        return 0;
    if (!comma)
        return 1;
    return batten_number_read(comma + 1, strlen(comma + 1), &at[1], NULL) == BATTEN_OK ? 2 : 0;
}

static void add_vector(batten_text *text, int dimension, const double *vector, bool json)
{
    batten_text_add(text, json ? "[" : "");
    for (int k = 0; k < dimension; k++) {
        batten_text_add(text, k ? (json ? ", " : " ") : "");
        batten_text_number(text, vector[k]);
    }
    batten_text_add(text, json ? "]" : "\n");
}

typedef struct {
    const char *name;
    int dimension, at_count, value_count;
    const double *at, *values;
} result;

static void add_result(batten_text *text, const result *r, bool first, bool json)
{
    if (!json) {
        for (int i = 0; i < r->value_count; i++)
            add_vector(text, r->dimension, r->values + i * r->dimension, false);
        return;
    }
    batten_text_add(text, "%s\n    {\"object\": ", first ? "" : ",");
    batten_text_json(text, r->name);
    batten_text_add(text, ", \"at\": ");
    add_vector(text, r->at_count, r->at, true);
    batten_text_add(text, ", \"point\": ");
    add_vector(text, r->dimension, r->values, true);
    batten_text_add(text, ", \"derivatives\": [");
    for (int i = 1; i < r->value_count; i++) {
        batten_text_add(text, i > 1 ? ", " : "");
        add_vector(text, r->dimension, r->values + i * r->dimension, true);
    }
    batten_text_add(text, "]}");
}

/* What is asked of every place. */
typedef struct {
    int order;
    batten_beyond beyond;
    bool json;
} request;

static batten_status evaluate(const batten_object *object, const double at[2], int at_count,
                              const request *asked, bool first, batten_text *text)
{
    const int order = asked->order;
    double values[3 * BATTEN_SURFACE_DERIVATIVES(HIGHEST_ORDER)];
    result r = {.name = object->name, .at_count = at_count, .at = at, .values = values};
    batten_status status;
    if (object->kind == BATTEN_OBJECT_CURVE && at_count == 1) {
        r.dimension = batten_curve_dimension(object->curve);
        r.value_count = order + 1;
        status =
            batten_curve_evaluate_beyond(object->curve, at[0], asked->beyond, order, values);
    } else if (object->kind == BATTEN_OBJECT_SURFACE && at_count == 2) {
        r.dimension = batten_surface_dimension(object->surface);
        r.value_count = BATTEN_SURFACE_DERIVATIVES(order);
        status = batten_surface_evaluate(object->surface, at[0], at[1], order, values);
    } else {
        return batten_fail(BATTEN_BAD_ARGUMENT, "'%s' is not a %s, so %d parameter%s not fit",
                           object->name, at_count == 1 ? "curve" : "surface", at_count,
                           at_count == 1 ? " does" : "s do");
    }
    if (status == BATTEN_OK)
        add_result(text, &r, first, asked->json);
    return status;
}

static bool is_place(const arguments *given, int g)
{
    return strcmp(given->options[given->given[g].option].name, "at") == 0;
}

/* All places on all objects that have as many parameters. */
static batten_status evaluate_all(const batten_model *model, const arguments *given,
                                  const request *asked, batten_text *text)
{
    bool first = true;
    const bool lone = batten_model_count(model) == 1;
    for (int g = 0; g < given->given_count; g++) {
        if (!is_place(given, g))
            continue;
        double at[2];
        const int at_count = read_at(given->given[g].value, at);
        for (int i = 0; i < batten_model_count(model); i++) {
            const batten_object *object = batten_model_object(model, i);
            const batten_object_kind kind =
                at_count == 1 ? BATTEN_OBJECT_CURVE : BATTEN_OBJECT_SURFACE;
            if (!lone && object->kind != kind)
                continue;
            const batten_status status = evaluate(object, at, at_count, asked, first, text);
            if (status != BATTEN_OK)
                return status;
            first = false;
        }
    }
    return first ? batten_fail(BATTEN_NOT_FOUND, "no object takes these parameters")
                 : BATTEN_OK;
}

/* Words in the order of batten_beyond. False for a usage error. */
static bool read_beyond(const arguments *given, batten_beyond *beyond)
{
    static const char *const words[] = {"refuse", "continue", "linear"};
    int index = (int)*beyond;
    if (!arguments_word(given, "beyond", 3, words, &index)) {
        complain("batten eval: --beyond wants refuse, continue or linear, not '%s'",
                 arguments_get(given, "beyond"));
        return false;
    }
    *beyond = (batten_beyond)index;
    return true;
}

static bool check_places(const arguments *given)
{
    for (int g = 0; g < given->given_count; g++) {
        double at[2];
        if (is_place(given, g) && read_at(given->given[g].value, at) == 0) {
            complain("batten eval: --at wants U or U,V, finite numbers, not '%s'",
                     given->given[g].value);
            return false;
        }
    }
    return true;
}

static int print_results(const batten_model *model, const arguments *given,
                         const request *asked)
{
    batten_text text = BATTEN_TEXT;
    batten_text_add(&text, asked->json ? "{\"results\": [" : "");
    const batten_status status = evaluate_all(model, given, asked, &text);
    batten_text_add(&text, asked->json ? "\n]}\n" : "");
    int exit = status == BATTEN_OK ? output_print(&text) : output_failed("eval", status);
    /* Places where the shape is not, or of which it has none. */
    if (status == BATTEN_OUT_OF_DOMAIN || status == BATTEN_BAD_ARGUMENT ||
        status == BATTEN_NOT_FOUND)
        exit = EXIT_USAGE;
    batten_text_free(&text);
    return exit;
}

static int run_eval(const arguments *given)
{
    request asked = {.json = arguments_has(given, "json")};
    batten_format format = BATTEN_FORMAT_AUTO;
    if (!arguments_count("eval", given, "order", 0, HIGHEST_ORDER, &asked.order) ||
        !formats_option("eval", given, "from-format", &format) ||
        !read_beyond(given, &asked.beyond))
        return EXIT_USAGE;
    if (!arguments_has(given, "at")) {
        complain("batten eval: --at U or --at U,V is missing; see 'batten help eval'");
        return EXIT_USAGE;
    }
    if (!check_places(given))
        return EXIT_USAGE;
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    if (batten_notes_create(1000, &notes) != BATTEN_OK)
        return output_failed("eval", BATTEN_OUT_OF_MEMORY);
    int exit = input_read(given->files[0], format, notes, &model);
    if (exit != EXIT_FAILED) {
        const int printed = print_results(model, given, &asked);
        exit = printed == EXIT_DONE ? exit : printed;
        notes_show(notes);
    }
    batten_model_unref(model);
    batten_notes_free(notes);
    return exit;
}

const command command_eval = {
    .name = "eval",
    .usage = "IN --at U[,V] [--at ...] [--order K]",
    .summary = "points and derivatives of curves and surfaces",
    .manual =
        "IN is a file, file#name for one object in it, or - for standard input. Derivatives are\n"
        "printed after the point: du, duu ... for a curve; du, dv, duu, duv, dvv ... for a\n"
        "surface. Numbers have the fewest digits that read back to the same bits. Parameters outside\n"
        "the domain are a usage error (2), but for curves with --beyond.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .run = run_eval,
};
