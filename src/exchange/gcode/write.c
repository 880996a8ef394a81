/* Writes paths as G-code: moves of lines and arcs. */
#include "base/list.h"
#include "exchange/gcode/gcode.h"
#include "exchange/shapes/path.h"
#include "numeric/vector.h"

#include <batten/text.h>
#include <string.h>

/* One program as it grows. Positions are what the machine knows: rounded, in its unit. */
typedef struct {
    batten_write_gcode_options options;
    batten_text text;
    double scale; /* from the model's unit to the machine's */
    double top;   /* height at which the tool travels */
    double at[3];
    int paths;
    int flat;       /* arcs of the path that are written as lines, for their radius */
    double largest; /* number written */
    const char *path;
    bat_tool_moves *moves; /* or NULL: nobody asks */
    batten_status listed;  /* whether there was memory for them */
} program;

static const double inch = 0.0254, millimetre = 0.001;

/* ---- words ---- */

static double rounded(const program *p, double value)
{
    const double ten = bat_pow(10, p->options.decimals);
    const double result = round(value * ten) / ten;
    return result == 0 ? 0 : result;
}

static void put_word(program *p, char letter, double value)
{
    p->largest = bat_max(p->largest, isfinite(value) ? fabs(value) : HUGE_VAL);
    batten_text_add(&p->text, " %c%.*f", letter, p->options.decimals, rounded(p, value));
}

/* An axis that moves; the tool is then there. */
static void put_axis(program *p, char letter, int axis, double to)
{
    const double from = p->options.relative_moves ? p->at[axis] : 0;
    put_word(p, letter, to - from);
    p->at[axis] = to;
}

/* ---- moves ---- */

/* A move from where the tool was to where it is. */
static void list_move(program *p, bat_tool_does does, const double from[3], double bulge)
{
    bat_tool_move move = {.does = does, .bulge = bulge, .path = p->path};
    if (!p->moves || memcmp(from, p->at, sizeof p->at) == 0 || p->listed != BATTEN_OK)
        return;
    memcpy(move.from, from, sizeof move.from);
    memcpy(move.to, p->at, sizeof move.to);
    p->listed = BAT_LIST_ADD(p->moves->items, p->moves->count, p->moves->room, move);
}

static void move_up(program *p)
{
    const double from[3] = {p->at[0], p->at[1], p->at[2]};
    batten_text_add(&p->text, "G0");
    put_axis(p, 'Z', 2, p->top);
    batten_text_add(&p->text, "\n");
    list_move(p, BAT_TOOL_TRAVELS, from, 0);
}

static void travel(program *p, double x, double y)
{
    const double from[3] = {p->at[0], p->at[1], p->at[2]};
    batten_text_add(&p->text, "G0");
    put_axis(p, 'X', 0, x);
    put_axis(p, 'Y', 1, y);
    batten_text_add(&p->text, "\n");
    list_move(p, BAT_TOOL_TRAVELS, from, 0);
}

static void plunge(program *p, double z)
{
    const double from[3] = {p->at[0], p->at[1], p->at[2]};
    batten_text_add(&p->text, "G1");
    put_axis(p, 'Z', 2, z);
    put_word(p, 'F', p->options.plunge);
    batten_text_add(&p->text, "\n");
    list_move(p, BAT_TOOL_PLUNGES, from, 0);
}

static void put_feed(program *p, bool first)
{
    if (first)
        put_word(p, 'F', p->options.feed);
    batten_text_add(&p->text, "\n");
}

static void cut_line(program *p, double x, double y, bool first)
{
    const double from[3] = {p->at[0], p->at[1], p->at[2]};
    batten_text_add(&p->text, "G1");
    put_axis(p, 'X', 0, x);
    put_axis(p, 'Y', 1, y);
    put_feed(p, first);
    list_move(p, BAT_TOOL_CUTS, from, 0);
}

/* The centre belongs to the rounded ends. */
static void cut_arc(program *p, const bat_vertex *from, double x, double y, bool first)
{
    const double start[3] = {p->at[0], p->at[1], p->at[2]};
    double cx, cy, radius;
    bat_path_centre(from, x, y, &cx, &cy, &radius);
    batten_text_add(&p->text, from->bulge > 0 ? "G3" : "G2");
    put_axis(p, 'X', 0, x);
    put_axis(p, 'Y', 1, y);
    put_word(p, 'I', p->options.absolute_centres ? cx : cx - from->x);
    put_word(p, 'J', p->options.absolute_centres ? cy : cy - from->y);
    put_feed(p, first);
    list_move(p, BAT_TOOL_CUTS, start, from->bulge);
}

/* So many chords that each is beside the arc by no more than `off`. */
static batten_status cut_chords(program *p, const bat_vertex *from, double x, double y,
                                double off, bool first)
{
    const double dx = x - from->x, dy = y - from->y, half = 2 * bat_atan(from->bulge);
    const double count = ceil(sqrt(bat_path_sagitta(from, x, y) / off));
    /* A million moves for one arc: more is a wrong tolerance, and 30 MB of text. */
    if (!(count <= 1e6))
        return bat_fail(BATTEN_TOO_LARGE,
                        "an arc from (%g, %g) to (%g, %g) has a larger radius than %g, and "
                        "would be %.0f lines within %g: allow a greater radius, or fewer "
                        "decimals",
                        from->x, from->y, x, y, p->options.greatest_radius, count, off);
    const double chord = bat_hypot(dx, dy) / bat_sin(half), angle = bat_atan2(dy, dx) - half;
    for (int i = 1; i < (int)count; i++) {
        const double part = half * (i / count), length = chord * bat_sin(part);
        cut_line(p, rounded(p, from->x + length * bat_cos(angle + part)),
                 rounded(p, from->y + length * bat_sin(angle + part)), first && i == 1);
    }
    cut_line(p, x, y, first && count <= 1);
    p->flat++;
    return BATTEN_OK;
}

/* From where the tool is. What the decimals do not show of an arc is a line. */
static batten_status cut(program *p, double x, double y, double bulge, bool first)
{
    const bat_vertex from = {p->at[0], p->at[1], bulge};
    const double place = bat_pow(10, -p->options.decimals);
    const double off = bat_path_sagitta(&from, x, y);
    /* chord^2 / (8 off) + off / 2, without a square that overflows. */
    const double radius = off / 2 + bat_hypot(x - from.x, y - from.y) / (4 * fabs(bulge));
    if (x == from.x && y == from.y)
        return BATTEN_OK;
    if (bulge == 0 || off < place / 2)
        cut_line(p, x, y, first);
    else if (radius > p->options.greatest_radius)
        return cut_chords(p, &from, x, y, place, first);
    else
        cut_arc(p, &from, x, y, first);
    return BATTEN_OK;
}

/* ---- paths ---- */

/* A vertex in the machine's coordinates. The frame may look from below: then left is right. */
static bat_vertex vertex_of(const program *p, const bat_path *path, int i)
{
    const bat_vertex v = path->vertices[i % path->count];
    const batten_frame *f = &path->frame;
    const batten_vec3 y = bat_vec3_cross(f->z, f->x);
    const double sign = f->z.z < 0 ? -1 : 1;
    return (bat_vertex){rounded(p, p->scale * (f->origin.x + v.x * f->x.x + v.y * y.x)),
                        rounded(p, p->scale * (f->origin.y + v.x * f->x.y + v.y * y.y)),
                        sign * v.bulge};
}

/* In parentheses, which a comment itself must not have. */
static void put_comment(program *p, const char *name)
{
    batten_text_add(&p->text, "(");
    for (; *name; name++)
        batten_text_add(&p->text, "%c",
                        *name == '(' || *name == ')' || (unsigned char)*name < ' ' ? '_'
                                                                                   : *name);
    batten_text_add(&p->text, ")\n");
}

static void note_flat(const program *p, const batten_object *object, batten_notes *notes)
{
    if (p->flat > 0)
        batten_notes_add(notes, "", 0, object->name,
                         "lines within %g in the place of %d arcs with radii above %g, the "
                         "greatest radius that the control takes",
                         bat_pow(10, -p->options.decimals), p->flat,
                         p->options.greatest_radius);
}

static batten_status put_path(program *p, const batten_object *object, const bat_path *path,
                              batten_notes *notes)
{
    batten_status status = BATTEN_OK;
    const double z = rounded(
        p, p->scale * (isnan(p->options.depth) ? path->frame.origin.z : p->options.depth));
    const bat_vertex start = vertex_of(p, path, 0);
    const int moves = path->closed ? path->count : path->count - 1;
    put_comment(p, object->name);
    p->path = object->name;
    travel(p, start.x, start.y);
    plunge(p, z);
    double bulge = start.bulge;
    p->flat = 0;
    for (int i = 1; i <= moves && status == BATTEN_OK; i++) {
        const bat_vertex to = vertex_of(p, path, i);
        status = cut(p, to.x, to.y, bulge, i == 1);
        bulge = to.bulge;
    }
    note_flat(p, object, notes);
    move_up(p);
    p->paths++;
    return status;
}

static bool is_level(const bat_path *path)
{
    return path->frame.x.z == 0 && path->frame.z.x == 0 && path->frame.z.y == 0;
}

/* A path that the machine can follow, or a note that says why not. */
static batten_status path_of(const batten_object *object, batten_notes *notes, bool *use,
                             bat_path *path)
{
    batten_status status = bat_path_of(object, use, path);
    if (status != BATTEN_OK)
        return status;
    if (!*use) {
        batten_notes_add(notes, "", 0, object->name,
                         "left out: this %s is not a chain of arcs and lines; the feature "
                         "'arcs' makes one of a curve",
                         batten_object_kind_name(object->kind));
    } else if (!is_level(path)) {
        batten_notes_add(notes, "", 0, object->name,
                         "left out: this %s is in no plane z = constant",
                         batten_object_kind_name(object->kind));
        bat_path_release(path);
        *use = false;
    }
    return BATTEN_OK;
}

static batten_status raise_to_path(const batten_object *object, double *highest)
{
    bool use = false;
    bat_path path = {0};
    const batten_status status = path_of(object, NULL, &use, &path);
    if (status != BATTEN_OK)
        return status;
    if (use)
        *highest = bat_max(*highest, path.frame.origin.z);
    bat_path_release(&path);
    return BATTEN_OK;
}

/* The highest path, so that travels clear them all. */
static batten_status find_top(program *p, const batten_model *model)
{
    double highest = isnan(p->options.depth) ? -HUGE_VAL : p->options.depth;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK; i++)
        status = raise_to_path(batten_model_object(model, i), &highest);
    if (status == BATTEN_OK)
        p->top = rounded(p, p->scale * highest + p->options.clearance);
    return status;
}

static batten_status put_paths(program *p, const batten_model *model, batten_notes *notes)
{
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        bool use = false;
        bat_path path = {0};
        batten_status status = path_of(object, notes, &use, &path);
        if (status == BATTEN_OK && use)
            status = put_path(p, object, &path, notes);
        bat_path_release(&path);
        if (status == BATTEN_TOO_LARGE)
            return bat_fail(status, "%s: %s", object->name, batten_message());
        if (status != BATTEN_OK)
            return status;
    }
    if (p->paths == 0)
        return bat_fail(BATTEN_UNSUPPORTED, "G-code holds chains of arcs and polylines in "
                                            "planes z = constant; the model has none");
    return BATTEN_OK;
}

/* ---- the whole ---- */

double bat_gcode_unit_metres(const batten_model *model)
{
    return fabs(batten_model_unit_metres(model) - inch) < 1e-9 * inch ? inch : millimetre;
}

/* Lengths of the options in the machine's unit, with the usual values for 0. */
static void settle(program *p, const batten_model *model)
{
    const double unit_metres = batten_model_unit_metres(model);
    const bool inches = bat_gcode_unit_metres(model) == inch;
    const double mm = inches ? 1 / 25.4 : 1;
    batten_write_gcode_options *o = &p->options;
    p->scale = inches || unit_metres == 0 ? 1 : unit_metres * 1000;
    o->feed = o->feed > 0 ? o->feed * p->scale : 1000 * mm;
    o->plunge = o->plunge > 0 ? o->plunge * p->scale : o->feed / 4;
    o->clearance = o->clearance > 0 ? o->clearance * p->scale : 5 * mm;
    /* Ten metres, as the manual says of the default. */
    o->greatest_radius = o->greatest_radius > 0 ? o->greatest_radius * p->scale : 1e4 * mm;
    if (o->decimals < 0)
        o->decimals = inches ? 5 : 4;
    batten_text_add(&p->text, "%%\n%s (%s)\nG17\n%s\n%s\n", inches ? "G20" : "G21",
                    inches ? "inches" : "millimetres",
                    o->absolute_centres ? "G90.1 (centres are absolute)"
                                        : "G91.1 (centres count from the start of an arc)",
                    o->relative_moves ? "G91 (moves count from where the tool is)" : "G90");
}

batten_status bat_write_gcode(const batten_model *model,
                              const batten_write_gcode_options *options, batten_notes *notes,
                              batten_text *text, bat_tool_moves *moves)
{
    program p = {.options = options ? *options : batten_write_gcode_defaults(),
                 .text = BATTEN_TEXT,
                 .path = "",
                 .moves = moves};
    batten_status status = bat_gcode_check_options(&p.options);
    if (status == BATTEN_OK) {
        settle(&p, model);
        status = find_top(&p, model);
    }
    if (status == BATTEN_OK && isfinite(p.top))
        move_up(&p);
    if (status == BATTEN_OK)
        status = put_paths(&p, model, notes);
    if (status == BATTEN_OK)
        status = p.listed;
    /* No machine is a million metres long: the unit is wrong. */
    if (status == BATTEN_OK && !(p.largest < 1e9))
        status =
            bat_fail(BATTEN_OVERFLOW,
                     "a coordinate of %g is more than controls take: look at the unit of the "
                     "design, or scale and move what is cut",
                     p.largest);
    if (status != BATTEN_OK) {
        batten_text_free(&p.text);
        return status;
    }
    batten_text_add(&p.text, "M2\n%%\n");
    *text = p.text;
    return BATTEN_OK;
}

batten_status batten_write_gcode(const batten_model *model,
                                 const batten_write_gcode_options *options, batten_notes *notes,
                                 char **data, size_t *size)
{
    assert(model && data && size);
    batten_write_gcode_options chosen = batten_write_gcode_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_write_gcode_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    batten_text text = BATTEN_TEXT;
    status = bat_write_gcode(model, &chosen, notes, &text, NULL);
    if (status == BATTEN_OK)
        status = batten_text_take(&text, data, size);
    batten_text_free(&text);
    return status;
}
