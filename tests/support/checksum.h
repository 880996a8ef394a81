/* A checksum of bits, for "the same bits with every compiler". */
#ifndef TESTS_SUPPORT_CHECKSUM_H
#define TESTS_SUPPORT_CHECKSUM_H
#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline uint64_t test_checksum(uint64_t sum, const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        sum = (sum ^ bits) * 0x100000001b3u;
        sum ^= sum >> 29;
    }
    return sum;
}

#endif
