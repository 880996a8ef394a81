/* The unknown numbers of a fill. */
#include "shape/fill/fill.h"

#include "shape/fill/loops.h"
#include "support/faults.h"

static const double radii[] = {1, 1.2, 0.9, 1.1, 0.95, 1.15, 1.05, 0.9};

/* Of the loop of a hole, all given back by end_fields. */
static batten_status make_fields(const hole *h, bat_fill_loop *loop, batten_surface **planes,
                                 bat_fill *fill)
{
    batten_surface_fill_report report = {0};
    batten_status status = bat_fill_loop_make(h->count, h->ribbons, 1e-9, &report, loop);
    if (status == BATTEN_OK)
        status = bat_fill_plane(loop, planes);
    return status == BATTEN_OK ? bat_fill_make(loop, planes, fill) : status;
}

static void end_fields(int count, bat_fill_loop *loop, batten_surface **planes, bat_fill *fill)
{
    bat_fill_end(fill);
    for (int i = 0; i < count; i++)
        batten_surface_unref(planes[i]);
    bat_fill_loop_free(loop);
}

TEST(fields_know_which_sides_have_slopes_and_find_all_unknowns)
{
    for (int n = 3; n <= 6; n++)
        for (int bare = n % 2; bare < 2; bare++) {
            hole h;
            bat_fill_loop loop = {0};
            batten_surface *planes[BATTEN_FILL_SIDES] = {NULL};
            bat_fill fill = {0};
            hole_on_paraboloid(n, radii, 0.8, &h);
            if (bare)
                h.ribbons[1].slope = NULL;
            const batten_status status = make_fields(&h, &loop, planes, &fill);
            if (status == BATTEN_OK) {
                CHECK_INT(fill.count, n);
                CHECK_NEAR(fill.cosine, n == 4 ? 0 : cos(2 * 3.14159265358979323846 / n),
                           1e-15);
                for (int i = 0; i < n; i++) {
                    CHECK(fill.side[i].has_slope == (loop.sides[i].slope != NULL));
                    for (int u = 0; u < fill.unknowns; u++)
                        CHECK(isfinite(fill.x[u]));
                }
            } else {
                CHECK_STATUS(status, BATTEN_OUT_OF_MEMORY);
            }
            end_fields(n, &loop, planes, &fill);
            hole_free(&h);
        }
}

static batten_status make_once(const bat_fill_loop *loop, batten_surface **planes)
{
    bat_fill fill = {0};
    const batten_status status = bat_fill_make(loop, planes, &fill);
    bat_fill_end(&fill);
    return status;
}

TEST(fields_report_every_lack_of_memory)
{
    hole h;
    bat_fill_loop loop = {0};
    batten_surface *planes[BATTEN_FILL_SIDES] = {NULL};
    batten_surface_fill_report report = {0};
    hole_on_paraboloid(5, radii, 0.8, &h);
    if (bat_fill_loop_make(5, h.ribbons, 1e-9, &report, &loop) == BATTEN_OK &&
        bat_fill_plane(&loop, planes) == BATTEN_OK)
        CHECK_EACH_ALLOCATION(make_once(&loop, planes));
    for (int i = 0; i < 5; i++)
        batten_surface_unref(planes[i]);
    bat_fill_loop_free(&loop);
    hole_free(&h);
}
