/* What holds of the reader over the corpus. */
#include "exchange/corpus.h"

static const char *const iges[] = {
    "iges/arcs.igs",      "iges/composite.igs", "iges/conics.igs", "iges/copious.igs",
    "iges/splines.igs",   "iges/ruled.igs",     "iges/turned.igs", "iges/offsets.igs",
    "iges/instances.igs", "iges/trimmed.igs"};

TEST(N1_a_number_that_is_none_is_never_lost_quietly)
{
    const corpus c = corpus_named(BATTEN_FORMAT_IGES, iges, COUNT(iges));
    check_no_number_is_lost(&c);
}

TEST(reading_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_IGES, iges, COUNT(iges));
    check_reading_without_memory(&c, 300);
}

TEST(writing_what_is_read_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_IGES, iges, COUNT(iges));
    check_writing_without_memory(&c, BATTEN_FORMAT_IGES, 200);
}
