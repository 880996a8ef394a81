/* Bodies in other places: mapped and turned. */
#include "body/builder.h"
#include "numeric/vector.h"

#include <string.h>

/* How much longer the map makes things at most, by its rows. */
static double stretch(const batten_affine *map)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            sum += map->m[i][k] * map->m[i][k];
    return sqrt(sum / 3);
}

static batten_status map_edges(const batten_body_parts *parts, const batten_affine *map,
                               bat_builder *builder)
{
    batten_status status = BATTEN_OK;
    int index;
    for (int i = 0; status == BATTEN_OK && i < parts->vertex_count; i++) {
        const double *p = &parts->vertices[3 * (size_t)i];
        const batten_vec3 at = batten_affine_apply(*map, (batten_vec3){p[0], p[1], p[2]});
        status = bat_builder_vertex(builder, (double[]){at.x, at.y, at.z}, &index);
    }
    for (int i = 0; status == BATTEN_OK && i < parts->edge_count; i++) {
        const batten_body_edge *edge = &parts->edges[i];
        batten_curve *curve = NULL;
        if (edge->curve)
            status = batten_curve_transform(edge->curve, map, &curve);
        if (status == BATTEN_OK)
            status =
                bat_builder_edge(builder, curve, edge->vertices[0], edge->vertices[1], &index);
        batten_curve_unref(curve);
    }
    return status;
}

/* The loop, begun at its end and run against itself when `turned`. */
static batten_status map_loop(const batten_body_parts *parts, const batten_body_loop *loop,
                              bool turned, bat_builder *builder)
{
    batten_status status = bat_builder_loop(builder);
    for (int k = 0; status == BATTEN_OK && k < loop->count; k++) {
        const batten_body_use *use =
            &parts->uses[loop->first + (turned ? loop->count - 1 - k : k)];
        status = bat_builder_use(builder, use->edge, use->reversed != turned, use->parameters);
    }
    return status;
}

static batten_status map_face(const batten_body_parts *parts, const batten_body_face *face,
                              const batten_affine *map, bool turned, bat_builder *builder)
{
    batten_surface *surface = NULL;
    batten_body_face made = *face;
    batten_status status = batten_surface_transform(face->surface, map, &surface);
    if (status == BATTEN_OK) {
        made.surface = surface;
        made.reversed = face->reversed != turned;
        status = bat_builder_face(builder, &made);
    }
    for (int k = 0; status == BATTEN_OK && k < face->count; k++)
        status = map_loop(parts, &parts->loops[face->first + k], turned, builder);
    batten_surface_unref(surface);
    return status;
}

batten_status batten_body_transform(const batten_body *body, const batten_affine *map,
                                    batten_body **out)
{
    const batten_body_parts *parts = batten_body_view(body);
    const double factor = stretch(map);
    bat_builder builder;
    const double determinant = batten_affine_determinant(*map);
    if (!(isfinite(factor) && determinant != 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the map is singular or not finite");
    bat_builder_begin(&builder, parts->tolerance * factor);
    const bool turned = determinant < 0;
    batten_status status = map_edges(parts, map, &builder);
    for (int i = 0; status == BATTEN_OK && i < parts->shell_count; i++) {
        const batten_body_shell *shell = &parts->shells[i];
        status = bat_builder_shell(&builder, shell->closed);
        for (int k = 0; status == BATTEN_OK && k < shell->count; k++)
            status = map_face(parts, &parts->faces[shell->first + k], map, turned, &builder);
    }
    builder.parts.is_traced = parts->is_traced;
    if (status == BATTEN_OK)
        return bat_builder_finish(&builder, parts->is_solid, out);
    bat_builder_end(&builder);
    return status;
}
