/* What holds of the reader over the corpus. */
#include "exchange/corpus.h"

static const char *const stl[] = {"stl/text.stl"};

TEST(N1_a_number_that_is_none_is_never_lost_quietly)
{
    const corpus c = corpus_named(BATTEN_FORMAT_STL, stl, COUNT(stl));
    check_no_number_is_lost(&c);
}

TEST(reading_says_that_memory_is_missing)
{
    const corpus c = corpus_of(BATTEN_FORMAT_STL, "stl", "");
    check_reading_without_memory(&c, 200);
}

TEST(writing_what_is_read_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_STL, stl, COUNT(stl));
    check_writing_without_memory(&c, BATTEN_FORMAT_STL, 200);
}
