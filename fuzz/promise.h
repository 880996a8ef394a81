/* What every target promises of a reader: it refuses, or what it read is written and reads
 * back. */
#ifndef FUZZ_PROMISE_H
#define FUZZ_PROMISE_H
#include <batten/exchange.h>
#include <stddef.h>
#include <stdint.h>

/* Read the bytes as a format. When a model comes of it: write it as `written`, read that, and
 * write again; both texts must be the same, and the two models bit for bit. Limits keep one
 * input short. */
void fuzz_promise(const uint8_t *data, size_t size, batten_format read, batten_format written);

/* Read the bytes as a format; what is written of them in that format must read whole. */
void fuzz_reads_back(const uint8_t *data, size_t size, batten_format format);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#endif
