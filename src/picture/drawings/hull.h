/* The lines of a half hull: its cuts with three families of planes, and its edges. */
#ifndef BAT_HULL_H
#define BAT_HULL_H
#include "picture/lines/stroke.h"
#include <batten/picture.h>

/* A family is numbered by the coordinate that is fixed in its planes. */
typedef enum { BAT_STATIONS, BAT_BUTTOCKS, BAT_WATERLINES, BAT_FAMILIES } bat_family;

typedef struct {
    double at;
    bool is_design; /* the design waterline */
    bat_strokes lines;
} bat_cut;

typedef struct {
    double spacing; /* 0 when positions were given */
    int count;
    bat_cut *cuts; /* by increasing position */
} bat_cuts;

typedef struct {
    double low[3], high[3]; /* of the half with y >= 0 */
    bat_cuts families[BAT_FAMILIES];
    bat_strokes edges; /* boundary curves of the surfaces */
} bat_hull;

/* Cut all surfaces of a model. A hull on the side of negative y is mirrored; of a whole hull
 * the half with y >= 0 is taken. What was left out is reported in `notes`. */
batten_status bat_hull_cut(const batten_model *model,
                           const batten_draw_lines_plan_options *plan, batten_notes *notes,
                           bat_hull *out);
void bat_hull_free(bat_hull *hull);

/* Add the parts of a polyline where sign * (coordinate - value) >= 0, cut exactly at the plane.
 */
batten_status bat_strokes_add_part(bat_strokes *list, const bat_stroke *stroke, int axis,
                                   double sign, double value);

#endif
