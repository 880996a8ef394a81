/* A traced body, and which faces of the given body its faces come from. */
#ifndef BAT_BODY_TRACED_H
#define BAT_BODY_TRACED_H
#include <batten/body.h>

typedef struct {
    batten_body *body; /* traced, with those of the given faces that could be */
    int *numbers;      /* [face_count] of its faces in the given body; NULL: the same */
    double tolerance;  /* by which it was traced; 0 when it was given so */
} bat_traced;

/* The given face that became face `face`. */
static inline int bat_traced_number(const bat_traced *traced, int face)
{
    return traced->numbers ? traced->numbers[face] : face;
}

/* As batten_body_trace, with the numbers; to be ended. */
batten_status bat_body_trace(const batten_body *body, double tolerance, const batten_job *job,
                             batten_notes *notes, batten_body_trace_report *report,
                             bat_traced *out);
void bat_traced_end(bat_traced *traced);

#endif
