#include "promise.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_promise(data, size, BATTEN_FORMAT_OFFSETS, BATTEN_FORMAT_OFFSETS);
    return 0;
}
