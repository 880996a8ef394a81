#include <batten/coons.h>

#include "support/faults.h"
#include "support/surfaces.h"

static const batten_edge edges[] = {BATTEN_EDGE_V0, BATTEN_EDGE_U1, BATTEN_EDGE_V1,
                                    BATTEN_EDGE_U0};

/* The derivative of order k out of the surface at t along the edge. */
static void outward(const batten_surface *surface, batten_edge edge, double t, int k,
                    double *out)
{
    const bool along_u = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1;
    const bool low = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_U0;
    const batten_interval across =
        batten_surface_domain(surface, along_u ? BATTEN_V : BATTEN_U);
    const int d = batten_surface_dimension(surface);
    const double at = low ? across.a : across.b;
    const batten_side side = low ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT;
    double all[BATTEN_SURFACE_DERIVATIVES(2) * 3];
    CHECK_OK(batten_surface_evaluate_side(
        surface, along_u ? t : at, along_u ? at : t,
        (batten_sides){along_u ? BATTEN_FROM_RIGHT : side, along_u ? side : BATTEN_FROM_RIGHT},
        2, all));
    const int place =
        along_u ? BATTEN_SURFACE_DERIVATIVE(0, k) : BATTEN_SURFACE_DERIVATIVE(k, 0);
    for (int x = 0; x < d; x++)
        out[x] = (k == 1 && low ? -1 : 1) * all[place * d + x];
}

static void check_ribbon(const batten_surface *surface, batten_edge edge,
                         batten_curve *const *curves, int order, double tolerance)
{
    const bool along_u = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1;
    const batten_interval along = batten_surface_domain(surface, along_u ? BATTEN_U : BATTEN_V);
    const int d = batten_surface_dimension(surface);
    for (int k = 0; k <= order; k++) {
        const batten_interval domain = batten_curve_domain(curves[k]);
        CHECK(domain.a == along.a && domain.b == along.b);
        double size = 1;
        for (int i = 0; i < 40; i++) {
            const double t = along.a + (along.b - along.a) * (i + 0.37) / 40;
            double wanted[3], point[3];
            outward(surface, edge, t, k, wanted);
            CHECK_OK(batten_curve_evaluate(curves[k], t, 0, point));
            for (int x = 0; x < d; x++) {
                size = fmax(size, fabs(wanted[x]));
                CHECK_NEAR(point[x], wanted[x], tolerance * size);
            }
        }
    }
}

TEST(the_ribbon_of_every_edge_continues_the_surface)
{
    test_random random = test_random_begin("ribbons");
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        surface_data_random(&random, 6, &data);
        batten_surface *surface = NULL;
        CHECK_OK(surface_data_create(&data, &surface));
        for (int e = 0; e < 4; e++) {
            batten_curve *curves[3] = {NULL, NULL, NULL};
            double error = 1;
            const int order = 1 + c % 2;
            CHECK_EACH_ALLOCATION(
                batten_edge_ribbon(surface, edges[e], order, 0, &error, curves));
            CHECK(error == 0);
            check_ribbon(surface, edges[e], curves, order, 1e-9);
            for (int k = 0; k <= order; k++)
                batten_curve_unref(curves[k]);
        }
        batten_surface_unref(surface);
    }
}

/* A quarter of a cylinder along v and u: the weights do not change across the edge. */
TEST(weights_that_do_not_change_across_an_edge_keep_its_degree)
{
    const double h = sqrt(0.5);
    const double points[] = {1, 0, 0, 1, 0, 3, 1, 1, 0, 1, 1, 3, 0, 1, 0, 0, 1, 3};
    const double weights[] = {1, 1, h, h, 1, 1};
    const double U[] = {0, 0, 0, 1, 1, 1}, V[] = {0, 0, 1, 1};
    const batten_axis u = {2, 3, U, false}, v = {1, 2, V, false};
    batten_surface *surface = NULL;
    batten_curve *curves[3] = {NULL, NULL, NULL};
    CHECK_OK(batten_surface_create(3, &u, &v, points, weights, &surface));
    CHECK_EACH_ALLOCATION(batten_edge_ribbon(surface, BATTEN_EDGE_V1, 2, 0, NULL, curves));
    for (int k = 0; k < 3; k++)
        CHECK_INT(batten_curve_degree(curves[k]), 2);
    double slope[3];
    CHECK_OK(batten_curve_evaluate(curves[1], 0.3, 0, slope));
    CHECK_NEAR(slope[2], 3, 1e-15);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(curves[k]);
    batten_surface_unref(surface);
}

/* A rational surface of degree 13 has a slope of degree 26, which no curve has. */
TEST(a_ribbon_of_too_high_a_degree_is_met_within_a_tolerance)
{
    enum { P = 13, N = P + 1 };
    double points[N * 2 * 3], weights[N * 2], U[2 * N], V[] = {0, 0, 1, 1};
    test_random random = test_random_begin("degree");
    for (int i = 0; i < N; i++) {
        U[i] = 0;
        U[N + i] = 1;
        for (int j = 0; j < 2; j++) {
            double *point = points + (2 * i + j) * 3;
            point[0] = i;
            point[1] = j;
            point[2] = test_random_unit(&random);
            weights[2 * i + j] = test_random_in(&random, 0.8, 1.25);
        }
    }
    const batten_axis u = {P, N, U, false}, v = {1, 2, V, false};
    batten_surface *surface = NULL;
    batten_curve *curves[3] = {NULL, NULL, NULL};
    double error = 0;
    CHECK_OK(batten_surface_create(3, &u, &v, points, weights, &surface));
    CHECK_STATUS(batten_edge_ribbon(surface, BATTEN_EDGE_V0, 2, 0, &error, curves),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("tolerance");
    CHECK_OK(batten_edge_ribbon(surface, BATTEN_EDGE_V0, 2, 1e-6, &error, curves));
    CHECK(error > 0 && error <= 1e-6);
    check_ribbon(surface, BATTEN_EDGE_V0, curves, 2, 2e-6);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(curves[k]);
    CHECK_STATUS(batten_edge_ribbon(surface, BATTEN_EDGE_V0, 3, 1e-6, &error, curves),
                 BATTEN_BAD_ARGUMENT);
    batten_surface_unref(surface);
}

TEST(orders_edges_and_tolerances_of_ribbons_are_checked_with_their_numbers)
{
    const double corners[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, knots[4] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *square = NULL;
    batten_curve *made[3] = {NULL};
    const struct {
        int edge, order;
        const char *message;
    } rows[] = {{0, 0, "the order of a ribbon is 0, not 1 or 2"},
                {0, 3, "the order of a ribbon is 3, not 1 or 2"},
                {-1, 1, "a surface has no edge -1"},
                {4, 1, "a surface has no edge 4"}};
    CHECK_OK(batten_surface_create(3, &axis, &axis, corners, NULL, &square));
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(batten_edge_ribbon(square, (batten_edge)rows[i].edge, rows[i].order, 1e-6,
                                        NULL, made),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(rows[i].message);
        CHECK(!made[0]);
    }
    batten_surface_unref(square);
}
