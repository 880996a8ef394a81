#ifndef BATTEN_TEXT_H
#define BATTEN_TEXT_H
/**
 * @file
 * Text: growing buffers, numbers and units as text, whole files.
 *
 * A text that could not grow stays `failed`, and batten_text_take reports it: so a writer
 * checks once, at its end.
 */
#include <batten/base.h>

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
 *
 * Cost: linear in length; 19 digits and less take one multiplication, more take whole-number
 * arithmetic of some hundred words.
 */
BATTEN_API batten_status batten_number_read(const char *text, size_t length, double *value,
                                            size_t *used);

/**
 * Read a whole number in decimal digits with an optional sign: no '.', no exponent, no blanks.
 *
 * @param text  the characters; need not end with a zero
 * @param length  how many there are
 * @param low, high  what is allowed
 * @param[out] value  the number
 * @param[out] used  how many characters belong to it; may be NULL, and then all must
 * @return BATTEN_OK; BATTEN_BAD_FORMAT when no whole number stands there; BATTEN_OVERFLOW when
 * it is outside low .. high
 *
 * Cost: linear in length.
 */
BATTEN_API batten_status batten_integer_read(const char *text, size_t length, int64_t low,
                                             int64_t high, int64_t *value, size_t *used);
/** Begin with BATTEN_TEXT. */
typedef struct batten_text {
    char *bytes; /**< ends with a zero byte; NULL while empty */
    size_t length, capacity;
    bool failed;
} batten_text;

#ifdef __cplusplus
#define BATTEN_TEXT          \
    batten_text              \
    {                        \
        nullptr, 0, 0, false \
    }
#else
#define BATTEN_TEXT ((batten_text){NULL, 0, 0, false})
#endif

/**
 * Append as printf does, in the C locale; for doubles use batten_text_number.
 *
 * @param text  appended to
 * @param format  as printf
 */
BATTEN_API void batten_text_add(batten_text *text, const char *format, ...) BATTEN_PRINTF(2, 3);
/**
 * snprintf in the C locale, whatever the locale of the process: a decimal point is a point.
 *
 * @param buffer  gets at most `size` bytes, the zero at the end among them
 * @param size  of the buffer
 * @param format  as printf
 * @return how many bytes the whole has; negative where the format has no meaning
 *
 * Cost: linear in the bytes.
 */
BATTEN_API int batten_text_print(char *buffer, size_t size, const char *format, ...)
    BATTEN_PRINTF(3, 4);
/**
 * Append `length` bytes as they are.
 *
 * @param text  appended to
 * @param bytes  `length` of them
 */
BATTEN_API void batten_text_bytes(batten_text *text, const char *bytes, size_t length);
/**
 * Append the fewest digits that read back to the same bits.
 *
 * @param text  appended to
 * @param value  finite or not: "nan", "inf"
 */
BATTEN_API void batten_text_number(batten_text *text, double value);
/**
 * Append a JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
 *
 * @param text  appended to
 * @param value  UTF-8, up to its zero byte
 */
BATTEN_API void batten_text_json(batten_text *text, const char *value);
/**
 * Hand the bytes over (release with batten_release) and start anew.
 *
 * @param text  any text; empty afterwards
 * @param[out] bytes  with a zero byte after the last
 * @param[out] length  bytes; may be NULL
 * @return BATTEN_OK, OUT_OF_MEMORY
 *
 * Cost: constant; the bytes are not copied.
 */
BATTEN_API batten_status batten_text_take(batten_text *text, char **bytes, size_t *length);
/** Release a text that is not taken. */
BATTEN_API void batten_text_free(batten_text *text);
/** @param name "m", "mm", "cm", "km", "um", "in", "ft", "yd", "mil", "mi", "uin", "dm", "dam",
 * "hm", "nm", "angstrom" and their long names in lower case, singular or plural: "metre",
 * "meters", "foot", "feet"; "usft", the US survey foot
 * @return metres in one of them, or 0 when the name is unknown */
BATTEN_API double batten_unit_metres(const char *name);

/**
 * The short name of a unit, to 4 units of the last place, or NULL when there is none.
 *
 * @param metres  of one of the unit
 */
BATTEN_API const char *batten_unit_name(double metres);
/**
 * A whole file in memory, with a zero byte after its end. Release with batten_release.
 *
 * @param path  a file, a device, or a pipe that somebody writes into, for which it does not
 *              wait
 * @param limit  bytes allowed
 * @param[out] data  with a zero byte after the last; release with batten_release
 * @param[out] size  bytes, without that zero
 * @return BATTEN_OK; FILE_ERROR with the system's reason, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the bytes, which are in memory once.
 */
BATTEN_API batten_status batten_load_file(const char *path, size_t limit, char **data,
                                          size_t *size);

/**
 * Put bytes into a file so that, whatever happens, either the old file or the new one is there,
 * whole: written beside it, synchronised, renamed. A symlink's target is replaced, the mode is
 * kept, a read-only file is refused. A pipe or device is written straight. What savings of the
 * same file left beside it when their process was killed is removed.
 *
 * SIGINT, SIGTERM and SIGHUP wait in the calling thread while the file beside exists. One that
 * arrives before the renaming ends the call with BATTEN_CANCELLED, the old file untouched; then
 * the signal takes its course. So a programme need not clean up after its own end.
 *
 * @param path  of the file, UTF-8
 * @param[out] data  the bytes
 * @param[out] size  how many there are
 * @return BATTEN_OK; FILE_ERROR naming the path and the system's reason; then no stray file
 * remains. When only the directory could not be synchronised, the message says that the file
 * was saved but may not survive a power loss. CANCELLED, as above; OUT_OF_MEMORY
 *
 * Cost: linear in the bytes, and two synchronisations with the disk.
 */
BATTEN_API batten_status batten_save_file(const char *path, const char *data, size_t size);

#ifdef __cplusplus
}
#endif
#endif
