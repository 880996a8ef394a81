#include "support/faults.h"
#include "support/test.h"
#include <batten/extend.h>
#include <batten/measure.h>
#include <batten/standard.h>

#define PI 3.14159265358979323846

static double length_of(const batten_curve *curve)
{
    double length = 0;
    CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
    return length;
}

TEST(a_circle_is_trimmed_by_a_plane_over_its_seam)
{
    /* x > 1/2 of the unit circle, which begins at (1, 0): one part of the angle 2 pi / 3. */
    batten_curve *circle = NULL;
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    batten_curves parts = {0, NULL};
    CHECK_EACH_ALLOCATION(
        batten_curve_trim_plane(circle, (batten_vec3){2, 0, 0}, 1, 1e-9, &parts));
    CHECK_INT(parts.count, 1);
    CHECK_NEAR(length_of(parts.at[0]), 2 * PI / 3, 1e-11);
    double p[2];
    CHECK_OK(batten_curve_evaluate(parts.at[0], batten_curve_domain(parts.at[0]).a, 0, p));
    CHECK_NEAR(p[0], 0.5, 1e-14);
    CHECK_NEAR(p[1], -sqrt(0.75), 1e-14);
    batten_curves_release(&parts);
    CHECK_EACH_ALLOCATION(
        batten_curve_trim_plane(circle, (batten_vec3){-1, 0, 0}, -0.5, 1e-9, &parts));
    CHECK_INT(parts.count, 1);
    CHECK_NEAR(length_of(parts.at[0]), 4 * PI / 3, 1e-11);
    batten_curves_release(&parts);
    CHECK_OK(batten_curve_trim_plane(circle, (batten_vec3){1, 0, 0}, 3, 1e-9, &parts));
    CHECK_INT(parts.count, 0);
    batten_curves_release(&parts);
    CHECK_OK(batten_curve_trim_plane(circle, (batten_vec3){1, 1, 0}, -3, 1e-9, &parts));
    CHECK_INT(parts.count, 1);
    CHECK_NEAR(length_of(parts.at[0]), 2 * PI, 1e-11);
    batten_curves_release(&parts);
    batten_curve_unref(circle);
}

TEST(a_plane_that_only_touches_cuts_nothing)
{
    batten_curve *circle = NULL, *path = NULL;
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    batten_curves parts = {0, NULL};
    CHECK_OK(batten_curve_trim_plane(circle, (batten_vec3){0, 1, 0}, -1, 1e-9, &parts));
    CHECK_INT(parts.count, 1);
    CHECK_NEAR(length_of(parts.at[0]), 2 * PI, 1e-11);
    batten_curves_release(&parts);
    /* A run in the plane belongs to the parts beside it. */
    const double points[] = {0, 1, 0, 1, 0, 0, 2, 0, 0, 3, 1, 0, 4, -1, 0, 5, 1, 0};
    CHECK_OK(batten_curve_polyline((batten_points){3, 6, points}, &path));
    CHECK_OK(batten_curve_trim_plane(path, (batten_vec3){0, 1, 0}, 0, 1e-9, &parts));
    CHECK_INT(parts.count, 2);
    CHECK_NEAR(length_of(parts.at[0]), sqrt(2) + 1 + sqrt(2) + sqrt(1.25), 1e-13);
    CHECK_NEAR(length_of(parts.at[1]), sqrt(1.25), 1e-13);
    batten_curves_release(&parts);
    batten_curve_unref(path);
    batten_curve_unref(circle);
}

TEST(parts_of_both_sides_of_any_plane_make_the_whole)
{
    test_random random = test_random_begin("trim");
    for (int n = test_cases(40); n > 0; n--) {
        double points[24];
        const double knots[12] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5};
        batten_curve *curve = NULL;
        for (int i = 0; i < 24; i++)
            points[i] = test_random_in(&random, -1, 1);
        CHECK_OK(batten_curve_create((batten_points){3, 8, points}, 3, NULL, knots, &curve));
        const batten_vec3 normal = {test_random_in(&random, -1, 1),
                                    test_random_in(&random, -1, 1),
                                    test_random_in(&random, -1, 1)};
        const double offset = test_random_in(&random, -0.3, 0.3);
        double sum = 0;
        for (int side = 1; side >= -1; side -= 2) {
            batten_curves parts = {0, NULL};
            const batten_vec3 to = {side * normal.x, side * normal.y, side * normal.z};
            CHECK_OK(batten_curve_trim_plane(curve, to, side * offset, 1e-9, &parts));
            for (int i = 0; i < parts.count; i++) {
                const batten_interval d = batten_curve_domain(parts.at[i]);
                sum += length_of(parts.at[i]);
                for (int k = 0; k <= 40; k++) {
                    double p[3];
                    CHECK_OK(
                        batten_curve_evaluate(parts.at[i], d.a + (d.b - d.a) * k / 40, 0, p));
                    CHECK(to.x * p[0] + to.y * p[1] + to.z * p[2] - side * offset >= -1e-13);
                }
            }
            batten_curves_release(&parts);
        }
        CHECK_NEAR(sum, length_of(curve), 1e-10);
        batten_curve_unref(curve);
    }
}

TEST(a_part_over_the_seam_needs_a_closed_curve)
{
    const double points[] = {0, 0, 2, 0, 1, 2}, more[] = {0, 1, 2, 3};
    batten_curve *ring = NULL, *circle = NULL, *line = NULL, *part = NULL;
    CHECK_OK(batten_curve_create_periodic((batten_points){2, 3, points}, 2, NULL, more, &ring));
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_OK(batten_curve_line(2, points, points + 2, &line));
    CHECK_EACH_ALLOCATION(batten_curve_trim(ring, 2, 1, 0, &part));
    double length = length_of(part);
    batten_curve_unref(part);
    CHECK_EACH_ALLOCATION(batten_curve_trim(ring, 1, 2, 0, &part));
    CHECK_NEAR(length + length_of(part), length_of(ring), 1e-11);
    batten_curve_unref(part);
    CHECK_OK(batten_curve_trim(circle, 0.75, 0.25, 0, &part));
    CHECK_NEAR(length_of(part), PI, 1e-11);
    batten_curve_unref(part);
    CHECK_OK(batten_curve_trim(circle, 0.5, 0.5, 0, &part));
    CHECK_NEAR(length_of(part), 2 * PI, 1e-11);
    CHECK_NEAR(batten_curve_domain(part).a, 0.5, 0);
    batten_curve_unref(part);
    CHECK_OK(batten_curve_trim(circle, 1, 0, 0, &part));
    CHECK_NEAR(length_of(part), 2 * PI, 1e-11);
    batten_curve_unref(part);
    CHECK_STATUS(batten_curve_trim(line, 0.75, 0.25, 0, &part), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curve_trim(line, 0.5, 0.5, 0, &part), BATTEN_NOT_COMPATIBLE);
    batten_curve_unref(line);
    batten_curve_unref(circle);
    batten_curve_unref(ring);
}

TEST(N1_N6_planes_and_tolerances_that_mean_nothing_are_refused)
{
    const double points[] = {0, 0, 2, 1}, one[] = {0, 1};
    batten_curve *line = NULL, *function = NULL, *part = NULL;
    batten_curves parts = {0, NULL};
    CHECK_OK(batten_curve_line(2, points, points + 2, &line));
    CHECK_OK(batten_curve_line(1, one, one + 1, &function));
    CHECK_STATUS(batten_curve_trim_plane(line, (batten_vec3){0, 0, 1}, 0, 0, &parts),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_trim_plane(line, (batten_vec3){NAN, 0, 1}, 0, 0, &parts),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_trim_plane(line, (batten_vec3){1, 0, 0}, INFINITY, 0, &parts),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_trim_plane(line, (batten_vec3){1, 0, 0}, 1, -1, &parts),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_trim_plane(function, (batten_vec3){1, 0, 0}, 1, 0, &parts),
                 BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_curve_trim(line, NAN, 1, 0, &part), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_trim(line, 0, 2, 0, &part), BATTEN_OUT_OF_DOMAIN);
    batten_curve_unref(function);
    batten_curve_unref(line);
}
