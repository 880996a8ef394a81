/* The colours of triangles, each once. */
#include "model/palette.h"
#include "base/sort.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    double colour[3];
    int triangle;
} coloured;

static int compare(const void *a, const void *b)
{
    const coloured *one = a, *other = b;
    for (int k = 0; k < 3; k++)
        if (one->colour[k] != other->colour[k])
            return bat_compare_doubles(&one->colour[k], &other->colour[k]);
    return one->triangle - other->triangle;
}

static void fill_slots(const coloured *sorted, int count, bat_palette *p)
{
    for (int i = 0; i < count; i++) {
        const double *colour = sorted[i].colour;
        if (i == 0 || colour[0] != sorted[i - 1].colour[0] ||
            colour[1] != sorted[i - 1].colour[1] || colour[2] != sorted[i - 1].colour[2])
            p->first[p->count++] = i;
        p->order[i] = sorted[i].triangle;
        p->of[sorted[i].triangle] = p->count - 1;
    }
    p->first[p->count] = count;
}

batten_status bat_palette_find(const batten_mesh_parts *parts, bat_palette *out)
{
    const size_t count = (size_t)parts->triangle_count;
    coloured *sorted = bat_array(count, sizeof *sorted);
    *out = (bat_palette){0};
    out->first = bat_array(count + 1, sizeof *out->first);
    out->order = bat_array(count, sizeof *out->order);
    out->of = bat_array(count, sizeof *out->of);
    const bool enough = sorted && out->first && out->order && out->of;
    if (enough) {
        for (size_t i = 0; i < count; i++) {
            memcpy(sorted[i].colour, parts->triangle_colours + 3 * i, sizeof sorted[i].colour);
            sorted[i].triangle = (int)i;
        }
        qsort(sorted, count, sizeof *sorted, compare);
        fill_slots(sorted, (int)count, out);
    } else {
        bat_palette_end(out);
    }
    bat_release(sorted);
    return enough ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

void bat_palette_end(bat_palette *palette)
{
    bat_release(palette->first);
    bat_release(palette->order);
    bat_release(palette->of);
    *palette = (bat_palette){0};
}

const double *bat_palette_colour(const bat_palette *palette, const batten_mesh_parts *parts,
                                 int index)
{
    return parts->triangle_colours + 3 * (size_t)palette->order[palette->first[index]];
}
