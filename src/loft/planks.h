/* Planks: what is straight across between two lines of a hull, and how far a plate is from lying there. */
#ifndef BAT_LOFT_PLANKS_H
#define BAT_LOFT_PLANKS_H
#include "loft/rails.h"

/* At equal steps of u along the lower line. */
enum { BAT_PLANK_RULINGS = 81 };

/* A ruling from u of the lower line to w of the upper, and the sine and cosine of its warp, the
 * angle between the normals at its ends. */
typedef struct {
    double u, w, sine, cosine;
} bat_plank_ruling;

/* Is there no point between the line of this number and the next? */
bool bat_hull_is_plank(const bat_hull_rails *rails, int low);

/* The rulings [BAT_PLANK_RULINGS] of least warp, none of which crosses another; a little counts
 * how far they are from stations. */
batten_status bat_plank_find_rulings(const bat_hull_rails *rails, int low,
                                     bat_plank_ruling *out);
/* Radians; a right angle and more where the plank turns over. */
double bat_plank_warp(const bat_plank_ruling *ruling);

#endif
