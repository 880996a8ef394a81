/* NURBS surfaces with the normals of another along their edges. */
#include "numeric/jet.h"
#include "shape/formula/formula.h"
#include "support/test.h"

#include <batten/coons.h>
#include <batten/fill.h>

static void keep(void *data)
{
    (void)data;
}

/* (u, v, sin(4 u + 3 v)), of which the data say how many coordinates are wanted */
static batten_status ripple(const void *data, const bat_surface_place *at, int order,
                            double *out)
{
    const double u = at->u, v = at->v;
    const int d = *(const int *)data;
    const bat_jet a = bat_jet_u(u), b = bat_jet_v(v);
    const double angle = 4 * u + 3 * v, s = sin(angle), c = cos(angle);
    const bat_jet z = bat_jet_compose((const double[4]){s, c, -s, -c},
                                      bat_jet_add(bat_jet_scale(4, a), bat_jet_scale(3, b)));
    const bat_jet xyz[3] = {a, b, z};
    for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
        for (int k = 0; k < d; k++)
            out[d * i + k] = xyz[k].d[i];
    return BATTEN_OK;
}

static batten_surface *make_ripple(int *dimension)
{
    static const double unit[] = {0, 1};
    const bat_formula formula = {"ripple", ripple, NULL, keep};
    const bat_formula_axis axis = {2, unit, 2};
    batten_surface *surface = NULL;
    CHECK_OK(bat_formula_create(&formula, dimension, *dimension, &axis, &axis, 2, &surface));
    return surface;
}

TEST(normals_along_the_edges_are_as_near_as_the_angle_asks)
{
    int dimension = 3;
    batten_surface *surface = make_ripple(&dimension);
    double last = 1;
    for (double angle = 1e-2; angle > 1e-7; angle /= 30) {
        batten_surface *made = NULL;
        double error = -1, reached = -1, worst = 0, far = 0;
        CHECK_OK(batten_surface_to_smooth_nurbs(surface, 1e-2, angle, &error, &reached, &made));
        CHECK(error >= 0 && error <= 1e-2 && reached > 0 && reached <= angle);
        for (int k = 0; k <= 400; k++)
            for (int edge = 0; edge < 4; edge++) {
                const double t = k / 400.0, u = edge < 2 ? edge : t,
                             v = edge < 2 ? t : edge - 2;
                batten_vec3 n, m;
                double p[3], q[3];
                CHECK_OK(batten_surface_normal(surface, u, v, NULL, &n));
                CHECK_OK(batten_surface_normal(made, u, v, NULL, &m));
                CHECK_OK(batten_surface_evaluate(surface, u, v, 0, p));
                CHECK_OK(batten_surface_evaluate(made, u, v, 0, q));
                worst = fmax(worst, hypot(hypot(n.x - m.x, n.y - m.y), n.z - m.z));
                far = fmax(far, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
            }
        /* 32 places of every span, these 401 beside them. */
        CHECK(worst <= 1.5 * reached && worst >= 0.5 * reached);
        CHECK(far <= error && reached <= last);
        last = reached;
        batten_surface_unref(made);
        made = NULL;
        CHECK_OK(batten_surface_to_smooth_nurbs(surface, 1e-2, angle, NULL, NULL, &made));
        batten_surface_unref(made);
    }
    batten_surface_unref(surface);
}

TEST(angles_that_cannot_be_kept_are_refused)
{
    int dimension = 3, plane = 2;
    batten_surface *surface = make_ripple(&dimension), *flat = make_ripple(&plane),
                   *made = NULL;
    static const double bad[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < COUNT(bad); i++) {
        CHECK_STATUS(batten_surface_to_smooth_nurbs(surface, 1, bad[i], NULL, NULL, &made),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the angle");
    }
    CHECK_STATUS(batten_surface_to_smooth_nurbs(flat, 1, 1, NULL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("dimension 2");
    CHECK_STATUS(batten_surface_to_smooth_nurbs(surface, 1, 1e-13, NULL, NULL, &made),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("degrees");
    CHECK_STATUS(batten_surface_to_smooth_nurbs(surface, -1, 0.1, NULL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK(!made);
    batten_surface_unref(flat);
    batten_surface_unref(surface);
}

/* Over the unit square: z = slope * v * u, flat along u at v = 0 but for the turn of its planes. */
static batten_surface *make_propeller(double slope)
{
    static const double knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    const double points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, slope};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

TEST(angles_along_edges_are_told_edge_by_edge)
{
    batten_surface *flat = make_propeller(0), *turned = make_propeller(0.5), *longer = NULL;
    double angles[4] = {-1, -1, -1, -1};
    CHECK_OK(batten_surface_edge_angles(flat, turned, angles));
    /* along v = 0 the slope across grows from 0 to 0.5, along v = 1 that along is 0.5 too */
    CHECK_NEAR(angles[BATTEN_EDGE_V0], atan(0.5), 1e-3);
    CHECK_NEAR(angles[BATTEN_EDGE_U0], atan(0.5), 1e-3);
    CHECK_NEAR(angles[BATTEN_EDGE_V1], atan(hypot(0.5, 0.5)), 1e-3);
    CHECK_NEAR(angles[BATTEN_EDGE_U1], atan(hypot(0.5, 0.5)), 1e-3);
    CHECK_OK(batten_surface_edge_angles(turned, turned, angles));
    for (int e = 0; e < 4; e++)
        CHECK_NEAR(angles[e], 0, 1e-12);
    int plane = 2;
    batten_surface *no_space = make_ripple(&plane);
    CHECK_STATUS(batten_surface_edge_angles(flat, no_space, angles), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("dimension 2");
    static const double knots[] = {0, 0, 1, 1}, others[] = {0, 0, 2, 2};
    const batten_axis axis = {1, 2, knots, false}, long_axis = {1, 2, others, false};
    const double points[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0};
    CHECK_OK(batten_surface_create(3, &axis, &long_axis, points, NULL, &longer));
    CHECK_STATUS(batten_surface_edge_angles(flat, longer, angles), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("from 0 to 1 and from 0 to 2 in v");
    batten_surface_unref(longer);
    batten_surface_unref(no_space);
    batten_surface_unref(turned);
    batten_surface_unref(flat);
}
