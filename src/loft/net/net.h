/* The fairing of a rectangular net of points: the bicubic spline through it, and its sections. */
#ifndef BAT_LOFT_NET_H
#define BAT_LOFT_NET_H
#include "loft/rounds.h"
#include <batten/fair.h>
#include <batten/grid.h>

/* Bulges of sections up to this part of the size of the net are not seen. */
#define BAT_FAIR_NET_SEEN 1e-6

/* A net at work. */
typedef struct {
    batten_grid given;
    const batten_net_fair_options *options;
    const batten_job *job;
    double size;    /* the diagonal of its box */
    double *within; /* [count_u][count_v] */
    double largest; /* of the bounds */
    double *centre; /* [count_u][count_v][3]: from where the bounds count */
    double *u, *v;  /* parameters, of closed nets one more */
    int cut_count;
    bat_loft_cut *cuts; /* sections, with what they need */
} bat_fair_net_work;

/* How the surface through a net is interpolated. */
batten_surface_interpolate_options bat_fair_net_fit(const batten_net_fair_options *options);
/* The surface through the net z at the parameters of the work. */
batten_status bat_fair_net_surface(const bat_fair_net_work *work, const double *z,
                                   batten_surface **out);

/* The sections of the net into the work, of which nothing is known yet. */
batten_status bat_fair_net_cuts(bat_fair_net_work *work);

/* What is in excess on the surface: sections that are not known yet need the inflections that it
 * has of bulges above the bound. */
batten_status bat_fair_net_judge(const bat_fair_net_work *work, const batten_surface *surface,
                                 bat_loft_reached *out);

/* Least change, with the sections known: z [count_u][count_v][3] comes as given, and stays so when
 * it is fair or cannot be bettered. */
batten_status bat_fair_net_change(const bat_fair_net_work *work, double *z);

#endif
