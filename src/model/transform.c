/* Objects as affine maps take them. */
#include "base/base.h"

#include <batten/model.h>

#include <string.h>

static double *map_points(const batten_affine *map, int count, const double *points)
{
    double *mapped = bat_array3((size_t)count, 3, sizeof *mapped);
    for (int i = 0; mapped && i < count; i++) {
        const double *p = &points[3 * (size_t)i];
        const batten_vec3 at = batten_affine_apply(*map, (batten_vec3){p[0], p[1], p[2]});
        memcpy(&mapped[3 * (size_t)i], (const double[]){at.x, at.y, at.z}, 3 * sizeof *mapped);
    }
    return mapped;
}

/* Does what lies in the plane z = 0 stay there? */
static bool keeps_plane(const batten_affine *map)
{
    return map->m[2][0] == 0 && map->m[2][1] == 0 && map->t[2] == 0;
}

/* A chain stays a chain under maps that keep shapes; otherwise only its curve is kept. */
static batten_status map_chain(const batten_affine *map, const batten_chain *chain,
                               batten_chain **out)
{
    const batten_frame world = batten_frame_world();
    batten_chain *placed = NULL;
    batten_status status = BATTEN_OK;
    if (batten_chain_dimension(chain) < 3 && !keeps_plane(map))
        status = batten_chain_place(chain, &world, &placed);
    if (status == BATTEN_OK)
        status = batten_chain_transform(placed ? placed : chain, map, out);
    batten_chain_unref(placed);
    return status == BATTEN_BAD_ARGUMENT ? BATTEN_OK : status;
}

/* A plane curve that leaves its plane is lifted into space. */
static batten_status map_curve(const batten_affine *map, const batten_curve *curve,
                               batten_curve **out)
{
    batten_curve *lifted = NULL;
    if (keeps_plane(map))
        return batten_curve_transform(curve, map, out);
    batten_status status = batten_curve_to_dimension(curve, 3, &lifted);
    if (status == BATTEN_OK)
        status = batten_curve_transform(lifted, map, out);
    batten_curve_unref(lifted);
    return status;
}

/* What was made for one object. */
typedef struct {
    double *points;
    batten_curve *curve;
    batten_chain *chain;
    batten_surface *surface;
    batten_triangles *triangles;
    batten_body *body;
    batten_mesh *mesh;
} made;

static batten_status map_parts(const batten_object *object, const batten_affine *map, made *m)
{
    batten_status status = BATTEN_OK;
    if (object->point_count) {
        m->points = map_points(map, object->point_count, object->points);
        status = m->points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK && object->curve)
        status = map_curve(map, object->curve, &m->curve);
    if (status == BATTEN_OK && object->chain)
        status = map_chain(map, object->chain, &m->chain);
    if (status == BATTEN_OK && object->surface)
        status = batten_surface_transform_sides(object->surface, map, &m->surface);
    if (status == BATTEN_OK && object->triangles)
        status = batten_triangles_transform(object->triangles, map, &m->triangles);
    if (status == BATTEN_OK && object->body)
        status = batten_body_transform(object->body, map, &m->body);
    if (status == BATTEN_OK && object->mesh)
        status = batten_mesh_transform(object->mesh, map, &m->mesh);
    return status;
}

batten_status batten_model_add_mapped(batten_model *model, const batten_object *object,
                                      const batten_affine *map)
{
    batten_object mapped = *object;
    made m = {0};
    if (object->kind == BATTEN_OBJECT_OFFSET_TABLE)
        return bat_fail(
            BATTEN_UNSUPPORTED,
            "'%s' is a table of offsets, which cannot be moved; 'read' can scale and turn "
            "it, and the curves through it can be moved",
            object->name);
    batten_status status = map_parts(object, map, &m);
    mapped.points = m.points;
    mapped.curve = m.curve;
    mapped.chain = m.chain;
    mapped.surface = m.surface;
    mapped.triangles = m.triangles;
    mapped.body = m.body;
    mapped.mesh = m.mesh;
    if (object->kind == BATTEN_OBJECT_INSTANCE)
        mapped.place = batten_affine_compose(object->place, *map);
    if (status == BATTEN_OK)
        status = batten_model_add(model, &mapped);
    bat_release(m.points);
    batten_curve_unref(m.curve);
    batten_chain_unref(m.chain);
    batten_surface_unref(m.surface);
    batten_triangles_unref(m.triangles);
    batten_body_unref(m.body);
    batten_mesh_unref(m.mesh);
    return status;
}
