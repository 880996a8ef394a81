/* How many objects there are of each kind. */
#ifndef CLI_TALLY_H
#define CLI_TALLY_H
#include "command.h"

enum { TALLY_KINDS = BATTEN_OBJECT_INSTANCE + 1 };

typedef struct {
    int count[TALLY_KINDS];
} tally;

tally tally_of(const batten_model *model);
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
int tally_sum(tally t);

/* "2 bodies, 1 curve"; "nothing". */
void tally_text(batten_text *text, tally t);
/* {"bodies": 2, "curves": 1} */
void tally_json(batten_text *text, tally t);

#endif
