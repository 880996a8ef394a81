/*
 * One line for each elementary function: a checksum of its values for 20,000 arguments. It needs neither the rest of
 * Batten nor a system, so it runs where nothing else does: tests/bits/functions.txt is what every machine prints.
 */
#include "base/elementary.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { ARGUMENTS = 20000 };

/* Marsaglia's generator of 64 bits. */
static uint64_t next_bits(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

static double of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Three of four below 2 in size, of every exponent down to 2^-30; the others any double. */
static double next_argument(uint64_t *state)
{
    const uint64_t bits = next_bits(state);
    if (bits & 3)
        return of_bits((bits & 0x800fffffffffffff) | (1023 - (bits >> 52) % 31) << 52);
    return of_bits(next_bits(state));
}

static uint64_t add_number(uint64_t sum, double x)
{
    uint64_t bits = 0;
    /* The sign and the payload of NaN are nobody's promise. */
    if (!isnan(x))
        memcpy(&bits, &x, sizeof bits);
    for (int i = 0; i < 64; i += 8)
        sum = (sum ^ (bits >> i & 255)) * 0x100000001b3;
    return sum;
}

#define ONE(name)                                                     \
    do {                                                              \
        uint64_t state = 88172645463325252, sum = 0xcbf29ce484222325; \
        for (int i = 0; i < ARGUMENTS; i++)                           \
            sum = add_number(sum, bat_##name(next_argument(&state))); \
        printf("%s %016llx\n", #name, (unsigned long long)sum);       \
    } while (0)

#define TWO(name)                                                        \
    do {                                                                 \
        uint64_t state = 88172645463325252, sum = 0xcbf29ce484222325;    \
        for (int i = 0; i < ARGUMENTS; i++) {                            \
            const double x = next_argument(&state);                      \
            sum = add_number(sum, bat_##name(x, next_argument(&state))); \
        }                                                                \
        printf("%s %016llx\n", #name, (unsigned long long)sum);          \
    } while (0)

int main(void)
{
    ONE(sin);
    ONE(cos);
    ONE(tan);
    ONE(asin);
    ONE(acos);
    ONE(atan);
    ONE(exp);
    ONE(expm1);
    ONE(log);
    ONE(log2);
    ONE(log10);
    ONE(cosh);
    ONE(sinh);
    ONE(cbrt);
    TWO(atan2);
    TWO(pow);
    TWO(hypot);
    return 0;
}
