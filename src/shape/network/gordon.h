/* A network of curves on its way to a surface: what the files of this room share. */
#ifndef BAT_GORDON_H
#define BAT_GORDON_H
#include "inspect/nearest/meetings.h"
#include "spline/spline.h"
#include <batten/gordon.h>

/* One curve of the network; all are scaled so that the largest coordinate is about 1. */
typedef struct {
    int index;           /* in the caller's list; -1 for a pole that no curve was given for */
    batten_curve *curve; /* polynomial, in space, clamped, over [0, 1] */
    bool point, closed;
    double moved;    /* by making it polynomial, and by closing it */
    double gap;      /* the widest of its joints */
    bat_trace trace; /* until the nodes are found */
    double *at;      /* [nodes] parameters of the nodes, rising */
    batten_curve
        *map; /* from the parameter of the surface to that of the curve; NULL: the same */
} bat_network_curve;

/* 0: profiles, along u; 1: guides, along v. */
typedef struct {
    const char *what; /* "profile", "guide" */
    const char *const *names;
    int given, count, room;
    bat_network_curve *curves; /* [room], in order across once the nodes are known */
    bool closed, smooth; /* each of them; then the other family has its first curve twice */
    double *parameters;  /* [count of the other] of the nodes along these curves */
} bat_network_family;

typedef struct {
    bat_network_family family[2];
    const batten_surface_gordon_options *options;
    double scale;     /* a length of the caller times this is one of ours */
    double tolerance; /* ours */
    double gap;       /* ours: how far curves may miss each other */
    double same;      /* ours: what is nearer is one place, whatever the tolerance */
    double size;      /* ours */
    bat_work work;
    double *nodes; /* [profiles][guides][3] */
    batten_surface_gordon_report report;
} bat_network;

/* "profile 3" of an array; "profile 'rib' (4 of 7)" when there are names. */
enum { BAT_NETWORK_LABEL = 160 };
const char *bat_network_label(const bat_network *net, int family,
                              const bat_network_curve *curve, char label[BAT_NETWORK_LABEL]);
static inline const bat_network_curve *bat_network_at(const bat_network *net, int family, int k)
{
    return &net->family[family].curves[k];
}

/* Take the curves of both families: in space, polynomial, of one scale (given_curves.c). */
batten_status bat_network_take(bat_network *net, const batten_curve *const *profiles,
                               const batten_curve *const *guides);
/* One of them; *moved is how far it is from the given one. */
batten_status bat_network_take_curve(const batten_curve *given, double scale, double tolerance,
                                     batten_curve **out, double *moved);
/* The power of two that brings the largest coordinate to about 1; NOT_COMPATIBLE names the
 * curve of one dimension, COINCIDENT when all is one point. */
batten_status bat_network_scale(int count, const batten_curve *const *curves, double *scale);
void bat_network_free(bat_network *net);

/* Find where each profile meets each guide, and order, turn and cut all curves so that the
 * nodes rise along each (nodes.c, curve_order.c). */
batten_status bat_network_find_nodes(bat_network *net);
/* What the nodes of all pairs are before they are in order: parameters on the profile and on
 * the guide, and points midway; [profiles][guides] with room for more. */
typedef struct {
    double *at[2];
    double *points;   /* [..][3] */
    double *distance; /* of the curves there */
} bat_network_pairs;
/* The place of curve k of a family with curve l of the other one. */
static inline int bat_network_pair(const bat_network *net, int family, int k, int l)
{
    return (family == 0 ? k : l) * net->family[1].room + (family == 0 ? l : k);
}
/* What is nearer is one place, whatever gap is allowed. A millionth of the size is far below
 * any distance that is meant, and above the rounding of coordinates about 1. */
static inline double bat_network_same_place(double gap, double size)
{
    return bat_min(gap, bat_max(1e-6 * size, 0x1p-44));
}
/* What is nearer to an end or a corner of a curve stands on it: hardly anything of what may be
 * missed, and of the network. */
static inline double bat_network_snap(const bat_network *net)
{
    return bat_min(net->tolerance / 16, 1e-5 * net->size);
}
/* Which curves close, when it is known what meets them where (closed_curves.c). */
batten_status bat_network_find_closed(bat_network *net, const bat_network_pairs *pairs);
/* Are two curves of a family one? *distance: how far the second is from the first. */
batten_status bat_network_are_same(const bat_network *net, const bat_network_curve *a,
                                   const bat_network_curve *b, bool *same, double *distance);
/* Curves of a family that were given twice, at the seam of closed ones, are dropped, or
 * refused; a point in which all of a family end becomes a curve of the other one
 * (poles.c). */
batten_status bat_network_drop_repeated(bat_network *net, bat_network_pairs *pairs, int family);
batten_status bat_network_find_poles(bat_network *net, bat_network_pairs *pairs, int family);
batten_status bat_network_order(bat_network *net, const bat_network_pairs *pairs);
/* In reverse_curves.c: cut, turn and rotate one curve of a family; `ranked` are the parameters
 * [count] of the nodes on it as it is, in their order. */
batten_status bat_network_turn(bat_network *net, int family, bat_network_curve *curve,
                               int count, const double *ranked, bool reversed);

/* Parameters of the surface, maps from there to the curves, points of the nodes
 * (common_parameters.c). */
batten_status bat_network_parametrize(bat_network *net);
/* The curve as the surface runs along it, cubic, within the tolerance; corners keep their place
 * (redraw.c). */
batten_status bat_network_redraw(const bat_network_curve *curve, int node_count,
                                 const double *parameters, double tolerance,
                                 batten_curve **out);
/* The point of the curve at a parameter of the surface. */
batten_status bat_network_point(const bat_network_curve *curve, double u, double *point);

/* The functions that are 1 at one node of a family's curves and 0 at the others, over [0, 1];
 * as wide as there are nodes, of a periodic one without the last (cardinal_functions.c). */
batten_status bat_network_make_cardinal(const bat_network *net, int family, bool periodic,
                                        bat_spline *out);
/* One family with common knots, and the cardinal functions of the other: all on the same
 * knots. */
typedef struct {
    int degree, count, curves, cardinals;
    double *knots; /* [count + degree + 1] */
    double *rows;  /* [curves][count][3] */
    double *blend; /* [count][cardinals] */
    bool exact;
    bool seam; /* rows and blends close with two derivatives, in cubics: they can be periodic */
    int exact_knots;
} bat_network_side;
batten_status bat_network_make_side(bat_network *net, int family, bat_network_side *out);
void bat_network_side_free(bat_network_side *side);

/* A + B - T, and the check against all curves and nodes (boolean_sum.c). */
batten_status bat_network_sum(bat_network *net, bat_network_side sides[2],
                              batten_surface **out);
/* How near neighbours come, and how far the guides are from the skin of the profiles: for the
 * report (report.c). */
batten_status bat_network_measure(bat_network *net, const bat_network_side sides[2]);

#endif
