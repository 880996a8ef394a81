/* Numbers as bytes, in either order, on any machine. */
#ifndef BAT_BYTES_H
#define BAT_BYTES_H
#include "base/base.h"
#include <batten/text.h>
#include <stdint.h>
#include <string.h>

/* The unsigned number of `count` bytes, at most 8. */
static inline uint64_t bat_bytes_get(const char *bytes, int count, bool big)
{
    uint64_t value = 0;
    for (int k = 0; k < count; k++) {
        const unsigned char byte = (unsigned char)bytes[big ? count - 1 - k : k];
        value |= (uint64_t)byte << (8 * k);
    }
    return value;
}

static inline uint32_t bat_bytes_u32(const char *bytes)
{
    return (uint32_t)bat_bytes_get(bytes, 4, false);
}

static inline double bat_bytes_float(const char *bytes, bool big)
{
    const uint32_t bits = (uint32_t)bat_bytes_get(bytes, 4, big);
    float value;
    memcpy(&value, &bits, sizeof value);
    return (double)value;
}

static inline double bat_bytes_double(const char *bytes, bool big)
{
    const uint64_t bits = bat_bytes_get(bytes, 8, big);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* ---- writing; the low byte first ---- */

static inline void bat_bytes_put(batten_text *text, uint64_t value, int count)
{
    char bytes[8];
    for (int k = 0; k < count; k++)
        bytes[k] = (char)(unsigned char)(value >> (8 * k) & 0xff);
    batten_text_bytes(text, bytes, (size_t)count);
}

static inline void bat_bytes_put_float(batten_text *text, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    bat_bytes_put(text, bits, 4);
}

static inline void bat_bytes_put_double(batten_text *text, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    bat_bytes_put(text, bits, 8);
}

#endif
