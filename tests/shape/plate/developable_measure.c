/* Warp and edge of regression of ruled surfaces with closed forms. */
#include "shape/plate/developable_parts.h"

#include "shape/plate/plates.h"

#include <batten/skin.h>

static const double right = 1.5707963267948966;

static batten_developable measured(const double *first, const double *second, int count,
                                   const double *knots, double warp)
{
    batten_developable out = {0};
    batten_curve *edges[2] = {NULL, NULL};
    batten_surface_developable_options options = batten_surface_developable_defaults();
    options.warp = warp;
    CHECK_OK(batten_curve_create((batten_points){3, count, first}, count == 2 ? 1 : 2, NULL,
                                 knots, &edges[0]));
    CHECK_OK(batten_curve_create((batten_points){3, count, second}, count == 2 ? 1 : 2, NULL,
                                 knots, &edges[1]));
    CHECK_OK(batten_surface_ruled(edges[0], edges[1], &out.surface));
    CHECK_OK(bat_plate_measure(&options, &out));
    drop(edges[0], edges[1]);
    batten_surface_unref(out.surface);
    out.surface = NULL;
    return out;
}

static const double unit[] = {0, 0, 1, 1}, square[] = {0, 0, 0, 1, 1, 1};

/* Between the x axis and a line above it, turned by an angle: rulings at the start stand upright, where the
 * normals differ by that angle. */
TEST(the_warp_of_a_twisted_strip_is_the_largest_along_it)
{
    for (int i = 1; i <= 3; i++) {
        const double angle = 0.2 * i;
        const double first[] = {0, 0, 0, 1, 0, 0},
                     second[] = {0, 0, 1, cos(angle), sin(angle), 1};
        const batten_developable of = measured(first, second, 2, unit, 0.3);
        CHECK_NEAR(of.warp, angle, 1e-14);
        CHECK(of.warp_at == 0 && !of.has_regression);
        CHECK(of.is_developable == (angle <= 0.3));
        const double turned[] = {-1, 0, 0, 0, 0, 0},
                     end[] = {-cos(angle), -sin(angle), 1, 0, 0, 1};
        const batten_developable other = measured(turned, end, 2, unit, 0.3);
        CHECK_NEAR(other.warp, angle, 1e-14);
        CHECK(other.warp_at == 1);
    }
}

TEST(a_warp_of_just_as_much_as_is_allowed_is_developable)
{
    static const double first[] = {0, 0, 0, 1, 0, 0}, second[] = {0, 0, 1, 0.8, 0.6, 1};
    const double warp = measured(first, second, 2, unit, 1).warp;
    CHECK(measured(first, second, 2, unit, warp).is_developable);
    CHECK(!measured(first, second, 2, unit, nextafter(warp, 0)).is_developable);
}

TEST(planes_cylinders_and_cones_have_no_warp)
{
    static const double line[] = {0, 0, 0, 1, 0, 0}, above[] = {0, 1, 0, 2, 1, 0},
                        point[] = {0, 0, 2, 0, 0, 2};
    static const double low[] = {0, 0, 0, 1, 1, 0, 2, 0, 0},
                        high[] = {0, 0, 3, 1, 1, 3, 2, 0, 3};
    static const double apex[] = {1, 0, 5, 1, 0, 5, 1, 0, 5};
    const batten_developable of[] = {
        measured(line, above, 2, unit, 1e-9), measured(line, point, 2, unit, 1e-9),
        measured(low, high, 3, square, 1e-9), measured(low, apex, 3, square, 1e-9),
        measured(apex, low, 3, square, 1e-9)};
    for (int i = 0; i < COUNT(of); i++)
        CHECK(of[i].warp < 1e-12 && of[i].is_developable && !of[i].has_regression);
}

/* In a plane, rulings from (u, 0) to (1 - 2 u, 1) .. move to opposite sides, as 1 to 2: they meet at a third. */
TEST(rulings_that_meet_are_an_edge_of_regression_with_its_share)
{
    static const double first[] = {0, 0, 0, 1, 0, 0}, second[] = {1, 1, 0, -1, 1, 0};
    const batten_developable of = measured(first, second, 2, unit, 0.3);
    CHECK(of.has_regression && !of.is_developable);
    CHECK(of.regression_at == 0);
    CHECK_NEAR(of.regression_share, 1.0 / 3, 1e-14);
    CHECK_NEAR(of.warp, 2 * right, 1e-14);
    const batten_developable other = measured(second, first, 2, unit, 0.3);
    CHECK_NEAR(other.regression_share, 2.0 / 3, 1e-14);
}

/* Parabolas that turn back together: the normal changes sides at their vertices, u = 1/2. */
TEST(rulings_that_change_sides_are_found)
{
    static const double first[] = {0, 0, 0, 1, 0, 0, 0, 0, 0},
                        second[] = {0, 1, 0, 1, 1, 0, 0, 1, 0};
    const batten_developable of = measured(first, second, 3, square, 0.3);
    CHECK_NEAR(of.warp, 2 * right, 1e-14);
    CHECK_NEAR(of.warp_at, 0.75, 1e-15);
    CHECK(!of.is_developable);
}
