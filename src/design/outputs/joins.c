/* The joins of all that is checked: of its curves, of its surfaces, and of the faces of its bodies. */
#include "design/outputs/fairness.h"

#include <stdlib.h>

/* The objects of one kind, with their numbers among all. */
typedef struct {
    int count;
    const void **shapes;
    int *objects;
} chosen;

static batten_status choose(const bat_check *check, batten_object_kind kind, chosen *out)
{
    const size_t count = (size_t)check->object_count;
    *out = (chosen){0, bat_array(count, sizeof *out->shapes),
                    bat_array(count, sizeof *out->objects)};
    if (!out->shapes || !out->objects)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < check->object_count; i++) {
        const batten_object *object = check->objects[i].object;
        if (object->kind != kind)
            continue;
        out->shapes[out->count] =
            kind == BATTEN_OBJECT_CURVE ? (const void *)object->curve : object->surface;
        out->objects[out->count++] = i;
    }
    return BATTEN_OK;
}

/* `from`: the objects that the numbers of shapes are of; NULL for faces. */
static batten_status keep_joins(bat_check *check, const chosen *from, const batten_joins *found)
{
    bat_join *grown = bat_resize(
        check->joins, (size_t)check->join_count + (size_t)found->count + 1, sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    check->joins = grown;
    for (int i = 0; i < found->count; i++) {
        bat_join *join = &check->joins[check->join_count++];
        *join = (bat_join){found->at[i], {-1, -1}, false, false};
        for (int k = 0; from && k < 2; k++)
            join->of.shape[k] = from->objects[join->of.shape[k]];
    }
    if (found->left_out)
        bat_note(check->run, "more than %d joins; the others are not listed", found->count);
    return BATTEN_OK;
}

/* Ends of curves where more than two meet. */
static batten_status mark_branches(bat_check *check)
{
    int(*met)[2] = bat_array((size_t)check->object_count + 1, sizeof *met);
    if (!met)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < check->join_count; i++)
        for (int k = 0; k < 2; k++)
            met[check->joins[i].of.shape[k]][check->joins[i].of.side[k]]++;
    for (int i = 0; i < check->join_count; i++)
        for (int k = 0; k < 2; k++)
            check->joins[i].is_branch |=
                met[check->joins[i].of.shape[k]][check->joins[i].of.side[k]] > 1;
    bat_release(met);
    return BATTEN_OK;
}

static batten_status add_joins(bat_check *check, batten_object_kind kind)
{
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_joins found = {0, NULL, false};
    chosen from;
    bounds.gap = bat_tolerance(check->run);
    batten_status status = choose(check, kind, &from);
    if (status == BATTEN_OK && kind == BATTEN_OBJECT_CURVE)
        status = batten_curves_joins(from.count, (const batten_curve *const *)from.shapes,
                                     &bounds, check->run->job, &found);
    if (status == BATTEN_OK && kind == BATTEN_OBJECT_SURFACE) {
        bounds.angle = BAT_EDGE_ANGLE;
        bounds.curvature = BAT_EDGE_CURVATURE;
        status = batten_surfaces_joins(from.count, (const batten_surface *const *)from.shapes,
                                       &bounds, check->run->job, &found);
    }
    if (status == BATTEN_OK)
        status = keep_joins(check, &from, &found);
    batten_joins_release(&found);
    bat_release(from.objects);
    bat_release(from.shapes);
    return status;
}

/* Faces of a body, within its own tolerance. */
static batten_status add_faces(bat_check *check, int object)
{
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_joins found = {0, NULL, false};
    bounds.angle = BAT_EDGE_ANGLE;
    bounds.curvature = BAT_EDGE_CURVATURE;
    batten_status status = batten_body_joins(check->objects[object].object->body, &bounds,
                                             check->run->job, &found);
    const int before = check->join_count;
    if (status == BATTEN_OK)
        status = keep_joins(check, NULL, &found);
    for (int i = before; i < check->join_count; i++) {
        bat_join *join = &check->joins[i];
        for (int k = 0; k < 2; k++) {
            join->face[k] = join->of.shape[k];
            join->of.shape[k] = object;
        }
    }
    batten_joins_release(&found);
    return status;
}

static int by_shape(const void *a, const void *b)
{
    const batten_join *x = &((const bat_join *)a)->of, *y = &((const bat_join *)b)->of;
    const int p[6] = {x->shape[0], x->shape[1], x->edge, x->side[0], x->side[1], x->part};
    const int q[6] = {y->shape[0], y->shape[1], y->edge, y->side[0], y->side[1], y->part};
    for (int k = 0; k < 6; k++)
        if (p[k] != q[k])
            return p[k] < q[k] ? -1 : 1;
    return 0;
}

batten_status bat_joins_find(bat_check *check)
{
    batten_status status = add_joins(check, BATTEN_OBJECT_CURVE);
    if (status == BATTEN_OK)
        status = mark_branches(check);
    if (status == BATTEN_OK)
        status = add_joins(check, BATTEN_OBJECT_SURFACE);
    for (int i = 0; i < check->object_count && status == BATTEN_OK; i++)
        if (check->objects[i].object->kind == BATTEN_OBJECT_BODY)
            status = add_faces(check, i);
    if (status == BATTEN_OK && check->join_count)
        qsort(check->joins, (size_t)check->join_count, sizeof *check->joins, by_shape);
    return status;
}

const char *bat_side_name(const batten_object *object, int side)
{
    static const char *const curve_sides[] = {"start", "end"};
    static const char *const surface_sides[] = {"u low", "u high", "v low", "v high"};
    return object->kind == BATTEN_OBJECT_CURVE ? curve_sides[side] : surface_sides[side];
}
