/* Which parts of a sheet are covered by lines, so that names find room between them. */
#ifndef BAT_PICTURE_COVER_H
#define BAT_PICTURE_COVER_H
#include "base/base.h"

typedef struct {
    double cell; /* the side of a cell, points */
    int columns, rows;
    unsigned char *cells; /* [rows][columns]; not 0 where a line may be */
} bat_cover;

/* Of a sheet of this size, in points. */
batten_status bat_cover_make(double width, double height, double cell, bat_cover *out);
void bat_cover_free(bat_cover *cover);
/* A segment from a [2] to b [2], `half` to both sides; what lies beyond the box low .. high [2] is not there. */
void bat_cover_segment(bat_cover *cover, const double a[2], const double b[2], double half,
                       const double box[4]);
/* Is there no line in the box left, top, right, bottom? Lines closer than a cell and a half may count. */
bool bat_cover_is_free(const bat_cover *cover, const double box[4]);

#endif
