#include "exchange/real.h"

#include <string.h>

int bat_real_write(double value, char text[BAT_REAL_SIZE])
{
    int length = batten_number_write(value, text), end = 0;
    bool point = false;
    while (end < length && text[end] != 'e')
        point |= text[end++] == '.';
    if (end < length)
        text[end] = 'E';
    if (!point) {
        memmove(text + end + 1, text + end, (size_t)(length - end) + 1);
        text[end] = '.';
        length++;
    }
    return length;
}

int bat_integer_write(int64_t value, char text[BAT_INTEGER_SIZE])
{
    char digits[BAT_INTEGER_SIZE];
    uint64_t rest = value < 0 ? 0 - (uint64_t)value : (uint64_t)value;
    int count = 0, length = 0;
    do
        digits[count++] = (char)('0' + rest % 10);
    while (rest /= 10);
    if (value < 0)
        text[length++] = '-';
    while (count > 0)
        text[length++] = digits[--count];
    text[length] = 0;
    return length;
}
