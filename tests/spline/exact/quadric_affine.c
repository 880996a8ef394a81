#include <batten/standard.h>

#include "support/test.h"

/* Axes that are at right angles, so that coordinates in the frame are dot products. */
static const batten_frame frame = {{1, -2, 0.5}, {0.6, 0, 0.8}, {-0.8, 0, 0.6}};

static batten_vec3 seen(const double *p)
{
    const double d[3] = {p[0] - 1, p[1] + 2, p[2] - 0.5};
    /* y = z cross x */
    return (batten_vec3){0.6 * d[0] + 0.8 * d[2], d[1], -0.8 * d[0] + 0.6 * d[2]};
}

static batten_vec3 at(const batten_surface *surface, int i, int j)
{
    double p[3];
    CHECK_OK(batten_surface_evaluate(surface, i / 40.0, j / 40.0, 0, p));
    return seen(p);
}

TEST(points_of_quadrics_satisfy_their_equations)
{
    batten_surface *ellipsoid = NULL, *paraboloid = NULL, *hyperboloid = NULL;
    CHECK_OK(batten_surface_ellipsoid(&frame, 3, 2, 1, &ellipsoid));
    CHECK_OK(batten_surface_paraboloid(&frame, 2, 1, 3, &paraboloid));
    CHECK_OK(
        batten_surface_hyperboloid(&frame, 1, 0.5, 2, (batten_interval){-1, 3}, &hyperboloid));
    for (int i = 0; i <= 40; i++)
        for (int j = 0; j <= 40; j++) {
            batten_vec3 p = at(ellipsoid, i, j);
            CHECK_NEAR(p.x * p.x / 9 + p.y * p.y / 4 + p.z * p.z, 1, 1e-14);
            p = at(paraboloid, i, j);
            CHECK_NEAR(3 * (p.x * p.x / 4 + p.y * p.y), p.z, 1e-14);
            p = at(hyperboloid, i, j);
            CHECK_NEAR(p.x * p.x + p.y * p.y / 0.25 - p.z * p.z / 4, 1, 2e-14);
            CHECK_NEAR(p.z, -1 + j / 10.0, 4e-15);
        }
    CHECK_INT(batten_surface_degree(hyperboloid, BATTEN_V), 1);
    batten_vec3 normal;
    bool is_limit = false;
    CHECK_OK(batten_surface_normal(paraboloid, 0.3, 0, &is_limit, &normal));
    CHECK(is_limit);
    CHECK_NEAR(fabs(-0.8 * normal.x + 0.6 * normal.z), 1, 1e-9);
    batten_surface_unref(hyperboloid);
    batten_surface_unref(paraboloid);
    batten_surface_unref(ellipsoid);
}

TEST(quadrics_refuse_axes_that_are_not_positive)
{
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_ellipsoid(&frame, 0, 1, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_ellipsoid(&frame, 1, NAN, 1, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_paraboloid(&frame, 1, 1, -1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the height is -1");
    CHECK_STATUS(batten_surface_hyperboloid(&frame, 1, 1, 1, (batten_interval){2, 2}, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(
        batten_surface_hyperboloid(&frame, 1, 1, 1, (batten_interval){2, HUGE_VAL}, &none),
        BATTEN_NOT_FINITE);
    CHECK(none == NULL);
}
