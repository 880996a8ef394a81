/* The sources of features, spelt out, and the index of the literature place by place. */
#ifndef CLI_LITERATURE_H
#define CLI_LITERATURE_H
#include "command.h"

/* Words in lines of at most 92 columns (of UTF-8), those after the first indented; ends the line. */
void literature_wrap(batten_text *text, const char *indent, const char *words);
/* Each source of a feature, with the places in it that the feature names. */
void literature_add_sources(batten_text *text, const batten_feature *feature);
/* The places of the literature that have all of these plain words (search_plain) and the features that stand on
 * them; how many there are. */
int literature_add_places(batten_text *text, const char *words);
/* The whole index as Markdown: docs/literature.md. */
void literature_page(batten_text *text);

#endif
