/* Elementary functions: Batten's and those of the C library, by pointers and one call a value. */
#include "base/elementary.h"

#include "bench.h"

#include <stdlib.h>

typedef struct {
    const bench_work *work;
    bench_function function;
    double *out;
} contest;

void *bench_open_function(const bench_work *work, const bench_function *table)
{
    contest *c = calloc(1, sizeof *c);
    if (!c)
        exit(1);
    c->work = work;
    c->function = table[work->function];
    c->out = bench_numbers(work->count);
    return c;
}

void bench_run_function(void *object)
{
    const contest *c = object;
    const bench_work *w = c->work;
    if (w->function < ATAN2)
        for (size_t i = 0; i < w->count; i++)
            c->out[i] = c->function.one(w->u[i]);
    else
        for (size_t i = 0; i < w->count; i++)
            c->out[i] = c->function.two(w->u[i], w->v[i]);
}

void bench_gather_function(void *object, double *result)
{
    const contest *c = object;
    for (size_t i = 0; i < c->work->count; i++)
        result[i] = c->out[i];
}

void bench_close_function(void *object)
{
    contest *c = object;
    free(c->out);
    free(c);
}

static const bench_function table[FUNCTION_COUNT] = {
    [SIN].one = bat_sin,     [COS].one = bat_cos,     [TAN].one = bat_tan,
    [ASIN].one = bat_asin,   [ACOS].one = bat_acos,   [ATAN].one = bat_atan,
    [EXP].one = bat_exp,     [EXPM1].one = bat_expm1, [LOG].one = bat_log,
    [LOG2].one = bat_log2,   [LOG10].one = bat_log10, [COSH].one = bat_cosh,
    [SINH].one = bat_sinh,   [CBRT].one = bat_cbrt,   [ATAN2].two = bat_atan2,
    [HYPOT].two = bat_hypot, [POW].two = bat_pow,
};

static void *open_function(const bench_work *work)
{
    return bench_open_function(work, table);
}

const bench_entry bench_batten_functions[] = {
    {"batten", ELEMENTARY, open_function, bench_run_function, bench_gather_function,
     bench_close_function, NULL},
    {.way = NULL},
};
