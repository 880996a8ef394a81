/* Which edges of a mesh are smooth, from the angles between its triangles. */
#include "picture/shaded/smooth_edges.h"

static const double one_degree = BAT_PI / 180;

/* The edges of one set; its patches begin at `sides`. */
static batten_status mark_set(const batten_triangles *triangles, double tolerance,
                              unsigned char *sides)
{
    /* Edge i lies opposite corner i; the patch has corner 0 at u = 0. */
    static const unsigned char side_of[3] = {BAT_SIDE_U1, BAT_SIDE_V1, BAT_SIDE_V0};
    batten_triangle_joins joins = {0, NULL};
    for (int t = 0; t < batten_triangles_count(triangles); t++)
        sides[t] |= BAT_SIDE_U0; /* the pole is a point */
    const batten_status status = batten_triangles_joins(triangles, tolerance, &joins);
    for (int i = 0; status == BATTEN_OK && i < joins.count; i++)
        for (int k = 0; k < 2; k++)
            if (joins.at[i].angle >= 0 && joins.at[i].angle < one_degree &&
                joins.at[i].gap <= tolerance)
                sides[joins.at[i].triangle[k]] |= side_of[joins.at[i].edge[k]];
    batten_triangle_joins_release(&joins);
    return status;
}

batten_status bat_smooth_edges(const batten_model *model, const batten_model *patched,
                               unsigned char **sides)
{
    const int total = batten_model_count(patched);
    unsigned char *made = bat_array((size_t)total, sizeof *made);
    batten_box box = {{0, 0, 0}, {0, 0, 0}};
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    batten_model_box(model, &box);
    const double size = bat_max(box.high.x - box.low.x,
                                bat_max(box.high.y - box.low.y, box.high.z - box.low.z));
    batten_status status = BATTEN_OK;
    int at = 0;
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->kind == BATTEN_OBJECT_TRIANGLES && size > 0)
            /* Edges are the same when they are within a millionth of the model: a thousandth of a pixel. */
            status = mark_set(object->triangles, 1e-6 * size, made + at);
        at += object->kind == BATTEN_OBJECT_TRIANGLES
                  ? batten_triangles_count(object->triangles)
                  : 1;
    }
    if (status == BATTEN_OK)
        *sides = made;
    else
        bat_release(made);
    return status;
}
