/* Counts what a file cannot say of the objects it holds, with one message for each kind. */
#include "exchange/losses.h"
#include "exchange/csv/separated.h"
#include "model/definitions.h"

#include <string.h>

/* Readers call what has no name by its kind and a number: "curve D1", "LINE 3". */
static bool is_made_up(const char *name)
{
    static const char *const kinds[] = {
        "point",   "points",   "line",     "curve",   "spline",     "arc",       "circle",
        "ellipse", "path",     "polyline", "polygon", "lwpolyline", "rect",      "mesh",
        "surface", "body",     "face",     "faces",   "3dface",     "triangles", "entity",
        "group",   "instance", "polymesh", "offsets"};
    const char *blank = strrchr(name, ' ');
    const size_t length = blank ? (size_t)(blank - name) : strlen(name);
    char word[16];
    if (length >= sizeof word)
        return false;
    memcpy(word, name, length);
    word[length] = '\0';
    const char *digits = blank ? blank + 1 + (blank[1] == 'D') : "";
    if (digits[strspn(digits, "0123456789")])
        return false;
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++)
        if (bat_same_word(word, kinds[k]))
            return true;
    return !*name;
}

/* In the order of the bits BAT_SAYS_... */
enum { NAME, LAYER, COLOUR, GROUP, HIDDEN, KINDS };

typedef struct {
    int count[KINDS];
    const batten_object *first[KINDS]; /* that lost it */
} losses;

static bool has(int what, const batten_object *object, const bat_format_row *row)
{
    switch (what) {
    case NAME:
        return !is_made_up(object->name) && !(row->names_layers && !object->layer[0]);
    case LAYER:
        return object->layer[0];
    case COLOUR:
        return object->has_colour;
    case GROUP:
        return object->group[0];
    default:
        return object->is_hidden;
    }
}

static void count(losses *lost, const bat_format_row *row, const batten_object *object)
{
    const unsigned says = row->says & ~(row->lesser & 1u << object->kind ? row->lacks : 0u);
    for (int k = 0; k < KINDS; k++)
        if (!(says & 1u << k) && has(k, object, row) && lost->count[k]++ == 0)
            lost->first[k] = object;
}

static void note_kind(const losses *lost, int k, const bat_format_row *row, batten_notes *notes)
{
    static const char *const names[KINDS] = {"names", "layers", "colours", "groups",
                                             "that objects are hidden is"};
    const batten_object *first = lost->first[k];
    const bool is_lesser = row->says & 1u << k;
    (k == NAME ? batten_notes_remark : batten_notes_add)(
        notes, "", 0, "", "%s left out: %d ('%.60s' first); %s files hold none%s%s%s", names[k],
        lost->count[k], first->name, row->title, is_lesser ? " for this " : "",
        is_lesser ? batten_object_kind_name(first->kind) : "",
        row->names_layers && k == NAME ? " but those of layers" : "");
}

static void note_loss(const losses *lost, const bat_format_row *row, batten_notes *notes)
{
    for (int k = 0; k < KINDS; k++)
        if (lost->count[k])
            note_kind(lost, k, row, notes);
}

batten_status bat_note_losses(const batten_model *model, const bat_format_row *row,
                              batten_notes *notes)
{
    bat_definitions d = {0};
    losses lost = {{0}, {0}};
    if (!row->holds)
        return BATTEN_OK; /* rows of numbers: it chooses for itself what it says */
    const batten_status status = bat_definitions_find(model, &d);
    for (int i = 0; status == BATTEN_OK && i < d.count; i++)
        for (int k = 0; k < batten_model_count(d.models[i]); k++)
            count(&lost, row, batten_model_object(d.models[i], k));
    bat_definitions_end(&d);
    if (status == BATTEN_OK)
        note_loss(&lost, row, notes);
    return status;
}
