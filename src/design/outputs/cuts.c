/* Which of the points given still belong to a shape: not those on what was cut off, nor where a table says that no hull is. */
#include "design/outputs/fairness.h"

#include <string.h>

/* The points of one root, followed from feature to feature. */
typedef struct {
    bat_check *check;
    const bool *passed;
    bat_cloud cloud;
    bool **stays;  /* [feature][point]; NULL where none of them come by */
    double *rooms; /* [3][point] */
    bool is_cut;   /* by a feature on the way */
    bool has_room;
} follower;

static bool *stays_at(follower *f, int feature)
{
    if (!f->stays[feature])
        f->stays[feature] =
            bat_arena_array(&f->check->arena, (size_t)f->cloud.count, sizeof **f->stays);
    f->has_room &= f->stays[feature] != NULL;
    return f->stays[feature];
}

/* What comes by several ways stays when it does by one of them. */
static void take_over(void *context, int parent, int child)
{
    follower *f = context;
    if (!f->passed[parent] || !f->stays[parent])
        return;
    bool *stays = stays_at(f, child);
    for (int i = 0; stays && i < f->cloud.count; i++)
        stays[i] |= f->stays[parent][i];
}

/* How near the curves and surfaces of a model come to the points; infinity without any. */
static batten_status approach(const follower *f, const batten_model *model, double *nearest)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; model && i < batten_model_count(model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->kind == BATTEN_OBJECT_CURVE || object->kind == BATTEN_OBJECT_SURFACE)
            status = bat_cloud_approach(f->check, &f->cloud, object, f->rooms, nearest);
    }
    return status;
}

/* A point whose distance grows by the cut has its foot on what was cut off. */
static batten_status cut(follower *f, int feature)
{
    const bat_run *run = f->check->run;
    const bat_entry *entry = &run->document->features[feature];
    const int count = f->cloud.count;
    double *before = f->rooms + count, *after = before + count;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < 2 * count; i++)
        before[i] = HUGE_VAL;
    for (int i = 0; i < entry->arguments[0].count && status == BATTEN_OK; i++) {
        const int input = entry->arguments[0].items[i].count;
        if (input >= 0)
            status = approach(f, run->results[input].value, before);
    }
    if (status == BATTEN_OK)
        status = approach(f, run->results[feature].value, after);
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        if (isfinite(before[i]))
            f->stays[feature][i] &= after[i] <= before[i] + bat_tolerance(run);
    f->is_cut = true;
    return status;
}

/* Points that moved, by the numbers of a table whose stations have `count` points in all. */
static void mark_moved(const batten_loft_report *loft, int count, bool *moved)
{
    for (int c = 0; c < loft->correction_count; c++) {
        int at = loft->corrections[c].index;
        for (int k = 0; k < loft->corrections[c].station; k++)
            at += batten_offset_table_station(loft->faired, k)->point_count;
        if (at < count)
            moved[at] = true;
    }
}

/* A lofting names every point of its table that the surface is not at: others that lie off it are those that only say
 * that there is no hull. */
static batten_status leave_no_hull(follower *f, int feature)
{
    const bat_run *run = f->check->run;
    const batten_loft_report *loft = run->results[feature].shown.loft;
    follower table = {.check = f->check, .rooms = f->rooms};
    double *off = f->rooms + f->cloud.count;
    bool *moved = bat_array((size_t)f->cloud.count, sizeof *moved);
    batten_status status = moved ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_cloud_of(
            f->check, run->document->features[feature].arguments[0].items[0].count,
            &table.cloud);
    for (int i = 0; i < f->cloud.count; i++)
        off[i] = HUGE_VAL;
    const bool is_alike = table.cloud.count == f->cloud.count; /* else it is not this table */
    if (status == BATTEN_OK && is_alike) {
        mark_moved(loft, f->cloud.count, moved);
        status = approach(&table, run->results[feature].value, off);
    }
    for (int i = 0; i < f->cloud.count && status == BATTEN_OK && is_alike; i++)
        f->stays[feature][i] &= moved[i] || !(off[i] > bat_tolerance(run));
    f->is_cut |= is_alike;
    bat_release(table.cloud.points);
    bat_release(moved);
    return status;
}

static bool leaves_points_out(const bat_check *check, int feature)
{
    const batten_loft_report *loft = check->run->results[feature].shown.loft;
    return loft && loft->trimmed_count > 0;
}

static batten_status follow(follower *f, int last, const bat_data_root *root)
{
    const bat_document *d = f->check->run->document;
    bool *stays = stays_at(f, root->feature);
    for (int i = 0; stays && i < f->cloud.count; i++)
        stays[i] = true;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < d->feature_count && status == BATTEN_OK && f->has_room; k++) {
        const int i = d->order[k];
        if (!f->passed[i] || i == root->feature)
            continue;
        bat_check_visit_parents(f->check, i, take_over, f);
        if (f->has_room && f->stays[i] && d->features[i].feature->cuts)
            status = cut(f, i);
        else if (f->has_room && f->stays[i] && leaves_points_out(f->check, i))
            status = leave_no_hull(f, i);
        if (i == last)
            break;
    }
    return f->has_room ? status : BATTEN_OUT_OF_MEMORY;
}

static bool passes_a_cut(const bat_check *check, const bool *passed)
{
    const bat_document *d = check->run->document;
    for (int i = 0; i < d->feature_count; i++)
        if (passed[i] && (d->features[i].feature->cuts || leaves_points_out(check, i)))
            return true;
    return false;
}

static batten_status cut_root(bat_check *check, const bool *passed, int feature,
                              bat_data_root *root)
{
    follower f = {.check = check, .passed = passed, .has_room = true};
    batten_status status = bat_cloud_of(check, root->feature, &f.cloud);
    f.stays = bat_array((size_t)check->run->document->feature_count, sizeof *f.stays);
    f.rooms = bat_array3((size_t)f.cloud.count, 3, sizeof *f.rooms);
    if (status == BATTEN_OK && (!f.stays || !f.rooms))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && f.cloud.count)
        status = follow(&f, feature, root);
    if (status == BATTEN_OK && f.is_cut)
        root->stays = f.stays[feature];
    bat_release(f.rooms);
    bat_release(f.stays);
    bat_release(f.cloud.points);
    return status;
}

/* The objects of one feature share their roots. */
batten_status bat_check_cuts(bat_check *check)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < check->object_count && status == BATTEN_OK; i++) {
        const bat_data_roots *data = &check->objects[i].data;
        if ((i > 0 && data->at == check->objects[i - 1].data.at) ||
            !passes_a_cut(check, data->passed))
            continue;
        for (int k = 0; k < data->count && status == BATTEN_OK; k++)
            if (data->at[k].feature != data->feature)
                status = cut_root(check, data->passed, data->feature, &data->at[k]);
    }
    return status;
}
