/* Points as the first and last of several curves. */
#include "design/shared/tips.h"
#include "base/plural.h"

/* The curve that stands still in a point. */
static batten_status take_tip(const batten_object *object, bool is_end, batten_curve **out)
{
    static const double knots[] = {0, 0, 1, 1};
    double points[6];
    if (!is_end || object->point_count != 1)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%s' is %d point%s: one point may be the first or the last section; "
                        "'interpolate' makes a curve through several",
                        object->name, object->point_count, bat_plural(object->point_count));
    for (int i = 0; i < 6; i++)
        points[i] = object->points[i % 3];
    return batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, out);
}

batten_status bat_take_tipped(const bat_objects *all, bat_tipped *out)
{
    *out = (bat_tipped){.curves = bat_array((size_t)all->count, sizeof *out->curves)};
    batten_status status = out->curves ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < all->count && status == BATTEN_OK; i++) {
        const batten_object *object = all->at[i];
        out->curves[i] = object->curve;
        if (object->kind == BATTEN_OBJECT_CURVE)
            continue;
        status = take_tip(object, i == 0 || i == all->count - 1, &out->tips[i > 0]);
        out->curves[i] = out->tips[i > 0];
    }
    return status;
}

void bat_tipped_release(bat_tipped *tipped)
{
    batten_curve_unref(tipped->tips[0]);
    batten_curve_unref(tipped->tips[1]);
    bat_release(tipped->curves);
    *tipped = (bat_tipped){NULL};
}
