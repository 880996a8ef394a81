/* Surfaces that fold over, or have spans too short to be of use, as features make them. */
#ifndef BAT_DESIGN_FOLDS_H
#define BAT_DESIGN_FOLDS_H
#include "design/feature.h"

/* Note where surfaces that a feature has made of something else fold over. What changes surfaces
 * and what reads files says nothing: there the folds are given. */
batten_status bat_note_folds(const bat_run *run);

/* Note where a surface has spans along u that are below a millionth of its domain, or across which it does not get
 * as far as the tolerance of the design; `advice` is what helps. */
batten_status bat_note_slivers(const bat_run *run, const batten_surface *surface,
                               const char *advice);

#endif
