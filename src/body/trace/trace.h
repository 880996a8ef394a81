/*
 * Tracing a body, in steps:
 *
 *   trace.c        all of it; one face after another, edge by edge (faces without loops too)
 *   chart.c        the surface as a plane that covers it; feet of points
 *   parameters.c   parameter curves: kept, in planes, straight; follow.c: all others
 *   loop.c         the uses of a loop one after the other; poles; parameters_of_edge.c: of one edge
 *   seam.c         where to cut a surface that closes, and where edges cross the cut
 *   divide.c       edges divided in all their uses
 *   cut.c          the surface begun at the cut
 *   relink.c       loops closed along the cut; relink_seam.c: with seams as edges
 *   close.c        loops closed to the bit, planes made large enough, a last look
 *   sides.c        which loops are outer ones; loops that run the wrong way
 *
 * While a face is in work its loops have it on their left in (u, v), whatever its side.
 */
#ifndef BAT_TRACE_H
#define BAT_TRACE_H
#include "body/builder.h"
#include "body/trace/chart.h"

typedef struct {
    int edge;
    bool reversed;
    bool is_pole;        /* put in: an edge without a curve */
    batten_curve *curve; /* of (u, v), or NULL; owned */
} bat_trace_use;

/* Arrays of uses, and loops that are ranges of them. */
typedef struct {
    int use_count, use_room, loop_count, loop_room;
    bat_trace_use *uses;
    batten_body_loop *loops;
} bat_trace_loops;

typedef struct {
    int from; /* the face in the given body */
    bool reversed, failed;
    bat_chart chart;
    bat_trace_loops loops;
    double seam[2]; /* where the surface is cut */
    bool cut[2];    /* loops crossed the cut there */
    int rims;       /* borders of the surface that became edges */
} bat_trace_face;

typedef struct {
    int edge;
    double t;
} bat_trace_cut;

typedef struct {
    const batten_body_parts *from;
    double tolerance, size; /* size: of the body */
    const batten_job *job;
    batten_notes *notes;
    batten_body_trace_report report;
    bat_builder builder; /* edges and vertices grow; the numbers of the given ones stay */
    bat_trace_face *faces;
    int face_count;
    int direction; /* in which surfaces are being cut: 0 u, 1 v */
    int *balance;  /* of each given edge: uses along it less uses against it */
    bat_trace_cut *cuts;
    int cut_count, cut_room;
} bat_trace;

/* Loops that grow; the curve is taken over, also on failure. */
batten_status bat_trace_add_use(bat_trace_loops *loops, int edge, bool reversed, bool is_pole,
                                batten_curve *curve);
batten_status bat_trace_add_loop(bat_trace_loops *loops);
void bat_trace_end_loops(bat_trace_loops *loops);
/* Turn one loop around. */
void bat_trace_turn(bat_trace_loops *loops, int loop);
int bat_trace_vertex(const bat_trace *trace, const bat_trace_use *use, bool end);
/* Where a use begins or ends in (u, v). */
void bat_trace_end_of(const bat_trace_use *use, bool end, double uv[2]);

/* Does this failure concern one face, and not the whole? If so it is noted. */
bool bat_trace_fails(bat_trace *trace, bat_trace_face *face, batten_status status);
/* Note something about a face. */
void bat_trace_note(bat_trace *trace, const bat_trace_face *face, const char *text);

batten_status bat_trace_cut_at(bat_trace *trace, int edge, double t);
/* Divide all edges at the cuts so far, and forget these. */
batten_status bat_trace_divide(bat_trace *trace);
/* Cuts where edges pass through poles of the face. */
batten_status bat_trace_pole_cuts(bat_trace *trace, const bat_trace_face *face);
/* Ten times the tolerance for a face whose edges are farther off: up to a thousandth of the
 * body and a hundredth of the face. False when that is reached. */
bool bat_trace_loosen(bat_trace *trace, bat_trace_face *face);
/* The parameter curves of all loops of the face, with poles put in. */
batten_status bat_trace_face_loops(bat_trace *trace, bat_trace_face *face);
/* Turn loops, or the face, where they run the wrong way. */
batten_status bat_trace_right(bat_trace *trace, bat_trace_face *face);
/* Choose where a surface that closes in trace->direction is cut, and cut the edges there. */
batten_status bat_trace_choose_seam(bat_trace *trace, bat_trace_face *face);
/* After the edges are divided: cut the surface, and close the loops along the cut. */
batten_status bat_trace_relink(bat_trace *trace, bat_trace_face *face);
/* Its parts (cut.c): the surface begun at the seam; uses along poles divided there. */
batten_status bat_trace_cut_surface(bat_trace_face *face, int k);
batten_status bat_trace_divide_poles(bat_trace *trace, bat_trace_face *face, int k);
/* Close the loops in (u, v) to the bit, within the domain; look at what the parameter curves
 * miss then. */
batten_status bat_trace_close(bat_trace *trace, bat_trace_face *face);
/* Add what became of the face to the builder; it may have become several. */
batten_status bat_trace_put(bat_trace *trace, bat_trace_face *face);

/* How many whole turns a loop makes in each direction. */
void bat_trace_winding(const bat_trace_face *face, const bat_trace_loops *loops, int loop,
                       int turns[2]);

#endif
