/* How our own loops obey a job: chunks on threads, questions to the caller. */
#ifndef BAT_WORK_H
#define BAT_WORK_H
#include "base/base.h"
#include <batten/base.h>

/* Work on items begin .. end - 1. Chunks share nothing that they write. */
typedef batten_status (*bat_chunk)(void *context, size_t begin, size_t end);

/* Run `chunk` over 0 .. count - 1 in pieces of `size` items, on as many threads as the job
 * says. The pieces do not depend on the number of threads, so neither do the bits. The failure
 * of the first failing piece is returned, its message kept for the calling thread; later pieces
 * may not have run. The calling thread asks the job whether to cancel after each of its own
 * pieces. Memory of the chunks comes from the caller or is theirs; no state is kept. */
batten_status bat_parallel(const batten_job *job, size_t count, size_t size, bat_chunk chunk,
                           void *context);

/* Work on item `index`, which may take long: obey `job`, which has one thread where there are several items. */
typedef batten_status (*bat_long_chunk)(void *context, const batten_job *job, size_t index);

/* As bat_parallel over 0 .. count - 1 one by one, for items that take long: each gets a job by which it learns at once that the caller
 * cancelled, with the caller's limit of steps, and the progress of `what` is reported as items end. One item alone gets the caller's own job. */
batten_status bat_parallel_long(const batten_job *job, size_t count, const char *what,
                                bat_long_chunk chunk, void *context);

/* The work of one call: begins with {job}; NULL job is fine. */
typedef struct {
    const batten_job *job;
    uint64_t steps;
} bat_work;

/* Count `steps` more, report `fraction` of `what`, ask whether to stop.
 * BATTEN_OK, BATTEN_CANCELLED or BATTEN_INCOMPLETE. Cheap enough for once a millisecond, not
 * for once a point. */
batten_status bat_work_step(bat_work *work, uint64_t steps, double fraction, const char *what);

/* One of the steps of a long call: its progress from 0 to 1 is reported as that of the whole, from `begin` to `begin + share`. */
typedef struct {
    batten_job whole;
    double begin, share;
} bat_stage;

/* The job of a stage of `job`, which may be NULL; BAD_ARGUMENT for a job of another size. `stage` is kept until the work is done. */
batten_status bat_stage_begin(const batten_job *job, double begin, double share,
                              bat_stage *stage, batten_job *out);

/* The sum of values[i * stride], pairwise: error grows with log(count), and the shape is fixed.
 */
double bat_sum(const double *values, size_t count, size_t stride);

#endif
