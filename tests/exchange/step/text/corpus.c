/* What holds of the text of STEP over the corpus. */
#include "exchange/corpus.h"

static const char *const files[] = {"step/assembly", "step/curve-spline_curve",
                                    "step/tessellated", "step/mapped"};

TEST(N1_a_number_that_is_none_is_lost_nowhere_in_the_text)
{
    const corpus c = corpus_named(BATTEN_FORMAT_STEP, files, COUNT(files));
    check_no_number_is_lost(&c);
}

TEST(taking_the_text_apart_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_STEP, files, COUNT(files));
    check_reading_without_memory(&c, 150);
}
