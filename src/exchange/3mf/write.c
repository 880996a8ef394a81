/* Writes meshes as 3MF: one XML model in a zip archive, with instances as components. */
#include "exchange/3mf/3mf.h"
#include "model/definitions.h"
#include "model/palette.h"

#include <batten/text.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Resource 1 holds the colours; objects follow. */
enum { COLOURS = 1, FIRST_OBJECT = 2 };

typedef struct {
    batten_notes *notes;
    batten_text xml;
    bat_definitions definitions;
    int *order;       /* [definitions] those that others place first */
    int *id;          /* [objects] resource of a mesh or of a placed definition; 0: none */
    int *whole;       /* [definitions] resource of a definition */
    int *same, *look; /* [objects] the first with the same mesh, and with its look too */
    int *shown;       /* [objects] of that first one: the object + 1 that was written first */
    bool *is_open;    /* [objects] */
    bool *is_surface; /* [definitions] something in it is open */
    int colours;      /* base materials so far */
    double scale;     /* from the model's unit to the file's */
    int next;         /* resource */
} writing;

static void put_xml(writing *w, const char *words)
{
    batten_text_bytes(&w->xml, words, strlen(words));
}

static void put_number(writing *w, double value)
{
    batten_text_number(&w->xml, value);
}

/* ---- names and units ---- */

/* Bytes that are no UTF-8 or no character of XML become "?". */
static void put_name(writing *w, const char *name)
{
    put_xml(w, " name=\"");
    while (*name) {
        const size_t length = bat_utf8_length(name);
        const char *entity = length == 0 || (unsigned char)*name < ' ' ? "?"
                             : *name == '&'                            ? "&amp;"
                             : *name == '<'                            ? "&lt;"
                             : *name == '"'                            ? "&quot;"
                                                                       : NULL;
        if (entity)
            put_xml(w, entity);
        else
            batten_text_bytes(&w->xml, name, length);
        name += length ? length : 1;
    }
    put_xml(w, "\"");
}

static const char *unit_of(writing *w, double metres)
{
    static const struct {
        double metres;
        const char *name;
        /* Metres in one unit, by the names of the schema. */
    } units[] = {{1e-6, "micron"}, {0.001, "millimeter"}, {0.01, "centimeter"},
                 {0.0254, "inch"}, {0.3048, "foot"},      {1, "meter"}};
    for (size_t k = 0; k < sizeof units / sizeof units[0]; k++)
        if (metres == units[k].metres)
            return units[k].name;
    if (metres > 0) {
        w->scale = metres / 0.001;
        batten_notes_add(w->notes, "", 0, "",
                         "3MF has no unit of %g m; what is written is in millimetres", metres);
    } else
        batten_notes_add(w->notes, "", 0, "",
                         "the model has no unit; its numbers are taken as millimetres");
    return "millimeter";
}

/* ---- meshes ---- */

static void put_vertex(writing *w, const double point[3])
{
    static const char *const names[] = {"<vertex x=\"", "\" y=\"", "\" z=\""};
    for (int k = 0; k < 3; k++) {
        put_xml(w, names[k]);
        put_number(w, w->scale * point[k]);
    }
    put_xml(w, "\"/>\n");
}

static void put_vertices(writing *w, const batten_mesh_parts *p)
{
    put_xml(w, "<vertices>\n");
    for (size_t i = 0; i < (size_t)p->vertex_count; i++)
        put_vertex(w, p->points + 3 * i);
    put_xml(w, "</vertices>\n");
}

/* Three different vertices are a must. `palette` has the colours from the base material `base`
 * on; NULL when triangles have none. @return how many triangles are left out */
static int put_triangles(writing *w, const batten_mesh_parts *p, const bat_palette *palette,
                         int base)
{
    static const char *const names[] = {"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
    int left_out = 0;
    put_xml(w, "<triangles>\n");
    for (size_t i = 0; i < (size_t)p->triangle_count; i++) {
        const int *t = p->corners + 3 * i;
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
            left_out++;
            continue;
        }
        for (int k = 0; k < 3; k++) {
            put_xml(w, names[k]);
            put_number(w, t[k]);
        }
        if (palette)
            batten_text_add(&w->xml, "\" pid=\"%d\" p1=\"%d", COLOURS, base + palette->of[i]);
        put_xml(w, "\"/>\n");
    }
    put_xml(w, "</triangles>\n");
    return left_out;
}

/* A solid is closed and has its inside inside; all else is a surface. */
static batten_status put_mesh(writing *w, const batten_object *object, int id, bool *is_open)
{
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    batten_mesh_facts facts;
    bat_palette palette = {0};
    batten_status status = batten_mesh_check(object->mesh, &facts);
    if (status == BATTEN_OK && p->triangle_colours)
        status = bat_palette_find(p, &palette);
    if (status != BATTEN_OK)
        return status;
    const bool is_solid = facts.is_watertight && facts.volume > 0;
    batten_text_add(&w->xml, "<object id=\"%d\" type=\"%s\"", id,
                    is_solid ? "model" : "surface");
    put_name(w, object->name);
    const int base = w->colours;
    w->colours += palette.count ? palette.count : object->has_colour;
    if (w->colours > base)
        batten_text_add(&w->xml, " pid=\"%d\" pindex=\"%d\"", COLOURS, base);
    put_xml(w, ">\n<mesh>\n");
    put_vertices(w, p);
    const int left_out = put_triangles(w, p, palette.count ? &palette : NULL, base);
    bat_palette_end(&palette);
    put_xml(w, "</mesh>\n</object>\n");
    *is_open = !is_solid;
    if (left_out)
        batten_notes_add(w->notes, "", 0, object->name,
                         "triangles with two corners at one vertex: %d; left out", left_out);
    return BATTEN_OK;
}

/* ---- definitions ---- */

static void put_colour(writing *w, const char *name, const double colour[3])
{
    unsigned part[3];
    for (int k = 0; k < 3; k++)
        part[k] = (unsigned)(255 * bat_min(bat_max(colour[k], 0), 1) + 0.5);
    if (!w->colours++)
        batten_text_add(&w->xml, "<basematerials id=\"%d\">\n", COLOURS);
    batten_text_add(&w->xml, "<base displaycolor=\"#%02X%02X%02X\"", part[0], part[1], part[2]);
    put_name(w, name);
    put_xml(w, "/>\n");
}

/* The number of an object that was written before and looks like this one, or -1. */
static int find_written(writing *w, int number)
{
    int *shown = &w->shown[w->look[number]];
    if (!*shown)
        *shown = number + 1;
    return *shown == number + 1 ? -1 : *shown - 1;
}

static batten_status put_colours_of(writing *w, const batten_object *object)
{
    const batten_mesh_parts *p = object->mesh ? batten_mesh_view(object->mesh) : NULL;
    bat_palette palette;
    if (!p || !p->triangle_count)
        return BATTEN_OK;
    if (!p->triangle_colours) {
        if (object->has_colour)
            put_colour(w, object->name, object->colour);
        return BATTEN_OK;
    }
    const batten_status status = bat_palette_find(p, &palette);
    for (int i = 0; status == BATTEN_OK && i < palette.count; i++)
        put_colour(w, object->name, bat_palette_colour(&palette, p, i));
    if (status == BATTEN_OK)
        bat_palette_end(&palette);
    return status;
}

static batten_status put_colours_of_model(writing *w, int definition)
{
    const batten_model *model = w->definitions.models[definition];
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < batten_model_count(model); k++) {
        const batten_object *object = batten_model_object(model, k);
        if (find_written(w, w->definitions.first[definition] + k) < 0)
            status = put_colours_of(w, object);
    }
    return status;
}

/* Colours in the order in which their objects will come. */
static batten_status put_colours(writing *w)
{
    batten_status status = bat_definitions_meshes(&w->definitions, w->same, w->look);
    for (int i = 0; status == BATTEN_OK && i < w->definitions.count; i++)
        status = put_colours_of_model(w, w->order[i]);
    if (w->colours)
        put_xml(w, "</basematerials>\n");
    w->colours = 0;
    return status;
}

/* Rows of 3MF multiply from the left: the columns of ours, then the shift. */
static void put_place(writing *w, const batten_affine *place)
{
    put_xml(w, " transform=\"");
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++) {
            put_number(w, place->m[row][column]);
            put_xml(w, " ");
        }
    for (int row = 0; row < 3; row++) {
        put_number(w, w->scale * place->t[row]);
        put_xml(w, row < 2 ? " " : "\"");
    }
}

static void put_reference(writing *w, const batten_object *object, int id, const char *element)
{
    batten_text_add(&w->xml, "<%s objectid=\"%d\"", element, id);
    if (object->definition)
        put_place(w, &object->place);
    put_xml(w, "/>\n");
}

/* What stands in a definition or in the build, by `element`. */
static void put_references(writing *w, int definition, const char *element)
{
    const batten_model *model = w->definitions.models[definition];
    for (int k = 0; k < batten_model_count(model); k++) {
        const batten_object *object = batten_model_object(model, k);
        const int id = w->id[w->definitions.first[definition] + k];
        if (id)
            put_reference(w, object, id, element);
    }
}

/* One that looks like another is that one. */
static batten_status add_mesh(writing *w, const batten_object *object, int definition, int k)
{
    const int number = w->definitions.first[definition] + k;
    const int written = find_written(w, number);
    bool is_open = false;
    batten_status status = BATTEN_OK;
    w->id[number] = written < 0 ? w->next++ : w->id[written];
    if (written < 0)
        status = put_mesh(w, object, w->id[number], &is_open);
    w->is_open[number] = written < 0 ? is_open : w->is_open[written];
    w->is_surface[definition] = w->is_surface[definition] || w->is_open[number];
    return status;
}

/* The objects of a definition, and when it is placed somewhere the definition itself. */
static batten_status put_definition(writing *w, int definition)
{
    const batten_model *model = w->definitions.models[definition];
    batten_status status = BATTEN_OK;
    bool any = false;
    for (int k = 0; status == BATTEN_OK && k < batten_model_count(model); k++) {
        const batten_object *object = batten_model_object(model, k);
        int *id = &w->id[w->definitions.first[definition] + k];
        if (object->definition) {
            const int inner = bat_definitions_index(&w->definitions, object->definition);
            *id = w->whole[inner];
            w->is_surface[definition] = w->is_surface[definition] || w->is_surface[inner];
        } else if (object->mesh && batten_mesh_view(object->mesh)->triangle_count) {
            status = add_mesh(w, object, definition, k);
        }
        any = any || *id;
    }
    if (status != BATTEN_OK || definition == 0 || !any)
        return status;
    w->whole[definition] = w->next++;
    batten_text_add(&w->xml, "<object id=\"%d\" type=\"%s\"", w->whole[definition],
                    w->is_surface[definition] ? "surface" : "model");
    if (batten_model_name(model)[0])
        put_name(w, batten_model_name(model));
    put_xml(w, ">\n<components>\n");
    put_references(w, definition, "component");
    put_xml(w, "</components>\n</object>\n");
    return BATTEN_OK;
}

static batten_status put_model(writing *w, const batten_model *model)
{
    const char *unit = unit_of(w, batten_model_unit_metres(model));
    batten_text_add(
        &w->xml,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<model unit=\"%s\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
        "<metadata name=\"Application\">Batten</metadata>\n"
        "<resources>\n",
        unit);
    batten_status status = put_colours(w);
    w->next = FIRST_OBJECT;
    for (int i = 0; status == BATTEN_OK && i < w->definitions.count; i++)
        status = put_definition(w, w->order[i]);
    put_xml(w, "</resources>\n<build>\n");
    put_references(w, 0, "item");
    put_xml(w, "</build>\n</model>\n");
    return status;
}

/* ---- the archive ---- */

static const char content_types[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";

static const char relations[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    "<Relationship Id=\"rel0\" Target=\"/3D/3dmodel.model\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";

static batten_status make_room(writing *w)
{
    const size_t definitions = (size_t)w->definitions.count;
    const size_t objects = (size_t)w->definitions.first[definitions];
    w->order = bat_array(definitions, sizeof *w->order);
    w->whole = bat_array(definitions, sizeof *w->whole);
    w->is_surface = bat_array(definitions, sizeof *w->is_surface);
    w->id = bat_array(objects, sizeof *w->id);
    w->same = bat_array(objects, sizeof *w->same);
    w->look = bat_array(objects, sizeof *w->look);
    w->shown = bat_array(objects, sizeof *w->shown);
    w->is_open = bat_array(objects, sizeof *w->is_open);
    return w->order && w->whole && w->is_surface && w->id && w->same && w->look && w->shown &&
                   w->is_open
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

batten_status bat_write_3mf(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text)
{
    (void)options;
    writing w = {.notes = notes, .scale = 1};
    batten_status status = bat_definitions_find(model, &w.definitions);
    if (status == BATTEN_OK)
        status = make_room(&w);
    if (status == BATTEN_OK)
        bat_definitions_rising(&w.definitions, w.order);
    if (status == BATTEN_OK)
        status = put_model(&w, model);
    if (status == BATTEN_OK) {
        const bat_zip_member members[] = {
            {"[Content_Types].xml", content_types, sizeof content_types - 1},
            {"_rels/.rels", relations, sizeof relations - 1},
            {"3D/3dmodel.model", w.xml.bytes, w.xml.length}};
        text->failed = text->failed || w.xml.failed;
        status = text->failed ? BATTEN_OK : bat_zip(3, members, text);
    }
    bat_definitions_end(&w.definitions);
    bat_release(w.order);
    bat_release(w.whole);
    bat_release(w.is_surface);
    bat_release(w.id);
    bat_release(w.same);
    bat_release(w.look);
    bat_release(w.shown);
    bat_release(w.is_open);
    batten_text_free(&w.xml);
    return status;
}
