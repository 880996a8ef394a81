/*
 * One patch made fair: the moves of its control points that keep every datum within its bound,
 * change least, and give no cut more inflections than its points require.
 */
#ifndef BAT_LOFT_ROUNDS_H
#define BAT_LOFT_ROUNDS_H
#include "loft/data.h"
#include "loft/signs.h"
#include <batten/base.h>

/* y <= most at a place. */
typedef struct {
    double u, v, most;
} bat_loft_limit;

typedef struct {
    bat_loft_patch patch;
    bool *held; /* [nu][nv][3] */
    int datum_count, cut_count;
    bat_loft_datum *data;
    bat_loft_cut *cuts;
    double within;  /* the bound of the user: moves are measured in it */
    double breadth; /* lengths of the energy are measured in it */
    double height;  /* bulges of cuts up to this are not counted */
    double smooth;  /* of the energy against the squares of the moves: found */
    bool one_side;  /* y >= 0 */
    bool is_graph;  /* x and z are held */
    int limit_count, limit_room;
    bat_loft_limit *limits; /* places at which y is limited */
    int trimmed;            /* points of the table that do not belong to the hull */
    const batten_job *job;
} bat_loft;

typedef struct {
    int rounds, excess, cuts_in_excess;
    double slack; /* how far the signs of curvature could not be met, normed; 0 when they are */
    double energy, lowest; /* the least y */
    bat_loft_moves moves;
} bat_loft_reached;

/* The patch comes with feet of the data, and with the held coordinates of its control points;
 * the others are found. NOT_COMPATIBLE when the bounds cannot be met. */
batten_status bat_loft_run(bat_loft *loft, bat_loft_reached *reached);
/* The cuts of the patch as it stands. */
batten_status bat_loft_judge(bat_loft *loft, bat_loft_reached *reached);
/* Is there a patch that keeps the bounds, whatever its cuts? */
batten_status bat_loft_fits(bat_loft *loft);

#endif
