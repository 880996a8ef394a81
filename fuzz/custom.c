/* What libFuzzer changes, it changes by our mutator. FUZZ_NAME is the name of the target. */
#include "mutate.h"

#include <string.h>

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);
size_t LLVMFuzzerCustomCrossOver(const uint8_t *one, size_t one_size, const uint8_t *other,
                                 size_t other_size, uint8_t *out, size_t most, unsigned seed);

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    return fuzz_mutate(fuzz_grammar_of(FUZZ_NAME), data, size, most, seed, NULL, 0,
                       LLVMFuzzerMutate);
}

size_t LLVMFuzzerCustomCrossOver(const uint8_t *one, size_t one_size, const uint8_t *other,
                                 size_t other_size, uint8_t *out, size_t most, unsigned seed)
{
    const size_t size = one_size < most ? one_size : most;
    memcpy(out, one, size);
    return fuzz_mutate(fuzz_grammar_of(FUZZ_NAME), out, size, most, seed, other, other_size,
                       NULL);
}
