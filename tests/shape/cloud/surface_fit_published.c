/* Surfaces near measured and published data. */
#include <batten/interpolate.h>
#include <batten/scattered.h>

#include "support/test.h"

#include <stdlib.h>

/* The numbers of a file from the first line that begins with none of `skip`. */
static int read_numbers(const char *name, int lines, double *numbers, int most)
{
    FILE *file = fopen(test_data(name), "r");
    char line[4000];
    int count = 0;
    CHECK(file != NULL);
    for (int i = 0; i < lines; i++)
        CHECK(fgets(line, sizeof line, file) != NULL);
    while (count < most && fscanf(file, "%lf", &numbers[count]) == 1)
        count++;
    fclose(file);
    return count;
}

TEST(the_volcano_is_fitted_with_ever_less_left)
{
    enum { U = 87, V = 61 };
    double *z = test_array(U * V, sizeof *z), last = HUGE_VAL;
    CHECK_INT(read_numbers("grids/volcano.txt", 1, z, U * V), U * V);
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    double u[U], v[V];
    for (int i = 0; i < U; i++)
        u[i] = 10 * i;
    for (int j = 0; j < V; j++)
        v[j] = 10 * j;
    options.parameters = BATTEN_GIVEN;
    options.given_u = u;
    options.given_v = v;
    for (int n = 8; n <= 32; n *= 2) {
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.points_u = n;
        options.points_v = n;
        CHECK_OK(batten_surface_fit_grid((batten_grid){1, U, V, z}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, &report, &s));
        CHECK(report.rms < 0.7 * last && report.error < 60);
        last = report.rms;
        batten_surface_unref(s);
    }
    CHECK(last < 1.5); /* metres; the heights are whole ones, 94 to 195 */
    /* Whole metres have errors of 0.29: cross validation finds about that. */
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    options.points_u = options.points_v = 0;
    CHECK_OK(batten_surface_smooth_grid((batten_grid){1, U, V, z}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, &report, &s));
    CHECK(report.rms > 0.1 && report.rms < 2);
    batten_surface_unref(s);
}

TEST(akimas_grid_of_1974_is_reproduced)
{
    enum { U = 9, V = 11 };
    double table[U * (V + 1)], z[U * V], u[U], v[V];
    CHECK_INT(read_numbers("scattered/akima474_grid.txt", 1, table, U * (V + 1)), U * (V + 1));
    for (int i = 0; i < U; i++) {
        u[i] = table[i * (V + 1)];
        memcpy(z + i * V, table + i * (V + 1) + 1, V * sizeof *z);
    }
    for (int j = 0; j < V; j++)
        v[j] = j;
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    batten_surface *s = NULL;
    batten_surface_interpolate_report report;
    options.parameters = BATTEN_GIVEN;
    options.given_u = u;
    options.given_v = v;
    CHECK_OK(batten_surface_interpolate((batten_grid){1, U, V, z}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, &report, &s));
    CHECK(report.error < 1e-13 * 62);
    batten_surface_unref(s);
}

/* A matrix of G+Smo: the numbers after its head. */
static int read_matrix(const char *name, const char *head, double *numbers, int most)
{
    FILE *file = fopen(test_data(name), "r");
    char word[100];
    int count = 0;
    bool found = false;
    CHECK(file != NULL);
    while (!found && fscanf(file, "%99s", word) == 1)
        found = strcmp(word, head) == 0;
    while (found && fgetc(file) != '>') {
    }
    while (count < most && fscanf(file, "%lf", &numbers[count]) == 1)
        count++;
    fclose(file);
    return count;
}

TEST(the_deep_drawn_sheet_comes_nearer_with_every_knot)
{
    enum { N = 2969 };
    double *rows = test_array(3 * N, sizeof *rows), *points = test_array(3 * N, sizeof *points),
           *uv = test_array(2 * N, sizeof *uv), last = HUGE_VAL;
    CHECK_INT(read_matrix("fitting/gismo_deepdrawingC.xml", "rows=\"3\"", rows, 3 * N), 3 * N);
    for (int i = 0; i < 3 * N; i++)
        points[i % N * 3 + i / N] = rows[i];
    CHECK_INT(read_matrix("fitting/gismo_deepdrawingC.xml", "rows=\"2\"", rows, 2 * N), 2 * N);
    for (int i = 0; i < 2 * N; i++)
        uv[i % N * 2 + i / N] = rows[i];
    for (int spans = 5; spans <= 20; spans *= 2) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.spans_u = options.spans_v = spans;
        options.by = BATTEN_SMOOTH_BY_LAMBDA;
        CHECK_OK(batten_surface_scattered(uv, (batten_points){3, N, points}, &options, NULL,
                                          &report, &s));
        CHECK(report.rms < last);
        last = report.rms;
        batten_surface_unref(s);
    }
}

TEST(the_scan_of_a_face_is_fitted_over_its_plane)
{
    enum { N = 1552 };
    double *points = test_array(3 * N, sizeof *points);
    char line[200];
    int count = 0;
    FILE *file = fopen(test_data("pointclouds/pcl_object_template_1.pcd"), "r");
    CHECK(file != NULL);
    while (fgets(line, sizeof line, file) && strncmp(line, "DATA", 4) != 0) {
    }
    while (count < N && fgets(line, sizeof line, file)) {
        char *at = line;
        for (int k = 0; k < 3; k++)
            points[3 * count + k] = strtod(at, &at);
        count++;
    }
    fclose(file);
    CHECK_INT(count, N);
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    options.huber = true;
    options.spans_u = options.spans_v = 12;
    options.corrections = 3;
    CHECK_OK(batten_surface_cloud(&(batten_cloud){{3, N, points}, NULL}, &options, NULL, NULL,
                                  &report, &s));
    /* Metres; a camera of depth knows some millimetres at this distance. */
    CHECK(report.most < 0.02 && report.rms < 0.01 && report.reweightings > 0);
    batten_surface_unref(s);
}
