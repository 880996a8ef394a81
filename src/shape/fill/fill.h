/*
 * The parts of filling a hole of n sides by n surfaces that meet in its centre.
 *
 * Surface i ("quad") has u along the first half of side i and v back along the second half of
 * side i - 1; its edges at u = 1 and v = 1 are the spokes i and i - 1, from the middle of the
 * side to the centre. A side runs over [0, 2], its middle at 1. All is in coordinates in which
 * the loop has size 1.
 *
 * Positions and derivatives across all edges are linear in N unknown numbers. Such a vector is
 * an array [N + 1][3]: what each unknown contributes, and at last what is fixed; a number is an
 * array [N + 1]. Tangent planes hold for all values of the unknowns; these are chosen so
 * that curvature varies least.
 */
#ifndef BAT_FILL_H
#define BAT_FILL_H
#include "base/base.h"
#include <batten/fill.h>

/* Of a side: half h goes from station 2 h to 2 h + 1. */
enum { FILL_START, FILL_BEFORE, FILL_AFTER, FILL_END, FILL_STATIONS };
enum { FILL_ORDERS = 4 }; /* point to third derivative */

/* One side of the loop, polynomial, clamped, over [0, 2]. */
typedef struct {
    int given;                          /* which of the caller's */
    batten_curve *curve, *slope, *bend; /* slope and bend may be NULL */
} bat_fill_side;

typedef struct {
    int count;
    bat_fill_side sides[BATTEN_FILL_SIDES];
    double centre[3], size; /* coordinates are centre + size times those of the sides */
} bat_fill_loop;

/* The loop in order, divided at corners, approximated where it is rational (boundary_loop.c). */
batten_status bat_fill_loop_make(int count, const batten_ribbon *sides, double tolerance,
                                 batten_surface_fill_report *report, bat_fill_loop *out);
void bat_fill_loop_free(bat_fill_loop *loop);

/* Derivatives of a side at one station: point and four of the curve, slope and three of it. */
typedef struct {
    double curve[5][3], slope[4][3];
} bat_fill_place;

batten_status bat_fill_see_place(const bat_fill_side *side, int station, bat_fill_place *out);

/* What is seen in a corner from one of its sides that has a slope T: the derivative D across it
 * is a T + b C' and what is beside the tangent plane of the ribbon. */
typedef struct {
    double normal[3], to_a[3], to_b[3]; /* unit normal; to_a . T = to_b . C' = 1 */
    double a, b, twist;                 /* how D' leaves the plane */
    bool back;                          /* D points to where T does not */
} bat_fill_seen;

/* The corners, for all forms (hole_corners.c). D in a corner: from the side that starts there (which 0) that of the `other` one, back. */
void bat_fill_across(int which, const bat_fill_place *other, double out[3]);
/* @param curve  which of the caller's, for messages */
batten_status bat_fill_look(const bat_fill_place *place, int station, const double across[3],
                            int curve, bat_fill_seen *out);
/* Does the side that starts in a corner continue the one before smoothly? */
bool bat_fill_is_flat(const bat_fill_place *start, const bat_fill_place *before);
/* Refuse ribbons that point out of the hole and re-entrant corners with ribbons; report how the
 * others contradict each other in their corners. */
batten_status bat_fill_corners(const bat_fill_loop *loop, batten_surface_fill_report *report);

/* What is known and unknown of one side and its spoke; vectors and numbers as above, [order].
 * Along a side with a slope T the derivative across is D = a T + b C'; else D itself is a
 * cubic in each half. */
typedef struct {
    bool has_slope;
    bool flat_corner; /* at its start the side continues the one before smoothly */
    int middle_speed; /* which unknown is a in the middle; -1 without a slope */
    int corner_turn;  /* which unknown is the part of the twist at its start that goes into
                         the hole; -1 where the twist is free */
    bat_fill_place place[FILL_STATIONS];
    double *across[FILL_STATIONS][2];    /* D, D' */
    double *factor[FILL_STATIONS][2][2]; /* a, a'; b, b' of a side with a slope */
    double *spoke[2][3];                 /* at the side, at the centre: G, G', G'' */
    double *turn[2][2];                  /* the same: W, W' */
} bat_fill_fields;

typedef struct {
    const bat_fill_loop *loop;
    int count, unknowns;
    double cosine; /* of 2 pi / n */
    bat_fill_fields side[BATTEN_FILL_SIDES];
    double *memory; /* of all vectors and numbers */
    double *x;      /* [N] once they are known */
} bat_fill;

/* All of it, the unknowns too. @param plane  surfaces that map each quad into a polygon of the
 * plane z = 0; @param fill  zeros; bat_fill_end gives its memory back, also after a failure */
batten_status bat_fill_make(const bat_fill_loop *loop, batten_surface *const *plane,
                            bat_fill *fill);
void bat_fill_end(bat_fill *fill);
static inline size_t bat_fill_length(const bat_fill *fill)
{
    return 3 * ((size_t)fill->unknowns + 1);
}

/* Values and derivatives of Hermite's functions on [0, 1]: out [order + 1][6], the functions
 * of value, first, second derivative at 0, then at 1. Quintic with `derivatives` 2, cubic with
 * 1: then those of second derivatives are 0. */
void bat_fill_hermite(int derivatives, double t, int order, double out[][6]);

/* The four functions of quad i that run along u (place 0) or v (place 1): at the start of the
 * other parameter point and derivative across, then at its end: out
 * [4][FILL_ORDERS][N + 1][3]. */
batten_status bat_fill_edges(const bat_fill *fill, int quad, int place, double t, double *out);

/* The fairest unknowns (least_energy.c). @param plane  as for bat_fill_make */
batten_status bat_fill_relax(bat_fill *fill, batten_surface *const *plane);

/* The map of each quad into a polygon whose sides have the proportions of the loop's, made the
 * way the fill is made (polygon.c). */
batten_status bat_fill_plane(const bat_fill_loop *loop, batten_surface **plane);

/* A vector or number with the unknowns known. */
void bat_fill_vector(const bat_fill *fill, const double *vector, double out[3]);
double bat_fill_number(const bat_fill *fill, const double *number);

/* Quad i as a B-spline surface, in the loop's coordinates (quad.c). */
batten_status bat_fill_patch(const bat_fill *fill, int quad, double angle,
                             batten_surface **out);

/* Curvature taken over along the sides with `bend`, of surfaces that have the tangent planes
 * already (side_curvature.c). */
batten_status bat_fill_bend(const bat_fill_loop *loop, batten_surface **patches);
/* What S_vv of a quad lacks along half of a side, at t from the corner to the middle, for the
 * normal curvature of the ribbon across the side: a vector along the normal, 0 where there is
 * none (report.c). */
batten_status bat_fill_lack(const bat_fill_loop *loop, int side, int half,
                            const batten_surface *patch, double t, double out[3]);

/* Quad i of a fill that is a formula, in the loop's coordinates (polygon_formulas.c). */
batten_status bat_fill_formula(const bat_fill_loop *loop, int quad, batten_fill_form form,
                               batten_surface **out);

/* A surface seen in one point: two derivatives and the three of second order. */
typedef struct {
    double point[3], u[3], v[3], uu[3], uv[3], vv[3];
    double normal[3];
    double sine;        /* between both first derivatives */
    bool regular, bent; /* there is a normal; second derivatives are known */
} bat_fill_view;

batten_status bat_fill_see_surface(const batten_surface *surface, double u, double v,
                                   bat_fill_view *out);
/* The ribbon, seen as a surface of which u runs along it. */
batten_status bat_fill_see_ribbon(const bat_fill_side *side, double t, batten_side from,
                                  bat_fill_view *out);
/* The normal curvature in a direction of the tangent plane. */
double bat_fill_curvature(const bat_fill_view *s, const double direction[3],
                          const double normal[3]);
/* The larger principal curvature. */
double bat_fill_largest_curvature(const bat_fill_view *s);
/* Both sides of one point of an edge that runs along `along`: the edge keeps what is largest. */
void bat_fill_compare(const bat_fill_view *s, const bat_fill_view *r, const double along[3],
                      batten_fill_edge *edge);

/* Does a normal turn away from the side that the whole hole is seen from (overlap.c)? Not asked
 * of holes that cannot be seen so. */
batten_status bat_fill_find_overlap(const bat_fill_loop *loop, batten_surface *const *patches,
                                    bool *found, double at[3]);

/* What was reached (report.c). @param patches in the loop's coordinates */
batten_status bat_fill_measure(const bat_fill_loop *loop, batten_surface *const *patches,
                               batten_surface_fill_report *report);

/* BAD_ARGUMENT for fewer sides than 2 and more than `most`, and curves that are not in space. */
batten_status bat_fill_check_sides(int count, int most, const batten_ribbon *sides);

#endif
