#include "command.h"

#include <string.h>

static const option options[] = {
    {"json", 0, OPTION_FLAG, NULL, "print JSON"},
};

/* What is told of one object, whatever its kind; `directions` is 1 for curves, 2 for surfaces,
 * else 0. */
typedef struct {
    const char *type, *kind;
    int dimension, directions;
    int degree[2], points[2];
    bool rational, closed[2];
    bool controls; /* the box is that of the control points */
    batten_interval domain[2];
    batten_box box;
} facts;

static facts curve_facts(const batten_curve *curve, double tolerance)
{
    return (facts){
        .type = "curve",
        .kind = batten_curve_is_periodic(curve) ? "periodic nurbs" : "nurbs",
        .dimension = batten_curve_dimension(curve),
        .directions = 1,
        .degree = {batten_curve_degree(curve)},
        .points = {batten_curve_point_count(curve)},
        .rational = batten_curve_is_rational(curve),
        .closed = {batten_curve_is_closed(curve, tolerance)},
        .domain = {batten_curve_domain(curve)},
        .controls = true,
        .box = batten_curve_box(curve),
    };
}

static facts surface_facts(const batten_surface *surface, double tolerance)
{
    facts f = {
        .type = "surface",
        .kind = batten_surface_kind(surface),
        .dimension = batten_surface_dimension(surface),
        .directions = 2,
        .box = batten_surface_box(surface),
    };
    for (int d = 0; d < 2; d++) {
        f.domain[d] = batten_surface_domain(surface, (batten_direction)d);
        f.closed[d] = batten_surface_is_closed(surface, (batten_direction)d, tolerance);
    }
    if (strcmp(f.kind, "nurbs") == 0) {
        f.controls = true;
        f.rational = batten_surface_is_rational(surface);
        for (int d = 0; d < 2; d++) {
            f.degree[d] = batten_surface_degree(surface, (batten_direction)d);
            f.points[d] = batten_surface_point_count(surface, (batten_direction)d);
        }
    }
    return f;
}

static facts triangles_facts(const batten_triangles *triangles)
{
    return (facts){
        .type = "triangles",
        .kind = "bezier",
        .dimension = batten_triangles_dimension(triangles),
        .degree = {batten_triangles_degree(triangles)},
        .points = {batten_triangles_count(triangles)},
        .rational = batten_triangles_is_rational(triangles),
        .controls = true,
        .box = batten_triangles_box(triangles),
    };
}

static batten_box points_box(const batten_object *object)
{
    batten_box box = {{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < object->point_count; i++) {
        const double *p = object->points + 3 * i;
        const batten_box here = {{p[0], p[1], p[2]}, {p[0], p[1], p[2]}};
        if (i == 0)
            box = here;
        box.low.x = p[0] < box.low.x ? p[0] : box.low.x;
        box.low.y = p[1] < box.low.y ? p[1] : box.low.y;
        box.low.z = p[2] < box.low.z ? p[2] : box.low.z;
        box.high.x = p[0] > box.high.x ? p[0] : box.high.x;
        box.high.y = p[1] > box.high.y ? p[1] : box.high.y;
        box.high.z = p[2] > box.high.z ? p[2] : box.high.z;
    }
    return box;
}

static facts facts_of(const batten_object *object, double tolerance)
{
    switch (object->kind) {
    case BATTEN_OBJECT_CURVE:
        return curve_facts(object->curve, tolerance);
    case BATTEN_OBJECT_SURFACE:
        return surface_facts(object->surface, tolerance);
    case BATTEN_OBJECT_OFFSETS:
        return (facts){.type = "offsets",
                       .kind = "table",
                       .dimension = 3,
                       .points = {batten_offsets_station_count(object->offsets),
                                  batten_offsets_line_count(object->offsets)},
                       .box = batten_offsets_box(object->offsets)};
    case BATTEN_OBJECT_TRIANGLES:
        return triangles_facts(object->triangles);
    case BATTEN_OBJECT_POINTS:
    case BATTEN_OBJECT_BODY:
    case BATTEN_OBJECT_MESH:
    case BATTEN_OBJECT_INSTANCE:
        break;
    }
    return (facts){.type = "points",
                   .kind = "row",
                   .dimension = 3,
                   .points = {object->point_count},
                   .box = points_box(object)};
}

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
    for (int d = 0; d < f->directions; d++) {
        batten_text_add(text, d ? ", [" : "[");
        batten_text_number(text, f->domain[d].a);
        batten_text_add(text, ", ");
        batten_text_number(text, f->domain[d].b);
        batten_text_add(text, "]");
    }
    batten_text_add(text, "], \"box\": [[");
    add_corner(text, f->box.low, f->dimension, ", ");
    batten_text_add(text, "], [");
    add_corner(text, f->box.high, f->dimension, ", ");
    batten_text_add(text, "]]}");
}

static void add_line(batten_text *text, const batten_object *object, const facts *f)
{
    batten_text_add(text, "%s: %s%s", object->name, f->rational ? "rational " : "", f->type);
    if (f->directions == 1)
        batten_text_add(text, ", degree %d, %d points%s", f->degree[0], f->points[0],
                        f->closed[0] ? ", closed" : "");
    else if (f->directions == 2)
        batten_text_add(text, " (%s), degree %d x %d, %d x %d points%s%s", f->kind,
                        f->degree[0], f->degree[1], f->points[0], f->points[1],
                        f->closed[0] ? ", closed in u" : "",
                        f->closed[1] ? ", closed in v" : "");
    else if (f->points[1])
        batten_text_add(text, ", %d stations, %d lines", f->points[0], f->points[1]);
    else
        batten_text_add(text, ", %d", f->points[0]);
    for (int d = 0; d < f->directions; d++) {
        batten_text_add(text, d ? " x [" : ", domain [");
        batten_text_number(text, f->domain[d].a);
        batten_text_add(text, ", ");
        batten_text_number(text, f->domain[d].b);
        batten_text_add(text, "]");
    }
    batten_text_add(text, "\n    box %s", f->controls ? "of the control points " : "");
    add_corner(text, f->box.low, f->dimension, " ");
    batten_text_add(text, "  to  ");
    add_corner(text, f->box.high, f->dimension, " ");
    batten_text_add(text, "\n");
}

static double size_of(const batten_model *model)
{
    batten_box box;
    if (!batten_model_box(model, &box))
        return 1;
    return box.high.x - box.low.x + (box.high.y - box.low.y) + (box.high.z - box.low.z);
}

static int print(const char *file, const batten_model *model, const batten_notes *notes,
                 bool json)
{
    /* Ends within a billionth of the model's size are the same point. */
    const double tolerance = 1e-9 * size_of(model);
    const char *unit = batten_unit_name(batten_model_unit_metres(model));
    batten_text text = BATTEN_TEXT;
    if (json) {
        batten_text_add(&text, "{\"file\": ");
        batten_text_json(&text, file);
        batten_text_add(&text, ", \"unit\": \"%s\",\n  \"objects\": [", unit ? unit : "");
    } else {
        batten_text_add(&text, "%s: %d object%s, unit %s\n", file, batten_model_count(model),
                        batten_model_count(model) == 1 ? "" : "s", unit ? unit : "not stated");
    }
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        const facts f = facts_of(object, tolerance);
        if (json) {
            batten_text_add(&text, "%s\n    ", i ? "," : "");
            add_json(&text, object, &f);
        } else {
            add_line(&text, object, &f);
        }
    }
    if (json) {
        batten_text_add(&text, "],\n  \"messages\": ");
        notes_json(&text, notes);
        batten_text_add(&text, "}\n");
    }
    return output_print(&text);
}

static int run(const arguments *given)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    if (batten_notes_create(1000, &notes) != BATTEN_OK)
        return output_failed("info", BATTEN_OUT_OF_MEMORY);
    int exit = input_read(given->files[0], notes, &model);
    if (exit != EXIT_FAILED) {
        const bool json = arguments_has(given, "json");
        const int printed = print(given->files[0], model, notes, json);
        exit = printed == EXIT_DONE ? exit : printed;
        if (!json)
            notes_show(notes);
    }
    batten_model_unref(model);
    batten_notes_free(notes);
    return exit;
}

const command command_info = {
    .name = "info",
    .usage = "IN [--json]",
    .summary = "what is in a file",
    .manual = "IN is a table of offsets, points, an aerofoil, an IGES file; file#name means "
              "one object in it, -\n"
              "standard input. Boxes of curves and surfaces are those of their control points, "
              "which hold them;\n"
              "'batten measure' finds the tight ones of curves. Exit status 3 when only a part "
              "could be read.",
    .least_files = 1,
    .most_files = 1,
    .option_count = sizeof options / sizeof options[0],
    .options = options,
    .run = run,
};
