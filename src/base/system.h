/*
 * The one door to the operating system: threads, processors, the clock, real paths, formatting in the C locale
 * (bat_format in base.h), loading and saving of files (batten_load_file, batten_save_file in <batten/text.h>). Behind the door stand posix*.c, windows*.c and none*.c of system/ and system/files/, one of which is compiled; no
 * other file of src/ includes a header of the system.
 */
#ifndef BAT_SYSTEM_H
#define BAT_SYSTEM_H
#include <batten/base.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* BAT_SYSTEM may be given to the compiler; without it we look. */
#define BAT_SYSTEM_NONE 0
#define BAT_SYSTEM_POSIX 1
#define BAT_SYSTEM_WINDOWS 2
#ifndef BAT_SYSTEM
#if defined(_WIN32)
#define BAT_SYSTEM BAT_SYSTEM_WINDOWS
#elif defined(__wasm__)
#define BAT_SYSTEM BAT_SYSTEM_NONE
#else
#define BAT_SYSTEM BAT_SYSTEM_POSIX
#endif
#endif

/* ---- threads ---- */

typedef struct {
    uintptr_t handle;
} bat_thread;

/* What a thread runs; its result is not used. */
typedef void *(*bat_thread_body)(void *user);

/* Start a thread, which is waited for with bat_thread_wait; false where the system gives no more. Written by tests
 * alone. */
extern bool (*bat_thread_start)(bat_thread *thread, bat_thread_body body, void *user);
void bat_thread_wait(bat_thread thread);

/* Let others work for about a millisecond. */
void bat_pause(void);

/* How many processors there are; at least 1. */
int bat_processor_count(void);

/* ---- paths, time ---- */

/* Seconds of a clock that never runs backwards. Exported for the sister libraries, no part of the API. */
BATTEN_API double batten_system_seconds(void);

/* The absolute path without links of a file that exists, NULL and the reason where there is none; given back with
 * bat_release. A reason of NULL means that there was no memory. Exported for the sister libraries, no part of the
 * API. */
BATTEN_API char *batten_system_real_path(const char *path, const char **reason);

/* Is this a link, be there something behind it or not? Exported likewise. */
BATTEN_API bool batten_system_is_link(const char *path);

#endif
