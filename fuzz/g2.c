/* Reads bytes as .g2 and checks that what is written reads back. */
#include "promise.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_promise(data, size, BATTEN_FORMAT_G2, BATTEN_FORMAT_G2);
    return 0;
}
