/* Text in the C locale on POSIX systems. */
#define _XOPEN_SOURCE 700
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_POSIX
#include "base/base.h"

#include <locale.h>
#include <pthread.h>
#include <stdio.h>

/* Made once and kept as long as the program runs; uselocale takes 0 to change nothing. */
static locale_t c_locale;

static void make_c_locale(void)
{
    c_locale = newlocale(LC_ALL_MASK, "C", c_locale);
}

int bat_format(char *buffer, size_t size, const char *format, va_list arguments)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, make_c_locale);
    const locale_t before = uselocale(c_locale);
    const int length = vsnprintf(buffer, size, format, arguments);
    uselocale(before);
    return length;
}

#endif
