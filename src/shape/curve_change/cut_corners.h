/* The corners of a curve, and how something else goes in their place. */
#ifndef BAT_CORNERS_H
#define BAT_CORNERS_H
#include <batten/blend.h>

typedef struct {
    int index; /* counted from 0 along the curve as it was given; the seam is the last */
    const batten_curve *before, *behind; /* up to the corners next to it */
} bat_corner;

/* Where the curve before is left and that behind is reached, and what goes between; without a
 * link the corner stays. */
typedef struct {
    double u[2];
    batten_curve *link;
} bat_corner_cut;

typedef struct {
    batten_status (*cut)(void *context, const bat_corner *corner, bat_corner_cut *out);
    void *context;
    double tolerance; /* of gaps */
} bat_cutter;

/* How many corners there are, the seam of a closed curve included. */
batten_status bat_curve_corner_count(const batten_curve *curve, int *count);
/* All corners cut, and all joined again; the curve itself when it has none. */
batten_status bat_curve_cut_corners(const batten_curve *curve, const bat_cutter *cutter,
                                    batten_curve **out);

/* The places in two curves of the plane where an arc of this radius leaves the first and enters
 * the second, turning to the left (side 1) or to the right (-1) (fillet_search.c). */
typedef struct {
    double u[2];
    int side, found;
    bool complete;
} bat_fillet_place;
batten_status bat_fillet_search(const batten_curve *const curves[2], double radius,
                                bat_fillet_place *out);

#endif
