/* What the entities of an IGES file have beside their geometry: colours, names, levels. */
#include "exchange/iges/write/writing.h"

#include <stdlib.h>
#include <string.h>

/* A colour in percent with 6 decimals, so that reading and writing again gives the same text.
 */
static double percent(double part)
{
    return nearbyint(part * 1e8) / 1e6;
}

int bat_iges_put_colour(bat_iges_writing *w, const double colour[3])
{
    const double rgb[3] = {percent(colour[0]), percent(colour[1]), percent(colour[2])};
    for (int k = 0; k < w->colour_count && k < BAT_IGES_COLOURS; k++)
        if (memcmp(w->colours[k], rgb, sizeof rgb) == 0)
            return -w->colour_ids[k];
    const int id = bat_iges_begin_entity(w, 314);
    for (int k = 0; k < 3; k++)
        bat_iges_put_real(&w->data, rgb[k], k < 2 ? ',' : ';');
    bat_iges_end_entity(w, &(bat_iges_look){.type = 314, .use = 2});
    memcpy(w->colours[w->colour_count % BAT_IGES_COLOURS], rgb, sizeof rgb);
    w->colour_ids[w->colour_count % BAT_IGES_COLOURS] = id;
    w->colour_count++;
    return -id;
}

int bat_iges_put_name(bat_iges_writing *w, const char *name)
{
    if (!name[0])
        return 0;
    const int id = bat_iges_begin_entity(w, 406);
    bat_iges_put_integer(&w->data, 1, ',');
    bat_iges_put_string(&w->data, name, ';');
    bat_iges_end_entity(w,
                        &(bat_iges_look){.type = 406, .form = 15, .is_part = true, .use = 3});
    return id;
}

enum { HIGHEST_LEVEL = 9999999 };

/* A layer that is a number is that level; 0 when it is none. */
static int level_of_number(const char *layer)
{
    const bool number = strspn(layer, "0123456789") == strlen(layer) && strlen(layer) <= 7;
    return number && layer[0] != '0' ? (int)strtol(layer, NULL, 10) : 0;
}

static batten_status add_layers(bat_members *list, const batten_model *model, int *highest)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++) {
        const char *layer = batten_model_object(model, i)->layer;
        *highest = bat_max_int(*highest, level_of_number(layer));
        if (layer[0] && !level_of_number(layer))
            status = bat_members_add(list, layer, 0);
    }
    return status;
}

batten_status bat_iges_put_layers(bat_iges_writing *w)
{
    bat_members *list = &w->layers;
    int highest = 0, kept = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < w->definitions.count; i++)
        status = add_layers(list, w->definitions.models[i], &highest);
    bat_members_sort(list);
    for (int i = 0; status == BATTEN_OK && i < list->count; i += bat_members_same(list, i)) {
        list->members[kept] = list->members[i];
        list->members[kept].item = bat_min_int(++highest, HIGHEST_LEVEL);
        const bat_member *layer = &list->members[kept++];
        bat_iges_begin_entity(w, 406);
        bat_iges_put_integer(&w->data, 2, ',');
        bat_iges_put_integer(&w->data, layer->item, ',');
        bat_iges_put_string(&w->data, layer->path, ';');
        bat_iges_end_entity(
            w, &(bat_iges_look){.type = 406, .form = 3, .level = layer->item, .use = 3});
    }
    list->count = kept;
    return status;
}

static int level_of(bat_iges_writing *w, const char *layer)
{
    const int number = level_of_number(layer);
    return number || !layer[0] ? number : bat_members_find(&w->layers, layer)->item;
}

bat_iges_look bat_iges_look_of(bat_iges_writing *w, const batten_object *object)
{
    return (bat_iges_look){.level = level_of(w, object->layer),
                           .colour =
                               object->has_colour ? bat_iges_put_colour(w, object->colour) : 0,
                           .is_hidden = object->is_hidden,
                           .is_part = w->is_inside};
}

batten_status bat_iges_check_room(const bat_iges_writing *w)
{
    if (w->data.count <= 9000000 && w->directory_count <= 9000000)
        return BATTEN_OK;
    return bat_fail(BATTEN_TOO_LARGE, "IGES has room for 9999999 records in a section");
}
