/* Curves as polylines in space, fine enough for any picture. */
#ifndef BAT_STROKE_H
#define BAT_STROKE_H
#include "base/base.h"
#include <batten/model.h>

typedef struct {
    size_t count;
    double *points; /* [count][3] */
} bat_stroke;

/* Points along a curve, each knot among them; coordinates it has not are 0. */
batten_status bat_stroke_curve(const batten_curve *curve, bat_stroke *out);
/* The same for the curve on a surface at a fixed parameter. */
batten_status bat_stroke_isoline(const batten_surface *surface, batten_direction direction,
                                 double at, bat_stroke *out);
/* Does the isoline shrink to a point, as at a pole? */
bool bat_stroke_is_point(const bat_stroke *stroke, double tolerance);
void bat_stroke_free(bat_stroke *stroke);

/* Growing list of strokes. */
typedef struct {
    size_t count, capacity;
    bat_stroke *strokes;
} bat_strokes;

/* Take a stroke over; it is freed when there is no memory to keep it. */
batten_status bat_strokes_add(bat_strokes *list, bat_stroke stroke);
void bat_strokes_free(bat_strokes *list);

/* Parameters at every knot and `steps` - 1 evenly between each two. */
batten_status bat_divide_spans(int knot_count, const double *knots, int steps, size_t *count,
                               double **out);

/* Steps into which each span of a curve is divided. */
int bat_stroke_steps(const batten_curve *curve);

#endif
