/* What the outline of a hull demands of a lofting: rows beside those of points and cuts. */
#ifndef BAT_LOFT_OUTLINE_H
#define BAT_LOFT_OUTLINE_H
#include "loft/rounds.h"

/* A stem that is plane and held on the centre plane rises along v: else the surface folds over beside it. */
batten_status bat_loft_add_stems(const bat_loft *loft, bat_loft_program *program);

#endif
