/* An SVG drawing: groups, looks, and every shape as a curve. */
#include "exchange/reading/census.h"
#include "exchange/reading/scan.h"
#include "exchange/svg/shapes.h"
#include "exchange/svg/sheet.h"
#include "exchange/svg/xml.h"

#include <stdio.h>
#include <string.h>

enum { NAME = 256, GROUP = 512 };

/* What elements inside inherit. */
typedef struct {
    bat_svg_map map;
    bool is_hidden, has_colour;
    double colour[3];
    size_t group; /* length of the name of the group */
} level;

typedef struct {
    bat_xml xml;
    bat_input *input;
    batten_model *model;
    bat_census census;
    bat_svg_row row;
    level *levels; /* [limits.nesting + 1] */
    int depth;
    char group[GROUP];
    int number; /* objects so far */
    /* of the element at work */
    level look;
    char name[NAME], layer[NAME];
    int parts;     /* that became curves */
    char left[32]; /* what was left out first */
} reading;

batten_status bat_svg_recognise(const bat_input *input, bool *is_svg)
{
    bat_input copy = *input;
    bat_xml xml;
    const size_t at = bat_past_white(input);
    *is_svg = false;
    if (at >= input->size || input->data[at] != '<')
        return BATTEN_OK;
    copy.data += at;
    copy.size -= at;
    bat_xml_begin(&xml, &copy);
    *is_svg =
        bat_xml_next(&xml) == BATTEN_OK && xml.kind == BAT_XML_BEGIN && bat_xml_is(&xml, "svg");
    bat_xml_end(&xml);
    return BATTEN_OK;
}

/* ---- looks ---- */

static bat_span without_white(bat_span text)
{
    while (text.length > 0 && bat_is_white(text.bytes[text.length - 1]))
        text.length--;
    while (text.length > 0 && bat_is_white(text.bytes[0])) {
        text.bytes++;
        text.length--;
    }
    return text;
}

/* One declaration of a style, "name : value": is it of that name? */
static bool declares(bat_span declaration, const char *name, bat_span *value)
{
    const char *colon =
        declaration.length ? memchr(declaration.bytes, ':', declaration.length) : NULL;
    if (!colon)
        return false;
    const size_t before = (size_t)(colon - declaration.bytes);
    *value = without_white((bat_span){colon + 1, declaration.length - before - 1});
    return bat_svg_says(without_white((bat_span){declaration.bytes, before}), name);
}

/* A property in "style", or in an attribute of its own. */
static bool property(const bat_xml *xml, const char *name, bat_span *value)
{
    bat_span style;
    const bool has_style = bat_xml_attribute(xml, "style", &style);
    for (size_t at = 0, end = 0; has_style && at < style.length; at = end + 1) {
        for (end = at; end < style.length && style.bytes[end] != ';';)
            end++;
        if (declares((bat_span){style.bytes + at, end - at}, name, value))
            return true;
    }
    if (!bat_xml_attribute(xml, name, value))
        return false;
    *value = without_white(*value);
    return true;
}

static batten_status read_transform(const reading *r, level *look)
{
    bat_span text;
    bat_svg_map map;
    if (!property(&r->xml, "transform", &text) || bat_svg_says(text, "none"))
        return BATTEN_OK;
    batten_status status = bat_svg_transform(r->input, r->xml.line, text, &map);
    if (status == BATTEN_OK)
        look->map = bat_svg_compose(map, look->map);
    return status;
}

static bool property_is(const bat_xml *xml, const char *name, const char *wanted)
{
    bat_span text;
    return property(xml, name, &text) && bat_svg_says(text, wanted);
}

static void read_colour(const bat_xml *xml, level *look)
{
    bat_span text;
    double colour[3];
    if (property(xml, "stroke", &text) && bat_svg_colour(text, colour)) {
        look->has_colour = true;
        memcpy(look->colour, colour, sizeof colour);
    }
}

/* What the element at work adds to what it inherits. A broken transform fails. */
static batten_status read_look(const reading *r, level *look)
{
    *look = r->levels[r->depth];
    look->is_hidden = look->is_hidden || property_is(&r->xml, "display", "none") ||
                      property_is(&r->xml, "visibility", "hidden");
    read_colour(&r->xml, look);
    return read_transform(r, look);
}

/* ---- curves ---- */

static void name_row(const reading *r, size_t size, char *name)
{
    if (r->parts > 1)
        snprintf(name, size, "%s.%d", r->name, r->parts);
    else
        snprintf(name, size, "%s", r->name);
}

static batten_object object_of(const reading *r, const char *name, batten_curve *curve)
{
    batten_object object = {.name = name,
                            .layer = r->layer,
                            .group = r->group,
                            .is_hidden = r->look.is_hidden,
                            .has_colour = r->look.has_colour,
                            .kind = BATTEN_OBJECT_CURVE,
                            .curve = curve};
    memcpy(object.colour, r->look.colour, sizeof object.colour);
    return object;
}

/* One part of the element at work as a curve; parts after the first are numbered. */
static batten_status take_row(void *context, const bat_svg_row *row)
{
    reading *r = context;
    char name[NAME + 16];
    batten_curve *curve = NULL;
    batten_status status = bat_svg_curve(row, &r->look.map, &curve);
    if (status != BATTEN_OK || !curve)
        return status;
    r->parts++;
    name_row(r, sizeof name, name);
    const batten_object object = object_of(r, name, curve);
    status = batten_model_add(r->model, &object);
    batten_curve_unref(curve);
    return status;
}

/* ---- elements ---- */

static bool is_one_of(const bat_xml *xml, const char *const *names)
{
    for (; *names; names++)
        if (bat_xml_is(xml, *names))
            return true;
    return false;
}

/* A name as the census may have it. */
static void kind_of(const bat_xml *xml, char name[32])
{
    const size_t length = xml->name.length < 31 ? xml->name.length : 31;
    memcpy(name, xml->name.bytes, length);
    name[length] = '\0';
}

static batten_status leave_out(reading *r, const char *kind, const char *why)
{
    if (r->input->left_out++ == 0)
        snprintf(r->left, sizeof r->left, "%s", kind);
    if (why)
        batten_notes_add(r->input->notes, r->input->file, r->xml.line, kind, "%s; %s", why,
                         r->parts ? "what stands before it is kept" : "left out");
    return bat_census_leave(r->input, &r->census, kind);
}

static void name_shape(reading *r, char kind[32])
{
    kind_of(&r->xml, kind);
    bat_xml_text(&r->xml, "id", sizeof r->name, r->name);
    bat_xml_text(&r->xml, "class", sizeof r->layer, r->layer);
    r->number++;
    if (!r->name[0])
        snprintf(r->name, sizeof r->name, "%s %d", kind, r->number);
}

static batten_status add_shape(reading *r)
{
    char kind[32];
    name_shape(r, kind);
    batten_status status = bat_input_limit(r->input, r->xml.line, (size_t)r->number,
                                           r->input->limits.entities, "shapes");
    if (status == BATTEN_OK)
        status = read_look(r, &r->look);
    if (status == BATTEN_OK)
        status = bat_svg_shape(&r->xml, &r->row, take_row, r);
    if (bat_input_ends(status))
        return status;
    if (status != BATTEN_OK)
        return leave_out(r, kind, batten_message());
    if (r->parts == 0)
        batten_notes_remark(r->input->notes, r->input->file, r->xml.line, kind,
                            "it has no length and makes no curve");
    return bat_census_read(r->input, &r->census, kind);
}

/* A group of elements, or the drawing itself. Names of groups follow one another: "a/b". */
static batten_status enter(reading *r)
{
    level look;
    char name[NAME];
    batten_status status = read_look(r, &look);
    if (bat_input_ends(status))
        return status;
    if (status != BATTEN_OK)
        status = leave_out(r, "transform", batten_message());
    bat_xml_text(&r->xml, "id", sizeof name, name);
    if (name[0] && bat_xml_is(&r->xml, "g") && look.group + strlen(name) + 2 < GROUP)
        look.group += (size_t)snprintf(r->group + look.group, GROUP - look.group, "%s%s",
                                       look.group ? "/" : "", name);
    r->levels[++r->depth] = look;
    return status;
}

/* Past an element with all that it holds: what is drawn only where it is used, text, styles. */
static batten_status skip(reading *r)
{
    int depth = 1;
    if (r->xml.kind == BAT_XML_ALONE)
        return BATTEN_OK;
    while (depth > 0) {
        batten_status status = bat_xml_next(&r->xml);
        if (status != BATTEN_OK || r->xml.kind == BAT_XML_NONE)
            return status;
        depth += r->xml.kind == BAT_XML_BEGIN ? 1 : r->xml.kind == BAT_XML_END ? -1 : 0;
    }
    return BATTEN_OK;
}

static batten_status skip_deep(reading *r)
{
    char why[80];
    snprintf(why, sizeof why, "it is nested deeper than %d groups", r->input->limits.nesting);
    const batten_status status = leave_out(r, "g", why);
    return status == BATTEN_OK ? skip(r) : status;
}

static bool has_sheet(const bat_xml *xml)
{
    bat_span text;
    return bat_xml_attribute(xml, "viewBox", &text) || bat_xml_attribute(xml, "x", &text) ||
           bat_xml_attribute(xml, "y", &text);
}

static batten_status read_element(reading *r)
{
    static const char *const silent[] = {"defs",     "style",     "script",   "title", "desc",
                                         "metadata", "namedview", "clipPath", "mask",  "marker",
                                         "symbol",   "pattern",   NULL};
    static const char *const groups[] = {"g", "svg", "a", "switch", NULL};
    char kind[32];
    r->parts = 0;
    if (bat_svg_is_shape(&r->xml)) {
        batten_status status = add_shape(r);
        return status == BATTEN_OK ? skip(r) : status;
    }
    if (bat_xml_is(&r->xml, "svg") && has_sheet(&r->xml)) {
        batten_status status =
            leave_out(r, "svg", "a drawing within the drawing, on a sheet of its own");
        return status == BATTEN_OK ? skip(r) : status;
    }
    if (is_one_of(&r->xml, groups) && r->depth < r->input->limits.nesting)
        return r->xml.kind == BAT_XML_BEGIN ? enter(r) : BATTEN_OK;
    if (is_one_of(&r->xml, groups))
        return skip_deep(r);
    if (is_one_of(&r->xml, silent))
        return skip(r);
    kind_of(&r->xml, kind);
    batten_status status = leave_out(r, kind, NULL);
    return status == BATTEN_OK ? skip(r) : status;
}

static size_t past_white(const bat_input *input, size_t at)
{
    while (at < input->size && bat_is_white(input->data[at]))
        at++;
    return at;
}

/* A comment without an end goes on to the end of the file. */
static size_t past_comment(const bat_input *input, size_t begin)
{
    size_t end = begin + 4;
    while (end < input->size && !bat_begins(input, end, "-->"))
        end++;
    return end < input->size ? end + 3 : end;
}

/* Comments may follow the end, and nothing else. */
static void note_behind(const reading *r)
{
    const bat_input *input = r->input;
    const bat_span last = r->xml.attributes; /* of </svg>: up to its '>' */
    size_t at = past_white(input, (size_t)(last.bytes + last.length + 1 - input->data));
    while (bat_begins(input, at, "<!--"))
        at = past_white(input, past_comment(input, at));
    bat_input_behind(input, at);
}

static batten_status read_root(reading *r)
{
    batten_status status = bat_xml_next(&r->xml);
    if (status == BATTEN_OK && !bat_xml_is(&r->xml, "svg"))
        status = bat_input_fail(r->input, BATTEN_BAD_FORMAT, r->xml.line,
                                "the drawing does not begin with <svg>");
    if (status == BATTEN_OK)
        r->levels[0] = (level){.map = bat_svg_sheet_of(&r->xml)};
    return status;
}

static batten_status read_all(reading *r)
{
    batten_status status = read_root(r);
    while (status == BATTEN_OK) {
        status = bat_xml_next(&r->xml);
        if (status != BATTEN_OK || r->xml.kind == BAT_XML_NONE)
            break;
        status = bat_input_step(r->input, r->xml.at);
        if (status == BATTEN_OK && r->xml.kind != BAT_XML_END) {
            status = read_element(r);
        } else if (status == BATTEN_OK) {
            if (r->depth == 0) { /* </svg> */
                note_behind(r);
                return BATTEN_OK;
            }
            r->depth--;
        }
        r->group[r->levels[r->depth].group] = '\0';
    }
    r->input->is_cut = status == BATTEN_OK;
    return status;
}

batten_status bat_read_svg(bat_input *input, batten_model **out)
{
    reading r = {.input = input};
    bat_xml_begin(&r.xml, input);
    bat_svg_row_begin(&r.row, input);
    bat_census_begin(&r.census);
    batten_status status =
        bat_input_array(input, (size_t)input->limits.nesting + 1, sizeof *r.levels, &r.levels);
    if (status == BATTEN_OK)
        status = batten_model_create(0.001, &r.model);
    if (status == BATTEN_OK)
        status = read_all(&r);
    if (status == BATTEN_OK && batten_model_count(r.model) == 0 && input->left_out > 0)
        status = bat_input_fail(input, BATTEN_UNSUPPORTED, 0,
                                "none of its %d shapes could be read; the first is a '%s'",
                                input->left_out, r.left);
    if (status == BATTEN_OK) {
        bat_census_note(input, &r.census);
        *out = batten_model_ref(r.model);
    }
    batten_model_unref(r.model);
    bat_svg_row_end(&r.row);
    bat_xml_end(&r.xml);
    bat_census_end(&r.census);
    bat_release(r.levels);
    return status;
}
