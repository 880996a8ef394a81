#include "shape/sections.h"

#include <batten/standard.h>

TEST(the_ruled_surface_is_the_mean_of_its_edges_by_v)
{
    const double a[9] = {0, 0, 0, 1, 3, 0, 4, 0, 1}, b[6] = {0, 5, 1, 4, 6, 2};
    const double knots[6] = {0, 0, 0, 2, 2, 2};
    batten_curve *first = NULL, *second = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, a}, 2, NULL, knots, &first));
    CHECK_OK(batten_curve_line(3, b, b + 3, &second));
    CHECK_OK(batten_surface_ruled(first, second, &surface));
    const batten_interval s = batten_curve_domain(second);
    for (int i = 0; i <= 4; i++)
        for (int j = 0; j <= 4; j++) {
            const double u = i / 4.0, v = j / 4.0;
            double p[3], q[3], r[3];
            CHECK_OK(batten_curve_evaluate(first, 2 * u, 0, p));
            CHECK_OK(batten_curve_evaluate(second, s.a + u * (s.b - s.a), 0, q));
            CHECK_OK(batten_surface_evaluate(surface, u, v, 0, r));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(r[c], (1 - v) * p[c] + v * q[c], 1e-14);
        }
    batten_surface_unref(surface);
    batten_curve_unref(second);
    batten_curve_unref(first);
}

TEST(plane_curves_are_extruded_into_space_and_vectors_that_lead_nowhere_refused)
{
    const double ends[4] = {1, 2, 4, 3};
    const struct {
        batten_vec3 along;
        batten_status status;
        const char *message;
    } rows[] = {
        {{0, INFINITY, 1}, BATTEN_NOT_FINITE, "the curve cannot be extruded along (0, inf, 1)"},
        {{NAN, 0, 1}, BATTEN_NOT_FINITE, "the curve cannot be extruded along (nan, 0, 1)"},
        {{0, 2, -INFINITY},
         BATTEN_NOT_FINITE,
         "the curve cannot be extruded along (0, 2, -inf)"},
        {{0, 0, 0}, BATTEN_BAD_ARGUMENT, "the vector to extrude along has no length"},
    };
    batten_curve *line = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_line(2, ends, ends + 2, &line));
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(batten_surface_extruded(line, rows[i].along, &surface), rows[i].status);
        CHECK_MESSAGE(rows[i].message);
        CHECK(!surface);
    }
    double p[3];
    CHECK_OK(batten_surface_extruded(line, (batten_vec3){1, -2, 5}, &surface));
    CHECK_OK(batten_surface_evaluate(surface, 1, 0.5, 0, p));
    CHECK_NEAR(p[0], 4.5, 1e-14);
    CHECK_NEAR(p[1], 2, 1e-14);
    CHECK_NEAR(p[2], 2.5, 1e-14);
    batten_surface_unref(surface);
    batten_curve_unref(line);
}
