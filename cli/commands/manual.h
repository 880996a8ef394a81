/* The manual pages and the completion, made from the same tables as the help. */
#ifndef CLI_MANUAL_H
#define CLI_MANUAL_H
#include "command.h"

#include <batten/text.h>

void manual_page(batten_text *text, const command_table *table);       /* batten(1) */
void manual_design_page(batten_text *text);                            /* batten-design(5) */
void manual_completion(batten_text *text, const command_table *table); /* for bash */

#endif
