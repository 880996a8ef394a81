/* The lofting of a hull from its table of offsets. */
#ifndef BAT_LOFT_HULL_H
#define BAT_LOFT_HULL_H
#include "base/arena.h"
#include "fair/grid.h"
#include "loft/rounds.h"
#include <batten/hull.h>

/* Of stations and of the points of a line. */
enum { BAT_HULL_FEWEST_STATIONS = 3 };

/* A station from the profile to the sheer. */
typedef struct {
    double x;
    int count;
    batten_table_point *points;
    double *v;    /* girth in parts of the whole */
    int *from;    /* [count]: which point of the table */
    bool is_stem; /* all points lie on the centre plane */
} bat_hull_station;

/* What a lofting takes from a table. */
typedef struct {
    const batten_offset_table *table;
    bat_arena arena; /* release it, also after a failure */
    int station_count;
    bat_hull_station *stations;
    int trimmed;           /* points of the table that do not belong to the hull */
    int most_points;       /* of a station */
    double breadth, least; /* the largest y and the least */
} bat_hull_table;

/* ---- stations.c ---- */

/* The stations, without girths. */
batten_status bat_hull_take_stations(const batten_offset_table *table, bat_hull_table *out);
/* Most points, breadth and least y, of the stations as they are. */
void bat_hull_count(bat_hull_table *hull);
/* BAD_ARGUMENT when the bound, or the hull, is too small or too large. */
batten_status bat_hull_check_bound(const bat_hull_table *hull, double within);
/* v of the k-th station of the table. COINCIDENT when two neighbours are one. */
batten_status bat_hull_measure_girth(const batten_offset_table *table, int k,
                                     bat_hull_station *station);
/* UNSUPPORTED when half of the stations have a knuckle. */
batten_status bat_hull_refuse_knuckles(const bat_hull_table *hull);
/* All of this, for one smooth surface. */
batten_status bat_hull_take_table(const batten_offset_table *table, bat_hull_table *out);

/* ---- hull.c ---- */

/* A faired line: x is linear in u, and y and z are functions in the knots of the panels beside it. */
typedef struct {
    double x[2];   /* at u = 0 and 1 */
    double *yz[2]; /* [coefficients] */
    int needed[2]; /* inflections that its points require of y and z over x */
    int found[2];
} bat_hull_rail;

/* What bounds a panel. */
typedef struct {
    int inner_count;
    const double *inner; /* knots along u */
    const bat_hull_rail *low, *high;
    bool is_top; /* nothing is above it */
} bat_hull_edges;

/* The patch of the hull, or with `edges` of a panel, whose edges are held; its points, which are
 * those between the edges, and the cuts by which it is judged; `smooth` is left at 0. A panel
 * without points is ruled, as it stands. */
batten_status bat_hull_patch(const bat_hull_table *table, double within,
                             const bat_hull_edges *edges, bat_loft *out);
/* One smooth surface. */
batten_status bat_hull_make(const batten_offset_table *table, double within, bat_loft *out);
void bat_hull_release(bat_loft *loft);

/* ---- hull_cuts.c ---- */

/* The cuts of a hull: its stations and waterlines and those halfway between, buttocks, two
 * families of diagonals, profile and sheer; of a panel its lower edge, from the side and from
 * above, and of the one at the top both; a panel without points, which is ruled, is judged by these
 * alone, for its twist makes its sections turn. */
batten_status bat_hull_cuts(const bat_hull_table *table, const bat_hull_edges *edges,
                            bat_loft *loft);

/* ---- graph.c ---- */

/* A hull as a graph y(x, z): x and z of the patch are a map between four lines, the ends, the foot and
 * the top, and are held; only half-breadths are found. */

/* What a graph is bounded by: coefficients of x of the ends over v, and of z of the foot and the
 * top over u. */
typedef struct {
    int u_count, v_count;      /* coefficients along u and v */
    double *u_knots, *v_knots; /* [count + 4] */
    double *aft, *fore;        /* [v_count] */
    double *low, *high;        /* [u_count] */
    double bend; /* of the way from the foot to the top: (1 - bend) v + bend v^2 */
    bool closed[2], closed_foot; /* the aft, the fore end, the foot lies on the centre plane */
} bat_graph_frame;

/* v where the foot and the top have this share of the way between them behind. */
double bat_graph_fall(double bend, double share);
/* A rectangle over all stations and heights. */
batten_status bat_graph_frame_all(const bat_hull_grid *grid, bat_arena *arena,
                                  bat_graph_frame *out);
/* The patch with x and z of the frame, y = 0; and the points of the hull at their feet. */
batten_status bat_graph_patch(const bat_hull_grid *grid, const bat_graph_frame *frame,
                              double within, bat_loft *out);
/* Where the table says that there is no hull beside it the graph over all is not above the bound. */
batten_status bat_graph_limit_outside(const bat_hull_grid *grid, bat_loft *all);

/* ---- graph_lines.c ---- */

/* The lines of the hull itself, made fair, from the graph over all of the grid; that is fitted first. */
batten_status bat_graph_find_lines(const bat_hull_grid *grid, bat_loft *all, double within,
                                   bat_arena *arena, bat_graph_frame *frame);

/* ---- smooth.c ---- */

/* One smooth surface of a table, as a graph where it is one; or girths say more. */
batten_status bat_hull_smooth(const batten_offset_table *table, double within,
                              const batten_job *job, bat_loft *out);

#endif
