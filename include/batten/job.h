#ifndef BATTEN_JOB_H
#define BATTEN_JOB_H
/**
 * @file
 * How a long computation is watched: threads, progress, cancelling, a budget of work.
 */
#include <batten/base.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Passed to every routine whose work depends on data; NULL means one thread and no questions.
 * The result has the same bits for any number of threads. The callbacks are called from the
 * thread that made the call, and from no other.
 */
typedef struct batten_job {
    size_t size;         /**< sizeof(batten_job), set by BATTEN_JOB */
    int thread_count;    /**< 1, or more; 0 means as many as there are processors */
    uint64_t work_limit; /**< 0 for none; else about this many elementary steps, then the
                              routine ends with BATTEN_INCOMPLETE */
    bool (*is_cancelled)(void *user); /**< may be NULL; true ends with BATTEN_CANCELLED */
    void (*progress)(void *user, double fraction, const char *what); /**< may be NULL */
    void *user;
} batten_job;

#ifdef __cplusplus
#define BATTEN_JOB                                          \
    batten_job                                              \
    {                                                       \
        sizeof(batten_job), 1, 0, nullptr, nullptr, nullptr \
    }
#else
#define BATTEN_JOB ((batten_job){.size = sizeof(batten_job), .thread_count = 1})
#endif

#ifdef __cplusplus
}
#endif
#endif
