/* How far the points given, and those after fairing, are from the nearest surface of a check. */
#include "design/outputs/fairness.h"
#include "design/shared/rows.h"

#include <batten/continuity.h>
#include <string.h>

/* ---- distances ---- */

typedef struct {
    int count, capacity;
    double *points;
} cloud;

static batten_status add_to_cloud(void *context, const bat_row *row)
{
    cloud *c = context;
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

static bool is_made_from(const bat_checked *checked, int feature)
{
    for (int i = 0; i < checked->data.count; i++)
        if (checked->data.at[i].feature == feature)
            return true;
    return false;
}

/* Of each point its distance from the nearest of the surfaces made from the same data. */
static batten_status nearest_surface(const bat_check *check, int feature, const cloud *all,
                                     double *nearest, double *distances)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < all->count; i++)
        nearest[i] = HUGE_VAL;
    for (int k = 0; k < check->object_count && status == BATTEN_OK; k++) {
        const batten_surface *surface = check->objects[k].object->surface;
        batten_deviation deviation;
        if (!surface || !is_made_from(&check->objects[k], feature))
            continue;
        status = batten_surface_deviation(surface, (batten_points){3, all->count, all->points},
                                          NULL, check->run->job, distances, &deviation);
        for (int i = 0; status == BATTEN_OK && i < all->count; i++)
            nearest[i] = bat_min(nearest[i], distances[i]);
    }
    return status;
}

static bat_data_distance sum_up(const char *feature, const cloud *all, const double *nearest)
{
    bat_data_distance sum = {.feature = feature, .count = all->count};
    double squares = 0;
    int worst = 0;
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
    cloud all = {0, 0, NULL};
    const int feature = root->feature;
    batten_status status = bat_check_visit_rows(check, feature, false, add_to_cloud, &all);
    double *nearest = bat_array3((size_t)all.count, 2, sizeof *nearest);
    if (status == BATTEN_OK && !nearest)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && all.count > 0)
        status = nearest_surface(check, feature, &all, nearest, nearest + all.count);
    if (status == BATTEN_OK && all.count > 0) {
        bat_data_distance *d = &checked->distances[checked->distance_count++];
        *d = sum_up(check->run->document->features[feature].name, &all, nearest);
        d->is_faired = root->is_faired;
        check->ok &= d->is_faired || d->max <= check->within;
        check->bounded_count += !d->is_faired;
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
