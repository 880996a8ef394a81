/* The properties of an element of a PLY file: which number of an item goes where. */
#include "exchange/ply/reading.h"

const bat_ply_property *bat_ply_properties_of(const bat_ply_reading *r,
                                              const bat_ply_element *element)
{
    const bat_ply_property *all = r->header.properties.items;
    return all ? all + element->first : NULL;
}

batten_status bat_ply_step(bat_ply_reading *r)
{
    if (r->items.at > r->reached)
        r->reached = r->items.at;
    return bat_input_step(r->input, r->reached);
}

int bat_ply_role_of(const bat_ply_property *property)
{
    static const char *const names[] = {"x",  "y",   "z",     "nx",  "ny",
                                        "nz", "red", "green", "blue"};
    static const char *const others[] = {"diffuse_red", "diffuse_green", "diffuse_blue"};
    if (property->is_list)
        return BAT_PLY_IGNORED;
    for (int k = 0; k < BAT_PLY_FURTHER; k++)
        if (bat_word_is(property->name, names[k]) ||
            (k >= BAT_PLY_COLOUR && bat_word_is(property->name, others[k - BAT_PLY_COLOUR])))
            return k;
    return BAT_PLY_FURTHER;
}

batten_status bat_ply_make_room(bat_ply_reading *r, const bat_ply_element *element)
{
    const double zero = 0;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && r->values.count < element->properties)
        status = bat_list_add(r->input, &r->values, &zero);
    return status;
}
