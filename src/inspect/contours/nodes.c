/* The ground of a net: pairs of numbers, the field, nodes and triangles as they are added. */
#include "base/list.h"
#include "base/plural.h"
#include "inspect/contours/net.h"

#include <limits.h>
#include <string.h>

/* Of triangles: a net of so many takes about a hundred megabytes. */
enum { MOST_TRIANGLES = 1048576 };

/* ---- pairs ---- */

/* The table, for the first pair, and the values grow together. */
static batten_status make_room_for_value(bat_pair_values *known)
{
    enum { FIRST = 512 };
    batten_status status = BATTEN_OK;
    if (!known->pairs.table)
        status = bat_pairs_begin(&known->pairs, FIRST);
    if (status != BATTEN_OK || known->pairs.count < known->room)
        return status;
    const int room = known->room > 0 ? bat_min_int(known->room, INT_MAX / 2) * 2 : FIRST;
    int *values = bat_resize(known->values, (size_t)room, sizeof *values);
    if (!values)
        return BATTEN_OUT_OF_MEMORY;
    known->values = values;
    known->room = room;
    return BATTEN_OK;
}

int *bat_pair_values_at(bat_pair_values *known, int a, int b, int otherwise)
{
    int index;
    if (make_room_for_value(known) != BATTEN_OK)
        return NULL;
    const int before = known->pairs.count;
    if (bat_pairs_add(&known->pairs, a, b, &index) != BATTEN_OK)
        return NULL;
    if (known->pairs.count > before)
        known->values[index] = otherwise;
    return &known->values[index];
}

void bat_pair_values_free(bat_pair_values *known)
{
    bat_pairs_end(&known->pairs);
    bat_release(known->values);
    *known = (bat_pair_values){0};
}

/* ---- the field ---- */

batten_status bat_net_field(const bat_net *net, int piece, const double uv[2], double *value,
                            double gradient[2], double derivatives[9])
{
    double all[3 * BATTEN_SURFACE_DERIVATIVES(3)], slope[2];
    const bat_pieces *p = net->pieces;
    const batten_status status = p->evaluate(p->shape, piece, uv, net->order, all);
    if (status != BATTEN_OK)
        return status;
    *value = bat_field_value(net->field, all, slope);
    if (gradient)
        memcpy(gradient, slope, sizeof slope);
    if (derivatives)
        memcpy(derivatives, all, 9 * sizeof *all);
    return BATTEN_OK;
}

int bat_net_levels_below(const bat_net *net, double value)
{
    int low = 0, high = net->level_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (net->levels[middle] <= value)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* ---- nodes and triangles ---- */

batten_status bat_net_add_node(bat_net *net, double value, int *out)
{
    if (net->node_count == net->node_capacity) {
        const size_t capacity = 2 * net->node_capacity + 256;
        double *values = bat_resize(net->values, capacity, sizeof *values);
        if (values)
            net->values = values;
        bool *critical = bat_resize(net->critical, capacity, sizeof *critical);
        if (critical)
            net->critical = critical;
        int *owner = bat_resize(net->owner, capacity, sizeof *owner);
        if (owner)
            net->owner = owner;
        if (!values || !critical || !owner)
            return BATTEN_OUT_OF_MEMORY;
        net->node_capacity = capacity;
    }
    net->values[net->node_count] = value;
    net->critical[net->node_count] = false;
    net->owner[net->node_count] = -1;
    *out = (int)net->node_count++;
    return BATTEN_OK;
}

batten_status bat_net_add_triangle(bat_net *net, const bat_triangle *triangle)
{
    if (net->triangle_count >= MOST_TRIANGLES)
        return bat_fail(
            BATTEN_TOO_LARGE, "contours need more than %d triangles: the shape has %d piece%s",
            MOST_TRIANGLES, net->pieces->piece_count, bat_plural(net->pieces->piece_count));
    if (BAT_LIST_GROW(net->triangles, net->triangle_count, net->triangle_capacity, 1) !=
        BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    net->triangles[net->triangle_count++] = *triangle;
    return BATTEN_OK;
}

void bat_net_free(bat_net *net)
{
    bat_release(net->triangles);
    bat_release(net->values);
    bat_release(net->critical);
    bat_release(net->owner);
    bat_release(net->criticals);
}
