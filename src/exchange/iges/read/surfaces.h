/* The surfaces of an IGES file: each reads an open item into item->surface, not yet moved. */
#ifndef BAT_IGES_SURFACES_H
#define BAT_IGES_SURFACES_H
#include "body/elementary/elementary.h"
#include "exchange/iges/read/reading.h"

batten_status bat_iges_read_spline_surface(bat_iges_item *item); /* 114 */
batten_status bat_iges_read_ruled(bat_iges_item *item);          /* 118 */
batten_status bat_iges_read_revolution(bat_iges_item *item);     /* 120 */
batten_status bat_iges_read_tabulated(bat_iges_item *item);      /* 122 */
batten_status bat_iges_read_nurbs_surface(bat_iges_item *item);  /* 128 */
batten_status bat_iges_read_offset_surface(bat_iges_item *item); /* 140 */

batten_status bat_iges_read_unbounded(bat_iges_item *item); /* 190 - 198: refused alone */

/* The plane a x + b y + c z = d. */
batten_status bat_iges_plane_of(const double equation[4], bat_elementary *out);
/* Is the surface of an entry without bounds of its own: a plane 108, 190 - 198? */
bool bat_iges_is_elementary(int type);
/* That surface, moved by its matrices. */
batten_status bat_iges_elementary(bat_iges_reading *reading, const bat_iges_entry *entry,
                                  bat_elementary *out);

#endif
