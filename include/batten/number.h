#ifndef BATTEN_NUMBER_H
#define BATTEN_NUMBER_H
/**
 * @file
 * Numbers as text, the same in every locale: '.' is the decimal mark.
 */
#include <batten/base.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Large enough for any number batten_number_write writes, with its final zero. */
#define BATTEN_NUMBER_SIZE 32

/**
 * Write a finite number with the fewest digits that read back to the same bits; of several
 * the nearest. From 1e-5 to below 1e17 it has no exponent.
 *
 * @param value  finite; NaN and infinities are written as "nan", "inf", "-inf"
 * @param[out] text  [BATTEN_NUMBER_SIZE], ends with a zero byte
 * @return the length without the zero: "0.1", "-2.5e-7", "1e22", "-0"
 */
BATTEN_API int batten_number_write(double value, char *text);

/**
 * Read a decimal number, correctly rounded (ties to even).
 *
 * Accepted: an optional sign, digits with an optional '.', at least one digit, an optional
 * exponent `e` or `E`. No blanks, no hexadecimal, no "nan" or "inf".
 *
 * @param text    the characters; need not end with a zero
 * @param length  how many there are
 * @param[out] value  the number; a number too small for a double becomes 0 or denormal
 * @param[out] used   how many characters belong to it; may be NULL, and then all must
 * @return BATTEN_OK; BATTEN_BAD_FORMAT when no number stands there; BATTEN_OVERFLOW when it is
 *         too large for a double
 */
BATTEN_API batten_status batten_number_read(const char *text, size_t length, double *value,
                                            size_t *used);

/**
 * Read a whole number in decimal digits with an optional sign: no '.', no exponent, no blanks.
 *
 * @param low, high  what is allowed
 * @param[out] used  how many characters belong to it; may be NULL, and then all must
 * @return BATTEN_OK; BATTEN_BAD_FORMAT when no whole number stands there; BATTEN_OVERFLOW when
 * it is outside low .. high
 */
BATTEN_API batten_status batten_integer_read(const char *text, size_t length, int64_t low,
                                             int64_t high, int64_t *value, size_t *used);

#ifdef __cplusplus
}
#endif
#endif
