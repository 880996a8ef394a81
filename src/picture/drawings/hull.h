/* The lines of a half hull: its cuts with four families of planes, its edges and its knuckles. */
#ifndef BAT_HULL_H
#define BAT_HULL_H
#include "picture/lines/stroke.h"
#include <batten/picture.h>

/* A family is numbered by the coordinate that is fixed in its planes; those of diagonals lie along x and
 * lean: in the body plan they fall from the centre line. */
typedef enum {
    BAT_STATIONS,
    BAT_BUTTOCKS,
    BAT_WATERLINES,
    BAT_AXES,
    BAT_DIAGONALS = BAT_AXES,
    BAT_FAMILIES
} bat_family;

static const char *const bat_family_names[BAT_FAMILIES] = {"station", "buttock", "waterline",
                                                           "diagonal"};

/* More lines of a family come of a wrong unit. */
enum { BAT_CUT_LIMIT = 400 };

typedef struct {
    double at;      /* of a diagonal: the height at which it leaves the centre plane */
    double angle;   /* of a diagonal: below the level, radians */
    bool is_design; /* the design waterline */
    bat_strokes lines;
} bat_cut;

typedef struct {
    double spacing; /* 0 when positions were given */
    int count;
    bat_cut *cuts; /* by increasing position; diagonals as given */
} bat_cuts;

/* An edge off the centre plane at which the sections across the hull turn: a chine. */
enum { BAT_KNUCKLE_NAME = 32 };
typedef struct {
    char name[BAT_KNUCKLE_NAME];
    bat_strokes lines; /* one after another along x */
} bat_knuckle;

typedef struct {
    double low[3], high[3]; /* of the half with y >= 0 */
    bat_cuts families[BAT_FAMILIES];
    double reach; /* the longest way along a diagonal from the centre plane; 0 without any */
    bat_strokes edges; /* boundary curves of the surfaces */
    int knuckle_count, knuckle_room;
    bat_knuckle *knuckles; /* from the lowest up */
} bat_hull;

/* Cut all surfaces of a model. A hull on the side of negative y is mirrored; of a whole hull
 * the half with y >= 0 is taken. What was left out is reported in `notes`. */
batten_status bat_hull_cut(const batten_model *model,
                           const batten_draw_lines_plan_options *plan, batten_notes *notes,
                           bat_hull *out);
void bat_hull_free(bat_hull *hull);

/* How far along a diagonal a point is from the centre plane. */
static inline double bat_diagonal_way(const bat_cut *diagonal, const double point[3])
{
    return point[1] * bat_cos(diagonal->angle) +
           (diagonal->at - point[2]) * bat_sin(diagonal->angle);
}

/* ---- hull_places.c ---- */

/* Room for so many cuts and a design waterline. */
batten_status bat_cuts_make(bat_cuts *cuts, int count);
/* The stations, waterlines and buttocks that are to be cut. */
batten_status bat_hull_place_cuts(const batten_draw_lines_plan_options *plan,
                                  batten_notes *notes, bat_hull *hull);

/* ---- hull_diagonals.c ---- */

/* The diagonals that are given, or are chosen for a hull that has its stations and knuckles. */
batten_status bat_hull_place_diagonals(const batten_draw_lines_plan_options *plan,
                                       bat_hull *hull);

/* ---- hull_knuckles.c ---- */

/* The knuckles among the edges, by how the stations turn there; named as the line of a table in
 * `data` (may be NULL) that runs along them, else by number. */
batten_status bat_hull_find_knuckles(const batten_model *data, bat_hull *hull);
/* y and z of a knuckle at a station; false where it does not reach. `margin`: so far beyond its end it still does. */
bool bat_knuckle_at(const bat_knuckle *knuckle, double x, double margin, double yz[2]);

/* Add the parts of a polyline where sign * (coordinate - value) >= 0, cut exactly at the plane.
 */
batten_status bat_strokes_add_part(bat_strokes *list, const bat_stroke *stroke, int axis,
                                   double sign, double value);

#endif
