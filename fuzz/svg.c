/* Reads bytes as SVG and checks that what is written reads back. */
#include "promise.h"

/* SVG is written from its own corner: only the reading is held to its promise. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_promise(data, size, BATTEN_FORMAT_SVG, BATTEN_FORMAT_G2);
    fuzz_reads_back(data, size, BATTEN_FORMAT_SVG);
    return 0;
}
