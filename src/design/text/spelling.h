/* Spelling: which known name the writer of an unknown word may have meant. */
#ifndef BAT_DESIGN_SPELLING_H
#define BAT_DESIGN_SPELLING_H
#include <stdbool.h>

/* Is `a` near enough to be what the writer of `word` meant, and nearer than `*best`? */
bool bat_is_nearer(const char *word, const char *a, int *best);

#endif
