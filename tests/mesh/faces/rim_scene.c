/* Borders made by hand. */
#include "mesh/faces/rim_scene.h"

border *begin_border(void)
{
    border *b = test_array(1, sizeof *b);
    b->u[1] = 1;
    b->rim.corners = b->corners;
    b->rim.at = b->at;
    b->rim.vertex_of = b->vertex_of;
    for (int k = 0; k < 2; k++)
        b->lattice.axis[k] =
            (bat_lattice_axis){.count = 2, .u = b->u, .x = b->u, .cells = b->cells};
    CHECK_OK(bat_pairs_begin(&b->splits, 4));
    return b;
}

void add_polygon(border *b, int edge, int count, const double (*places)[2])
{
    const int first = b->rim.count;
    CHECK(first + count <= MOST);
    for (int i = 0; i < count; i++) {
        b->corners[first + i] = (bat_rim_corner){.uv = {places[i][0], places[i][1]},
                                                 .vertex = first + i,
                                                 .next = first + (i + 1) % count,
                                                 .edge = edge,
                                                 .segment = i};
        b->at[first + i][0] = places[i][0];
        b->at[first + i][1] = places[i][1];
    }
    b->rim.count = first + count;
}
