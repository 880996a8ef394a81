/* `batten info`: what is in a file, as lines or as JSON, with its oddities. */
#include "commands/facts.h"
#include "commands/tally.h"
#include "formats.h"
#include "unit.h"

#include <batten/exchange.h>
#include <batten/text.h>
#include <math.h>
#include <string.h>

static const option options[] = {
    FROM_FORMAT_OPTION,
    THREADS_OPTION,
    {"json", 0, OPTION_FLAG, NULL, "print JSON"},
    {"no-lint", 0, OPTION_FLAG, NULL, "do not look for what is wrong with the objects"},
};

static void add_corner(batten_text *text, batten_vec3 corner, int dimension,
                       const char *between)
{
    const double values[3] = {corner.x, corner.y, corner.z};
    for (int k = 0; k < dimension; k++) {
        batten_text_add(text, "%s", k ? between : "");
        batten_text_number(text, values[k]);
    }
}

static void add_pair(batten_text *text, const char *key, const int *pair, int count)
{
    batten_text_add(text, ", \"%s\": [", key);
    for (int d = 0; d < count; d++)
        batten_text_add(text, "%s%d", d ? ", " : "", pair[d]);
    batten_text_add(text, "]");
}

/* "faces", "vertices" */
static void add_plural(batten_text *text, const char *word)
{
    if (strcmp(word, "vertex") == 0)
        batten_text_add(text, "vertices");
    else
        batten_text_add(text, "%ss", word);
}

/* "53 faces" */
static void add_count(batten_text *text, const char *word, int count)
{
    batten_text_add(text, "%d ", count);
    if (count == 1)
        batten_text_add(text, "%s", word);
    else
        add_plural(text, word);
}

static void add_text(batten_text *text, const char *key, const char *value)
{
    batten_text_add(text, ", \"%s\": ", key);
    batten_text_json(text, value);
}

/* The end of "[a, b]". */
static void add_bounds(batten_text *text, batten_interval domain)
{
    batten_text_number(text, domain.a);
    batten_text_add(text, ", ");
    batten_text_number(text, domain.b);
    batten_text_add(text, "]");
}

static void json_domains(batten_text *text, const facts *f)
{
    for (int d = 0; d < f->directions; d++) {
        batten_text_add(text, d ? ", [" : "[");
        add_bounds(text, f->domain[d]);
    }
}

static void json_faults(batten_text *text, const batten_mesh_facts *mesh)
{
    batten_text_add(text,
                    ", \"watertight\": %s, \"rim_edges\": %d, \"wrong_edges\": %d, "
                    "\"crowded_edges\": %d",
                    mesh->is_watertight ? "true" : "false", mesh->rim_edges, mesh->wrong_edges,
                    mesh->crowded_edges);
}

static void json_colour(batten_text *text, const batten_object *object)
{
    batten_text_add(text, ", \"colour\": [");
    add_corner(text, (batten_vec3){object->colour[0], object->colour[1], object->colour[2]}, 3,
               ", ");
    batten_text_add(text, "]");
}

static void json_box(batten_text *text, const facts *f)
{
    batten_text_add(text, ", \"box\": [[");
    add_corner(text, f->box.low, f->dimension, ", ");
    batten_text_add(text, "], [");
    add_corner(text, f->box.high, f->dimension, ", ");
    batten_text_add(text, f->controls ? "]], \"box_of\": \"control points\"}" : "]]}");
}

static void add_json(batten_text *text, const batten_object *object, const facts *f)
{
    batten_text_add(text, "{\"name\": ");
    batten_text_json(text, object->name);
    batten_text_add(text, ", \"type\": \"%s\", \"kind\": \"%s\", \"dimension\": %d", f->type,
                    f->kind, f->dimension);
    add_pair(text, "degree", f->degree, f->directions);
    add_pair(text, "points", f->points, f->directions ? f->directions : f->points[1] ? 2 : 1);
    batten_text_add(text, ", \"rational\": %s, \"closed\": [", f->rational ? "true" : "false");
    for (int d = 0; d < f->directions; d++)
        batten_text_add(text, "%s%s", d ? ", " : "", f->closed[d] ? "true" : "false");
    batten_text_add(text, "], \"domain\": [");
    json_domains(text, f);
    batten_text_add(text, "]");
    for (int k = 0; k < 4 && f->counted[k]; k++) {
        batten_text_add(text, ", \"");
        add_plural(text, f->counted[k]);
        batten_text_add(text, "\": %d", f->counts[k]);
    }
    if (f->has_faces)
        batten_text_add(text, ", \"coloured_faces\": %d", f->coloured_faces);
    if (f->mesh_checked)
        json_faults(text, &f->mesh);
    add_text(text, "layer", object->layer);
    add_text(text, "group", object->group);
    batten_text_add(text, ", \"hidden\": %s", object->is_hidden ? "true" : "false");
    if (object->has_colour)
        json_colour(text, object);
    json_box(text, f);
}

/* Why a mesh is not watertight: ": 4 edges at the rim"; of other objects nothing. */
static void add_reasons(batten_text *text, const batten_mesh_facts *mesh)
{
    const struct {
        int count;
        const char *what;
    } rows[] = {{mesh->rim_edges, "at the rim"},
                {mesh->wrong_edges, "between triangles turned against each other"},
                {mesh->crowded_edges, "of more than two triangles"}};
    const char *before = ": ";
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++)
        if (rows[k].count > 0) {
            batten_text_add(text, "%s%d edge%s %s", before, rows[k].count,
                            rows[k].count == 1 ? "" : "s", rows[k].what);
            before = ", ";
        }
}

/* "colour #ff8000", as sRGB. */
static void add_colour(batten_text *text, const double colour[3])
{
    batten_text_add(text, "colour #");
    for (int k = 0; k < 3; k++)
        batten_text_add(text, "%02x", (unsigned)lround(255 * fmin(fmax(colour[k], 0), 1)));
}

/* Layer, group, colour and whether it is hidden, when there is any of them. */
static void add_looks(batten_text *text, const batten_object *object)
{
    const char *const first = "    ", *const next = "  ";
    const char *before = first;
    if (object->layer[0]) {
        batten_text_add(text, "%slayer %s", before, object->layer);
        before = next;
    }
    if (object->group[0]) {
        batten_text_add(text, "%sgroup %s", before, object->group);
        before = next;
    }
    if (object->has_colour) {
        batten_text_add(text, "%s", before);
        add_colour(text, object->colour);
        before = next;
    }
    if (object->is_hidden) {
        batten_text_add(text, "%shidden", before);
        before = next;
    }
    batten_text_add(text, "%s", before == next ? "\n" : "");
}

static void text_counts(batten_text *text, const facts *f)
{
    for (int k = 0; k < 4 && f->counted[k]; k++) {
        batten_text_add(text, ", ");
        add_count(text, f->counted[k], f->counts[k]);
    }
    if (f->coloured_faces)
        batten_text_add(text, ", %ss with colours of their own: %d", f->counted[0],
                        f->coloured_faces);
}

static void text_domains(batten_text *text, const facts *f)
{
    for (int d = 0; d < f->directions; d++) {
        batten_text_add(text, d ? " x [" : ", domain [");
        add_bounds(text, f->domain[d]);
    }
}

static void text_box(batten_text *text, const facts *f)
{
    batten_text_add(text, "\n    box %s", f->controls ? "of the control points " : "");
    add_corner(text, f->box.low, f->dimension, " ");
    batten_text_add(text, "  to  ");
    add_corner(text, f->box.high, f->dimension, " ");
    batten_text_add(text, "\n");
}

static void add_line(batten_text *text, const batten_object *object, const facts *f)
{
    batten_text_add(text, "%s: %s%s", object->name, f->rational ? "rational " : "", f->type);
    if (f->directions == 1)
        batten_text_add(text, ", degree %d, %d point%s%s", f->degree[0], f->points[0],
                        f->points[0] == 1 ? "" : "s", f->closed[0] ? ", closed" : "");
    else if (f->directions == 2)
        batten_text_add(text, " (%s), degree %d x %d, %d x %d points%s%s", f->kind,
                        f->degree[0], f->degree[1], f->points[0], f->points[1],
                        f->closed[0] ? ", closed in u" : "",
                        f->closed[1] ? ", closed in v" : "");
    else if (f->counted[0]) {
        text_counts(text, f);
    } else if (f->points[1])
        batten_text_add(text, ", %d station%s, %d line%s", f->points[0],
                        f->points[0] == 1 ? "" : "s", f->points[1],
                        f->points[1] == 1 ? "" : "s");
    else
        batten_text_add(text, ", %d", f->points[0]);
    if (f->remark)
        batten_text_add(text, ", %s", f->remark);
    add_reasons(text, &f->mesh);
    text_domains(text, f);
    text_box(text, f);
    add_looks(text, object);
}

static void begin_json(batten_text *text, const char *file, const char *unit)
{
    batten_text_add(text, "{\"file\": ");
    batten_text_json(text, file);
    batten_text_add(text, ", \"unit\": \"%s\",\n  \"objects\": [", unit);
}

static void begin_text(batten_text *text, const char *file, const batten_model *model,
                       const char *unit)
{
    batten_text_add(text, "%s: %d object%s", file, batten_model_count(model),
                    batten_model_count(model) == 1 ? "" : "s");
    if (batten_model_count(model) > 1) {
        batten_text_add(text, " (");
        tally_text(text, tally_of(model, TALLY_BODIES));
        batten_text_add(text, ")");
    }
    batten_text_add(text, ", unit %s\n", unit[0] ? unit : "not stated");
}

static int print(const char *file, const batten_model *model, const facts *found,
                 const batten_notes *notes, bool json)
{
    char unit[UNIT_SIZE];
    unit_words(batten_model_unit_metres(model), unit);
    batten_text text = BATTEN_TEXT;
    if (json) {
        begin_json(&text, file, unit);
    } else {
        begin_text(&text, file, model, unit);
    }
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (json) {
            batten_text_add(&text, "%s\n    ", i ? "," : "");
            add_json(&text, object, &found[i]);
        } else {
            add_line(&text, object, &found[i]);
        }
    }
    if (json) {
        batten_text_add(&text, "],\n  \"messages\": ");
        notes_json(&text, notes);
        batten_text_add(&text, "}\n");
    }
    return output_print(&text);
}

/* Instances are listed by what they place; where that is too much, by what there is to place. */
static int flatten(batten_model **model, batten_notes *notes, int exit)
{
    batten_model *flat = NULL;
    int instances = 0;
    for (int i = 0; i < batten_model_count(*model); i++)
        instances += batten_model_object(*model, i)->kind == BATTEN_OBJECT_INSTANCE;
    batten_status status = batten_model_flat(*model, &flat);
    if (status == BATTEN_TOO_LARGE) {
        batten_notes_remark(notes, "", 0, "", "%s; each is listed once, where it is defined",
                            batten_message());
        status = batten_model_once(*model, &flat);
    }
    if (status != BATTEN_OK)
        return output_failed("info", status);
    if (instances > 0)
        batten_notes_remark(
            notes, "", 0, "", "instances among the %d object%s: %d, %d deep at most",
            batten_model_count(*model), batten_model_count(*model) == 1 ? "" : "s", instances,
            batten_model_depth(*model));
    batten_model_unref(*model);
    *model = flat;
    return exit;
}

/* What is wrong with the objects goes to the notes. The exit status, or EXIT_FAILED. */
static int lint(const batten_model *model, const facts *found, batten_notes *notes, int exit)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK; i++)
        status = lint_object(batten_model_object(model, i), &found[i], notes);
    return status == BATTEN_OK ? exit : output_failed("info", status);
}

/* The facts of every object, found once (a mesh is checked for them); NULL without memory. */
static facts *facts_of_all(const batten_model *model)
{
    const int count = batten_model_count(model);
    facts *found = batten_array((size_t)count + 1, sizeof *found);
    for (int i = 0; found && i < count; i++)
        found[i] = facts_of(batten_model_object(model, i));
    return found;
}

static int tell_facts(const arguments *given, const batten_model *model, batten_notes *notes,
                      int exit)
{
    const bool json = arguments_has(given, "json");
    facts *found = facts_of_all(model);
    if (!found)
        return output_failed("info", BATTEN_OUT_OF_MEMORY);
    if (!arguments_has(given, "no-lint"))
        exit = lint(model, found, notes, exit);
    if (exit != EXIT_FAILED) {
        const int printed = print(given->files[0], model, found, notes, json);
        exit = printed == EXIT_DONE ? exit : printed;
        if (!json)
            notes_show(notes);
    }
    batten_release(found);
    return exit;
}

static int run_info(const arguments *given)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    batten_format format = BATTEN_FORMAT_AUTO;
    if (!formats_option("info", given, "from-format", &format))
        return EXIT_USAGE;
    if (batten_notes_create(1000, &notes) != BATTEN_OK)
        return output_failed("info", BATTEN_OUT_OF_MEMORY);
    int exit = input_read(given->files[0], format, notes, &model);
    if (exit != EXIT_FAILED)
        exit = flatten(&model, notes, exit);
    if (exit != EXIT_FAILED)
        exit = tell_facts(given, model, notes, exit);
    batten_model_unref(model);
    batten_notes_free(notes);
    return exit;
}

const command command_info = {
    .name = "info",
    .usage = "IN [--from-format FORMAT] [--json] [--no-lint]",
    .summary = "what is in a file",
    .manual =
        "IN is a file of any format that can be read ('batten help formats'); file#name means one\n"
        "object in it, - standard input. Boxes of curves, surfaces and bodies are those of their\n"
        "control points, which contain them (\"box_of\" in --json); 'batten measure' finds the\n"
        "tight ones. Oddities are reported too: knots that nearly coincide, poles, tiny or free\n"
        "edges, gaps, faces turned against each other, loops that touch; --no-lint leaves that\n"
        "out. The exit status is 3 when only a part could be read.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .run = run_info,
};
