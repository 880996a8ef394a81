/* A hull in panels between faired lines; a smooth one is a hull of one panel without lines. */
#ifndef BAT_LOFT_PANELS_H
#define BAT_LOFT_PANELS_H
#include "loft/rails.h"

typedef struct {
    bool has_rails;
    bat_hull_rails rails;
    int count;                 /* panels, from below */
    bat_loft *at;              /* [count] */
    bat_loft_reached *reached; /* [count] */
} bat_hull_panels;

/* The panels as they begin; release with bat_hull_panels_free, also after a failure. */
batten_status bat_hull_panels_make(const batten_offset_table *table,
                                   const batten_loft_options *options, const batten_job *job,
                                   bat_hull_panels *out);
void bat_hull_panels_free(bat_hull_panels *panels);

/* All of them made fair; their data are then all points, those of the lines too. */
batten_status bat_hull_panels_run(bat_hull_panels *panels);
/* Are there panels that keep the bounds, whatever their cuts? Their data are then all
 * points, those of the lines too, and where they come to. */
batten_status bat_hull_panels_fit(bat_hull_panels *panels);

/* Has the panel no points but those of its lines? */
static inline bool bat_hull_is_ruled(const bat_loft *panel)
{
    return panel->patch.nv == BAT_LOFT_SUPPORT;
}

#endif
