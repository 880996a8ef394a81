/*
 * The elementary functions, made of sums, products, quotients and square roots of doubles alone, so that they have the
 * same bits on every machine. Those of C libraries differ from library to library, and glibc's from processor to
 * processor.
 *
 * Zeros, infinities, subnormal numbers and NaN follow annex F of C; errno and the exception flags mean nothing. Where
 * the true value is a double it is that one. The largest errors found, in units of the last place, beside 113 bits over
 * 100,000 arguments of each stretch that tests/base/elementary names:
 *
 *     sin cos tan 0.501    asin 0.52  acos 0.52    atan atan2 0.503    exp expm1 0.51
 *     log log2 log10 0.504    pow 0.54    sinh 0.53  cosh 0.51    cbrt 0.51    hypot 0.501
 */
#ifndef BAT_ELEMENTARY_H
#define BAT_ELEMENTARY_H
#include <batten/base.h>

/* The exported names serve the sister libraries; inside we write bat_. */
#define bat_sin batten_sin
#define bat_cos batten_cos
#define bat_sincos batten_sincos
#define bat_tan batten_tan
#define bat_asin batten_asin
#define bat_acos batten_acos
#define bat_atan batten_atan
#define bat_atan2 batten_atan2
#define bat_exp batten_exp
#define bat_expm1 batten_expm1
#define bat_log batten_log
#define bat_log2 batten_log2
#define bat_log10 batten_log10
#define bat_pow batten_pow
#define bat_hypot batten_hypot
#define bat_cbrt batten_cbrt
#define bat_cosh batten_cosh
#define bat_sinh batten_sinh

/* The result depends on the arguments alone: the compiler may leave out calls. */
#if defined __GNUC__
#define BAT_PURE __attribute__((const))
#else
#define BAT_PURE
#endif

/* Angles are in radians; those of any size are reduced with all bits of pi that they ask for. */
BATTEN_API BAT_PURE double bat_sin(double x);
BATTEN_API BAT_PURE double bat_cos(double x);
BATTEN_API BAT_PURE double bat_tan(double x);

/* Both for little more than the cost of one; the bits are those of bat_sin and bat_cos. */
BATTEN_API void bat_sincos(double x, double *sine, double *cosine);

BATTEN_API BAT_PURE double bat_asin(double x);
BATTEN_API BAT_PURE double bat_acos(double x);
BATTEN_API BAT_PURE double bat_atan(double x);
BATTEN_API BAT_PURE double bat_atan2(double y, double x);

BATTEN_API BAT_PURE double bat_exp(double x);
BATTEN_API BAT_PURE double bat_expm1(double x); /* e^x - 1 */
BATTEN_API BAT_PURE double bat_log(double x);
BATTEN_API BAT_PURE double bat_log2(double x);
BATTEN_API BAT_PURE double bat_log10(double x);
BATTEN_API BAT_PURE double bat_pow(double x, double y);

BATTEN_API BAT_PURE double bat_cosh(double x);
BATTEN_API BAT_PURE double bat_sinh(double x);

/* sqrt(x^2 + y^2) without overflow on the way. */
BATTEN_API BAT_PURE double bat_hypot(double x, double y);
BATTEN_API BAT_PURE double bat_cbrt(double x);

#endif
