/* The series of textbooks in numbers of 113 bits. They are slow, and right to about 2^-105. */
#include "oracle.h"

#include <float.h>

static quad q_abs(quad x)
{
    return x < 0 ? -x : x;
}

/* x 2^n. */
static quad scaled(quad x, int n)
{
    for (; n > 1000; n -= 1000)
        x *= 0x1p1000;
    for (; n < -1000; n += 1000)
        x *= 0x1p-1000;
    return x * ldexp(1, n);
}

static quad pi(void)
{
    return (quad)0x1.921fb54442d18p1 + (quad)0x1.1a62633145c06p-53 +
           (quad)0x1.c1cd129024e09p-106;
}

static quad log_two(void)
{
    return (quad)0x1.62e42fefa39efp-1 + (quad)0x1.abc9e3b39803fp-56 +
           (quad)0x1.7b57a079a1934p-111;
}

static quad q_sqrt(quad x)
{
    if (x <= 0)
        return 0;
    /* Far from the least doubles, where the first guess has all its bits. */
    int n = 0;
    for (; x < 0x1p-400; n++)
        x *= 0x1p400;
    for (; x > 0x1p400; n--)
        x *= 0x1p-400;
    quad root = sqrt((double)x);
    for (int i = 0; i < 2; i++)
        root = (root + x / root) / 2;
    return scaled(root, -200 * n);
}

/* e^x - 1 for |x| < 0.4. */
static quad small_expm1(quad x)
{
    quad term = x, sum = x;
    for (int k = 2; k < 34; k++)
        sum += term *= x / k;
    return sum;
}

quad oracle_exp(quad x)
{
    const int k = (int)floor((double)(x / log_two()) + 0.5);
    return scaled(1 + small_expm1(x - k * log_two()), k);
}

quad oracle_expm1(quad x)
{
    return q_abs(x) < (quad)0.3 ? small_expm1(x) : oracle_exp(x) - 1;
}

quad oracle_log(quad x)
{
    int k = 0;
    if (x < DBL_MIN) {
        x *= 0x1p100;
        k = -100;
    }
    int exponent;
    frexp((double)x, &exponent);
    quad m = scaled(x, -exponent); /* in [1/2, 1) */
    if (m < (quad)0.7) {
        m *= 2;
        exponent--;
    }
    const quad z = (m - 1) / (m + 1), square = z * z;
    quad power = z, sum = 0;
    for (int n = 1; n < 50; n += 2) {
        sum += power / n;
        power *= square;
    }
    return 2 * sum + (k + exponent) * log_two();
}

quad oracle_log2(quad x)
{
    return oracle_log(x) / log_two();
}

quad oracle_log10(quad x)
{
    static quad log_ten;
    if (log_ten == 0)
        log_ten = oracle_log(10);
    return oracle_log(x) / log_ten;
}

/* sin(x), or cos(x) where `from` is 0, for |x| < 0.8. */
static quad wave_series(quad x, int from)
{
    quad term = from ? x : 1, sum = term;
    for (int k = from + 1; k < 34; k += 2)
        sum += term *= -x * x / (k * (k + 1));
    return sum;
}

/* The sine of x and so many quarters of a turn. */
static quad wave(quad x, int quarters)
{
    const double k = floor((double)(x / (pi() / 2)) + 0.5);
    /* pi/2 in parts, the first of which has exact multiples. */
    const quad rest = ((x - (quad)k * 0x1.921fb54442d18p0) - (quad)k * 0x1.1a62633145c06p-54) -
                      (quad)k * 0x1.c1cd129024e09p-107;
    const int turn = (int)fmod(fmod(k, 4) + quarters + 4, 4);
    const quad size = wave_series(rest, turn % 2 == 0);
    return turn < 2 ? size : -size;
}

quad oracle_sin(quad x)
{
    return wave(x, 0);
}

quad oracle_cos(quad x)
{
    return wave(x, 1);
}

quad oracle_tan(quad x)
{
    return wave(x, 0) / wave(x, 1);
}

quad oracle_atan(quad x)
{
    if (x < 0)
        return -oracle_atan(-x);
    if (x > 1)
        return pi() / 2 - oracle_atan(1 / x);
    int halvings = 0;
    for (; x > (quad)0.1; halvings++)
        x = x / (1 + q_sqrt(1 + x * x));
    quad power = x, sum = 0;
    for (int n = 1; n < 40; n += 2) {
        sum += power / n;
        power *= -x * x;
    }
    return scaled(sum, halvings);
}

quad oracle_atan2(quad y, quad x)
{
    const quad angle = oracle_atan(q_abs(y) / q_abs(x)), turned = x < 0 ? pi() - angle : angle;
    return y < 0 ? -turned : turned;
}

quad oracle_asin(quad x)
{
    const quad root = q_sqrt((1 - x) * (1 + x));
    return root == 0 ? (x < 0 ? -pi() / 2 : pi() / 2) : oracle_atan(x / root);
}

quad oracle_acos(quad x)
{
    const quad root = q_sqrt((1 - x) * (1 + x));
    if (x == 0)
        return pi() / 2;
    return x > 0 ? oracle_atan(root / x) : pi() - oracle_atan(root / -x);
}

quad oracle_sinh(quad x)
{
    const quad e = oracle_expm1(q_abs(x)), size = (e + e / (1 + e)) / 2;
    return x < 0 ? -size : size;
}

quad oracle_cosh(quad x)
{
    const quad e = oracle_exp(x);
    return (e + 1 / e) / 2;
}

quad oracle_cbrt(quad x)
{
    if (x < 0)
        return -oracle_cbrt(-x);
    int n = 0;
    for (; x < 0x1p-300; n++)
        x *= 0x1p300;
    quad root = pow((double)x, 1.0 / 3);
    for (int i = 0; i < 3; i++)
        root -= (root - x / (root * root)) / 3;
    return scaled(root, -100 * n);
}

quad oracle_pow(quad x, quad y)
{
    return oracle_exp(y * oracle_log(x));
}

quad oracle_hypot(quad x, quad y)
{
    return q_sqrt(x * x + y * y);
}

double oracle_units(double got, quad want)
{
    int exponent;
    frexp((double)want, &exponent);
    if (exponent < DBL_MIN_EXP)
        exponent = DBL_MIN_EXP;
    return fabs((double)scaled((quad)got - want, 53 - exponent));
}

static double argument_of(const oracle_stretch *stretch, test_random *random)
{
    if (!stretch->by_logarithm)
        return test_random_in(random, stretch->low, stretch->high);
    const double x = exp(test_random_in(random, log(stretch->low), log(stretch->high)));
    return test_random_int(random, 0, 1) ? x : -x;
}

void oracle_check(const oracle_stretch *stretches, int count, double most)
{
#ifndef __SIZEOF_FLOAT128__
    SKIP("no numbers of 113 bits");
#endif
    for (int k = 0; k < count; k++) {
        const oracle_stretch *s = &stretches[k];
        test_random random = test_random_begin(s->name);
        double worst = 0, where = 0;
        for (int n = test_cases(3000); n > 0; n--) {
            const double x = argument_of(s, &random),
                         units = oracle_units(s->function(x), s->oracle(x));
            if (!(units <= worst)) {
                worst = units;
                where = x;
            }
        }
        if (!(worst <= most))
            printf("%s: %.4f units at %a\n", s->name, worst, where);
        CHECK(worst <= most);
    }
}

void oracle_check_order(double (*function)(double), const double *places, int count,
                        int direction)
{
    for (int k = 0; k < count; k++) {
        double x = places[k];
        for (int n = 0; n < 250; n++)
            x = nextafter(x, -INFINITY);
        double before = function(x);
        for (int n = 0; n < 500; n++) {
            x = nextafter(x, INFINITY);
            const double value = function(x);
            CHECK(direction * (value - before) >= 0);
            before = value;
        }
    }
}

static void check_same(double got, double want, double x)
{
    const bool same = isnan(want) ? isnan(got) : got == want && signbit(got) == signbit(want);
    if (!same)
        printf("at %a: %a, expected %a\n", x, got, want);
    CHECK(same);
}

void oracle_check_values(double (*function)(double), const oracle_value *values, int count)
{
    for (int k = 0; k < count; k++)
        check_same(function(values[k].x), values[k].value, values[k].x);
}

void oracle_check_values2(double (*function)(double, double), const oracle_value2 *values,
                          int count)
{
    for (int k = 0; k < count; k++)
        check_same(function(values[k].x, values[k].y), values[k].value, values[k].x);
}
