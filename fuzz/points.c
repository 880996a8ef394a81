/* Reads bytes as points and checks that what is written reads back. */
#include "promise.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_promise(data, size, BATTEN_FORMAT_POINTS, BATTEN_FORMAT_POINTS);
    return 0;
}
