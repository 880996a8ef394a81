#include "design/outputs/checked.h"

/* How smoothly edges join where several places of one edge are the same point. */

/* A sheet about the unit square on its corner, whose sides are its edge v = 0; outwards the corners go to `end` times
 * as far. With the distance from the edge it rises as a parabola does, by `rise[i]` at corner i; the last corner is the
 * first again, and need not rise as that does. */
static batten_surface *collar(double end, const double rise[5])
{
    static const double corners[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    static const double along[] = {0, 0, 1, 2, 3, 4, 4}, out[] = {0, 0, 0, 1, 1, 1};
    double points[5 * 3 * 3];
    batten_surface *surface = NULL;
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++) {
            double *p = points + 3 * (3 * i + k);
            p[0] = corners[i][0] * (1 + (end - 1) * k / 2);
            p[1] = corners[i][1] * (1 + (end - 1) * k / 2);
            p[2] = k == 2 ? rise[i] * (end - 1) * (end - 1) : 0;
        }
    CHECK_OK(batten_surface_create(3, &(batten_axis){1, 5, along, false},
                                   &(batten_axis){2, 3, out, false}, points, NULL, &surface));
    return surface;
}

static const bat_join *join_of(checked_design *d, const double first[5], double first_end,
                               const double second[5], double second_end)
{
    checked_open("  a: {points: [[0, 0, 0]]}\n  b: {points: [[0, 0, 0]]}\n", "[a, b]", d);
    checked_put_surface(d, "a", collar(first_end, first));
    checked_put_surface(d, "b", collar(second_end, second));
    checked_run(d, HUGE_VAL);
    CHECK_INT(d->check.join_count, 1);
    const bat_join *join = d->check.joins;
    CHECK(join->of.shape[0] == 0 && join->of.shape[1] == 1 && join->of.part == -1);
    CHECK_TEXT(bat_side_name(d->check.objects[0].object, join->of.side[0]), "v low");
    CHECK_TEXT(bat_side_name(d->check.objects[1].object, join->of.side[1]), "v low");
    CHECK_NEAR(join->of.gap.value, 0, 1e-12);
    return join;
}

TEST(where_a_closed_edge_meets_itself_the_place_that_agrees_best_counts)
{
    static const double rise[] = {0, 0.25, 0.5, 0.75, 1}, back[] = {1, 0.75, 0.5, 0.25, 0};
    static const double *const rises[] = {rise, back};
    for (int i = 0; i < COUNT(rises); i++)
        for (int k = 0; k < 2; k++) {
            checked_design d;
            const bat_join *join = join_of(&d, rises[i], k ? 0.5 : 2, rises[i], k ? 2 : 0.5);
            CHECK_NEAR(join->of.angle.value, 0, 1e-9);
            CHECK_NEAR(join->of.curvature.value, 0, 1e-6);
            CHECK_INT(d.check.unfairness.creases + d.check.unfairness.edge_jumps, 0);
            checked_close(&d);
        }
}

TEST(curvatures_across_a_closed_edge_differ_by_a_share_of_the_larger)
{
    static const double low[] = {1, 1, 1, 1, 2}, high[] = {4, 4, 4, 4, 8};
    checked_design d;
    const bat_join *join = join_of(&d, low, 2, high, 0.5);
    CHECK_NEAR(join->of.angle.value, 0, 1e-9);
    CHECK_NEAR(join->of.curvature.value, 0.75, 1e-6);
    CHECK_INT(d.check.unfairness.edge_jumps, 1);
    CHECK_INT(d.check.unfairness.creases, 0);
    checked_close(&d);
}
