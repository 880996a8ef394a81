/* The models that instances place, each once: for formats that share what is placed often. */
#ifndef BAT_DEFINITIONS_H
#define BAT_DEFINITIONS_H
#include "model/addresses.h"
#include <batten/model.h>

typedef struct {
    int count;
    const batten_model **models; /* [count], borrowed; the model itself first */
    int *first;                  /* [count + 1] the number of the first object of each */
    int capacity;
    bat_addresses addresses; /* the index by the model's address */
} bat_definitions;

/* Begin with all 0; release by bat_definitions_end, also after a failure. */
batten_status bat_definitions_find(const batten_model *model, bat_definitions *out);
void bat_definitions_end(bat_definitions *definitions);
/* The index of a model that was found. */
int bat_definitions_index(const bat_definitions *definitions, const batten_model *model);
/* Which objects have one mesh, and which of these one name and colour too.
 * mesh, look: [objects] the lowest number of such an object; its own when there is none before
 * it, and where there is no mesh. Cost: O(n log n). */
batten_status bat_definitions_meshes(const bat_definitions *definitions, int *mesh, int *look);
/* The indices in an order in which each comes after those that it places: by rising depth.
 * order: [count]. */
void bat_definitions_rising(const bat_definitions *definitions, int *order);
/* What each is called, else the name under which it is placed first, "" for none.
 * names: [count]. */
void bat_definitions_names(const bat_definitions *definitions, const char **names);
/* Hand them over in that order, each with its name. */
typedef batten_status bat_definition_take(void *context, int index, const char *name);
batten_status bat_definitions_each(const bat_definitions *definitions,
                                   bat_definition_take *take, void *context);

#endif
