/* Single arcs of a row of tangent ones: how the curve bends, where an arc may end, whether it is in the band. */
#ifndef BAT_ARCS_SMOOTH_STEP_H
#define BAT_ARCS_SMOOTH_STEP_H
#include "shape/arcs/smooth_arcs.h"

enum {
    BAT_SMOOTH_LOOKS = 24, /* at the curve along an arc */
    BAT_SMOOTH_FINE = 96,  /* places along each plain arc */
    BAT_SMOOTH_LEANS = 65  /* ranges of leans */
};

typedef struct {
    double u, point[2], direction[2]; /* of the curve */
    double node[2];                   /* in the middle of the band */
    double angle;                     /* of the direction, all turns added */
    double reach;                     /* the length of a plain arc there */
} bat_smooth_row;

typedef struct {
    int place, parent;
    double lean;
} bat_arc_state;

typedef struct {
    const bat_arcs_smooth *task;
    double half, middle, shrink;  /* of the band; the share of it that samples may take */
    double excess;                /* by how much arcs may bend otherwise than the curve */
    double least_bend, most_bend; /* the curvatures that arcs may have at all */
    bool held; /* the ends stay on the curve, beside the middle of the band */
    bool around;
    int count;            /* of steps between the rows */
    bat_smooth_row *rows; /* [count + 1] */
    int state_count, capacity;
    bat_arc_state *states;
    bat_arc_state start; /* that was best, around, and the arcs from there; 0: none yet */
    int start_arcs;
    int best[BAT_SMOOTH_LEANS], now[BAT_SMOOTH_LEANS],
        next[BAT_SMOOTH_LEANS]; /* place; states, or -1 */
} bat_arc_search;

/* Where an arc goes: the chord to a node, and half its turn. */
typedef struct {
    const bat_smooth_row *from;
    double lean, angle, direction[2]; /* with which it begins */
    double length, half;
} bat_smooth_leg;

/* Steadily going on, a lean is sqrt 3 / 6 * 36 = 10.4 half bands by the length of an arc. The
 * ranges reach to 16 of them. */
static const double bat_step_of_leans = 0.5, bat_most_lean = 1;

/* The row at a place; a closed curve continues. */
bat_smooth_row bat_smooth_row_at(const bat_arc_search *s, int place);
/* As fine along each plain arc: so the rows are dense where arcs will be short. */
batten_status bat_smooth_rows(bat_arc_search *s);
bool bat_smooth_may_bend(const bat_arc_search *s, double curvature);
batten_status bat_smooth_add(bat_arc_search *s, const bat_arc_state *from, int *index);
/* By how much an arc bends otherwise than the curve on average: a steady arc not at all, one at
 * an extreme of curvature by less than 20 half bands by the square of its length. Short arcs
 * that bend wildly fit into the band as well, but nobody wants them. */
bool bat_smooth_bends_alike(const bat_arc_search *s, double lean, const bat_smooth_row *to,
                            double to_lean, double l);
bat_smooth_leg bat_smooth_leg_of(const bat_smooth_row *from, double lean);
/* On to the node of a row, and the lean with which the arc arrives; false when it turns by more
 * than a half circle, leans too much or bends too much. */
bool bat_smooth_aim(const bat_arc_search *s, bat_smooth_leg *l, const bat_smooth_row *to,
                    double *lean, int *range);
bool bat_smooth_arc(const bat_arc_search *s, const bat_smooth_leg *l, batten_biarc *out);
/* A few looks at the curve along the arc; then all between those next to the extremes. */
bool bat_smooth_fits(const bat_arc_search *s, const batten_biarc *arc, int from, int to);
/* At an end that lies on one side of its band the arcs must lead into it. */
bool bat_smooth_leads_in(const bat_arc_search *s, double lean, bool arriving);

#endif
