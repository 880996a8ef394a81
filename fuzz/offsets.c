/* Reads bytes as a table of offsets and checks that what is written reads back. */
#include "promise.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_promise(data, size, BATTEN_FORMAT_OFFSET_TABLE, BATTEN_FORMAT_OFFSET_TABLE);
    return 0;
}
