/* What the command says to people: on standard error, one line a message. */
#ifndef CLI_COMPLAIN_H
#define CLI_COMPLAIN_H
#include <batten/base.h>

/* One line on standard error; control characters that file names may hold are shown escaped. */
void complain(const char *format, ...) BATTEN_PRINTF(1, 2);

/* The name that a misspelt word most likely means: at most a third of its letters differ; or
 * NULL. */
const char *nearest_name(const char *word, int count, const char *const *names);
/* The names nearest to a word, however far, the nearest first and none twice: at most `most`.
 * @return how many */
int nearest_names(const char *word, int count, const char *const *names, int most,
                  const char **out);

#endif
