/* Arcs, asked again and again whether to continue. */
#include "support/test.h"
#include "support/watcher.h"
#include <batten/arcs.h>

enum { MARKS = 60 };

typedef struct {
    batten_arcs_join joined;
    const batten_curve *curve; /* NULL: of the points */
    double points[2 * MARKS];
} task;

static batten_status make_arcs(void *context, const batten_job *job)
{
    const task *t = context;
    batten_arcs_options options = batten_arcs_defaults();
    batten_chain *chain = NULL;
    options.tolerance = 0.01;
    options.joined = t->joined;
    options.job = job;
    const batten_status status =
        t->curve ? batten_arcs_from_curve(t->curve, &options, NULL, &chain)
                 : batten_arcs_from_points((batten_points){2, MARKS, t->points}, &options, NULL,
                                           NULL, &chain);
    CHECK_INT(chain != NULL, status == BATTEN_OK);
    batten_chain_unref(chain);
    return status;
}

TEST(arcs_end_when_they_are_cancelled)
{
    static const double s[] = {0, 0, 1, 3, 3, -3, 4, 1}, breaks[] = {0, 1};
    static const batten_arcs_join joins[] = {BATTEN_ARCS_SMOOTH, BATTEN_ARCS_PLAIN,
                                             BATTEN_ARCS_BIARCS};
    task t = {BATTEN_ARCS_SMOOTH, NULL, {0}};
    batten_curve *curve = NULL;
    for (int i = 0; i < MARKS; i++) {
        t.points[2 * i] = 0.1 * i;
        t.points[2 * i + 1] = sin(0.1 * i);
    }
    check_cancelling(make_arcs, &t, 10);
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, s, NULL, &curve));
    t.curve = curve;
    for (int i = 0; i < COUNT(joins); i++) {
        t.joined = joins[i];
        check_cancelling(make_arcs, &t, 10);
    }
    batten_curve_unref(curve);
}
