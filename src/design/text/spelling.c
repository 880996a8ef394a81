/* Spelling: which known name the writer of an unknown word may have meant. */
#include "design/text/spelling.h"

#include "base/base.h"
#include "design/text/edit_distance.h"
#include <string.h>

bool bat_is_nearer(const char *word, const char *a, int *best)
{
    /* A third of the letters may be wrong, and never all of them. */
    const int letters = (int)strlen(word);
    const int allowed = bat_min_int(letters - 1, bat_max_int(1, letters / 3));
    const int distance = bat_edit_distance(word, a, bat_min_int(*best, allowed + 1));
    if (distance > allowed || distance >= *best)
        return false;
    *best = distance;
    return true;
}
