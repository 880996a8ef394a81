/* How things of a STEP file look: colours, layers, and what is not to be seen. */
#ifndef BAT_STEP_STYLES_H
#define BAT_STEP_STYLES_H
#include "exchange/step/text/instances.h"

typedef struct {
    bool has_fill, has_stroke; /* colours of surfaces, of curves and points */
    double fill[3], stroke[3]; /* sRGB, 0..1 */
} bat_step_colours;

typedef struct {
    const bat_step_file *file;
    bat_list looks;   /* of items, by their instances */
    bat_list members; /* of layers, by their instances */
    bat_list layers;  /* names */
    bat_list hidden;  /* uint32_t: instances, in order */
} bat_step_styles;

void bat_step_styles_begin(const bat_step_file *file, bat_step_styles *styles);
void bat_step_styles_end(bat_step_styles *styles);
/* Take in a STYLED_ITEM of any kind, a PRESENTATION_LAYER_ASSIGNMENT, an INVISIBILITY; in any
 * order, then sort, then ask. What is broken of them is noted; only failures of the whole are
 * handed back. */
batten_status bat_step_styles_add(bat_step_styles *styles, const bat_step_instance *instance);
batten_status bat_step_styles_add_layer(bat_step_styles *styles,
                                        const bat_step_instance *instance);
batten_status bat_step_styles_add_hidden(bat_step_styles *styles,
                                         const bat_step_instance *instance);
void bat_step_styles_sort(bat_step_styles *styles);

/* NULL when the item has none. */
const bat_step_colours *bat_step_colours_of(const bat_step_styles *styles,
                                            const bat_step_instance *item);
/* The name of its layer; NULL when it is on none. */
const char *bat_step_layer_of(const bat_step_styles *styles, const bat_step_instance *item);
/* Is it, its style or its layer invisible? */
bool bat_step_is_hidden(const bat_step_styles *styles, const bat_step_instance *item);

#endif
