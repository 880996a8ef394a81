/* What holds of the reader over the corpus. */
#include "exchange/corpus.h"

static const char *const step[] = {"step/assembly",
                                   "step/curve-rational_curve",
                                   "step/curve-spline_curve",
                                   "step/curve-trimmed_circle",
                                   "step/surface-rational",
                                   "step/surface-spline",
                                   "step/surface-torus",
                                   "step/surface-revolution",
                                   "step/tessellated",
                                   "step/mapped",
                                   "step/faces-with-parameters"};

TEST(N1_a_number_that_is_none_is_never_lost_quietly)
{
    const corpus c = corpus_named(BATTEN_FORMAT_STEP, step, COUNT(step));
    check_no_number_is_lost(&c);
}

TEST(reading_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_STEP, step, COUNT(step));
    check_reading_without_memory(&c, 200);
}

TEST(writing_what_is_read_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_STEP, step, COUNT(step));
    check_writing_without_memory(&c, BATTEN_FORMAT_STEP, 200);
}

TEST(P1_a_reference_to_nothing_is_never_lost_quietly)
{
    const corpus c = corpus_named(BATTEN_FORMAT_STEP, step, COUNT(step));
    check_no_reference_is_lost(&c);
}
