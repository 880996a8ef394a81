/* Reads bytes as DXF and checks that what is written reads back. */
#include "promise.h"

/* Arcs come back cut at other places, so that only the reading is held to its promise. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_promise(data, size, BATTEN_FORMAT_DXF, BATTEN_FORMAT_G2);
    fuzz_reads_back(data, size, BATTEN_FORMAT_DXF);
    return 0;
}
