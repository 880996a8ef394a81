#include "exchange/real.h"

#include <stdio.h>
#include <string.h>

void bat_real_write(double value, char text[BAT_REAL_SIZE])
{
    char number[BATTEN_NUMBER_SIZE];
    batten_number_write(value, number);
    const size_t mantissa = strcspn(number, "eE");
    const bool point = memchr(number, '.', mantissa) != NULL;
    const bool exponent = number[mantissa] != '\0';
    snprintf(text, BAT_REAL_SIZE, "%.*s%s%s%s", (int)mantissa, number, point ? "" : ".",
             exponent ? "E" : "", exponent ? number + mantissa + 1 : "");
}
