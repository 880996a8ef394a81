/* The box around the edges of a body. */
#include "body/edge_box.h"
#include "numeric/box.h"
#include "spline/surface/surface.h"

batten_box bat_body_edge_box(const batten_body *body)
{
    const batten_body_parts *parts = batten_body_view(body);
    batten_box box = bat_box_of_nothing();
    for (int i = 0; i < parts->vertex_count; i++)
        bat_box_join(&box, bat_box_at(&parts->vertices[3 * (size_t)i]));
    for (int i = 0; i < parts->edge_count; i++)
        if (parts->edges[i].curve)
            bat_box_join(&box, batten_curve_box(parts->edges[i].curve));
    for (int i = 0; i < parts->face_count; i++)
        if (parts->faces[i].count == 0)
            bat_box_join(&box, batten_surface_box(parts->faces[i].surface));
    return bat_box_is_of_nothing(box) ? (batten_box){{0, 0, 0}, {0, 0, 0}} : box;
}
