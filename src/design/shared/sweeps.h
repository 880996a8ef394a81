/* What features of sweeps share. */
#ifndef BAT_DESIGN_SWEEPS_H
#define BAT_DESIGN_SWEEPS_H
#include "design/feature.h"
#include <batten/sweep.h>

/* The parameters "within" and "degree". */
#define BAT_SWEEP_BOUNDS                                                        \
    {"within",                                                                  \
     BATTEN_VALUE_LENGTH,                                                       \
     false,                                                                     \
     false,                                                                     \
     NULL,                                                                      \
     NULL,                                                                      \
     "how far from the true sweep; the tolerance of the design if not given"},  \
    {                                                                           \
        "degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "along the path" \
    }

/* The parameters "corners" and "folds". */
#define BAT_SWEEP_CORNERS                                       \
    {"corners",                                                 \
     BATTEN_VALUE_WORD,                                         \
     false,                                                     \
     false,                                                     \
     "refuse",                                                  \
     "refuse mitre split",                                      \
     "what happens at corners of the spine"},                   \
    {                                                           \
        "folds", BATTEN_VALUE_YES_NO, false, false, "no", NULL, \
            "allow sections that run into each other"           \
    }

double bat_sweep_within(const bat_run *run);

/* Numbers as a function over [0, 1]: constant, straight, or a spline through them at equal
 * steps; NULL when the parameter is not given. */
batten_status bat_sweep_law(const bat_run *run, const char *parameter, batten_curve **out);

/* Note what becomes of the third coordinate of sections that are not curves of the xy-plane. */
void bat_remark_space_section(const bat_run *run, const batten_curve *section);

/* Put the surfaces into the model, as "name" or "name 1", "name 2" ..., give their references
 * back and release the array; say what is true of them. A bad status so far is handed on. */
batten_status bat_put_sweep(bat_run *run, batten_status status, int count,
                            batten_surface **surfaces,
                            const batten_surface_sweep_report *report);

/* Curves of which the first and the last may be a point: a tip. */
typedef struct {
    const batten_curve **curves; /* as many as there are objects */
    batten_curve *tips[2];       /* those made for points at the start and the end; owned */
} bat_tipped;

/* The curves of gathered curves and points; a point stands still over [0, 1]. Several points, and a point between
 * curves, are refused by name. Release it after a failure too. */
batten_status bat_take_tipped(const bat_objects *all, bat_tipped *out);
void bat_tipped_release(bat_tipped *tipped);

#endif
