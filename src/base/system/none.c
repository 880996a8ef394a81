/* No operating system, such as WebAssembly without threads: one processor, one thread. */
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_NONE
#include "base/base.h"

#include <stdio.h>
#include <time.h>

static bool start_no_thread(bat_thread *thread, bat_thread_body body, void *user)
{
    (void)thread, (void)body, (void)user;
    return false;
}

bool (*bat_thread_start)(bat_thread *thread, bat_thread_body body,
                         void *user) = start_no_thread;

void bat_thread_wait(bat_thread thread)
{
    (void)thread;
}

void bat_pause(void)
{
}

int bat_processor_count(void)
{
    return 1;
}

/* There is but the C locale. */
int bat_format(char *buffer, size_t size, const char *format, va_list arguments)
{
    return vsnprintf(buffer, size, format, arguments);
}

double batten_system_seconds(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec; /* nanoseconds */
}

#endif
