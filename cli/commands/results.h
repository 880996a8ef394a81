/* What became of the features of a design, for people and as JSON. */
#ifndef CLI_RESULTS_H
#define CLI_RESULTS_H
#include "command.h"

#include <batten/design.h>
#include <batten/text.h>

/* `outputs`: names of the files that were made. */
void results_json(batten_text *text, const batten_design *design, int output_count,
                  const char *const *outputs, const batten_notes *notes);
void results_text(batten_text *text, const batten_design *design, int output_count,
                  const char *const *outputs);

#endif
