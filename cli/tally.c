#include "tally.h"

#include <stdlib.h>
#include <string.h>

static const char *const several[TALLY_KINDS] = {[BATTEN_OBJECT_POINTS] = "rows of points",
                                                 [BATTEN_OBJECT_CURVE] = "curves",
                                                 [BATTEN_OBJECT_SURFACE] = "surfaces",
                                                 [BATTEN_OBJECT_OFFSETS] = "tables of offsets",
                                                 [BATTEN_OBJECT_TRIANGLES] =
                                                     "sets of Bezier triangles",
                                                 [BATTEN_OBJECT_BODY] = "bodies",
                                                 [BATTEN_OBJECT_MESH] = "meshes",
                                                 [BATTEN_OBJECT_INSTANCE] = "instances"};

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
    tally_changes found = {{{0}}, 0, 0, 0, false};
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
                        t.count[k] == 1 ? batten_object_kind_name((batten_object_kind)k)
                                        : several[k]);
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
