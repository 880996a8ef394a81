/* The colours of instances given to what they place. */
#ifndef BAT_MODEL_PAINTED_H
#define BAT_MODEL_PAINTED_H
#include "base/base.h"
#include <batten/model.h>

/* The same model for formats whose instances have no colours: shapes without a colour within an
 * instance that has one get it, as by batten_model_flat. A definition is copied for each colour
 * that it is placed in, its geometry is shared; up to 256 colours for one definition and a
 * million objects, a note counts the instances that stay without. The model itself when there
 * is nothing to do. Cost: linear in the objects of the copies. */
batten_status bat_model_painted(const batten_model *model, batten_notes *notes,
                                batten_model **out);

#endif
