/* The feature 'points': points that stand in the design itself. */
#include "design/feature.h"

#include <stdio.h>

static const batten_parameter parameters[] = {
    {"points", BATTEN_VALUE_POINT, true, true, NULL, NULL, "the points, in order"},
    {"columns", BATTEN_VALUE_COUNT, false, false, NULL, NULL,
     "this many points make one row; all in one row by default"},
};

static batten_status add_row(bat_run *run, const char *name, int count, const bat_item *items,
                             double *points)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            points[3 * i + k] = items[i].number[k];
    const batten_object row = {.name = name,
                               .layer = "",
                               .kind = BATTEN_OBJECT_POINTS,
                               .point_count = count,
                               .points = points};
    return bat_add(run, &row);
}

static batten_status run_points(bat_run *run)
{
    const bat_argument *all = bat_argument_of(run, "points");
    const int columns = bat_has(run, "columns") ? bat_count(run, "columns") : all->count;
    if (columns < 1 || all->count % columns)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d points do not make whole rows of %d",
                        all->count, columns);
    double *points = bat_array3((size_t)columns, 3, sizeof *points);
    batten_status status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < all->count / columns && status == BATTEN_OK; i++) {
        char name[32];
        snprintf(name, sizeof name, "row %d", i + 1);
        status = add_row(run, columns == all->count ? run->name : name, columns,
                         all->items + i * columns, points);
    }
    bat_release(points);
    return status;
}

const bat_feature bat_feature_points = {
    .shown =
        {"points", "Points that stand in the design itself",
         "A list of points, each [x, y, z] or [x, y] with z = 0, with units or in the unit of the\n"
         "design. With 'columns' the list is cut into rows of that many points: the form that\n"
         "interpolate-grid takes.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm]]}\n",
         "", "batten_model_add", BAT_PARAMETERS(parameters), false,
         .also = "point list, data points, ducks"},
    .run = run_points};
