/*
 * Arithmetic on whole numbers of any size, by the schoolbook methods. Numbers live in pools and
 * are freed together. Source: [Knuth97] 4.3.1 for division.
 */
#include "numeric/whole.h"

#include <string.h>

/* ---- pools ---- */

struct bat_whole_block {
    bat_whole_block *next;
    size_t size;
    max_align_t bytes[];
};

enum { BLOCK = 1 << 14, ALIGN = sizeof(max_align_t) };

void bat_wholes_empty(bat_wholes *pool)
{
    pool->last = pool->first;
    pool->used = 0;
}

void bat_wholes_release(bat_wholes *pool)
{
    for (bat_whole_block *block = pool->first; block;) {
        bat_whole_block *next = block->next;
        bat_release(block);
        block = next;
    }
    pool->first = pool->last = NULL;
    pool->used = 0;
}

static bat_whole_block *new_block(bat_wholes *pool, size_t bytes)
{
    const size_t size = bytes > BLOCK ? bytes : BLOCK;
    bat_whole_block *block = bat_array(1, sizeof *block + size);
    if (!block) {
        pool->effort->status = BATTEN_OUT_OF_MEMORY;
        return NULL;
    }
    block->size = size;
    block->next = pool->last ? pool->last->next : pool->first;
    if (pool->last)
        pool->last->next = block;
    else
        pool->first = block;
    return block;
}

static bool go_to_next_block(bat_wholes *pool, size_t bytes)
{
    bat_whole_block *next = pool->last ? pool->last->next : pool->first;
    if (!next || next->size < bytes)
        next = new_block(pool, bytes);
    if (!next)
        return false;
    pool->last = next;
    pool->used = 0;
    return true;
}

void *bat_wholes_take(bat_wholes *pool, size_t count, size_t size)
{
    if (pool->effort->status != BATTEN_OK)
        return NULL;
    assert(count < SIZE_MAX / 4 / size);
    const size_t bytes = (count * size + ALIGN - 1) / ALIGN * ALIGN;
    const bool fits = pool->last && pool->used + bytes <= pool->last->size;
    if (!fits && !go_to_next_block(pool, bytes))
        return NULL;
    void *taken = (char *)pool->last->bytes + pool->used;
    pool->used += bytes;
    return memset(taken, 0, bytes);
}

/* ---- making ---- */

static const bat_whole zero = {0, 0, NULL};

static uint32_t *limbs(bat_wholes *pool, int count)
{
    return bat_wholes_take(pool, (size_t)bat_max_int(count, 1), sizeof(uint32_t));
}

/* The number of these limbs, of which the highest may be 0. */
static bat_whole trimmed(int sign, int count, const uint32_t *limb)
{
    while (count > 0 && limb[count - 1] == 0)
        count--;
    return count ? (bat_whole){sign, count, limb} : zero;
}

bat_whole bat_whole_of_int(bat_wholes *pool, int64_t value)
{
    const uint64_t size = value < 0 ? 0 - (uint64_t)value : (uint64_t)value;
    uint32_t *limb = limbs(pool, 2);
    if (!limb)
        return zero;
    limb[0] = (uint32_t)size;
    limb[1] = (uint32_t)(size >> 32);
    return trimmed(value < 0 ? -1 : 1, 2, limb);
}

bat_whole bat_whole_of_double(bat_wholes *pool, double value, int shift)
{
    int exponent;
    const double part = frexp(value, &exponent);
    int64_t mantissa = (int64_t)(part * 0x1p53);
    exponent += shift - 53;
    for (; exponent < 0 && mantissa != 0; exponent++)
        mantissa /= 2;
    return bat_whole_shift(pool, bat_whole_of_int(pool, mantissa), bat_max_int(exponent, 0));
}

bat_whole bat_whole_copy(bat_wholes *pool, bat_whole a)
{
    uint32_t *limb = limbs(pool, a.count);
    if (!limb || a.sign == 0)
        return zero;
    memcpy(limb, a.limb, (size_t)a.count * sizeof *limb);
    return (bat_whole){a.sign, a.count, limb};
}

/* ---- sums ---- */

static int compare_sizes(bat_whole a, bat_whole b)
{
    if (a.count != b.count)
        return a.count < b.count ? -1 : 1;
    for (int i = a.count - 1; i >= 0; i--)
        if (a.limb[i] != b.limb[i])
            return a.limb[i] < b.limb[i] ? -1 : 1;
    return 0;
}

static int bits_of(uint32_t limb)
{
    int bits = 0;
    for (; limb; limb >>= 1)
        bits++;
    return bits;
}

int bat_whole_bits(bat_whole a)
{
    return a.count ? 32 * (a.count - 1) + bits_of(a.limb[a.count - 1]) : 0;
}

/* What one call costs besides, in products of limbs. */
enum { CALL = 24 };

/* May so many products of limbs still be made? */
static bool spend(bat_wholes *pool, int rows, int columns)
{
    bat_effort *effort = pool->effort;
    const uint64_t steps = CALL + (uint64_t)rows * (uint64_t)columns;
    if (effort->status == BATTEN_OK && steps > effort->steps)
        effort->status = BATTEN_INCOMPLETE;
    if (effort->status != BATTEN_OK)
        return false;
    effort->steps -= steps;
    return true;
}

/* |a| + |b| for a.count >= b.count */
static bat_whole sum_of_sizes(bat_wholes *pool, int sign, bat_whole a, bat_whole b)
{
    uint32_t *limb = spend(pool, a.count, 1) ? limbs(pool, a.count + 1) : NULL;
    uint64_t carry = 0;
    if (!limb)
        return zero;
    for (int i = 0; i < a.count; i++) {
        carry += (uint64_t)a.limb[i] + (i < b.count ? b.limb[i] : 0);
        limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    limb[a.count] = (uint32_t)carry;
    return trimmed(sign, a.count + 1, limb);
}

/* |a| - |b| for |a| >= |b| */
static bat_whole difference_of_sizes(bat_wholes *pool, int sign, bat_whole a, bat_whole b)
{
    uint32_t *limb = spend(pool, a.count, 1) ? limbs(pool, a.count) : NULL;
    uint64_t borrow = 0;
    if (!limb)
        return zero;
    for (int i = 0; i < a.count; i++) {
        const uint64_t less = (uint64_t)(i < b.count ? b.limb[i] : 0) + borrow;
        borrow = a.limb[i] < less;
        limb[i] = (uint32_t)(a.limb[i] - less);
    }
    return trimmed(sign, a.count, limb);
}

bat_whole bat_whole_add(bat_wholes *pool, bat_whole a, bat_whole b)
{
    if (a.sign == 0 || b.sign == 0)
        return a.sign ? a : b;
    const bool swap = compare_sizes(a, b) < 0;
    const bat_whole big = swap ? b : a, small = swap ? a : b;
    return a.sign == b.sign ? sum_of_sizes(pool, a.sign, big, small)
                            : difference_of_sizes(pool, big.sign, big, small);
}

bat_whole bat_whole_subtract(bat_wholes *pool, bat_whole a, bat_whole b)
{
    return bat_whole_add(pool, a, bat_whole_negated(b));
}

bat_whole bat_whole_shift(bat_wholes *pool, bat_whole a, int bits)
{
    const int whole = bits / 32, part = bits % 32;
    if (a.sign == 0 || bits == 0)
        return a;
    uint32_t *limb = limbs(pool, a.count + whole + 1);
    if (!limb)
        return zero;
    for (int i = 0; i < a.count; i++) {
        const uint64_t moved = (uint64_t)a.limb[i] << part;
        limb[i + whole] |= (uint32_t)moved;
        limb[i + whole + 1] = (uint32_t)(moved >> 32);
    }
    return trimmed(a.sign, a.count + whole + 1, limb);
}

/* ---- products ---- */

bat_whole bat_whole_multiply(bat_wholes *pool, bat_whole a, bat_whole b)
{
    if (a.sign == 0 || b.sign == 0 || !spend(pool, a.count, b.count))
        return zero;
    uint32_t *limb = limbs(pool, a.count + b.count);
    if (!limb)
        return zero;
    for (int i = 0; i < a.count; i++) {
        uint64_t carry = 0;
        for (int j = 0; j < b.count; j++) {
            carry += (uint64_t)a.limb[i] * b.limb[j] + limb[i + j];
            limb[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        limb[i + b.count] = (uint32_t)carry;
    }
    return trimmed(a.sign * b.sign, a.count + b.count, limb);
}

bat_whole bat_whole_times(bat_wholes *pool, bat_whole a, int64_t factor)
{
    return bat_whole_multiply(pool, a, bat_whole_of_int(pool, factor));
}

/* ---- quotients ---- */

static uint32_t divide_by_limb(const bat_whole a, uint32_t b, uint32_t *quotient)
{
    uint64_t rest = 0;
    for (int i = a.count - 1; i >= 0; i--) {
        rest = rest << 32 | a.limb[i];
        if (quotient)
            quotient[i] = (uint32_t)(rest / b);
        rest %= b;
    }
    return (uint32_t)rest;
}

/* One digit of Knuth's D: u[0 .. n] loses q v[0 .. n - 1], with the largest q that fits. */
static uint32_t take_digit(uint32_t *u, const uint32_t *v, int n)
{
    const uint64_t top = (uint64_t)u[n] << 32 | u[n - 1];
    uint64_t q = top / v[n - 1], rest = top % v[n - 1];
    while (q >> 32 || q * v[n - 2] > (rest << 32 | u[n - 2])) {
        q--;
        rest += v[n - 1];
        if (rest >> 32)
            break;
    }
    uint64_t carry = 0, borrow = 0;
    for (int i = 0; i <= n; i++) {
        carry += i < n ? q * v[i] : 0;
        const uint64_t less = (uint64_t)(uint32_t)carry + borrow;
        borrow = u[i] < less;
        u[i] = (uint32_t)(u[i] - less);
        carry >>= 32;
    }
    if (!borrow)
        return (uint32_t)q;
    carry = 0; /* one too many, which is rare */
    for (int i = 0; i <= n; i++) {
        carry += (uint64_t)u[i] + (i < n ? v[i] : 0);
        u[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return (uint32_t)(q - 1);
}

/* |a| by |b|, both shifted so that the highest bit of b is set; |a| >= |b|, b of two limbs at
 * least. */
static bat_whole divide_long(bat_wholes *pool, bat_whole a, bat_whole b, bat_whole *rest)
{
    const int n = b.count, m = a.count - n, shift = 32 - bits_of(b.limb[n - 1]);
    const bat_whole v = bat_whole_shift(pool, b, shift),
                    moved = bat_whole_shift(pool, a, shift);
    uint32_t *u = limbs(pool, a.count + 1), *q = limbs(pool, m + 1), *r = limbs(pool, n);
    if (!u || !q || !r || !spend(pool, m + 1, n))
        return zero;
    memcpy(u, moved.limb, (size_t)moved.count * sizeof *u);
    for (int j = m; j >= 0; j--)
        q[j] = take_digit(u + j, v.limb, n);
    for (int i = 0; i < n; i++)
        r[i] = shift ? u[i] >> shift | (uint32_t)((uint64_t)u[i + 1] << (32 - shift)) : u[i];
    *rest = trimmed(a.sign, n, r);
    return trimmed(a.sign * b.sign, m + 1, q);
}

bat_whole bat_whole_divide(bat_wholes *pool, bat_whole a, bat_whole b, bat_whole *rest)
{
    bat_whole ignored, *const r = rest ? rest : &ignored;
    *r = zero;
    if (pool->effort->status != BATTEN_OK)
        return zero;
    assert(b.sign != 0);
    if (compare_sizes(a, b) < 0) {
        *r = a;
        return zero;
    }
    if (b.count > 1)
        return divide_long(pool, a, b, r);
    uint32_t *q = limbs(pool, a.count), *one = limbs(pool, 1);
    if (!q || !one || !spend(pool, a.count, 1))
        return zero;
    one[0] = divide_by_limb(a, b.limb[0], q);
    *r = trimmed(a.sign, 1, one);
    return trimmed(a.sign * b.sign, a.count, q);
}

bat_whole bat_whole_gcd(bat_wholes *pool, bat_whole a, bat_whole b)
{
    while (b.sign != 0) {
        bat_whole rest;
        bat_whole_divide(pool, a, b, &rest);
        a = b;
        b = rest;
    }
    return a.sign < 0 ? bat_whole_negated(a) : a;
}

uint32_t bat_whole_modulo(bat_whole a, uint32_t p)
{
    const uint32_t rest = divide_by_limb(a, p, NULL);
    return a.sign < 0 && rest ? p - rest : rest;
}

/* ---- back to doubles ---- */

double bat_whole_frexp(bat_whole a, int *exponent)
{
    uint64_t top = 0;
    const int bits = bat_whole_bits(a);
    *exponent = bits;
    for (int i = bits - 1; i >= bat_max_int(bits - 53, 0); i--)
        top = top << 1 | (a.limb[i / 32] >> (i % 32) & 1);
    return a.sign * ldexp((double)top, -bat_min_int(bits, 53));
}

double bat_whole_ratio(bat_whole a, bat_whole b)
{
    int above, below;
    const double x = bat_whole_frexp(a, &above), y = bat_whole_frexp(b, &below);
    return ldexp(x / y, above - below);
}
