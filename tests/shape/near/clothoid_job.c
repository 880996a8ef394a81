/* The nearest clothoid, asked again and again whether to continue. */
#include "support/test.h"
#include "support/watcher.h"
#include <batten/approximate.h>

enum { MARKS = 300 };

static batten_status fit_clothoid(void *context, const batten_job *job)
{
    batten_span span = {.length = -1};
    const batten_status status =
        batten_clothoid_fit((batten_points){2, MARKS, context}, job, NULL, NULL, &span);
    CHECK_INT(span.length > 0, status == BATTEN_OK);
    return status;
}

TEST(the_nearest_clothoid_ends_when_it_is_cancelled)
{
    double *q = test_array(2 * MARKS, sizeof *q);
    for (int i = 0; i < MARKS; i++) {
        const double t = i / (MARKS - 1.0);
        q[2 * i] = t;
        q[2 * i + 1] = t * t * t / 6;
    }
    check_cancelling(fit_clothoid, q, 10);
}
