/* A design in memory: what its edits and its evaluation share. */
#ifndef BAT_DESIGN_STATE_H
#define BAT_DESIGN_STATE_H
#include "design/text/document.h"

/* Of an output when it was last made. */
typedef struct {
    bool unmet, partly; /* a bound; of what is there */
} bat_outcome;

/* A text, what it says, and the results so far. An edit makes another of these. */
typedef struct {
    char *text;
    size_t length;
    bat_document document;
    bat_result *results; /* [feature_count] */
    int *evaluated;      /* [feature_count] in the order of evaluation */
    int evaluated_count;
    bat_outcome *outcomes; /* [output_count] */
} bat_design_state;

struct batten_design {
    char *file_name;
    bool allow_outside;
    batten_limits limits;
    char *provided_file;
    batten_model *provided;
    bat_design_state now;
};

/* Give back what a result holds. */
void bat_result_release(bat_result *result);
/* Let what is shown of a result point to its entry and to itself. */
void bat_result_settle(const bat_entry *entry, bat_result *result);

#endif
