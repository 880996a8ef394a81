/* Threads, processors, the clock and the C locale on Windows. */
#include "base/system.h"
#if BAT_SYSTEM == BAT_SYSTEM_WINDOWS
#define WIN32_LEAN_AND_MEAN
#include "base/base.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

/* ---- threads ---- */

typedef struct {
    bat_thread_body body;
    void *user;
} thread_task;

static DWORD WINAPI run_thread_task(LPVOID user)
{
    const thread_task task = *(const thread_task *)user;
    free(user);
    task.body(task.user);
    return 0;
}

static bool start_thread(bat_thread *thread, bat_thread_body body, void *user)
{
    thread_task *task = malloc(sizeof *task);
    if (!task)
        return false;
    *task = (thread_task){body, user};
    const HANDLE handle = CreateThread(NULL, 0, run_thread_task, task, 0, NULL);
    if (!handle)
        free(task);
    thread->handle = (uintptr_t)handle;
    return handle != NULL;
}

bool (*bat_thread_start)(bat_thread *thread, bat_thread_body body, void *user) = start_thread;

void bat_thread_wait(bat_thread thread)
{
    WaitForSingleObject((HANDLE)thread.handle, INFINITE);
    CloseHandle((HANDLE)thread.handle);
}

void bat_pause(void)
{
    Sleep(1); /* milliseconds */
}

int bat_processor_count(void)
{
    SYSTEM_INFO info;
    GetSystemInfo(&info);
    return info.dwNumberOfProcessors < 1 ? 1 : (int)info.dwNumberOfProcessors;
}

/* ---- text, time ---- */

int bat_format(char *buffer, size_t size, const char *format, va_list arguments)
{
    const int before = _configthreadlocale(_ENABLE_PER_THREAD_LOCALE);
    const char *current = setlocale(LC_NUMERIC, NULL);
    char kept[128] = "C";
    if (current && strlen(current) < sizeof kept)
        memcpy(kept, current, strlen(current) + 1);
    setlocale(LC_NUMERIC, "C");
    const int length = vsnprintf(buffer, size, format, arguments);
    setlocale(LC_NUMERIC, kept);
    _configthreadlocale(before);
    return length;
}

double batten_system_seconds(void)
{
    LARGE_INTEGER count, frequency;
    QueryPerformanceCounter(&count);
    QueryPerformanceFrequency(&frequency);
    return (double)count.QuadPart / (double)frequency.QuadPart;
}

#endif
