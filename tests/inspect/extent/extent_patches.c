/* Patches of a surface, and which of their sides are creases. */
#include "inspect/extent/extent_patches.h"
#include "support/test.h"

static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
}

/* Knots of degree 2, breaks and creases: where a knot stands as often as the degree, but not at the ends. */
static const struct {
    int knot_count, spans;
    double knots[12], breaks[6];
    bool creases[6];
} rows[] = {
    {6, 1, {0, 0, 0, 1, 1, 1}, {0, 1}, {false, false}},
    {7, 2, {0, 0, 0, 1, 3, 3, 3}, {0, 1, 3}, {false, false, false}},
    {8, 2, {0, 0, 0, 1, 1, 3, 3, 3}, {0, 1, 3}, {false, true, false}},
    {10,
     4,
     {-1, -1, -1, 0, 1, 1, 2, 4, 4, 4},
     {-1, 0, 1, 2, 4},
     {false, false, true, false, false}},
    {11,
     4,
     {0, 0, 0, 1, 1, 2, 3, 3, 5, 5, 5},
     {0, 1, 2, 3, 5},
     {false, true, false, true, false}},
};

TEST(inner_knots_as_many_as_the_degree_are_creases_in_both_directions)
{
    only_once();
    for (int i = 0; i < COUNT(rows); i++)
        for (int j = 0; j < COUNT(rows); j++) {
            const batten_axis u = {2, rows[i].knot_count - 3, rows[i].knots, false},
                              v = {2, rows[j].knot_count - 3, rows[j].knots, false};
            double points[64];
            batten_surface *surface = NULL;
            bat_extent_patches p;
            for (int k = 0; k < 64; k++)
                points[k] = k * k % 17;
            CHECK_OK(batten_surface_create(1, &u, &v, points, NULL, &surface));
            const batten_status status = bat_extent_patches_begin(surface, &p);
            for (int k = 0; status == BATTEN_OK && k < 2; k++) {
                const int row = k ? j : i;
                CHECK_INT(p.spans[k], rows[row].spans);
                CHECK_INT(batten_surface_point_count(p.bezier, (batten_direction)k),
                          2 * rows[row].spans + 1);
                for (int at = 0; at <= rows[row].spans; at++) {
                    CHECK_BITS(p.breaks[k][at], rows[row].breaks[at]);
                    CHECK_INT(p.creases[k][at], rows[row].creases[at]);
                }
            }
            bat_extent_patches_end(&p);
            batten_surface_unref(surface);
            CHECK_OK(status);
        }
}

TEST(a_surface_of_degree_1_is_sharp_at_every_inner_knot)
{
    only_once();
    static const double knots[] = {0, 0, 1, 2, 2}, net[9] = {0, 1, 2, 5, 4, 3, 2, 2, 2};
    const batten_axis along = {1, 3, knots, false};
    batten_surface *surface = NULL;
    bat_extent_patches p;
    CHECK_OK(batten_surface_create(1, &along, &along, net, NULL, &surface));
    const batten_status status = bat_extent_patches_begin(surface, &p);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        CHECK_INT(p.spans[k], 2);
        CHECK(!p.creases[k][0] && p.creases[k][1] && !p.creases[k][2]);
    }
    bat_extent_patches_end(&p);
    batten_surface_unref(surface);
    CHECK_OK(status);
}
