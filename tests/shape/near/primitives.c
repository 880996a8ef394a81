#include <batten/approximate.h>
#include <batten/standard.h>

#include "support/test.h"

#include <string.h>

static const double PI = 3.14159265358979323846;

/* ---- lines ---- */

TEST(points_on_a_line_give_it_back)
{
    test_random random = test_random_begin("lines");
    for (int c = 0; c < test_cases(50); c++) {
        const int d = 2 + c % 2, n = 2 + c % 9;
        double at[3], along[3], q[30], size = 0;
        for (int k = 0; k < d; k++) {
            at[k] = test_random_in(&random, -10, 10);
            along[k] = test_random_in(&random, -1, 1);
            size = hypot(size, along[k]);
        }
        for (int i = 0; i < n; i++)
            for (int k = 0; k < d; k++)
                q[i * d + k] = at[k] + (i * i + i) * along[k] / size;
        batten_fitted_line line;
        batten_primitive_report report;
        CHECK_OK(batten_line_fit((batten_points){d, n, q}, &report, &line));
        CHECK(report.error < 1e-13 * (10 + n * n));
        for (int k = 0; k < d; k++) {
            CHECK_NEAR(line.direction[k], along[k] / size, 1e-12);
            CHECK_NEAR(line.point[k] + line.from * line.direction[k], q[k], 1e-12 * n * n);
            CHECK_NEAR(line.point[k] + line.to * line.direction[k], q[(n - 1) * d + k],
                       1e-12 * n * n);
        }
    }
}

TEST(a_line_minimises_distances_at_right_angles)
{
    const double q[] = {0, 0, 1, 2, 2, 1, 3, 3};
    batten_fitted_line line;
    batten_primitive_report report;
    CHECK_OK(batten_line_fit((batten_points){2, 4, q}, &report, &line));
    CHECK_NEAR(line.direction[0], sqrt(0.5), 1e-15); /* symmetric about the diagonal */
    CHECK_NEAR(line.direction[1], sqrt(0.5), 1e-15);
    CHECK_NEAR(report.error, sqrt(0.5), 1e-15);
    CHECK_NEAR(report.rms, 0.5, 1e-15);
}

TEST(G1_one_point_many_times_is_no_line_or_circle)
{
    const double q[] = {1, 2, 1, 2, 1, 2, 1, 2, 1, 2};
    batten_fitted_line line;
    batten_fitted_circle circle;
    batten_fitted_ellipse ellipse;
    batten_span span;
    CHECK_STATUS(batten_line_fit((batten_points){2, 5, q}, NULL, &line), BATTEN_COINCIDENT);
    CHECK_STATUS(
        batten_circle_fit((batten_points){2, 5, q}, BATTEN_CIRCLE_GEOMETRIC, NULL, &circle),
        BATTEN_COINCIDENT);
    CHECK_STATUS(batten_ellipse_fit((batten_points){2, 5, q}, NULL, &ellipse),
                 BATTEN_COINCIDENT);
    CHECK_STATUS(batten_clothoid_fit((batten_points){2, 5, q}, NULL, NULL, NULL, &span),
                 BATTEN_COINCIDENT);
}

TEST(a_square_has_no_nearest_line)
{
    const double q[] = {0, 0, 1, 0, 1, 1, 0, 1};
    batten_fitted_line line;
    CHECK_STATUS(batten_line_fit((batten_points){2, 4, q}, NULL, &line),
                 BATTEN_SINGULAR_SYSTEM);
}

/* ---- circles ---- */

TEST(points_on_a_circle_give_it_back_by_every_method)
{
    test_random random = test_random_begin("circles");
    for (int c = 0; c < test_cases(120); c++) {
        const double x = test_random_in(&random, -5, 5), y = test_random_in(&random, -5, 5),
                     r = test_random_in(&random, 0.1, 20),
                     sweep = test_random_in(&random, 1, 6) * (c % 2 ? 1 : -1),
                     start = test_random_in(&random, 0, 6);
        const int n = 3 + c % 20;
        double q[60];
        for (int i = 0; i < n; i++) {
            q[2 * i] = x + r * cos(start + sweep * i / (n - 1));
            q[2 * i + 1] = y + r * sin(start + sweep * i / (n - 1));
        }
        batten_fitted_circle circle;
        batten_primitive_report report;
        CHECK_OK(batten_circle_fit((batten_points){2, n, q}, (batten_circle_method)(c % 4),
                                   &report, &circle));
        CHECK_NEAR(circle.radius, r, 1e-10 * r);
        CHECK_NEAR(circle.frame.origin.x, x, 1e-10 * r);
        CHECK_NEAR(circle.frame.origin.y, y, 1e-10 * r);
        CHECK(report.error < 1e-10 * r);
    }
}

TEST(a_circle_in_space_is_found_in_its_plane_and_runs_as_the_data_do)
{
    for (int c = 0; c < 2; c++) {
        double q[30];
        const double u[3] = {0.6, 0.8, 0}, v[3] = {-0.48, 0.36, 0.8};
        for (int i = 0; i < 10; i++)
            for (int k = 0; k < 3; k++) {
                const double t = (c ? -0.3 : 0.3) * i + 1;
                q[3 * i + k] = k + 2 * (u[k] * cos(t) + v[k] * sin(t));
            }
        batten_fitted_circle circle;
        batten_primitive_report report;
        batten_curve *arc = NULL;
        double point[3];
        CHECK_OK(batten_circle_fit((batten_points){3, 10, q}, BATTEN_CIRCLE_GEOMETRIC, &report,
                                   &circle));
        CHECK_NEAR(circle.radius, 2, 1e-12);
        CHECK_NEAR(circle.frame.origin.z, 2, 1e-12);
        CHECK_NEAR(circle.angle, 2.7, 1e-12);
        CHECK_OK(batten_curve_arc_in(&circle.frame, circle.radius, circle.start, circle.angle,
                                     &arc));
        for (int e = 0; e < 2; e++) {
            CHECK_OK(batten_curve_evaluate(arc, e, 0, point));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(point[k], q[27 * e + k], 1e-11);
        }
        batten_curve_unref(arc);
    }
}

/* The geometric circle leaves the least sum; Kasa's is too small on a short noisy arc. */
TEST(the_geometric_circle_is_nearest)
{
    test_random random = test_random_begin("noisy circle");
    double q[200], rms[4], radius[4];
    for (int i = 0; i < 100; i++) {
        const double t = i / 100.0, r = 10 + test_random_in(&random, -0.1, 0.1);
        q[2 * i] = r * cos(t);
        q[2 * i + 1] = r * sin(t);
    }
    for (int m = 0; m < 4; m++) {
        batten_fitted_circle circle;
        batten_primitive_report report;
        CHECK_OK(batten_circle_fit((batten_points){2, 100, q}, (batten_circle_method)m, &report,
                                   &circle));
        rms[m] = report.rms;
        radius[m] = circle.radius;
    }
    for (int m = 1; m < 4; m++)
        CHECK(rms[0] <= rms[m]);
    CHECK(radius[BATTEN_CIRCLE_KASA] < radius[BATTEN_CIRCLE_TAUBIN]);
    CHECK_NEAR(radius[BATTEN_CIRCLE_TAUBIN], radius[BATTEN_CIRCLE_GEOMETRIC], 0.02);
}

TEST(G2_points_on_a_line_have_no_circle_and_no_ellipse)
{
    double q[20];
    for (int i = 0; i < 10; i++) {
        q[2 * i] = 1 + 0.3 * i;
        q[2 * i + 1] = 2 - 0.7 * i;
    }
    batten_fitted_circle circle;
    batten_fitted_ellipse ellipse;
    for (int m = 0; m < 4; m++)
        CHECK_STATUS(batten_circle_fit((batten_points){2, 10, q}, (batten_circle_method)m, NULL,
                                       &circle),
                     BATTEN_SINGULAR_SYSTEM);
    CHECK_STATUS(batten_ellipse_fit((batten_points){2, 10, q}, NULL, &ellipse),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_STATUS(batten_circle_fit((batten_points){2, 2, q}, BATTEN_CIRCLE_KASA, NULL, &circle),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_ellipse_fit((batten_points){2, 4, q}, NULL, &ellipse),
                 BATTEN_TOO_FEW_POINTS);
}

/* ---- ellipses ---- */

TEST(points_on_an_ellipse_give_it_back)
{
    test_random random = test_random_begin("ellipses");
    for (int c = 0; c < test_cases(120); c++) {
        const double x = test_random_in(&random, -5, 5), y = test_random_in(&random, -5, 5),
                     a = test_random_in(&random, 1, 4),
                     b = a * test_random_in(&random, 0.2, 0.9),
                     turn = test_random_in(&random, -1.5, 1.5),
                     sweep = test_random_in(&random, 3, 6) * (c % 2 ? 1 : -1);
        const int n = 6 + c % 40;
        double q[100];
        for (int i = 0; i < n; i++) {
            const double t = 0.3 + sweep * i / (n - 1), u = a * cos(t), v = b * sin(t);
            q[2 * i] = x + cos(turn) * u - sin(turn) * v;
            q[2 * i + 1] = y + sin(turn) * u + cos(turn) * v;
        }
        batten_fitted_ellipse e;
        batten_primitive_report report;
        CHECK_OK(batten_ellipse_fit((batten_points){2, n, q}, &report, &e));
        CHECK_NEAR(e.a, a, 1e-10 * a);
        CHECK_NEAR(e.b, b, 1e-10 * a);
        CHECK_NEAR(e.center[0], x, 1e-10 * a);
        CHECK_NEAR(e.center[1], y, 1e-10 * a);
        CHECK_NEAR(fabs(e.axis[0] * cos(turn) + e.axis[1] * sin(turn)), 1, 1e-10);
        CHECK(report.error < 1e-10 * a);
        CHECK((e.angle > 0) == (sweep > 0));
    }
}

TEST(the_distances_from_an_ellipse_are_those_of_its_normals)
{
    double q[2 * 24];
    for (int i = 0; i < 24; i++) { /* 0.1 outside and inside along the normals */
        const double t = 2 * PI * i / 24, nx = cos(t) / 3, ny = sin(t), size = hypot(nx, ny);
        const double off = i % 2 ? 0.1 : -0.1;
        q[2 * i] = 3 * cos(t) + off * nx / size;
        q[2 * i + 1] = sin(t) + off * ny / size;
    }
    batten_fitted_ellipse e;
    batten_primitive_report report;
    CHECK_OK(batten_ellipse_fit((batten_points){2, 24, q}, &report, &e));
    CHECK(report.rms <= 0.1 + 1e-12); /* the ellipse before the noise has 0.1 */
    CHECK_NEAR(e.a, 3, 0.03);
    CHECK_NEAR(e.b, 1, 0.03);
    CHECK_NEAR(fabs(e.angle), 2 * PI, 1e-15);
}

/* ---- clothoids ---- */

static void on_clothoid(const batten_span *span, int count, double wobble, double *q)
{
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, span, NULL, false}, 1, &chain));
    for (int i = 0; i < count; i++) {
        double at[4];
        CHECK_OK(batten_chain_evaluate(chain, span->length * i / (count - 1), 1, at));
        q[2 * i] = at[0] - (i % 2 ? wobble : -wobble) * at[3];
        q[2 * i + 1] = at[1] + (i % 2 ? wobble : -wobble) * at[2];
    }
    batten_chain_unref(chain);
}

TEST(points_on_a_clothoid_give_it_back)
{
    test_random random = test_random_begin("clothoids");
    for (int c = 0; c < test_cases(60); c++) {
        const int n = 6 + c % 30;
        const double length = test_random_in(&random, 1, 20);
        const batten_span span = {
            .kind = BATTEN_SPAN_SPIRAL,
            .length = length,
            .start = {test_random_in(&random, -5, 5), test_random_in(&random, -5, 5)},
            .angle = test_random_in(&random, -3, 3),
            .curvature = {test_random_in(&random, -1.5, 1.5) / length,
                          test_random_in(&random, -3, 3) / (length * length)}};
        double q[80], lengths[40];
        on_clothoid(&span, n, 0, q);
        batten_span found;
        batten_primitive_report report;
        CHECK_OK(batten_clothoid_fit((batten_points){2, n, q}, NULL, lengths, &report, &found));
        CHECK(report.error < 1e-11 * length);
        CHECK_NEAR(found.length, span.length, 1e-10 * length);
        CHECK_NEAR(found.start[0], span.start[0], 1e-10 * length);
        CHECK_NEAR(found.curvature[0], span.curvature[0], 1e-9 / length);
        CHECK_NEAR(found.curvature[1], span.curvature[1], 1e-8 / (length * length));
        CHECK_NEAR(lengths[n - 1], length, 1e-10 * length);
    }
}

TEST(a_noisy_clothoid_is_found_nearly)
{
    const batten_span span = {
        .kind = BATTEN_SPAN_SPIRAL, .length = 10, .angle = 0.2, .curvature = {0.01, 0.03}};
    double q[400];
    on_clothoid(&span, 200, 0.02, q);
    batten_span found;
    batten_primitive_report report;
    CHECK_OK(batten_clothoid_fit((batten_points){2, 200, q}, NULL, NULL, &report, &found));
    CHECK(report.rms < 0.0201);
    CHECK_NEAR(found.curvature[1], 0.03, 0.001);
    CHECK_NEAR(found.length, 10, 0.02);
}

TEST(lines_and_arcs_are_clothoids)
{
    double q[20];
    batten_span found;
    for (int c = 0; c < 2; c++) {
        for (int i = 0; i < 10; i++) {
            q[2 * i] = c ? 3 * sin(i / 10.0) : i;
            q[2 * i + 1] = c ? 3 - 3 * cos(i / 10.0) : 2 * i;
        }
        CHECK_OK(batten_clothoid_fit((batten_points){2, 10, q}, NULL, NULL, NULL, &found));
        CHECK_NEAR(found.curvature[0], c / 3.0, 1e-9);
        CHECK_NEAR(found.curvature[1], 0, 1e-9);
    }
}

/* Feet run away on a trial that winds up; the rounds go on from a nearer one. */
TEST(points_far_from_any_clothoid_are_fitted_the_same_in_both_orders)
{
    const double q[] = {0, 0, 1, .6, 2, .7, 3, .2, 4, 0, 5, .3, 6, .9};
    const double stairs[] = {0, 0, 1, 0, 2, 0, 2.001, 1, 3, 1, 4, 1};
    double back[COUNT(q)];
    for (int i = 0; i < 7; i++)
        memcpy(back + 2 * i, q + 2 * (6 - i), 2 * sizeof *q);
    batten_span found, reversed;
    batten_primitive_report one, other;
    CHECK_OK(batten_clothoid_fit((batten_points){2, 7, q}, NULL, NULL, &one, &found));
    CHECK_OK(batten_clothoid_fit((batten_points){2, 7, back}, NULL, NULL, &other, &reversed));
    CHECK_NEAR(one.rms, other.rms, 1e-8);
    CHECK_NEAR(found.length, reversed.length, 1e-5);
    CHECK_NEAR(found.curvature[0] + reversed.length * reversed.curvature[1] +
                   reversed.curvature[0],
               0, 1e-5);
    CHECK_OK(batten_clothoid_fit((batten_points){2, 6, stairs}, NULL, NULL, &one, &found));
    CHECK(one.error < 0.5 && found.length > 4);
}

TEST(N1_what_is_not_finite_is_named_by_fits_of_primitives)
{
    const double q[] = {0, 0, 1, 1, 2, NAN, 3, 1, 4, 0};
    batten_fitted_line line;
    batten_fitted_circle circle;
    batten_fitted_ellipse ellipse;
    batten_span span;
    CHECK_STATUS(batten_line_fit((batten_points){2, 5, q}, NULL, &line), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("2");
    CHECK_STATUS(
        batten_circle_fit((batten_points){2, 5, q}, BATTEN_CIRCLE_PRATT, NULL, &circle),
        BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_ellipse_fit((batten_points){2, 5, q}, NULL, &ellipse),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_clothoid_fit((batten_points){2, 5, q}, NULL, NULL, NULL, &span),
                 BATTEN_NOT_FINITE);
}

TEST(N2_primitives_of_tiny_and_huge_points_are_found_alike)
{
    const double sizes[] = {1e-300, 1e-9, 1e9, 1e300};
    for (int s = 0; s < COUNT(sizes); s++) {
        double q[24];
        for (int i = 0; i < 12; i++) {
            q[2 * i] = sizes[s] * (3 + 2 * cos(i / 2.0));
            q[2 * i + 1] = sizes[s] * (1 + sin(i / 2.0));
        }
        batten_fitted_ellipse e;
        batten_fitted_circle circle;
        CHECK_OK(batten_ellipse_fit((batten_points){2, 12, q}, NULL, &e));
        CHECK_NEAR(e.a / sizes[s], 2, 1e-10);
        CHECK_OK(batten_circle_fit((batten_points){2, 12, q}, BATTEN_CIRCLE_GEOMETRIC, NULL,
                                   &circle));
        CHECK(circle.radius / sizes[s] > 1 && circle.radius / sizes[s] < 2);
    }
}
