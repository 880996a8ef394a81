/* Files, by each who takes part. */
#ifndef BENCH_EXCHANGE_H
#define BENCH_EXCHANGE_H
#include "bench.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const bench_entry bench_batten_write, bench_batten_read, bench_occt_write,
    bench_occt_read;

#ifdef __cplusplus
}
#endif
#endif
