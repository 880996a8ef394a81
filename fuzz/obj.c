/* Reads bytes as OBJ and checks that what is written reads back. */
#include "promise.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_promise(data, size, BATTEN_FORMAT_OBJ, BATTEN_FORMAT_OBJ);
    return 0;
}
