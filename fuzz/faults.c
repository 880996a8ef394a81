#include "faults.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

/* Readers may use threads. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static long allocated, live; /* so many so far; so many blocks that were not given back */
static long fail_from, fail_to;

static void *resize(void *user, void *memory, size_t bytes)
{
    (void)user;
    pthread_mutex_lock(&lock);
    allocated++;
    void *block =
        allocated >= fail_from && allocated <= fail_to ? NULL : realloc(memory, bytes);
    if (block && !memory)
        live++;
    pthread_mutex_unlock(&lock);
    return block;
}

static void release(void *user, void *memory)
{
    (void)user;
    pthread_mutex_lock(&lock);
    live--;
    pthread_mutex_unlock(&lock);
    free(memory);
}

void fuzz_faults_begin(void)
{
    batten_set_allocator(&(batten_allocator){.resize = resize, .release = release});
    fail_to = 0;
}

/* Read once, with the allocations from..to failing. */
static bool keeps_promises(const uint8_t *data, size_t size, batten_format format, long from,
                           long to)
{
    batten_read_options options = batten_read_defaults();
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    options.format = format;
    allocated = live = 0;
    fail_from = from;
    fail_to = to;
    batten_status status = batten_notes_create(20, &notes);
    if (status == BATTEN_OK)
        status = batten_read_memory((const char *)data, size, &options, NULL, notes, &model);
    const bool comes = (status == BATTEN_OK || status == BATTEN_PARTLY_READ) == (model != NULL);
    batten_model_unref(model);
    batten_notes_free(notes);
    fail_to = 0;
    return comes && live == 0;
}

bool fuzz_faults(const char *name, const uint8_t *data, size_t size, batten_format format,
                 long most)
{
    if (!keeps_promises(data, size, format, 1, 0)) {
        fprintf(stderr, "%s: memory is kept, or a model that should not come\n", name);
        return false;
    }
    const long count = allocated, tries = count < most ? count : most;
    for (long i = 0; i < tries; i++) {
        const long at = 1 + i * count / tries;
        if (!keeps_promises(data, size, format, at, at) ||
            !keeps_promises(data, size, format, at, count + 1)) {
            fprintf(stderr, "%s: memory is kept, or a model comes, when allocation %ld fails\n",
                    name, at);
            return false;
        }
    }
    return true;
}
