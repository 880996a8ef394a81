/* What holds of the text of IGES over the corpus. */
#include "exchange/corpus.h"

static const char *const files[] = {"iges/arcs.igs", "iges/splines.igs", "iges/instances.igs",
                                    "iges/trimmed.igs", "iges/copious.igs"};

TEST(N1_a_number_that_is_none_is_lost_nowhere_in_the_text)
{
    const corpus c = corpus_named(BATTEN_FORMAT_IGES, files, COUNT(files));
    check_no_number_is_lost(&c);
}

TEST(taking_the_text_apart_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_IGES, files, COUNT(files));
    check_reading_without_memory(&c, 150);
}
