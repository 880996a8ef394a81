/*
 * Cuts: the plane curves by which a lofting is judged. A cut is a plane section of the patch, or
 * an edge of it seen along an axis.
 */
#ifndef BAT_LOFT_CUT_H
#define BAT_LOFT_CUT_H
#include "loft/patch.h"

typedef enum {
    BAT_CUT_STATION,   /* x = const, sampled along v */
    BAT_CUT_WATERLINE, /* z = const, sampled along u, as all that follow */
    BAT_CUT_BUTTOCK,
    BAT_CUT_DIAGONAL,
    BAT_CUT_PROFILE, /* the edge v = 0 seen from the side or from above */
    BAT_CUT_SHEER    /* the edge v = 1 */
} bat_cut_kind;

typedef struct {
    bat_cut_kind kind;
    double m[3];   /* the unit normal of the plane, or the direction of sight */
    double at;     /* m . S = at of a plane */
    int needed;    /* changes of the sign of curvature that the points require; -1: not known */
    int found;     /* those of the patch whose bulges are above the height of judging */
    bool is_asked; /* `needed` is what the surface of least energy has */
    bool shaped;   /* the signs of its curvature are rows of the program from now on */
} bat_loft_cut;

static inline bool bat_cut_is_edge(const bat_loft_cut *cut)
{
    return cut->kind >= BAT_CUT_PROFILE;
}

/* Points of the patch over a grid of parameters, made once for many cuts. */
typedef struct {
    const bat_loft_patch *patch;
    bool along_v;
    int along_count, across_count;
    double *along, *across; /* parameters */
    double *points;         /* [along_count][across_count][3] */
    int row_count;
    double *rows; /* [along_count][row_count][3]: control points of the curves across */
} bat_loft_grid;

/* The longest connected run of a cut: at most one place for each parameter along. */
typedef struct {
    int count;
    double *u, *v;
    double *plane; /* [][2]: coordinates in the plane */
} bat_cut_trace;

/* What traces cuts: one grid for each direction, and room for a trace. */
typedef struct {
    bat_loft_grid along_u, along_v;
    bat_cut_trace trace;
} bat_cut_tracer;

/* `each`: samples in a span of the knots; 0 for `even` samples in all. */
batten_status bat_cut_tracer_make(const bat_loft_patch *patch, int each, int even,
                                  bat_cut_tracer *out);
void bat_cut_tracer_free(bat_cut_tracer *tracer);

/* Into tracer->trace. Cost: a pass over the grid, and some 7 points for each place. */
void bat_cut_find(bat_cut_tracer *tracer, const bat_loft_cut *cut);

#endif
