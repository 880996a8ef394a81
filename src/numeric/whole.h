/*
 * Whole numbers of any size, for elimination: where `exact.h` runs out of range.
 *
 * Numbers live in a pool that is emptied or released as a whole, and are never changed once
 * they are made. Pools share an effort: when memory is exhausted or the steps are used up its
 * status says so, every later result is 0, and the caller asks once at its end.
 */
#ifndef BAT_WHOLE_H
#define BAT_WHOLE_H
#include "base/base.h"
#include <stdint.h>

/* sign is -1, 0 or 1; `count` limbs of 32 bits, the lowest first, the highest not 0. */
typedef struct {
    int sign, count;
    const uint32_t *limb;
} bat_whole;

typedef struct {
    batten_status status; /* OK, OUT_OF_MEMORY or INCOMPLETE */
    uint64_t steps;       /* products of limbs that may still be made, or work like them */
} bat_effort;

typedef struct bat_whole_block bat_whole_block;
typedef struct {
    bat_effort *effort;
    bat_whole_block *first, *last; /* `last` is being filled, those behind it wait */
    size_t used;                   /* bytes of `last` */
} bat_wholes;

/* A pool begins as {effort}. */
void bat_wholes_empty(bat_wholes *pool);
void bat_wholes_release(bat_wholes *pool);
/* Zeroed memory of the pool; NULL when the effort has failed. */
void *bat_wholes_take(bat_wholes *pool, size_t count, size_t size);

bat_whole bat_whole_of_int(bat_wholes *pool, int64_t value);
/* value 2^shift, which must be whole */
bat_whole bat_whole_of_double(bat_wholes *pool, double value, int shift);
/* The same number in another pool. */
bat_whole bat_whole_copy(bat_wholes *pool, bat_whole a);

static inline bat_whole bat_whole_negated(bat_whole a)
{
    a.sign = -a.sign;
    return a;
}

/* How many bits |a| has; 0 of 0. */
int bat_whole_bits(bat_whole a);
bat_whole bat_whole_add(bat_wholes *pool, bat_whole a, bat_whole b);
bat_whole bat_whole_subtract(bat_wholes *pool, bat_whole a, bat_whole b);
bat_whole bat_whole_multiply(bat_wholes *pool, bat_whole a, bat_whole b);
bat_whole bat_whole_times(bat_wholes *pool, bat_whole a, int64_t factor);
/* a 2^bits, bits >= 0 */
bat_whole bat_whole_shift(bat_wholes *pool, bat_whole a, int bits);
/* The quotient towards 0; b is not 0 unless the effort has failed. *rest, where wanted, has the
 * sign of a. Source: [Knuth97] 4.3.1 D. */
bat_whole bat_whole_divide(bat_wholes *pool, bat_whole a, bat_whole b, bat_whole *rest);
/* The greatest common divisor, 0 or more. */
bat_whole bat_whole_gcd(bat_wholes *pool, bat_whole a, bat_whole b);
/* a modulo p, in [0, p); p below 2^31 */
uint32_t bat_whole_modulo(bat_whole a, uint32_t p);
/* a = m 2^*exponent with |m| in [1/2, 1); m is cut, not rounded. 0 of 0. */
double bat_whole_frexp(bat_whole a, int *exponent);
/* a / b as the nearest double but for two roundings. */
double bat_whole_ratio(bat_whole a, bat_whole b);

#endif
