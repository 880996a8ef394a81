/* How a surface continues the one beside it. */
#include <batten/coons.h>
#include <batten/skin.h>

#include "support/test.h"

static const double ends[] = {0, 0, 1, 1};

/* The bilinear surface between (0, 0, 0), (0, 1, 0) and the same moved by `along`, run along the common edge
 * backwards when told. */
static batten_surface *strip(batten_vec3 along, bool backwards)
{
    const double y[2] = {backwards, !backwards};
    const double points[] = {0, y[0], 0, along.x, y[0] + along.y, along.z,
                             0, y[1], 0, along.x, y[1] + along.y, along.z};
    const batten_axis axis = {1, 2, ends, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

static const struct {
    batten_vec3 along;
    bool backwards;
    double angle;
} neighbours[] = {
    {{-1, 0, 0}, false, 0},
    {{-1, 0.3, 0}, true, 0},
    {{-1, 0, -1}, false, 0.78539816339744831},
    {{-1, 0.2, -1}, true, 0.78539816339744831},
    {{-1, 0, 1}, true, 0.78539816339744831},
    {{1, 0, 0.01}, false, 3.1315929869031574}, /* it turns back: pi - atan 0.01 */
};

TEST(the_angle_between_a_surface_and_its_neighbour_is_that_of_their_planes)
{
    batten_surface *surface = strip((batten_vec3){1, 0, 0}, false);
    for (int i = 0; i < COUNT(neighbours); i++) {
        batten_surface *beside = strip(neighbours[i].along, neighbours[i].backwards);
        batten_edge_join join = {0};
        CHECK_OK(batten_surface_edge_join((batten_surface_edge){surface, BATTEN_EDGE_V0},
                                          beside, 1e-6, &join));
        CHECK_NEAR(join.angle, neighbours[i].angle, 1e-12);
        CHECK_NEAR(join.gap, 0, 1e-12);
        CHECK_NEAR(join.curvature_difference, 0, 1e-12);
        batten_surface_unref(beside);
    }
    batten_surface_unref(surface);
}

/* A quarter of a cylinder of radius 2 about (0, y, 2), from below; it leaves (0, y, 0) in the direction of -x. */
static batten_surface *cylinder(void)
{
    const double w = sqrt(0.5), weights[] = {1, w, 1}, knots[] = {0, 0, 0, 1, 1, 1};
    const double points[] = {0, 0, 0, -2, 0, 0, -2, 0, 2};
    batten_curve *arc = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, weights, knots, &arc));
    CHECK_OK(batten_surface_extruded(arc, (batten_vec3){0, 3, 0}, &surface));
    batten_curve_unref(arc);
    return surface;
}

TEST(a_plane_beside_a_cylinder_differs_by_its_curvature)
{
    batten_surface *plane = strip((batten_vec3){1, 0, 0}, false), *round = cylinder();
    batten_edge_join join = {0};
    /* The edge of the plane runs along a part of that of the cylinder. */
    CHECK_OK(batten_surface_edge_join((batten_surface_edge){plane, BATTEN_EDGE_V0}, round, 1e-6,
                                      &join));
    CHECK_NEAR(join.angle, 0, 1e-12);
    CHECK_NEAR(join.curvature, 0.5, 1e-12);
    CHECK_NEAR(join.curvature_difference, 0.5, 1e-12);
    batten_surface_unref(round);
    batten_surface_unref(plane);
}

TEST(surfaces_without_a_common_edge_are_refused)
{
    batten_surface *plane = strip((batten_vec3){1, 0, 0}, false), *round = cylinder();
    batten_edge_join join = {.gap = -1};
    CHECK_STATUS(batten_surface_edge_join((batten_surface_edge){plane, BATTEN_EDGE_V1}, round,
                                          1e-6, &join),
                 BATTEN_NOT_FOUND);
    CHECK_MESSAGE("no edge of the surface runs along the curve");
    CHECK(join.gap == -1);
    batten_surface_unref(round);
    batten_surface_unref(plane);
}
