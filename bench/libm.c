/* The elementary functions of the C library. */
#include "bench.h"

#include <math.h>

static const bench_function table[FUNCTION_COUNT] = {
    [SIN].one = sin,   [COS].one = cos,   [TAN].one = tan,     [ASIN].one = asin,
    [ACOS].one = acos, [ATAN].one = atan, [EXP].one = exp,     [EXPM1].one = expm1,
    [LOG].one = log,   [LOG2].one = log2, [LOG10].one = log10, [COSH].one = cosh,
    [SINH].one = sinh, [CBRT].one = cbrt, [ATAN2].two = atan2, [HYPOT].two = hypot,
    [POW].two = pow,
};

static void *open_function(const bench_work *work)
{
    return bench_open_function(work, table);
}

const bench_entry bench_libm[] = {
    {"libm", ELEMENTARY, open_function, bench_run_function, bench_gather_function,
     bench_close_function, NULL},
    {.way = NULL},
};
