#include <batten/scattered.h>

#include "support/faults.h"
#include "support/test.h"
#include "support/watcher.h"

#include <stdlib.h>

static double franke(double x, double y)
{
    const double a = 9 * x, b = 9 * y;
    return 0.75 * exp(-((a - 2) * (a - 2) + (b - 2) * (b - 2)) / 4) +
           0.75 * exp(-(a + 1) * (a + 1) / 49 - (b + 1) / 10) +
           0.5 * exp(-((a - 7) * (a - 7) + (b - 3) * (b - 3)) / 4) -
           0.2 * exp(-(a - 4) * (a - 4) - (b - 7) * (b - 7));
}

static double plane(double x, double y)
{
    return 3 * x - 2 * y + 1;
}

static double bowl(double x, double y)
{
    return x * x - x * y + 2 * y * y + x;
}

/* A grid n x n of the unit square, its inner points shaken. */
static void shaken(int n, double part, test_random *random, double (*f)(double, double),
                   double *xy, double *values)
{
    for (int i = 0; i < n * n; i++) {
        const int at[2] = {i % n, i / n};
        for (int k = 0; k < 2; k++) {
            const bool inside = at[k] > 0 && at[k] < n - 1;
            xy[2 * i + k] =
                (at[k] + (inside ? part * test_random_in(random, -1, 1) : 0)) / (n - 1);
        }
        values[i] = f(xy[2 * i], xy[2 * i + 1]);
    }
}

/* The largest error at places inside, away from the rim where gradients are one-sided. */
static double error_of(const batten_triangles *triangles, double (*f)(double, double))
{
    enum { SIDE = 41 };
    double *xy = test_array(2 * SIDE * SIDE, sizeof *xy);
    double *found = test_array(SIDE * SIDE, sizeof *found), most = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        xy[2 * i] = 0.15 + 0.7 * (i % SIDE) / (SIDE - 1);
        xy[2 * i + 1] = 0.15 + 0.7 * (i / SIDE) / (SIDE - 1);
    }
    CHECK_OK(batten_triangles_over(triangles, (batten_batch){SIDE * SIDE, xy}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL}, NULL,
                                   found));
    for (int i = 0; i < SIDE * SIDE; i++)
        most = fmax(most, fabs(found[i] - f(xy[2 * i], xy[2 * i + 1])));
    return most;
}

static double try_out(int n, double (*f)(double, double),
                      const batten_triangles_scattered_options *options,
                      batten_triangles_scattered_report *report)
{
    test_random random = test_random_begin("shaken");
    double *xy = test_array(2 * (size_t)(n * n), sizeof *xy);
    double *values = test_array((size_t)(n * n), sizeof *values);
    batten_triangles *triangles = NULL;
    shaken(n, 0.3, &random, f, xy, values);
    CHECK_EACH_ALLOCATION(batten_triangles_scattered((batten_points){2, n * n, xy}, values,
                                                     options, NULL, report, &triangles));
    const double error = error_of(triangles, f);
    batten_triangles_unref(triangles);
    return error;
}

TEST(planes_are_met_by_every_element_and_quadratics_by_local_gradients)
{
    batten_triangles_scattered_options options = batten_triangles_scattered_defaults();
    batten_triangles_scattered_report report;
    for (int c = 0; c < 12; c++) {
        options.element = (batten_triangle_element)(c % 3);
        options.network = c / 3 % 2;
        options.data_dependent = c / 6;
        CHECK_NEAR(try_out(7, plane, &options, &report), 0, 1e-12);
        CHECK_NEAR(report.error, 0, 0);
        CHECK_INT(report.worst, -1);
        CHECK_INT(report.vertices, 49);
        CHECK_INT(report.pieces, report.triangles * (c % 3 == 0 ? 3 : c % 3 == 1 ? 6 : 1));
        CHECK_INT(report.swaps, 0);
    }
    options = batten_triangles_scattered_defaults();
    for (int c = 0; c < 2; c++) {
        options.element = (batten_triangle_element)c;
        CHECK_NEAR(try_out(8, bowl, &options, &report), 0, 1e-12);
        CHECK_INT(report.planes, 0);
    }
}

TEST(with_local_gradients_the_error_of_frankes_function_falls_with_the_third_power)
{
    batten_triangles_scattered_options options = batten_triangles_scattered_defaults();
    for (int c = 0; c < 4; c++) {
        options.element = (batten_triangle_element)(c % 2);
        options.network = c / 2;
        const double coarse = try_out(17, franke, &options, NULL);
        const double fine = try_out(65, franke, &options, NULL);
        /* A quarter of the distance: h^3 makes 64 of it. Slopes of the network are of lower
         * order, but better from few points. */
        CHECK(fine < coarse / (options.network ? 8 : 40));
        CHECK(fine < 4e-4 && coarse < (options.network ? 6e-3 : 2e-2));
    }
    options.element = BATTEN_ELEMENT_LINEAR;
    const double ratio =
        try_out(17, franke, &options, NULL) / try_out(65, franke, &options, NULL);
    CHECK(ratio > 8 && ratio < 32); /* h^2 */
}

TEST(G2_points_on_two_lines_or_round_a_hub_give_planes_where_no_quadratic_is_determined)
{
    enum { N = 400 };
    double *xy = test_array(2 * N, sizeof *xy), *f = test_array(N, sizeof *f);
    for (int c = 0; c < 2; c++) {
        for (int i = 0; i < N; i++) {
            const double turn = 2 * 3.141592653589793 * i / (N - 1);
            xy[2 * i] = c ? (i ? cos(turn) : 0) : i % 2;
            xy[2 * i + 1] = c ? (i ? sin(turn) : 0) : 0.01 * (i / 2) + 0.003 * (i % 2);
            f[i] = plane(xy[2 * i], xy[2 * i + 1]);
        }
        batten_triangles_scattered_report report;
        batten_triangles *out = NULL;
        CHECK_OK(batten_triangles_scattered((batten_points){2, N, xy}, f, NULL, NULL, &report,
                                            &out));
        CHECK(c || report.planes > 0);
        double at[2] = {0.4, 0.3}, value[3];
        CHECK_OK(batten_triangles_over(out, (batten_batch){1, at}, 1,
                                       (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL},
                                       NULL, value));
        CHECK_NEAR(value[0], plane(0.4, 0.3), 1e-10);
        CHECK_NEAR(value[1], 3, 1e-8);
        CHECK_NEAR(value[2], -2, 1e-8);
        batten_triangles_unref(out);
    }
}

TEST(the_network_bends_less_than_any_other)
{
    enum { N = 6 };
    test_random random = test_random_begin(__func__);
    double xy[2 * N * N], f[N * N], g[2 * N * N];
    batten_plane_triangles t;
    shaken(N, 0.3, &random, franke, xy, f);
    CHECK_OK(batten_triangulate((batten_points){2, N * N, xy}, NULL, &t));
    int steps = 0;
    CHECK_EACH_ALLOCATION(batten_triangle_gradients(&t, f, NULL, NULL, g));
    CHECK_EACH_ALLOCATION(batten_triangle_network(&t, f, NULL, &steps, g));
    CHECK(steps > 3 && steps < 60);
    double again[2 * N * N] = {0};
    CHECK_OK(batten_triangle_network(&t, f, NULL, NULL, again));
    for (int i = 0; i < 2 * N * N; i++)
        CHECK_NEAR(again[i], g[i], 1e-11);
    /* the derivative of the bending with respect to each unknown vanishes */
    double sum[2 * N * N] = {0};
    for (int i = 0; i < 3 * t.count; i++) {
        if (t.beside[i] > i / 3)
            continue;
        const int a = t.corners[3 * (i / 3) + (i + 1) % 3];
        const int b = t.corners[3 * (i / 3) + (i + 2) % 3];
        const double x = xy[2 * b] - xy[2 * a], y = xy[2 * b + 1] - xy[2 * a + 1];
        const double L = hypot(x, y), s = (f[b] - f[a]) / L;
        const double at_a = (g[2 * a] * x + g[2 * a + 1] * y) / L - s;
        const double at_b = (g[2 * b] * x + g[2 * b + 1] * y) / L - s;
        sum[2 * a] += (2 * at_a + at_b) * x / (L * L);
        sum[2 * a + 1] += (2 * at_a + at_b) * y / (L * L);
        sum[2 * b] += (at_a + 2 * at_b) * x / (L * L);
        sum[2 * b + 1] += (at_a + 2 * at_b) * y / (L * L);
    }
    for (int i = 0; i < 2 * N * N; i++)
        CHECK_NEAR(sum[i], 0, 1e-10);
    batten_plane_triangles_release(&t);
}

TEST(edges_follow_a_ridge_where_they_depend_on_the_data)
{
    /* a roof |x - y| over a grid: only along the diagonal x = y it is met by planes */
    enum { N = 6 };
    double xy[2 * N * N], f[N * N];
    for (int i = 0; i < N * N; i++) {
        xy[2 * i] = i % N;
        xy[2 * i + 1] =
            i / N + 1e-3 * (i % N) * (i / N); /* Delaunay takes the other diagonals */
        f[i] = abs(i % N - i / N);
    }
    batten_triangles_scattered_options options = batten_triangles_scattered_defaults();
    batten_triangles_scattered_report report;
    batten_triangles *out = NULL;
    options.element = BATTEN_ELEMENT_LINEAR;
    options.data_dependent = true;
    CHECK_OK(batten_triangles_scattered((batten_points){2, N * N, xy}, f, &options, NULL,
                                        &report, &out));
    CHECK(report.swaps > 0);
    for (int i = 0; i + 1 < N; i++) { /* between vertices of the ridge the value stays 0 */
        const int a = i * (N + 1), b = a + N + 1;
        const double middle[2] = {(xy[2 * a] + xy[2 * b]) / 2,
                                  (xy[2 * a + 1] + xy[2 * b + 1]) / 2};
        double value;
        CHECK_OK(batten_triangles_over(out, (batten_batch){1, middle}, 0,
                                       (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL},
                                       NULL, &value));
        CHECK_NEAR(value, 0, 1e-14);
    }
    batten_triangles_unref(out);
}

TEST(G1_points_at_one_place_give_their_mean_and_the_conflict_is_reported)
{
    const double xy[] = {0, 0, 2, 0, 2, 2, 0, 2, 1, 1, 1, 1, 2, 2}, f[] = {0, 0, 0, 0, 3, 5, 0};
    batten_triangles_scattered_report report;
    batten_triangles *out = NULL;
    CHECK_OK(
        batten_triangles_scattered((batten_points){2, 7, xy}, f, NULL, NULL, &report, &out));
    CHECK_INT(report.vertices, 5);
    CHECK_INT(report.merged, 2);
    CHECK_NEAR(report.conflict, 2, 0);
    CHECK_INT(report.conflicting, 5);
    CHECK_NEAR(report.error, 1, 0);
    CHECK_INT(report.worst, 4);
    CHECK_NEAR(report.rms, sqrt(2.0 / 7), 1e-15);
    const double middle[2] = {1, 1};
    double value;
    CHECK_OK(batten_triangles_over(out, (batten_batch){1, middle}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL}, NULL,
                                   &value));
    CHECK_NEAR(value, 4, 1e-14);
    batten_triangles_unref(out);
}

TEST(N1_G2_values_that_are_no_numbers_and_points_on_a_line_are_refused)
{
    const double line[] = {0, 0, 1, 2, 2, 4, 3, 6}, f[] = {0, 1, NAN, 2}, good[] = {0, 1, 2, 2};
    batten_triangles *out = NULL;
    CHECK_STATUS(
        batten_triangles_scattered((batten_points){2, 4, line}, f, NULL, NULL, NULL, &out),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("value 3");
    CHECK_STATUS(
        batten_triangles_scattered((batten_points){2, 4, line}, good, NULL, NULL, NULL, &out),
        BATTEN_COINCIDENT);
    CHECK_STATUS(
        batten_triangles_scattered((batten_points){2, -1, line}, good, NULL, NULL, NULL, &out),
        BATTEN_TOO_FEW_POINTS);
}

TEST(N2_scattered_values_of_any_size_are_met_or_refused)
{
    const double sizes[] = {1e-300, 1e-150, 1e-80, 1, 1e80, 1e150, 1e300};
    for (int c = 0; c < 49; c++) {
        const double width = sizes[c / 7], height = sizes[c % 7];
        test_random random = test_random_begin("sizes");
        double xy[60], f[30];
        for (int i = 0; i < 30; i++) {
            const double x = test_random_unit(&random), y = test_random_unit(&random);
            xy[2 * i] = width * x;
            xy[2 * i + 1] = width * y;
            f[i] = height * (0.6 * x - 0.3 * y);
        }
        batten_triangles_scattered_options options = batten_triangles_scattered_defaults();
        options.network = c % 2;
        batten_triangles *out = NULL;
        batten_status status = batten_triangles_scattered((batten_points){2, 30, xy}, f,
                                                          &options, NULL, NULL, &out);
        if (test_memory_failed(status, BATTEN_OK))
            status = batten_triangles_scattered((batten_points){2, 30, xy}, f, &options, NULL,
                                                NULL, &out);
        if (status != BATTEN_OK) {
            CHECK(width != 1 || height != 1);
            continue;
        }
        const double at[2] = {0.5 * width, 0.5 * width};
        double value;
        CHECK_OK(batten_triangles_over(out, (batten_batch){1, at}, 0,
                                       (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL},
                                       NULL, &value));
        CHECK_NEAR(value / height, 0.15, 1e-9);
        batten_triangles_unref(out);
    }
}

enum { SIDE = 20 };

typedef struct {
    const batten_triangles_scattered_options *options;
    double xy[2 * SIDE * SIDE], values[SIDE * SIDE];
} scattered_task;

static batten_status make_scattered(void *context, const batten_job *job)
{
    const scattered_task *t = context;
    batten_triangles *out = NULL;
    const batten_status status = batten_triangles_scattered(
        (batten_points){2, SIDE * SIDE, t->xy}, t->values, t->options, job, NULL, &out);
    CHECK_INT(out != NULL, status == BATTEN_OK);
    batten_triangles_unref(out);
    return status;
}

TEST(I8_scattered_triangles_are_cancelled_cleanly)
{
    test_random random = test_random_begin("cancelled");
    batten_triangles_scattered_options options = batten_triangles_scattered_defaults();
    scattered_task t = {.options = &options};
    shaken(SIDE, 0.2, &random, franke, t.xy, t.values);
    check_cancelling(make_scattered, &t, 15);
    options.network = options.data_dependent = true;
    check_cancelling(make_scattered, &t, 40);
}

/* ---- published data ---- */

static int read_rows(const char *name, double *xy, double *values, int most)
{
    FILE *file = fopen(test_data(name), "r");
    char line[200];
    int count = 0;
    CHECK(file != NULL);
    while (count < most && fgets(line, sizeof line, file)) {
        double row[3];
        if (sscanf(line, "%lf,%lf,%lf", &row[0], &row[1], &row[2]) != 3)
            continue;
        xy[2 * count] = row[0];
        xy[2 * count + 1] = row[1];
        values[count++] = row[2];
    }
    fclose(file);
    return count;
}

TEST(published_terrains_are_met_at_every_point)
{
    const char *names[] = {"scattered/topo_mass.csv", "scattered/akima526.csv"};
    const int counts[] = {52, 50};
    for (int c = 0; c < 8; c++) {
        double xy[200], f[100], found[100];
        const int count = read_rows(names[c % 2], xy, f, 100);
        CHECK_INT(count, counts[c % 2]);
        batten_triangles_scattered_options options = batten_triangles_scattered_defaults();
        batten_triangles_scattered_report report;
        batten_triangles *out = NULL;
        options.element = (batten_triangle_element)(c / 2 % 2);
        options.network = c / 4;
        CHECK_OK(batten_triangles_scattered((batten_points){2, count, xy}, f, &options, NULL,
                                            &report, &out));
        CHECK_INT(report.merged, 0);
        CHECK_OK(batten_triangles_over(out, (batten_batch){(size_t)count, xy}, 0,
                                       (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL},
                                       NULL, found));
        for (int i = 0; i < count; i++)
            CHECK_NEAR(found[i], f[i], 1e-12 * 1000);
        batten_triangles_unref(out);
    }
}
