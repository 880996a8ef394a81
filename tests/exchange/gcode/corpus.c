/* What holds of the writer over the corpora of the readers. */
#include "exchange/corpus.h"

TEST(writing_what_is_in_dxf_files_says_that_memory_is_missing)
{
    static const char *const files[] = {"dxf/simple.dxf", "dxf/poly.dxf"};
    const corpus c = corpus_named(BATTEN_FORMAT_DXF, files, COUNT(files));
    check_writing_without_memory(&c, BATTEN_FORMAT_GCODE, 200);
}
