/* How many objects there are of each kind. */
#ifndef CLI_TALLY_H
#define CLI_TALLY_H
#include "command.h"

#include <batten/model.h>
#include <batten/text.h>

enum { TALLY_KINDS = BATTEN_OBJECT_INSTANCE + 1 };

typedef struct {
    long long count[TALLY_KINDS];
    long long solids; /* of the bodies; the others are sheets; -1: not known */
} tally;

/* How bodies are counted: IGES and G2 files mostly have their faces one by one. */
typedef enum { TALLY_BODIES, TALLY_FACES } tally_bodies;

tally tally_of(const batten_model *model, tally_bodies bodies);
/* What the model holds when every instance is what it places, 10^15 of a kind at most. */
batten_status tally_placed(const batten_model *model, tally_bodies bodies, tally *out);
/* What writers say of objects, in the notes from `first` on: those that stay whole behind, and
 * those that come near to what they were. */
typedef struct {
    tally left_out;
    int approximated, meshed;
    int faces;      /* of bodies, that could not be meshed */
    bool is_failed; /* an object could not be meshed at all */
} tally_changes;
tally_changes tally_notes(const batten_notes *notes, int first);
/* The kinds without those of `less`, none below 0. */
tally tally_without(tally all, tally less);
long long tally_sum(tally t);

/* "2 solids, 1 curve"; "nothing". */
void tally_text(batten_text *text, tally t);
/* {"bodies": 2, "solids": 1, "sheets": 1, "curves": 1}; `placed`, unless it is NULL, stands in
 * it as "in_all". */
void tally_json(batten_text *text, tally t, const tally *placed);

#endif
