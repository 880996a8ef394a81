/* Few common knots for many curves. */
#ifndef BAT_COMMON_KNOTS_H
#define BAT_COMMON_KNOTS_H
#include "base/work.h"
#include <batten/curve.h>

/*
 * Give curves of one dimension the same degree, few common knots and the domain [0, 1], no
 * curve moving farther than `tolerance` at equal parameters; corners stay, and the ends, but of
 * periodic curves: these, all of them, stay periodic. When that takes as many knots as the
 * exact union, that.
 * @param[out] out [count]; @param[out] deviation [count] bounds on how far each moved
 */
batten_status bat_common_knots(int count, const batten_curve *const *curves, double tolerance,
                               bat_work *work, batten_curve **out, double *deviation);

/* What more common knots can be asked for. */
typedef struct {
    double tolerance; /* how far a curve may move, > 0 */
    int held_count;
    const double *held; /* [held_count] knots inside (0, 1), rising, that all get */
    bool seam;          /* the curves close smoothly: so do the results, with two derivatives */
} bat_common_request;

/* The same. With held knots or a seam the exact union, which has neither, is taken only when
 * the tolerance cannot be met with fewer knots. */
batten_status bat_common_knots_held(int count, const batten_curve *const *curves,
                                    const bat_common_request *request, bat_work *work,
                                    batten_curve **out, double *deviation);

#endif
