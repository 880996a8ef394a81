/* What holds of the readers of tables over the corpus. */
#include "exchange/corpus.h"

static const char *const offsets[] = {"offsets/long.csv", "offsets/matrix.csv",
                                      "offsets/loft.csv"};

TEST(N1_a_number_that_is_none_of_offsets_is_never_lost_quietly)
{
    const corpus c = corpus_named(BATTEN_FORMAT_OFFSET_TABLE, offsets, COUNT(offsets));
    check_no_number_is_lost(&c);
}

TEST(reading_of_offsets_says_that_memory_is_missing)
{
    const corpus c = corpus_of(BATTEN_FORMAT_OFFSET_TABLE, "offsets", "");
    check_reading_without_memory(&c, 200);
}

TEST(writing_what_is_read_of_offsets_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_OFFSET_TABLE, offsets, COUNT(offsets));
    check_writing_without_memory(&c, BATTEN_FORMAT_OFFSET_TABLE, 200);
}

static const char *const aerofoil[] = {"aerofoil/selig.dat", "aerofoil/lednicer.dat"};

TEST(N1_a_number_that_is_none_of_aerofoil_is_never_lost_quietly)
{
    const corpus c = corpus_named(BATTEN_FORMAT_AEROFOIL, aerofoil, COUNT(aerofoil));
    check_no_number_is_lost(&c);
}

TEST(reading_of_aerofoil_says_that_memory_is_missing)
{
    const corpus c = corpus_of(BATTEN_FORMAT_AEROFOIL, "aerofoil", "");
    check_reading_without_memory(&c, 200);
}

TEST(writing_what_is_read_of_aerofoil_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_AEROFOIL, aerofoil, COUNT(aerofoil));
    check_writing_without_memory(&c, BATTEN_FORMAT_AEROFOIL, 200);
}

static const char *const points[] = {"points/plain.xyz"};

TEST(N1_a_number_that_is_none_of_points_is_never_lost_quietly)
{
    const corpus c = corpus_named(BATTEN_FORMAT_POINTS, points, COUNT(points));
    check_no_number_is_lost(&c);
}

TEST(reading_of_points_says_that_memory_is_missing)
{
    const corpus c = corpus_of(BATTEN_FORMAT_POINTS, "points", "");
    check_reading_without_memory(&c, 200);
}

TEST(writing_what_is_read_of_points_says_that_memory_is_missing)
{
    const corpus c = corpus_named(BATTEN_FORMAT_POINTS, points, COUNT(points));
    check_writing_without_memory(&c, BATTEN_FORMAT_POINTS, 200);
}
