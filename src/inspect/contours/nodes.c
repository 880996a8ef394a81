/* The ground of a net: pairs of numbers, the field, nodes and triangles as they are added. */
#include "base/list.h"
#include "base/plural.h"
#include "inspect/contours/net.h"

#include <string.h>

/* Of triangles: a net of so many takes about a hundred megabytes. */
enum { MOST_TRIANGLES = 1048576 };

/* ---- pairs ---- */

static uint64_t scatter(uint64_t key)
{
    key ^= key >> 31;
    key *= 0x9e3779b97f4a7c15u;
    return key ^ key >> 29;
}

static size_t find_slot(const bat_pairs *pairs, uint64_t key)
{
    size_t slot = (size_t)scatter(key) & (pairs->capacity - 1);
    while (pairs->keys[slot] != 0 && pairs->keys[slot] != key)
        slot = (slot + 1) & (pairs->capacity - 1);
    return slot;
}

static batten_status grow_pairs(bat_pairs *pairs)
{
    bat_pairs larger = {.capacity = pairs->capacity ? 2 * pairs->capacity : 1024};
    larger.keys = bat_array(larger.capacity, sizeof *larger.keys);
    larger.values = bat_array(larger.capacity, sizeof *larger.values);
    if (!larger.keys || !larger.values) {
        bat_pairs_free(&larger);
        return BATTEN_OUT_OF_MEMORY;
    }
    larger.count = pairs->count;
    for (size_t i = 0; i < pairs->capacity; i++) {
        if (pairs->keys[i] == 0)
            continue;
        const size_t slot = find_slot(&larger, pairs->keys[i]);
        larger.keys[slot] = pairs->keys[i];
        larger.values[slot] = pairs->values[i];
    }
    bat_pairs_free(pairs);
    *pairs = larger;
    return BATTEN_OK;
}

int *bat_pairs_at(bat_pairs *pairs, int a, int b, int otherwise)
{
    const uint64_t key = ((uint64_t)(uint32_t)a << 32 | (uint32_t)b) + 1;
    if (2 * (pairs->count + 1) > pairs->capacity && grow_pairs(pairs) != BATTEN_OK)
        return NULL;
    const size_t slot = find_slot(pairs, key);
    if (pairs->keys[slot] == 0) {
        pairs->keys[slot] = key;
        pairs->values[slot] = otherwise;
        pairs->count++;
    }
    return &pairs->values[slot];
}

void bat_pairs_free(bat_pairs *pairs)
{
    bat_release(pairs->keys);
    bat_release(pairs->values);
    *pairs = (bat_pairs){0};
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
