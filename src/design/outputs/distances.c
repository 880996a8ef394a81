/* How far the points given, and those after fairing, are from the nearest surface of a check. */
#include "design/outputs/fairness.h"
#include "design/shared/rows.h"

#include <batten/continuity.h>
#include <string.h>

/* ---- clouds ---- */

static batten_status add_to_cloud(void *context, const bat_row *row)
{
    bat_cloud *c = context;
    if (row->count == 0)
        return BATTEN_OK;
    double *grown = bat_resize(c->points, 3 * (size_t)(c->count + row->count), sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    c->points = grown;
    memcpy(grown + 3 * c->count, row->points, 3 * (size_t)row->count * sizeof *grown);
    c->count += row->count;
    return BATTEN_OK;
}

batten_status bat_cloud_of(const bat_check *check, int feature, bat_cloud *out)
{
    *out = (bat_cloud){0, NULL};
    return bat_check_visit_rows(check, feature, false, add_to_cloud, out);
}

batten_status bat_cloud_approach(const bat_check *check, const bat_cloud *cloud,
                                 const batten_object *object, double *room, double *nearest)
{
    const batten_points points = {3, cloud->count, cloud->points};
    batten_curve *space = NULL;
    batten_deviation deviation;
    batten_status status;
    if (object->kind == BATTEN_OBJECT_SURFACE) {
        status = batten_surface_deviation(object->surface, points, NULL, check->run->job, room,
                                          &deviation);
    } else {
        status = batten_curve_to_dimension(object->curve, 3, &space);
        if (status == BATTEN_OK)
            status = batten_curve_deviation(space, points, NULL, check->run->job, room,
                                            &deviation);
        batten_curve_unref(space);
    }
    for (int i = 0; status == BATTEN_OK && i < cloud->count; i++)
        nearest[i] = bat_min(nearest[i], room[i]);
    return status;
}

/* ---- distances ---- */

static bool is_made_from(const bat_checked *checked, int feature)
{
    const bool is_surface = checked->object->kind == BATTEN_OBJECT_SURFACE;
    for (int i = 0; i < checked->data.count; i++)
        if (checked->data.at[i].feature == feature)
            return is_surface || bat_check_is_cut(checked);
    return false;
}

/* Of each point its distance from the nearest of the shapes made from the same data. */
static batten_status nearest_shape(const bat_check *check, int feature, const bat_cloud *all,
                                   double *nearest, double *room)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < all->count; i++)
        nearest[i] = HUGE_VAL;
    for (int k = 0; k < check->object_count && status == BATTEN_OK; k++)
        if (is_made_from(&check->objects[k], feature))
            status =
                bat_cloud_approach(check, all, check->objects[k].object, room, nearest);
    return status;
}

/* Only points that stay on one of the shapes made from them. */
static int leave_out(const bat_check *check, int feature, bat_cloud *all)
{
    int kept = 0;
    for (int i = 0; i < all->count; i++) {
        bool stays = false;
        for (int k = 0; k < check->object_count; k++) {
            const bat_data_roots *data = &check->objects[k].data;
            for (int r = 0; r < data->count && is_made_from(&check->objects[k], feature); r++)
                stays |= data->at[r].feature == feature &&
                         (!data->at[r].stays || data->at[r].stays[i]);
        }
        if (stays)
            memmove(all->points + 3 * kept++, all->points + 3 * i, 3 * sizeof *all->points);
    }
    const int left_out = all->count - kept;
    all->count = kept;
    return left_out;
}

static bat_data_distance sum_up(const char *feature, const bat_cloud *all, const double *nearest)
{
    bat_data_distance sum = {.feature = feature, .count = all->count};
    double squares = 0;
    int worst = 0;
    sum.max = sum.rms = sum.worst[0] = sum.worst[1] = sum.worst[2] = NAN;
    if (all->count == 0)
        return sum;
    for (int i = 0; i < all->count; i++) {
        squares += nearest[i] * nearest[i];
        worst = nearest[i] > nearest[worst] ? i : worst;
    }
    sum.max = nearest[worst];
    sum.rms = sqrt(squares / all->count);
    memcpy(sum.worst, all->points + 3 * worst, sizeof sum.worst);
    return sum;
}

static batten_status add_distance(bat_check *check, bat_checked *checked,
                                  const bat_data_root *root)
{
    bat_cloud all;
    const int feature = root->feature;
    batten_status status = bat_cloud_of(check, feature, &all);
    const int left_out = status == BATTEN_OK ? leave_out(check, feature, &all) : 0;
    double *nearest = bat_array3((size_t)all.count, 2, sizeof *nearest);
    if (status == BATTEN_OK && !nearest)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && all.count > 0)
        status = nearest_shape(check, feature, &all, nearest, nearest + all.count);
    if (status == BATTEN_OK && all.count + left_out > 0) {
        bat_data_distance *d = &checked->distances[checked->distance_count++];
        *d = sum_up(check->run->document->features[feature].name, &all, nearest);
        d->is_faired = root->is_faired;
        d->left_out = left_out;
        check->ok &= d->is_faired || !(d->max > check->within);
        check->bounded_count += !d->is_faired && d->count;
    }
    bat_release(nearest);
    bat_release(all.points);
    return status;
}

batten_status bat_check_add_distances(bat_check *check, bat_checked *checked)
{
    checked->distances =
        bat_arena_array(&check->arena, (size_t)checked->data.count, sizeof *checked->distances);
    batten_status status = checked->distances ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < checked->data.count && status == BATTEN_OK; i++)
        status = add_distance(check, checked, &checked->data.at[i]);
    return status;
}
