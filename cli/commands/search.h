/* What `batten help WORDS` finds where no topic has that name. */
#ifndef CLI_SEARCH_H
#define CLI_SEARCH_H
#include "command.h"

/* Features, commands, formats and places of the literature that hold all the words, best first. False, with
 * nothing added, when nothing was found. */
bool search_add(batten_text *text, const char *words, const command_table *table);
/* Words in lower case, without accents, separated by single blanks; yours to batten_release. */
char *search_plain(const char *words);

#endif
