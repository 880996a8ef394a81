#include "tally.h"

#include <stdlib.h>
#include <string.h>

static const char *const names[TALLY_KINDS][2] = {
    [BATTEN_OBJECT_POINTS] = {"row of points", "rows of points"},
    [BATTEN_OBJECT_CURVE] = {"curve", "curves"},
    [BATTEN_OBJECT_SURFACE] = {"surface", "surfaces"},
    [BATTEN_OBJECT_OFFSETS] = {"table of offsets", "tables of offsets"},
    [BATTEN_OBJECT_TRIANGLES] = {"set of Bezier triangles", "sets of Bezier triangles"},
    [BATTEN_OBJECT_BODY] = {"body", "bodies"},
    [BATTEN_OBJECT_MESH] = {"mesh", "meshes"},
    [BATTEN_OBJECT_INSTANCE] = {"instance", "instances"}};

static const char *const keys[TALLY_KINDS] = {
    [BATTEN_OBJECT_POINTS] = "points",       [BATTEN_OBJECT_CURVE] = "curves",
    [BATTEN_OBJECT_SURFACE] = "surfaces",    [BATTEN_OBJECT_OFFSETS] = "offsets",
    [BATTEN_OBJECT_TRIANGLES] = "triangles", [BATTEN_OBJECT_BODY] = "bodies",
    [BATTEN_OBJECT_MESH] = "meshes",         [BATTEN_OBJECT_INSTANCE] = "instances"};

tally tally_of(const batten_model *model)
{
    tally t = {{0}};
    for (int i = 0; i < batten_model_count(model); i++)
        t.count[batten_model_object(model, i)->kind]++;
    return t;
}

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

tally_changes tally_notes(const batten_model *model, const batten_notes *notes, int first)
{
    static const char faces[] = "faces left out of the mesh: ";
    tally_changes found = {{{0}}, 0, 0, false};
    for (int i = first; i < batten_notes_count(notes); i++) {
        const batten_note *note = batten_notes_at(notes, i);
        const int object = batten_model_find(model, note->entity);
        found.approximated += begins(note->text, "approximated");
        found.is_failed |= begins(note->text, "left out, as it cannot be meshed");
        if (begins(note->text, faces))
            found.faces += (int)strtol(note->text + sizeof faces - 1, NULL, 10);
        if (object >= 0 && begins(note->text, "left out"))
            found.left_out.count[batten_model_object(model, object)->kind]++;
    }
    return found;
}

tally tally_without(tally all, tally less)
{
    for (int k = 0; k < TALLY_KINDS; k++)
        all.count[k] = all.count[k] > less.count[k] ? all.count[k] - less.count[k] : 0;
    return all;
}

int tally_sum(tally t)
{
    int sum = 0;
    for (int k = 0; k < TALLY_KINDS; k++)
        sum += t.count[k];
    return sum;
}

void tally_text(batten_text *text, tally t)
{
    bool first = true;
    for (int k = 0; k < TALLY_KINDS; k++) {
        if (t.count[k] == 0)
            continue;
        batten_text_add(text, "%s%d %s", first ? "" : ", ", t.count[k],
                        names[k][t.count[k] != 1]);
        first = false;
    }
    batten_text_add(text, "%s", first ? "nothing" : "");
}

void tally_json(batten_text *text, tally t)
{
    bool first = true;
    batten_text_add(text, "{");
    for (int k = 0; k < TALLY_KINDS; k++)
        if (t.count[k]) {
            batten_text_add(text, "%s\"%s\": %d", first ? "" : ", ", keys[k], t.count[k]);
            first = false;
        }
    batten_text_add(text, "}");
}
