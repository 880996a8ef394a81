/* What the instances of a model place in all, without placing it. */
#ifndef BAT_PLACED_H
#define BAT_PLACED_H
#include <batten/model.h>

/* Instances count as objects, for those of nothing cost time too. Points: of rows, of control
 * nets, vertices of meshes. */
typedef struct {
    double objects, points;
} bat_placed;

/* @param own  what the model and its definitions hold, each once
 * @param placed  what the model is when instances are replaced by what they place.
 * Cost: linear in `own`. */
batten_status bat_count_placed(const batten_model *model, bat_placed *own, bat_placed *placed);

#endif
