/* The curves of an IGES file: each reads an open item into item->curve, not yet moved. */
#ifndef BAT_IGES_CURVES_H
#define BAT_IGES_CURVES_H
#include "exchange/iges/read/reading.h"

batten_status bat_iges_read_arc(bat_iges_item *item);          /* 100 */
batten_status bat_iges_read_composite(bat_iges_item *item);    /* 102 */
batten_status bat_iges_read_conic(bat_iges_item *item);        /* 104 */
batten_status bat_iges_read_copious(bat_iges_item *item);      /* 106, curves and points */
batten_status bat_iges_read_line(bat_iges_item *item);         /* 110 */
batten_status bat_iges_read_spline_curve(bat_iges_item *item); /* 112 */
batten_status bat_iges_read_point(bat_iges_item *item);        /* 116 */
batten_status bat_iges_read_nurbs_curve(bat_iges_item *item);  /* 126 */
batten_status bat_iges_read_offset_curve(bat_iges_item *item); /* 130 */

/* Some curves, each counted once more. */
typedef struct {
    bat_list at; /* of batten_curve * */
} bat_iges_curves;
void bat_iges_curves_begin(bat_iges_curves *curves);
void bat_iges_curves_end(bat_iges_curves *curves);
size_t bat_iges_curves_count(const bat_iges_curves *curves);
const batten_curve *bat_iges_curves_at(const bat_iges_curves *curves, size_t index);

/* Append the curve of an id; of a composite its members, one after another. */
batten_status bat_iges_members(bat_iges_reading *reading, int id, bat_iges_curves *curves);

double bat_iges_size_of_curve(const batten_curve *curve);
double bat_iges_size_of_box(batten_box box);

/* What an interval or a weight of 126 and 128 may be. */
batten_status bat_iges_check_shape(const bat_iges_item *item, int upper, int degree);
batten_interval bat_iges_interval(const bat_iges_item *item, size_t at, batten_interval domain);
/* Do equal weights say nothing, as the entity calls itself polynomial? */
bool bat_iges_weights_matter(const bat_iges_item *item, bool polynomial, size_t count,
                             const double *weights);

#endif
