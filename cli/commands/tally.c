/* Counts of the kinds of objects in a model, in words. */
#include "commands/tally.h"

#include <batten/model.h>
#include <batten/text.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const char *const several[TALLY_KINDS] = {
    [BATTEN_OBJECT_POINTS] = "rows of points",
    [BATTEN_OBJECT_CURVE] = "curves",
    [BATTEN_OBJECT_SURFACE] = "surfaces",
    [BATTEN_OBJECT_OFFSET_TABLE] = "tables of offsets",
    [BATTEN_OBJECT_TRIANGLES] = "sets of Bezier triangles",
    [BATTEN_OBJECT_BODY] = "bodies",
    [BATTEN_OBJECT_MESH] = "meshes",
    [BATTEN_OBJECT_INSTANCE] = "instances"};

static const char *const keys[TALLY_KINDS] = {
    [BATTEN_OBJECT_POINTS] = "points",       [BATTEN_OBJECT_CURVE] = "curves",
    [BATTEN_OBJECT_SURFACE] = "surfaces",    [BATTEN_OBJECT_OFFSET_TABLE] = "offsets",
    [BATTEN_OBJECT_TRIANGLES] = "triangles", [BATTEN_OBJECT_BODY] = "bodies",
    [BATTEN_OBJECT_MESH] = "meshes",         [BATTEN_OBJECT_INSTANCE] = "instances"};

static void add_object(const batten_object *object, tally_bodies bodies, tally *t)
{
    const batten_body_parts *parts = object->body ? batten_body_view(object->body) : NULL;
    const bool by_faces = parts && bodies == TALLY_FACES;
    t->count[object->kind] += by_faces ? parts->face_count : 1;
    t->solids += parts && parts->is_solid && !by_faces;
}

tally tally_of(const batten_model *model, tally_bodies bodies)
{
    tally t = {.solids = 0};
    for (int i = 0; i < batten_model_count(model); i++)
        add_object(batten_model_object(model, i), bodies, &t);
    return t;
}

/* ---- what is placed ---- */

/* What a definition holds, each counted once however often it is placed. */
typedef struct {
    const batten_model *model;
    tally held;
} counted;

typedef struct {
    tally_bodies bodies;
    size_t size, used; /* a table by address, size a power of 2, never more than half full */
    counted *rows;
} counting;

static counted *find_row(const counting *c, const batten_model *model)
{
    size_t at = (size_t)((uintptr_t)model / 16 * 0x9E3779B1u) & (c->size - 1);
    while (c->rows[at].model && c->rows[at].model != model)
        at = (at + 1) & (c->size - 1);
    return &c->rows[at];
}

static batten_status keep_row(counting *c, const batten_model *model, const tally *held)
{
    if (2 * (c->used + 1) > c->size) {
        counting wider = *c;
        wider.size = c->size ? 2 * c->size : 64;
        wider.rows = batten_array(wider.size, sizeof *wider.rows);
        if (!wider.rows)
            return batten_fail(BATTEN_OUT_OF_MEMORY, "no memory to count what is placed");
        memset(wider.rows, 0, wider.size * sizeof *wider.rows);
        for (size_t i = 0; i < c->size; i++)
            if (c->rows[i].model)
                *find_row(&wider, c->rows[i].model) = c->rows[i];
        batten_release(c->rows);
        *c = wider;
    }
    *find_row(c, model) = (counted){model, *held};
    c->used++;
    return BATTEN_OK;
}

static void add_up_to_most(long long *to, long long more)
{
    const long long most = 1000000000000000;
    *to = *to + more < most ? *to + more : most;
}

/* Instances lie at most 32 deep within instances. */
static batten_status count_placed(counting *c, const batten_model *model, tally *out)
{
    tally all = {.solids = 0};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        tally held = {.solids = 0};
        if (object->kind != BATTEN_OBJECT_INSTANCE) {
            add_object(object, c->bodies, &held);
        } else {
            const counted *row = c->size ? find_row(c, object->definition) : NULL;
            if (row && row->model)
                held = row->held;
            else
                status = count_placed(c, object->definition, &held);
        }
        for (int k = 0; k < TALLY_KINDS; k++)
            add_up_to_most(&all.count[k], held.count[k]);
        add_up_to_most(&all.solids, held.solids);
    }
    *out = all;
    return status == BATTEN_OK ? keep_row(c, model, &all) : status;
}

batten_status tally_placed(const batten_model *model, tally_bodies bodies, tally *out)
{
    counting c = {.bodies = bodies};
    const batten_status status = count_placed(&c, model, out);
    batten_release(c.rows);
    return status;
}

/* ---- what is left out ---- */

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* The kind that the note of an object left out names, "this curve": names do not tell, since
 * objects may share them. -1: the note is of something else. */
static int kind_left_out(const char *text)
{
    const char *kind = begins(text, "left out") ? strstr(text, "this ") : NULL;
    for (int k = 0; kind && k < TALLY_KINDS; k++)
        if (begins(kind + strlen("this "), batten_object_kind_name((batten_object_kind)k)))
            return k;
    return -1;
}

tally_changes tally_notes(const batten_notes *notes, int first)
{
    static const char faces[] = "faces left out of the mesh: ";
    tally_changes found = {.faces = 0};
    for (int i = first; i < batten_notes_count(notes); i++) {
        const char *text = batten_notes_at(notes, i)->text;
        const int kind = kind_left_out(text);
        const bool near = begins(text, "approximated");
        found.approximated += near;
        found.meshed += begins(text, "meshed") || (near && strstr(text, " triangles"));
        found.is_failed |= kind >= 0 && strstr(text, "cannot be meshed");
        if (begins(text, faces))
            found.faces += (int)strtol(text + sizeof faces - 1, NULL, 10);
        if (kind >= 0)
            found.left_out.count[kind]++;
    }
    return found;
}

tally tally_without(tally all, tally less)
{
    const long long bodies = all.count[BATTEN_OBJECT_BODY];
    for (int k = 0; k < TALLY_KINDS; k++)
        all.count[k] = all.count[k] > less.count[k] ? all.count[k] - less.count[k] : 0;
    if (all.solids == bodies || all.count[BATTEN_OBJECT_BODY] == 0)
        all.solids = all.count[BATTEN_OBJECT_BODY];
    else if (less.count[BATTEN_OBJECT_BODY] > 0 && all.solids > 0)
        all.solids = -1;
    return all;
}

long long tally_sum(tally t)
{
    long long sum = 0;
    for (int k = 0; k < TALLY_KINDS; k++)
        sum += t.count[k];
    return sum;
}

static void text_count(batten_text *text, bool *first, long long count, const char *one,
                       const char *more)
{
    if (count == 0)
        return;
    batten_text_add(text, "%s%lld %s", *first ? "" : ", ", count, count == 1 ? one : more);
    *first = false;
}

static void text_kind(batten_text *text, bool *first, tally t, int k)
{
    if (k == BATTEN_OBJECT_BODY && t.solids >= 0) {
        text_count(text, first, t.solids, "solid", "solids");
        text_count(text, first, t.count[k] - t.solids, "sheet", "sheets");
    } else
        text_count(text, first, t.count[k], batten_object_kind_name((batten_object_kind)k),
                   several[k]);
}

void tally_text(batten_text *text, tally t)
{
    bool first = true;
    for (int k = 0; k < TALLY_KINDS; k++)
        text_kind(text, &first, t, k);
    batten_text_add(text, "%s", first ? "nothing" : "");
}

static void json_count(batten_text *text, bool *first, const char *key, long long count)
{
    if (count == 0)
        return;
    batten_text_add(text, "%s\"%s\": %lld", *first ? "" : ", ", key, count);
    *first = false;
}

static void json_kind(batten_text *text, bool *first, tally t, int k)
{
    json_count(text, first, keys[k], t.count[k]);
    if (k == BATTEN_OBJECT_BODY && t.solids >= 0) {
        json_count(text, first, "solids", t.solids);
        json_count(text, first, "sheets", t.count[k] - t.solids);
    }
}

void tally_json(batten_text *text, tally t, const tally *placed)
{
    bool first = true;
    batten_text_add(text, "{");
    for (int k = 0; k < TALLY_KINDS; k++)
        json_kind(text, &first, t, k);
    if (placed) {
        batten_text_add(text, ", \"in_all\": ");
        tally_json(text, *placed, NULL);
    }
    batten_text_add(text, "}");
}
