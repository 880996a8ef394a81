/* A model made anew, object by object, the models that it places among them. */
#ifndef BAT_MODEL_CHANGE_H
#define BAT_MODEL_CHANGE_H
#include "base/base.h"
#include <batten/model.h>

/* What becomes of object `index` of the model `from`: `made` takes it, or does not. It is
 * handed over as `object`: instances place what was changed before, where it is in the new
 * unit. */
typedef batten_status bat_object_change(void *context, const batten_model *from, int index,
                                        batten_model *made, const batten_object *object);

/* Each model that is placed is changed once, however often it is placed, and before those that
 * place it. @param scale  the shifts of places are multiplied by it. Cost: linear. */
batten_status bat_model_change(const batten_model *model, double unit_metres, double scale,
                               bat_object_change *change, void *context, batten_model **out);

#endif
