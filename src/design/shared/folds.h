/* Surfaces that fold over, as features make them. */
#ifndef BAT_DESIGN_FOLDS_H
#define BAT_DESIGN_FOLDS_H
#include "design/feature.h"

/* Note where surfaces that a feature has made of something else fold over. What changes surfaces
 * and what reads files says nothing: there the folds are given. */
batten_status bat_note_folds(const bat_run *run);

#endif
