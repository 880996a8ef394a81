/* Contours of any shape that consists of smooth pieces. */
#ifndef BAT_CONTOURS_H
#define BAT_CONTOURS_H
#include "inspect/contours/net.h"

/* As batten_surface_contours, or, with cubics, batten_surface_smooth_contours. */
batten_status bat_contours(const bat_pieces *pieces, const batten_surface_field *field,
                           int level_count, const double *levels, double tolerance, bool smooth,
                           const batten_job *job, batten_contours *out);

#endif
