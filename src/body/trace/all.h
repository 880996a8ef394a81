/*
 * Tracing for what looks at faces one by one, as measuring and checking do: every face as
 * finely as its edges allow. Files often miss the tolerance that they state. So faces that fail
 * are traced again, ten times as coarse, and again; edges that they share with others are then
 * not shared any more.
 */
#ifndef BAT_TRACE_ALL_H
#define BAT_TRACE_ALL_H
#include "base/base.h"
#include "body/trace/traced_body.h"

enum { BAT_TRACE_ROUNDS = 12 };

typedef struct {
    int count;
    bat_traced at[BAT_TRACE_ROUNDS];
    int failed;      /* faces of the given body that could not be traced */
    bool *is_failed; /* whether each of them; NULL when none is */
    int rims;        /* borders of surfaces that became edges: free ones */
} bat_traced_all;

/* Has every face its loops, and every use its parameters? */
bool bat_is_traced(const batten_body_parts *parts);
/* From the body's own tolerance up to `coarsest`. */
batten_status bat_trace_all(const batten_body *body, double coarsest, const batten_job *job,
                            bat_traced_all *out);
void bat_trace_all_end(bat_traced_all *all);

#endif
