/* Text in the C locale on POSIX systems. */
#define _XOPEN_SOURCE 700
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_POSIX
#include "base/base.h"

#include <locale.h>
#include <stdio.h>

int bat_format(char *buffer, size_t size, const char *format, va_list arguments)
{
    const locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    const locale_t before = c ? uselocale(c) : (locale_t)0;
    const int length = vsnprintf(buffer, size, format, arguments);
    if (c) {
        uselocale(before);
        freelocale(c);
    }
    return length;
}

#endif
