/* Round numbers, and numbers rounded to be read. */
#include "picture/sheet/numbers.h"

#include "numeric/vector.h"

double bat_round_step(double range, double count)
{
    const double least = range / count, power = bat_pow(10, floor(bat_log10(least)));
    static const double factors[] = {1, 2, 5};
    for (int i = 0; i < 3; i++)
        /* A range of exactly ten steps must not fall to the next because of a rounding. */
        if (factors[i] * power >= least * (1 - 1e-9))
            return factors[i] * power;
    return 10 * power;
}

int bat_decimals_of_step(double step)
{
    /* A power of ten whose logarithm is rounded down is still that power. */
    return -(int)floor(bat_log10(step) + 1e-9);
}

void bat_number_text(double value, int decimals, char text[static BATTEN_NUMBER_SIZE])
{
    /* Dividing by a power of ten rounds once, so that 3 tenths are written 0.3. */
    const double power = bat_pow(10, fabs((double)decimals));
    double rounded =
        decimals >= 0 ? round(value * power) / power : round(value / power) * power;
    if (!isfinite(rounded))
        rounded = value;
    batten_number_write(rounded == 0 ? 0 : rounded, text);
}

void bat_digits_text(double value, int digits, char text[static BATTEN_NUMBER_SIZE])
{
    const double size = fabs(value);
    bat_number_text(value, size > 0 ? digits - 1 - (int)floor(bat_log10(size)) : 0, text);
}
