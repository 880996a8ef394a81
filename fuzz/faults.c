/* An allocator that fails when it is told to, and counts the blocks that are not given back. */
#include "faults.h"

#include <batten/base.h>
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
static bool keeps_promises(const uint8_t *data, size_t size, const batten_read_options *options,
                           const batten_job *job, long from, long to)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    allocated = live = 0;
    fail_from = from;
    fail_to = to;
    batten_status status = batten_notes_create(20, &notes);
    if (status == BATTEN_OK)
        status = batten_read_memory((const char *)data, size, options, job, notes, &model);
    const bool comes = (status == BATTEN_OK || status == BATTEN_PARTLY_READ) == (model != NULL);
    batten_model_unref(model);
    batten_notes_free(notes);
    fail_to = 0;
    return comes && live == 0;
}

bool fuzz_faults(const char *name, const uint8_t *data, size_t size, batten_format format,
                 long most)
{
    batten_read_options options = batten_read_defaults();
    options.format = format;
    if (!keeps_promises(data, size, &options, NULL, 1, 0)) {
        fprintf(stderr, "%s: memory is kept, or a model that should not come\n", name);
        return false;
    }
    const long count = allocated, tries = count < most ? count : most;
    for (long i = 0; i < tries; i++) {
        const long at = 1 + i * count / tries;
        if (!keeps_promises(data, size, &options, NULL, at, at) ||
            !keeps_promises(data, size, &options, NULL, at, count + 1)) {
            fprintf(stderr, "%s: memory is kept, or a model comes, when allocation %ld fails\n",
                    name, at);
            return false;
        }
    }
    return true;
}

/* ---- limits ---- */

/* The limit number `which` at `value`, the others as they are; false when there is none. */
static bool lower(int which, size_t value, batten_limits *limits, batten_job *job)
{
    size_t *const of_size[] = {&limits->entities, &limits->points, &limits->string_bytes,
                               &limits->line_bytes};
    *limits = batten_limits_defaults();
    *job = BATTEN_JOB;
    if (which < 4)
        *of_size[which] = value;
    else if (which == 4)
        limits->nesting = (int)value;
    else if (which == 5)
        limits->memory_bytes = 64 * value * value;
    else
        job->work_limit = 700 * value;
    return which < 7;
}

bool fuzz_limits(const char *name, const uint8_t *data, size_t size, batten_format format)
{
    static const size_t values[] = {1, 2, 3, 5, 8, 13, 21};
    batten_limits limits;
    batten_job job;
    batten_read_options options = batten_read_defaults();
    options.format = format;
    options.limits = &limits;
    for (size_t k = 0; k < sizeof values / sizeof values[0]; k++)
        for (int which = 0; lower(which, values[k], &limits, &job); which++)
            if (!keeps_promises(data, size, &options, &job, 1, 0)) {
                fprintf(stderr, "%s: memory is kept, or a model comes, at limit %d of %zu\n",
                        name, which, values[k]);
                return false;
            }
    return true;
}
