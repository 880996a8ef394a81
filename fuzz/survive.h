/* What a damaged file must not do to what comes after reading. */
#ifndef FUZZ_SURVIVE_H
#define FUZZ_SURVIVE_H
#include <batten/exchange.h>
#include <stddef.h>
#include <stdint.h>

/* Read the bytes as a format; when a model comes of it, write it as STEP and as IGES, mesh it
 * and check its bodies, each within a small budget. Only that it ends is asked. */
void fuzz_survive(const uint8_t *data, size_t size, batten_format format);

#endif
