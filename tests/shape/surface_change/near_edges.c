/* Which edges of two surfaces belong together. */
#include <batten/continuity.h>

#include "support/test.h"

/* The unit square moved by (x, y, z). */
static batten_surface *square(double x, double y, double z)
{
    const double corners[12] = {x, y, z, x, y + 1, z, x + 1, y, z, x + 1, y + 1, z};
    const double knots[4] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, corners, NULL, &surface));
    return surface;
}

static const struct {
    double shift[3];
    batten_edge first, second;
    double apart;
} rows[] = {
    {{1.5, 0, 0}, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 0.5},
    {{-1.25, 0, 0}, BATTEN_EDGE_U0, BATTEN_EDGE_U1, 0.25},
    {{0, 3, 0}, BATTEN_EDGE_V1, BATTEN_EDGE_V0, 2},
    {{0, -1, 0}, BATTEN_EDGE_V0, BATTEN_EDGE_V1, 0},
    {{1, 0.75, 1}, BATTEN_EDGE_U1, BATTEN_EDGE_U0, 1.25},
    {{0, 0, 2}, BATTEN_EDGE_V0, BATTEN_EDGE_V0, 2}, /* of equal ones the first */
};

TEST(the_edges_whose_ends_are_nearest_belong_together)
{
    batten_surface *first = square(0, 0, 0);
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface *second = square(rows[i].shift[0], rows[i].shift[1], rows[i].shift[2]);
        batten_edge edges[2] = {BATTEN_EDGE_U0, BATTEN_EDGE_U0};
        double apart = -1;
        CHECK_OK(batten_surfaces_near_edges(first, second, &edges[0], &edges[1], &apart));
        CHECK_INT(edges[0], rows[i].first);
        CHECK_INT(edges[1], rows[i].second);
        CHECK_NEAR(apart, rows[i].apart, 1e-15);
        CHECK_OK(batten_surfaces_near_edges(first, second, &edges[0], &edges[1], NULL));
        batten_surface_unref(second);
    }
    batten_surface_unref(first);
}

TEST(functions_have_no_near_edges)
{
    const double knots[4] = {0, 0, 1, 1}, z[4] = {0, 1, 2, 3};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *first = square(0, 0, 0), *function = NULL;
    batten_edge edges[2];
    CHECK_OK(batten_surface_create(1, &axis, &axis, z, NULL, &function));
    CHECK_STATUS(batten_surfaces_near_edges(first, function, &edges[0], &edges[1], NULL),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the surfaces have the dimensions 3 and 1");
    CHECK_STATUS(batten_surfaces_near_edges(function, first, &edges[0], &edges[1], NULL),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the surfaces have the dimensions 1 and 3");
    batten_surface_unref(function);
    batten_surface_unref(first);
}
